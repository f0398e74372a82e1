"""The examples of bodies by their modes: what they print agrees with direct calls, and with
docs/understand/findings/any_body.md."""

from pathlib import Path

import numpy as np
import pytest

import stoss

EXAMPLES = Path(__file__).parents[3] / "examples"
PAGE = (EXAMPLES.parent / "docs/understand/findings/any_body.md").read_text(encoding="utf-8")


def test_13_bar(example):
    its = example("13_bar")
    bar = stoss.ModalBody.read(its.folder / "bar.json")
    rows = its.table(3)
    assert rows[:, 0] == pytest.approx(bar.frequency, abs=0.5)
    # Of a thin bar with free ends (4.730, 10.996)²; shear and rotation lower the second.
    assert bar.frequency[0] == pytest.approx(1329, rel=0.015)
    assert 5.0 < rows[1, 1] < 5.404
    ball = stoss.Sphere(radius=0.01, material=stoss.materials["bearing steel"], loss_time=0)
    found = stoss.restitution(ball, against=bar, speed=0.5, tolerance=0.1)
    ((_, epsilon, error, _),) = its.numbers("ε at")
    assert (epsilon, error) == pytest.approx((found.restitution, found.restitution_error), abs=1e-3)
    assert rows[:, 2].sum() == pytest.approx(1 - found.restitution**2, abs=2 * error)


def test_14_bell(example):
    its = example("14_bell")
    bell = stoss.ModalBody.read(EXAMPLES / "any_body/bell.json")
    rows = its.table(6)
    assert all(np.min(np.abs(bell.frequency - frequency)) < 0.6 for frequency in rows[:, 0])
    for column, name in ((2, "small clapper"), (4, "large clapper")):
        _, epsilon, error, _ = its.numbers(name)[0]
        lost, doubt = 1 - epsilon**2, 2 * epsilon * error
        assert 0 < rows[:, column].sum() / 100 < lost + doubt + 1e-3
        assert rows[:, column].sum() / 100 == pytest.approx(lost, abs=doubt + 0.02)
    # The large one, four times as long in touch, drives the first partial alone.
    assert rows[0, 4] > 1.5 * rows[0, 2] and rows[1:, 4].sum() < 0.02 * rows[0, 4]
    assert rows[1:, 2].sum() > 0.7 * rows[0, 2]
    told = [f"{frequency:.0f}({error:.0f}) Hz" for frequency, error in rows[:2, :2]]
    told += [f"{rows[0, 2]:.1f}(", f"{rows[1, 2]:.1f}(", f"{rows[0, 4]:.1f}(", f"{rows[1, 4]:.2f}("]
    assert not [number for number in told if number not in PAGE]


def test_15_bat(example):
    its = example("15_bat")
    rows = its.table(7)
    place, mass, restitution, error, ringing, back, back_error = rows.T
    best = np.argmax(restitution)
    assert place[best] == 140 and place[np.argmax(back)] == 170 and restitution[best] > 0.98
    assert np.all(np.diff(restitution[: best + 1]) > 0) and np.all(np.diff(restitution[best:]) < 0)
    assert ringing / 100 == pytest.approx(1 - restitution**2, abs=0.01)  # the ball takes hardly any
    ball = 683 * 4 / 3 * np.pi * 0.037**3
    assert back == pytest.approx((restitution - ball / mass) / (1 + ball / mass), abs=2e-3)
    bat = stoss.ModalBody.read(EXAMPLES / "any_body/bat_30.json")
    assert mass[0] < 0.6 * bat.mass and np.argmax(mass) > best and mass.max() < bat.mass
    told = [(restitution[k], error[k]) for k in (0, best)] + [(back[best + 1], back_error[best + 1])]
    numbers = [f"{value:.4f}({1e4 * doubt:.0f})" for value, doubt in told]
    assert not [number for number in numbers if number not in PAGE], numbers


def test_16_coin(example):
    its = example("16_coin")
    middle, side = its.numbers("in the middle")[0], its.numbers("9 mm from the middle")[0][1:]
    coin = stoss.ModalBody.read(EXAMPLES / "any_body/coin_0.json")
    assert middle[3] == pytest.approx(1e3 * coin.mass, abs=6e-3) and side[3] < 0.4 * middle[3]
    partials = its.numbers("28.5 kHz")[0], its.numbers("17.0 kHz")[0], its.numbers("38.1 kHz")[0]
    for (frequency, share, error), at_least in zip(partials, (20, 10, 4)):
        assert at_least < share < 30 and 0 < error < 0.1 * share
        assert f"{frequency:.1f} kHz" in PAGE and f"{share:.1f}(" in PAGE
    for epsilon, error, *_ in (middle, side):
        assert f"{epsilon:.3f}({1e3 * error:.0f})" in PAGE
    epsilon, error, _, mass = its.numbers("on its edge")[0]
    assert mass == middle[3] and f"{epsilon:.5f}({1e5 * error:.0f})" in PAGE
    assert 1 - epsilon < 1e-3 * (1 - middle[0])
    lowest = its.numbers("97.5 kHz")[0]  # in its plane: far above the contact's 20 kHz
    assert lowest[1] < 0.05


