"""The subcommands sweep, merge, fit, calibrate, and table as NetCDF, which the command stoss hands over.

The exit code is 1 where values of a merge are missing. A value that did not converge is there, with
its error: it makes no job fail.
"""

from __future__ import annotations

import json
import math
import os
import re
import warnings
from typing import Any, Sequence

import numpy as np

from stoss._arguments import refusal
from stoss._commands import Parser, guarded, on_terminal, put, say
from stoss._errors import InvalidInput, StossWarning
from stoss.calibration._calibration import calibrate
from stoss.export._files import require_writable, write_lines
from stoss.laws._fit import fit
from stoss.results._adaptive_rule import collision_rule
from stoss.results._progress import bar
from stoss.sweeps import _store
from stoss.sweeps._computation import material_warnings
from stoss.sweeps._grid import Grid
from stoss.sweeps._rows import Layout
from stoss.sweeps._specification import of_document
from stoss.sweeps._tasks import Part, Worker, fill, flush, missing, parts_of
from stoss.sweeps._values import Sweep, merge, values_of

LEFT_OUT = object()


def main(words: Sequence[str]) -> int:
    """Run one of them. Returns the exit code."""
    run = {"sweep": _sweep, "merge": _merge, "fit": _fit, "calibrate": _calibrate, "table": _table}[words[0]]
    kept = " (what was finished is in the store)" if run in (_sweep, _merge) else ""
    return guarded(lambda: run(words[1:]), f"interrupted{kept}")


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
    name, parts = f"shard-{shard}-of-{shards}", sample(grid, shard, shards)
    threads = given.threads or len(os.sched_getaffinity(0))
    with Worker(path, Layout(grid.computation), name) as worker:  # a second one of this shard ends here
        pieces = list(missing(grid, path, parts))
        with bar(sum(len(each.points) for each in pieces), on_terminal(), "sweep") as seen:
            done = fill(worker, grid.computation, path, pieces, threads, None if seen is None else seen.update)
    flush(path)
    found, own = values_of(grid, path), np.zeros(grid.shape, dtype=bool)
    for case, (begin, end) in parts:
        own[case.place].reshape(-1)[begin:end] = True
    values, doubtful = np.count_nonzero(own), np.count_nonzero(own & ~found.converged)
    say(f"stoss: shard {shard}/{shards}: {values} values, {done} computed now")
    if doubtful:
        hint = "they are in the store with their errors, converged is false"
        say(f"stoss: warning: {doubtful} of {values} values not as accurate as asked for ({hint})")
    for said in material_warnings(grid.cases(), float(grid.speed.max())):
        say(f"stoss: warning: {said}")
    return 0


def sample(grid: Grid, shard: int, shards: int) -> list[Part]:
    """The parts of a shard, which has its share of each body and of each partner.

    Parts are spread over [0, 1) by three irrational numbers, evenly along each row and each column of
    bodies and partners, whatever their numbers. Shards are successive pieces of equal length.
    """
    steps = (math.sqrt(5) - 1) / 2, math.sqrt(2) - 1, math.sqrt(3) - 1
    every = parts_of(grid)
    count = len(every) // len(grid.cases())

    def at(number: int) -> float:
        place = (*every[number].case.place, number % count)
        return sum(index * step for index, step in zip(place, steps)) % 1

    spread = [every[number] for number in sorted(range(len(every)), key=at)]
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
    require_writable(given.output)
    result = merge(given.store, given.output, mix=given.mix)
    if result.complete:
        return 0
    _tell_missing(result)
    return 1


def _tell_missing(result: Sweep) -> None:
    """The first missing values, and how many there are."""
    absent = np.argwhere(~result.computed)
    grid = result.grid
    for i, j, *places in absent[:5].tolist():
        at = zip(grid.axes.items(), places)
        point = ", ".join(f"{name} {axis[k]:.6g}{_unit(result, name)}" for (name, axis), k in at)
        case = grid.cases()[i * len(grid.against) + j]
        what = repr(case.against) if "number" in grid.axes else f"{case.body!r} against {grid.against[j]['kind']}"
        say(f"stoss: missing: {what}, {point}")
    if len(absent) > 5:
        say(f"stoss: missing: … and {len(absent) - 5} more")
    text = f"stoss: warning: {len(absent)} of {result.computed.size} values are missing (fill values in the file)"
    say(text)


def _unit(result: Sweep, name: str) -> str:
    unit = result._unit(name)
    return f" {unit}" if unit else ""


