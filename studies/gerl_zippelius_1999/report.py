"""The report: one HTML file with everything inside, that needs no network, no fonts and no scripts.

No date and no path enters it, so that two runs give the same bytes.
"""

from __future__ import annotations

import base64
import os
from html import escape
from pathlib import Path
from typing import NamedTuple, Sequence

import stoss

from gerl_zippelius_1999 import words
from gerl_zippelius_1999.common import NONE, Row

HEADINGS = ("Quantity", "Paper", "Protocol", "Converged")
ERRATUM = ("", "Paper", "Should be", "Section of the errata")
PIXELS = 134  # for an inch of a figure: larger than in print, where it would be 96
REPOSITORY = Path(__file__).resolve().parents[2]


class Outcome(NamedTuple):
    """What became of an item."""

    title: str
    caption: str
    alt: str
    rows: list[Row]
    meaning: str
    width: float  # of the figure, inches
    tables: list[str]
    computed: bool  # now, or before
    failure: str  # empty if there is none


STYLE = """
:root { color-scheme: light; --ink: #1b1f24; --faint: #59636e; --line: #d4d9df; --accent: #00588a; --ground: #f5f7f9;
  --wide: 60rem; --text: 44rem; }
* { box-sizing: border-box; }
html { font-size: 17px; -webkit-text-size-adjust: 100%; }
body { margin: 0; color: var(--ink); background: #fff; line-height: 1.55; overflow-wrap: break-word;
  font-family: Charter, "Bitstream Charter", "Iowan Old Style", "Source Serif 4", Georgia, "Liberation Serif", serif; }
header, main, footer { max-width: var(--wide); margin: 0 auto; padding: 0 1.25rem; }
header { padding-top: 3rem; }
h1, h2, h3, nav, table, .kind, .small, footer { font-family: system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial,
  "Liberation Sans", "DejaVu Sans", sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0.2rem 0 0.6rem; letter-spacing: -0.01em; }
h2 { font-size: 1.3rem; line-height: 1.3; margin: 3.5rem 0 0.8rem; padding-top: 1rem;
  border-top: 1px solid var(--line); }
h3 { font-size: 1rem; margin: 1.6rem 0 0.4rem; }
p, ul, ol, .narrow { max-width: var(--text); }
p { margin: 0.7rem 0; }
a { color: var(--accent); text-decoration-thickness: 1px; text-underline-offset: 2px; }
.kind { font-size: 0.8rem; color: var(--faint); text-transform: uppercase; letter-spacing: 0.06em; margin: 0; }
.small { font-size: 0.8rem; color: var(--faint); }
nav ol { list-style: none; margin: 0; padding: 0; columns: 2; column-gap: 2rem; max-width: none; font-size: 0.88rem; }
nav li { break-inside: avoid; padding: 0.14rem 0; }
nav a { text-decoration: none; }
nav a:hover { text-decoration: underline; }
figure { margin: 1.2rem 0; }
figure img { display: block; max-width: 100%; height: auto; margin: 0 auto 0.9rem; }
figcaption { max-width: var(--text); font-size: 0.92rem; line-height: 1.5; color: #333a42; }
.scroll { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; font-size: 0.82rem; line-height: 1.4; font-variant-numeric: tabular-nums;
  width: 100%; }
th, td { text-align: left; vertical-align: top; padding: 0.4rem 0.9rem 0.4rem 0; border-bottom: 1px solid var(--line); }
thead th { border-bottom: 1.5px solid var(--ink); font-weight: 600; white-space: nowrap; }
tbody th { font-weight: 400; }
.numbers { min-width: 40rem; }
.numbers th:first-child { width: 34%; }
.numbers td { width: 22%; }
.numbers .none { color: var(--faint); }
.converged { font-weight: 600; }
.errata { min-width: 40rem; }
.errata td:first-child { width: 3.2rem; white-space: nowrap; color: var(--faint); }
.failed { border-left: 4px solid #a33b00; padding: 0.5rem 1rem; background: #fdf3ec; max-width: var(--text); }
math { font-size: 1.08em; font-family: "Latin Modern Math", "STIX Two Math", "Cambria Math", "XITS Math",
  "TeX Gyre Termes Math", math, serif; }
math[display="block"] { margin: 0.9rem 0; }
.equation { overflow-x: auto; overflow-y: hidden; max-width: var(--text); }
cite { font-style: italic; }
footer { padding: 3rem 1.25rem 4rem; }
@media (max-width: 40rem) {
  html { font-size: 16px; }
  header { padding-top: 1.5rem; }
  h1 { font-size: 1.5rem; }
  nav ol { columns: 1; }
  math { font-size: 0.95em; }
  /* Small print would become too small to read: wide figures scroll instead. */
  .picture { overflow-x: auto; }
  .picture img { max-width: max(100%, 34rem); }
  /* A row of a table becomes a card, whose cells say which column they are. */
  .numbers, .errata { min-width: 0; }
  thead { position: absolute; left: -999rem; }
  tbody tr { display: grid; column-gap: 0.6rem; padding: 0.5rem 0; border-bottom: 1px solid var(--line); }
  .numbers tr { grid-template-columns: repeat(3, 1fr); }
  .numbers tbody th { grid-column: 1 / -1; }
  tbody th, tbody td, .numbers th:first-child, .numbers td, .errata td:first-child { width: auto; min-width: 0;
    padding: 0.1rem 0; border-bottom: 0; }
  td[data-column]:not([data-column=""])::before { content: attr(data-column); display: block; font-size: 0.7rem;
    font-weight: 400; color: var(--faint); }
}
@media print {
  html { font-size: 10pt; }
  h2, h3 { break-after: avoid; }
  figure, tr { break-inside: avoid; }
  .scroll, .equation { overflow: visible; }
  .numbers, .errata { min-width: 0; }
  a { color: inherit; text-decoration: none; }
}
"""


