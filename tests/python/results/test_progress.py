"""What calls that may take long show on stderr where progress=True."""

import contextlib
import importlib
import inspect
import io
import sys

import pytest

import stoss
from stoss.results import _progress

BALL, DISK, RODS = stoss.Sphere(poisson=0.3), stoss.Disk(poisson=0.33), [stoss.Rod(length=1.0), stoss.Rod(length=1.1)]
GLASS = stoss.Sphere(radius=5e-3, material=stoss.materials["glass"])
WAITING = {
    "bounce": ("_bounce", lambda **more: stoss.bounce(BALL, speed=0.05, count=2, flight_time=30, **more)),
    "calibrate": ("stoss.calibration._calibration", lambda **more: stoss.calibrate(
        {"speed": [1.0], "restitution": [0.97], "restitution_uncertainty": [0.01]}, GLASS, unknown="quality", **more)),
    "collision_rule": ("_adaptive_rule", lambda **more: stoss.collision_rule(
        BALL, speed=(0.01, 0.011), error=0.05, tolerance=0.1, **more)),
    "impact": ("_impact", lambda **more: stoss.impact(BALL, speed=0.1, cutoff=10, **more)),
    "oblique_impact": ("_oblique_impact", lambda **more: stoss.oblique_impact(
        BALL, speed=0.05, angle=40, friction=0.3, cutoff=10, **more)),
    "pair_table": ("_pair_table", lambda **more: stoss.pair_table(
        DISK, speed=(0.1, 0.11), ratio=(1, 1.1), error=0.05, **more)),
    "pulse": ("_pulse", lambda **more: stoss.pulse(BALL, speed=0.1, **more)),
    "predict": ("_prediction", lambda **more: stoss.predict(GLASS, speed=0.01, tolerance=0.1, **more)),
    "restitution_function": ("_function", lambda **more: stoss.restitution_function(
        BALL, speed=(0.1, 0.11), error=0.05, **more)),
    "row_impact": ("stoss.rows._row_impact", lambda **more: stoss.row_impact([BALL] * 2, speed=[0.1], cutoff=6, **more)),
    "rod_chain": ("_rod_chain", lambda **more: stoss.rod_chain(
        RODS, circumference=20, velocities=[1e-3, 0], collisions=1, **more)),
}  # fmt: skip
COUNTING = {"fit", "oblique", "restitution", "restitution_distribution", "row", "sweep"}
AT_ONCE = {"atlas", "merge", "modes", "open_sweep", "read_csv", "relaxation_of_measurement", "shifted", "with_error"}
"""Calls that look up, read or write: less than 5 s."""


def test_every_call_that_may_take_long_has_a_progress():
    calls = {name for name in stoss.__all__ if inspect.isfunction(getattr(stoss, name, None))} - {"animate"}
    assert calls == set(WAITING) | COUNTING | AT_ONCE
    for name in calls:
        parameter = inspect.signature(getattr(stoss, name)).parameters.get("progress")
        assert (parameter is not None) == (name not in AT_ONCE), name
        assert parameter is None or parameter.default is False


@pytest.mark.parametrize("name", WAITING)
def test_calls_that_cannot_count_say_for_how_long_they_go_on(name, monkeypatch):
    told = []

    @contextlib.contextmanager
    def waiting(wanted, said):
        told.append((wanted, said))
        yield
        told.append("done")

    module, call = WAITING[name]
    monkeypatch.setattr(importlib.import_module(module if "." in module else f"stoss.results.{module}"), "waiting", waiting)
    call(), call(progress=True)
    assert told == [(False, name), "done", (True, name), "done"]
    with pytest.raises(stoss.InvalidInput, match="^progress: got 1, allowed True or False"):
        call(progress=1)




def test_the_core_lets_the_line_be_written(monkeypatch):
    """A call of some hundred milliseconds, with no patience."""
    monkeypatch.setattr(_progress, "PATIENCE", 0.0)
    monkeypatch.setattr(_progress, "PAUSE", 0.01)
    monkeypatch.setattr(sys, "stderr", io.StringIO())
    stoss.impact(DISK, speed=1e-3, cutoff=60, progress=True)
    text = sys.stderr.getvalue()
    assert text.count("\rimpact: 0.") >= 1 and text.endswith(" s\n"), text


def test_no_line_is_left_after_a_short_call_or_a_failure(monkeypatch):
    monkeypatch.setattr(_progress, "PATIENCE", 1000.0)
    monkeypatch.setattr(sys, "stderr", io.StringIO())
    with pytest.raises(ZeroDivisionError), _progress.waiting(True, "x"):
        _ = 1 / 0
    assert sys.stderr.getvalue() == ""


@pytest.mark.parametrize("executor", [None, 2])
def test_sweep_counts_its_values(monkeypatch, tmp_path, executor):
    monkeypatch.setitem(sys.modules, "tqdm", None)
    monkeypatch.setattr(sys, "stderr", io.StringIO())
    grid = stoss.Grid(bodies={"kind": "disk", "poisson": [0.2, 0.3]}, speed=[0.1, 0.2, 0.3], tolerance=0.1)
    stoss.sweep(grid, executor, store=tmp_path, progress=True)
    text = sys.stderr.getvalue()
    assert text.endswith("] 6/6\n") and (text.count("\r") == 7 if executor is None else text.count("\r") == 3), text
