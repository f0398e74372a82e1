"""A file, or its folder, that goes while it is written: an end with one line, and no row lost."""

import os
import resource
import shutil
import signal
import subprocess
import time

import pytest
from conftest import rows, wait_for_rows
from test_kept_files import NU, WAYS, fails, wait_until_locked

pytestmark = pytest.mark.skipif(os.name == "nt", reason="Windows keeps what is open")

LONG = "restitution --body disk --poisson 0.33 --speed log:1e-3:0.3:100000 --threads 1"
MARK = "# interrupted: the rows above are complete, later ones are missing\n"


def in_removed_folder(folder):
    """Where the process begins; it may use 20 s of processor time."""

    def prepare():
        resource.setrlimit(resource.RLIMIT_CPU, (20, 20))
        folder.mkdir()
        os.chdir(folder)
        folder.rmdir()

    return prepare


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", ["x", "./x"])
def test_removed_folder(stoss, tmp_path, way, name):
    result = stoss.run(way, name, preexec_fn=in_removed_folder(tmp_path / "gone"))
    fails(result, f"'{name}'", "its folder has been removed")
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize("way", ["--format csv -o", "--resume"])
@pytest.mark.parametrize("change", ["removed", "replaced", "truncated", "cut", "appended", "folder", "folder made anew"])
def test_changed_under_a_run(stoss, tmp_path, way, change):
    folder = tmp_path / "folder"
    folder.mkdir()
    path = folder / "curve.csv"
    process = stoss.start(f"{LONG} {way} {path}", stderr=subprocess.PIPE)
    wait_for_rows(process, path, 3)
    process.send_signal(signal.SIGSTOP)
    while " (stoss) T " not in open(f"/proc/{process.pid}/stat").read():
        time.sleep(0.01)
    before = path.read_text()
    if change == "removed":
        path.unlink()
    elif change == "replaced":
        (folder / "other").write_text("precious")
        os.replace(folder / "other", path)
    elif change in ("truncated", "cut"):
        os.truncate(path, 0 if change == "truncated" else len(before) - 5)
    elif change == "appended":
        with open(path, "a") as stream:
            stream.write("precious\n")
    else:
        shutil.rmtree(folder)
        if change == "folder made anew":
            folder.mkdir()
    process.send_signal(signal.SIGCONT)
    output, error = process.communicate(timeout=60)
    assert process.returncode == 4
    (line,) = error.splitlines()
    assert line.startswith(f"stoss: error: output: cannot write '{path}': another process has "), line
    kept = folder / "curve.csv.kept"
    if change in ("removed", "replaced", "folder made anew"):
        assert f"is in '{kept}'" in line
        found = kept.read_text().removesuffix(MARK)
        assert found.startswith(before) and found.endswith("\n") and len(rows(found)) > len(rows(before))
        assert not path.exists() or path.read_text() == "precious"
        again = stoss.start(f"{LONG} --resume {kept}", stderr=subprocess.PIPE)  # it goes on from there
        wait_for_rows(again, kept, len(rows(found)) + 1)
        again.kill()
        again.wait()
    elif change == "folder":
        assert "is lost" in line and os.listdir(tmp_path) == []
    else:
        assert "has changed it" in line and os.listdir(folder) == ["curve.csv"]
        now = {"truncated": "", "cut": before[:-5], "appended": before + "precious\n"}[change]
        assert path.read_text() == now


def test_changed_between_two_calls(stoss, tmp_path):
    """A change at any moment of a run is neither written over nor missed, also not just before a row is written."""
    for trial in range(25):
        path = tmp_path / f"{trial}.csv"
        process = stoss.start(f"{LONG} --format csv -o {path}", stderr=subprocess.PIPE)
        wait_for_rows(process, path, 1)
        process.send_signal(signal.SIGSTOP)  # most often as a call of the system ends
        while " (stoss) T " not in open(f"/proc/{process.pid}/stat").read():
            time.sleep(0.001)
        with open(path, "a") as stream:
            stream.write("precious\n")
        process.send_signal(signal.SIGCONT)
        error = process.communicate(timeout=20)[1]
        assert process.returncode == 4 and "has changed it" in error
        assert path.read_text().endswith("\nprecious\n")


