"""What measurements tell of constants, as lines for a terminal and as one page in HTML."""

from __future__ import annotations

import base64
import html
import importlib
import io
import os
from typing import Any, Iterable

from stoss import _core
from stoss.bodies._bodies import shown
from stoss.calibration._calibration import Calibration
from stoss.export._files import write_lines

PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>{title}</title>
<style>
body {{ font-family: sans-serif; max-width: 50em; margin: 2em auto; padding: 0 1em; color: #222 }}
table {{ border-collapse: collapse; margin: 1em 0 }}
th, td {{ padding: 0.2em 0.8em; text-align: right; border-bottom: 1px solid #ccc }}
th:first-child, td:first-child {{ text-align: left }}
img {{ max-width: 30em; width: 100% }}
</style>
</head>
<body>
<h1>{title}</h1>
<p>{who}</p>
{constants}
<p>The first uncertainty is the standard one of the data, the second that of constants that are held, the third the
numerical error.</p>
<p>{goodness}</p>
{notes}
<img alt="Measured and computed values against speed" src="data:image/png;base64,{picture}">
{values}
<p>stoss {version}</p>
</body>
</html>
"""


def lines(result: Calibration) -> list[str]:
    """Constants, what there is to say of them, and values."""
    told = [*map(str, result.constants)]
    names = [each.name for each in result.constants]
    for k in range(1, len(names)):
        told += [f"correlation of {names[j]} and {names[k]}: {result.correlation[k, j]:+.3f}" for j in range(k)]
    told += [result.goodness, *result.not_told_apart, *result.notes]
    head = {"quantity": 24, "speed": 10, "angle": 7, "measured": 13, "uncertainty": 12, "computed": 13, "residual": 9}
    told.append(
        "".join(f"{name:<{width}}" if name == "quantity" else f"{name:>{width}}" for name, width in head.items())
    )
    for k, name in enumerate(result.quantity):
        residual = (result.measured[k] - result.fitted[k]) / result.uncertainty[k]
        told.append(
            f"{name:24}{result.speed[k]:10.4g}{result.angle[k]:7.3g}{result.measured[k]:13.6g}"
            f"{result.uncertainty[k]:12.2g}{result.fitted[k]:13.6g}{residual:+9.2f}"
        )
    return told


def write(result: Calibration, path: str | os.PathLike[str]) -> None:
    """Write the page. It appears whole or not at all."""
    head = ("constant", "value", "± data", "± constants", "± numerical", "unit")
    constants = (
        (
            each.name,
            *(f"{of:.4g}" for of in (each.value, each.uncertainty, each.by_constants, each.numerical)),
            each.unit,
        )
        for each in result.constants
    )
    columns = result._table()
    rows = zip(
        *([f"{its:.5g}" if name != "quantity" else its for its in column.tolist()] for name, column in columns.items())
    )
    units = [f"{name}, {result._unit(name)}" if result._unit(name) else name for name in columns]
    said = (*result.not_told_apart, *result.notes)
    text = PAGE.format(
        title="Constants from measured impacts", who=html.escape(_who(result)), constants=_table(head, constants),
        goodness=html.escape(result.goodness), notes="".join(f"<p>{html.escape(each)}</p>" for each in said),
        picture=_picture(result), values=_table(units, rows), version=html.escape(_core.version),
    )  # fmt: skip
    write_lines(path, [text])


def _who(result: Calibration) -> str:
    if isinstance(result.against, str):
        return f"{shown(result.body)}, two of them"
    return shown(result.body, result.against)


def _table(head: Iterable[str], rows: Iterable[Iterable[Any]]) -> str:
    def line(cells: Iterable[Any], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(str(each))}</{tag}>" for each in cells) + "</tr>"

    return "<table>\n" + "\n".join([line(head, "th"), *(line(row, "td") for row in rows)]) + "\n</table>"


def _picture(result: Calibration) -> str:
    axes = importlib.import_module("stoss.plot").calibration(result)
    content = io.BytesIO()
    axes.figure.savefig(content, format="png", dpi=200)
    return base64.b64encode(content.getvalue()).decode("ascii")
