"""Half-spaces, half-planes and rigid bodies: SI and ratios, who absorbs the loss, pictures."""

import pickle

import numpy as np
import pytest

import stoss
from stoss.results import _replay

BALL = stoss.Sphere(poisson=0.3)
DISK = stoss.Disk(poisson=0.33)
STEEL = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
GLASS = stoss.Material(young=7e10, poisson=0.23, density=2500)


def test_one_call_in_si():
    curve = stoss.restitution(
        stoss.Sphere(radius=5e-3, material=STEEL), against=stoss.HalfSpace(material=GLASS), speed=[0.1, 1]
    )
    assert abs(curve.lost_fraction[1] - 0.0085314) <= 7.5e-6 + curve.lost_fraction_error[1]
    assert curve.contact_time_si[1] == pytest.approx(46.0e-6, rel=3e-3)
    given = {"poisson": 0.23, "young": 7e10 / 2.1e11, "density": 2500 / 7850}
    ratios = stoss.restitution(BALL, against=stoss.HalfSpace(**given), speed=curve.speed)
    assert ratios.lost_fraction == pytest.approx(curve.lost_fraction, rel=1e-9)


# Without a material sizes are ratios in any units.
def test_no_size_of_the_sphere_matters():
    large = stoss.Sphere(poisson=0.3, radius=7.0, young=4.0, density=0.5)
    found = stoss.restitution(large, against=stoss.HalfSpace(young=8.0, density=1.5), speed=0.05)
    ratios = stoss.restitution(BALL, against=stoss.HalfSpace(young=2.0, density=3.0), speed=0.05)
    assert found.lost_fraction == pytest.approx(ratios.lost_fraction, rel=1e-9)


@pytest.mark.parametrize("plane", ["stress", "strain"])
def test_half_plane_in_si(plane):
    disk = stoss.Disk(radius=0.01, material=STEEL, plane=plane)
    half_plane = stoss.HalfPlane(material=GLASS, plane=plane)
    found = stoss.restitution(disk, against=half_plane, speed=10.0)
    given = {"young": half_plane.young / disk.young, "density": half_plane.density / disk.density}
    ratios = stoss.HalfPlane(poisson=half_plane.poisson, **given)
    other = stoss.restitution(stoss.Disk(poisson=disk.poisson), against=ratios, speed=found.speed)
    assert found.lost_fraction == pytest.approx(other.lost_fraction, rel=1e-9)


def test_half_plane_is_like_each_of_several_disks():
    curve = stoss.restitution(poisson=[0.2, 0.33], against=stoss.HalfPlane(young=2.0), speed=0.1)
    assert curve.against == stoss.HalfPlane(young=2.0)
    for k, poisson in enumerate((0.2, 0.33)):
        one = stoss.restitution(poisson=poisson, against=stoss.HalfPlane(poisson=poisson, young=2.0), speed=0.1)
        assert one.lost_fraction == curve.lost_fraction[k]


@pytest.fixture(scope="module")
def hit():
    return stoss.impact(BALL, against=stoss.HalfSpace(young=0.5), speed=0.1, cutoff=25.0)


def test_impact_its_ledger_and_trajectory(hit):
    assert hit.against == stoss.HalfSpace(poisson=0.3, young=0.5)
    assert hit.translation + hit.vibration + hit.unresolved == pytest.approx(1.0, abs=1e-4)
    waves = hit.mode_energies[hit.mode_energies["body"] == 1]
    assert waves["after"].sum() == pytest.approx(hit.lost_to_second, rel=1e-2)
    path = hit.trajectory()
    total = path.translation + path.vibration + path.stored + path.unresolved
    assert np.abs(total - 1.0).max() < 1e-3
    assert path.center[0] == pytest.approx(-1.0, abs=1e-3)
    again = pickle.loads(pickle.dumps(hit))
    assert again.restitution == hit.restitution and again.against == hit.against
    assert "against HalfSpace(poisson=0.3, young=0.5)" in repr(hit)


