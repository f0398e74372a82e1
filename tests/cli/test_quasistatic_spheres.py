"""stoss quasistatic --body sphere: Hertz' closed forms, the law of the centre, the full solution, SI and refusals."""

import json
import math
import signal
import subprocess

import pytest
from conftest import number, rows, wait_for_rows

pytestmark = pytest.mark.numbers

NU = 0.3
SPHERE = f"quasistatic --body sphere --poisson {NU}"
STEEL = "--young 2.1e11 --density 7850 --radius 0.01"
C = math.sqrt(2.1e11 / 7850)
MASS = 4 * math.pi / 3  # in rho R^3, and so mc^2/R in E R^2
SOFTNESS = 1 - NU**2
K1 = -1.540051  # docs/theory/points.md
MEAN = 0.199


def center(a):
    """Compression by the law of the centre of mass, for a radius of the contact."""
    g = (1 - 2 * NU) ** 2 / (2 * (1 - NU))
    beyond = g * (19 / 12 - math.log(2 * a)) + K1 - (1 - 2 * NU) / (2 * (1 - NU))
    return a**2 + 4 / (3 * math.pi) * a**3 * beyond


# Hertz' impact (Johnson, eqs. 11.22 to 11.24), in units of the sphere.
@pytest.mark.parametrize("speed", [1e-12, 1e-6, 1e-3, 0.1])
def test_hertz_impact_is_its_closed_form(stoss, speed):
    (row,) = stoss.data(f"{SPHERE} --law hertz --speed {speed} --cutoff 10")
    a = (1.25 * math.pi * SOFTNESS * speed**2) ** 0.2
    assert number(row, "speed") == speed and number(row, "poisson") == NU
    assert number(row, "max_radius") == pytest.approx(a, rel=1e-13)
    assert number(row, "max_compression") == pytest.approx(a**2, rel=1e-13)
    assert number(row, "max_force") * MASS == pytest.approx(4 / 3 / SOFTNESS * a**3, rel=1e-13)
    time = 0.8 * math.gamma(0.4) * math.gamma(0.5) / math.gamma(0.9) * a**2 / speed
    assert number(row, "contact_time") == pytest.approx(time, rel=1e-12)


@pytest.mark.parametrize("speed", [1e-9, 1e-4, 0.05])
def test_law_of_the_centre(stoss, speed):
    (row,) = stoss.data(f"{SPHERE} --speed {speed} --cutoff 10")
    a = number(row, "max_radius")
    assert number(row, "max_force") == pytest.approx(a**3 / (math.pi * SOFTNESS), rel=1e-13)
    assert number(row, "max_compression") == pytest.approx(center(a), rel=1e-6)


def test_modes_have_the_lost_energy(stoss):
    document = json.loads(stoss.run(f"{SPHERE} --speed 1e-4 --cutoff 20 --format json").stdout)
    (record,) = document["records"]
    known = {(row["order"], row["index"]): row for row in stoss.data(f"modes --body sphere --poisson {NU} --cutoff 20")}
    assert len(document["modes"]) == record["modes"] == len(known)
    mean = 0.0
    for mode in document["modes"]:
        radial = float(known[str(mode["order"]), str(mode["index"])]["radial"])
        assert mode["after"] == pytest.approx((radial * mode["amplitude"]) ** 2, rel=1e-12)
        mean += radial**2 / mode["omega"] ** 5
    lost = sum(mode["after"] for mode in document["modes"])
    assert record["lost_fraction"] == pytest.approx(lost, rel=1e-12)
    factor = 2 * math.pi / (SOFTNESS * MASS) ** 2 * mean
    assert record["mean_lost_fraction"] == pytest.approx(factor * 1e-4, rel=1e-12)
    assert factor == pytest.approx(MEAN, abs=5e-4)


@pytest.mark.parametrize("speed", ["1e-5", "1e-3"])
def test_estimate_is_near_the_full_solution(stoss, speed):
    (full,) = stoss.data(f"restitution --body sphere --poisson {NU} --speed {speed} --absolute 0")
    (row,) = stoss.data(f"{SPHERE} --speed {speed}")
    off = abs(number(row, "lost_fraction") - number(full, "lost_fraction"))
    assert off < number(row, "lost_fraction_error") and off < 0.02 * number(full, "lost_fraction")
    # What the modes carry as they follow the force is left out.
    share = number(row, "kinetic_share")
    for name in ("contact_time", "max_compression", "max_force"):
        value, error = number(full, name), number(full, name + "_error")
        assert number(row, name) == pytest.approx(value, abs=3 * share * value + error)


