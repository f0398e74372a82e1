"""Each law against closed forms, and against an integration that knows only its force."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest
from scipy import integrate, optimize

from stoss._errors import InvalidInput
from stoss.laws._law import Impacts, Pair, Spring, along_normal
from stoss.laws._power import HuntCrossley, Linear, Mujoco, Tsuji, Viscoelastic
from stoss.laws._rules import Table, Thornton, Walton

PAIR = Pair(2e-3, 4e-3, 8e-3, 8e-3, 2500.0, 2500.0)
PULLS, PUSHES = Spring(tension=True), Spring()
SPEEDS = np.geomspace(1e-3, 3.0, 5)
SLIDING = np.array([0.5, 1.0, 2.0, 3.0, 4.0, 6.0])

# A law, its constants, and its force by them.
FORCES = {
    Linear: ((4e6, 30.0), lambda k, g, x, u: k * x + g * u),
    Mujoco: ((4e6, 30.0), lambda k, g, x, u: k * x + g * u),
    Tsuji: ((2e9, 0.3 * np.sqrt(2e9 * 2e-3)), lambda k, g, x, u: k * x**1.5 + g * x**0.25 * u),
    Viscoelastic: ((2e9, 2e4), lambda k, g, x, u: k * x**1.5 + g * x**0.5 * u),
    HuntCrossley: ((2e9, 6e8), lambda k, g, x, u: k * x**1.5 * (1 + g / k * u)),
}


def made(law, spring, ratio=None, friction=0.0):
    return law(PAIR, spring, friction, *FORCES[law][0], ratio)


def integrated(force, mass, speed, pulls):
    """ε and contact time of m x″ = −F, until the bodies part or, if they do not pull, the force is gone."""

    def parts(t, state):
        return state[0]

    def released(t, state):
        return force(max(state[0], 0.0), state[1]) if state[1] < 0 else 1.0

    end = parts if pulls else released
    end.terminal, end.direction = True, -1
    start = 1e-9 * speed * 1e-5  # a little overlap, where powers of it have derivatives
    scale = optimize.brentq(lambda x: 0.5 * mass * speed**2 - force(x, 0.0) * x / 2, 1e-12, 1.0)
    solved = integrate.solve_ivp(
        lambda t, state: (state[1], -force(max(state[0], 0.0), state[1]) / mass), (0, 30 * scale / speed),
        (start, speed), method="DOP853", events=end, rtol=1e-10, atol=(1e-10 * scale, 1e-10 * speed),
        max_step=0.02 * scale / speed,
    )  # fmt: skip
    return -solved.y_events[0][0][1] / speed, solved.t_events[0][0]


@pytest.mark.parametrize("pulls", [True, False])
@pytest.mark.parametrize("law", FORCES)
def test_laws_agree_with_an_integration_of_their_forces(law, pulls):
    (k, g), force = FORCES[law]
    its = made(law, PULLS if pulls else PUSHES)
    epsilon, times = its.restitution(SPEEDS), its.contact_time(SPEEDS)
    for speed, one, time in zip(SPEEDS[::2], epsilon[::2], times[::2]):
        # The force of Hunt and Crossley is gone only where the bodies part.
        expected = integrated(lambda x, u: force(k, g, x, u), PAIR.mass, speed, pulls or law is HuntCrossley)
        assert (one, time) == pytest.approx(expected, rel=1e-4)


@pytest.mark.parametrize("pulls", [True, False])
@pytest.mark.parametrize("zeta", [1e-7, 0.1, 0.7, 0.999999, 1.0, 1.3, 5.0])
def test_the_closed_form_of_a_linear_spring(zeta, pulls):
    """Its loss is exact however small it is, and goes on where the dashpot is critical."""
    spring = PULLS if pulls else PUSHES
    law = Linear(PAIR, spring, 0.0, 4e6, 2 * zeta * np.sqrt(4e6 * PAIR.mass), None)
    if pulls and zeta > 0.99:  # it hardly parts, or never
        assert law.restitution(SPEEDS) == pytest.approx(0.0, abs=1e-12)
        assert zeta < 1 or np.all(np.isinf(law.contact_time(SPEEDS)))
        return
    stepped = along_normal(1.0, 0.0, np.array([2 * zeta]), spring)
    assert law.restitution(SPEEDS) == pytest.approx(stepped.restitution[0], abs=2e-6)
    assert law.contact_time(SPEEDS) * np.sqrt(4e6 / PAIR.mass) == pytest.approx(stepped.duration[0], rel=1e-4)
    if zeta < 1e-6:
        assert 1 - law.restitution(SPEEDS) == pytest.approx(np.pi * zeta, rel=1e-6)


@pytest.mark.parametrize("zeta", [1e-4, 0.01, 0.3])
def test_linear_and_tsuji_have_the_closed_form(zeta):
    mass, k = PAIR.mass, 1e7
    root, omega = np.sqrt(1 - zeta**2), np.sqrt(k / mass)
    angles = {PULLS: np.pi, PUSHES: np.pi - np.arctan2(2 * zeta * root, 1 - 2 * zeta**2)}
    for spring, angle in angles.items():
        linear = Linear(PAIR, spring, 0.0, k, 2 * zeta * np.sqrt(mass * k), None)
        assert linear.restitution(SPEEDS) == pytest.approx(np.exp(-zeta * angle / root), abs=2e-6)
        assert linear.contact_time(SPEEDS) == pytest.approx(angle / root / omega, rel=1e-5)
        tsuji = Tsuji(PAIR, spring, 0.0, k, np.sqrt(5) * zeta * np.sqrt(mass * k), None)
        assert tsuji.restitution(SPEEDS) == pytest.approx(np.exp(-zeta * angle / root), abs=5e-5)
        assert tsuji.alpha == pytest.approx(np.sqrt(5) * zeta)
        assert tsuji.nominal == pytest.approx(np.exp(-zeta * np.pi / root))


def test_viscoelastic_has_the_pade_approximant_and_the_first_order():
    lossy = Viscoelastic(PAIR, PUSHES, 0.0, 2e9, 1.5 * 2e9 * 1e-6, None)
    assert lossy.loss_time == pytest.approx(1e-6)
    speeds = np.geomspace(1e-6, 100.0, 9)
    assert lossy.pade(speeds) == pytest.approx(lossy.restitution(speeds), abs=1e-3)
    x = 1.5 * 1e-6 * (2e9 / PAIR.mass) ** 0.4 * speeds[:2] ** 0.2
    second = 0.6 * 1.153449**2
    assert 1 - lossy.restitution(speeds[:2]) == pytest.approx(1.153449 * x - second * x**2, rel=2e-3)


def test_hunt_and_crossley_obey_their_equation():
    law = made(HuntCrossley, PUSHES)
    d, epsilon = law.hysteresis * SPEEDS, law.restitution(SPEEDS)
    assert d * (1 + epsilon) == pytest.approx(np.log((1 + d) / (1 - epsilon * d)), rel=1e-5)


def test_thornton_has_his_formula_and_an_integration():
    law = Thornton(PAIR, PUSHES, 0.0, 2e9, 0.05)
    speeds = np.array([0.01, 0.05, 0.06, 0.2, 1.0, 5.0])
    assert law.restitution(speeds[:2]) == pytest.approx(1.0)
    r = (0.05 / speeds[2:]) ** 2
    root = np.sqrt(6 / 5 - r / 5)
    printed = np.sqrt(6 * np.sqrt(3) / 5) * np.sqrt(1 - r / 6) * (np.sqrt(r) / (np.sqrt(r) + 2 * root)) ** 0.25
    assert law.restitution(speeds[2:]) == pytest.approx(printed, rel=1e-12)
    hertz = 2.9432750 * (1.25 * PAIR.mass / 2e9) ** 0.4 * speeds[:2] ** -0.2
    assert law.contact_time(speeds[:2]) == pytest.approx(hertz, rel=1e-6)
    # Far beyond the yield speed: the way in and out, each by itself.
    overlap = (1.25 * PAIR.mass * 0.05**2 / 2e9) ** 0.4  # at yield

    def force(x, way):
        y = x / overlap
        return 2e9 * overlap**1.5 * (y**1.5 if y < 1 else 1.5 * y - 0.5)

    def turns(t, state):
        return state[1]

    turns.terminal = True
    into = integrate.solve_ivp(
        lambda t, s: (s[1], -force(max(s[0], 0), 0) / PAIR.mass), (0, 1e-2), (0, 1.0), events=turns, rtol=1e-10,
        atol=1e-14, max_step=1e-6,
    )  # fmt: skip
    deepest, peak = into.y_events[0][0][0], force(into.y_events[0][0][0], 0)
    radius = PAIR.radius * (deepest / overlap) ** 1.5 / (peak / (2e9 * overlap**1.5))
    flat = PAIR.radius * deepest / radius  # a²/R of the flatter sphere
    out = 2.9432750 / 2 * flat / law.restitution(np.array([1.0]))[0]
    assert law.contact_time(np.array([1.0]))[0] == pytest.approx(into.t_events[0][0] + out, rel=1e-5)


def test_springs_along_the_surface():
    # k_t = 2/7 k_n: the motion along the surface is that along the normal, while nothing slides.
    elastic = Linear(PAIR, PULLS, 0.3, 1e7, 1e-9, 2 / 7)
    assert elastic.tangential_restitution(SPEEDS, np.array([0.1, 1.0])) == pytest.approx(1.0, abs=1e-3)
    for law in set(FORCES) - {Mujoco}:  # what is so fast that it slides all the time
        its = made(law, PUSHES, 0.7, 0.3)
        sliding = 3.5 * (1 + its.restitution(SPEEDS)[:, None]) / 60.0 - 1
        assert its.tangential_restitution(SPEEDS, np.array([60.0])) == pytest.approx(sliding, abs=1e-4)
    # The same spring of displacement or of force is one where its stiffness is constant.
    other = dataclasses.replace(elastic, spring=Spring(tension=True, rising=True), tangential_ratio=0.9)
    same = dataclasses.replace(elastic, tangential_ratio=0.9)
    a, b = (each.tangential_restitution(SPEEDS[:1], SLIDING) for each in (other, same))
    assert a == pytest.approx(b, abs=1e-9)


def test_springs_are_those_of_the_study_of_oblique_impacts():
    """docs/results/oblique/dem.csv: elastic spheres of ν = 0.3, integrated by a program in C++."""
    lines = (Path(__file__).parents[3] / "docs/results/oblique/dem.csv").read_text(encoding="utf-8").splitlines()
    rows = [line.split(",") for line in lines if line[0] != "#"][1:]
    mindlin = 1.4 / 1.7
    k = 1e9
    laws = {
        "history": Tsuji(PAIR, PULLS, 0.3, k, 1e-9, mindlin),
        "force": Tsuji(PAIR, Spring(tension=True, rising=True), 0.3, k, 1e-9, mindlin),
        "linear_1": Linear(PAIR, PULLS, 0.3, k, 1e-9, 1.0),
        "linear_2/7": Linear(PAIR, PULLS, 0.3, k, 1e-9, 2 / 7),
    }
    for name, law in laws.items():
        values = {float(x): float(value) for each, x, value in rows if each == name}
        x = np.array([0.5, 1.0, 2.0, 3.0, 5.0, 7.0])
        found = law.tangential_restitution(SPEEDS[:1], x)[0]
        assert found == pytest.approx([values[each] for each in x], abs=2e-3), name


def impacts_by(law, friction):
    """What a law itself says, as if stoss had said it."""
    sliding = SLIDING if friction else np.zeros(0)
    along = law.tangential_restitution(SPEEDS, sliding) if friction else np.zeros((SPEEDS.size, 0))
    times = law.contact_time(SPEEDS)
    times = np.ones_like(SPEEDS) if times is None else times
    return Impacts(PAIR, SPEEDS, law.restitution(SPEEDS), times, friction, sliding, along)


@pytest.mark.parametrize("law, spring", zip(FORCES, [PULLS, PUSHES, Spring(rising=True), PUSHES, PULLS]))
def test_a_fit_finds_the_constants_of_its_own_law(law, spring):
    friction = 0.0 if law is Mujoco else 0.3
    its = made(law, spring, 0.8 if friction else None, friction)
    found = law.fitted(impacts_by(its, friction), spring, (0.1, 3.0))
    assert found.constants == pytest.approx(its.constants, rel=1e-3)
    assert list(found.constants) == [name for name in law.UNITS if friction or name != "tangential_ratio"]


@pytest.mark.parametrize("left", [0.001, 0.3])
@pytest.mark.parametrize("law", [Linear, Tsuji])
def test_a_fit_where_little_is_left(law, left):
    """Far from the first order, on which the guess rests: nearly 1, whose logarithm is 0."""
    wanted = dataclasses.replace(impacts_by(made(law, PUSHES), 0.0), restitution=np.full_like(SPEEDS, left))
    assert law.fitted(wanted, PUSHES, (0.1, 3.0)).restitution(SPEEDS) == pytest.approx(left, rel=1e-3)


def test_a_law_that_never_ends_is_refused(monkeypatch):
    """Springs that pull do not part at all where their dashpot is critical, d = 2."""
    monkeypatch.setattr("stoss.laws._power.nearest_to", lambda *_: 2.5)
    wanted = dataclasses.replace(impacts_by(made(Linear, PUSHES), 0.0), restitution=np.zeros_like(SPEEDS))
    with pytest.raises(InvalidInput, match="law: got linear, allowed another one"):
        Linear.fitted(wanted, PULLS, (0.1, 3.0))


def test_fits_of_rules_and_tables():
    rule = Walton(PAIR, PUSHES, 0.3, 0.9, 0.45, 0.01)
    assert Walton.fitted(impacts_by(rule, 0.3), PUSHES, (0.1, 3.0)).constants == pytest.approx(rule.constants)
    yields = Thornton(PAIR, PUSHES, 0.0, 3e9, 0.02)
    found = Thornton.fitted(impacts_by(yields, 0.0), PUSHES, (0.1, 3.0))
    assert found.constants == pytest.approx(yields.constants, rel=1e-5)
    rows = Table(PAIR, PUSHES, 0.0, tuple(SPEEDS), (1.0, 0.9, 0.8, 0.75, 0.7))
    found = Table.fitted(impacts_by(rows, 0.0), PUSHES, (0.1, 3.0))
    assert found.restitution(SPEEDS) == pytest.approx(rows.restitution(SPEEDS))