# At the foremost points the surfaces of both are one, beyond the contact they part.
def test_ball_and_half_space_touch(hit):
    now = hit.contact_time / 2
    field = hit.field(time=now)
    y, x, _ = _replay.surface(hit, now, 1.0)
    assert y == pytest.approx(-y[::-1]) and np.all(np.diff(y) > 0.0)
    edge = np.argmax(field.radius)
    inside = np.abs(field.y[edge]) < 0.8 * field.contact_half_width
    inside &= np.abs(field.angle) < 1.0
    surface = np.interp(field.y[edge, inside], y, x[0])
    assert inside.sum() > 10 and np.abs(surface - field.x[edge, inside]).max() < 0.01
    assert np.interp(0.9, y, x[0]) - np.interp(0.9, field.y[edge, 90:150], field.x[edge, 90:150]) > 0.05
    assert np.abs(_replay.surface(hit, 0.0, 1.0)[1]).max() < 1e-12


@pytest.mark.parametrize("name", ["HalfSpace(poisson=0.3, young=2)", "HalfSpace()", "HalfPlane(density=3)"])
def test_repr_makes_it_again(name):
    assert repr(eval(name, vars(stoss))) == name


def test_repr_of_a_rigid_one():
    assert repr(stoss.Sphere(poisson=0.3, rigid=True)) == "Sphere(poisson=0.3, rigid=True)"
    assert repr(stoss.Disk(poisson=0.3)) == "Disk(poisson=0.3)"


RIGID = stoss.Sphere(poisson=0.3, rigid=True)
IN_SI = stoss.Sphere(radius=1.0, material=STEEL)


@pytest.mark.parametrize(
    "call, said",
    [
        (lambda: stoss.impact(RIGID, speed=0.1), "against: got HardWall"),
        (lambda: stoss.restitution(RIGID, against="same", speed=0.1), "allowed a body that deforms"),
        (lambda: stoss.restitution(RIGID, against=RIGID, speed=0.1), "allowed a body that deforms"),
        (lambda: stoss.restitution(BALL, against=RIGID, speed=0.1, tolerance=0), "tolerance: got 0"),
        (lambda: stoss.modes(RIGID, cutoff=5), "body: got Sphere"),
        (lambda: stoss.quasistatic.slow_impact(stoss.Disk(poisson=0.3, rigid=True), speed=1e-3), "body: got Disk"),
        (lambda: stoss.restitution(BALL, against=stoss.HalfPlane(), speed=0.1), "a stoss.Sphere or a stoss.ModalBody or a stoss.HalfSpace"),
        (lambda: stoss.restitution(DISK, against=stoss.HalfSpace(), speed=0.1), "a stoss.Disk or a stoss.HalfPlane"),
        (lambda: stoss.impact(stoss.Rod(), against=stoss.HalfSpace(), speed=0.1), "allowed a stoss.Rod"),
        (lambda: stoss.restitution(IN_SI, against=stoss.HalfSpace(), speed=1), "two bodies with a material"),
        (lambda: stoss.restitution(BALL, against=stoss.HalfSpace(material=STEEL), speed=0.1), "or two without"),
        (lambda: stoss.HalfSpace(poisson=0.5), "poisson: got 0.5, allowed -0.95 to 0.4999"),
        (lambda: stoss.HalfSpace(young=0), "young: got 0"),
        (lambda: stoss.HalfSpace(density=float("nan")), "density: got nan"),
        (lambda: stoss.HalfSpace(material=3), "material: got 3"),
        (lambda: stoss.HalfSpace(material=STEEL, poisson=0.2), "none with a material"),
        (lambda: stoss.HalfPlane(plane="strain"), "plane: got 'strain', allowed none without a material"),
        (lambda: stoss.HalfPlane(material=STEEL, plane="flat"), "plane: got 'flat'"),
        (lambda: stoss.HalfPlane(poisson="x"), "poisson: got 'x'"),
        (lambda: stoss.Sphere(poisson=0.3, rigid=1), "rigid: got 1, allowed True or False"),
        (lambda: stoss.restitution(BALL, against=stoss.HalfSpace(young=1e-4), speed=0.1), "young ratio: got"),
        (lambda: stoss.restitution(BALL, against=stoss.HalfSpace(density=1e7), speed=0.1), "density ratio: got"),
        (
            lambda: stoss.impact(RIGID, against=stoss.HalfSpace(), speed=0.1, cutoff=12).field(time=0),
            "a rigid one has no field",
        ),
    ],
)
def test_refusals(call, said):
    with pytest.raises(stoss.InvalidInput) as caught:
        call()
    assert said in str(caught.value) and "allowed" in str(caught.value)


