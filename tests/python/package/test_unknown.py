"""An error that is as large as its value is unknown: infinite in arrays, a word elsewhere, and no bar in pictures."""

import csv
import dataclasses
import json

import numpy as np
import pytest

import stoss


@pytest.fixture(scope="module")
def doubtful():
    return dataclasses.replace(
        stoss.restitution(poisson=0.33, speed=0.1, tolerance=0.1),
        restitution_error=np.inf, lost_fraction_error=np.inf, contact_time_error=np.inf,
    )  # fmt: skip


@pytest.fixture(scope="module")
def several():
    curve = stoss.restitution(poisson=0.33, speed=[0.05, 0.1, 0.2], tolerance=0.1)
    error = curve.restitution_error.copy()
    error[1] = np.inf
    return dataclasses.replace(curve, restitution_error=error)


def test_the_line_says_so(doubtful):
    assert f"restitution {doubtful.restitution:.6g} ± unknown" in repr(doubtful)


def test_files_say_so(doubtful, several, tmp_path):
    for result, words in ((doubtful, ["unknown"]), (several, None)):
        result.to_csv(tmp_path / "result.csv")
        rows = list(csv.DictReader(line for line in open(tmp_path / "result.csv") if not line.startswith("#")))
        found = [row["restitution_error"] for row in rows]
        assert found == words if words else found[1] == "unknown" and all(float(each) < 1 for each in found[::2])
        assert "inf" not in (tmp_path / "result.csv").read_text()
    assert rows[1]["restitution"] == repr(float(several.restitution[1]))


def test_dictionaries_say_so(doubtful, several):
    assert doubtful.to_dict()["contact_time_error"] == "unknown"
    assert several.to_dict()["restitution_error"][1] == "unknown"
    assert "Infinity" not in json.dumps([doubtful.to_dict(), several.to_dict()], allow_nan=False)


def test_pictures_have_no_bar_there(several, closed):
    axes = several.plot()
    container = axes.containers[0]
    assert len(container.lines[0].get_xdata()) == 3  # the marker stays
    (bars,) = container.lines[2]
    assert [round(each[0][0], 2) for each in bars.get_segments()] == [0.05, 0.2]
    assert np.isfinite(axes.get_ylim()).all() and np.ptp(axes.get_ylim()) < 0.5
