"""What a user reads: help that fits the terminal, tables whose columns stand apart, and refusals of what was given."""

import fcntl
import json
import os
import pty
import re
import struct
import subprocess
import termios
from pathlib import Path

import pytest

FILES = Path(__file__).resolve().parents[2] / "examples/any_body"
SUBCOMMANDS = ["", "modes", "impact", "bounce", "restitution", "oblique", "distribution", "quasistatic", "predict",
               "table", "fit", "materials", "schema", "sweep", "merge"]  # fmt: skip


def on_a_terminal(words, columns):
    """What the command prints on a terminal of that width."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    with subprocess.Popen([os.environ["STOSS"], *words], stdout=theirs) as process:
        os.close(theirs)
        text = b""
        try:
            while part := os.read(ours, 65536):
                text += part
        except OSError:  # the other side is closed
            pass
        os.close(ours)
    assert process.returncode == 0
    return text.decode().replace("\r\n", "\n")


def test_these_are_all_subcommands(stoss):
    listed = re.findall(r"^  ([a-z]+)  ", stoss.run("--help").stdout.partition("Subcommands:")[2], re.MULTILINE)
    assert listed == SUBCOMMANDS[1:]


@pytest.mark.parametrize("name", SUBCOMMANDS)
def test_help_is_wrapped_to_the_terminal(stoss, name):
    """To 80 columns where there is none; the words are the same whatever the width."""
    plain = stoss.run(name, "--help").stdout
    texts = {80: plain, 60: on_a_terminal([*name.split(), "--help"], 60), 120: on_a_terminal([*name.split(), "--help"], 120)}
    for width, text in texts.items():
        assert max(map(len, text.splitlines())) <= width
        assert re.sub(r"\s", "", text) == re.sub(r"\s", "", plain)
    assert on_a_terminal([*name.split(), "--help"], 80) == plain
    assert len(texts[120].splitlines()) <= len(plain.splitlines()) <= len(texts[60].splitlines())


@pytest.mark.parametrize("words", ["materials", "restitution --body disk --poisson 0.33 --speed 0.1"])
def test_columns_of_tables_stand_apart(stoss, words):
    lines = stoss.run(words).stdout.splitlines()
    assert max(map(len, lines)) <= 80
    if words == "materials":
        assert lines[0].split() == ["name", "young", "poisson", "density", "yield_strength", "quality", "surface_energy"]
        glass = next(line for line in lines if line.split()[:1] == ["glass"])
        assert glass.split() == ["glass", "7e+10", "0.22", "2500", "1000", "0.03"]


def test_a_value_that_there_is_not_is_no_nan(stoss):
    """Known too close to the point: the row says so, and the reason stands on standard error."""
    result = stoss.run(f"restitution --body @{FILES}/bell.json --against @{FILES}/bar.json --speed 62.7")
    assert result.returncode == 1 and "nan" not in result.stdout + result.stderr
    assert result.stdout.count("not computed") == 2 and "modal data" in result.stderr or "computed" in result.stderr


@pytest.mark.parametrize("words, said", [
    # names of materials
    ("--material Glass --radius 1", "did you mean glass?"),
    ("--material aluminum --radius 1", "did you mean aluminium?"),
    ("--material ruby --radius 1", "allowed"),
    # hard on soft: the reason, and the way out
    ("--poisson 0.3 --against half-space,young=1e-4",
     "young ratio: got 0.0001, allowed 0.001 to 1e6 (of the half-space to the body; the waves of the stiffer one are too "
     "fast for the steps of the other: let the first be rigid (--rigid-body))"),
    ("--poisson 0.3 --against plate,thickness=1,young=1e-4", "of the plate to the body"),
    ("--poisson 0.3 --against half-space,young=1e7", "let it be a wall"),
    ("--poisson 0.3 --against sphere,young=1e4", "of the second body to the first; the waves"),
    # a loss time in the unit in which it is given
    ("--material glass --radius 0.01 --loss-time 31", "loss_time: got 31, allowed 0 to 0.18898"),
    ("--material glass --radius 0.01 --against sphere,material=ice,radius=0.02,loss_time=50",
     "against loss_time: got 50, allowed 0 to 0.6280"),
    ("--poisson 0.3 --speed 0.5 --against half-space,young=0.01,density=2", "c at so soft a body"),
])  # fmt: skip
def test_refusals_are_of_what_was_given(stoss, words, said):
    speed = "" if "--speed" in words else "--speed 0.05" if "--poisson" in words else "--speed 1"
    result = stoss.run("restitution --body sphere", words, speed)
    assert (result.returncode, result.stdout, result.stderr.count("\n")) == (3, "", 1), result.stderr
    assert said in result.stderr


def test_a_cutoff_is_refused_in_the_units_in_which_it_is_given(stoss):
    ball = f"impact --body @{FILES}/hollow_sphere.json --speed 0.01 --against half-space,material=glass --cutoff"
    (line,) = stoss.run(ball, "50").stderr.splitlines()
    most = float(re.search(r"cutoff: got 50, allowed above 0 to ([0-9.]+) \(in c/R of the first body", line)[1])
    assert 20 < most < 50 and "own time" not in line


def test_a_table_speaks_of_its_error(stoss):
    result = stoss.run("table --body rod --against wall --speed 1.19e-07:1.19e-06 --error 0.01")
    (line,) = result.stderr.splitlines()
    assert result.returncode == 1 and line.endswith("and the table needs less (allow a greater error)")
    assert "tolerance" not in line


def test_an_uncertainty_is_given_once(stoss):
    result = stoss.run("predict --body sphere --material glass --radius 1e-3 --speed 0.1 --uncertainty young=0.1 "
                       "--uncertainty young=0.2")  # fmt: skip
    assert result.returncode == 3 and result.stderr == "stoss: error: uncertainty young: given twice, allowed once\n"


@pytest.mark.parametrize("against", ["half-space,density=2,young=", "sphere,radius=2,young="])
def test_the_modulus_of_a_rigid_body_is_only_a_unit(stoss, against):
    """A rigid ball on what is 10^6 times softer, at the same speed in the wave speed of what deforms."""
    values = []
    for young, speed in (("1", "0.01"), ("1e-2", "0.001"), ("1e-6", "1e-5")):
        text = stoss.run("restitution --body sphere --poisson 0.3 --rigid-body --format json --speed", speed,
                         f"--against {against}{young}").stdout  # fmt: skip
        (row,) = json.loads(text)["records"]
        assert row["converged"]
        values.append((row["restitution"], row["restitution_error"], row["contact_time"] * float(speed)))
    assert values[1] == pytest.approx(values[0], rel=1e-9) and values[2] == pytest.approx(values[0], rel=1e-9)


def test_a_body_whose_curvatures_differ_has_a_value(stoss):
    """In its other curvature it has another unit of length, in which the step of the impact was refused."""
    result = stoss.run(f"restitution --body @{FILES}/bat_30.json --speed 0.01 --tolerance 0.1 --format json")
    assert result.returncode in (0, 1) and result.stderr.count("error") == 0
    (row,) = json.loads(result.stdout)["records"]
    assert 0 < row["restitution"] < 1 and 0 < row["restitution_error"] < 1


def test_a_trajectory_has_the_units_of_its_inputs(stoss, tmp_path):
    path = tmp_path / "t.csv"
    words = f"impact --body sphere --material glass --radius 0.001 --speed 0.1 --cutoff 6 --quiet --trajectory {path}"
    assert stoss.run(words).returncode == 0
    *head, names, first = path.read_text().splitlines()[: path.read_text().count("\n# ") + 3]
    given = dict(line[2:].split(": ", 1) for line in head if ": " in line)
    assert float(given["speed[m/s]"]) == 0.1
    names = names.split(",")
    assert names[-5:] == ["time_si[s]", "center_si[m]", "velocity_si[m/s]", "force_si[N]", "contact_half_width_si[m]"]
    row = dict(zip(names, map(float, first.split(","))))
    assert row["velocity_si[m/s]"] == pytest.approx(0.1, rel=1e-12)
    for name, unit in (("center", "R"), ("time", "R/c")):
        si = f"{name}_si[{'m' if unit == 'R' else 's'}]"
        scale = 0.001 if unit == "R" else 0.001 * float(given["speed"]) / 0.1
        assert row[si] == pytest.approx(scale * row[f"{name}[{unit}]"], rel=1e-12)
    # Without a material there is nothing to be in SI.
    assert stoss.run(f"impact --body disk --poisson 0.33 --speed 0.1 --cutoff 6 --quiet --trajectory {path}").returncode == 0
    assert "_si" not in path.read_text()


def test_rods_say_which_error_they_reach(stoss):
    rods = "restitution --body rod --speed 0.1 --against same"
    done = stoss.run(rods)
    assert done.returncode == 1
    reached = re.search(r"as so little is lost; try an absolute error of ([\d.e-]+) or larger", done.stderr)
    assert reached, done.stderr
    assert stoss.run(rods, f"--absolute {reached[1]}").returncode == 0
