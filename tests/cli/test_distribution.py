"""stoss distribution: one row a sample, the same however it is computed, and what they have in
common."""

import json
import math
import signal
import statistics

import pytest

from conftest import number, resume, rows, wait_for_rows

pytestmark = pytest.mark.numbers

BALL = "distribution --body sphere --poisson 0.3 --speed 0.01"
JOB = f"{BALL} --temperature 0.01 --samples 12 --seed 7"
LONG = f"{BALL} --temperature 0.01 --samples 400 --error 1e-5 --seed 3"


@pytest.fixture(scope="module")
def whole(stoss):
    """The whole CSV text of JOB."""
    return stoss.run(JOB, "--format csv").stdout


def test_rows_are_samples(whole):
    samples = rows(whole)
    assert [row["sample"] for row in samples] == [str(k) for k in range(12)]
    for row in samples:
        assert row["converged"] == "true" and 0 < number(row, "lost_fraction_error") < 1e-3
        assert 1 - number(row, "restitution") ** 2 == pytest.approx(number(row, "lost_fraction"), abs=1e-12)
    assert statistics.mean(number(row, "vibration") for row in samples) == pytest.approx(0.44, abs=0.1)  # 44 modes
    assert max(number(row, "restitution") for row in samples) > 1


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_threads_change_nothing(stoss, whole, threads):
    again = stoss.run(JOB, f"--format csv --threads {threads}").stdout
    assert rows(again) == rows(whole)


def test_samples_depend_on_seed_and_number_only(stoss, whole):
    assert rows(stoss.run(JOB.replace("12", "5"), "--format csv").stdout) == rows(whole)[:5]
    other = rows(stoss.run(JOB.replace("seed 7", "seed 8"), "--format csv").stdout)
    assert all(a["restitution"] != b["restitution"] for a, b in zip(other, rows(whole)))


def test_a_temperature_is_a_spectrum_of_equal_energies(stoss):
    warm = stoss.run(f"{BALL} --temperature 0.05 --highest 2.5 --samples 4 --format json")
    modes = json.loads(warm.stdout)
    assert modes["inputs"]["modes"] == 3
    spectrum = " ".join(f"--spectrum {n},0,energy=0.05" for n in (1, 2, 3))
    named = stoss.data(f"{BALL} {spectrum} --samples 4")
    assert [number(row, "restitution") for row in named] == [row["restitution"] for row in modes["records"]]


def test_summary(stoss, whole):
    summary = json.loads(stoss.run(JOB, "--format json").stdout)["summary"]
    values = [number(row, "restitution") for row in rows(whole)]
    assert summary["samples"] == 12 and summary["missing"] == 0 == summary["not_converged"]
    assert summary["restitution"] == pytest.approx(statistics.mean(values), rel=1e-14)
    spread = statistics.stdev(values)
    assert summary["standard_deviation"] == pytest.approx(spread, rel=1e-10)
    assert summary["restitution_statistical_error"] == pytest.approx(spread / math.sqrt(12), rel=1e-10)
    errors = [number(row, "restitution_error") for row in rows(whole)]
    assert summary["restitution_numerical_error"] == pytest.approx(statistics.mean(errors), rel=1e-10)
    assert (summary["least"], summary["greatest"]) == (min(values), max(values))
    assert summary["share_above_one"] == sum(value > 1 for value in values) / 12


def test_summary_is_for_reading_beside_data(stoss, whole):
    table = stoss.run(JOB)
    last = table.stdout.split("\n\n")[1]
    assert last.startswith("mean restitution") and "± " in last and "% of 12 samples" in last and not table.stderr
    csv = stoss.run(JOB, "--format csv")
    assert csv.stdout == whole.replace("\n# command: " + whole.split("# command: ")[1].split("\n")[0],
                                       "\n# command: " + csv.stdout.split("# command: ")[1].split("\n")[0])
    assert csv.stderr == last
    assert not stoss.run(JOB, "--format csv --quiet").stderr


def test_one_sample_has_no_spread(stoss):
    summary = json.loads(stoss.run(f"{BALL} --temperature 0.01 --samples 1 --format json").stdout)["summary"]
    assert summary["standard_deviation"] == "unknown" == summary["restitution_statistical_error"]


def test_bodies_at_rest_are_all_alike(stoss):
    cold = stoss.data(f"{BALL} --temperature 0 --samples 3")
    (at_rest,) = stoss.data("restitution --body sphere --poisson 0.3 --speed 0.01")
    assert len({row["restitution"] for row in cold}) == 1 and number(cold[0], "vibration") == 0
    assert number(cold[0], "lost_fraction") == pytest.approx(
        number(at_rest, "lost_fraction"), abs=number(cold[0], "lost_fraction_error")
    )


