"""Pages for users, docstrings, doc comments of headers and help texts stay below the ceilings of scripts/prose.py for
patterns of hard prose."""

import importlib.util
import re

import pytest
from conftest import ROOT

SPEC = importlib.util.spec_from_file_location("prose", ROOT / "scripts/prose.py")
prose = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(prose)


@pytest.mark.parametrize("page", prose.pages(), ids=lambda page: str(page.relative_to(ROOT)))
def test_page_is_below_the_ceilings(page):
    assert not dict(prose.too_many(page.read_text(encoding="utf-8")))


@pytest.mark.parametrize("face", prose.FACES)
def test_face_is_below_the_ceilings(face):
    text = prose.FACES[face]()
    assert prose.findings(text)[1] > 1000 and not dict(prose.too_many(text, but=("I fragments",)))


@pytest.mark.parametrize("page", prose.pages(), ids=lambda page: str(page.relative_to(ROOT)))
def test_headings_and_tables_stand_apart(page):
    """A heading within a line is no heading, and a line that follows a table is a row of it."""
    text = re.sub(r"^```.*?^```$", "```", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    assert not re.findall(r"^.*[.:)|]#{2,5} .*$|^[^\n]+\n#{1,5} .*$|^\|.*\n[^|\n].*$", text, re.MULTILINE)


@pytest.mark.parametrize("name, sentence", [
    ("A pronouns", "It takes its own from that of those that are both there, one by one, and they theirs."),
    ("A that of", "The loss is that of the plate."),
    ("B what", "The error covers what the mesh is too coarse for."),
    ("B of which", "The table has the types, of which the page has words."),
    ("C size", "A ball of 5 mm falls."),
    ("C as", "The impact ends there, as theory demands of it."),
    ("D fronted", "Of spheres the rings are known."),
    ("E semicolons", "The first is here; the second is there; the third is gone."),
    ("F G words", "The errors are honest and certified."),
    ("H persons", "Mean-field theory knows the constants."),
    ("I fragments", "A file of Gmsh, or STEP from any program."),
    ("J template", "The message is got 2, allowed 1 to 3."),
    ("long", "word " * 41 + "ends."),
])  # fmt: skip
def test_pattern_is_found(name, sentence):
    assert name in [each for each, _ in prose.findings(sentence)[0]]


def test_code_tables_and_formulas_do_not_count():
    page = "# That of those\n\n| that of | those of |\n|---|---|\n\n```text\nthat of those of\n```\n\n$$that of$$\n"
    assert prose.findings(page) == ([], 0)
