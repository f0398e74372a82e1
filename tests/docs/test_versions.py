"""One version: CMakeLists.txt has it, and whatever names it a second time names the same. CITATION.cff is valid."""

import os
import re
import subprocess

import pytest
from conftest import ROOT, page

PROJECT = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
VERSION = re.search(r"project\(stoss VERSION (\S+)", PROJECT)[1]
SOVERSION = re.search(r"set\(STOSS_SOVERSION (\d+)\)", PROJECT)[1]


def read(name):
    return (ROOT / name).read_text(encoding="utf-8")


def test_whatever_names_the_version_names_this_one():
    assert re.search(r"^version: (\S+)$", read("CITATION.cff"), re.MULTILINE)[1] == VERSION
    assert re.search(r"^## \[?(\d\S*?)\]?( |$)", read("CHANGELOG.md"), re.MULTILINE)[1] == VERSION
    assert read("debian/changelog").startswith(f"stoss ({VERSION}-")
    assert f"stoss {VERSION} follows" in page("docs/developer/versions.md")[0]
    for header in ("include/stoss/stoss.h", "include/stoss/version.hpp"):
        assert f'as in "{VERSION}"' in read(header), header


def test_what_is_built_has_this_version():
    done = subprocess.run([os.environ["STOSS"], "--version"], capture_output=True, text=True, check=True)
    assert done.stdout.split()[:2] == ["stoss", VERSION]


def test_packages_read_the_version_from_the_project():
    assert 'dynamic = ["version"]' in read("pyproject.toml")
    for name in ("setup.py", "web/vite.config.ts"):
        assert re.search(r"project\\\(stoss VERSION", read(name)), name
    assert 'importlib.metadata.version("stoss")' in read("docs/site/conf.py")
    assert "@VERSION@" in read("cli/stoss.1.in") and "@PROJECT_VERSION@" in read("cmake/stoss.pc.in")


def test_cmake_asks_for_the_python_of_the_package():
    needed = re.search(r'^requires-python = ">=(\S+)"$', read("pyproject.toml"), re.MULTILINE)[1]
    for name in ("python/CMakeLists.txt", "bench/CMakeLists.txt", "tests/CMakeLists.txt"):
        assert set(re.findall(r"find_package\(Python (\S+)", read(name))) == {needed}, name


def test_the_number_of_the_shared_library_is_its_own_and_is_documented():
    assert re.search(r"\n  SOVERSION \$\{STOSS_SOVERSION\}\)", PROJECT)
    assert f"`libstoss.so.{SOVERSION}`" in page("docs/developer/versions.md")[0]
    assert f"\nPackage: libstoss{SOVERSION}\n" in read("debian/control")


def test_the_changelog_begins_with_what_to_change():
    text = read("CHANGELOG.md").partition(f"## {VERSION}")[2]
    assert re.search(r"^### (.*)$", text, re.MULTILINE)[1] == "What you must change"


OPTIONAL = """abstract commit contact date-released doi identifiers keywords license license-url preferred-citation references
repository repository-artifact repository-code type url version""".split()


def test_the_citation_follows_the_rules_of_its_format():
    """Those of the schema of CFF 1.2.0 that matter here."""
    yaml = pytest.importorskip("yaml")
    citation = yaml.safe_load(read("CITATION.cff"))
    required = {"cff-version", "message", "title", "authors"}
    assert required <= set(citation) <= required | set(OPTIONAL)
    assert citation["cff-version"] == "1.2.0" and citation["type"] in ("software", "dataset")
    assert all(isinstance(citation[name], str) and citation[name] for name in ("message", "title", "version", "license"))
    assert citation["authors"] == [{"name": "The stoss developers"}]
    assert len(set(citation["keywords"])) == len(citation["keywords"]) > 0
    for reference in citation["references"]:
        assert {"type", "title", "authors"} <= set(reference)
        assert all({"family-names", "given-names"} == set(author) for author in reference["authors"])
        assert re.fullmatch(r"10\.\d{4,9}(\.\d+)?/[A-Za-z0-9:/_;\-\.\(\)\[\]\\]+", reference["doi"])
        assert isinstance(reference["year"], int) and isinstance(reference["volume"], int)


def test_every_format_that_the_sources_name_is_in_the_table():
    folders = (ROOT / folder for folder in ("src", "include", "python/stoss", "cli"))
    files = [file for folder in folders for file in folder.rglob("*") if file.suffix in (".cpp", ".hpp", ".h", ".py")]
    form = r'"(stoss [a-z]+(?: [a-z]+)* \d+)"'
    named = {each for file in files for each in re.findall(form, file.read_text(encoding="utf-8"))}
    table = re.findall(r"^\| [^|]* \| `(stoss [^`]*)` \|", page("docs/developer/versions.md")[0], re.MULTILINE)
    assert named == set(table) and len(table) == 6
    results = re.search(r'"stoss/\{\}/(\d+)"', read("cli/output/writer.cpp"))[1]
    assert f"| `stoss/KIND/{results}` |" in page("docs/developer/versions.md")[0]
