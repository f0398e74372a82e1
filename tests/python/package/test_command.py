"""`python -m stoss` becomes the command, or says how to get it."""

import os
import subprocess
import sys

import pytest

import stoss
from stoss._commands import guarded


def run(interpreter, path, *arguments):
    return subprocess.run(
        [sys.executable, "-m", "stoss", *arguments], env={**interpreter.environment, "PATH": str(path)},
        capture_output=True, text=True, timeout=60,
    )  # fmt: skip


@pytest.mark.skipif("STOSS" not in os.environ, reason="needs the command in STOSS")
def test_it_runs_the_command(interpreter, tmp_path):
    (tmp_path / "stoss").symlink_to(os.path.abspath(os.environ["STOSS"]))
    arguments = ["impact", "--poisson", "0.33", "--speed", "0.1", "--cutoff", "6"]
    alone = subprocess.run([os.environ["STOSS"], *arguments], capture_output=True, text=True, check=True)
    done = run(interpreter, tmp_path, *arguments)
    assert (done.returncode, done.stdout) == (0, alone.stdout)
    assert run(interpreter, tmp_path, "--version").stdout.split()[1] == stoss.__version__


def test_it_passes_arguments_and_exit_code_on(interpreter, tmp_path):
    script = tmp_path / "stoss"
    script.write_text('#!/bin/sh\nfor each; do echo "<$each>"; done\nexit 5\n')
    script.chmod(0o755)
    done = run(interpreter, tmp_path, "restitution", "--speed", "a b", "")
    assert (done.returncode, done.stdout.split("\n")) == (5, ["<restitution>", "<--speed>", "<a b>", "<>", ""])


def test_without_it_one_line_says_how_to_get_it(interpreter, tmp_path):
    done = run(interpreter, tmp_path, "modes")
    assert (done.returncode, done.stdout) == (2, "")
    assert "make install" in done.stderr and done.stderr.count("\n") == 1


def test_what_cannot_converge_is_one_line_and_its_own_exit_code(capsys):
    def run():
        raise stoss.NotConverged("impact: too many steps\nof time")

    assert guarded(run, "interrupted") == 1
    assert capsys.readouterr() == ("", "stoss: error: impact: too many steps of time\n")
