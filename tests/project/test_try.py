"""make try: which tests a file has."""

import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def name_of(file):
    return subprocess.run([ROOT / "scripts/try.sh", "--name", file], cwd=ROOT, capture_output=True, text=True)


@pytest.mark.parametrize("file, name", [
    ("src/contact/contact.cpp", "try_contact"),
    ("src/contact/edge/edge_contact.cpp", "try_contact"),
    ("src/bodies/plate/sheet.cpp", "try_bodies_plate"),
    ("src/bodies/disk/disk.cpp", "try_bodies"),
    ("include/stoss/bodies/plate.hpp", "try_bodies"),
    ("include/stoss/material.hpp", "try_"),
    ("tests/identities/cases.cpp", "try_identities"),
    ("src/c/interface.cpp", "try_c"),
    (str(ROOT / "src/numeric/random.cpp"), "try_numeric"),
])  # fmt: skip
def test_a_file_has_the_tests_of_its_room(file, name):
    assert name_of(file).stdout.strip() == name


@pytest.mark.parametrize("file", ["", "cli/app.cpp", "src/nothing.cpp", "README.md"])
def test_a_file_without_is_refused(file):
    done = name_of(file)
    assert done.returncode == 2 and done.stderr.startswith(f"try: FILE: got '{file}', allowed ")
    assert len(done.stderr.splitlines()) == 1


def test_no_room_of_the_library_is_without_tests():
    for folder in {path.parent for path in (ROOT / "src").glob("*/**/*.cpp")}:
        assert name_of(str(next(folder.glob("*.cpp")).relative_to(ROOT))).stdout.strip() != "try_", folder
