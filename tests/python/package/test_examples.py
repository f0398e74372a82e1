"""The programs in examples/ run as a user runs them; what they print and write agrees with direct
calls of stoss."""

import importlib.util
import itertools
import re
import runpy
import subprocess
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest

import stoss

EXAMPLES = Path(__file__).parents[3] / "examples"
FILES = {
    "01_first_curve": ["first_curve.csv", "first_curve.png"],
    "02_modes": ["modes.csv", "modes.png"],
    "03_anatomy": ["anatomy.csv", "anatomy.png"],
    "04_material": ["steel.png", "steel_plane_strain.csv", "steel_plane_stress.csv"],
    "05_event_driven": ["event_driven.png"],
    "06_two_disks": ["two_disks.png"],
    "07_balls": ["balls.csv", "balls.png"],
    "08_drop_test": ["drop_test.csv", "drop_test.png"],
    "09_vibrating_ball": ["vibrating_ball.csv", "vibrating_ball.png"],
    "10_rod_chain": ["rod_chain.png"],
    "11_superball_in_a_box": ["superball.csv", "superball.png"],
    "12_how_thick": ["how_thick.csv", "how_thick.png"],
    "13_bar": ["bar.json", "bar.png", "bar.wav"],
    "14_bell": ["bell.png", "bell_large.wav", "bell_small.wav"],
    "15_bat": ["bat.png"],
    "16_coin": ["coin.png"],
    "17_ring": ["ring.png"],
    "18_ball_drop_calibration": ["ball_drop.csv", "ball_drop.png", "ball_drop_below.txt", "ball_drop_force.txt"],
    "19_impact_echo": ["impact_echo.csv", "impact_echo.png"],
    "20_table_tennis_ball": ["table_tennis_ball.csv", "table_tennis_ball.png"],
    "21_bat_in_hands": ["bat_in_hands.png"],
    "22_bell_map": ["bell_map.png"],
    "23_clamped_plate_map": ["clamped_plate_map.png"],
    "24_leeb_hardness": ["leeb.csv", "leeb.png"],
}


# Which take seconds, and run before a release.
LONG = ("08_drop_test", "10_rod_chain", "18_ball_drop_calibration", "19_impact_echo", "20_table_tennis_ball")


