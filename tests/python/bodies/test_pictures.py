"""Pictures and fields of two bodies, of balls and of blocks: both are shown, where they are, with their units."""

import math

import numpy as np
import pytest
import stoss
from stoss.plot import _ground

BALL, ONE = stoss.Sphere(poisson=0.3), stoss.Disk(poisson=0.33)
TWO = stoss.Disk(poisson=0.2, radius=2.0, young=3.0, density=2.0)


@pytest.fixture(scope="module")
def pair():
    return stoss.impact(ONE, against=TWO, speed=0.2, cutoff=12)


@pytest.fixture(scope="module")
def bounce():
    return stoss.impact(BALL, speed=0.1, cutoff=12)


@pytest.fixture(scope="module")
def on_block():
    return stoss.impact(BALL, against=stoss.HalfSpace(young=0.5), speed=0.1, cutoff=12.0)


def test_field_of_both(pair):
    radius, weight = (0.5 * (x + y) for x, y in zip(np.polynomial.legendre.leggauss(40), (1, 0)))
    angle = np.linspace(-np.pi, np.pi, 1441)[:-1]
    time = np.array([-1.0, 1.0, 0.5 * pair.contact_time, pair.contact_time + 2])
    centers = []
    for of, size in ((0, 1.0), (1, 2.0)):
        field = pair.field(time=time, radius=radius, angle=angle, of=of)
        assert (field.of, field.size) == (of, size)
        mean = (field.x * (radius * weight)[:, None]).sum((-1, -2)) * 2 / angle.size
        assert mean == pytest.approx(field.center, abs=1e-12)
        centers.append(field.center)
    # The common centre of mass is at rest, and their distance is that of the trajectory.
    assert centers[0] + 8 * centers[1] == pytest.approx(np.full(4, -1 + 8 * 2), abs=1e-12)
    path = pair.trajectory()
    apart = np.interp(field.time[1:3], path.time, path.center)
    assert (centers[0] - centers[1])[1:3] == pytest.approx(apart, abs=1e-12)
    # Before, they fly as they were made.
    before = pair.field(time=-1.0, radius=[1.0], angle=[0.0], of=1)
    ahead = -3.0 - pair.trajectory().center[0]  # of the touch, at the start
    assert before.x[0, 0] == pytest.approx((0.2 + ahead) / 9, abs=1e-12) and before.von_mises.max() == 0


# At the foremost points the surfaces of both are one, beyond the contact they part.
def test_ball_and_half_space_touch(on_block):
    now = on_block.contact_time / 2
    field = on_block.field(time=now)
    y, x, _ = _ground.surface(on_block, now, 1.0)
    assert y == pytest.approx(-y[::-1]) and np.all(np.diff(y) > 0.0)
    edge = np.argmax(field.radius)
    inside = np.abs(field.y[edge]) < 0.8 * field.contact_half_width
    inside &= np.abs(field.angle) < 1.0
    surface = np.interp(field.y[edge, inside], y, x[0])
    assert inside.sum() > 10 and np.abs(surface - field.x[edge, inside]).max() < 0.01
    assert np.interp(0.9, y, x[0]) - np.interp(0.9, field.y[edge, 90:150], field.x[edge, 90:150]) > 0.05
    assert np.abs(_ground.surface(on_block, 0.0, 1.0)[1]).max() < 1e-12


def test_ledger_shows_what_the_half_space_took(on_block, closed):
    ax = stoss.plot.ledger(on_block)
    assert ax.get_legend().get_texts()[-1].get_text() == "half-space"
    waves = on_block.mode_energies["body"] == 1
    heights = [bar.get_height() for bar in ax.patches]
    assert max(heights) == pytest.approx(on_block.mode_energies["after"][waves].sum())
    with pytest.raises(stoss.InvalidInput, match="a half-space has no modes"):
        stoss.plot.ledger(on_block, of=1)
    rigid = stoss.impact(stoss.Sphere(poisson=0.3, rigid=True), against=stoss.HalfSpace(), speed=0.1, cutoff=12.0)
    assert len(stoss.plot.ledger(rigid).patches) == 1


def test_pictures_have_the_moved_surface(on_block, tmp_path, closed):
    field = on_block.field(time=[0.0, on_block.contact_time / 2])
    for draw in (stoss.plot.sphere, stoss.plot.stress):
        ax = draw(field, frame=1)
        deepest = max(float(line.get_xdata().max()) for line in ax.lines if len(line.get_xdata()) == 512)
        assert deepest == pytest.approx(field.x[1].max(), abs=0.01)
        assert ax.get_xlim()[1] > deepest
    ax = stoss.plot.sequence(on_block, count=3)
    assert sum(len(line.get_xdata()) == 512 for line in ax.lines) == 3
    stoss.animate(on_block, tmp_path / "a.gif", frames=3)
    assert (tmp_path / "a.gif").stat().st_size > 1000


