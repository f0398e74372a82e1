"""The waves below a half-space's surface: they are those of the surface, move as time passes, and can be drawn."""

import csv
from pathlib import Path

import numpy as np
import pytest

import stoss
from stoss.results import _replay

pyplot = pytest.importorskip("matplotlib.pyplot")


@pytest.fixture(scope="module")
def hit():
    return stoss.impact(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(young=0.5), speed=0.1, cutoff=6)


def test_surface_is_that_of_the_impact(hit):
    time = 1.2 * hit.contact_time
    y, x, _ = _replay.surface(hit, [time], 4.0)
    side = y > 0.0
    wave = hit.wave(time=time, distance=y[side], depth=[0.0])
    assert wave.normal[0] == pytest.approx(x[0][side], abs=2e-3 * np.abs(x).max())


def test_velocity_is_the_rate_of_displacement(hit):
    times = hit.contact_time * np.array([0.5, 1.3])
    points = {"distance": [0.0, 0.7, 3.0], "depth": [0.5, 2.0]}
    wave = hit.wave(time=times, **points)
    width = 2 * hit.step
    before, after = hit.wave(time=wave.time - width, **points), hit.wave(time=wave.time + width, **points)
    for name in ("lateral", "normal"):
        step = (after.time - before.time)[:, None, None]
        rate = (getattr(after, name) - getattr(before, name)) / step
        speed = getattr(wave, f"{name}_velocity")
        assert speed == pytest.approx(rate, abs=0.01 * np.abs(wave.normal_velocity).max())


def test_units_are_those_of_the_first_body(hit):
    wave = hit.wave(time=[0.0], distance=[0.0], depth=[0.0])
    glass = stoss.impact(stoss.Sphere(poisson=0.3, radius=3, young=2), against=stoss.HalfSpace(), speed=0.1, cutoff=6)
    assert wave.shear_speed == pytest.approx(np.sqrt(0.5 / 2.6), rel=1e-14)
    points = {"time": 4.0, "distance": [0.0, 1.0], "depth": [1.0, 2.0]}
    assert glass.wave(**points).normal == pytest.approx(hit.wave(**points).normal, rel=1e-9)


def test_times_in_any_order_and_defaults(hit):
    points = {"distance": [0.0, 2.0], "depth": [0.0, 1.0, 2.0]}
    turned = hit.wave(time=[9.0, 2.0], **points)
    assert turned.normal.shape == (2, 3, 2)
    alone = hit.wave(time=2.0, **points)
    assert alone.normal == pytest.approx(turned.normal[1], rel=1e-3)
    usual = hit.wave()
    assert usual.time.size == 4
    assert usual.distance[-1] == pytest.approx(1.6 * hit.contact_time * usual.pressure_speed)


def test_file(hit, tmp_path):
    wave = hit.wave(time=[2.0, 4.0], distance=[0.0, 1.0], depth=[0.0, 1.0, 2.0])
    wave.to_csv(tmp_path / "wave.csv")
    lines = [line for line in (tmp_path / "wave.csv").read_text().splitlines() if not line.startswith("#")]
    assert lines[0].split(",")[-1] == "normal_velocity[c]" and len(lines) == 1 + 12
    assert wave.to_dict()["depth"] == [0.0, 1.0, 2.0]


def test_only_half_spaces_have_waves():
    with pytest.raises(stoss.InvalidInput, match="against: got .*HalfSpace, HalfPlane, Plate or Strip"):
        stoss.impact(stoss.Sphere(poisson=0.3), speed=0.1, cutoff=10).wave()


def test_a_plate_moves_through_its_thickness():
    plate = stoss.Plate(thickness=0.5, poisson=0.3, young=5, density=5)
    hit = stoss.impact(stoss.Sphere(poisson=0.3), against=plate, speed=0.02, cutoff=8)
    time = hit.contact_time
    wave = hit.wave(time=time)
    assert wave.depth[-1] == 0.5 and wave.distance.size == 121
    y, upper, lower = _replay.surface(hit, [time], 3.0)
    side = y > 0.0
    near = hit.wave(time=time, distance=y[side], depth=[0.0, 0.5])
    size = np.abs(near.normal).max()
    assert near.normal[0] == pytest.approx(upper[0][side], abs=5e-3 * size)
    assert near.normal[1] == pytest.approx(lower[0][side] - 0.5, abs=5e-3 * size)
    # It bends as a whole, farther out than it is dented.
    far = y[side] > 1.5
    assert near.normal[0][far] == pytest.approx(near.normal[1][far], abs=0.05 * size)
    with pytest.raises(stoss.InvalidInput, match="depth: got .*0 to 0.5 .R, the thickness of the plate"):
        hit.wave(depth=[0.0, 0.6])
    for picture in (wave.plot(), stoss.plot.sequence(hit, count=2), stoss.plot.stress(hit.field(time=time))):
        pyplot.close(picture.figure)


