"""stoss predict and stoss table --predict: what a drop test of a real ball shows."""

import json
import re
import resource

import pytest

pytestmark = pytest.mark.numbers

BALL = "--body sphere --radius 0.005"


def rows(stoss, arguments):
    return json.loads(stoss.run("predict --format json --quiet", arguments).stdout)["records"]


def test_table_has_three_uncertainties_and_fits_a_terminal(stoss):
    ball = f"{BALL} --material 'bearing steel' --against half-space,material=glass --speed 0.001,3"
    result = stoss.run("predict", ball)
    assert max(map(len, result.stdout.splitlines())) <= 80, result.stdout
    names = result.stdout.split("\n")[0].split()
    assert names == ["speed", "restitution", "by_models", "by_constants", "rebound_height"]
    assert result.stdout.count("modelled") == 2 and result.stdout.count("computed") == 3
    assert "glass is taken as sound, smooth, dry and uncracked" in result.stderr
    header = stoss.run("predict --format csv --quiet", ball).stdout
    columns = "restitution,restitution_error,by_models,by_constants,models_low,models_high,restitution_without_models,"
    assert columns in header and "dominant" in header


def test_quick_is_one_line_a_speed(stoss, tmp_path):
    """ε within a unit of its last digit, and a spread that holds all three uncertainties, but not twice as much."""
    for material in ("'bearing steel'", "aluminium"):  # of which the latter yields at 1 m/s: the models differ
        ball = f"{BALL} --material {material} --against half-space,material=glass --speed 0.1,1"
        lines = stoss.run("predict --quick --quiet", ball).stdout.splitlines()
        assert len(lines) == 2
        for line, row in zip(lines, rows(stoss, ball)):
            told, spread = line.split(" +- ")
            unit = 10.0 ** -len(told.partition(".")[2])
            total = row["restitution_error"] + row["by_models"] + row["by_constants"]
            assert float(told) == pytest.approx(row["restitution"], abs=0.51 * unit)
            assert total + 0.5 * unit <= float(spread) * (1 + 1e-12) <= 1.2 * total + 2 * unit
            assert 10 <= round(float(spread) / unit) <= 101
    file = tmp_path / "epsilon"
    done = stoss.run("predict --quick", ball, f"-o {file}")
    assert done.stdout == "" and file.read_text().splitlines() == lines and "warning" in done.stderr


def test_table_states_the_spread_beside_its_error(stoss):
    wall = f"{BALL} --material aluminium --speed 0.1:1 --error 0.003"
    header = stoss.run("table --predict", wall)
    error = float(re.search(r"interpolation included: at most ([0-9.e-]+)", header.stdout)[1])
    spread = float(re.search(r"differ from the coefficient by up to ([0-9.e-]+),", header.stdout)[1])
    assert error < 0.003 < 0.01 < spread < 0.02 and "by up to" in header.stderr
    made = json.loads(stoss.run("table --predict --format json --quiet", wall).stdout)
    assert made["greatest_error"] <= error and spread == pytest.approx(made["by_models"], rel=0.1)
    assert "differ" not in stoss.run("table --quiet", wall).stdout


def test_slow_balls_on_blocks_take_hardly_longer_than_without_models(stoss):
    # Of processor time: a ladder without loss and an impact for each constant took more than twice as much.
    ball = f"{BALL} --material glass --against half-space,material=glass --speed 1e-3 --threads 1"

    def taken(*arguments):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        assert stoss.run(*arguments).returncode == 0
        return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before

    alone = min(taken("restitution --absolute 1e-5 --quiet", ball) for _ in range(2))
    assert min(taken("predict --quiet", ball) for _ in range(2)) < 1.7 * alone


def test_what_is_not_computed_is_said(stoss):
    """On a sheet so thin that the ball stays on it for longer than is computed."""
    ball = "--body sphere --poisson 0.3 --young 2e11 --density 7850 --radius 1 --speed 50"
    result = stoss.run("predict", ball, "--against plate,poisson=0.3,young=1e10,density=7850,thickness=0.001")
    assert result.returncode == 1 and "not computed" in result.stdout, result.stderr
    assert "so thin" in result.stderr and "nan" not in result.stdout
