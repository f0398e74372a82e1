"""The linters find nothing in the tracked files, and find something in bad ones."""

import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BAD = {
    "unused.py": ("import os\n", "F401"),
    "undefined.py": ("print(unknown)\n", "F821"),
    "late.py": ("made = [lambda: n for n in range(3)]\n", "B023"),
    "old.py": ("from typing import List\n\nROWS: List[int] = []\n", "UP006"),
    "broken.py": ("def (\n", ""),
    "compare.ts": ("export const same = (one: string, other: string): boolean => one == other;\n", "noDoubleEquals"),
    "types.ts": ("export const any: any = 1;\n", "noExplicitAny"),
    "broken.ts": ("export const = ;\n", "parse"),
}


def lint(*files):
    done = subprocess.run(
        [ROOT / "scripts/lint.sh", *files], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300
    )
    if done.returncode == 77:
        pytest.skip(done.stdout.strip())
    return done


def test_the_sources_are_clean():
    done = lint()
    assert done.returncode == 0, done.stdout
    python, page = map(int, re.findall(r"[Cc]hecked (\d+) files", done.stdout))
    assert python > 350 and page > 100


@pytest.mark.parametrize("name", BAD)
def test_a_bad_file_is_found(tmp_path, name):
    text, rule = BAD[name]
    (tmp_path / name).write_text(text, encoding="utf-8")
    done = lint(tmp_path / name)
    assert done.returncode == 1 and f"{name}:" in done.stdout and rule in done.stdout, done.stdout


def test_a_line_may_say_why_it_keeps_what_is_found(tmp_path):
    (tmp_path / "kept.py").write_text("import os  # noqa: F401\n", encoding="utf-8")
    assert lint(tmp_path / "kept.py").returncode == 0
