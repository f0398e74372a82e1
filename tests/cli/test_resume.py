"""stoss ... --resume: what was computed stays, what is missing is added, nothing else is touched."""

import os
import resource
import signal
import subprocess
import time

import pytest
from conftest import SMALL, resume, rows, wait_for_rows, wait_until_caught

pytestmark = pytest.mark.numbers

JOB = "restitution --body disk --poisson 0.33,-0.2 --speed log:1e-3:0.09:300"
INTERRUPTED = "# interrupted: the rows above are complete, later ones are missing\n"
DISK = '{"kind":"disk","poisson":%s}'
BALL = "--body sphere --poisson 0.3"
STEEL = "restitution --body disk --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01 --plane strain --speed 10,20"
# Jobs of two rows and more, and others that are not theirs, with the input that says so.
OTHERS = {
    SMALL: [(SMALL.replace("0.33", "0.34"), "first"), (SMALL.replace("0.1,0.2", "0.1,0.2,0.3"), "speed"),
            (SMALL + " --tolerance 1e-2", "tolerance"), (SMALL + " --absolute 1e-4", "absolute"),
            (SMALL + " --against disk,radius=2", "against"), (STEEL, "first")],
    STEEL: [(STEEL.replace("7850", "7851"), "first"), (STEEL.replace(" --plane strain", ""), "first"), (STEEL + " --against same", "against")],
    f"restitution {BALL} --speed 0.1,0.2 --tolerance 0.1 --against half-space,young=2 --rigid-body": [
        (f"restitution {BALL} --speed 0.1,0.2 --tolerance 0.1 --against half-space,young=2", "first"),
        (f"restitution {BALL} --speed 0.1,0.2 --tolerance 0.1 --against half-space,young=2,loss_time=1 --rigid-body", "against")],
    f"restitution {BALL} --speed 0.01,0.02 --mode 2,0,energy=0.1,phase=2": [
        (f"restitution {BALL} --speed 0.01,0.02", "vibration"), (f"restitution {BALL} --speed 0.01,0.02 --mode 2,0,energy=0.1", "vibration")],
    f"oblique {BALL} --friction 0.2 --speed 0.05 --angle 10,20 --tolerance 0.1": [
        (f"oblique {BALL} --friction 0.2 --speed 0.05 --tangential 0.01,0.02 --tolerance 0.1", "tangential"),
        (f"oblique {BALL} --friction 0.3 --speed 0.05 --angle 10,20 --tolerance 0.1", "friction")],
    f"distribution {BALL} --speed 0.01 --temperature 0.01 --samples 4 --seed 7": [
        (f"distribution {BALL} --speed 0.01 --temperature 0.01 --samples 4 --seed 8", "seed"),
        (f"distribution {BALL} --speed 0.01 --temperature 0.01 --samples 5 --seed 7", "samples"),
        (f"restitution {BALL} --speed 0.01", "kind of result")],
}  # fmt: skip


@pytest.mark.parametrize("job", OTHERS, ids=lambda job: job.split()[0])
def test_a_part_is_completed_and_another_job_is_refused(stoss, tmp_path, job):
    path = tmp_path / "curve.csv"
    assert resume(stoss, path, job).returncode == 0
    whole = path.read_text()
    assert rows(whole) == stoss.data(job)
    for part in (whole, whole[: whole.rindex("\n", 0, -1) + 5], whole[: whole.rindex("\n", 0, -1) + 1] + INTERRUPTED):
        path.write_text(part)
        for other, name in OTHERS[job]:
            result = resume(stoss, path, other)
            assert (result.returncode, result.stdout) == (3, "") and path.read_text() == part
            (line,) = result.stderr.splitlines()
            assert line.startswith(f"stoss: error: {name}") and ": got " in line and f" as in '{path}'" in line, line
        assert resume(stoss, path, job).returncode == 0 and path.read_text() == whole


def lines(text):
    return [line for line in text.splitlines() if not line.startswith("#")]


@pytest.fixture(scope="module")
def whole(stoss):
    return stoss.run(JOB, "--format csv").stdout


def test_interrupted_again_and_again(stoss, tmp_path, whole):
    path = tmp_path / "curve.csv"
    for count in (5, 30, 61, 90):
        command = stoss.start(f"{JOB} --threads 1 --resume {path}", stderr=subprocess.DEVNULL)
        wait_until_caught(command, signal.SIGINT)  # as many rows may be there from the run before
        wait_for_rows(command, path, count)
        command.send_signal(signal.SIGINT)
        assert command.wait(timeout=60) == 130
    assert resume(stoss, path, JOB).returncode == 0
    assert rows(path.read_text()) == rows(whole)


@pytest.mark.parametrize("begun", ["--resume", "--format csv -o"])
def test_a_row_that_was_changed_is_refused(stoss, tmp_path, begun):
    path = tmp_path / "curve.csv"
    job = "restitution --body disk --poisson 0.33 --speed 0.01,0.02,0.03"
    assert stoss.run(job, begun, str(path)).returncode == 0
    whole = path.read_text()
    row = rows(whole)[1]
    damaged = whole.replace(row["restitution"], "0.7")
    path.write_text(damaged)
    done = resume(stoss, path, job)
    assert done.returncode == 3 and "with the checksum of another row" in done.stderr, done.stderr
    assert path.read_text() == damaged
    path.write_text(whole[: whole.rindex("0.03")])  # cut within the last row
    assert resume(stoss, path, job).returncode == 0 and path.read_text() == whole


