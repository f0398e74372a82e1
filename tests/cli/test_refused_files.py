"""Files that cannot be used: of other jobs, no files at all, and those that another process writes."""

import os
import signal
import subprocess

import pytest
from conftest import SMALL, resume, rows, wait_for_rows

DISK = '{"kind":"disk","poisson":%s}'
INTERRUPTED = "# interrupted: the rows above are complete, later ones are missing\n"


@pytest.mark.parametrize(
    "job, name, got, allowed",
    [
        (SMALL.replace("0.33", "0.34"), "first", DISK % '"0.34,-0.2"', DISK % '"0.33,-0.2"'),
        (SMALL.replace("0.1,0.2", "0.1,0.2,0.3"), "speed", "0.1,0.2,0.3", "0.1,0.2"),
        (SMALL + " --tolerance 1e-2", "tolerance", "0.01", "0.001"),
        (
            "restitution --body disk --poisson 0.33 --young 1e9 --density 1e3 --radius 1 --speed 100",
            "first",
            '{"kind":"disk","radius":1.0,"material":{"young":1000000000.0,"poisson":0.33,"density":1000.0},"plane":"stress"}',
            DISK % '"0.33,-0.2"',
        ),
    ],
)
@pytest.mark.parametrize("part", [1, 0.9])
def test_other_inputs_are_refused(stoss, tmp_path, small, job, name, got, allowed, part):
    path = tmp_path / "curve.csv"
    text = small[: int(part * len(small))]
    path.write_text(text)
    result = resume(stoss, path, job)
    assert (result.returncode, result.stdout) == (3, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {name}: got {got}, allowed {allowed} as in '{path}'")
    assert path.read_text() == text


def changed(text, old, new):
    assert old in text
    return text.replace(old, new, 1)


@pytest.mark.parametrize(
    "change, told",
    [
        (lambda text: "precious\n", "precious"),
        (lambda text: "precious", "precious"),
        (lambda text: "\0\1\2\377" * 100 + "\n", "\\x00\\x01\\x02\\xff"),
        (lambda text: '{\n  "schema": "stoss/restitution/2"\n', "{"),
        (lambda text: changed(text, ": restitution\n", ": modes\n"), "allowed modes"),
        (lambda text: changed(text, "# stoss ", "# stoss 9"), "version of stoss"),
        (lambda text: changed(text, "# tolerance: 0.001\n", ""), "tolerance: got 0.001, allowed none"),
        (lambda text: changed(text, "# against", "# colour: red\n# against"), "colour: got none, allowed red"),
        (lambda text: changed(text, "# against", "# a\0b: 1\n# against"), "a\\x00b: got none, allowed 1"),
        (lambda text: changed(text, "# against", f"# {'a' * 9999}: 1\n# against"), "a... (9999 bytes): got none"),
        (lambda text: changed(text, "# against: ", "# against, "), "# against, wall"),
        (lambda text: changed(text, "max_force[piRE]", "max_force[N]"), "poisson,speed"),
        (lambda text: changed(text, "\n0.33,0.1,", "\n0.33,0.10000001,"), "row 1 of the file, allowed 0.33,0.1"),
        (lambda text: changed(text, "\n-0.2,0.1,", "\n-0.25,0.1,"), "row 3 of the file"),
        (lambda text: changed(text, ",true\n", "\n"), "as line 10"),
        (lambda text: changed(text, ",true\n", ",maybe\n"), "as line 10"),
        (lambda text: changed(text, ",true\n", ",true\n" + INTERRUPTED), "as line 11"),
        (lambda text: changed(text, ",true\n", ",true\n\n"), "as line 11"),
        (lambda text: text + text.splitlines(True)[-1], "got a row 5"),
    ],
)
def test_damaged_or_foreign_file_is_refused_and_left_alone(stoss, tmp_path, small, change, told):
    path = tmp_path / "curve.csv"
    text = change(small).encode("latin-1")
    path.write_bytes(text)
    result = resume(stoss, path)
    assert (result.returncode, result.stdout) == (3, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith("stoss: error: ") and told in line and "allowed" in line
    assert path.read_bytes() == text


def test_unusable_paths(stoss, tmp_path):
    (tmp_path / "loop").symlink_to("loop")
    for path in (tmp_path, tmp_path / "no/such/folder/x.csv", tmp_path / "loop", "/dev/full", "/dev/null"):
        result = resume(stoss, path)
        assert (result.returncode, result.stdout) == (4, ""), path
        (line,) = result.stderr.splitlines()
        assert "cannot" in line and str(path) in line


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read and write everything")
@pytest.mark.parametrize("mode", [0o200, 0o400])
def test_unreadable_or_unwritable_file(stoss, tmp_path, small, mode):
    path = tmp_path / "curve.csv"
    path.write_text(small[:-3])
    path.chmod(mode)
    result = resume(stoss, path)
    assert result.returncode == 4
    assert "Permission denied" in result.stderr
    path.chmod(0o600)
    assert path.read_text() == small[:-3]


@pytest.mark.parametrize(
    "more, told",
    [
        ("--format json", "got --format json, allowed csv"),
        ("--format table", "got --format table, allowed csv"),
        ("-o other.csv", "got another file as --output"),
        ("-o -", "got another file as --output"),
    ],
)
def test_other_output_is_refused(stoss, tmp_path, more, told):
    result = resume(stoss, tmp_path / "x.csv", f"{SMALL} {more}")
    assert (result.returncode, result.stdout) == (3, "")
    assert result.stderr.startswith(f"stoss: error: resume: {told}")
    assert not (tmp_path / "x.csv").exists()


def test_stdout_cannot_be_resumed(stoss):
    result = resume(stoss, "-")
    assert result.returncode == 3
    assert "allowed the name of a file" in result.stderr


@pytest.mark.parametrize("part", [1, 0.9, 0.1])
def test_line_ends_of_another_system_are_named(stoss, tmp_path, small, part):
    path = tmp_path / "curve.csv"
    text = small[: int(part * len(small))].replace("\n", "\r\n").encode()
    path.write_bytes(text)
    result = resume(stoss, path)
    assert result.returncode == 3
    (line,) = result.stderr.splitlines()
    assert "got line ends CRLF" in line and str(path) in line and "allowed LF" in line
    assert path.read_bytes() == text


def test_bad_input_leaves_the_file_alone(stoss, tmp_path, small):
    path = tmp_path / "curve.csv"
    path.write_text(small[:-3])
    for bad in ("--tolerance 0", "--threads -1"):
        assert resume(stoss, path, f"{SMALL} {bad}").returncode == 3
        assert path.read_text() == small[:-3]


JOB = "restitution --body disk --poisson 0.33 --speed log:1e-3:0.1:40 --threads 1"
LONG = "restitution --body disk --poisson 0.33 --speed log:1e-3:0.3:100000 --threads 1"


@pytest.fixture(scope="module")
def whole(stoss):
    return rows(stoss.run(JOB, "--format csv").stdout)


@pytest.mark.parametrize("trial", range(3))
def test_two_that_begin_at_once(stoss, tmp_path, whole, trial):
    path = tmp_path / "curve.csv"
    both = [stoss.start(f"{JOB} --resume {path}", stderr=subprocess.PIPE) for _ in range(2)]
    texts = [process.communicate(timeout=100)[1] for process in both]
    assert sorted(process.returncode for process in both) == [0, 4]
    first, second = sorted(both, key=lambda process: process.returncode)
    (line,) = texts[both.index(second)].splitlines()
    assert f"cannot write '{path}': process {first.pid} (stoss restitution " in line
    assert rows(path.read_text()) == whole


@pytest.fixture
def writer(stoss, tmp_path):
    """A process at work on curve.csv in the folder tmp_path."""
    path = tmp_path / "curve.csv"
    process = stoss.start(f"{LONG} --format csv -o {path}", stderr=subprocess.DEVNULL)
    wait_for_rows(process, path, 2)
    yield process
    process.kill()
    process.wait()


@pytest.mark.parametrize("how", ["-o", "--resume", "--trajectory"])
@pytest.mark.parametrize("name", ["curve.csv", "link", "hard"])
def test_a_file_at_work_is_left_alone(stoss, tmp_path, writer, how, name):
    (tmp_path / "link").symlink_to("curve.csv")
    os.link(tmp_path / "curve.csv", tmp_path / "hard")
    before = (tmp_path / "curve.csv").read_text()
    job = "impact --body disk --poisson 0.33 --speed 0.1 --trajectory" if how == "--trajectory" else f"{LONG} {how}"
    result = stoss.run(job, str(tmp_path / name))
    assert (result.returncode, result.stdout) == (4, "")
    (line,) = result.stderr.splitlines()
    assert f"process {writer.pid} (stoss " in line and "is writing it" in line
    writer.send_signal(signal.SIGINT)
    assert writer.wait(timeout=30) == 130
    assert (tmp_path / "curve.csv").read_text().startswith(before)


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGINT])
def test_a_lock_ends_with_its_process(stoss, tmp_path, writer, number):
    writer.send_signal(number)
    writer.wait(timeout=30)
    path = tmp_path / "curve.csv"
    again = stoss.start(f"{LONG} --resume {path}", stderr=subprocess.PIPE)
    wait_for_rows(again, path, len(rows(path.read_text())) + 1)
    again.send_signal(signal.SIGINT)
    assert again.wait(timeout=30) == 130


