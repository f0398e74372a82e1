"""Closed and unwritable standard streams, and provenance that can be pasted."""

import json
import os
import resource
import shlex
import signal
import subprocess

import pytest
from conftest import rows

pytestmark = pytest.mark.numbers

LINEAR = "restitution --body disk --poisson 0.33 --speed 0.7 --format csv"  # warns of small strain


def closed(*descriptors):
    return lambda: [os.close(descriptor) for descriptor in descriptors]


@pytest.mark.parametrize("descriptors", [(2,), (0, 2), (0, 1, 2)])
def test_closed_descriptors_do_not_reach_the_file(stoss, tmp_path, descriptors):
    path = tmp_path / "curve.csv"
    words = [*LINEAR.split(), "-o", str(path)]
    assert subprocess.run([stoss.path, *words], preexec_fn=closed(*descriptors), timeout=60).returncode == 0
    text = path.read_text()
    assert "warning" not in text and len(rows(text)) == 1
    assert text.splitlines()[-1].startswith("0.33,0.7,")


@pytest.mark.parametrize("words", ["modes --body disk --poisson 0.33 --cutoff 3", "--help", "--version"])
def test_closed_stdout_is_an_error(stoss, words):
    result = subprocess.run(
        [stoss.path, *words.split()], preexec_fn=closed(1), stderr=subprocess.PIPE, text=True, timeout=60
    )
    assert result.returncode == 4
    assert "cannot write to stdout" in result.stderr


@pytest.mark.parametrize("words, status", [
    ("modes --body disk --poisson 0.33 --cutoff 3", 0), (LINEAR, 0), ("restitution --poisson 0.33 --speed 0.1 --tolerance 1e-12 --absolute 0", 1),
    ("modes --colour", 2), ("modes --body disk --poisson 7", 3), ("modes --poisson 0.33 -o /no/such/folder/x", 4),
])  # fmt: skip
def test_unwritable_stderr_changes_no_exit_code(stoss, words, status):
    with open("/dev/full", "w") as full:
        result = subprocess.run([stoss.path, *words.split()], stdout=subprocess.DEVNULL, stderr=full, timeout=60)
    assert result.returncode == status
    reader, writer = os.pipe()
    os.close(reader)
    result = subprocess.run(
        [stoss.path, *words.split()],
        preexec_fn=lambda: signal.signal(signal.SIGPIPE, signal.SIG_DFL),
        stdout=subprocess.DEVNULL,
        stderr=writer,
        timeout=60,
    )
    os.close(writer)
    assert result.returncode == status


def test_too_many_threads(stoss):
    def little_memory():
        resource.setrlimit(resource.RLIMIT_AS, (400_000_000, 400_000_000))

    if "ReserveShadowMemoryRange" in stoss.run("--version", preexec_fn=little_memory).stderr:
        pytest.skip("AddressSanitizer needs more address space than this")
    result = stoss.run("restitution --body disk --poisson 0.33 --speed 0.1,0.2 --threads 64", preexec_fn=little_memory)
    many = stoss.run("restitution --body disk --poisson 0.33 --speed lin:0.1:0.2:64 --threads 64", preexec_fn=little_memory)
    assert result.returncode in (0, 4) and many.returncode == 4
    assert many.stderr == "stoss: error: threads: cannot start as many as asked for (use --threads 1)\n"


NAMES = ["plain.csv", "two words.csv", "it's; $(date) & \"x\".csv", "line\nend\t\x1b.csv", "Maß.csv", "b\\s.csv"]


@pytest.mark.parametrize("form, name", [("csv", name) for name in NAMES] + [("json", NAMES[2])])
def test_command_line_can_be_pasted(stoss, tmp_path, name, form):
    words = ["modes", "--body", "disk", "--poisson", " 0.33", "--cutoff", "2", "--format", form, "-o", name]
    assert subprocess.run([stoss.path, *words], cwd=tmp_path, timeout=60).returncode == 0
    path = tmp_path / name
    text = path.read_text()
    command = json.loads(text)["command"] if form == "json" else text.splitlines()[1].removeprefix("# command: ")
    if "\n" not in name:
        assert shlex.split(command) == ["stoss", *words]
    path.unlink()
    shell = ["bash", "-c", f'stoss() {{ "$STOSS" "$@"; }}; {command}']
    assert subprocess.run(shell, cwd=tmp_path, env={**os.environ, "STOSS": stoss.path}, timeout=60).returncode == 0
    assert path.read_text() == text