@pytest.mark.parametrize("job", [SMALL, "distribution --body disk --poisson 0.33 --speed 0.1 --spectrum 2,0,energy=0.1 --samples 5"])
def test_interrupted_before_the_first_row(stoss, tmp_path, job):
    """The file says so where its first row would be."""
    path = tmp_path / "curve.csv"
    whole = stoss.run(job, "--format csv").stdout
    header = "".join(line for line in whole.splitlines(True) if line.startswith("#"))
    path.write_text(header + INTERRUPTED)
    assert resume(stoss, path, job).returncode == 0
    assert rows(path.read_text()) == rows(whole) and INTERRUPTED not in path.read_text()
    damaged = header + INTERRUPTED + lines(whole)[0] + "\n"
    path.write_text(damaged)
    result = resume(stoss, path, job)
    assert result.returncode == 3 and "got '# interrupted" in result.stderr and path.read_text() == damaged


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_stopped_at_any_time(stoss, tmp_path, number):
    """From before the first row on, with every delay a little more."""
    path = tmp_path / "curve.csv"
    job = f"{SMALL} --tolerance 1e-4"
    whole = rows(stoss.run(job, "--format csv").stdout)
    for trial in range(12):
        command = stoss.start(f"{job} --threads 1 --resume {path}", stderr=subprocess.PIPE)
        time.sleep(0.004 * trial)
        command.send_signal(number)
        _, error = command.communicate(timeout=60)
        assert command.returncode in (0, 128 + number, -number), error
        if trial % 3 == 2:
            assert resume(stoss, path, job).returncode == 0
            assert rows(path.read_text()) == whole and os.listdir(tmp_path) == ["curve.csv"]
            path.unlink()


def test_every_place_of_the_end(stoss, tmp_path, small):
    path = tmp_path / "curve.csv"
    header = small.index("poisson,speed")
    first = small.index("\n", header) + 1
    cuts = [0, 1, 9, header - 30, header, header + 5, first - 1, first, first + 1, len(small) - 1, len(small)]
    cuts += range(first + 7, len(small), 97)
    for cut in cuts:
        path.write_text(small[:cut])
        result = resume(stoss, path)
        assert (result.returncode, result.stderr) == (0, ""), cut
        assert rows(path.read_text()) == rows(small), cut
        kept = small[: small.rindex("\n", 0, cut) + 1] if cut > first else ""
        assert path.read_text().startswith(kept)


def test_marks_of_earlier_rows_count(stoss, tmp_path):
    path = tmp_path / "curve.csv"
    job = "restitution --body disk --poisson 0.33 --speed 0.7"
    whole = stoss.run(job, "--format csv").stdout  # that of stdout has no checksums, and is continued without
    before = whole.replace(",true,false,", ",false,false,")  # not converged, does not stay
    path.write_text(before)
    result = resume(stoss, path, job, strain=True)
    assert result.returncode == 1
    assert "linear elasticity" in result.stderr
    assert "1 of 1 values" in result.stderr
    quiet = resume(stoss, path, f"{job} --quiet")
    assert (quiet.returncode, quiet.stderr) == (1, "")
    assert path.read_text() == before


@pytest.mark.parametrize("how", ["--resume", "-o"])
def test_full_disk_leaves_whole_rows(stoss, tmp_path, whole, how):
    path = tmp_path / "curve.csv"

    def little_space():
        resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))

    for begun in (False, True):
        if begun or how == "--resume":
            result = resume(stoss, path, JOB, preexec_fn=little_space)
        else:
            result = stoss.run(JOB, "--format csv -o", str(path), preexec_fn=little_space)
        assert result.returncode == 4
        (line,) = result.stderr.splitlines()
        assert "cannot write" in line and "curve.csv" in line
        kept = path.read_text()
        assert len(kept) <= 20000 and kept.endswith("\n")
        assert rows(kept) == rows(whole)[: len(rows(kept))] != []
    assert resume(stoss, path, JOB).returncode == 0
    assert rows(path.read_text()) == rows(whole)


def test_row_with_an_unknown_error_is_kept(stoss, tmp_path, small):
    path = tmp_path / "curve.csv"
    header, *table = lines(small)
    cells = table[0].split(",")
    cells[header.split(",").index("contact_time_error[R/c]")] = "unknown"
    known = small.replace(table[0], ",".join(cells))
    path.write_text(known[: known.index(table[1])])
    assert resume(stoss, path).returncode == 0
    assert path.read_text() == known


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


@pytest.mark.parametrize("more, told", [
    ("--format json", "got --format json, allowed csv"), ("--format table", "got --format table, allowed csv"),
    ("-o other.csv", "got another file as --output"), ("-o -", "got another file as --output"),
])  # fmt: skip
def test_other_output_is_refused(stoss, tmp_path, more, told):
    result = resume(stoss, tmp_path / "x.csv", f"{SMALL} {more}")
    assert (result.returncode, result.stdout) == (3, "")
    assert result.stderr.startswith(f"stoss: error: resume: {told}")
    assert not (tmp_path / "x.csv").exists()


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
