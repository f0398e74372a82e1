"""What a file holds stays until what replaces it is on the disk, whatever goes wrong."""

import os
import resource
import signal
import stat
import subprocess
import time

import pytest
from conftest import rows, wait_for_rows

NU = "--body disk --poisson 0.33 --speed 0.1"
# Every way to write a file.
WAYS = [
    *[f"{job} --format {form} -o" for form in ("table", "csv", "json") for job in (
        "modes --body disk --poisson 0.33 --cutoff 3", f"impact {NU} --cutoff 12.5",
        f"bounce {NU} --cutoff 4 --flight-time 30 --count 2",
        f"restitution {NU} --tolerance 0.1", f"distribution {NU} --spectrum 2,0,energy=0.1 --samples 2 --error 0.1",
        "quasistatic --body disk --poisson 0.33 --speed 0.01", "quasistatic --poisson 0.33 --compression 0.01",
    )],
    f"impact {NU} --cutoff 12.5 --trajectory", f"restitution {NU} --tolerance 0.1 --resume",
    f"distribution {NU} --spectrum 2,0,energy=0.1 --samples 2 --error 0.1 --resume",
    "table --body disk --poisson 0.33 --speed 0.01:0.1 --error 0.1 -o",
]  # fmt: skip
# Its first row takes seconds.
SLOW = "restitution --body disk --poisson -0.95 --speed 1,0.9 --tolerance 1e-4"


def fails(result, *words):
    """Exit status 4 and one line."""
    assert (result.returncode, result.stdout) == (4, ""), result
    (line,) = result.stderr.splitlines()
    assert line.startswith("stoss: error: output: cannot write ") and all(str(word) in line for word in words), line


def full():
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))


@pytest.mark.parametrize("way", WAYS)
def test_full_disk(stoss, tmp_path, way):
    path = tmp_path / "x"
    fails(stoss.run(way, str(path), preexec_fn=full), path, "File too large")
    assert os.listdir(tmp_path) == []
    if "--resume" in way:
        return  # a file of rows to be continued is test_resume's
    path.write_text("precious")
    fails(stoss.run(way, str(path), preexec_fn=full), path, "File too large")
    assert path.read_text() == "precious" and os.listdir(tmp_path) == ["x"]


@pytest.mark.parametrize("way", WAYS)
def test_replaced_as_a_whole(stoss, tmp_path, way):
    """Behind a link, with the rights that the file had."""
    (tmp_path / "link").symlink_to("x")
    assert stoss.run(way, "link", cwd=tmp_path).returncode == 0  # makes what the link names
    text = (tmp_path / "x").read_text()
    if "--resume" not in way:
        (tmp_path / "x").write_text(10 * text + "behind")
    (tmp_path / "x").chmod(0o640)
    assert stoss.run(way, "link", cwd=tmp_path).returncode == 0
    assert (tmp_path / "link").is_symlink() and sorted(os.listdir(tmp_path)) == ["link", "x"]
    assert (tmp_path / "x").read_text() == text and stat.S_IMODE((tmp_path / "x").stat().st_mode) == 0o640


@pytest.mark.parametrize("job", [
    f"bounce {NU} --flight-time 1 --mode 2,99,energy=0.1", f"restitution {NU} --mode 2,0,energy=-1",
    f"distribution {NU} --spectrum 2,0,energy=-1", f"impact {NU} --mode 2,99,energy=0.1",
    f"impact {NU} --nodes 1", "modes --body disk --poisson 7", "quasistatic --poisson 7 --speed 0.1",
    f"restitution {NU} --tolerance 7", "restitution --body disk --poisson 0.33,7 --speed 0.1", f"restitution {NU},7",
    "table --body disk --poisson 0.33 --speed 0.01:0.1 --error 7",
])  # fmt: skip
@pytest.mark.parametrize("there", [True, False])
def test_bad_input(stoss, tmp_path, job, there):
    path = tmp_path / "x"
    if there:
        path.write_text("precious")
    for form in ("c", "json") if job.startswith("table") else ("table", "csv", "json"):
        for more in ("", f"-o {path}"):
            result = stoss.run(job, f"--format {form}", more)
            assert (result.returncode, result.stdout) == (3, "") and result.stderr.count("\n") == 1, result
    assert os.listdir(tmp_path) == (["x"] if there else [])
    assert not there or path.read_text() == "precious"


