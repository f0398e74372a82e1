"""`python -m stoss` in a folder with a small grid, for the tests of sweeps."""

import subprocess
import sys

import pytest

SMALL = 'speed = [0.01, 0.1]\ntolerance = 1e-2\nbodies = {kind = "sphere", poisson = [0.1, 0.3]}\n'


class Command:
    """`python -m stoss` in a folder."""

    def __init__(self, folder, environment):
        self.folder, self.environment = folder, environment
        (folder / "grid.toml").write_text(SMALL)

    def start(self, *words, **options):
        pipe = subprocess.PIPE
        command = [sys.executable, "-m", "stoss", *words]
        return subprocess.Popen(
            command, cwd=self.folder, env=self.environment, stdout=pipe, stderr=pipe, text=True, **options
        )

    def run(self, *words):
        """Exit code and what is on stderr; nothing is on stdout."""
        process = self.start(*words)
        out, error = process.communicate(timeout=300)
        assert out == ""
        return process.returncode, error


@pytest.fixture
def command(tmp_path, interpreter):
    return Command(tmp_path, interpreter.environment)
