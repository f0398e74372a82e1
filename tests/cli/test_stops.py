"""Runs that are stopped, or whose file another process takes, changes or removes: one line, and no row lost."""

import json
import os
import re
import shutil
import signal
import subprocess
import time

import pytest
from conftest import rows, wait_for_rows, wait_until_caught
from test_files import WAYS, fails

pytestmark = pytest.mark.numbers

NU = "--body disk --poisson 0.33"
BALL = "--body sphere --poisson 0.3"
LONG = f"restitution {NU} --speed log:1e-3:0.3:20000 --threads 1"
SLOW = "restitution --body disk --poisson -0.95 --speed 1,0.9 --tolerance 1e-4"  # its first row takes seconds
MARK = "# interrupted: the rows above are complete, later ones are missing\n"
needs_locks = pytest.mark.skipif(not os.path.exists("/proc/locks"), reason="needs the list of locks")
# Of each subcommand of rows: a run of minutes.
RUNS = {
    "restitution": LONG,
    "oblique": f"oblique {BALL} --friction 0.2 --speed log:0.01:0.1:400 --angle lin:-80:80:100 --threads 1",
    "distribution": f"distribution {BALL} --speed 0.01 --temperature 0.01 --samples 100000 --error 1e-4 --threads 1",
    "bounce": f"bounce {BALL} --speed 0.05 --cutoff 12 --count 1000000 --flight-time 30",
    "quasistatic": f"quasistatic {NU} --speed log:1e-9:0.1:1000000",
}


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
@pytest.mark.parametrize("command", RUNS)
def test_stopped_runs_keep_their_rows(stoss, tmp_path, command, number):
    path = tmp_path / "x"
    process = stoss.start(f"{RUNS[command]} --format csv -o {path} --quiet", stderr=subprocess.PIPE)
    wait_for_rows(process, path, 5)
    process.send_signal(number)
    _, error = process.communicate(timeout=60)
    text = path.read_text()
    if number == signal.SIGKILL:
        assert process.returncode == -number and text.endswith("\n")
    else:
        assert (process.returncode, error) == (128 + number, "stoss: error: interrupted\n") and text.endswith(MARK)
    table = rows(text)
    assert len(table) >= 5 and all(len(row) == len(table[0]) and None not in row.values() for row in table)
    assert os.listdir(tmp_path) == ["x"]


def test_an_interrupted_run_in_json_and_its_trajectory(stoss, tmp_path):
    """They appear at the end, with what rows there are."""
    command = stoss.start(f"{LONG} --format json -o {tmp_path}/x", stderr=subprocess.PIPE)
    wait_until_caught(command, signal.SIGINT)
    time.sleep(1.5)
    command.send_signal(signal.SIGINT)
    assert command.wait(timeout=30) == 130
    document = json.loads((tmp_path / "x").read_text())
    speeds = [record["speed"] for record in document["records"]]
    assert document["complete"] is False and speeds == sorted(speeds) != []
    (tmp_path / "x").unlink()
    command = stoss.start(f"impact {NU} --speed 0.1 --step 5e-6 --nodes 16 --cutoff 2 --trajectory {tmp_path}/t.csv", stdout=subprocess.PIPE)
    while not os.listdir(tmp_path):
        assert command.poll() is None
        time.sleep(0.05)
    command.send_signal(signal.SIGINT)
    assert command.wait(timeout=60) == 130 and os.listdir(tmp_path) == ["t.csv"]
    assert (tmp_path / "t.csv").read_text().endswith(MARK) and rows((tmp_path / "t.csv").read_text())


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted_tables_leave_nothing(stoss, tmp_path, number):
    path = tmp_path / "table.h"
    path.write_text("old\n")
    process = stoss.start(f"table {BALL} --speed 1e-4:0.5 --error 1e-7 -o {path}", stderr=subprocess.PIPE)
    wait_until_caught(process, number)
    process.send_signal(number)
    _, error = process.communicate(timeout=60)
    assert process.returncode == 128 + number and "interrupted" in error
    assert path.read_text() == "old\n" and os.listdir(tmp_path) == ["table.h"]


@pytest.mark.parametrize("ignored", [False, True])
def test_a_closed_pipe_ends_it_quietly(stoss, ignored):
    words = [stoss.path, *f"modes {NU} --cutoff 200".split()]
    how = signal.SIG_IGN if ignored else signal.SIG_DFL
    command = subprocess.Popen(words, preexec_fn=lambda: signal.signal(signal.SIGPIPE, how), restore_signals=False,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)  # fmt: skip
    assert command.stdout.readline().split()[0] == b"order"
    command.stdout.close()
    assert command.stderr.read() == b"" and command.wait(timeout=60) in ((4,) if ignored else (-signal.SIGPIPE, 4))


def wait_until_locked(process, path):
    """Until the process writes the file, of which it has no row yet."""
    while not any(f":{path.stat().st_ino} " in line for line in open("/proc/locks")) if path.exists() else True:
        assert process.poll() is None
        time.sleep(0.01)


