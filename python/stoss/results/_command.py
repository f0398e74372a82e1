"""`stoss table --oblique --format netcdf`, which the command stoss hands over."""

from __future__ import annotations

from typing import Sequence

from stoss._commands import Parser, guarded, on_terminal
from stoss.export._files import require_writable
from stoss.results._adaptive_rule import collision_rule
from stoss.sweeps._specification import of_document


def main(words: Sequence[str]) -> int:
    """Run it. Returns the exit code."""
    return guarded(lambda: _write(words[1:]), "interrupted")


def _write(words: Sequence[str]) -> int:
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