def load(name):
    spec = importlib.util.spec_from_file_location(name[3:], EXAMPLES / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_all_examples_are_tested():
    assert sorted(path.stem for path in EXAMPLES.glob("*.py")) == sorted(FILES)


@pytest.mark.parametrize("name", [pytest.param(name, marks=pytest.mark.long) if name in LONG else name for name in FILES])
def test_files(name, example):
    folder = example(name).folder
    assert sorted(path.name for path in folder.iterdir()) == FILES[name]
    for picture in folder.glob("*.png"):
        pixels = plt.imread(picture)[..., :3]
        assert min(pixels.shape[:2]) > 400
        assert 0.01 < np.mean(np.any(pixels < 0.95, axis=-1)) < 0.6, f"{picture.name}: blank, or all ink"
        for half in itertools.chain(np.array_split(pixels, 2), np.array_split(pixels, 2, axis=1)):
            assert np.any(half < 0.5), f"{picture.name}: half of it is empty"


SCRIPTS = sorted(path for path in EXAMPLES.rglob("*") if path.suffix in (".py", ".sh"))


@pytest.mark.parametrize("option", ["--help", "--no-such-option"])
@pytest.mark.parametrize("script", SCRIPTS, ids=lambda path: path.name)
def test_answers_help_and_refuses_what_it_does_not_know(script, option, tmp_path, monkeypatch, capfd):
    """Without writing anything, as the name of an option is no name of a file."""
    monkeypatch.chdir(tmp_path)
    if script.suffix == ".sh":
        status = subprocess.run(["bash", script, option]).returncode
    else:  # in this process, which has imported what takes long
        monkeypatch.setattr(sys, "argv", [str(script), option])
        with pytest.raises(SystemExit) as ended:
            runpy.run_path(str(script), run_name="__main__")
        status = ended.value.code
    said = capfd.readouterr()
    if option == "--help":
        assert not status and script.name in said.out and said.err == ""
    else:
        assert status == 2 and said.out == "" and said.err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", FILES)
def test_says_how_to_run_it(name):
    text = load(name).__doc__
    assert "mkdir(parents=True" in (EXAMPLES / f"{name}.py").read_text(encoding="utf-8")
    assert f"python examples/{name}.py" in text and "Expect:" in text and "out/" in text


def test_first_curve(example):
    run = example("01_first_curve")
    rows = run.table(5)
    assert len(rows) == 14
    poisson, speed, value, error, time = rows.T
    direct = stoss.restitution(poisson=poisson, speed=np.tile(np.geomspace(1e-4, 0.09, 43)[::7], 2))
    np.testing.assert_allclose(speed, direct.speed, rtol=1e-3)
    np.testing.assert_allclose(value, direct.restitution, atol=6e-7, rtol=0)
    np.testing.assert_allclose(error, direct.restitution_error, atol=6e-7, rtol=0)
    np.testing.assert_allclose(time, direct.contact_time, atol=6e-4, rtol=0)
    table = run.csv("first_curve.csv")
    assert len(table) == 86 and float(table[42]["restitution"]) == direct.restitution[6]


def test_anatomy(example):
    run = example("03_anatomy")
    hit = stoss.impact(poisson=0.33, speed=0.1)
    assert run.text.splitlines()[0] == str(hit)
    assert run.numbers("maximum force") == [[round(hit.max_force, 5)]]
    assert run.numbers("maximum compression") == [[round(hit.max_compression, 5)]]
    # The force falls fastest as the pressure wave comes back, as the picture says.
    ((echo,),) = run.numbers("pressure wave")
    path = hit.trajectory()
    middle = (path.time > 1.0) & (path.time < 5.0)
    fall = path.time[middle][np.argmin(np.gradient(path.force, path.time)[middle])]
    assert echo - 0.1 < fall < echo
    # Momentum: what the wall gave is what the centre of mass changed by.
    impulse, _, change = run.numbers("impulse")[0]
    assert change == pytest.approx(1 + hit.restitution, abs=6e-6)
    assert impulse == pytest.approx(change, abs=2e-5)
    for name in ("translation", "vibration", "unresolved", "energy_error"):
        assert run.numbers(name)[0][-1] == pytest.approx(getattr(hit, name), abs=6e-7)
    strongest = np.sort(hit.mode_energies["after"])[:-5:-1]
    found = [float(each) for each in re.findall(r"mode \(\d,\d\) +(\S+)", run.text)]
    np.testing.assert_allclose(found, strongest, atol=6e-7)
    assert len(run.csv("anatomy.csv")) == len(hit.trajectory())


RUBBER = stoss.Disk(radius=0.01, material=stoss.materials["rubber"], loss_time=0)


def test_gas(example):
    run = example("05_event_driven")
    (left, *_), (*_, left_constant, _, _) = run.numbers("gas with ε(v)")[0], run.numbers("gas with ε =")[0]
    assert 1e-3 < left < 1e-1 and 200 < left / left_constant < 1000

    cool = load("05_event_driven").cool
    law = stoss.restitution_function(RUBBER, against="same", speed=(0.002, 30.0), error=1e-2, beyond="law")
    time, energy = cool(law, 200, 5.0)
    assert np.all(np.diff(time) >= 0) and np.all(np.diff(energy) < 0)
    again = cool(law, 200, 5.0)
    assert np.array_equal(time, again[0]) and np.array_equal(energy, again[1])
    # Elastic disks keep their energy; sticking ones lose what is relative.
    assert cool(lambda v: 1.0, 200, 5.0)[1] == pytest.approx(1.0, abs=1e-12)
    assert cool(lambda v: 0.0, 1, 5.0, count=2)[1][-1] == pytest.approx(0.0, abs=1e-12)


def test_vibrating_ball(example):
    run = example("09_vibrating_ball")
    ball = stoss.Sphere(poisson=0.3)
    rows = run.table(4)
    assert len(rows) == 9
    for phase, value, error, law in rows[:-1]:
        state = stoss.Oscillation(order=2, index=0, energy=0.05, phase=phase)
        direct = stoss.restitution(ball, speed=0.01, absolute=1e-5, state=state)
        assert abs(value - direct.restitution) < 1e-6 and abs(error - direct.restitution_error) < 1e-6
        assert abs(value - law) < 0.06 * 0.0105  # of the amplitude: what is of higher order
    values = [float(row["restitution"]) for row in run.csv("vibrating_ball.csv")]
    assert len(values) == 33 and 0.4 < np.mean(np.array(values) > 1) < 0.5
    warm = run.table(6)
    assert list(warm[:, 0]) == [1e-4, 1e-3, 1e-2]
    for _, mean, error, spread, law, _ in warm:
        assert spread == pytest.approx(law, rel=0.1)  # 300 samples: 4 %
        assert abs(mean - 0.99861) < 3 * error + 1e-5


@pytest.mark.long
def test_rod_chain(example):
    run = example("10_rod_chain")
    ((*_, left_none, mean_none, spread, above),) = run.numbers("no ")
    ((*_, left_complete, mean_complete, spread_complete, above_complete),) = run.numbers("complete")
    # 40 rods with 50 and 55 modes each, and what 40 velocities hold of it.
    assert left_none == pytest.approx(19.5 / (19.5 + 2100), rel=0.5) and left_complete < 1e-9
    assert spread > 0.2 and 0.3 < above < 0.6 and mean_none == pytest.approx(1, abs=0.1)
    assert mean_complete == pytest.approx(0.9, abs=0.005) and spread_complete < 1e-3 and above_complete == 0


def test_superball(example):
    run = example("11_superball_in_a_box")
    rows = run.csv("superball.csv")
    columns = {name: np.array([float(row[name]) for row in rows]) for name in rows[0] if name != "side"}
    assert len(rows) == 24 and {row["side"] for row in rows} == {"left", "right", "floor", "lid"}
    energy = np.array([1.0, *(columns["flying"] + columns["rotating"])])
    assert np.all(np.diff(energy) < 0) and energy[-1] > 0.3
    # The first bounce is that of one impact, after a fall of 0.475 m.
    ((_, speed, before, after, turns, *_), *_) = run.numbers("1  floor")
    assert speed == pytest.approx(np.sqrt(3.0**2 + 2 * 9.81 * 0.475), abs=6e-5) and before == 3.5
    ball = stoss.Sphere(radius=0.025, material=stoss.materials["rubber"], loss_time=0)
    direct = stoss.oblique(ball, speed=speed, tangential=before, friction=1.0)
    assert after == pytest.approx(-direct.tangential_restitution * before, abs=0.04 * (before + speed))  # of the rule
    assert turns == pytest.approx(5 / 7 * (after - before) / 0.025 / (2 * np.pi), abs=2e-3)
    # The second, at the lid, turns it back: along the floor it flew to the right, at 3.5 m/s before.
    changes = 2 / 7 * (columns["sliding_after_m_s"] - columns["sliding_m_s"])
    assert 3.5 + changes[0] > 1 and 3.5 + changes[0] - changes[1] < -1


def test_how_thick(example):
    run = example("12_how_thick")
    rows = run.table(5)
    assert len(rows) == 13
    thickness, restitution, time, by_restitution, by_time = rows.T
    assert np.all(np.diff(restitution) > 0) and np.all(np.diff(time) < 0)
    # Thin panes are told by the time, thick ones by the restitution.
    assert by_time[0] < 0.5 * by_restitution[0] and by_time[-1] > 5 * by_restitution[-1]
    ball = stoss.Sphere(radius=5e-3, material=stoss.materials["bearing steel"], loss_time=0)
    for k in (0, 9):
        pane = stoss.Plate(thickness=1e-3 * thickness[k], material=stoss.materials["glass"], loss_time=0)
        direct = stoss.restitution(ball, against=pane, speed=1.0)
        assert restitution[k] == pytest.approx(direct.restitution, abs=1e-5)
        assert time[k] == pytest.approx(1e6 * direct.contact_time_si, abs=1e-2)
    ((_, _, *found, true),) = run.numbers("a pane with restitution")
    assert found == pytest.approx([true, true], abs=0.05)


def test_balls_of_the_example_are_those_of_the_package(example):
    rows = example("07_balls").csv("balls.csv")
    assert len(rows) == 14  # steel up to its yield speed, 0.13 m/s
    for row in rows:
        speed = row["speed_m_s"]
        ball = stoss.Sphere(radius=0.01, material=stoss.materials[row["material"]], loss_time=0)
        direct = stoss.restitution(ball, speed=float(speed))
        assert direct.lost_fraction == pytest.approx(float(row["lost_fraction"]), rel=1e-8)
        # Hertz: the pressure that goes with a force and the energy that made it.
        stiff = ball.young / (1 - ball.poisson**2)
        hertz = stiff * 2 / np.pi * (15 / 16 * 4 * np.pi / 3 * ball.density * float(speed) ** 2 / stiff) ** 0.2
        if direct.speed < 5e-4:  # a faster ball presses deeper, where a whole ball is stiffer than Hertz's
            assert float(row["pressure_Pa"]) == pytest.approx(hertz, rel=0.01)