def test_si(stoss):
    steel = "--young 2.1e11 --density 7850 --radius 0.01"
    (row,) = stoss.data(f"distribution --body sphere --poisson 0.3 {steel} --speed 1 --temperature 0.1 --samples 1")
    c = math.sqrt(2.1e11 / 7850)
    assert number(row, "contact_time_si") == pytest.approx(number(row, "contact_time") * 0.01 / c, rel=1e-12)
    (own,) = stoss.data(f"{BALL.replace('0.01', repr(1 / c))} --temperature 0.1 --samples 1")
    assert number(row, "restitution") == pytest.approx(number(own, "restitution"), rel=1e-9)


def test_samples_that_miss_their_error_are_marked(stoss):
    result = stoss.run("distribution --body rod --speed 0.1 --against rod,length=2.5 --temperature 0.1 --samples 3 "
                       "--error 1e-5")  # fmt: skip
    assert result.returncode == 1 and "sample 0: " in result.stderr
    assert "3 of 3 values not as accurate as asked for" in result.stderr and " !" in result.stdout


@pytest.mark.parametrize("keep", [0, 3, 4.5, 12])
def test_resume_is_the_same_byte_for_byte(stoss, tmp_path, keep):
    path = tmp_path / "samples.csv"
    assert resume(stoss, path, JOB).returncode == 0
    text = path.read_text()
    lines = text.splitlines(keepends=True)
    head = next(i for i, line in enumerate(lines) if line.startswith("sample,")) + 1
    kept = "".join(lines[: head + int(keep)])
    path.write_text(kept + (lines[head + int(keep)][:30] if keep != int(keep) else ""))
    again = resume(stoss, path, JOB)
    assert again.returncode == 0 and path.read_text() == text
    assert again.stderr.startswith("mean restitution") and "% of 12 samples" in again.stderr


@pytest.mark.parametrize("how, code", [(signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGKILL, -9)])
def test_an_end_at_any_time_loses_no_row(stoss, tmp_path, how, code):
    path = tmp_path / "samples.csv"
    process = stoss.start(f"{LONG} --resume {path} --quiet")
    wait_for_rows(process, path, 5)
    process.send_signal(how)
    assert process.wait(timeout=10) == code
    text = path.read_text()
    assert text.endswith("# interrupted: the rows above are complete, later ones are missing\n") == (code > 0)
    done = [line for line in text[: text.rindex("\n") + 1].splitlines() if line and not line.startswith("#")][1:]
    assert 5 <= len(done) < 400
    first = stoss.run(LONG.replace("samples 400", f"samples {len(done)}"), "--format csv --quiet").stdout
    assert first.splitlines()[-len(done):] == [line.rpartition(",")[0] for line in done]  # but for their checksums


def test_another_ensemble_is_another_job(stoss, tmp_path):
    path = tmp_path / "samples.csv"
    assert resume(stoss, path, JOB).returncode == 0
    text = path.read_text()
    changes = {"seed 7": "seed 8", "samples 12": "samples 13", "temperature 0.01": "temperature 0.02",
               "0.01 --temperature 0.01": "0.01 --spectrum 2,0,energy=0.1"}  # fmt: skip
    for before, after in changes.items():
        result = resume(stoss, path, JOB.replace(before, after))
        assert result.returncode == 3 and "as in '" in result.stderr
    other = resume(stoss, path, "restitution --body sphere --poisson 0.3 --speed 0.01")
    assert other.returncode == 3 and "kind of result: got restitution, allowed distribution" in other.stderr
    assert path.read_text() == text


@pytest.mark.parametrize(
    "arguments, message",
    [
        ("", "temperature: got neither --temperature and --spectrum"),
        ("--temperature 1 --spectrum 2,0,energy=1", "temperature: got both"),
        ("--temperature 1 --highest 0.5", "highest: got 0.5, allowed from 1.64"),
        ("--temperature 1 --highest 1e4", "highest: got 10000, allowed above 0 to 128"),
        ("--spectrum 2,0,energy=1 --highest 10", "highest: got --highest with --spectrum"),
        ("--spectrum 2,0,energy=1 --spectrum 2,0,energy=1", "twice, allowed once"),
        ("--spectrum 2,0,energy=-1", "energy: got -1"),
        ("--spectrum 2,0,energy=1,phase=1", "spectrum: got 'phase', allowed energy, of"),
        ("--spectrum 2,700,energy=1", "mode (2, 700) of the first body"),
        ("--spectrum 2,0,energy=1,of=second", "mode of body 1, allowed 0 (a wall has no modes)"),
        ("--against half-space --spectrum 0,0,energy=1,of=second", "bodies that are there as a whole"),
        ("--against exponential --temperature 1", "against: got exponential"),
        ("--temperature 1 --threads -1", "threads: got -1"),
    ],
)
def test_refusals_leave_the_file_alone(stoss, tmp_path, arguments, message):
    path = tmp_path / "there.csv"
    path.write_text("mine")
    result = stoss.run(f"{BALL} {arguments} -o {path}")
    assert result.returncode == 3 and message in result.stderr and result.stderr.count("\n") == 1
    assert path.read_text() == "mine"
