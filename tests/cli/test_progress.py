"""What a terminal shows on stderr while stdout goes elsewhere: no call is silent for longer than some seconds."""

import os
import pty
import re
import select
import shlex
import signal
import subprocess

import pytest

GLASS = "--body sphere --material glass --radius 0.005 --against half-space,material=glass"
BALL = "--body sphere --poisson 0.3"
LONG = {  # which take minutes and more
    "impact": "impact --body disk --poisson 0.33 --speed 1e-6 --cutoff 1000",
    "restitution of many speeds": f"restitution {BALL} --speed lin:0.01:0.1:20000 --tolerance 1e-4",
    "oblique at many speeds": f"oblique {BALL} --speed lin:0.01:0.1:20000 --friction 0.1 --angle 30 --against half-space",
    "distribution": f"distribution {BALL} --speed 0.1 --temperature 0.1 --samples 1000000",
    "bounce": f"bounce {BALL} --speed 0.1 --count 1000000 --flight-time 30",
    "table of a rule": f"table --oblique {BALL} --speed 1e-6:0.01 --error 1e-5",
    "predict": f"predict {GLASS} --speed log:1e-4:1:20000",
}


def shown(command, folder, enough):
    """What a terminal has got of stderr when it is enough, or when the command has ended; then Ctrl-C."""
    screen, stderr = pty.openpty()
    with open(folder / "stdout.txt", "w") as stdout:
        process = subprocess.Popen(command, stdout=stdout, stderr=stderr, stdin=subprocess.DEVNULL)
    os.close(stderr)
    text = ""
    try:
        while not enough(text) and select.select([screen], [], [], 120.0)[0]:
            try:
                text += os.read(screen, 4096).decode()
            except OSError:  # it has ended
                break
    finally:
        process.send_signal(signal.SIGINT)
        process.wait(60)
        os.close(screen)
    return text


@pytest.mark.numbers
@pytest.mark.parametrize("name", LONG)
def test_a_long_call_shows_on_the_terminal_that_it_goes_on(stoss, tmp_path, name):
    going_on = re.compile(r"\d\.\d s, |\] [1-9]\d*/\d+")
    text = shown([stoss.path, *shlex.split(LONG[name])], tmp_path, going_on.search)
    assert going_on.search(text) and "stoss:" not in text, text


def test_nothing_is_shown_where_it_is_not_wanted(stoss, tmp_path):
    job = f"restitution {BALL} --speed 0.01,0.02 --tolerance 0.1"
    end = re.compile(r"2/2\r\n")
    assert end.search(shown([stoss.path, *job.split()], tmp_path, end.search))
    assert shown([stoss.path, *job.split(), "--quiet"], tmp_path, bool) == ""
    assert stoss.run(job).stderr == ""
