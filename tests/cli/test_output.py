"""Files, pipes, full disks, signals."""

import json
import os
import pty
import re
import shutil
import signal
import subprocess
import time

import pytest
from conftest import rows, wait_for_rows, wait_until_caught

pytestmark = pytest.mark.numbers

# Minutes of work.
LONG = "restitution --body disk --poisson 0.33 --speed log:1e-3:0.3:100000 --threads 2"


def test_output_file(stoss, tmp_path):
    path = tmp_path / "modes.csv"
    result = stoss.run(f"modes --body disk --poisson 0.33 --cutoff 3 --format csv -o {path}")
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")
    assert len(rows(path.read_text())) == 6


@pytest.mark.parametrize("subcommand", ["modes", "impact --speed 0.1", "restitution --speed 0.1,0.2"])
@pytest.mark.parametrize("form", ["table", "csv", "json"])
def test_full_disk(stoss, subcommand, form):
    with open("/dev/full", "w") as full:
        result = subprocess.run(
            [stoss.path, *f"{subcommand} --body disk --poisson 0.33 --format {form}".split()],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            timeout=60,
        )
    assert result.returncode == 4
    (line,) = result.stderr.splitlines()
    assert "cannot write" in line and "No space left" in line


@pytest.mark.parametrize("option", ["-o", "--trajectory"])
def test_unwritable_file(stoss, tmp_path, option):
    result = stoss.run(f"impact --body disk --poisson 0.33 --speed 0.1 {option} {tmp_path}/no/such/folder/x.csv")
    assert result.returncode == 4
    (line,) = result.stderr.splitlines()
    assert "cannot write" in line and "x.csv" in line


