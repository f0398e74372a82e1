"""A FIFO among the files of a store: it is refused, as reading it would wait for ever."""

import os
import subprocess
import sys

import pytest
import stoss

GRID = """import sys, stoss
stoss.sweep({"bodies": {"kind": "sphere", "poisson": 0.3}, "speed": [0.1], "tolerance": 1e-2}, store=sys.argv[1])"""


@pytest.mark.parametrize("name", ["grid.json", "shard-1-of-1.csv", "other.csv"])
def test_is_refused(tmp_path, name):
    os.mkfifo(tmp_path / name)
    if name != "grid.json":
        fresh = tmp_path / "fresh"
        subprocess.run([sys.executable, "-c", GRID, str(fresh)], check=True, timeout=60)
        (fresh / "grid.json").rename(tmp_path / "grid.json")
    result = subprocess.run([sys.executable, "-c", GRID, str(tmp_path)], capture_output=True, text=True, timeout=60)
    said = result.stderr.splitlines()[-1]
    assert "InvalidInput: store: got" in said and "no regular file" in said


@pytest.mark.parametrize("read", [stoss.Grid.from_toml, stoss.ModalBody.read])
def test_a_grid_or_a_body_that_is_a_fifo_is_refused(read, tmp_path):
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(stoss.InvalidInput, match="which is no regular file"):
        read(tmp_path / "pipe")
