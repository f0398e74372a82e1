"""What an impact was like: its trajectory and field, what is heard of it, and the waves below a surface."""

import wave
from pathlib import Path

import numpy as np
import pytest
import stoss
from stoss.plot import _ground

pyplot = pytest.importorskip("matplotlib.pyplot")

integral = getattr(np, "trapezoid", None) or np.trapz


def test_trajectory_is_the_impact(hit):
    path = hit.trajectory()
    assert len(path) == hit.steps + 1
    # It starts less than a step in front of the contact grid's first touch.
    assert (path.time[0], path.velocity[0]) == (0, hit.speed)
    assert -1 - 2 * hit.step * hit.speed < path.center[0] < -1
    assert path.time[-1] == pytest.approx(hit.steps * hit.step, rel=1e-14)
    assert path.velocity[-1] == pytest.approx(-hit.restitution * hit.speed, rel=1e-14)
    assert (path.vibration[-1], path.unresolved[-1]) == pytest.approx((hit.vibration, hit.unresolved), abs=1e-14)
    assert path.force.max() == pytest.approx(hit.max_force, rel=1e-3)
    assert path.contact_half_width.max() == pytest.approx(hit.max_half_width, rel=1e-3)
    assert np.ptp(path.time[path.force > 0]) == pytest.approx(hit.contact_time, abs=2 * hit.step)
    some = hit.trajectory(every=7)
    assert some.time[:-1].tolist() == path.time[::7][: len(some) - 1].tolist() and some.time[-1] == path.time[-1]


def test_field_is_that_of_the_impact(hit):
    radius, weight = (0.5 * (x + y) for x, y in zip(np.polynomial.legendre.leggauss(40), (1, 0)))
    angle = np.linspace(-np.pi, np.pi, 361)[:-1]
    field = hit.field(time=[[3.0, 1.0], [0.2, 5.0]], radius=radius, angle=angle)
    assert field.x.shape == (2, 2, 40, 360) and field.force.shape == (2, 2)
    assert field.time == pytest.approx(np.array([[3.0, 1.0], [0.2, 5.0]]), abs=hit.step / 2 + 1e-12)
    # Nothing is beyond the wall, and the centre of mass is the mean position.
    assert hit.field(time=np.linspace(0, 7, 15)).x.max() < 1e-3
    mean = (field.x * (radius * weight)[:, None]).sum((-1, -2)) * 2 / angle.size
    assert mean == pytest.approx(field.center, abs=1e-12)
    assert (field.y * (radius * weight)[:, None]).sum((-1, -2)) == pytest.approx(np.zeros((2, 2)), abs=1e-12)
    # Each instant is that of the trajectory, and alone it is the same.
    path = hit.trajectory()
    for at in np.ndindex(2, 2):
        k = np.argmin(abs(path.time - field.time[at]))
        assert (path.time[k], path.center[k], path.force[k]) == (field.time[at], field.center[at], field.force[at])
        alone = hit.field(time=field.time[at], radius=radius, angle=angle)
        assert isinstance(alone.center, float) and alone.center == field.center[at]
        assert np.array_equal(alone.x, field.x[at]) and np.array_equal(alone.stress_rr, field.stress_rr[at])


def test_field_is_elasticity(hit):
    field = hit.field(time=2.9)
    rr, pp, rp = field.stress_rr, field.stress_pp, field.stress_rp
    assert field.von_mises == pytest.approx(np.sqrt(rr**2 - rr * pp + pp**2 + 3 * rp**2), abs=1e-14)
    assert field.principal_difference == pytest.approx(np.hypot(rr - pp, 2 * rp), abs=1e-14)
    # Before, the disk flies as it was made.
    before = hit.field(time=-2, radius=[0, 0.5, 1], angle=[0, 1, 2])
    start = hit.trajectory().center[0]
    assert before.x == pytest.approx(start - 2 * hit.speed + np.outer([0, 0.5, 1], np.cos([0, 1, 2])), abs=1e-14)
    assert before.von_mises.max() == 0 and before.force == 0


GLASS = stoss.Material(young=7e10, poisson=0.22, density=2500)
BALL = stoss.Sphere(radius=0.05, material=GLASS)


@pytest.fixture(scope="module")
def rung():
    return stoss.impact(BALL, speed=1.0, cutoff=4)


def test_it_goes_on_as_the_impact_ends(rung):
    # The vibration a little later is that of the replay: the same sum of energies, and the velocity of the point
    # that follows from the free motion of the modes.
    state = rung.state_after(flight=0.0)
    modes = stoss.modes(BALL, cutoff=4)
    at = {(n, k): (u, w) for n, k, u, w in zip(modes.order, modes.index, modes.radial, modes.omega)}
    heard = rung.sound(duration=0.2, slower=200, quality=1e12)
    time = heard.time / BALL.scales.time
    parted = rung.restitution * rung.speed * BALL.scales.speed
    path = rung.trajectory()
    # State and phases count from where the bodies would part unexcited; the sound begins at the end of the impact.
    delay = (path.center[-1] + 1.0) / (-rung.restitution * rung.speed)
    expected = sum(
        -u * np.sqrt(each["energy"]) * parted * np.sin(w * (time + delay) + each["phase"])
        for each in state for u, w in [at[each["order"], each["index"]]]
    )  # fmt: skip
    assert np.abs(heard.samples - expected).max() < 1e-6 * np.abs(expected).max()


