"""`stoss fit`, `sweep` and `merge` find the Python package beside the command, without PATH."""

import shutil
import subprocess

import pytest


@pytest.mark.parametrize("place", ["build/release/cli", "build/static", "build/venv/bin"])
def test_beside_the_command(stoss, tmp_path, place):
    folder, venv = tmp_path / place, tmp_path / "build/venv"
    folder.mkdir(parents=True)
    command = shutil.copy(stoss.path, folder / "stoss")
    words = [command, "merge", "none", "-o", "x.nc"]
    (venv / "bin").mkdir(parents=True, exist_ok=True)
    python = venv / "bin/python3"
    python.write_text('#!/bin/sh\necho "$0"\n')
    python.chmod(0o755)
    without = subprocess.run(words, capture_output=True, text=True, cwd=tmp_path)
    assert without.stdout == ""  # an environment without the package is left alone
    package = venv / "lib/python3.11/site-packages/stoss"
    package.mkdir(parents=True)
    (package / "__init__.py").touch()
    done = subprocess.run(words, capture_output=True, text=True, cwd=tmp_path, env={"PATH": "/nowhere"})
    assert done.stdout == f"{python}\n", done.stderr