def _fit(words: Sequence[str]) -> int:
    parser = Parser("stoss fit", description="Fit a force law to elasticity.", allow_abbrev=False)
    parser.add_argument("encounter", metavar="DOCUMENT", help="who meets whom, as JSON")
    parser.add_argument("--law", required=True, metavar="NAME", help="the force law")
    parser.add_argument("--speed", required=True, nargs=2, type=float, metavar="V", help="slowest and fastest speed")
    parser.add_argument("--friction", type=float, default=0.0, metavar="MU", help="coefficient of friction")
    parser.add_argument("--program", metavar="NAME", help="whose lines are written")
    parser.add_argument("--threads", type=int, default=0, metavar="N", help="threads, 0 for all cores (default)")
    parser.add_argument("-o", "--output", metavar="FILE", help="file of the lines")
    given = parser.parse_args(words)
    output = None if given.output == "-" else given.output
    if output:
        require_writable(output)
    body, met = of_document(given.encounter)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", StossWarning)
        found = fit(
            body, against=met, law=given.law, speed=given.speed, friction=given.friction, program=given.program,
            threads=given.threads, progress=on_terminal(),
        )  # fmt: skip
    if output:
        found.write(output)
    else:
        put(str(found))
    for text in dict.fromkeys(str(each.message) for each in caught):
        say(f"stoss: warning: {text}")
    return 0


def _calibrate(words: Sequence[str]) -> int:
    parser = Parser("stoss calibrate", description="Find constants from measured impacts.", allow_abbrev=False)
    parser.add_argument("data", metavar="DATA", help="CSV file of the measurements")
    parser.add_argument("encounter", metavar="DOCUMENT", help="who meets whom, as JSON")
    parser.add_argument("--unknown", required=True, action="append", metavar="NAME[=START]", help="what is sought")
    parser.add_argument("--uncertainty", action="append", default=[], metavar="NAME=U", help="of what is held")
    parser.add_argument("--friction", type=float, metavar="MU", help="coefficient of friction")
    parser.add_argument("--without-air", action="store_true", help="heights and times without air")
    parser.add_argument("--format", default="table", choices=("table", "json", "csv"), help="how it is printed")
    parser.add_argument("--report", metavar="FILE", help="page in HTML")
    parser.add_argument("-o", "--output", metavar="FILE", help="file of what is printed")
    given = parser.parse_args(words)
    output = None if given.output == "-" else given.output
    for path in (output, given.report):
        if path:
            require_writable(path)
    body, met = of_document(given.encounter)
    found = calibrate(
        given.data, body, against="same" if met == body else met, unknown=_named("unknown", given.unknown, None),
        friction=given.friction, air=not given.without_air, progress=on_terminal(),
        uncertainties=_named("uncertainty", given.uncertainty),
    )  # fmt: skip
    lines = [str(found)] if given.format == "table" else [json.dumps(found.to_dict(), indent=2, ensure_ascii=False)]
    lines = [line.rstrip("\n") for line in found._lines()] if given.format == "csv" else lines
    if given.report:
        found.report(given.report)
    if output:
        write_lines(output, (f"{line}\n" for line in lines))
    else:
        put("\n".join(lines))
    return 0


def _named(option: str, given: Sequence[str], otherwise: Any = LEFT_OUT) -> dict[str, Any]:
    """What NAME=NUMBER says, each once; `otherwise`: of a name alone, if that may be."""
    found: dict[str, Any] = {}
    for text in given:
        name, sign, number = text.partition("=")
        if name in found or not sign and otherwise is LEFT_OUT:
            raise InvalidInput.out_of_range(option, repr(text), "NAME=NUMBER, each name once", "as in young=0.05")
        try:
            found[name] = float(number) if sign else otherwise
        except ValueError:
            raise InvalidInput.out_of_range(f"{option} {name}", repr(number), "a number") from None
    return found


def _table(words: Sequence[str]) -> int:
    parser = Parser("stoss table", description="Write a collision rule as NetCDF.", allow_abbrev=False)
    parser.add_argument("encounter", metavar="DOCUMENT", help="who meets whom, as JSON")
    parser.add_argument("--speed", required=True, nargs=2, type=float, metavar="V", help="slowest and fastest speed")
    parser.add_argument("--ratio", nargs=2, type=float, metavar="R", help="smallest and largest ratio of radii")
    parser.add_argument("--friction", type=float, metavar="MU", help="coefficient of friction")
    parser.add_argument("--error", type=float, required=True, help="maximum error of the restitution")
    parser.add_argument("--tolerance", type=float, required=True, help="maximum error of the sliding")
    parser.add_argument("--threads", type=int, default=0, metavar="N", help="threads, 0 for all cores (default)")
    parser.add_argument("-o", "--output", required=True, metavar="FILE", help="where it goes")
    given = parser.parse_args(words)
    require_writable(given.output)
    body, met = of_document(given.encounter)
    rule = collision_rule(
        body, against=met, speed=given.speed, ratio=given.ratio, friction=given.friction, error=given.error,
        tolerance=given.tolerance, threads=given.threads, progress=on_terminal(),
    )  # fmt: skip
    rule.to_netcdf(given.output)
    return 0
