"""What measurements say of impacts, and which are refused."""

import numpy as np
import pytest
import stoss
from stoss.calibration._air import GRAVITY, Flight
from stoss.calibration._data import data_of

FREE = Flight(0.01, 2500.0, False)


def test_heights_are_speeds():
    found = data_of({"drop_height": [1.0], "rebound_height": [0.64], "rebound_height_uncertainty": [0.01]}, FREE)
    assert found.speed == pytest.approx(np.sqrt(2 * GRAVITY))
    assert found.value == pytest.approx(0.8)
    assert found.uncertainty == pytest.approx(0.8 * 0.5 * 0.01 / 0.64, rel=1e-3)


def test_both_heights_are_uncertain():
    columns = {
        "drop_height": [1.0],
        "rebound_height": [0.64],
        "drop_height_uncertainty": [0.01],
        "rebound_height_uncertainty": [0.01],
    }
    assert data_of(columns, FREE).uncertainty == pytest.approx(0.4 * np.hypot(0.01, 0.01 / 0.64), rel=1e-3)


def test_times_of_bounces_share_their_errors():
    epsilon, times = 0.9, [0.0]
    for flight in 2 * 2.0 / GRAVITY * epsilon ** np.arange(5):
        times.append(times[-1] + flight)
    found = data_of({"time": times, "time_uncertainty": [1e-3] * 6}, FREE)
    assert found.value == pytest.approx([epsilon] * 4, rel=1e-9)
    assert found.speed == pytest.approx(2.0 * epsilon ** np.arange(4), rel=1e-9)
    random = np.random.default_rng(1)
    drawn = [data_of({"time": np.array(times) + 1e-3 * random.standard_normal(6)}, FREE).value for _ in range(4000)]
    assert found.covariance == pytest.approx(np.cov(np.array(drawn).T), abs=0.08 * found.covariance.max())


def test_a_file_may_have_units_comments_and_empty_cells(tmp_path):
    path = tmp_path / "data.csv"
    names = "note,speed[m/s],restitution,restitution_uncertainty,contact_time [s],contact_time_uncertainty"
    path.write_text(f"# by me\n{names}\na,1,0.9,0.01,,\nb,2,,,1e-5,1e-6\n")
    found = data_of(str(path), FREE)
    assert found.quantity.tolist() == ["restitution", "contact_time"]
    assert found.speed.tolist() == [1.0, 2.0]
    assert found.uncertainty.tolist() == pytest.approx([0.01, 1e-6])
    assert found.known


def test_without_uncertainties_all_weigh_alike():
    found = data_of({"speed": [1.0, 2.0], "restitution": [0.9, 0.8], "contact_time": [2e-5, 1e-5]}, FREE)
    assert not found.known
    assert found.uncertainty[found.quantity == "contact_time"] == pytest.approx([2e-5, 1e-5])


REFUSED = [
    ({"speed": [1.0], "restitution": [1.01]}, "restitution"),
    ({"speed": [1.0], "restitution": [1.0]}, "restitution"),
    ({"speed": [-1.0], "restitution": [0.9]}, "speed"),
    ({"speed": [0.0], "restitution": [0.9]}, "speed"),
    ({"speed": [np.inf], "restitution": [0.9]}, "speed|row 1"),
    ({"speed": [1.0], "contact_time": [0.0]}, "contact_time"),
    ({"speed": [1.0], "peak_force": [-2.0]}, "peak_force"),
    ({"speed": [1.0], "tangential_restitution": [0.3]}, "angle"),
    ({"speed": [1.0], "tangential_restitution": [1.3], "angle": [10.0]}, "tangential_restitution"),
    ({"drop_height": [-1.0], "rebound_height": [0.5]}, "drop_height"),
    ({"drop_height": [1.0], "rebound_height": [1.2]}, "restitution"),
    ({"speed": [1.0], "drop_height": [1.0], "restitution": [0.9]}, "one of them"),
    ({"speed": [1.0, 2.0], "restitution": [0.9]}, "one length"),
    ({"speed": [1.0, 2.0], "restitution": [0.9, 0.9], "restitution_uncertainty": [0.1, np.nan]}, "all or none"),
    ({"time": [0.0, 1.0]}, "three or more"),
    ({"time": [0.0, 1.0, 0.5]}, "ascending"),
    ({"restitution": [0.9]}, "speed, drop_height or time"),
    ({"speed": [1.0]}, "no measured value"),
    ({"speed": []}, "1 to 1000"),
    ({}, "columns"),
    ({"restitution[%]": [90.0], "speed": [1.0]}, "no unit"),
]


@pytest.mark.parametrize(("columns", "said"), REFUSED)
def test_what_cannot_be_is_refused(columns, said):
    with pytest.raises(stoss.InvalidInput, match=said):
        data_of(columns, FREE)


NO_TABLES = [
    ("", "empty file"),
    ("speed,restitution\n1,abc\n", "'abc' in row 1"),
    ("speed,speed\n1,2\n", "two columns"),
    ("a,b\n1,2\n", "columns"),
]


@pytest.mark.parametrize(("text", "said"), NO_TABLES)
def test_a_file_that_is_no_table_is_refused(tmp_path, text, said):
    (tmp_path / "data.csv").write_text(text)
    with pytest.raises(stoss.InvalidInput, match=said):
        data_of(tmp_path / "data.csv", FREE)
