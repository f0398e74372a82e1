"""What docs/understand/findings/oblique.md says is what its CSV files say."""

import math
import statistics

import pytest
from oblique_results import (
    BEST,
    CODES_WORDS,
    COUPLING,
    CURVES,
    FASTER,
    GLASS,
    MEASURED,
    MEASURED_WORDS,
    NORMAL,
    SIZE,
    WORDS,
    at,
    best_limit,
    curve,
    having,
    of_law,
    one,
    signed,
    size_law,
    walton,
    worst,
)


def test_who_meets_the_tolerance():
    for rows in (CURVES, SIZE, GLASS, BEST):
        assert all(row["converged"] == "true" for row in rows)
    missed = [row for row in COUPLING + NORMAL if row["converged"] == "false"]
    assert f"{len(missed)} of fast disks" in WORDS
    assert all(row["speed"] >= 0.05 for row in missed)


def test_claims_about_steel():
    row = one(SIZE, against="wall", poisson=0.3, psi1=1, speed=1e-3)
    assert f"comes back with ε_t = {-row['psi2']:.2f};" in WORDS and f"theory gives {-row['maw']:.2f}." in WORDS


def test_claims_about_published_finite_elements():
    maw = [{"angle": x, **row} for x, row in sorted(curve("maw", 0.0).items())]
    found = [(row["at"], -row["value"] / row["at"]) for row in having(MEASURED, quantity="fem") if row["at"] < 8]
    off = {x: value - at(maw, x, "tangential_restitution") for x, value in found if x > 0.6}
    assert all(abs(each) < 0.02 for x, each in off.items() if 2 < x < 5)
    near = [each for x, each in off.items() if 0.8 < x < 1.25]
    assert len(near) == 2 and all(round(each, 2) in (0.12, 0.13) for each in near)


def test_claims_about_size():
    rest = max(size_law(*each, psi)[2] for each in (("wall", 0.0), ("wall", 0.3), ("wall", 0.45), ("half_space", 0.3))
               for psi in (0.5, 1.0, 2.0, 3.0))  # fmt: skip
    assert f"to within {rest:.2f}" in WORDS


def root_mean_square(values):
    return math.sqrt(sum(each * each for each in values) / len(values))


def test_claims_about_the_experiment():
    first = GLASS[0]["restitution"]
    loss = 100 * (1 - first**2)
    assert f"stoss gives {first:.4f} for the head-on impact: the waves in the glass take {loss:.1f} %" in MEASURED_WORDS
    assert f"some {100 * loss / (100 * (1 - 0.98**2)):.0f} % of the measured loss" in MEASURED_WORDS
    near, far = (at(GLASS, angle, "neglected_coupling") for angle in (2, 10))
    most = max(abs(row["neglected_coupling"]) for row in GLASS if row["angle"] >= 12)
    assert f"{near:.2f} at 2°, {far:.2f} at 10°, at most {most:.2f} from 12° on" in MEASURED_WORDS
    off = {}
    for quantity, name in (("et", "tangential_of_center"), ("spin", "spin"), ("patch", "angle_of_patch")):
        its = [row for row in having(MEASURED, quantity=quantity) if row["at"] > 15]
        off[quantity] = [row["value"] - at(GLASS, row["at"], name) for row in its]
    said = f"v_t′/v_t agrees to {root_mean_square(off['et']):.3f} (root mean square of {len(off['et'])} points"
    assert said in MEASURED_WORDS
    spin, patch = off["spin"], off["patch"]
    assert f"the spin to {root_mean_square(spin):.0f} rad/s of up to 612 ({len(spin)} points)" in MEASURED_WORDS
    said = f"rebounds to {root_mean_square(patch):.1f}° ({len(patch)} points, {statistics.fmean(patch):.1f}° above"
    assert said in MEASURED_WORDS


def test_claims_about_superballs():
    best = max(having(BEST, bodies="sphere"), key=lambda row: row["tangential_restitution"])
    said = f"reaches is {best['tangential_restitution']:.2f}, at ν = {best['poisson']:g}, v = {best['speed']:g} c"
    assert f"{said} and x = {best['x']:.1f}" in WORDS
    disk = max(row["tangential_restitution"] for row in having(BEST, bodies="equal_disks"))
    assert f"Two equal disks reach {disk:.2f}" in WORDS
    assert all(row["tangential_restitution"] < 0.6 for row in having(BEST, bodies="maw"))


def test_claims_about_codes():
    limits = [best_limit(speed) for speed in FASTER]
    errors = [abs(worst(walton(limit, speed), speed)[0]) for limit, speed in zip(limits, FASTER)]
    said = "The best β₀ is {:.2f} at 10⁻⁶ c, {:.2f} at 0.001 c and {:.2f} at 0.1 c".format(*limits)
    assert f"{said}, with errors of " + "{:.2f}, {:.2f} and {:.2f}".format(*errors) in CODES_WORDS
    superball = of_law("linear_2/7")
    assert all(value == pytest.approx(1, abs=1e-3) for x, value in superball.items() if x < 3.45)
    assert all(of_law("history_2/7")[x] == pytest.approx(value, abs=1e-3) for x, value in superball.items())
    slow = curve("sphere", 1e-6)
    for name in ("history", "rescale", "force", "rescale_force", "linear_1"):
        law = of_law(name)
        assert all(abs(law[x] - slow[x]["tangential_restitution"]) < 0.16 for x in law if x > 2.95)


def test_claims_about_coupling():
    assert f"({len(COUPLING)} impacts, ν = 0, 0.33, 0.7)" in WORDS
    added = {(row["x"], row["speed"], round(row["friction"] / row["beta"], 3), row["poisson"]):
             row["tangential_restitution"] - row["equal_disks"] for row in COUPLING}  # fmt: skip
    slow = {key: value for key, value in added.items() if key[1] == 0.003}
    assert all(abs(value) < 0.03 for (x, _, ratio, _), value in slow.items() if x <= 1 and ratio >= 1.99)
    beyond = [value for (x, *_), value in added.items() if x >= 2]
    assert max(map(abs, beyond)) < 0.2 and sum(value < 0 for value in beyond) > len(beyond) / 2
    slowly = having(COUPLING, speed=0.003)
    stuck = [row for row in slowly if row["x"] <= 1 and row["friction"] < 0.11 * row["beta"]]
    assert all(0.495 < row["tangential_restitution"] < 0.75 and -0.25 < row["equal_disks"] < 0.35 for row in stuck)


def test_claims_about_restitution_along_the_normal():
    more = [row["restitution"] - row["without_friction"] for row in NORMAL]
    said = f"by {signed(min(more))} to {max(more):.3f} ({len(NORMAL)} impacts"
    assert said in WORDS
    assert f"maximum of all is {max(row['restitution'] for row in NORMAL):.3f}" in WORDS
    soft = having(NORMAL, against="soft")
    assert max(abs(row["restitution"] - row["without_friction"]) for row in soft) < 0.005
