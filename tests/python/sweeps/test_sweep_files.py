"""Files of sweeps: a FIFO among them is refused, and a merge where its file cannot be written."""

# ruff: noqa: F811 (a fixture is an argument that has the name of what is imported)
import functools
import os
import resource
import stat
import subprocess
import sys

import pytest
import stoss
from sweep_command import command  # noqa: F401 (a fixture)

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


# ruff: noqa: F811 (a fixture is an argument that has the name of what is imported)


def test_merge_where_nothing_can_be_written(command):
    pytest.importorskip("netCDF4")
    stoss.sweep(command.folder / "grid.toml", store=command.folder / "store")
    for target in ("none/all.nc", "store", "/proc/all.nc"):
        code, error = command.run("merge", "store", "-o", target)
        assert code == 4 and error.count("\n") == 1, error


def test_merge_to_what_is_no_file(command):
    """It would be replaced by one."""
    pytest.importorskip("netCDF4")
    stoss.sweep(command.folder / "grid.toml", store=command.folder / "store")
    os.mkfifo(command.folder / "pipe")
    (command.folder / "link").symlink_to("pipe")
    for target in ("pipe", "link", "/dev/stdout"):
        code, error = command.run("merge", "store", "-o", target)
        assert code == 4
        assert error == f"stoss: error: output: cannot read or write '{target}': it is not a regular file\n"
    assert stat.S_ISFIFO((command.folder / "link").stat().st_mode) and (command.folder / "link").is_symlink()


@pytest.mark.parametrize("before", ["", "precious"])
@pytest.mark.parametrize("size", [0, 2000, 20000])
def test_merge_on_a_full_disk(command, before, size):
    """HDF5 does not survive a write that fails."""
    pytest.importorskip("netCDF4")
    stoss.sweep(command.folder / "grid.toml", store=command.folder / "store")
    if before:
        (command.folder / "all.nc").write_text(before)
    listing = sorted(os.listdir(command.folder))
    full = functools.partial(resource.setrlimit, resource.RLIMIT_FSIZE, (size, size))
    process = command.start("merge", "store", "-o", "all.nc", preexec_fn=full)
    out, error = process.communicate(timeout=60)
    assert (process.returncode, out) == (4, "")
    assert error == "stoss: error: output: cannot read or write 'all.nc': File too large\n"
    assert sorted(os.listdir(command.folder)) == listing
    assert not before or (command.folder / "all.nc").read_text() == before
