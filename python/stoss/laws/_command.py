"""`stoss fit`, to which the command stoss hands over."""

from __future__ import annotations

import warnings
from typing import Sequence

from stoss._commands import Parser, guarded, on_terminal, put, say
from stoss._errors import StossWarning
from stoss.export._files import require_writable
from stoss.laws._fit import fit
from stoss.sweeps._specification import of_document


def main(words: Sequence[str]) -> int:
    """Run it. Returns the exit code."""
    return guarded(lambda: _fit(words[1:]), "interrupted")


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
