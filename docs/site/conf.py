"""Settings of the documentation site for Sphinx, which reads the tree that `generate` has put together."""

import importlib.metadata
import sys
from pathlib import Path

SITE = Path(__file__).parent
ROOT = SITE.parents[1]
sys.path.insert(0, str(SITE / "extensions"))

from repository import Slug  # noqa: E402

project = "stoss"
author = "the authors of stoss"
version = release = importlib.metadata.version("stoss")

extensions = [
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.napoleon",
    "breathe",
    "myst_parser",
    "sphinx_copybutton",
    "katex",
    "repository",
    "theme",
]
exclude_patterns = ["extra", "paper"]
root_doc = "index"
nitpicky = False

# The chapters are Markdown as forges show it: $…$, and headings that links name by their words.
myst_enable_extensions = ["dollarmath"]
myst_dmath_double_inline = True
myst_heading_anchors = 4
myst_heading_slug_func = Slug()

default_role = "py:obj"
autodoc_member_order = "bysource"
autodoc_typehints = "none"

autosummary_generate = False
napoleon_numpy_docstring = False
napoleon_custom_sections = [("Attributes", "params_style")]  # which may name several at once
napoleon_use_rtype = False
add_module_names = False

breathe_projects = {"stoss": str(ROOT / "build/docs-doxygen/xml")}
breathe_default_project = "stoss"
breathe_domain_by_extension = {"hpp": "cpp", "h": "c"}

html_theme = "furo"
html_title = f"stoss {version}"
html_favicon = str(ROOT / "web/src/icon.svg")
html_static_path = [str(SITE / "static")]
html_css_files = ["site.css"]
html_extra_path = [str(ROOT / "build/docs-source/extra")]
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
html_math_renderer = "katex"
pygments_style = "default"
pygments_dark_style = "monokai"


def escape_bars(app, what, name, obj, options, lines):
    """|x| is a magnitude in docstrings, no name of something to be put in its place."""
    lines[:] = [line if line.lstrip().startswith(">>>") else line.replace("|", r"\|") for line in lines]


def setup(app):
    app.connect("autodoc-process-docstring", escape_bars)
