"""Mends the theme Furo as Debian 12 packs it: its parts are not joined there, and it is never dark by itself.

The script is an ES module, which no browser loads from a folder, and the style sheet imports another one from a
server's /javascript/. A theme that is whole is left as it is.
"""

import re
from pathlib import Path

from sphinx.application import Sphinx

IMPORT = 'import Gumshoe from "./gumshoe-patched.js";'
NORMALIZE = re.compile(r"@import url\((/javascript/normalize.css/normalize.css)\);")
DARK = re.compile(r'body\[data-theme="dark"\] (\{[^}]*--color-foreground-primary[^}]*\})')


def mend(app: Sphinx, exception: Exception | None) -> None:
    if exception is not None or app.builder.format != "html":
        return
    static = Path(app.outdir) / "_static"
    script, style = static / "scripts/furo.js", static / "styles/furo.css"
    text = script.read_text(encoding="utf-8")
    if IMPORT in text:
        parts = (static / "scripts/gumshoe-patched.js").read_text(encoding="utf-8"), text.replace(IMPORT, "")
        script.write_text("\n".join(parts), encoding="utf-8")
    text = style.read_text(encoding="utf-8")
    if match := NORMALIZE.search(text):
        text = text.replace(match[0], Path(f"/usr/share{match[1]}").read_text(encoding="utf-8"))
        dark = f'body:not([data-theme="light"]) {DARK.search(text)[1]}'
        text += f"\n@media not print {{ @media (prefers-color-scheme: dark) {{ {dark} }} }}\n"
        style.write_text(text, encoding="utf-8")


def setup(app: Sphinx) -> dict:
    app.connect("build-finished", mend)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
