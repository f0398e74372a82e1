"""Times depend on a machine, so no test can repeat them; but what pages say of them must be what the tables of
docs/developer/benchmarks.md and docs/developer/validation.md hold."""

import math
import re

import pytest
from conftest import page

PAGE, WORDS = page("docs/developer/benchmarks.md")
VALIDATION, VALIDATION_WORDS = page("docs/developer/validation.md")


def rows(first):
    """The lines of the table whose header begins so, as lists of cells."""
    block = PAGE[PAGE.index(f"\n| {first} |") + 1 :].partition("\n\n")[0].splitlines()
    return [[cell.strip() for cell in line.split("|")[1:-1]] for line in block[2:]]


MS = {cells[0]: cells[1:] for cells in rows("benchmark")}
PROTOCOL = float(MS["the paper's protocol"][0])


def ms(name):
    """The time of a benchmark, in whichever table it is."""
    return float(re.search(rf"^\| {re.escape(name)} \| ([\d.]+) \|", PAGE, re.MULTILINE)[1])


def rounded(value, shown):
    """Whether a number, as a page shows it, is that value."""
    digits = len(shown.partition(".")[2])
    return abs(float(shown) - value) <= 0.5001 * 10.0**-digits


@pytest.mark.parametrize("name", [name for name, cells in MS.items() if len(cells) >= 4 and cells[3] != "–"])
def test_ratios_to_the_paper(name):
    time, ratio = float(MS[name][0]), float(MS[name][3])
    assert ratio == pytest.approx(PROTOCOL / time, abs=0.006, rel=2.5e-3)


def elements(shape):
    """The table of finite elements of a shape, by the task."""
    return {cells[0]: cells[1:] for cells in rows(f"{shape}: error, speed")}


ELEMENTS = elements("disk")
CASES = page("bench/finite_element_cases.hpp")[1]
# By speed, the place of its case in bench/cases.hpp, by whose name the header of meshes has it.
PLACES = {
    "disk": ("hard_wall_cases", {"0.01": 1, "0.1": 2, "0.3": 3}),
    "sphere": ("sphere_cases", {"0.1": 0, "0.05": 1, "0.01": 3}),
    "half-space": ("half_space_cases", {"0.1": 0, "0.01": 1}),
}


@pytest.mark.parametrize("shape, task", [(shape, task) for shape in PLACES for task in elements(shape)])
def test_ratios_to_finite_elements(shape, task):
    count, theirs, ours, ratio = elements(shape)[task]
    assert rounded(float(theirs) / float(ours), ratio) or ratio == f"{float(theirs) / float(ours):.2g}"
    tolerance, _, speed = task.partition(", v = ")
    name, places = PLACES[shape]
    found = re.search(rf"{name}\[{places[speed]}\], 1e-{len(tolerance) - 2}, {{(\d+), (\d+), ", CASES)
    across, rings = map(int, found.groups())
    assert int(count.partition(" + ")[0]) == 2 * across**2 + 4 * across * rings


def test_finite_elements_of_the_large_table():
    for name in MS:
        if name.startswith("finite elements to "):
            task = name.removeprefix("finite elements to ")
            _, theirs, ours, ratio = ELEMENTS[task if "v = " in task else f"{task}, v = 0.1"]
            same = MS[f"restitution to {task}"]
            assert (theirs, ours) == (MS[name][0], same[0])
            assert float(same[4]) == pytest.approx(float(ratio), rel=0.06), name


@pytest.mark.parametrize("shape, what, more", [("sphere", "a sphere", ""),
                                               ("half-space", "a sphere on a half-space", ", set-up included")])
def test_finite_elements_of_the_table_of_spheres(shape, what, more):
    for task, (_, theirs, ours, _) in elements(shape).items():
        tolerance, _, speed = task.partition(", v = ")
        names = (f"finite elements of {what} to {tolerance}, v = {speed}",
                 f"restitution of {what} to {tolerance}{more}, v = {speed}")
        assert [float(theirs), float(ours)] == [ms(name) for name in names]
        said = re.search(rf"^\| {re.escape(names[1])} \|[^|]*\|[^|]*\|[^|]*\| ([\d.]+) \|", PAGE, re.MULTILINE)[1]
        assert float(said) == pytest.approx(float(theirs) / float(ours), rel=0.02), names