# docs/theory/points.md, "Static contact of a sphere": by how much a law has too great a compression.
@pytest.mark.parametrize("law, off", [("center", (2.0e-5, 2.3e-4, 2.7e-3)), ("hertz", (-5.1e-3, -1.78e-2, -6.2e-2))])
def test_exact_contact_differs_as_the_theory_says(stoss, law, off):
    for row, more in zip(stoss.data(f"{SPHERE} --compression 1e-4,1e-3,1e-2 --law {law}"), off, strict=True):
        force, delta = number(row, "force"), number(row, "compression")
        exact, error = number(row, "static_force"), number(row, "static_force_error")
        a = number(row, "contact_radius")
        assert force == pytest.approx(a**3 / (math.pi * SOFTNESS), rel=1e-13)
        assert delta == pytest.approx(a**2 if law == "hertz" else center(a), rel=1e-6)
        if law == "hertz":
            assert number(row, "energy") == pytest.approx(0.4 * force * delta, rel=1e-13)
        assert 0 < error < 1e-4 * exact
        # At the exact force the law has the compression of a circle of its radius.
        circle = (math.pi * SOFTNESS * exact) ** (1 / 3)
        by_law = circle**2 if law == "hertz" else center(circle)
        assert delta / by_law - 1 == pytest.approx(more, abs=0.02 * abs(more) + error / exact)


@pytest.mark.parametrize("job, columns", [
    ("--speed 1e-6,0.1", [
        "poisson", "speed[c]", "lost_fraction", "lost_fraction_error", "mean_lost_fraction", "contact_time[R/c]",
        "max_compression[R]", "max_force[mc^2/R]", "max_radius[R]", "kinetic_share", "beyond_perturbation", "modes"]),
    ("--compression 1e-6,0.1", [
        "poisson", "compression[R]", "force[mc^2/R]", "energy[mc^2]", "contact_radius[R]", "static_force[mc^2/R]",
        "static_force_error[mc^2/R]"]),
])  # fmt: skip
def test_formats_agree(stoss, job, columns):
    text = stoss.run(SPHERE, job, "--format csv --quiet").stdout
    head = [line for line in text.splitlines() if line.startswith("#")]
    assert {'# first: {"kind":"sphere","poisson":0.3}', "# law: center"} <= set(head)
    table = rows(text)
    assert list(table[0]) == columns
    document = json.loads(stoss.run(SPHERE, job, "--format json --quiet").stdout)
    assert document["schema"] == "stoss/quasistatic/2" and document["complete"] is True
    assert document["units"] == {name.partition("[")[0]: name.partition("[")[2][:-1] for name in columns if "[" in name}
    for row, record in zip(table, document["records"], strict=True):
        assert [json.loads(text) for text in row.values()] == list(record.values())


@pytest.mark.parametrize("job", ["--speed 1e-12,1e-8,1e-4,0.16", "--compression 1e-12,1e-6,0.01,0.28",
                                 f"--speed 1e-8,1,800 {STEEL} --yield 1e9",
                                 f"--compression 1e-14,1e-3 {STEEL}"])  # fmt: skip
def test_table_fits_80_columns_and_keeps_them_apart(stoss, job):
    lines = stoss.run(SPHERE, job, "--quiet").stdout.splitlines()
    assert max(map(len, lines)) <= 80
    names = lines[0].split()
    assert len(names) == 5 - ("--speed" in job and "--young" in job)
    assert all(name.replace("_", "").isalpha() and name.count("compression") < 2 for name in names)
    assert not any(" 0.000000000000(0)" in line for line in lines)


def test_rows_beyond_perturbation_are_marked(stoss):
    result = stoss.run(f"{SPHERE} --speed 0.01,0.035,0.045")
    assert [" !" in line for line in result.stdout.splitlines()[2:]] == [False, False, True]
    (warning,) = result.stderr.splitlines()
    assert warning.startswith("stoss: warning: 1 of 3 rows beyond perturbation theory")
    result = stoss.run(f"{SPHERE} --compression 0.05,0.2")
    assert result.stderr.startswith("stoss: warning: 1 of 2 compressions above 0.1 R")


def test_si(stoss):
    force = MASS * 0.01**2 * 2.1e11
    (row,) = stoss.data(f"{SPHERE} {STEEL} --speed 1")
    assert number(row, "speed_si") == pytest.approx(1, rel=1e-14)
    assert number(row, "speed") == pytest.approx(1 / C, rel=1e-14)
    scales = {"contact_time": 0.01 / C, "max_compression": 0.01, "max_force": force, "max_radius": 0.01}
    for name, scale in scales.items():
        assert number(row, name + "_si") == pytest.approx(number(row, name) * scale, rel=1e-14)
    assert {"speed_si[m/s]", "contact_time_si[s]", "max_force_si[N]", "max_radius_si[m]"} <= set(row)
    assert "yield_speed[c]" not in row
    (row,) = stoss.data(f"{SPHERE} {STEEL} --compression 1e-5")
    assert number(row, "compression") == pytest.approx(1e-3, rel=1e-14)
    scales = {"force": force, "energy": force * 0.01, "contact_radius": 0.01, "static_force": force}
    for name, scale in scales.items():
        assert number(row, name + "_si") == pytest.approx(number(row, name) * scale, rel=1e-14)
    assert {"force_si[N]", "energy_si[J]", "contact_radius_si[m]", "static_force_si_error[N]"} <= set(row)


