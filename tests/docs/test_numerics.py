"""The tables of docs/developer/numerics.md that the command, a script or docs/developer/validation.md gives. (Those whose numbers come from
changed versions of the program, or from hours of computing, are not here.)"""

import json
import os
import re
import subprocess
import sys

import pytest
from conftest import ROOT, command, line, page, power, sampled, with_error

PAGE, WORDS = page("docs/developer/numerics.md")
VALIDATION, _ = page("docs/developer/validation.md")
POWERS = {1e-2: "10⁻²", 1e-3: "10⁻³", 1e-4: "10⁻⁴"}


def records(arguments):
    words = [os.environ["STOSS"], *arguments.split(), "--format", "json", "--quiet"]
    found = subprocess.run(words, capture_output=True, text=True, timeout=120)
    assert found.returncode in (0, 1), found.stderr
    return json.loads(found.stdout)["records"]


def cells_of(name, after=""):
    """The cells of the first line of a table that begins with a name, behind some words."""
    found = re.search(rf"^\| {re.escape(name)} \|(.*)\|$", PAGE.partition(after)[2] if after else PAGE, re.MULTILINE)
    return [cell.strip() for cell in found[1].split("|")]


def runs(arguments):
    """1 − ε² of each run, by its cutoff to three digits."""
    return {float(f"{run['cutoff']:.3g}"): run["lost_fraction"] for row in records(arguments) for run in row["runs"]}


SPEEDS = {"v = 0.3": 0.3, "v = 0.1": 0.1, "v = 0.01": 0.01, "v = 10⁻³": 1e-3, "v = 10⁻⁴": 1e-4, "v = 10⁻⁶": 1e-6}


@pytest.mark.parametrize("name", sampled(SPEEDS))
def test_convergence_in_the_cutoff(name):
    table = dict(zip((5.66, 11.3, 22.6, 45.3, 90.5, 181), cells_of(name, "**Convergence in the cutoff**")))
    found = runs(f"restitution --body disk --poisson 0.33 --speed {SPEEDS[name]} --tolerance 6e-6 --absolute 0")
    compared = [(cutoff, value) for cutoff, value in found.items() if cutoff in table]
    assert len(compared) == len(table)
    for cutoff, value in compared:
        assert value == pytest.approx(float(table[cutoff]), rel=1e-4), cutoff  # nodes follow from the runs before


def test_what_the_tail_of_today_gives():
    cells = cells_of("+ edge law and phase of first touch (§3; **all kept**)")
    for k, (speed, nodes) in enumerate(((0.1, 64), (0.01, 48))):
        for cutoff, cell in zip((12.5, 25, 50), cells[3 * k :]):
            job = f"impact --body disk --poisson 0.33 --speed {speed} --cutoff {cutoff} --step {0.5 / cutoff} --nodes {nodes} --quiet"
            (row,) = command(job)
            assert f"{row['lost_fraction']:.5f}" == cell


@pytest.mark.parametrize("name", sampled(["R₂ = 2, v = 0.2", "E₂ = 4, v = 0.2", "R₂ = 10, v = 0.1", "ρ₂ = 4, v = 0.1"]))
def test_pairs(name):
    shown = cells_of(name)
    which, value, speed = re.fullmatch(r"(.)₂ = (\d+), v = ([\d.]+)", name).groups()
    key = {"R": "radius", "E": "young", "ρ": "density"}[which]
    (row,) = records(f"restitution --body disk --poisson 0.33 --against disk,{key}={value} --speed {speed} --tolerance 3e-5")
    assert [f"{run['lost_fraction']:.6f}" for run in row["runs"][:4]] == shown[:4]
    assert with_error(row["lost_fraction"], row["lost_fraction_error"]) == shown[4]


@pytest.mark.parametrize("point", sampled([(0.9, 0.1448), (0.9, 0.5), (0, 0.39718)]))
def test_single_points_that_take_long(point):
    poisson, speed = point
    for tolerance, cell in zip((1e-3, 2e-4, 1e-4), cells_of(f"ν = {poisson}, v = {speed}")):
        (row,) = command(f"restitution --body disk --poisson {poisson} --speed {speed} --tolerance {tolerance} --quiet")
        shown = f"{row['lost_fraction']:.5f}({1e5 * row['lost_fraction_error']:.0f})"
        assert cell.startswith(shown), (tolerance, shown)
        assert ("not reached" in cell) == (row["converged"] == "false"), tolerance


def test_force_that_comes_back_focused():
    cells = cells_of("maximum force", "comes back to the contact focused")
    for tolerance, cell in zip((1e-2, 1e-3, 2e-4, 1e-4), cells):
        (row,) = command(f"restitution --body disk --poisson 0.98 --speed 0.085 --tolerance {tolerance} --quiet")
        assert f"{row['max_force']:.4f} ± {row['max_force_error']:.4f}" == cell


