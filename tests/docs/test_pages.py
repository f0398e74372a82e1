"""Links, line lengths, names of files and claims about the sources in the documentation."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
THEORY = sorted((ROOT / "docs/theory").glob("*.md"))


PAGES = [*sorted(ROOT.glob("*.md")), *sorted((ROOT / "docs").rglob("*.md"))]


def without_code(page):
    text = page.read_text(encoding="utf-8")
    return re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)


def anchors(page):
    """The anchors that GitHub gives to the headings of a page."""
    titles = re.findall(r"^#+ (.*)$", without_code(page), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_between_pages_lead_somewhere(page):
    for target in re.findall(r"\]\(([^)\s]+)\)", without_code(page)):
        if not re.match(r"\w+:", target):
            name, _, anchor = target.partition("#")
            there = page.parent / name if name else page
            assert there.exists(), target
            assert not anchor or anchor in anchors(there), target


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_formulas_in_a_line_have_no_escape_that_markdown_takes_away(page):
    formulas = re.findall(r"(?<!`)\$[^$`]+\$", without_code(page))
    assert not [formula for formula in formulas if re.search(r"\\[!-/:-@\[-`{-~]", formula)]


def test_equations_of_the_paper_are_cited_by_number():
    folders = (ROOT / name for name in ("include", "src", "tests", "bench"))
    for place in [*PAGES, *(file for folder in folders for file in folder.rglob("*.?pp"))]:
        cited = re.findall(r"\b[Ee]qs?\. (\S+)", place.read_text(encoding="utf-8"))
        assert not [name for name in cited if re.match(r"`|[A-Za-z]", name)], place


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_prose_has_short_lines(page):
    prose = re.sub(r"^\|.*$", "", without_code(page), flags=re.MULTILINE)
    assert not [line for line in prose.splitlines() if len(line) > 100]


@pytest.mark.parametrize("page", THEORY, ids=lambda page: page.name)
def test_chapter_of_the_theory_names_code_that_exists(page):
    text = page.read_text(encoding="utf-8")
    for paragraph in re.findall(r"^Code: .*?(?=\n\n|\Z)", text, re.MULTILINE | re.DOTALL):
        for name, symbols in re.findall(r"`((?:src|include)/[\w./]+)`(?:\s\(([^)]*)\))?", paragraph):
            code = (ROOT / name).read_text(encoding="utf-8")
            assert all(symbol in code for symbol in re.findall(r"`(\w+)`", symbols)), (name, symbols)


def test_chapters_of_the_theory_are_all_in_its_index():
    index = (ROOT / "docs/theory/README.md").read_text(encoding="utf-8")
    assert THEORY and all(f"]({page.name})" in index for page in THEORY if page.name != "README.md")


def included(folder):
    """Headers of other libraries that the sources in a folder include."""
    files = [file for file in (ROOT / folder).rglob("*.?pp")]
    text = "\n".join(file.read_text(encoding="utf-8") for file in files)
    return set(re.findall(r"^#include <(\w+/[\w/]+)", text, re.MULTILINE))


def test_dependencies_of_the_core_are_those_that_it_includes():
    page = (ROOT / "docs/dependencies.md").read_text(encoding="utf-8")
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in page.splitlines() if line.startswith("| ")]
    said = {row[0].split()[0] for row in rows if "core" in row[-1]}
    names = {"Eigen": "Eigen", "boost/math": "Boost.Math"}
    found = {next(names[key] for key in names if header.startswith(key + "/")) for header in included("src")}
    assert said == found == set(names.values())
    assert not included("include")


def test_index_of_the_private_rooms_has_every_source():
    page = (ROOT / "docs/architecture.md").read_text(encoding="utf-8")
    table = page.partition("### Private rooms")[2].partition("###")[0]
    named = set(re.findall(r"`(?:\w+/)?(\w+)(?:\.hpp)?`", "\n".join(re.findall(r"^\|.*$", table, re.MULTILINE))))
    public = {header.stem for header in (ROOT / "include").rglob("*.hpp")}
    private = {file.stem for file in (ROOT / "src").rglob("*.?pp")} - public
    assert private <= named, private - named
