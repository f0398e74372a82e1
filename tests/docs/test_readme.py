"""README is short and shows how to begin; what it and docs/python.md say of accuracy is what the validation has found;
the page of the C++ library quotes programs that are built and run (tests/downstream)."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
PROSE = " ".join(README.split())
GUIDE = " ".join((ROOT / "docs/python.md").read_text(encoding="utf-8").split())
VALIDATION = (ROOT / "docs/validation.md").read_text(encoding="utf-8")
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


def test_pages_that_it_lists_are_all_there_are():
    table = README.partition("## Read on")[2]
    pages = {page.name for page in (ROOT / "docs").glob("*.md")} - {"index.md", "dependencies.md", "numerics.md"}
    assert pages <= set(re.findall(r"\]\(docs/(\w+\.md)\)", table))


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
    page = (ROOT / "docs/cpp.md").read_text(encoding="utf-8")
    folder = ROOT / "examples/library"
    for name in ("impact.cpp", "pairs.cpp", "oblique.cpp", "CMakeLists.txt"):
        assert f"```{'cmake' if name == 'CMakeLists.txt' else 'cpp'}\n{(folder / name).read_text()}```" in page, name
    assert page.count("```cpp") == len(list(folder.glob("*.cpp")))


def test_page_of_the_library_shows_what_they_print():
    page = (ROOT / "docs/cpp.md").read_text(encoding="utf-8")
    shown = re.findall(r"```text\n(.*?)```", page, re.DOTALL)
    names = ("impact", "pairs", "oblique")
    expected = [(ROOT / f"tests/downstream/{name}.txt").read_text(encoding="utf-8") for name in names]
    assert shown == expected
