"""stoss distribution: one row a sample, the same however it is computed, and what they have in
common."""

import json

import pytest

from conftest import number, resume, rows

pytestmark = pytest.mark.numbers

BALL = "distribution --body sphere --poisson 0.3 --speed 0.01"
JOB = f"{BALL} --temperature 0.01 --samples 12 --seed 7"


@pytest.fixture(scope="module")
def whole(stoss):
    """The whole CSV text of JOB."""
    return stoss.run(JOB, "--format csv").stdout


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


@pytest.mark.parametrize("keep", [0, 4.5])
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