def test_rods():
    cells = (cells_of("1 − ε"), cells_of("impulse time c/L (exactly 1.96)"))
    for cutoff, *shown in zip((10, 20, 40, 80, 160, 320, 640), *cells):
        (row,) = command(f"impact --body rod --speed 0.1 --cutoff {cutoff} --quiet")
        assert [f"{1 - row['restitution']:.4f}", f"{row['impulse_time']:.3f}"] == shown


def test_energy_error_of_the_radiating_tail():
    for step, shown in zip((0.5, 0.25, 0.125, 0.0625), cells_of("energy error")):
        (row,) = command(f"impact --body disk --poisson 0.33 --speed 0.1 --cutoff 25 --step {step / 25} --quiet")
        mantissa, power = re.fullmatch(r"−([\d.]+)·10⁻(.)", shown).groups()
        expected = -float(mantissa) * 10.0 ** -"⁰¹²³⁴⁵⁶⁷⁸⁹".index(power)
        assert row["energy_error"] == pytest.approx(expected, rel=0.5 / float(mantissa.replace(".", "")) + 0.01)


@pytest.mark.parametrize("loss_time", sampled((1, 0.001, 0.01, 0.1)))
def test_energy_error_of_lossy_spheres(loss_time):
    for cutoff, cell in zip((16, 32, 64), cells_of(f"{loss_time:g}", "| η | ω_c = 16 | 32 | 64 |")):
        job = f"impact --body sphere --poisson 0.3 --loss-time {loss_time} --speed 0.01"
        (row,) = command(f"{job} --cutoff {cutoff} --step {0.5 / cutoff} --quiet")
        mantissa, exponent = re.fullmatch(r"−([\d.]+)·10⁻(.)", cell).groups()
        unit = 10.0 ** -("⁰¹²³⁴⁵⁶⁷⁸⁹".index(exponent) + len(mantissa.partition(".")[2]))
        assert abs(row["energy_error"] + float(mantissa.replace(".", "")) * unit) <= 0.6 * unit


@pytest.mark.long
def test_edge_law():
    pytest.importorskip("numpy")
    script = subprocess.run([sys.executable, ROOT / "validate/edge_law.py"], capture_output=True, text=True, check=True)
    for row in script.stdout.splitlines()[1:]:
        nodes, *values = row.split()
        for value, cell in zip(values[:4], cells_of(nodes, "| touching nodes k |")):
            assert float(value) == pytest.approx(float(cell.replace("−", "-")), abs=5.5e-4)  # it has one digit more


def validated(points):
    """Converged, within, maximum and median padding at each tolerance."""
    line = rf"^\| ([\d.]+) \| {points} \| (\d+) of (\d+) \| ([\d.]+) % \| ([\d.]+) \| ([\d.]+) \|"
    found = re.findall(line, VALIDATION, re.MULTILINE)
    assert len(found) == 3
    return [tuple(map(float, each)) for each in found]


def test_errors_of_vibrating_bodies():
    for tolerance, converged, _, within, largest, padding in validated("vibrating"):
        assert line(POWERS[tolerance], f"{converged:.0f}", f"{within} %", f"{largest:.2f}", padding) in PAGE


def test_errors_of_lossy_bodies():
    found = validated("lossy")
    inside = [round(count * within / 100) for _, _, count, within, _, _ in found]
    said = f"{inside[0]}, {inside[1]} and {inside[2]} lie within the error, the worst at"
    assert f"{said} {max(each[4] for each in found):.2f} times" in WORDS
    paddings, converged = [each[5] for each in found], [round(each[1]) for each in found]
    assert f"errors are {paddings[0]}, {paddings[1]} and {paddings[2]} times the true ones" in WORDS
    assert f"{converged[0]}, {converged[1]} and {converged[2]} converge" in WORDS


RULES = [("wall", "1e-3:0.1", 0.08), ("wall", "1e-5:1e-2", 0.02), ("same", "1e-4:1e-3", 0.005), ("same", "1e-4:1e-2", 0.02)]


@pytest.mark.parametrize("which", sampled(RULES, 4))
def test_grid_of_a_table_of_the_rule(which):
    against, speed, tolerance = which
    job = f"table --body sphere --poisson 0.3 --against {against} --speed {speed} --tolerance {tolerance} --oblique"
    words = [os.environ["STOSS"], *job.split(), "--format", "json"]
    found = json.loads(subprocess.run(words, capture_output=True, text=True, check=True, timeout=120).stdout)
    grid = found["records"][1]
    size = f"{len(grid['speed'])} × {len(grid['slip'])}"
    assert f"| {tolerance} | {size} | {found['greatest_sliding_error']:.2g} |" in PAGE


@pytest.mark.parametrize("error", (1e-2, 1e-3))
def test_grid_of_a_table_of_pairs(error):
    job = f"table --body disk --poisson 0.33 --against same --speed 1e-3:0.3 --ratio 1:3 --error {error} --format json"
    words = [os.environ["STOSS"], *job.split()]
    found = json.loads(subprocess.run(words, capture_output=True, text=True, check=True, timeout=120).stdout)
    cells = (POWERS[error], f"{len(found['records'])} × {len(found['ratio'])}", power(found["greatest_error"], 2))
    assert line(*cells)[:-2] in PAGE
