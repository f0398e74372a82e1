"""What tests of things to be carried elsewhere share. The command to compare with is in the environment variable STOSS;
the build tree around it has the rest."""

import json
import os
import re
import shlex
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
COMMAND = Path(os.environ["STOSS"]).resolve()
TREE = COMMAND.parents[1]
VERSION = re.search(r"project\(stoss VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]

# Where no request reaches anything.
OFFLINE = {
    **os.environ,
    **dict.fromkeys(("http_proxy", "https_proxy", "HTTP_PROXY", "HTTPS_PROXY", "ALL_PROXY"), "http://127.0.0.1:9"),
    "PIP_NO_INDEX": "1",
    "npm_config_offline": "true",
}


def run(*words, **options):
    """Runs a program to its end; returns the completed process, which has succeeded."""
    options = {"capture_output": True, "text": True, "timeout": 600, "stdin": subprocess.DEVNULL, **options}
    done = subprocess.run([str(word) for word in words], **options)
    assert done.returncode == 0, f"{words}\n{done.stdout}\n{done.stderr}"
    return done


@pytest.fixture(scope="session")
def record():
    """The first record of what the command prints as JSON."""

    def of(arguments):
        return json.loads(run(COMMAND, *shlex.split(arguments), "--format", "json").stdout)["records"][0]

    return of
