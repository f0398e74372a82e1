"""Files, pipes, full disks, signals."""

import os
import pty
import re
import shutil
import signal
import subprocess

import pytest

pytestmark = pytest.mark.numbers

# Minutes of work.


@pytest.mark.parametrize("more, status", [("", 0), ("--tolerance 1e-12 --absolute 0", 1), ("--quiet", 0)])
def test_progress_bar_on_a_terminal(stoss, tmp_path, more, status):
    terminal, end = pty.openpty()
    command = stoss.start(f"restitution --body disk --poisson 0.33,0.2 --speed 0.1 -o {tmp_path}/x {more}", stderr=end)
    os.close(end)
    text = ""
    try:
        while part := os.read(terminal, 1000):
            text += part.decode()
    except OSError:  # Linux: the other end is closed
        pass
    os.close(terminal)
    assert command.wait(timeout=60) == status
    assert ("2/2\r\n" in text) == (more != "--quiet")
    # What else is said has lines of its own.
    starts = [line.split("\r")[-1] for line in text.split("\r\n") if "warning" in line]
    assert len(starts) == (3 if status else 0)
    assert all(line.startswith("stoss: warning: ") for line in starts)


def test_a_long_value_shows_what_it_has_come_to(stoss):
    terminal, end = pty.openpty()
    # Several seconds of work; it is interrupted as soon as it has said something.
    command = stoss.start(
        "restitution --body disk --poisson -0.95 --speed 1 --tolerance 1e-4", stdout=subprocess.DEVNULL, stderr=end
    )
    os.close(end)
    text, shown = "", False
    try:
        while part := os.read(terminal, 1000):
            text += part.decode()
            if not shown and re.search(r"\r[1-9][0-9.]* s, cutoff \d+, relative error of 1-eps\^2 so far \d", text):
                shown = True
                command.send_signal(signal.SIGINT)
    except OSError:  # Linux: the other end is closed
        pass
    os.close(terminal)
    command.wait(timeout=60)
    assert shown
    assert "cutoff" not in text.replace("\r\n", "\r").split("\r")[-1]  # the line is gone at the end


def documents(stoss):
    folder = os.path.dirname(stoss.path)
    return [open(os.path.join(folder, name)).read() for name in ("stoss.1", "completion.bash")]


def test_manual_and_completion_have_the_options_of_the_help(stoss):
    manual, completion = documents(stoss)
    sections = {part.split("\n")[0]: part for part in re.split(r"\n\.S[SH] ", manual.replace("\\-", "-"))}
    assert not re.search("@[A-Z_]+@", manual + completion)
    for subcommand in ("modes", "impact", "restitution", "quasistatic", "table"):
        text = stoss.run(subcommand, "--help").stdout
        options = set(re.findall(r"^  (?:-\w,)?(--[a-z0-9-]+)", text, re.MULTILINE))
        assert len(options) > 8
        manual_options = sections[f"stoss {subcommand}"] + sections["All subcommands"]
        assert set(re.findall(r"\\fB(--[a-z0-9-]+)", manual_options)) == options
        (words,) = re.findall(rf'^ +{subcommand}\) words="(.*)"', completion, re.MULTILINE)
        assert {word for word in words.split() if word.startswith("--")} == options


def test_completion(stoss):
    _, completion = documents(stoss)

    def complete(line):
        words = line.split(" ")
        script = f"""{completion}
COMP_WORDS=({" ".join(f"'{word}'" for word in words)}); COMP_CWORD={len(words) - 1}; _stoss
printf '%s\\n' "${{COMPREPLY[@]}}\""""
        result = subprocess.run(["bash", "-c", script], capture_output=True, text=True, timeout=60)
        assert result.stderr == ""
        return result.stdout.split()

    bodies = ["wall", "same", "disk", "sphere", "hollow-sphere", "rod", "half-space", "half-plane", "plate", "strip",
              "exponential"]
    assert complete("stoss re") == ["restitution", "relaxation"]
    assert complete("stoss impact --tr") == ["--trajectory"]
    assert complete("stoss restitution --format ") == ["table", "csv", "json"]
    assert complete("stoss restitution --against ") == bodies
    assert complete("stoss impact --against e") == ["exponential"]
    assert complete("stoss restitution --against e") == ["exponential"]
    assert complete("stoss table --format ") == ["c", "rust", "js", "two-column", "json", "netcdf"]
    assert complete("stoss impact --speed ") == []
    assert complete("stoss swe") == ["sweep"] and complete("stoss sweep grid.toml --sh") == ["--shard"]


@pytest.mark.skipif(shutil.which("groff") is None, reason="needs groff")
def test_manual_can_be_typeset(stoss):
    path = os.path.join(os.path.dirname(stoss.path), "stoss.1")
    result = subprocess.run(["groff", "-man", "-ww", "-Tascii", path], capture_output=True, text=True, timeout=60)
    assert (result.returncode, result.stderr) == (0, "")
