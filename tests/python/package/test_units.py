"""With a material all is in SI: the same as without one in ratios to the first body, for every kind and every question."""

import numpy as np
import pytest
import stoss



def viscous(name, loss_time):
    """A material of the list that loses energy by a loss time, which bodies without a material have too."""
    its = stoss.materials[name]
    return stoss.Material(young=its.young, poisson=its.poisson, density=its.density, loss_time=loss_time)


STEEL, GLASS, PVB = viscous("structural steel", 5e-9), viscous("glass", 1.6e-8), viscous("PVB", 1.3e-6)
BALL, DISK = stoss.Sphere(radius=5e-3, material=STEEL), stoss.Disk(radius=0.01, material=STEEL, loss_time=0)
STRAINED = stoss.Disk(radius=0.01, material=STEEL, plane="strain")
ROD = stoss.Rod(length=0.2, area=1e-4, material=STEEL, loss_time=0)
PANE, FILM = stoss.Layer(thickness=4e-3, material=GLASS), stoss.Layer(thickness=0.8e-3, material=PVB)
ENCOUNTERS = {
    "sphere": (BALL, None), "same": (BALL, "same"), "spheres": (BALL, stoss.Sphere(radius=8e-3, material=GLASS)),
    "block": (BALL, stoss.HalfSpace(material=GLASS)), "pane": (BALL, stoss.Plate(thickness=0.01, material=GLASS)),
    "laminate": (BALL, stoss.Plate(layers=[PANE, FILM, PANE], loss_time=0)), "disk": (DISK, None),
    "disks": (STRAINED, stoss.Disk(radius=0.02, material=GLASS, plane="strain")),
    "half-plane": (STRAINED, stoss.HalfPlane(material=GLASS, plane="strain")),
    "strip": (DISK, stoss.Strip(thickness=0.03, material=GLASS)),
    "rods": (ROD, stoss.Rod(length=0.5, area=2e-4, material=GLASS, loss_time=0)),
}  # fmt: skip
LENGTHS, LIKE_THE_FIRST = ("radius", "thickness", "length"), ("young", "density", "area")
pytestmark = pytest.mark.filterwarnings("ignore::stoss.StossWarning")


def in_ratios(one, first):
    """The same body without a material, in ratios to the first."""
    if one in (None, "same"):
        return one
    numbers = {"poisson": one.poisson} if hasattr(one, "poisson") else {}
    size = first.length if isinstance(first, stoss.Rod) else first.radius
    numbers |= {name: getattr(one, name) / size for name in LENGTHS if hasattr(one, name)}
    numbers |= {name: getattr(one, name) / getattr(first, name) for name in LIKE_THE_FIRST if hasattr(one, name)}
    if isinstance(one, stoss.Layer):
        return stoss.Layer(**numbers)
    if getattr(one, "layers", None):
        return stoss.Plate(layers=[in_ratios(each, first) for each in one.layers], loss_time=one.loss_time)
    return type(one)(**numbers, loss_time=one.loss_time / first.scales.time)


def same(result, other):
    """All columns that have no unit of their own."""
    columns, others = result._columns(), other._columns()
    assert others and len(result._units_of(columns)) >= len(other._units_of(others))
    for name in set(others) - {"speed"}:
        if others[name].dtype.kind == "f":
            np.testing.assert_allclose(columns[name], others[name], rtol=1e-6, atol=1e-9, err_msg=name)


@pytest.mark.parametrize("name", ENCOUNTERS)
def test_every_kind(name):
    first, met = ENCOUNTERS[name]
    speed = np.array([0.002, 0.01])
    result = stoss.restitution(first, against=met, speed=speed * first.scales.speed, tolerance=0.05)
    assert result.speed_si == pytest.approx(speed * first.scales.speed, rel=1e-14)
    same(result, stoss.restitution(in_ratios(first, first), against=in_ratios(met, first), speed=speed, tolerance=0.05))


BARE = in_ratios(BALL, BALL)
V, T, W = BALL.scales.speed, BALL.scales.time, BALL.scales.frequency
SPEED = {"speed": ((0.002, 0.01), V)}
QUESTIONS = {
    "impact": (stoss.impact, {"speed": (0.01, V)}, {"cutoff": 6}),
    "bounce": (stoss.bounce, {"speed": (0.01, V), "gravity": (1e-3, V / T), "decay_time": (30.0, T)}, {"count": 3,
     "cutoff": 6}),
    "flights": (stoss.bounce, {"speed": (0.01, V), "flight_time": (30.0, T)}, {"count": 3, "cutoff": 6}),
    "oblique": (stoss.oblique, {"speed": (0.01, V), "tangential": (0.004, V), "spin": (0.003, W)}, {"friction": 0.1}),
    "oblique_impact": (stoss.oblique_impact, {"speed": (0.01, V), "tangential": (0.004, V), "spin": (0.003, W)},
                       {"friction": 0.1, "cutoff": 6}),
    "distribution": (stoss.restitution_distribution, {"speed": (0.01, V)}, {"temperature": 0.01, "samples": 2}),
    "slow_impact": (stoss.quasistatic.slow_impact, SPEED, {}),
    "rayleigh": (stoss.quasistatic.rayleigh, SPEED, {"cutoff": 6}),
}  # fmt: skip


@pytest.mark.parametrize("name", QUESTIONS)
def test_every_question(name):
    ask, with_units, others = QUESTIONS[name]
    own = {each: value for each, (value, _) in with_units.items()}
    si = {each: np.multiply(value, unit).tolist() for each, (value, unit) in with_units.items()}
    result, other = ask(BALL, **si, **others), ask(BARE, **own, **others)
    for each in with_units:
        if hasattr(result, each):
            assert getattr(result, each) == pytest.approx(getattr(other, each), rel=1e-12), each
    same(result, other)


def test_every_function():
    """They take speeds in m/s, and give them."""
    made = {}
    bare = stoss.Sphere(poisson=BALL.poisson)
    ball = stoss.Sphere(radius=5e-3, material=STEEL, loss_time=0)
    for one, unit in ((ball, V), (bare, 1.0)):
        speed = (0.002 * unit, 0.01 * unit)
        function = stoss.restitution_function(one, speed=speed, error=1e-2)
        pairs = stoss.pair_table(one, speed=speed, ratio=(1, 1.3), error=2e-2)
        rule = stoss.collision_rule(one, speed=speed, error=0.05, tolerance=0.1)
        after, along = rule(0.005 * unit, 0.002 * unit, 0.1)
        velocity, spin, *_ = rule.collide([0.005 * unit, 0.002 * unit, 0], [0, 0, 1e-3 * W ** (unit > 1)], [1, 0, 0],
         friction=0.1)
        fit = stoss.fit(one, law="linear", speed=speed)
        made[unit] = [
            function(0.005 * unit), pairs(0.005 * unit, 1.2), stoss.atlas(one, speed=0.005 * unit).restitution, after,
            along / unit, *(velocity / unit), *(spin / (W if unit > 1 else 1)), fit.misfit["restitution"].maximum,
        ]  # fmt: skip
        assert function.range == pytest.approx(speed, rel=1e-14)
    assert made[V] == pytest.approx(made[1.0], rel=1e-6, abs=1e-9)