def test_pictures_show_both(pair, closed, tmp_path):
    axes = stoss.plot.disk(pair.field(time=0.5 * pair.contact_time))
    left, right = axes.get_xlim()
    assert left < -1.9 and right > 3.9
    assert len(axes.collections) == 2  # two grids, and no wall
    behind = stoss.plot.disk(pair.field(time=0.5 * pair.contact_time, of=1))
    for one, other in zip(axes.collections, behind.collections):
        assert all(np.array_equal(a, b) for a, b in zip(one.get_segments(), other.get_segments()))
    colours = stoss.plot.stress(pair.field(time=0.5 * pair.contact_time, radius=np.linspace(0, 1, 9)))
    assert len(colours.collections) == 2
    assert stoss.plot.velocity(pair.trajectory()).get_ylabel() == "velocity of approach / c"
    rows = stoss.plot.sequence(pair, count=4, columns=2)
    assert len(rows.collections) == 8 and not rows.patches
    points = np.concatenate([segment for grid in rows.collections for segment in grid.get_segments()])
    (low, high), (bottom, top) = rows.get_xlim(), rows.get_ylim()
    assert low < points[:, 0].min() and points[:, 0].max() < high
    assert bottom < points[:, 1].min() and points[:, 1].max() < top
    heights = [sorted(bar.get_height() for group in stoss.plot.ledger(pair, of=of).containers for bar in group)
               for of in (0, 1)]  # fmt: skip
    strongest = [pair.mode_energies["after"][pair.mode_energies["body"] == of].max() for of in (0, 1)]
    assert [each[-1] for each in heights] == strongest
    for quantity in (None, "von_mises"):
        stoss.animate(pair, tmp_path / "pair.gif", frames=3, quantity=quantity)
        assert (tmp_path / "pair.gif").stat().st_size > 3000


def test_pictures_name_degrees_and_units(bounce, closed, tmp_path):
    modes = stoss.modes(BALL, cutoff=10)
    uneven = stoss.impact(BALL, against=stoss.Sphere(poisson=0.2, radius=2, young=3, density=0.7), speed=0.1, cutoff=12)
    assert stoss.plot.ledger(bounce).get_xlabel() == "degree n" == stoss.plot.spectrum(modes).get_xlabel()
    assert stoss.plot.force(bounce.trajectory()).get_ylabel() == "force F / (mc²/R)"
    assert stoss.plot.half_width(bounce.trajectory()).get_ylabel() == "contact radius / R"
    points = {"radius": np.linspace(0, 1, 9), "angle": np.linspace(-np.pi, np.pi, 33)}
    field = uneven.field(time=uneven.contact_time / 2, **points)
    for quantity in ("von_mises", "principal_difference", "fringes"):
        assert len(stoss.plot.stress(field, quantity=quantity).collections) == 2  # of both
    assert stoss.plot.sphere(field).get_xlabel() == "x / R"
    assert len(stoss.plot.sequence(bounce, count=3).texts) == 3
    stoss.animate(bounce, tmp_path / "ball.gif", frames=3)
    assert (tmp_path / "ball.gif").stat().st_size > 1000
    assert stoss.plot.restitution(stoss.restitution(BALL, speed=[0.1, 0.2])).get_legend() is not None


def test_shape_of_a_mode_is_that_of_its_polynomial(closed):
    modes = stoss.modes(BALL, cutoff=3)
    ax = stoss.plot.mode_shape(modes, order=2, index=0, amplitude=0.1)
    x, y = ax.collections[0].get_segments()[5].T  # the surface, from −π to π
    front, side, between = 96, 144, 120  # 0, π/2, π/4
    k = modes.find(2, 0)
    ratio = modes.tangential[k] / modes.radial[k]
    moved = x[front] - 1.0
    assert abs(moved) > 0.05
    assert y[side] - 1.0 == pytest.approx(-0.5 * moved, rel=1e-9)  # P_2(0)
    half = math.sqrt(0.5)
    assert half * (x[between] + y[between]) - 1.0 == pytest.approx(0.25 * moved, rel=1e-9)  # P_2(cos π/4)
    assert half * (y[between] - x[between]) == pytest.approx(-1.5 * ratio * moved, rel=1e-9)  # its derivative