def test_no_kept_file_is_overwritten(stoss, tmp_path):
    path = tmp_path / "x.csv"
    (tmp_path / "x.csv.kept").write_text("precious")
    process = stoss.start(f"{LONG} --resume {path}", stderr=subprocess.PIPE)
    wait_for_rows(process, path, 1)
    path.unlink()
    assert process.wait(timeout=60) == 4 and "x.csv.kept-2'" in process.stderr.read()
    assert (tmp_path / "x.csv.kept").read_text() == "precious" and rows((tmp_path / "x.csv.kept-2").read_text())


@pytest.mark.skipif(not os.path.exists("/proc/locks"), reason="needs the list of locks")
def test_changed_before_the_first_new_row(stoss, tmp_path):
    """What another has added to the rows of an earlier run is not cut off."""
    path = tmp_path / "curve.csv"
    slow = "restitution --body disk --poisson -0.95 --speed 0.1,1 --tolerance 1e-4"  # its second row takes seconds
    process = stoss.start(f"{slow} --resume {path}")
    wait_for_rows(process, path, 1)
    process.kill()
    process.wait()
    process = stoss.start(f"{slow} --resume {path}", stderr=subprocess.PIPE)
    wait_until_locked(process, path)
    time.sleep(0.5)
    with open(path, "a") as stream:
        stream.write("precious\n")
    error = process.communicate(timeout=100)[1].splitlines()[-1]
    assert process.returncode == 4 and "has changed it" in error
    assert path.read_text().endswith("\nprecious\n") and len(rows(path.read_text())) == 2


# Of 45 MB, of which 16 are kept in memory.
TRAJECTORY = f"impact {NU} --cutoff 2 --nodes 16 --step 2e-5 --trajectory"


@pytest.mark.parametrize("size", [2000, 20_000_000])
def test_full_disk_keeps_the_old_trajectory(stoss, tmp_path, size):
    """Rows of it were written before the disk was full."""
    path = tmp_path / "t.csv"

    def full():
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

    for old in (None, "precious"):
        if old:
            path.write_text(old)
        fails(stoss.run(TRAJECTORY, str(path), preexec_fn=full), "t.csv", "File too large")
        assert os.listdir(tmp_path) == (["t.csv"] if old else []) and (not old or path.read_text() == old)


def test_disk_of_a_page(stoss, tmp_path):
    if os.geteuid() != 0 or subprocess.run(["mount", "-t", "tmpfs", "-o", "size=2m", "none", tmp_path]).returncode:
        pytest.skip("needs the right to mount")
    try:
        path = tmp_path / "t.csv"
        path.write_text("precious")
        fails(stoss.run(TRAJECTORY, str(path)), "No space left")
        assert path.read_text() == "precious" and os.listdir(tmp_path) == ["t.csv"]
    finally:
        subprocess.run(["umount", tmp_path], check=True)


@pytest.mark.parametrize("one, other", [("./same.csv", "same.csv"), ("same.csv", "./same.csv"), ("same.csv", "{}/same.csv"),
                                        ("a/../same.csv", "same.csv"), ("link/same.csv", "a/same.csv"),
                                        ("loose", "./same.csv"), ("loose", "loose"), ("a/up/same.csv", "same.csv")])  # fmt: skip
def test_two_outputs_in_one_file_that_is_not_there(stoss, tmp_path, one, other):
    (tmp_path / "a").mkdir()
    (tmp_path / "link").symlink_to("a")
    (tmp_path / "a" / "up").symlink_to("..")
    (tmp_path / "loose").symlink_to("same.csv")
    before = sorted(os.listdir(tmp_path))
    result = stoss.run(f"impact {NU} --trajectory", one.format(tmp_path), "-o", other.format(tmp_path), cwd=tmp_path)
    assert result.returncode == 3 and "one would overwrite the other" in result.stderr
    assert sorted(os.listdir(tmp_path)) == before
