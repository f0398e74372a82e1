"""Sets formulas in the reader's browser with KaTeX, from files that the site has itself."""

from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.fileutil import copy_asset

KATEX = Path("/usr/share/javascript/katex")


def inline(writer, node):
    writer.body.append(writer.starttag(node, "span", "", CLASS="math notranslate nohighlight"))
    writer.body.append(writer.encode(node.astext()) + "</span>")
    raise nodes.SkipNode


def display(writer, node):
    writer.body.append(writer.starttag(node, "div", "", CLASS="math notranslate nohighlight"))
    writer.body.append(writer.encode(node.astext().strip()) + "</div>\n")
    raise nodes.SkipNode


def copy(app: Sphinx, exception: Exception | None) -> None:
    if exception is None and app.builder.format == "html":
        there = Path(app.outdir) / "_static/katex"
        for name in ("katex.min.js", "katex.min.css"):
            copy_asset(str(KATEX / name), str(there))
        for font in (KATEX / "fonts").glob("*.woff2"):
            copy_asset(str(font), str(there / "fonts"))


def load(app: Sphinx, page: str, template: str, context: dict, doctree: nodes.document | None) -> None:
    """Only pages with formulas load KaTeX."""
    if page == "search":
        app.add_js_file("excerpts.js")
    if doctree is not None and any(doctree.findall(lambda node: isinstance(node, (nodes.math, nodes.math_block)))):
        app.add_css_file("katex/katex.min.css")
        app.add_js_file("katex/katex.min.js")
        app.add_js_file("formulas.js")


def setup(app: Sphinx) -> dict:
    app.add_html_math_renderer("katex", (inline, None), (display, None))
    app.connect("html-page-context", load)
    app.connect("build-finished", copy)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