def test_closed_pipe(stoss):
    command = stoss.start("modes --body disk --poisson 0.33 --cutoff 200", stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert command.stdout.readline().split()[0] == "order"
    command.stdout.close()
    assert command.stderr.read() == ""
    assert command.wait(timeout=60) in (-signal.SIGPIPE, 4)


def test_closed_pipe_where_the_signal_is_ignored(stoss):
    command = subprocess.Popen(
        [stoss.path, *"modes --body disk --poisson 0.33 --cutoff 200".split()],
        preexec_fn=lambda: signal.signal(signal.SIGPIPE, signal.SIG_IGN),
        restore_signals=False,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    command.stdout.readline()
    command.stdout.close()
    assert command.stderr.read() == b""
    assert command.wait(timeout=60) == 4


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("form", ["csv", "json"])
def test_interrupt_keeps_the_rows_so_far(stoss, tmp_path, form, number):
    path = tmp_path / "curve"
    command = stoss.start(f"{LONG} --format {form} -o {path}", stderr=subprocess.PIPE)
    if form == "json":
        wait_until_caught(command, number)
        time.sleep(1.5)  # its records are written at the end
    else:
        wait_for_rows(command, path, 20)
    command.send_signal(number)
    assert command.wait(timeout=30) == 128 + number
    assert command.stderr.read() == "stoss: error: interrupted\n"
    text = path.read_text()
    if form == "json":
        document = json.loads(text)
        assert document["complete"] is False
        speeds = [record["speed"] for record in document["records"]]
    else:
        assert text.endswith("# interrupted: the rows above are complete, later ones are missing\n")
        table = rows(text)
        assert all(row["beyond_small_strain"] == "false" for row in table)
        speeds = [float(row["speed[c]"]) for row in table]
    assert len(speeds) >= (1 if form == "json" else 20)
    assert speeds == sorted(speeds) and speeds[0] == pytest.approx(1e-3)


def test_kill_leaves_whole_rows(stoss, tmp_path):
    path = tmp_path / "curve.csv"
    command = stoss.start(f"{LONG} --format csv -o {path}")
    wait_for_rows(command, path, 20)
    command.kill()
    command.wait(timeout=30)
    text = path.read_text()
    assert text.endswith("\n")
    assert all(row["beyond_small_strain"] == "false" for row in rows(text))


def test_interrupt_of_a_trajectory(stoss, tmp_path):
    """Its file appears at the end, with what rows there are; so many rows are kept beside it before."""
    path = tmp_path / "t.csv"
    arguments = f"impact --body disk --poisson 0.33 --speed 0.1 --step 5e-6 --nodes 16 --cutoff 2 --trajectory {path}"
    command = stoss.start(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    while not os.listdir(tmp_path):
        assert command.poll() is None
        time.sleep(0.05)
    command.send_signal(signal.SIGINT)
    assert command.wait(timeout=60) == 130 and os.listdir(tmp_path) == ["t.csv"]
    assert path.read_text().endswith("missing\n") and rows(path.read_text())


def test_refused_impact_leaves_the_trajectory_alone(stoss, tmp_path):
    path = tmp_path / "t.csv"
    path.write_text("precious")
    assert stoss.run(f"impact --body disk --poisson 0.33 --speed 0.1 --step 7 --trajectory {path}").returncode == 3
    assert path.read_text() == "precious"


@pytest.mark.parametrize("option", ["--help", "--version"])
def test_help_to_a_full_disk(stoss, option):
    with open("/dev/full", "w") as full:
        assert subprocess.run([stoss.path, option], stdout=full, stderr=subprocess.PIPE).returncode == 4


def test_dash_is_stdout(stoss, tmp_path):
    assert stoss.run("modes --body disk --poisson 0.33 --cutoff 3 -o -").stdout.startswith("  order")


def test_no_progress_bar_off_a_terminal(stoss, tmp_path):
    result = stoss.run(f"restitution --body disk --poisson 0.33 --speed 0.05,0.1 -o {tmp_path}/x")
    assert result.stderr == ""


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


@pytest.mark.parametrize("more", ["", "--quiet"])
def test_a_long_value_shows_what_it_has_come_to(stoss, more):
    terminal, end = pty.openpty()
    # Several seconds of work; it is interrupted as soon as it has said something.
    command = stoss.start(
        f"restitution --body disk --poisson -0.95 --speed 1 --tolerance 1e-4 {more}", stdout=subprocess.DEVNULL, stderr=end
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
    assert shown == (not more)
    assert "cutoff" not in text.replace("\r\n", "\r").split("\r")[-1]  # the line is gone at the end


def test_table_fits_80_columns(stoss):
    text = stoss.run("restitution --body disk --poisson 0.33 --speed 0.1,1e-8").stdout
    assert max(map(len, text.splitlines())) <= 80
    assert all(line == line.rstrip() for line in text.splitlines())
    steel = "--body disk --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01 --speed 1e-3,10"
    assert max(map(len, stoss.run("restitution", steel).stdout.splitlines())) <= 80


def test_many_threads_for_few_speeds(stoss):
    assert len(stoss.data("restitution --body disk --poisson 0.33 --speed 0.1 --threads 64")) == 1


def documents(stoss):
    folder = os.path.dirname(stoss.path)
    return [open(os.path.join(folder, name)).read() for name in ("stoss.1", "completion.bash")]


def test_manual_and_completion_have_the_options_of_the_help(stoss):
    manual, completion = documents(stoss)
    sections = {part.split("\n")[0]: part for part in re.split(r"\n\.S[SH] ", manual.replace("\\-", "-"))}
    assert not re.search("@[A-Z_]+@", manual + completion)
    for subcommand in ("modes", "impact", "restitution", "quasistatic", "table"):
        text = stoss.run(subcommand, "--help").stdout
        options = set(re.findall(r"^  (?:-\w,)?(--[a-z-]+)", text, re.MULTILINE))
        assert len(options) > 8
        manual_options = sections[f"stoss {subcommand}"] + sections["All subcommands"]
        assert set(re.findall(r"\\fB(--[a-z-]+)", manual_options)) == options
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

    bodies = ["wall", "same", "disk", "sphere", "rod", "half-space", "half-plane", "plate", "strip"]
    assert complete("stoss re") == ["restitution"]
    assert complete("stoss impact --tr") == ["--trajectory"]
    assert complete("stoss restitution --format ") == ["table", "csv", "json"]
    assert complete("stoss restitution --against ") == bodies
    assert complete("stoss impact --against e") == ["exponential"]
    assert complete("stoss restitution --against e") == []
    assert complete("stoss table --format ") == ["c", "two-column", "json", "netcdf"]
    assert complete("stoss impact --speed ") == []
    assert complete("stoss swe") == ["sweep"] and complete("stoss sweep grid.toml --sh") == ["--shard"]


@pytest.mark.skipif(shutil.which("groff") is None, reason="needs groff")
def test_manual_can_be_typeset(stoss):
    path = os.path.join(os.path.dirname(stoss.path), "stoss.1")
    result = subprocess.run(["groff", "-man", "-ww", "-Tascii", path], capture_output=True, text=True, timeout=60)
    assert (result.returncode, result.stderr) == (0, "")
