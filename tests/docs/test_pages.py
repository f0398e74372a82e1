"""Links, line lengths, names of files and claims about the sources in the documentation."""

import subprocess
import ast
import importlib.util
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
THEORY = sorted((ROOT / "docs/developer/derivations").glob("*.md"))


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


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_files_that_a_page_names_exist(page):
    folders = "bench|cli|cmake|docs|examples|include|python|scripts|src|studies|tests|validate"
    named = re.findall(rf"`((?:{folders})/[\w./]*)`", without_code(page))
    own = ROOT / "tests/docs/recipe"  # has the example of the architecture
    assert not [name for name in named if not (ROOT / name).exists() and not (own / name).exists()]


@pytest.mark.parametrize("folder", ["docs/theory", "docs/developer/derivations"])
def test_chapters_of_the_theory_are_all_in_its_index(folder):
    index = (ROOT / folder / "README.md").read_text(encoding="utf-8")
    chapters = {page.name for page in (ROOT / folder).glob("*.md")} - {"README.md"}
    assert chapters and all(f"]({name})" in index for name in chapters)


def test_letters_with_several_meanings_are_in_the_chapters_that_are_named():
    index = (ROOT / "docs/developer/derivations/README.md").read_text(encoding="utf-8")
    section = index.partition("## Letters with several meanings")[2].partition("\n## ")[0]
    lines = re.findall(r"^\| \$(\S+)\$ \| (.*) \|$", section, re.MULTILINE)
    assert len(lines) > 10
    for letter, meanings in lines:
        for chapter in re.findall(r"\]\((\w+\.md)\)", meanings):
            text = (ROOT / "docs/developer/derivations" / chapter).read_text(encoding="utf-8")
            formulas = re.findall(r"```math\n(.*?)```", text, re.DOTALL) + re.findall(r"\$([^$\n]+)\$", text)
            before = "" if letter.startswith("\\") else r"(?<![a-zA-Z\\])"
            assert re.search(rf"{before}{re.escape(letter)}(?![a-zA-Z])", " ".join(formulas)), (letter, chapter)


def included(folder):
    """Headers of other libraries that the sources in a folder include."""
    files = list((ROOT / folder).rglob("*.?pp"))
    text = "\n".join(file.read_text(encoding="utf-8") for file in files)
    return set(re.findall(r"^#include <(\w+/[\w/]+)", text, re.MULTILINE))


def test_dependencies_of_the_core_are_those_that_it_includes():
    page = (ROOT / "docs/developer/dependencies.md").read_text(encoding="utf-8")
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in page.splitlines() if line.startswith("| ")]
    said = {row[0].split()[0] for row in rows if "core" in row[-1]}
    names = {"Eigen": "Eigen", "boost/math": "Boost.Math", "boost/multiprecision": "Boost.Multiprecision",
             "Random123": "Random123", "nlohmann": "JSON"}
    found = {next(names[key] for key in names if header.startswith(key + "/")) for header in included("src")}
    assert said == found == set(names.values())
    assert not included("include")


ARCHITECTURE = (ROOT / "docs/architecture.md").read_text(encoding="utf-8")


def test_architecture_is_short():
    assert len(ARCHITECTURE.splitlines()) <= 300


def test_architecture_names_every_room():
    table = ARCHITECTURE.partition("## The library")[2].partition("\n## ")[0]
    named = set(re.findall(r"^\| `(\w+)`", table, re.MULTILINE))
    assert named == {room.name for folder in ("include/stoss", "src") for room in (ROOT / folder).iterdir() if room.is_dir()}


def test_architecture_names_every_folder():
    table = ARCHITECTURE.partition("## Around the library")[2].partition("\n\n#")[0]
    firsts = " ".join(re.findall(r"^\| ([^|]*) \|", table, re.MULTILINE))
    tracked = subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    folders = {name.split("/")[0] for name in tracked.splitlines() if "/" in name and not name.startswith(".")}
    assert set(re.findall(r"`(\w+)/", firsts)) == folders - {"include", "src"}


def test_recipe_of_the_architecture_is_the_one_that_is_compiled():
    recipe = ROOT / "tests/docs/recipe"
    quoted = dict(re.findall(r"`([\w/]+\.[ch]pp)`:\n\n```cpp\n(.*?)^```$", ARCHITECTURE, re.MULTILINE | re.DOTALL))
    files = [*recipe.glob("include/**/*.hpp"), *recipe.glob("src/**/*.cpp")]
    assert len(files) == ARCHITECTURE.count("```cpp")
    assert quoted == {str(file.relative_to(recipe)): file.read_text(encoding="utf-8") for file in files}
    patches = re.findall(r"```diff\n(.*?)^```$", ARCHITECTURE, re.MULTILINE | re.DOTALL)
    assert patches == [(recipe / name).read_text(encoding="utf-8") for name in ("anvil.patch", "half_width.patch")]


