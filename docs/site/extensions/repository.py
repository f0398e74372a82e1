"""Reads the Markdown of the repository as forges do: formulas in ```math, links to files and folders beside docs/, and
pictures with a caption below."""

import dataclasses
import os
import re
from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform

ROOT = Path(__file__).parents[3]


@dataclasses.dataclass(frozen=True)
class Slug:
    """The anchor that a forge gives to a heading; no function, which Sphinx would take for a changed setting."""

    def __call__(self, title: str) -> str:
        return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def page_of(path: Path) -> str | None:
    """The page of the site that shows a file or a folder of the repository."""
    name = str(path.relative_to(ROOT))
    if name == "README.md":
        return "index"  # says the same
    if name in ("CHANGELOG.md", "CONTRIBUTING.md"):
        return name.removesuffix(".md")
    if name == "examples":
        return "examples/index"
    if match := re.fullmatch(r"(examples/\w+)\.py", name):
        return match[1]
    match = re.fullmatch(r"docs/(?!paper/)(.+)\.md", name)  # the paper is for other programs
    return match and match[1]


class Formulas(SphinxTransform):
    """Makes formulas of the code blocks whose language is math."""

    default_priority = 20

    def apply(self) -> None:
        for block in list(self.document.findall(nodes.literal_block)):
            if block.get("language") == "math":
                text = block.astext()
                formula = nodes.math_block(text, text, nowrap=False, number=None, label=None, docname=self.env.docname)
                formula.source, formula.line = block.source, block.line
                block.replace_self(formula)


class Figures(SphinxTransform):
    """Makes a figure of a paragraph that holds a picture alone; the next is its caption if all of it is emphasised."""

    default_priority = 20

    def apply(self) -> None:
        for picture in list(self.document.findall(nodes.image)):
            paragraph = picture.parent
            if not isinstance(paragraph, nodes.paragraph) or len(paragraph) > 1:
                continue
            place = paragraph.parent.index(paragraph) + 1
            below = paragraph.parent[place] if place < len(paragraph.parent) else None
            if isinstance(below, nodes.paragraph) and len(below) == 1 and isinstance(below[0], nodes.emphasis):
                figure = nodes.figure("", picture.deepcopy(), nodes.caption("", "", *below[0].children))
                below.parent.remove(below)
                paragraph.replace_self(figure)


class Links(SphinxTransform):
    """Leads links to the page that shows a file, or else to the file itself; of a folder, to its files."""

    default_priority = 20

    def apply(self) -> None:
        page = Path(self.env.doc2path(self.env.docname)).resolve()
        if Path(self.env.srcdir) in page.parents:
            return  # made for the site
        for kind in (addnodes.pending_xref, addnodes.download_reference):
            for link in list(self.document.findall(kind)):
                target, _, anchor = link["reftarget"].partition("#")
                if link.get("reftype") == "myst" and target:
                    self.lead(link, Path(os.path.normpath(page.parent / target)), anchor)

    def lead(self, link: nodes.Element, file: Path, anchor: str) -> None:
        if ROOT not in file.parents or not file.exists():
            return  # which the builder reports
        if shown := page_of(file):
            if re.fullmatch(r"README|[\w/]+\.md", link.astext()):
                link["refexplicit"] = False  # the title of the page takes the place of its file's name
            there = os.path.relpath(f"{shown}.md", os.path.dirname(self.env.docname) or ".")
            self.replace(link, addnodes.pending_xref, f"{there}#{anchor}" if anchor else there)
        elif file.is_file():
            self.replace(link, addnodes.download_reference, self.beside(file))
        else:
            self.list_files(link, file)

    def replace(self, link: nodes.Element, kind: type, target: str) -> None:
        made = kind(**{**link.attributes, "reftarget": target, "refwarn": True})
        made.source, made.line = link.source, link.line
        made += link.children
        link.replace_self(made)

    def list_files(self, link: nodes.Element, folder: Path) -> None:
        parts = [*link.children, nodes.Text(" (")]
        for file in sorted(file for file in folder.iterdir() if file.is_file()):
            name = nodes.literal("", file.name, classes=["download"])
            parts += [addnodes.download_reference("", "", name, refdoc=self.env.docname, reftarget=self.beside(file))]
            parts += [nodes.Text(", ")]
        link.replace_self([*parts[:-1], nodes.Text(")")])

    def beside(self, file: Path) -> str:
        return "/" + os.path.relpath(file, self.env.srcdir)


def setup(app: Sphinx) -> dict:
    app.add_transform(Formulas)
    app.add_transform(Figures)
    app.add_transform(Links)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
