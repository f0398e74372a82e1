"""What docs/tutorials/vibrating_bodies.md says of its numbers follows from what its code prints (which
tests/python/package/test_guide.py runs) and from the tables of docs/understand/findings/vibration.md."""

import re

from conftest import page, table

PAGE, WORDS = page("docs/tutorials/vibrating_bodies.md")


def printed(pattern):
    return [float(each) for each in re.search(pattern, WORDS).groups()]


def test_shares_are_of_the_whole_energy():
    translation, vibration = printed(r"after: ([\d.]+) translation \+ ([\d.]+) vibration")
    assert abs(translation + vibration - 1) < 1e-4 and "1.1 times the translational one" in WORDS
    # ε² = what translation has of 1.1 times its energy before
    (restitution,) = printed(r"ε = ([\d.]+) energy after")
    assert abs(1.1 * translation - restitution**2) < 2e-4


def test_a_third_of_warm_balls_come_back_faster():
    (row,) = [row for row in table("docs/results/vibration/temperatures.csv")
              if (row["body"], row["speed"], row["temperature"]) == ("sphere", 0.01, 0.01)]  # fmt: skip
    assert abs(row["share_above_one"] - 1 / 3) < 0.03 and "A third of the impacts have ε > 1" in WORDS


def test_spread_follows_from_the_loss_of_a_cold_ball():
    spread, law = printed(r"spread ([\d.]+), from the loss at rest ([\d.]+)")
    assert abs(law / spread - 1) < 0.125 and "to about a tenth at this temperature" in WORDS


def test_translation_has_a_nineteenth():
    shares = table("docs/results/vibration/equipartition.csv")
    assert "each of the 18 modes: a nineteenth" in WORDS and len(shares) in (18, 19)