def test_what_a_new_input_and_a_new_body_touch():
    """Files that are made or changed: those of the recipes, which apply to the sources as they are."""
    recipe = ROOT / "tests/docs/recipe"
    touched = {}
    for name in ("anvil.patch", "half_width.patch"):
        check = ["git", "apply", "--check", "--unidiff-zero", str(recipe / name)]
        subprocess.run(check, cwd=ROOT, check=True)
        touched[name] = re.findall(r"^\+\+\+ b/(.*)$", (recipe / name).read_text(encoding="utf-8"), re.MULTILINE)
    section = ARCHITECTURE.partition("## How to add a body")[2].partition("\n## ")[0]
    made = [str(file.relative_to(recipe)) for file in recipe.glob("*/**/*.?pp")]
    named = {"CMakeLists.txt", "tests/identities/cases.hpp", "src/encounter/laws.cpp", "src/encounter/inside.cpp"}
    assert all(f"`{name}`" in section for name in named)
    folders = ["python/stoss/bodies/", "python/stoss/__init__.py", "tests/", "docs/theory/"]  # class, name, test, chapter
    assert len({*touched["anvil.patch"], *made, *named, *folders}) <= 15
    assert len(touched["half_width.patch"]) <= 3


def test_class_of_the_recipe_is_that_of_its_kind():
    (code,) = re.findall(r"```python\n(.*?)^```$", ARCHITECTURE, re.MULTILINE | re.DOTALL)
    ((_, *body),) = [[each, *each.body] for each in ast.parse(code).body if isinstance(each, ast.ClassDef)]
    assert not any(isinstance(each, ast.AnnAssign) for each in body)  # its fields follow from the table
    patch = (ROOT / "tests/docs/recipe/anvil.patch").read_text(encoding="utf-8")
    assert [each.value.value for each in body if isinstance(each, ast.Assign)] == re.findall(r'anvil.name = "(\w+)"', patch)


def rooms_picture():
    place = ROOT / "docs/images/rooms.py"
    spec = importlib.util.spec_from_file_location("rooms", place)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_picture_of_the_rooms_is_drawn_by_its_source():
    drawn = (ROOT / "docs/images/rooms.svg").read_text(encoding="utf-8")
    assert drawn == "\n".join(rooms_picture().picture()) + "\n"


def followed(arrows, room):
    """The rooms that arrows lead to, straight or through others."""
    ends = set(arrows.get(room, ()))
    return ends.union(*(followed(arrows, end) for end in ends))


def test_arrows_between_the_rooms_are_the_includes():
    picture = rooms_picture()
    rooms = set(picture.ROOMS)
    included = {room: set() for room in rooms}
    for folder in (ROOT / "include/stoss", ROOT / "src"):
        for file in folder.rglob("*/*.?pp"):
            into = file.relative_to(folder).parts[0]
            text = file.read_text(encoding="utf-8")
            for room in re.findall(r'^#include "(?:stoss/)?(\w+)[/.]', text, re.MULTILINE):
                if {room, into} <= rooms and room != into:
                    included[room].add(into)
    straight = {room: set(ends) for room, ends in picture.ARROWS.items()}
    assert all(ends <= followed(straight, room) for room, ends in included.items()), included
    assert all(ends <= included[room] for room, ends in straight.items())


def test_every_figure_has_the_code_that_draws_it():
    images = ROOT / "docs/images"
    page = (ROOT / "docs/developer/figures.md").read_text(encoding="utf-8")
    rows = [row.split("|")[1:3] for row in re.findall(r"^\| `.*$", page, re.MULTILINE)]
    drawn = {name: source for figures, source in rows for name in re.findall(r"`([\w.]+)`", figures)}
    assert set(drawn) == {file.name for file in images.iterdir() if file.suffix in (".png", ".svg", ".gif")}
    for name, source in drawn.items():
        files = [ROOT / file for file in re.findall(r"`([\w/.]+)`", source)]
        text = "\n".join(file.read_text(encoding="utf-8") for file in [*files, ROOT / "Makefile"])
        assert files and name in text, name


def test_every_figure_is_shown():
    text = "\n".join(page.read_text(encoding="utf-8") for page in PAGES)
    for file in (ROOT / "docs/images").iterdir():
        assert file.suffix in (".py", ".md") or re.search(rf"!\[[^\]]*\]\([\w/.]*images/{file.name}\)", text), file.name
