"""The study as a process of its own, that sees the same stoss as the tests."""

import os
import re
import subprocess
import sys
from pathlib import Path

import stoss

ROOT = Path(__file__).resolve().parents[2]
STUDIES = ROOT / "studies"


def environment(studies):
    folders = [str(studies), str(Path(stoss.__file__).parents[1]), os.environ.get("PYTHONPATH", "")]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, folders)), "PYTHONDONTWRITEBYTECODE": "1"}


def run(*arguments, studies=STUDIES):
    command = [sys.executable, "-m", "gerl_zippelius_1999", *map(str, arguments)]
    return subprocess.run(command, env=environment(studies), capture_output=True, text=True, timeout=400)


def states(process):
    """What the runner says of each item: computed, kept or failed."""
    return dict(re.findall(r"^\[\d+/\d+\] (\w+) +[\d.]+ s  (\w+)", process.stderr, re.MULTILINE))
