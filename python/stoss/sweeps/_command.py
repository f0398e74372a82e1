"""`stoss sweep` and `stoss merge`, to which the command stoss hands over.

The exit code is 1 where values of a merge are missing. A value that did not converge is there, with
its error: it makes no job fail.
"""

from __future__ import annotations

import math
import os
import re
import sys
from typing import Sequence

import numpy as np

from stoss._arguments import refusal
from stoss._commands import Parser, guarded
from stoss.sweeps import _store
from stoss.sweeps._grid import Case, Grid
from stoss.sweeps._store import Worker
from stoss.sweeps._sweep import compute, missing
from stoss.sweeps._values import Sweep, merge, open_sweep


def main(words: Sequence[str]) -> int:
    """Run one of the two commands. Returns the exit code."""
    run = _sweep if words[0] == "sweep" else _merge
    return guarded(lambda: run(words[1:]), "interrupted (what was finished is in the store)")


def _sweep(words: Sequence[str]) -> int:
    parser = Parser("stoss sweep", description="Compute what a store lacks of the cases of a grid.", allow_abbrev=False)
    parser.add_argument("grid", metavar="GRID", help="TOML file of the grid")
    parser.add_argument("--store", required=True, metavar="DIR", help="directory of the values")
    parser.add_argument("--shard", metavar="I/N", help="only the I-th of N parts, from 1/N to N/N")
    parser.add_argument("--threads", type=int, default=0, metavar="N", help="threads, 0 for all cores (default)")
    given = parser.parse_args(words)
    shard, shards = _shard(given.shard)
    if not 0 <= given.threads <= 1024:
        raise refusal("threads", given.threads, "0 to 1024")
    grid = Grid.from_toml(given.grid)
    path = _store.create(given.store, grid)
    name = f"shard-{shard}-of-{shards}"
    cases = sample(grid, shard, shards)
    with Worker(path, name):  # before anything is computed: a second one of this shard ends here
        jobs = list(missing(grid, path, cases, given.threads or len(os.sched_getaffinity(0))))
    done = sum(compute(*job, name) for job in jobs)
    own = np.zeros(grid.shape, dtype=bool)
    for case in cases:
        own[case.place] = True
    values, doubtful = np.count_nonzero(own), np.count_nonzero(own & ~open_sweep(path).converged)
    print(f"stoss: shard {shard}/{shards}: {values} values, {done} computed now", file=sys.stderr)
    if doubtful:
        hint = "they are in the store with their errors, converged is false"
        print(f"stoss: warning: {doubtful} of {values} values not as accurate as asked for ({hint})", file=sys.stderr)
    return 0


def sample(grid: Grid, shard: int, shards: int) -> list[Case]:
    """The cases of a shard, which has its share of each body and of each partner.

    Cases are spread over [0, 1) by two irrational numbers, evenly along each row and each column of
    bodies and partners, whatever their numbers. Shards are successive pieces of equal length.
    """
    golden, other = (math.sqrt(5) - 1) / 2, math.sqrt(2) - 1
    spread = sorted(grid.cases(), key=lambda case: (case.place[0] * golden + case.place[1] * other) % 1)
    begin, end = (-(-len(spread) * piece // shards) for piece in (shard - 1, shard))
    return spread[begin:end]


def _shard(text: str | None) -> tuple[int, int]:
    if text is None:
        return 1, 1
    found = re.fullmatch(r"(\d{1,6})/(\d{1,6})", text, re.ASCII)
    if found is None or not 1 <= int(found[1]) <= int(found[2]):
        raise refusal("shard", text, "I/N with I from 1 to N")
    return int(found[1]), int(found[2])


def _merge(words: Sequence[str]) -> int:
    parser = Parser("stoss merge", description="Write the values of a store to one NetCDF file.", allow_abbrev=False)
    parser.add_argument("store", metavar="DIR", help="directory of the values")
    parser.add_argument("-o", "--output", required=True, metavar="FILE", help="NetCDF-4 file to write")
    parser.add_argument("--mix", action="store_true", help="take rows of other versions too, leave out other grids'")
    given = parser.parse_args(words)
    result = merge(given.store, given.output, mix=given.mix)
    if result.complete:
        return 0
    _tell_missing(result)
    return 1


def _tell_missing(result: Sweep) -> None:
    """The first missing values, and how many there are."""
    absent = np.argwhere(~result.computed)
    for i, j, k in absent[:5].tolist():
        partner = result.grid.against[j]["kind"]
        speed = f"{result.grid.speed[k]:.6g} {'m/s' if result.grid.in_si else 'c'}"
        print(f"stoss: missing: {result.grid.bodies[i]!r} against {partner}, speed {speed}", file=sys.stderr)
    if len(absent) > 5:
        print(f"stoss: missing: … and {len(absent) - 5} more", file=sys.stderr)
    text = f"stoss: warning: {len(absent)} of {result.computed.size} values are missing (fill values in the file)"
    print(text, file=sys.stderr)