def test_a_half_space_has_no_field_and_no_modes_in_the_ledger(hit):
    with pytest.raises(stoss.InvalidInput, match="a half-space has no field"):
        hit.field(time=0, of=1)
    with pytest.raises(stoss.InvalidInput, match="a half-space has no modes"):
        stoss.plot.ledger(hit, of=1)


def test_ledger_shows_what_the_half_space_took(hit, closed):
    ax = stoss.plot.ledger(hit)
    assert ax.get_legend().get_texts()[-1].get_text() == "half-space"
    waves = hit.mode_energies["body"] == 1
    heights = [bar.get_height() for bar in ax.patches]
    assert max(heights) == pytest.approx(hit.mode_energies["after"][waves].sum())
    rigid = stoss.impact(RIGID, against=stoss.HalfSpace(), speed=0.1, cutoff=12.0)
    assert len(stoss.plot.ledger(rigid).patches) == 1


def test_pictures_have_the_moved_surface(hit, tmp_path, closed):
    field = hit.field(time=[0.0, hit.contact_time / 2])
    for draw in (stoss.plot.sphere, stoss.plot.stress):
        ax = draw(field, frame=1)
        deepest = max(float(line.get_xdata().max()) for line in ax.lines if len(line.get_xdata()) == 512)
        assert deepest == pytest.approx(field.x[1].max(), abs=0.01)
        assert ax.get_xlim()[1] > deepest
    ax = stoss.plot.sequence(hit, count=3)
    assert sum(len(line.get_xdata()) == 512 for line in ax.lines) == 3
    stoss.animate(hit, tmp_path / "a.gif", frames=3)
    assert (tmp_path / "a.gif").stat().st_size > 1000


def test_several_spheres_at_a_half_space_like_each():
    balls = [stoss.Sphere(poisson=0.2), BALL]
    curve = stoss.restitution(balls, against=stoss.HalfSpace(young=2.0), speed=0.1)
    assert curve.against == stoss.HalfSpace(young=2.0)
    for k, ball in enumerate(balls):
        one = stoss.restitution(ball, against=stoss.HalfSpace(poisson=ball.poisson, young=2.0), speed=0.1)
        assert one.lost_fraction == curve.lost_fraction[k]


# Johnson's number for a hard steel sphere that strikes steel (Contact Mechanics, section 11.5), 0.14 m/s.
def test_results_say_where_yielding_begins():
    hard = stoss.Material(young=2.1e11, poisson=0.3, density=7850, yield_strength=1e9)
    block = stoss.HalfSpace(material=hard)
    with pytest.warns(stoss.StossWarning, match="^the ball yields above"):
        curve = stoss.restitution(stoss.Sphere(radius=0.01, material=hard), against=block, speed=[0.1, 0.2])
    assert curve.beyond_yield.tolist() == [False, True]
    assert curve.yield_speed_si[0] == pytest.approx(0.14, abs=0.005)
    # A rigid ball makes the contact stiffer, and does not yield itself: v is proportional to 1/E*².
    rigid = stoss.Sphere(radius=0.01, material=hard, rigid=True)
    assert stoss.quasistatic.yield_speed(rigid, against=block) == pytest.approx(curve.yield_speed_si[0] / 4)
    assert stoss.quasistatic.yield_speed(rigid, against=stoss.HalfSpace(material=GLASS)) is None
    with pytest.raises(stoss.InvalidInput, match="allowed an elastic sphere at a wall"):
        stoss.quasistatic.yield_speed(rigid)


def test_usual_cutoffs_are_those_of_the_core():
    """64 over the time scale √2, and over how long it lasts."""
    normal = stoss.impact(BALL, against=stoss.HalfSpace(), speed=0.1)
    oblique = stoss.oblique_impact(BALL, against=stoss.HalfSpace(), speed=0.1, tangential=0.02, friction=0.1)
    assert normal.cutoff == oblique.cutoff == pytest.approx(32.0, rel=1e-12)
    slow = stoss.impact(BALL, against=stoss.HalfSpace(), speed=1e-4)
    assert slow.cutoff < 10 and slow.modes < 20000
    assert stoss.impact(BALL, speed=0.1).cutoff == stoss.impact(BALL, against="same", speed=0.1).cutoff == 50.0
