"""Black-box tests of the stoss command. The program under test is in the environment variable STOSS."""

import csv
import io
import os
import subprocess

import pytest


class Command:
    def __init__(self, path):
        self.path = path

    def run(self, *arguments, **options):
        """Runs the command with `arguments` split at spaces; returns the completed process."""
        words = [word for argument in arguments for word in argument.split()]
        return subprocess.run(
            [self.path, *words], capture_output=True, text=True, timeout=120, stdin=subprocess.DEVNULL, **options
        )

    def data(self, *arguments):
        """Rows of the CSV output, as dictionaries; the command must succeed."""
        result = self.run(*arguments, "--format csv")
        assert result.returncode == 0, result.stderr
        return rows(result.stdout)


def rows(text):
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    return list(csv.DictReader(io.StringIO("\n".join(lines))))


@pytest.fixture(scope="session")
def stoss():
    return Command(os.environ["STOSS"])