# At the speed at which yielding begins Hertz' maximum pressure is 1.6 Y.
def test_yield_speed_is_that_of_the_greatest_pressure(stoss):
    strength = 1e9
    (row,) = stoss.data(f"{SPHERE} {STEEL} --yield {strength} --speed 1e-3")
    speed = number(row, "yield_speed_si")
    assert number(row, "yield_speed") == pytest.approx(speed / C, rel=1e-14) and row["beyond_yield"] == "false"
    speeds = f"{speed!r},{1.001 * speed!r}"
    result = stoss.run(f"{SPHERE} {STEEL} --yield {strength} --law hertz --speed {speeds} --format csv")
    at, beyond = rows(result.stdout)
    pressure = 1.5 * number(at, "max_force_si") / (math.pi * number(at, "max_radius_si") ** 2)
    assert pressure == pytest.approx(1.6 * strength, rel=1e-12)
    assert beyond["beyond_yield"] == "true"
    assert result.stderr.startswith(f"stoss: warning: the ball yields above {speed:.3g} m/s (you asked")


@pytest.mark.parametrize("arguments, name, got", [
    ("--speed 9e-13", "speed", "9e-13, allowed 1e-12 to 0.1693"),
    ("--speed 0.01,0.2", "speed", "0.2, allowed 1e-12"),
    ("--speed nan", "speed", "nan"),
    (f"{STEEL} --speed 1000", "speed", "1000, allowed 5.17"),
    ("--speed 0.01 --law diameter", "law", "diameter with --body sphere, allowed center or hertz"),
    ("--compression 0.01 --law diameter", "law", "diameter with --body sphere, allowed center or hertz"),
    ("--speed 0.01 --cutoff 1", "cutoff", "1"),
    ("--speed 0.01 --cutoff 1001", "cutoff", "1001"),
    ("--compression 0.01 --cutoff 10", "cutoff", "--compression"),
    ("--compression 9e-13", "compression", "9e-13"),
    ("--compression 0.29", "compression", "0.29, allowed 1e-12 to 0.280321 R"),
    ("--compression 0.51 --law hertz", "compression", "0.51, allowed 1e-12 to 0.5 R"),
    ("--speed 0.01 --plane stress", "plane", "--body sphere"),
    ("--speed 0.01 --radius 1", "material", "sphere without young"),
    ("--speed 0.01 --yield 1e9", "yield", "without a material"),
    (f"--speed 0.01 --yield 0 {STEEL}", "yield_strength", "0"),
    (f"--speed 0.01 --yield nan {STEEL}", "yield", "nan"),
    (f"--compression 1e-5 --yield 1e9 {STEEL}", "yield", "--compression"),
])  # fmt: skip
def test_refusals(stoss, tmp_path, arguments, name, got):
    path = tmp_path / "kept"
    path.write_text("precious")
    for more in ("", f"-o {path} --format csv"):
        result = stoss.run(SPHERE, arguments, more)
        assert (result.returncode, result.stdout) == (3, "")
        (line,) = result.stderr.splitlines()
        assert line.startswith(f"stoss: error: {name}: got ") and got in line and "allowed" in line
    assert path.read_text() == "precious"


@pytest.mark.parametrize("poisson", ["-1", "0.5", "1e9"])
@pytest.mark.parametrize("asked", ["--speed 0.01", "--compression 0.01"])
def test_poisson_numbers_that_no_sphere_has(stoss, poisson, asked):
    result = stoss.run(f"quasistatic --body sphere --poisson {poisson} {asked}")
    assert (result.returncode, result.stdout) == (3, "")
    assert result.stderr.startswith("stoss: error: poisson: got ") and "allowed -0.95 to 0.4999" in result.stderr


@pytest.mark.parametrize("poisson", ["-0.95", "0", "0.4999"])
@pytest.mark.parametrize("law", ["center", "hertz"])
def test_range_ends_are_allowed(stoss, poisson, law):
    job = f"quasistatic --body sphere --poisson {poisson} --law {law}"
    for option in ("--speed 9", "--compression 9"):
        refusal = stoss.run(f"{job} {option}").stderr
        low, high = (float(word) for word in refusal.split("allowed ")[1].split()[0:3:2])
        near = high * (1 - 1e-5)
        assert stoss.run(f"{job} {option[:-1]}{low!r},{near!r} --quiet").returncode == 0


def test_interrupt_keeps_the_rows_so_far(stoss, tmp_path):
    path = tmp_path / "slow.csv"
    command = stoss.start(f"{SPHERE} --speed log:1e-9:0.01:10000 --format csv -o {path}", stderr=subprocess.PIPE)
    wait_for_rows(command, path, 3)
    command.send_signal(signal.SIGINT)
    assert command.wait(timeout=30) == 130
    assert command.stderr.read() == "stoss: error: interrupted\n"
    assert path.read_text().endswith("# interrupted: the rows above are complete, later ones are missing\n")


def test_a_closed_pipe_ends_it_quietly(stoss):
    command = stoss.start(f"{SPHERE} --speed log:1e-9:0.01:10000 --cutoff 10 --format csv",
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)  # fmt: skip
    assert command.stdout.readline().startswith("# stoss ")
    command.stdout.close()
    assert command.wait(timeout=30) == -signal.SIGPIPE
    assert command.stderr.read() == ""
