"""Does a command of another system compute what the one of this machine computes?

    compare.py NATIVE [EMULATOR...] COMMAND

Both run the same jobs. Numbers must agree to DIGITS, errors of values to ERROR_DIGITS, words and flags as they are.
They do not agree bit by bit: compilers contract and vectorise differently, and each system has a mathematical library
of its own.
"""

import csv
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

DIGITS = 1e-9
# An error has two digits that count, and is a difference of runs that agree to many.
ERROR_DIGITS = 1e-6
# As large as rounding itself: sums that would be 0.
NOISE = 1e-11

BALL = "--body sphere --material 'structural steel' --radius 0.005"
CURVE = "restitution --poisson 0.33 --speed 0.1,0.2,0.3"
JOBS = [
    "modes --poisson 0.33 --cutoff 10 --format csv",
    "impact --poisson 0.33 --speed 0.1 --cutoff 20 --format csv",
    "bounce --poisson 0.33 --speed 0.1 --count 3 --flight-time 100 --format csv",
    "quasistatic --poisson 0.33 --speed 1e-3 --format csv",
    f"{CURVE} --format csv",
    "restitution --body sphere --poisson 0.3 --speed 0.1 --format csv",
    "restitution --body sphere --poisson 0.3 --speed 0.01 --against half-space,poisson=0.22 --format csv",
    f"restitution {BALL} --speed 1 --against half-space,material=glass --format json",
    "restitution --body rod --speed 0.1 --against rod,length=2.5 --tolerance 0.01 --format csv",
    # Random numbers by counter: which mode vibrates how.
    "distribution --poisson 0.33 --speed 0.1 --temperature 0.02 --highest 4 --samples 3 --seed 7 --error 0.02"
    " --format csv",
    "oblique --body sphere --poisson 0.3 --speed 0.1 --angle 30 --friction 0.1 --format csv",
    "table --poisson 0.33 --speed 0.05:0.2 --error 1e-3",
    f"predict {BALL} --speed 0.5 --against half-space,material=glass --format csv",
    "schema",
    "materials --format json",
]
# A wrong name, a wrong number, a file that is not there: codes and lines of stderr.
REFUSED = ["restitution --poison 0.3", "restitution --poisson 3 --speed 0.1", f"{CURVE} -o no/such/folder/curve.csv"]

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
KEY = re.compile(r'\s*"(\w+)": ')


class Differs(Exception):
    """What the two have computed differs."""


def run(command, job, code=0):
    """What a job writes on stdout, or with an exit code above 0 on stderr; \\r\\n counts as it is."""
    done = subprocess.run([*command, *shlex.split(job)], capture_output=True, timeout=1200)
    if done.returncode != code:
        raise Differs(f"{job}: exit code {done.returncode}, not {code}\n{done.stderr.decode(errors='replace')}")
    return (done.stderr if code else done.stdout).decode()


def parts(text, is_csv):
    """A text in parts with the names that they have: cells by their columns, lines of JSON by their keys."""
    lines = text.splitlines()
    if not is_csv:
        return [(key[1] if (key := KEY.match(line)) else "", line) for line in lines]
    columns, *rows = csv.reader(line for line in lines if not line.startswith("#"))
    return [named for row in rows for named in zip(columns, row, strict=True)]


def same(expected, got, job):
    """The largest relative difference of numbers above 0.001, but of errors, in texts that must agree in all else."""
    if NUMBER.sub("#", expected) != NUMBER.sub("#", got):
        raise Differs(f"{job}: other words:\n{expected}\n{got}")
    is_csv = "--format csv" in job
    largest = 0.0
    for (name, mine), (_, other) in zip(parts(expected, is_csv), parts(got, is_csv), strict=True):
        is_error = "_error" in name
        for a, b in zip(map(float, NUMBER.findall(mine)), map(float, NUMBER.findall(other)), strict=True):
            size = max(abs(a), abs(b))
            if abs(a - b) > (ERROR_DIGITS if is_error else DIGITS) * size + NOISE:
                raise Differs(f"{job}: {b} instead of {a} {name}")
            if size > 1e-3 and not is_error:
                largest = max(largest, abs(a - b) / size)
    return largest


def kept(native, command, folder):
    """Files: what this machine has begun the other goes on with, and ends as it ends its own."""
    job = f"{CURVE} --format csv"
    whole = pathlib.Path(folder, "whole.csv")
    whole.write_text("of another job\n")
    run(command, f"{job} -o {whole}")
    if b"\r" in whole.read_bytes():
        raise Differs("lines end with CR")
    begun = pathlib.Path(folder, "begun.csv")
    run(native, f"{job} -o {begun}")
    lines = begun.read_bytes().splitlines(keepends=True)
    begun.write_bytes(b"".join(lines[:-2]) + lines[-2][:20])  # one row and a part of the next
    run(command, f"{CURVE} --resume {begun}")
    after = begun.read_bytes().splitlines(keepends=True)
    ends = whole.read_bytes().splitlines(keepends=True)
    if after[:-2] != lines[:-2] or after[-2:] != ends[-2:]:
        raise Differs("a file that was begun here is not ended there as its own")


def main(arguments):
    native, command = [arguments[0]], arguments[1:]
    largest = 0.0
    with tempfile.TemporaryDirectory() as folder:
        for job in JOBS:
            largest = max(largest, same(run(native, job), run(command, job), job))
        for job in REFUSED:
            code = subprocess.run([*native, *shlex.split(job)], capture_output=True).returncode
            same(run(native, job, code), run(command, job, code), job)
        kept(native, command, folder)
    print(f"{len(JOBS)} jobs agree, numbers above 0.001 to {largest:.1e}; {len(REFUSED)} are refused alike; "
          "a file is resumed")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except Differs as difference:
        sys.exit(f"compare: {difference}")
