"""stoss pulse: the force of one impact in time."""

import csv
import io
import json

import pytest

pytestmark = pytest.mark.numbers

BALL = "pulse --body sphere --poisson 0.3 --speed 0.01"
STEEL = "pulse --body sphere --material 'bearing steel' --radius 0.003 --against half-space,material=glass"


def record(stoss, words):
    result = stoss.run(words, "--format json")
    assert result.returncode == 0, result.stderr
    document = json.loads(result.stdout)
    assert document["schema"] == "stoss/pulse/2" and document["complete"]
    return document["records"][0]


def test_a_record_has_numbers_with_errors_and_the_series_behind(stoss):
    made = record(stoss, BALL)
    for name in ("peak_force", "contact_time", "impulse", "rise", "corner_frequency", "first_null"):
        assert 0.0 < made[f"{name}_error"] < 0.05 * made[name]
    assert made["impulse"] == pytest.approx(0.01 * (1 + made["restitution"]), rel=1e-5)
    assert len(made["time"]) == len(made["force"]) == len(made["force_error"]) == len(made["amplitude"]) == 400
    assert max(made["force"]) == pytest.approx(made["peak_force"], rel=0.01)
    assert max(made["force_error"]) < 0.02 * made["peak_force"]
    assert made["amplitude"][0] == pytest.approx(1.0, abs=1e-6)


def test_with_a_material_the_series_is_in_si(stoss):
    made = record(stoss, f"{STEEL} --height 0.2 --points 1000")
    assert made["series_units"] == {"time": "s", "force": "N", "force_error": "N", "frequency": "rad/s", "amplitude": "",
                                    "amplitude_error": ""}  # fmt: skip
    assert max(made["force"]) == pytest.approx(made["peak_force_si"], rel=0.01)
    area = sum(made["force"]) * (made["time"][1] - made["time"][0])
    assert area == pytest.approx(made["impulse_si"], rel=1e-3)
    mass = 4.0 / 3.0 * 3.141592653589793 * 0.003**3 * 7800
    assert made["impulse_si"] == pytest.approx(mass * made["speed_si"] * (1 + made["restitution"]), rel=0.02)


def test_csv_is_the_force_in_time(stoss):
    text = stoss.run(f"{STEEL} --speed 1 --format csv").stdout
    rows = list(csv.DictReader(line for line in io.StringIO(text) if not line.startswith("#")))
    assert list(rows[0]) == ["time[R/c]", "force[mc^2/R]", "force_error[mc^2/R]", "time_si[s]", "force_si[N]",
                             "force_si_error[N]"]  # fmt: skip
    assert len(rows) == 400 and float(rows[200]["force_si[N]"]) > 10


def test_a_threshold_shortens_the_duration(stoss):
    low, high = (record(stoss, f"{BALL} --threshold {share}") for share in (0.01, 0.5))
    assert high["duration"] < 0.7 * low["duration"] < 0.7 * low["contact_time"]


PLATE = "pulse --body sphere --poisson 0.3 --speed 0.001 --against plate,thickness=4"


def test_a_receiver_on_the_other_face_has_numbers_and_series(stoss):
    made = record(stoss, f"{PLATE} --depth 4 --until 60 --points 61")
    assert made["depth"] == 4 and made["distance"] == 0 and made["max_radial"] == 0
    assert made["arrival"] == pytest.approx(4 / 1.160, rel=1e-3)  # c_p at nu = 0.3
    assert len(made["receiver_time"]) == len(made["normal"]) == len(made["radial_velocity_error"]) == 61
    assert made["receiver_time"][-1] == pytest.approx(60) and len(made["time"]) == 61
    assert max(map(abs, made["normal"])) == made["max_normal"] > 50 * made["max_normal_error"]
    assert made["series_units"]["normal"] == "R" and made["series_units"]["normal_velocity"] == "c"


def test_csv_of_a_receiver_is_its_motion(stoss):
    text = stoss.run(f"{PLATE} --distance 5 --points 50 --format csv").stdout
    assert "# distance: 5" in text
    rows = list(csv.DictReader(line for line in io.StringIO(text) if not line.startswith("#")))
    assert list(rows[0]) == ["time[R/c]", "force[mc^2/R]", "force_error[mc^2/R]", "normal[R]", "normal_error[R]",
                             "radial[R]", "radial_error[R]", "normal_velocity[c]", "normal_velocity_error[c]", "radial_velocity[c]",
                             "radial_velocity_error[c]"]  # fmt: skip
    assert len(rows) == 50 and float(rows[0]["normal[R]"]) == pytest.approx(0.0, abs=1e-9)


def test_a_receiver_is_given_in_metres_with_a_material(stoss):
    made = record(stoss, f"{STEEL} --speed 1 --distance 0.06")
    assert made["distance"] == pytest.approx(20) and made["distance_si"] == pytest.approx(0.06)
    assert made["max_normal_si"] == pytest.approx(max(map(abs, made["normal"])), rel=1e-12)


@pytest.mark.parametrize("words, line", {
    f"{PLATE} --depth 5": "depth: got 5, allowed 0 to 4 R",
    f"{PLATE} --distance 0.01": "twice the radius of the contact",
    f"{PLATE} --until 50": "until: a time without a receiver",
    f"{BALL} --distance 5": "against: got wall, allowed a half-space or a plate",
}.items())  # fmt: skip
def test_refuses_a_receiver_in_one_line(stoss, words, line):
    result = stoss.run(words)
    assert result.returncode == 3 and len(result.stderr.splitlines()) == 1 and line in result.stderr


@pytest.mark.parametrize("words, line", {
    "--tolerance 0": "tolerance: got 0, allowed 1e-5 to 0.5",
    "--threshold 1": "threshold: got 1, allowed 0 to 0.9",
    "--points 3": "points: got 3, allowed 16 to 100000",
    "--height 1": "height",
}.items())  # fmt: skip
def test_refuses_in_one_line(stoss, words, line):
    result = stoss.run(f"{BALL} {words}")
    assert result.returncode in (2, 3) and len(result.stderr.splitlines()) == 1 and line in result.stderr


def test_what_misses_the_tolerance_is_written_and_said(stoss):
    result = stoss.run("pulse --body disk --poisson 0.3 --speed 0.1 --tolerance 1e-3 --format json")
    made = json.loads(result.stdout)["records"][0]
    assert result.returncode == 1 and "not as accurate as asked for" in result.stderr and not made["converged"]
