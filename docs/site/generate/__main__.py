"""Puts together what Sphinx reads, a folder of links to the pages of docs/ and of pages made here:

build/venv/bin/python docs/site/generate FOLDER STOSS
"""

import os
import sys
from pathlib import Path

import command
import cpp
import examples
import package
from tree import ROOT, Tree


def main(folder: Path, stoss: Path) -> None:
    tree = Tree(folder)
    for page in [*(ROOT / "docs").iterdir(), ROOT / "CHANGELOG.md", ROOT / "CONTRIBUTING.md"]:
        if page.name == "reference":  # beside pages that are made here
            for file in page.iterdir():
                tree.link(f"reference/{file.name}", file)
        elif page.is_dir() != (page.suffix == ".md") and page.name != "site":
            tree.link(page.name, page)
    page = ROOT / "build/docs-page"
    if (page / "index.html").exists():
        tree.link("extra/page", page)
        try_it = '<a href="page/index.html">Try it in the browser</a>: the same core on a page, with nothing to install.'
    else:
        try_it = "`make web-serve` serves the same core as a page for the browser."
    tree.write("page.inc", try_it + "\n")
    command.write(tree, stoss)
    cpp.write(tree)
    package.write(tree)
    examples.write(tree)
    tree.finish()


if __name__ == "__main__":
    os.chdir(ROOT)
    main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve())