def test_points_outside_are_refused(hit):
    with pytest.raises(stoss.InvalidInput, match="depth"):
        hit.wave(depth=[-1.0])
    with pytest.raises(stoss.InvalidInput, match="distance"):
        hit.wave(distance=[np.nan])
    with pytest.raises(stoss.InvalidInput, match="distance"):
        hit.wave(distance=[])
    with pytest.raises(stoss.InvalidInput, match="time: got .*-1e4 to 1e4"):
        hit.wave(time=np.inf)


def test_picture(hit):
    wave = hit.wave(time=[3.0, 9.0], distance=np.linspace(0, 12, 25), depth=np.linspace(0, 12, 25))
    axes = wave.plot()
    texts = [text.get_text() for text in axes.texts]
    assert texts[0] == f"t = {wave.time[0]:.2f} R/c"
    assert {"$c_p t$", "$c_s t$", "$c_R t$"} <= set(texts)
    scale = axes.lines[-1].get_xdata()
    assert texts[-1] == "5 R" and scale[1] - scale[0] == pytest.approx(5.0)
    pyplot.close(axes.figure)


@pytest.mark.parametrize(
    "body, against",
    [(stoss.Disk(poisson=0.33), stoss.HalfPlane()), (stoss.Sphere(poisson=0.3, rigid=True), stoss.HalfSpace())],
)
def test_picture_of_others(body, against):
    other = stoss.impact(body, against=against, speed=0.1, cutoff=6)
    wave = other.wave(time=6.0, distance=np.linspace(0, 8, 17), depth=np.linspace(0, 8, 17))
    axes = stoss.plot.wave(wave, limit=0.1)
    assert axes.get_aspect() == 1.0
    pyplot.close(axes.figure)


def test_picture_refusals(hit):
    wave = hit.wave(time=3.0, distance=[0.0, 1.0], depth=[0.0, 1.0])
    for arguments, message in (({"columns": 0}, "columns"), ({"limit": 0.0}, "limit")):
        with pytest.raises(stoss.InvalidInput, match=message):
            stoss.plot.wave(wave, **arguments)
    with pytest.raises(stoss.InvalidInput, match="allowed at least 2"):
        stoss.plot.wave(hit.wave(time=3.0, distance=[0.0, 1.0], depth=[0.0]))


def test_numbers_of_the_results():
    """What docs/results/half_space.md says of how the waves spread."""
    hit = stoss.impact(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(), speed=0.1, cutoff=8)
    peaks = []
    for time in (20.0, 40.0):
        # Where the Rayleigh wave is, and where the pressure wave is alone.
        places = time * np.concatenate((np.linspace(0.565, 0.595, 31), np.linspace(0.68, 1.2, 81)))
        surface = hit.wave(time=time, distance=places, depth=[0.0])
        axis = hit.wave(time=time, distance=[0.0], depth=time * np.linspace(0.9, 1.2, 41))
        along = np.hypot(surface.lateral_velocity, surface.normal_velocity)[0] / hit.speed
        down = np.abs(axis.normal_velocity)[:, 0] / hit.speed
        peaks.append([along[:31].max(), down.max(), along[31:].max()])
    assert np.array(peaks) == pytest.approx(np.array([[0.0276, 0.0035, 0.0031], [0.0207, 0.0016, 0.00083]]), rel=0.03)
    words = (Path(__file__).parents[3] / "docs/results/half_space.md").read_text(encoding="utf-8")
    for name in ("0.0276 to 0.0207 v", "0.0035 to 0.0016 v", "0.0031 to 0.00083 v"):
        assert name in " ".join(words.split())
    assert (surface.pressure_speed, surface.shear_speed, surface.rayleigh_speed) == pytest.approx(
        (1.160, 0.620, 0.575), abs=5e-4
    )


@pytest.mark.parametrize("ball, rigid", [("elastic", False), ("rigid", True)])
def test_table_of_the_results(ball, rigid):
    lines = (Path(__file__).parents[3] / "docs/results/half_space.csv").read_text(encoding="utf-8").splitlines()
    table = csv.DictReader(line for line in lines if not line.startswith("#"))
    known = [row for row in table if row["ball"] == ball][10::20]
    body = stoss.Sphere(poisson=0.3, rigid=rigid)
    speeds = [float(row["speed[c]"]) for row in known]
    found = stoss.restitution(body, against=stoss.HalfSpace(), speed=speeds)
    for row, lost, error in zip(known, found.lost_fraction, found.lost_fraction_error):
        # Speeds have six digits in the table.
        assert abs(lost - float(row["lost_fraction"])) <= error + float(row["lost_fraction_error"]) + 1e-6 * lost