@pytest.mark.parametrize("way", [WAYS[0], *[way for way in WAYS if "csv" in way or "--format" not in way]])
def test_what_is_no_regular_file_is_refused(stoss, tmp_path, way):
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "link").symlink_to("pipe")
    places = [tmp_path / "pipe", tmp_path / "link", *([] if "--trajectory" in way else ["/dev/stdout"])]
    if os.geteuid() == 0:  # one of our own, which may be harmed
        places.append(tmp_path / "null")
        os.mknod(places[-1], stat.S_IFCHR | 0o666, os.makedev(1, 3))
    for place in places:
        fails(stoss.run(way, str(place)), f"'{place}'", "not a regular file", "leave the option out")
    fails(stoss.run(way, str(tmp_path)), f"'{tmp_path}'", "directory")
    assert not any(path.is_file() for path in tmp_path.iterdir()) and (tmp_path / "link").is_symlink()


@pytest.mark.parametrize("name", ["x", "/dev/stdout", "/dev/stderr"])
def test_a_file_that_is_a_standard_stream_already(stoss, tmp_path, name):
    with open(tmp_path / "x", "w") as stream:
        error = stream if name == "/dev/stderr" else subprocess.PIPE
        out = subprocess.PIPE if name == "/dev/stderr" else stream
        words = [stoss.path, *WAYS[0].split(), name]
        done = subprocess.run(words, cwd=tmp_path, stdout=out, stderr=error, text=True, timeout=60)
    assert done.returncode == 4
    assert f"'{name}': it is std" in (done.stderr or (tmp_path / "x").read_text())


def wait_until_locked(process, path):
    """Until the process writes the file, of which it has no row yet."""
    while not any(f":{path.stat().st_ino} " in line for line in open("/proc/locks")) if path.exists() else True:
        assert process.poll() is None
        time.sleep(0.01)


@pytest.mark.skipif(not os.path.exists("/proc/locks"), reason="needs the list of locks")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
@pytest.mark.parametrize("way", ["--format csv -o", "--format json -o", "-o", "--resume"])
def test_stopped_before_the_first_row(stoss, tmp_path, way, number):
    path = tmp_path / "x"
    for before in ("", "precious"):
        if before and way == "--resume":
            continue
        path.write_text(before)
        process = stoss.start(f"{SLOW} {way} {path}", stderr=subprocess.PIPE)
        wait_until_locked(process, path)
        fails(stoss.run(WAYS[0], str(path)), f"process {process.pid} (stoss restitution ", "is writing it")
        process.send_signal(number)
        _, error = process.communicate(timeout=60)
        if number == signal.SIGKILL:
            assert process.returncode == -number
        else:
            assert (process.returncode, error) == (128 + number, "stoss: error: interrupted\n")
        assert path.read_text() == before and os.listdir(tmp_path) == ["x"]


@pytest.mark.skipif(not os.path.exists("/proc/locks"), reason="needs the list of locks")
@pytest.mark.parametrize("there", [True, False])
def test_replaced_rows_are_locked(stoss, tmp_path, there):
    """From before the first row to the last."""
    path = tmp_path / "x.csv"
    if there:
        path.write_text("precious\n")
    long = "restitution --body disk --poisson 0.33 --speed log:1e-3:0.3:100000 --threads 1 --format csv -o"
    process = stoss.start(f"{long} {path}", stderr=subprocess.DEVNULL)
    wait_until_locked(process, path)
    fails(stoss.run(WAYS[0], str(path)), "is writing it")
    while "precious" in path.read_text():
        time.sleep(0.02)
    wait_for_rows(process, path, 2)
    fails(stoss.run(WAYS[0], str(path)), "is writing it")
    process.send_signal(signal.SIGTERM)
    assert process.wait(timeout=30) == 143
    assert len(rows(path.read_text())) >= 2 and os.listdir(tmp_path) == ["x.csv"]


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
@pytest.mark.parametrize("way", [WAYS[0], WAYS[8], "table --body disk --poisson 0.33 --speed 1e-4:0.3 -o"])
def test_folder_that_is_read_only(stoss, tmp_path, way):
    folder = tmp_path / "folder"
    folder.mkdir()
    folder.chmod(0o500)
    fails(stoss.run(way, str(folder / "x")), "Permission denied")
    folder.chmod(0o700)
    assert os.listdir(folder) == []


@pytest.mark.parametrize("way", WAYS)
def test_folder_that_is_not_there(stoss, tmp_path, way):
    fails(stoss.run(way, f"{tmp_path}/none/x"), "No such file")
    fails(stoss.run(way, f"{tmp_path}/none/"), "No such file")
    assert os.listdir(tmp_path) == []
