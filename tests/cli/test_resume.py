"""stoss restitution --resume: what was computed stays, what is missing is added, nothing else is touched."""

import os
import resource
import signal
import subprocess
import time

import pytest
from conftest import SMALL, resume, rows, wait_for_rows

pytestmark = pytest.mark.numbers

JOB = "restitution --body disk --poisson 0.33,-0.2 --speed log:1e-3:0.09:60"
INTERRUPTED = "# interrupted: the rows above are complete, later ones are missing\n"


def lines(text):
    return [line for line in text.splitlines() if not line.startswith("#")]


@pytest.fixture(scope="module")
def whole(stoss):
    return stoss.run(JOB, "--format csv").stdout


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
@pytest.mark.parametrize("count", [1, 70])
def test_interrupted_or_killed_and_resumed(stoss, tmp_path, whole, number, count):
    path = tmp_path / "curve.csv"
    command = stoss.start(f"{JOB} --threads 1 --format csv -o {path}", stderr=subprocess.DEVNULL)
    wait_for_rows(command, path, count)
    command.send_signal(number)
    assert command.wait(timeout=60) == (-number if number == signal.SIGKILL else 128 + number)
    before = path.read_text()
    assert before.endswith(INTERRUPTED) == (number != signal.SIGKILL)
    result = resume(stoss, path, JOB)
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")
    after = path.read_text()
    assert after.startswith(before.removesuffix(INTERRUPTED))
    assert len(lines(before)) < len(lines(after))
    assert INTERRUPTED not in after
    assert rows(after) == rows(whole)


def test_interrupted_again_and_again(stoss, tmp_path, whole):
    path = tmp_path / "curve.csv"
    for count in (5, 30, 61, 90):
        command = stoss.start(f"{JOB} --threads 1 --resume {path}", stderr=subprocess.DEVNULL)
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


@pytest.mark.parametrize("job", [JOB, "distribution --body disk --poisson 0.33 --speed 0.1 --spectrum 2,0,energy=0.1 --samples 5"])
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


def test_nothing_there_begins_the_file(stoss, tmp_path, small):
    path = tmp_path / "curve.csv"
    assert resume(stoss, path).returncode == 0
    assert rows(path.read_text()) == rows(small)


def test_complete_file_stays_as_it_is(stoss, tmp_path, small):
    path = tmp_path / "curve.csv"
    path.write_text(small)
    result = resume(stoss, path)
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")
    assert path.read_text() == small


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


def test_material(stoss, tmp_path):
    path = tmp_path / "curve.csv"
    job = "restitution --body disk --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01 --plane strain --speed 10,20,30"
    text = stoss.run(job, "--format csv").stdout
    path.write_text(text[:-200])
    assert resume(stoss, path, job).returncode == 0
    assert rows(path.read_text()) == rows(text)
    other = resume(stoss, path, job.replace("7850", "7851"))
    assert (other.returncode, path.read_text().count("\n")) == (3, text.count("\n"))
    assert "got 7851" in other.stderr.replace(".0", "") or "poisson" in other.stderr


def test_same_output_is_allowed(stoss, tmp_path, small):
    path = tmp_path / "x.csv"
    assert resume(stoss, path, f"{SMALL} --format csv -o {tmp_path}/./x.csv").returncode == 0
    assert rows(path.read_text()) == rows(small)


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


@pytest.mark.parametrize("number_of_signal", [signal.SIGINT, signal.SIGKILL])
def test_curve_of_pairs_interrupted_or_killed_and_resumed(stoss, tmp_path, number_of_signal):
    path = tmp_path / "curve.csv"
    job = "restitution --body disk --poisson 0.33,0.2 --speed log:0.01:0.2:40 --tolerance 1e-2 --against disk,radius=2"
    command = stoss.start(f"{job} --threads 1 --resume {path}", stderr=subprocess.DEVNULL)
    wait_for_rows(command, path, 3)
    command.send_signal(number_of_signal)
    assert command.wait(timeout=60) == (130 if number_of_signal == signal.SIGINT else -signal.SIGKILL)
    assert resume(stoss, path, job).returncode == 0
    assert rows(path.read_text()) == rows(stoss.run(job, "--format csv").stdout)


@pytest.mark.parametrize(
    "bodies, others",
    [
        (
            "--body disk --poisson 0.33 --against disk,radius=2",
            [
                "--body disk --poisson 0.33 --against disk,radius=2.5",
                "--body disk --poisson 0.33 --against same",
                "--body disk --poisson 0.33",
                "--body rod",
            ],
        ),
        ("--body rod --against rod,length=2.5", ["--body rod --against same", "--body rod", "--poisson 0.33"]),
    ],
)
def test_resume_keeps_to_the_bodies(stoss, tmp_path, bodies, others):
    path = tmp_path / "curve.csv"
    job = "restitution --speed 0.1,0.2 --tolerance 0.1"
    whole = stoss.run(job, bodies, "--format csv").stdout
    path.write_text(whole[: whole.rindex("\n", 0, -1) + 1])
    before = path.read_text()
    for other in others:
        result = resume(stoss, path, f"{job} {other}")
        assert result.returncode == 3 and "another job needs another file" in result.stderr
        assert path.read_text() == before
    assert resume(stoss, path, f"{job} {bodies}").returncode == 0
    assert rows(path.read_text()) == rows(whole)