def html(outcomes: Sequence[tuple[str, Outcome]], quick: bool, folder: Path) -> str:
    """The page. The figures are read from the folder."""
    body = [_head(quick), _contents(outcomes), _section("introduction", "What this is", words.INTRODUCTION)]
    body += [_section("method", "The model", _scrolling(words.METHOD)), _glance(outcomes)]
    body += [_item(item, outcome, folder) for item, outcome in outcomes]
    body += [_errata(folder), _references()]
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>Gerl and Zippelius 1999, reproduced</title>\n<style>{STYLE}</style>\n</head>\n<body>\n"
        + "\n".join(body)
        + f'\n</main>\n<footer class="small">Made by stoss {escape(stoss.__version__)}, <code>make paper</code>.'
        "</footer>\n</body>\n</html>\n"
    )


def _head(quick: bool) -> str:
    note = '<p class="failed">This is the quick version: coarser than the full study.</p>' if quick else ""
    return (
        f'<header>\n<p class="kind">A paper reproduced · stoss {escape(stoss.__version__)}</p>\n'
        "<h1>Coefficient of restitution for elastic disks</h1>\n"
        f'<p>After {words.PAPER}. <a href="{words.DOI}">doi:10.1103/PhysRevE.59.2361</a></p>\n{note}</header>\n<main>'
    )


def _contents(outcomes: Sequence[tuple[str, Outcome]]) -> str:
    entries = [("introduction", "What this is"), ("method", "The model"), ("glance", "The paper’s numbers at a glance")]
    entries += [(item, outcome.title + (" – failed" if outcome.failure else "")) for item, outcome in outcomes]
    entries += [("errata", "Errata of the paper"), ("references", "References")]
    lines = "\n".join(f'<li><a href="#{name}">{escape(title)}</a></li>' for name, title in entries)
    return f'<nav aria-labelledby="contents">\n<h2 id="contents">Contents</h2>\n<ol>\n{lines}\n</ol>\n</nav>'


def _section(name: str, title: str, content: str) -> str:
    return f'<section id="{name}">\n<h2>{escape(title)}</h2>\n{content.strip()}\n</section>'


def _scrolling(content: str) -> str:
    """Wraps equations that are wider than the page, which scroll by themselves."""
    content = content.replace('<math display="block"', '<div class="equation"><math display="block"')
    return content.replace("</math>\n", "</math></div>\n")


def _glance(outcomes: Sequence[tuple[str, Outcome]]) -> str:
    """The verdict, and all numbers that the paper gives in one table."""
    rows = []
    for item, outcome in outcomes:
        name = outcome.title.split(":")[0]
        for quantity, *values in outcome.rows:
            if values[0] not in ("", NONE):
                link = f'<a href="#{item}">{escape(name)}</a>: {escape(quantity)}'
                rows.append(_row(link, values))
    text = "<p>Every number in the paper’s text about its figures and its table, with what stoss finds.</p>"
    return _section("glance", "The paper’s numbers at a glance", f"{words.VERDICT.strip()}\n{text}\n{_numbers(rows)}")


