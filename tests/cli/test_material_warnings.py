"""Every subcommand that computes with a named material says where its loss is far off, and what it takes as sound."""

import pytest

SOUND = "stoss: warning: granite is taken as sound, smooth, dry and uncracked: measured losses are often ten times as large and more"
BALL = ["--body", "sphere", "--material", "granite", "--radius", "1"]
CASES = {
    "restitution": ["--speed", "0.1", "--against", "same", "--tolerance", "0.1"],
    "oblique": ["--speed", "0.1", "--angle", "30", "--friction", "0.1", "--against", "same", "--tolerance", "0.3"],
    "impact": ["--speed", "0.1", "--against", "same", "--cutoff", "12"],
    "bounce": ["--speed", "0.1", "--count", "2", "--gravity", "9.81", "--cutoff", "12"],
    "distribution": ["--speed", "0.1", "--temperature", "0.01", "--samples", "2"],
    "table": ["--speed", "0.05:0.1", "--against", "same", "--error", "0.05"],
}


@pytest.mark.parametrize("command", CASES)
def test_loss_far_off_and_sound(stoss, command):
    done = stoss.run(command, *BALL, *CASES[command])
    said = done.stderr.splitlines()
    assert any(line.startswith("stoss: warning: the loss of granite is ") and " times too small " in line for line in said), said
    assert said.count(SOUND) == 1


@pytest.mark.parametrize("command", ["restitution", "impact"])
def test_nothing_of_a_loss_time_of_ones_own(stoss, command):
    done = stoss.run(command, *BALL, *CASES[command], "--loss-time", "2.4e-5")
    assert "loss" not in done.stderr


def test_elastic_estimates_and_predictions_say_what_is_taken_as_sound(stoss):
    quasistatic = stoss.run("quasistatic", *BALL, "--speed", "0.1")
    assert quasistatic.stderr.splitlines() == [SOUND]
    table = stoss.run("table", *BALL, "--speed", "0.05:0.1", "--against", "same", "--error", "0.05", "--predict")
    assert SOUND in table.stderr.splitlines()
