"""The numbers of docs/understand/: those of the validation, the benchmarks, the tables and the command."""

import csv
import importlib.util
import re

import pytest
from conftest import ROOT, command, page, table

VALIDATION, _ = page("docs/developer/validation.md")
BENCHMARKS, _ = page("docs/developer/benchmarks.md")


def words(name):
    return page(f"docs/understand/{name}.md")[1]


def cells(text, *starts):
    """The cells of the line of a table that begins with these."""
    joined = r" \| ".join(map(re.escape, starts))
    found = re.search(rf"^\| {joined} \|.*$", text, re.MULTILINE)
    return [cell.strip() for cell in found[0].split("|")[1:-1]]


def section(title):
    return VALIDATION.partition(f"\n## {title}\n")[2].partition("\n## ")[0]


def scatter():
    spec = importlib.util.spec_from_file_location("scatter", ROOT / "validate/scatter.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_points_of_the_picture_are_those_of_the_validation():
    points = list(scatter().points(VALIDATION))
    lines = (ROOT / "docs/results/validation.csv").read_text(encoding="utf-8").splitlines()[2:]
    assert [tuple(row) for row in csv.reader(lines)] == points
    ratios = [float(row[-1]) for row in points]
    share = 100 * sum(ratio <= 1 for ratio in ratios) / len(ratios)
    assert f"Of these {len(ratios)} impacts, {share:.1f} % are within" in words("accuracy") and max(ratios) <= 3


def test_shares_within_the_errors():
    its = [cells(line, "0.001") for line in section("Result").splitlines() if line.startswith("| 0.001 |")]
    within = [float(row[3].removesuffix(" %")) for row in its]
    text = words("accuracy")
    assert f"{min(within):.0f} to {max(within):.0f} % of the test cases of each of ten sets" in text and len(its) == 10
    medians = [float(row[5]) for row in its]
    assert f"the stated error is {min(medians):.0f} to {max(medians):.0f} times the true one" in text
    fast = re.search(r"with 0.1 < v < 0.6, ([\d, ]+ and \d+) % lie within", " ".join(VALIDATION.split()))[1]
    assert f"{fast.replace(', 92 and', ', 92 and')} % of 120 disks" in text
    modes, oblique = cells(section("Bodies by their modes at a point"), "all", "1−ε²"), section("Oblique impacts")
    assert f"by their modes it is {modes[3]}" in text
    assert f"for oblique impacts {cells(oblique, '0.001', 'all', 's′')[4]}" in text


def test_costs():
    text = words("accuracy")
    its = [cells(section("Convergence and time"), tolerance) for tolerance in ("0.01", "0.001", "0.0001")]
    assert cells(page("docs/understand/accuracy.md")[0], "disk at a wall, median of 240 speeds and ν")[1:] == [
        f"{row[3]} ms" for row in its
    ]
    assert [f"{row[4]} ms" for row in its] == cells(page("docs/understand/accuracy.md")[0],
                                                   "the same, one case of a hundred takes at least")[1:]  # fmt: skip
    oblique = [cells(section("Times of oblique impacts"), tolerance, "all")[4] for tolerance in ("0.01", "0.001")]
    assert f"| oblique impact, median | {oblique[0]} ms | {oblique[1]} ms | – |" in page("docs/understand/accuracy.md")[0]
    assert f"takes {its[1][3]} ms in the median of 240 test points" in words("performance")
    assert f"and {its[1][5]} ms at most" in words("performance") and text


@pytest.mark.parametrize("shape, mine", [("disk", "disk at a wall"), ("sphere", "sphere at a wall"),
                                         ("half-space", "sphere on a block")])  # fmt: skip
def test_ratios_to_finite_elements(shape, mine):
    block = BENCHMARKS.partition(f"\n| {shape}: error, speed |")[2].partition("\n\n")[0]
    ratios = {tuple(re.findall(r"[\d.]+", line)[:2]): line.split("|")[-2].strip() for line in block.splitlines()[2:]}
    shown = re.findall(rf"^\| {mine}, v = ([\d.]+) c \| ([\d.]+) \| ([\d.]+) \|$", page("docs/understand/performance.md")[0], re.M)
    assert shown
    for speed, coarse, fine in shown:
        assert (ratios["0.01", speed], ratios["0.001", speed]) == (coarse, fine)


def test_loss_of_a_slow_sphere():
    job = "restitution --body sphere --poisson 0.3 --speed 1e-4"
    for arguments, said in (("", "0.00002488(22)"), (" --absolute 0", "0.000024937(14)")):
        (row,) = command(job + arguments)
        value, error = re.fullmatch(r"([\d.]+)\((\d+)\)", said).groups()
        unit = 10.0 ** -len(value.partition(".")[2])
        assert said in words("accuracy")
        assert abs(row["lost_fraction"] - float(value)) < unit and abs(row["lost_fraction_error"] / unit - int(error)) < 1


def test_channels_are_those_of_the_command():
    spec = importlib.util.spec_from_file_location("energy", ROOT / "studies/energy/figure.py")
    energy = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(energy)
    text = page("docs/understand/energy.md")[0]
    rows = list(energy.predicted(command.__globals__["os"].environ["STOSS"]))
    for row, stored in zip(rows, table("docs/results/energy.csv"), strict=True):
        assert float(row["restitution"]) == pytest.approx(stored["restitution"], abs=2e-5)
        shown = cells(text, row["case"])
        assert shown[1] == f"{stored['restitution']:.3f}"
        for name, cell in zip(energy.CHANNELS, shown[2:], strict=True):
            percent = 100 * stored[name]
            assert float(row[name]) == pytest.approx(stored[name], rel=0.02, abs=1e-8)
            assert cell == ("0" if percent == 0 else f"{percent:.2f} %" if percent < 10 else f"{percent:.1f} %"), row["case"]
    block, pane = (float(row["radiation"]) for row in rows[:2])
    assert f"loses {pane / block:.0f} times as much energy as waves" in words("energy")


def test_related_laws_say_what_the_theory_says():
    text = words("related_laws")
    excess = re.search(r"^\| \$F_\{\\max\}/F_H - 1\$, ball at a wall \|(.*)\|$", page("docs/theory/points.md")[0], re.M)[1].split("|")
    assert f"by {excess[0].strip()} at 10⁻⁵ c, by {excess[2].strip()} at 10⁻³ c" in text
    assert f"by {excess[4].strip()} at 0.01 c" in text


def test_regimes_are_those_of_the_command():
    rows = [row for row in table("docs/results/regimes.csv") if row["pair"] == "two balls of bearing steel"]
    chosen = rows[::8]
    speeds = ",".join(f"{row['speed']:g}" for row in chosen)
    job = f'predict --body sphere --material "bearing steel" --radius 0.005 --against same --speed {speeds} --quiet'
    for row, found in zip(chosen, command(job), strict=True):
        assert found["dominant"] == row["dominant"]
        assert found["restitution"] == pytest.approx(row["restitution"], abs=2e-4)