def _item(item: str, outcome: Outcome, folder: Path) -> str:
    if outcome.failure:
        return _section(item, outcome.title, f'<p class="failed">This item failed: {escape(outcome.failure)}</p>')
    rows = [_row(escape(quantity), values) for quantity, *values in outcome.rows]
    links = [f'<a href="figures/{item}.{kind}">{kind.upper()}</a>' for kind in ("svg", "png")]
    links += [f'<a href="data/{item}/{name}.csv">{name}.csv</a>' for name in outcome.tables]
    source, width = _picture(folder / "figures", item), round(outcome.width * PIXELS)
    picture = f'<img src="{source}" width="{width}" alt="{escape(outcome.alt)}">'
    content = (
        f'<figure>\n<div class="picture" tabindex="0">{picture}</div>\n<figcaption>{escape(outcome.caption)}'
        f'</figcaption>\n</figure>\n{_numbers(rows) if rows else ""}\n{_paragraphs(outcome.meaning)}\n'
        f'<p class="small">Next to this file: {" · ".join(links)}</p>'
    )
    return _section(item, outcome.title, content)


def _picture(folder: Path, item: str) -> str:
    """The figure as SVG or PNG, whichever is smaller, inside an address."""
    pictures = [((folder / f"{item}.{kind}").read_bytes(), name) for kind, name in (("svg", "svg+xml"), ("png", "png"))]
    content, name = min(pictures, key=lambda each: len(each[0]))
    return f"data:image/{name};base64,{base64.b64encode(content).decode()}"


def _paragraphs(text: str) -> str:
    return "\n".join(f"<p>{escape(part.strip())}</p>" for part in text.split("\n\n") if part.strip())


def _row(quantity: str, values: Sequence[str]) -> str:
    cells = "".join(
        f'<td class="{name.lower()}{" none" * (value == NONE)}" data-column="{name}">{escape(value)}</td>'
        for name, value in zip(HEADINGS[1:], values)
    )
    return f'<tr><th scope="row">{quantity}</th>{cells}</tr>'


def _numbers(rows: Sequence[str]) -> str:
    head = "".join(f'<th scope="col">{each}</th>' for each in HEADINGS)
    body = "\n".join(rows)
    return (
        f'<div class="scroll" tabindex="0">\n<table class="numbers">\n<thead><tr>{head}</tr></thead>\n'
        f"<tbody>\n{body}\n</tbody>\n</table>\n</div>"
    )


def _errata(folder: Path) -> str:
    theory = _documentation(folder)
    rows = []
    for paper, correct, name, anchor in words.ERRATA:
        label, _, title = name.partition(" ")
        place = f'<a href="{theory}#{anchor}">{title}</a>' if theory else title
        cells = zip(ERRATUM, (label, paper, correct, place))
        row = "".join(f'<td data-column="{name}">{content}</td>' for name, content in cells)
        rows.append(f"<tr>{row}</tr>")
    head = "".join(f'<th scope="col">{each}</th>' for each in ERRATUM)
    text = (
        "<p>stoss follows the column “Should be”. The section named at the end of each row has the derivation, or "
        "the computation, and the tests that show it. The main conclusion of the paper stands: collisions lose energy "
        "to vibration, and the loss vanishes in the limit of slow impacts. But the loss grows with the speed and with "
        "<i>ν</i> for fast impacts only (figure 1).</p>"
    )
    table = "\n".join(rows)
    return _section(
        "errata", "Errata of the paper",
        f'{text}\n<div class="scroll" tabindex="0">\n<table class="errata">\n<thead><tr>{head}</tr></thead>\n'
        f"<tbody>\n{table}\n</tbody>\n</table>\n</div>",
    )  # fmt: skip


def _documentation(folder: Path) -> str:
    """Path of docs/developer/derivations/errata.md from here; nothing if the report is outside the repository."""
    place = folder.resolve()
    return os.path.relpath(REPOSITORY / "docs/developer/derivations/errata.md", place) if REPOSITORY in place.parents else ""


def _references() -> str:
    lines = "\n".join(f"<li>{each}.</li>" for each in words.REFERENCES)
    return _section("references", "References", f"<ol>\n{lines}\n</ol>")