def test_claims_about_finite_elements():
    ratio = {task: cells[3] for task, cells in ELEMENTS.items()}
    assert f"{ratio['0.01, v = 0.1']} times as long as `restitution` to 10⁻² at v = 0.1" in WORDS
    assert f"and {ratio['0.001, v = 0.1']} times to 10⁻³" in WORDS
    assert f"at v = 0.01 {ratio['0.01, v = 0.01']} and {ratio['0.001, v = 0.01']} times" in WORDS
    assert f"v = 0.3 they reach 10⁻² in {ratio['0.01, v = 0.3']} times its time" in WORDS
    assert rounded(float(ELEMENTS["0.01, v = 0.1"][1]), limits(3)["7·10⁻⁴"])
    assert rounded(float(ELEMENTS["0.001, v = 0.1"][1]), limits(3)["1·10⁻⁴"])
    ball = [float(cells[3]) for cells in elements("sphere").values()]
    assert f"Of spheres at a wall they take {min(ball):.0f} to {max(ball):.0f} times as long" in WORDS
    below = [float(cells[3]) for cells in elements("half-space").values()]
    assert f"on a half-space {min(below):.2g} to {max(below):.0f} times" in WORDS


def test_before_and_after():
    shown = {}
    for name, *cells in rows("before and after"):
        before, after, ratio = map(float, cells)
        assert after / before == pytest.approx(ratio, abs=0.011), name
        shown[name] = ratio
    longer = [shown.pop(f"disk, v = 0.01, to {tolerance}") for tolerance in ("10⁻³", "10⁻⁴")]
    single = [ratio for name, ratio in shown.items() if re.match("disk|sphere", name)]
    changes = page("CHANGELOG.md")[1]
    assert f"most take {min(single):.1f} to {max(single):.1f} of the time" in changes
    assert "a disk at v = 0.01 takes {:.1f} times as long to 10⁻³, and {:.1f} times to 10⁻⁴".format(*longer) in changes


def limits(column):
    """What a column of the errors against times says, by the error."""
    return {row[0]: row[column] for row in rows("error ≤")}


def test_errors_against_times():
    assert rounded(PROTOCOL, limits(1)["9·10⁻³"])
    two = ms("the paper's two limits, modes included")
    assert rounded(two, limits(2)["7·10⁻⁴"])
    assert rounded(ms("hard wall, static, cutoff 25"), limits(4)["9·10⁻³"])
    assert rounded(ms("hard wall, static, cutoff 100"), limits(4)["7·10⁻⁴"])
    by_impact = {"7·10⁻⁴": "hard wall, as restitution resolves it, cutoff 16",
                 "1·10⁻⁴": "hard wall, radiating, cutoff 25",
                 "2·10⁻⁵": "hard wall, radiating, cutoff 50", "7·10⁻⁶": "hard wall, radiating, cutoff 50",
                 "2·10⁻⁶": "hard wall, as restitution resolves it, cutoff 64"}  # fmt: skip
    assert all(rounded(ms(name), limits(5)[error]) for error, name in by_impact.items())
    converged = {"7·10⁻⁴": "0.01", "1·10⁻⁴": "0.001", "2·10⁻⁵": "0.0001", "7·10⁻⁶": "0.0001"}
    assert all(rounded(ms(f"restitution to {to}"), limits(6)[error]) for error, to in converged.items())
    best = ms("restitution to 0.01")
    assert f"takes {two:.0f} ms with the modes, steps and inner loops of stoss" in WORDS
    assert f"`restitution` to 10⁻² takes {best:.1f} ms, {round(two / best, -1):.0f} times less" in WORDS


def test_tolerances():
    slow = {to: [float(cells[0]) for name, cells in MS.items() if re.match(rf"restitution to {to}(, v = .*)?$", name)]
            for to in ("0.01", "0.001", "0.0001")}  # fmt: skip
    assert {f"{time:.1f}" for time in slow["0.01"]} == {"0.4"} and "10⁻² takes 0.4 ms" in WORDS
    assert f"10⁻³ {min(slow['0.001']):.1f} to {max(slow['0.001']):.1f} ms" in WORDS
    assert f"10⁻⁴ {min(slow['0.0001']):.0f} to {max(slow['0.0001']):.0f} ms" in WORDS


def test_other_claims():
    assert f"it takes {ms('restitution of a sphere to 0.001, v = 0.0001, absolute 0'):.0f} ms at v = 10⁻⁴" in WORDS
    modes = [ms(f"modes of a sphere, cutoff {cutoff}") for cutoff in (100, 400)]
    assert f"ω ≤ 100 in {modes[0]:.0f} ms" in WORDS and f"66 974 of them, in {modes[1]:.0f} ms" in WORDS
    accurate = [ms(f"restitution of a sphere to 0.001, v = {v}") for v in (0.1, 0.05, 0.02)]
    assert f"a value takes {min(accurate):.0f} to {max(accurate):.0f} ms" in WORDS
    for v, digits in ((0.1, "1.3"), (0.01, "1.6")):
        time = ms(f"100 samples of a sphere at temperature 0.01 up to 10 c/R, to 0.001, v = {v}")
        assert rounded(time / 100, digits) and f"{digits} ms" in WORDS
    cutoffs = [ms(f"hard wall, as restitution resolves it, cutoff {cutoff}") for cutoff in (16, 32, 64, 128, 256)]
    powers = ", ".join(f"{math.log2(b / a):.1f}" for a, b in zip(cutoffs, cutoffs[1:]))
    assert f"256 is {powers};" in WORDS
    assert round(ms("the paper's protocol, every mode at every angle") / PROTOCOL) == 7
    assert "it takes seven times as long (second row)" in WORDS
    curves = [ms(f"two curves of 60 speeds to 0.001, {n}, modes included") / 1e3 for n in ("1 thread", "2 threads")]
    assert f"{curves[0]:.2f} s on one thread, {curves[1]:.2f} s on two" in WORDS


