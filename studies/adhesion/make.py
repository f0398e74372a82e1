"""Adhesion of an elastic sphere: make.py PROGRAM FOLDER writes static.csv and impact.csv
(docs/developer/derivations/adhesion.md). PROGRAM is stoss_adhesion. All runs take about an hour of processor time.
A ball that is caught has the restitution 0; it keeps its energy, so that `lost` and `share` mean nothing then."""

import subprocess
import sys
from pathlib import Path

STATIC = (
    "tabor,rings,ratio,pull_off[wR],maugis_dugdale[wR],jump_in[(w2R/E*2)^1/3],jump_out[(w2R/E*2)^1/3],"
    "work[(w5R4/E*2)^1/3],share"
)
IMPACT = (
    "tabor,work[ER],ratio,speed[v_JKR],speed[c],modes_factor,rings_factor,steps_factor,cutoff[c/R],modes,rings,"
    "step[R/c],restitution,lost,share,imbalance,largest_imbalance,pull[wR],push[ER2],time[R/c],deepest[R],"
    "uniqueness,steps"
)

SOFT = (0.03, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.75, 0.8, 0.9, 1, 1.25, 1.5, 2, 2.5, 3)
FORMS = {"0": (0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 1, 2, 3), "0.3333333": (0.1, 0.3, 0.5, 1, 2, 3)}  # Lennard-Jones; a harder push

ACROSS = [f"{0.3 * 10 ** (i / 30):.4g}" for i in range(31)]
FEW = (0.5, 0.57, 0.65, 0.75, 0.85, 1, 1.15, 1.3, 1.5, 1.75, 2)
FAR = (3, 2, 1.5, 1.2, 1, 0.8, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1, 0.05)
CLOSE = (0.6, 0.685, 0.7, 0.72, 0.75, 0.8, 0.9, 1, 1.1, 1.2, 1.5, 2)
FINER = ("2 1 1", "1 2 1", "1 1 2", "2 2 2")  # modes, rings, steps


def static_runs():
    for tabor in SOFT:
        yield from (f"{tabor} {rings}" for rings in (100, 200))
    yield from (f"{tabor} 200" for tabor in (0.72, 0.73, 0.74))
    yield from ("3 400", "4 300", "4 450", "5 400", "5 600")
    for ratio, tabors in FORMS.items():
        yield from (f"{tabor} 200 {ratio}" for tabor in tabors)
    yield "3 400 0"


def impact_runs():
    yield from (f"1 1e-4 {speed}" for speed in ACROSS)
    yield from (f"1 1e-4 {speed} {finer}" for speed in (1.2, 0.6) for finer in ("1 1 1", *FINER))
    yield from (f"1 1e-4 {speed} 1 1 1 0.3333333" for speed in (1.2, 0.6))
    yield from (f"0.3 1e-4 {speed}" for speed in FAR)
    yield from (f"0.3 1e-4 {speed} {finer}" for finer in FINER for speed in (1, 0.3))
    yield from (f"{tabor} 1e-4 {speed}" for tabor in (0.5, 0.7, 1.5, 2) for speed in FEW)
    yield from (f"3 1e-4 {speed} 0.75" for speed in CLOSE)
    yield from ("3 1e-4 1.2 1", "3 1e-4 1.2 0.75 2", "3 1e-4 1.2 0.75 1 2")
    yield from (f"1 1e-3 {speed}" for speed in (0.5, 0.65, 0.85, 1, 1.3))
    yield from (f"1 1e-5 {speed}" for speed in (0.5, 0.65, 0.85, 1, 1.3))
    yield from (f"1 1e-6 {speed}" for speed in (0.28, 0.5, 0.75, 1, 1.3))
    yield from ("0.3 1e-6 1", "0.3 1e-4 0.02")


def stick_runs():
    """Between which speeds to look for the sticking speed."""
    yield from ("1 1e-4 0.28 0.45", "2 1e-4 0.4 0.8", "1.5 1e-4 0.3 0.7")


def write(program, kind, runs, head, target):
    """The last column of an impact is the time that it took."""
    with target.open("a", encoding="utf-8") as table:
        table.write("" if table.tell() else head + "\n")
        for run in runs:
            made = subprocess.run([program, kind, *run.split()], capture_output=True, text=True, check=True)
            for line in made.stdout.splitlines():
                table.write((line if kind == "static" else line.rpartition(",")[0]) + "\n")
            table.flush()


if __name__ == "__main__":
    PROGRAM, FOLDER = sys.argv[1], Path(sys.argv[2])
    write(PROGRAM, "static", static_runs(), STATIC, FOLDER / "static.csv")
    write(PROGRAM, "impact", impact_runs(), IMPACT, FOLDER / "impact.csv")
    write(PROGRAM, "stick", stick_runs(), IMPACT, FOLDER / "impact.csv")
