"""stoss quasistatic: against closed forms, and against an integration of the motion step by step."""

import json
import math

import pytest
from conftest import number

NU = 0.33
IMPACT = f"quasistatic --body disk --poisson {NU} --speed"
CONTACT = f"quasistatic --body disk --poisson {NU} --compression"
STEEL = "quasistatic --body disk --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01"
BAR_SPEED = math.sqrt(2.1e11 / 7850)
# Scale and offset of δ = F (ln(scale/F) − offset).
LAWS = {"center": (1.0, 0.25 * (1 + NU)), "diameter": (4.0, 1.0)}


def energy(law, force):
    scale, offset = LAWS[law]
    return force**2 * (0.5 * math.log(scale / force) - 0.5 * offset - 0.25)


def from_turn(law, force, duration, steps=4000):
    """(time, F, velocity) from the turning point on by Runge and Kutta's method: δ̈ = −F, Ḟ = δ̇ / (dδ/dF)."""
    scale, offset = LAWS[law]
    h = duration / steps

    def rate(state):
        f, w = state
        return (w / (math.log(scale / f) - offset - 1), -f) if f > 0 else (0.0, 0.0)

    state, path = (force, 0.0), [(0.0, force, 0.0)]
    for i in range(1, steps + 1):
        k1 = rate(state)
        k2 = rate([x + 0.5 * h * k for x, k in zip(state, k1)])
        k3 = rate([x + 0.5 * h * k for x, k in zip(state, k2)])
        k4 = rate([x + h * k for x, k in zip(state, k3)])
        state = tuple(x + h / 6 * (a + 2 * b + 2 * c + d) for x, a, b, c, d in zip(state, k1, k2, k3, k4))
        path.append((i * h, *state))
    return path


def pulse(path, omega):
    """∫F cos ωt dt from the turning point on, by Simpson's rule."""
    values = [max(force, 0.0) * math.cos(omega * time) for time, force, _ in path]
    inner = 4 * sum(values[1:-1:2]) + 2 * sum(values[2:-1:2])
    return (values[0] + inner + values[-1]) * path[1][0] / 3


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("speed", [1e-100, 1e-12, 1e-5, 0.01, 0.1])
def test_energy_is_conserved(stoss, law, speed):
    (row,) = stoss.data(f"{IMPACT} {speed} --law {law}")
    scale, offset = LAWS[law]
    force = number(row, "max_force")
    assert number(row, "speed") == speed and number(row, "poisson") == NU
    assert (force / speed) ** 2 * (math.log(scale / force) - offset - 0.5) == pytest.approx(1, rel=1e-12)
    assert number(row, "max_compression") == pytest.approx(force * (math.log(scale / force) - offset), rel=1e-12)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("speed", [1e-12, 1e-4, 0.05])
def test_motion_step_by_step(stoss, law, speed):
    document = json.loads(stoss.run(f"{IMPACT} {speed} --law {law} --cutoff 12 --format json").stdout)
    (record,) = document["records"]
    path = from_turn(law, record["max_force"], 0.5 * record["contact_time"])
    # After half the contact time the disk leaves the wall as fast as it came.
    assert path[-1][2] == pytest.approx(-speed, rel=1e-6)
    # F ends with a logarithm in time, which costs the last steps digits.
    assert path[-1][1] == pytest.approx(0, abs=5e-5 * record["max_force"])
    for mode in document["modes"]:
        assert mode["amplitude"] == pytest.approx(2 * pulse(path, mode["omega"]) / speed, abs=4e-6)


def test_contact_time_is_its_series(stoss):
    for row in stoss.data(f"{IMPACT} log:1e-100:1e-4:13"):
        v, a = number(row, "speed"), 10.0
        for _ in range(100):
            a = math.log(1 / v) - 0.25 * (3 + NU) + 0.5 * math.log(a)
        series = math.pi * math.sqrt(a) * (1 + math.log(2) / (2 * a) + 0.0104 / a**2)
        assert number(row, "contact_time") == pytest.approx(series, rel=0.5 / a**3)
        assert number(row, "max_force") == pytest.approx(v / math.sqrt(a), rel=1e-12)


def test_modes_have_the_lost_energy(stoss):
    document = json.loads(stoss.run(f"{IMPACT} 1e-4 --cutoff 20 --format json").stdout)
    (record,) = document["records"]
    known = {(mode["order"], mode["index"]): mode for mode in stoss.data(f"modes --body disk --poisson {NU} --cutoff 20")}
    assert len(document["modes"]) == record["modes"] == len(known)
    for mode in document["modes"]:
        at_edge = float(known[str(mode["order"]), str(mode["index"])]["radial"])
        assert mode["after"] == pytest.approx((at_edge * mode["amplitude"]) ** 2, rel=1e-12)
    lost = sum(mode["after"] for mode in document["modes"])
    assert record["lost_fraction"] == pytest.approx(lost, rel=1e-12)
    change = 7 * record["kinetic_share"]
    assert record["lost_fraction_error"] == pytest.approx(change * (2 * math.sqrt(lost) + change), rel=1e-9)