def test_oblique_claims():
    disk = "oblique: a disk, v = 0.1, μ = 0.3, x = 3.33, to 0.01", "oblique: a disk, v = 0.003, μ = 0.1, x = 0.2, to 0.001"
    assert f"A disk takes {ms(disk[0]):.0f} ms to 10⁻², one that nearly sticks {ms(disk[1]):.0f} ms to 10⁻³" in WORDS
    said = []
    for what in ("sphere, v = 0.001", "sphere on a half-space, v = 0.001", "sphere on a half-space, v = 1e-05"):
        one, all_angles = (ms(f"oblique: {many}a {what}, x = 1, to 0.01") for many in ("", "33 angles, "))
        said.append((one, (all_angles - one) / 32))
    (wall, angle), (fast, its), (slow, each) = said
    assert f"A sphere takes {wall:.1f} ms and {angle:.2f} ms for each further angle" in WORDS
    assert f"on a half-space at v = 10⁻³ {fast:.0f} and {its:.1f} ms, at 10⁻⁵ {slow:.0f} and {each:.1f} ms" in WORDS


def over_the_whole_range():
    """Of each tolerance what docs/developer/validation.md measures: converged, cutoff, and times: median, 99 %, longest."""
    line = r"^\| (0\.\d+) \| (\d+) of 240 \| (\d+) \| ([\d.]+) \| (\d+) \| (\d+) \|"
    found = re.findall(line, VALIDATION, re.MULTILINE)
    return {float(tolerance): rest for tolerance, *rest in found}


RANGE = over_the_whole_range()


def test_times_that_others_quote():
    _, _, median, most, _ = RANGE[1e-3]
    said = rf"takes {re.escape(median)} ms in the median(?:, {most} ms or more in one case of a hundred)?"
    guide = page("docs/howto/accuracy.md")[1]
    for other in ("README.md", "docs/howto/accuracy.md", "docs/paper/paper.md", "python/stoss/results/_restitution.py"):
        text = page(other)[1]
        every = re.findall(r"takes [\d.]+ m?s in the median(?:, [\d.]+ m?s or more in one case of a hundred)?", text)
        assert len(every) == 1 and re.fullmatch(said, every[0]), (other, every)
        assert ("one case of a hundred" in every[0]) == (other in ("docs/howto/accuracy.md", "python/stoss/results/_restitution.py"))
    _, _, finer, slowest, _ = RANGE[1e-4]
    found = re.search(r"tolerance of 10⁻⁴ it takes ([\d.]+) ms and ([\d.]+) s", guide)
    assert found[1] == finer and rounded(float(slowest) / 1e3, found[2]) and len(found[2]) >= len("0.72")


def test_coverage_of_fast_disks_that_others_quote():
    said = r"with 0.1 < v < 0.6, ([\d, ]+) and (\d+) % lie within the error at (.*?), (.*?), (.*?) and (.*?), and"
    shares, last, *tolerances = re.search(said, VALIDATION_WORDS).groups()
    at = dict(zip(tolerances, [*shares.split(", "), last], strict=True))
    both = rf"for fast disks \(0.1 to 0.6 c\) (?:in )?{at['10⁻³']} % at the tolerance 10⁻³ and {at['10⁻⁴']} % at 10⁻⁴"
    others = {  # tests/docs/test_paper.py has the paper
        "README.md": rf"{at['10⁻³']} % for fast disks, 0.1 to 0.6 c",
        "docs/howto/accuracy.md": rf"at the default tolerance [^.]*, for fast disks \(0.1 to 0.6 c\) {at['10⁻³']} %",
        "include/stoss/restitution/restitution.hpp": both,
        "python/stoss/results/_restitution.py": both,
    }
    for other, quoted in others.items():
        text = " ".join(page(other)[1].replace("///", "").split())
        assert len(re.findall(quoted, text)) == 1, other
        assert "never beyond three times" not in text, other
