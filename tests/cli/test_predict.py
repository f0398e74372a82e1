"""stoss predict and stoss table --predict: what a drop test of a real ball shows."""

import json
import re
import resource

import pytest

BALL = "--body sphere --radius 0.005"
CHANNELS = ("ringing", "radiation", "material", "yield", "adhesion")


def rows(stoss, arguments):
    return json.loads(stoss.run("predict --format json --quiet", arguments).stdout)["records"]


@pytest.mark.numbers
def test_shares_add_up(stoss):
    for row in rows(stoss, f"{BALL} --material 'structural steel' --against half-space,material=glass --speed 0.01,1"):
        assert sum(row[name] for name in CHANNELS) == pytest.approx(1 - row["restitution"] ** 2, abs=1e-9)
        assert row["models_low"] <= row["restitution"] <= row["models_high"]
        spread = max(row["models_high"] - row["restitution"], row["restitution"] - row["models_low"])
        assert row["by_models"] == pytest.approx(spread, abs=1e-15)
        assert 0 < row["restitution_error"] < 1e-4 < row["by_constants"]
        assert row["rebound_height"] == pytest.approx(row["restitution"] ** 2 * row["drop_height"])
        assert row["dominant"] == max(CHANNELS, key=row.get)
        changes = [abs(each["change"]) for each in row["influences"]]
        assert changes == sorted(changes, reverse=True) and changes[0] > 0


@pytest.mark.numbers
def test_without_models_it_is_the_restitution(stoss):
    ball = f"{BALL} --poisson 0.3 --young 2e11 --density 7800 --loss-time 1e-9"
    ball += " --against half-space,young=7e10,poisson=0.22,density=2500"
    (row,) = rows(stoss, f"{ball} --speed 1")
    elastic = stoss.run("restitution --format json --absolute 1e-5", f"{ball} --speed 1")
    (other,) = json.loads(elastic.stdout)["records"]
    assert row["restitution_without_models"] == other["restitution"]
    assert row["restitution"] == pytest.approx(other["restitution"], abs=1e-8)
    assert row["yield"] == row["adhesion"] == 0


@pytest.mark.numbers
def test_a_height_is_the_speed_of_its_fall(stoss):
    (row,) = rows(stoss, f"{BALL} --material glass --height 0.5")
    assert row["speed"] == pytest.approx((2 * 9.80665 * 0.5) ** 0.5)
    assert row["drop_height"] == pytest.approx(0.5)


@pytest.mark.numbers
def test_dust_sticks(stoss):
    dust = "--body sphere --radius 1e-6 --material ice --against same"
    slow, fast = rows(stoss, f"{dust} --speed 0.1,10")
    assert slow["restitution"] == 0 and slow["dominant"] == "adhesion" and fast["restitution"] > 0.9
    said = stoss.run("predict", f"{dust} --speed 0.1").stderr
    assert "sticks below 1.4" in said and "model" in said


@pytest.mark.numbers
def test_table_is_the_prediction(stoss):
    wall = f"{BALL} --material aluminium"
    made = json.loads(stoss.run("table --predict --format json", f"{wall} --speed 0.01:1 --error 0.003").stdout)
    middle = made["records"][len(made["records"]) // 2]
    (row,) = rows(stoss, f"{wall} --speed {middle['speed']}")
    assert middle["restitution"] == pytest.approx(row["restitution"], abs=1e-5)
    assert made["inputs"]["models"] == "yield, adhesion"


def test_refuses_in_one_line(stoss):
    for arguments, said in (
        ("--body disk --poisson 0.3 --young 2e11 --density 7800 --radius 0.01 --speed 1", "body: got a disk"),
        ("--body sphere --poisson 0.3 --speed 0.1", "material: missing"),
        (f"{BALL} --material 'structural steel' --speed -1", "speed: got -1"),
        (f"{BALL} --material 'structural steel' --speed nan", "speed"),
        (f"{BALL} --material 'structural steel' --height 0", "height: got 0"),
        (f"{BALL} --material 'structural steel' --speed 1 --adhesion -1", "adhesion: got -1"),
        (f"{BALL} --material 'structural steel' --speed 1 --uncertainty young", "NAME=U"),
        (f"{BALL} --material 'structural steel' --speed 1 --uncertainty colour=1", "uncertainties: got 'colour'"),
        (f"{BALL} --material 'structural steel' --speed 1 --uncertainty against.young=1", "uncertainties: got 'against.young'"),
    ):
        result = stoss.run("predict", arguments)
        assert result.returncode == 3 and said in result.stderr and result.stderr.count("\n") == 1, result.stderr
    nothing = stoss.run("predict", f"{BALL} --material 'structural steel'")
    assert nothing.returncode == 2 and "--speed or --height" in nothing.stderr
    for arguments, said in (("--adhesion 0.1", "only with --predict"), ("--predict --oblique", "only without")):
        table = stoss.run("table", f"{BALL} --material 'structural steel' --speed 1:2", arguments)
        assert table.returncode == 3 and said in table.stderr


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


def test_table_states_the_spread_beside_its_error(stoss):
    wall = f"{BALL} --material aluminium --speed 0.1:1 --error 0.003"
    header = stoss.run("table --predict", wall)
    error = float(re.search(r"interpolation included: at most ([0-9.e-]+)", header.stdout)[1])
    spread = float(re.search(r"differ from the coefficient by up to ([0-9.e-]+),", header.stdout)[1])
    assert error < 0.003 < 0.1 < spread and "by up to" in header.stderr
    made = json.loads(stoss.run("table --predict --format json --quiet", wall).stdout)
    assert made["greatest_error"] <= error and spread == pytest.approx(made["by_models"], rel=0.1)
    assert "differ" not in stoss.run("table --quiet", wall).stdout


@pytest.mark.numbers
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