def test_estimate_is_near_the_full_solution(stoss):
    (full,) = stoss.data(f"restitution --body disk --poisson {NU} --speed 1e-6")
    (row,) = stoss.data(f"{IMPACT} 1e-6")
    assert abs(number(row, "lost_fraction") - number(full, "lost_fraction")) < number(row, "lost_fraction_error")
    for name, share in (("contact_time", 0.02), ("max_compression", 0.02), ("max_force", 0.02)):
        assert number(row, name) == pytest.approx(number(full, name), rel=share)


def test_higher_cutoff_adds_little(stoss):
    low, high = (number(stoss.data(f"{IMPACT} 1e-3 --cutoff {cutoff}")[0], "lost_fraction") for cutoff in (60, 120))
    assert 0 < high - low < 5e-4


@pytest.mark.parametrize("law", LAWS)
def test_static_compression(stoss, law):
    scale, offset = LAWS[law]
    table = stoss.data(f"{CONTACT} log:1e-12:0.03:7 --law {law}")
    assert number(table[0], "compression") == 1e-12 and number(table[-1], "compression") == 0.03
    for row in table:
        force = number(row, "force")
        assert number(row, "compression") == pytest.approx(force * (math.log(scale / force) - offset), rel=1e-13)
        assert number(row, "energy") == pytest.approx(energy(law, force), rel=1e-13)
        assert number(row, "half_width") == pytest.approx(2 * math.sqrt(force), rel=1e-14)


def test_exact_contact_differs_as_the_manual_says(stoss):
    # docs/theory/quasistatic.md, "Static contact": the law of the centre is 0.113 % and 0.583 % too great.
    for row, more in zip(stoss.data(f"{CONTACT} 0.01,0.03"), (0.00113, 0.00583)):
        error = number(row, "static_force_error")
        assert 0 < error < 1e-4 * number(row, "static_force")
        assert number(row, "force") / number(row, "static_force") - 1 == pytest.approx(more, abs=2e-5)
    # Its next term is (3 + 1.5ν)F².
    (row,) = stoss.data(f"{CONTACT} 1e-4")
    f, exact = number(row, "force"), number(row, "static_force")
    slope = math.log(1 / f) - 0.25 * (1 + NU) - 1
    error = number(row, "static_force_error")
    assert f - exact == pytest.approx((3 + 1.5 * NU) * f**2 / slope, rel=0.02, abs=2 * error)


def test_si(stoss):
    (row,) = stoss.data(f"{STEEL} --speed 5")
    force = math.pi * 0.01 * 2.1e11
    assert number(row, "speed_si") == pytest.approx(5, rel=1e-14)
    assert number(row, "speed") == pytest.approx(5 / BAR_SPEED, rel=1e-14)
    scales = {"contact_time": 0.01 / BAR_SPEED, "max_compression": 0.01, "max_force": force}
    for name, scale in scales.items():
        assert number(row, name + "_si") == pytest.approx(number(row, name) * scale, rel=1e-14)
    (row,) = stoss.data(f"{STEEL} --compression 1e-4")
    assert number(row, "compression") == pytest.approx(0.01, rel=1e-14)
    scales = {"force": force, "energy": force * 0.01, "half_width": 0.01, "static_force": force, "compression": 0.01}
    for name, scale in scales.items():
        assert number(row, name + "_si") == pytest.approx(number(row, name) * scale, rel=1e-14)
    assert {"speed_si[m/s]", "contact_time_si[s]"} <= set(stoss.data(f"{STEEL} --speed 1")[0])
    assert {"force_si[N/m]", "energy_si[J/m]", "half_width_si[m]", "static_force_si_error[N/m]"} <= set(row)


def test_plane_strain_is_another_poisson_number(stoss):
    c = math.sqrt(1e10 / (1 - 0.25**2) / 2500)
    solid = "quasistatic --body disk --poisson 0.25 --young 1e10 --density 2500 --radius 1 --plane strain"
    (strain,) = stoss.data(f"{solid} --speed {0.001 * c!r}")
    (plane,) = stoss.data(f"quasistatic --body disk --poisson {0.25 / 0.75!r} --speed 0.001")
    assert number(strain, "lost_fraction") == pytest.approx(number(plane, "lost_fraction"), rel=1e-9)