def test_17_ring(example):
    """The partials are those of a thin ring, the lower the better; what is told of them stands in the page."""
    its = example("17_ring")
    steel = stoss.materials["structural steel"]
    for thickness in (3, 4, 6, 9):
        ring = stoss.ModalBody.read(EXAMPLES / f"any_body/ring_{thickness}.json")
        middle, height = 0.030 - thickness / 2000, 0.010
        assert ring.mass == pytest.approx(steel.density * 2 * np.pi * middle * height * thickness / 1000, rel=1e-3)
        n, speed = np.array([2, 3]), np.sqrt(steel.young / steel.density)
        slender = n * thickness / 1000 / middle
        thin = n * (n**2 - 1) / np.sqrt(n**2 + 1) * speed * thickness / 1000 / np.sqrt(12) / middle**2
        higher = thin / (2 * np.pi) / ring.frequency[ring.displacement > 2][:2] - 1
        assert np.all(higher > 0.05 * slender**2) and np.all(higher < 0.25 * slender**2)  # by shear and rotation
        mass, _, _, contact = its.numbers(f"{thickness} mm thick")[0][1:]
        assert mass == pytest.approx(1e3 * ring.mass, abs=0.6)
        ball = stoss.Sphere(radius=8e-3, material=stoss.materials["bearing steel"], loss_time=0)
        again = stoss.restitution(ball, against=ring, speed=0.1, tolerance=0.1)
        epsilon = stoss.with_error(again.restitution, again.restitution_error)
        assert f"{thickness} mm thick, {mass:.0f} g: ε = {epsilon}, contact {contact:.0f} µs" in its.text
        assert f"| {thickness} mm | {epsilon} | {contact:.0f} µs |" in PAGE
    takes = list(its.numbers("3.23 kHz"))[0]
    assert 58 < takes[1] < 60 and takes[2] < 1


def near(table, speed, **place):
    """The row at a speed with a value that is closest to a place in m."""
    rows = table[(table["speed"] == speed) & np.isfinite(table["restitution"])]
    return rows[int(np.argmin(np.sqrt(sum((rows[name] - at) ** 2 for name, at in place.items()))))]


def test_22_bell_map(example):
    its, table = example("22_bell_map"), stoss.read_csv(EXAMPLES / "any_body/bell_map.csv")
    for row in its.numbers("outside, points"):
        assert row[0] < row[1] < 1.0  # as they must on a body of revolution
    low, high = (near(table, 1.0, z=height) for height in (0.03, 0.077))
    told = [f"{row['restitution']:.2f}({100 * row['restitution_error']:.0f})" for row in (low, high)]
    ((*_, few, _, value, error),) = its.numbers("bell, ball")
    assert few == pytest.approx(value, abs=error)
    told += [f"{value:.4f}({1e4 * error:.0f})", f"{few:.4f}"]
    ((*_, few, _, value, error),) = its.numbers("plate, ball")
    ((exact, _),) = its.numbers("and ")
    assert abs(value - exact) < error and few - exact > 15 * abs(value - exact)
    told += [f"{few:.3f}", f"{exact:.3f}", f"{value:.2f}({100 * error:.0f})"]
    assert not [number for number in told if number not in PAGE], told


def test_23_clamped_plate_map(example):
    its, table = example("23_clamped_plate_map"), stoss.read_csv(EXAMPLES / "any_body/clamped_plate_map.csv")
    for speed in (0.3, 3.0):
        ((*_, off),) = its.numbers(f"{speed:g} m/s, ")
        assert off < 1.0  # as its faces, left and right, are alike
    middle, corner = near(table, 0.3, x=0.002, y=0.0), near(table, 0.3, x=0.048, y=0.03)
    told = f"{middle['restitution']:.3f}({1e3 * middle['restitution_error']:.0f})"
    assert told in PAGE and f"{corner['restitution']:.4f}({1e4 * corner['restitution_error']:.0f})" in PAGE
