"""README is short and shows how to begin; its numbers are those of tables and of the validation; every page is in the contents;
the page of the C++ library quotes programs that are built and run (tests/downstream)."""

import re
from pathlib import Path

import pytest
from conftest import table

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
PROSE = " ".join(README.split())
GUIDE = " ".join((ROOT / "docs/howto/accuracy.md").read_text(encoding="utf-8").split())
VALIDATION = (ROOT / "docs/developer/validation.md").read_text(encoding="utf-8")
DEFAULT = "0.001"  # the tolerance of which README speaks


def rows(section):
    """The rows of the tables of a section at the default tolerance."""
    text = VALIDATION.partition(f"\n## {section}\n")[2].partition("\n## ")[0]
    lines = [[cell.strip() for cell in line.split("|")[1:-1]] for line in text.splitlines() if line.startswith("| ")]
    return [line for line in lines if line[0] == DEFAULT]


def test_it_is_short():
    assert len(README.splitlines()) <= 120


@pytest.mark.parametrize("line", ["make demo", "make python", "make test", "pip install ."])
def test_it_shows_how_to_begin(line):
    assert line in README


def test_every_page_is_in_the_contents():
    index = (ROOT / "docs/index.md").read_text(encoding="utf-8")
    listed = re.findall(r"^(?:.* <)?([a-z_]+/[\w/]+|architecture|CONTRIBUTING|CHANGELOG)>?$", index, re.MULTILINE)
    pages = {str(page.relative_to(ROOT / "docs").with_suffix("")) for page in (ROOT / "docs").rglob("*.md")}
    pages -= {page for page in pages if page.startswith("paper/")} | {"index"}
    made = {"examples/index", "CONTRIBUTING", "CHANGELOG"}
    made |= {f"reference/{name}/index" for name in ("python", "cpp", "command")}
    assert sorted(listed) == sorted(pages | made)


def test_rebound_along_the_surface_is_that_of_the_tables():
    rows = table("docs/results/oblique/dem.csv")
    mindlin = ("history", "rescale", "force", "rescale_force")
    springs = [row["tangential_restitution"] for row in rows if row["law"] in mindlin and row["x"] <= 1]
    low, high = re.search(r"Mindlin's stiffness give ε_t from −([\d.]+) to −([\d.]+)", PROSE).groups()
    assert (low, high) == (f"{-min(springs):.2f}", f"{-max(springs):.2f}")
    slow = [row["tangential_restitution"] for row in table("docs/results/oblique/curves.csv")
            if row["bodies"] == "sphere" and row["speed"] <= 1e-3 and row["x"] <= 1]  # fmt: skip
    assert "has −0.2 to 0.2" in PROSE and (round(min(slow), 1), round(max(slow), 1)) == (-0.2, 0.2)
    balls = [row for row in table("docs/results/oblique/superball.csv") if row["bodies"] == "sphere"]
    at_first = max(row["tangential_restitution"] for row in balls if row["speed"] <= 1e-4)
    assert "less than 0.65 of their sliding" in PROSE and 0.6 < at_first < 0.65
    best = max(balls, key=lambda row: row["tangential_restitution"])
    assert f"{best['speed']:g} c, and {best['tangential_restitution']:.2f} comes back" in PROSE


def test_share_of_true_errors_within_the_estimates_is_that_of_the_validation():
    within = [float(row[3].removesuffix(" %")) for row in rows("Result")]
    words = "one two three four five six seven eight nine ten".split()
    said = re.search(r"(\d+) to (\d+) % of the true errors", PROSE)
    assert (int(said[1]), int(said[2])) == (int(min(within)), int(max(within)))
    assert f"{words[len(within) - 1]} sets" in PROSE
    assert f"{said[1]} to {said[2]} % of the true errors are within" in GUIDE


def test_times_are_those_of_the_validation():
    ((_, converged, _, median, _, longest, *_),) = rows("Convergence and time")
    points = converged.split()[-1]
    assert f"takes {median} ms in the median of {points} test points, at most {longest} ms" in PROSE


def test_page_of_the_library_quotes_its_examples():
    page = (ROOT / "docs/reference/cpp.md").read_text(encoding="utf-8")
    folder = ROOT / "examples/library"
    for name in ("impact.cpp", "pairs.cpp", "oblique.cpp", "CMakeLists.txt"):
        assert f"```{'cmake' if name == 'CMakeLists.txt' else 'cpp'}\n{(folder / name).read_text()}```" in page, name
    assert page.count("```cpp") == len(list(folder.glob("*.cpp")))


def test_page_of_the_library_shows_what_they_print():
    page = (ROOT / "docs/reference/cpp.md").read_text(encoding="utf-8")
    shown = re.findall(r"```text\n(.*?)```", page, re.DOTALL)
    names = ("impact", "pairs", "oblique")
    expected = [(ROOT / f"tests/downstream/{name}.txt").read_text(encoding="utf-8") for name in names]
    assert shown == expected