def test_trajectory_and_output_in_one_file(stoss, tmp_path):
    path = tmp_path / "x"
    path.write_text("precious")
    os.link(path, tmp_path / "hard")
    (tmp_path / "loose").symlink_to("none")
    result = stoss.run("impact --body disk --poisson 0.33 --speed 0.1 -o loose --trajectory none", cwd=tmp_path)
    assert result.returncode == 3 and not (tmp_path / "none").exists()
    for other in (path, tmp_path / "hard", "/proc/self/cwd/x"):
        result = stoss.run(f"impact --body disk --poisson 0.33 --speed 0.1 -o {path} --trajectory {other}", cwd=tmp_path)
        assert result.returncode == 3
        assert path.read_text() == "precious"
    with open(path, "a") as stdout:
        words = "impact --body disk --poisson 0.33 --speed 0.1 --trajectory /dev/stdout".split()
        assert subprocess.run([stoss.path, *words], stdout=stdout, stderr=subprocess.DEVNULL).returncode == 3
    assert path.read_text() == "precious"


def test_a_body_file_that_is_a_fifo_is_refused_and_stdin_is_read(stoss, tmp_path):
    os.mkfifo(tmp_path / "pipe")
    for option in (f"--body @{tmp_path}/pipe", f"--body sphere --poisson 0.3 --against @{tmp_path}/pipe"):
        done = stoss.run("restitution --speed 0.1", option)
        assert done.returncode == 3 and "which is no regular file" in done.stderr, done.stderr
    given = subprocess.run([stoss.path, "restitution", "--speed", "0.1", "--body", "@/dev/stdin"], input="[1]", text=True, capture_output=True)
    assert given.returncode == 3 and "no regular file" not in given.stderr, given.stderr
