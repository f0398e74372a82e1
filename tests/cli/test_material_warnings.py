"""Every subcommand that computes with a named material says what it takes as sound."""

import json

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
def test_sound(stoss, command):
    said = stoss.run(command, *BALL, *CASES[command]).stderr.splitlines()
    assert said.count(SOUND) == 1 and not any("the loss of" in line for line in said)


@pytest.mark.parametrize("loss", ["--loss-time 2.4e-5", "--loss-time 0", "--quality 20", "--quality 0"])
def test_nothing_of_a_loss_of_ones_own(stoss, loss):
    done = stoss.run("impact", *BALL, *CASES["impact"], *loss.split())
    assert done.stderr == ""


def test_a_named_material_relaxes_and_a_loss_of_ones_own_takes_its_place(stoss):
    def heat(loss):
        found = stoss.run("restitution", *BALL, "--speed", "0.1", "--format", "json", *loss.split())
        return json.loads(found.stdout)["records"][0]["dissipated"]

    assert 100 * heat("") == pytest.approx(2.385, rel=0.01)  # of Q = 100, whatever the speed and the size
    assert 20 * heat("--quality 20") == pytest.approx(2.28, rel=0.02)
    assert heat("--loss-time 0") == heat("--quality 0") == 0
    assert 0 < heat("--loss-time 1e-9") < 1e-5


def test_elastic_estimates_and_predictions_say_what_is_taken_as_sound(stoss):
    quasistatic = stoss.run("quasistatic", *BALL, "--speed", "0.1")
    assert quasistatic.stderr.splitlines() == [SOUND]
    table = stoss.run("table", *BALL, "--speed", "0.05:0.1", "--against", "same", "--error", "0.05", "--predict")
    assert SOUND in table.stderr.splitlines()
