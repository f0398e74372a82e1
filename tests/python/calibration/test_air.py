"""Flights of a sphere in air: limits that are known, and that a flight is a rise and a fall."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from stoss.calibration._air import DENSITY, GRAVITY, VISCOSITY, Flight, drag_coefficient

GOLF = Flight(radius=0.02135, density=1130.0, air=True)


def test_without_air_energy_is_kept():
    free = Flight(0.02, 1000.0, False)
    assert free.after_fall(1.0) == free.before_rise(1.0) == pytest.approx(np.sqrt(2 * GRAVITY), rel=1e-14)
    up, down = free.of_flight(0.9)
    assert up == pytest.approx(down, rel=1e-12)
    assert up == pytest.approx(0.45 * GRAVITY, rel=1e-12)


@pytest.mark.parametrize(("reynolds", "known"), [(1.0, 27.3), (100.0, 1.09), (1e4, 0.41), (1e5, 0.47)])
def test_drag_is_that_of_the_standard_curve(reynolds, known):
    """Values of the standard drag curve (Clift, Grace and Weber, Bubbles, Drops and Particles, table 5.1), to 6 %."""
    assert drag_coefficient(reynolds) == pytest.approx(known, rel=0.06)


@pytest.mark.long
def test_a_grain_falls_at_the_speed_of_stokes():
    grain = Flight(radius=5e-6, density=2500.0, air=True)
    viscosity = VISCOSITY * DENSITY
    stokes = 2.0 / 9.0 * (grain.density - DENSITY) * GRAVITY * grain.radius**2 / viscosity
    assert grain.after_fall(1.0) == pytest.approx(stokes, rel=0.01)


def test_a_ball_reaches_its_terminal_speed():
    ball = Flight(radius=0.02, density=84.0, air=True)  # table tennis
    fastest = ball.after_fall(100.0)
    assert ball.drag(fastest) == pytest.approx(ball.weight, rel=1e-6)


def test_heights_and_times_tell_the_same():
    up, down = GOLF.of_flight(1.2)
    assert down < GRAVITY * 0.6 < up

    def motion(_, state):
        return [state[1], -GOLF.weight - np.sign(state[1]) * GOLF.drag(abs(state[1]))]

    flight = solve_ivp(motion, (0.0, 1.2), [0.0, up], rtol=1e-10, atol=1e-12, dense_output=True)
    assert flight.y[0, -1] == pytest.approx(0.0, abs=1e-7)
    assert -flight.y[1, -1] == pytest.approx(down, rel=1e-7)
    top = flight.sol(np.linspace(0, 1.2, 20001))[0].max()
    assert GOLF.before_rise(top) == pytest.approx(up, rel=1e-7)
    assert GOLF.after_fall(top) == pytest.approx(down, rel=1e-7)


def test_drag_takes_what_it_does_of_a_light_ball():
    """To first order in the drag: v² = 2gh (1 ∓ c h), c = 3 ρₐ c_d / 8 ρ R, of a constant c_d."""
    ball = Flight(radius=0.05, density=20000.0, air=True)
    height = 1.0
    speed = ball.after_fall(height)
    share = 0.375 * DENSITY / ball.density * float(drag_coefficient(ball.reynolds(speed))) / ball.radius * height
    lost = 1.0 - speed**2 / (2.0 * ball.weight * height)
    assert lost == pytest.approx(share, rel=0.1)
