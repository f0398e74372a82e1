"""What a user reads: help that fits the terminal, tables whose columns stand apart, and refusals of what was given."""

import fcntl
import json
import os
import pty
import re
import select
import struct
import subprocess
import termios
from pathlib import Path

import pytest

FILES = Path(__file__).resolve().parents[2] / "examples/any_body"
SUBCOMMANDS = ["", "modes", "impact", "bounce", "restitution", "oblique", "distribution", "quasistatic", "predict",
               "pulse", "row", "table", "fit", "calibrate", "relaxation", "materials", "schema", "sweep", "merge"]  # fmt: skip


def on_a_terminal(words, columns):
    """What the command prints on a terminal of that width."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    with subprocess.Popen([os.environ["STOSS"], *words], stdout=theirs) as process:
        text, ended = b"", False
        while not ended:  # our end of the terminal stays open, as what is in it can be lost when its last one closes
            ended = process.poll() is not None
            while select.select([ours], [], [], 0.02)[0]:
                text += os.read(ours, 65536)
        os.close(theirs)
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


def test_a_value_that_there_is_not_is_no_nan(stoss):
    """Known too close to the point: the row says so, and the reason stands on standard error."""
    result = stoss.run(f"restitution --body @{FILES}/bell.json --against @{FILES}/bar.json --speed 62.7")
    assert result.returncode == 1 and "nan" not in result.stdout + result.stderr
    assert result.stdout.count("not computed") == 2 and "modal data" in result.stderr or "computed" in result.stderr


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
    result = stoss.run(f"restitution --body @{FILES}/bat_30.json --speed 0.01 --tolerance 0.1 --format json "
                       "--against sphere,radius=0.01,material=glass")
    assert result.returncode in (0, 1) and result.stderr.count("error") == 0
    (row,) = json.loads(result.stdout)["records"]
    assert 0 < row["restitution"] < 1 and 0 < row["restitution_error"] < 1


def test_rods_say_which_error_they_reach(stoss):
    rods = "restitution --body rod --speed 0.1 --against same"
    done = stoss.run(rods)
    assert done.returncode == 1
    reached = re.search(r"as so little is lost; try an absolute error of ([\d.e-]+) or larger", done.stderr)
    assert reached, done.stderr
    assert stoss.run(rods, f"--absolute {reached[1]}").returncode == 0