def test_a_wav_file_holds_it(rung, tmp_path):
    heard = rung.sound(duration=0.25, rate=8000, slower=50)
    heard.save(tmp_path / "ball.wav")
    with wave.open(str(tmp_path / "ball.wav")) as file:
        assert (file.getnchannels(), file.getsampwidth(), file.getframerate()) == (1, 2, 8000)
        written = np.frombuffer(file.readframes(file.getnframes()), dtype="<i2")
    assert np.abs(written).max() == 32767
    assert np.abs(written / 32767 - heard.samples / np.abs(heard.samples).max()).max() < 2e-5
    assert repr(heard) == "Sound(Sphere(poisson=0.22, radius=0.05 m), 0.25 s at 8000 Hz, 50 times slower)"


def test_either_body_is_heard():
    pair = stoss.impact(BALL, against=stoss.Sphere(radius=0.1, material=GLASS), speed=1.0, cutoff=4)
    first, second = (pair.sound(duration=0.2, slower=100, of=of) for of in (0, 1))
    assert np.abs(first.samples).max() > 0 and np.abs(second.samples).max() > 0 and "0.1 m" in repr(second)


@pytest.fixture(scope="module")
def met():
    return stoss.impact(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(young=0.5), speed=0.1, cutoff=6)


def test_surface_is_that_of_the_impact(met):
    time = 1.2 * met.contact_time
    y, x, _ = _ground.surface(met, [time], 4.0)
    side = y > 0.0
    wave = met.wave(time=time, distance=y[side], depth=[0.0])
    assert wave.normal[0] == pytest.approx(x[0][side], abs=2e-3 * np.abs(x).max())


def test_times_in_any_order_and_defaults(met):
    points = {"distance": [0.0, 2.0], "depth": [0.0, 1.0, 2.0]}
    turned = met.wave(time=[9.0, 2.0], **points)
    assert turned.normal.shape == (2, 3, 2)
    alone = met.wave(time=2.0, **points)
    assert alone.normal == pytest.approx(turned.normal[1], rel=1e-3)
    usual = met.wave()
    assert usual.time.size == 4
    assert usual.distance[-1] == pytest.approx(1.6 * met.contact_time * usual.pressure_speed)


def test_a_plate_moves_through_its_thickness():
    plate = stoss.Plate(thickness=0.5, poisson=0.3, young=5, density=5)
    met = stoss.impact(stoss.Sphere(poisson=0.3), against=plate, speed=0.02, cutoff=8)
    time = met.contact_time
    wave = met.wave(time=time)
    assert wave.depth[-1] == 0.5 and wave.distance.size == 121
    y, upper, lower = _ground.surface(met, [time], 3.0)
    side = y > 0.0
    near = met.wave(time=time, distance=y[side], depth=[0.0, 0.5])
    size = np.abs(near.normal).max()
    assert near.normal[0] == pytest.approx(upper[0][side], abs=5e-3 * size)
    assert near.normal[1] == pytest.approx(lower[0][side] - 0.5, abs=5e-3 * size)
    # It bends as a whole, farther out than it is dented.
    far = y[side] > 1.5
    assert near.normal[0][far] == pytest.approx(near.normal[1][far], abs=0.05 * size)
    with pytest.raises(stoss.InvalidInput, match="depth: got .*0 to 0.5 .R, the thickness of the plate"):
        met.wave(depth=[0.0, 0.6])
    for picture in (wave.plot(), stoss.plot.sequence(met, count=2), stoss.plot.stress(met.field(time=time))):
        pyplot.close(picture.figure)


def test_picture(met):
    wave = met.wave(time=[3.0, 9.0], distance=np.linspace(0, 12, 25), depth=np.linspace(0, 12, 25))
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


def test_numbers_of_the_results():
    """What docs/understand/findings/half_space.md says of how the waves spread."""
    met = stoss.impact(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(), speed=0.1, cutoff=8)
    peaks = []
    for time in (20.0, 40.0):
        # Where the Rayleigh wave is, and where the pressure wave is alone.
        places = time * np.concatenate((np.linspace(0.565, 0.595, 31), np.linspace(0.68, 1.2, 81)))
        surface = met.wave(time=time, distance=places, depth=[0.0])
        axis = met.wave(time=time, distance=[0.0], depth=time * np.linspace(0.9, 1.2, 41))
        along = np.hypot(surface.lateral_velocity, surface.normal_velocity)[0] / met.speed
        down = np.abs(axis.normal_velocity)[:, 0] / met.speed
        peaks.append([along[:31].max(), down.max(), along[31:].max()])
    assert np.array(peaks) == pytest.approx(np.array([[0.0276, 0.0035, 0.0031], [0.0207, 0.0016, 0.00083]]), rel=0.03)
    words = (Path(__file__).parents[3] / "docs/understand/findings/half_space.md").read_text(encoding="utf-8")
    for name in ("0.0276 to 0.0207 v", "0.0035 to 0.0016 v", "0.0031 to 0.00083 v"):
        assert name in " ".join(words.split())
    assert (surface.pressure_speed, surface.shear_speed, surface.rayleigh_speed) == pytest.approx(
        (1.160, 0.620, 0.575), abs=5e-4
    )