@needs_locks
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL])
@pytest.mark.parametrize("way", ["--format csv -o", "--format json -o", "--resume"])
def test_stopped_before_the_first_row(stoss, tmp_path, way, number):
    path = tmp_path / "x"
    before = "" if way == "--resume" else "precious"
    path.write_text(before)
    process = stoss.start(f"{SLOW} {way} {path}", stderr=subprocess.PIPE)
    wait_until_locked(process, path)
    fails(stoss.run(WAYS[0], str(path)), f"process {process.pid} (stoss restitution ", "is writing it")
    process.send_signal(number)
    _, error = process.communicate(timeout=60)
    expected = (-number, "") if number == signal.SIGKILL else (128 + number, "stoss: error: interrupted\n")
    assert (process.returncode, error) == expected
    assert path.read_text() == before and os.listdir(tmp_path) == ["x"]


@pytest.fixture
def writer(stoss, tmp_path):
    """A process at work on curve.csv in the folder tmp_path, which has replaced another file."""
    path = tmp_path / "curve.csv"
    path.write_text("precious\n")
    process = stoss.start(f"{LONG} --format csv -o {path}", stderr=subprocess.PIPE)
    while "precious" in path.read_text():
        time.sleep(0.02)
    wait_for_rows(process, path, 2)
    yield process
    process.kill()
    process.wait()


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGINT])
def test_a_file_at_work_is_left_alone_until_its_process_ends(stoss, tmp_path, writer, number):
    path = tmp_path / "curve.csv"
    (tmp_path / "link").symlink_to("curve.csv")
    os.link(path, tmp_path / "hard")
    before = path.read_text()
    for how in (f"{LONG} -o", f"{LONG} --resume", f"impact {NU} --speed 0.1 --trajectory"):
        for name in ("curve.csv", "link", "hard"):
            fails(stoss.run(how, str(tmp_path / name)), f"process {writer.pid} (stoss ", "is writing it")
    writer.send_signal(number)
    writer.wait(timeout=30)
    assert path.read_text().startswith(before)
    again = stoss.start(f"{LONG} --resume {path}", stderr=subprocess.PIPE)
    wait_for_rows(again, path, len(rows(path.read_text())) + 1)
    again.send_signal(signal.SIGINT)
    assert again.wait(timeout=30) == 130


def test_two_that_begin_at_once(stoss, tmp_path):
    path = tmp_path / "curve.csv"
    job = f"restitution {NU} --speed log:1e-3:0.1:40 --threads 1"
    both = [stoss.start(f"{job} --resume {path}", stderr=subprocess.PIPE) for _ in range(2)]
    texts = [process.communicate(timeout=100)[1] for process in both]
    assert sorted(process.returncode for process in both) == [0, 4]
    first, second = sorted(both, key=lambda process: process.returncode)
    assert f"cannot write '{path}': process {first.pid} (stoss restitution " in texts[both.index(second)]
    assert rows(path.read_text()) == rows(stoss.run(job, "--format csv").stdout)


def stop(process):
    """Most often as a call of the system ends."""
    process.send_signal(signal.SIGSTOP)
    while " (stoss) T " not in open(f"/proc/{process.pid}/stat").read():
        time.sleep(0.001)


@pytest.mark.parametrize("way, change", [(way, change) for change in ("removed", "replaced", "truncated", "cut", "appended", "folder", "made anew")
                                         for way in ("--format csv -o", "--resume")[change == "removed":]])  # fmt: skip
def test_changed_under_a_run(stoss, tmp_path, way, change):
    folder = tmp_path / "folder"
    folder.mkdir()
    path = folder / "curve.csv"
    process = stoss.start(f"{LONG} {way} {path}", stderr=subprocess.PIPE)
    wait_for_rows(process, path, 3)
    stop(process)
    before = path.read_text()
    if change == "removed":
        path.unlink()
        (folder / "curve.csv.kept").write_text("precious")
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
        if change == "made anew":
            folder.mkdir()
    process.send_signal(signal.SIGCONT)
    output, error = process.communicate(timeout=60)
    assert process.returncode == 4
    (line,) = error.splitlines()
    assert line.startswith(f"stoss: error: output: cannot write '{path}': another process has "), line
    kept = folder / ("curve.csv.kept-2" if change == "removed" else "curve.csv.kept")  # none is overwritten
    if change in ("removed", "replaced", "made anew"):
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
    """A change at any moment of a run is neither written over nor missed, also not just before or after a row."""
    for trial in range(10):
        path = tmp_path / f"{trial}.csv"
        process = stoss.start(f"{LONG} --format csv -o {path}", stderr=subprocess.PIPE)
        wait_for_rows(process, path, 1)
        stop(process)
        with open(path, "a") as stream:
            stream.write("precious\n")
        process.send_signal(signal.SIGCONT)
        error = process.communicate(timeout=20)[1]
        assert process.returncode == 4 and "has changed it" in error
        assert path.read_text().endswith("\nprecious\n")


@needs_locks
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
    assert process.returncode == 4 and re.search("has changed it", error)
    assert path.read_text().endswith("\nprecious\n") and len(rows(path.read_text())) == 2
