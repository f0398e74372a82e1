"""The gallery: every program of examples/ is run, and shown with what it prints and draws."""

import ast
import concurrent.futures
import os
import re
import sys
import textwrap
from pathlib import Path

from tree import ROOT, Tree

sys.path.insert(0, str(ROOT / "scripts"))
from run_examples import run  # noqa: E402


def described(text: str) -> tuple[str, list[str]]:
    """Title of a program and the rest of its docstring as Markdown: indented paragraphs are equations."""
    first, *paragraphs = re.split(r"\n\s*\n", text.strip())
    title, _, more = " ".join(first.split()).rstrip(".").partition(": ")
    lines = [f"{more[0].upper()}{more[1:]}.", ""] if more else []
    for paragraph in paragraphs:
        if paragraph.startswith("    "):
            lines += ["```text", textwrap.dedent(paragraph), "```", ""]
            continue
        for line in re.split(r"\n(?=\w+:)", paragraph):
            said, _, what = line.partition(":") if re.match(r"(Run|Expect):", line) else ("", "", line)
            what = " ".join(what.split())
            if said == "Run":
                what = re.sub(r"^.*?\]", r"`\g<0>`", what)
            lines += [f"**{said}:** {what}" if said else what, ""]
    return title, lines


def page(tree: Tree, program: Path, folder: Path) -> tuple[str, str]:
    source = program.read_text(encoding="utf-8")
    title, lines = described(ast.get_docstring(ast.parse(source)) or program.stem)
    pictures = sorted((folder / "out").glob("*.png"))
    for picture in pictures:
        tree.copy(f"examples/pictures/{picture.name}", picture)
        lines += [f"![{title}](pictures/{picture.name})", ""]
    lines += ["## What it prints", "", "```text", (folder / "output.txt").read_text(encoding="utf-8").rstrip(), "```"]
    lines += ["", "## Program", "", "```python", source.rstrip(), "```"]
    tree.write(f"examples/{program.stem}.md", "\n".join([f"# {title}", "", *lines]) + "\n")
    return title, pictures[0].name


def write(tree: Tree) -> None:
    programs = sorted((ROOT / "examples").glob("*.py"))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        folders = list(pool.map(lambda program: run(program.stem), programs))
    lines = ["# Examples", "", "Short programs, in `examples/`, with what they print and draw. Each runs as it stands.", ""]
    for program, folder in zip(programs, folders):
        title, picture = page(tree, program, folder)
        lines += [f"## [{title}]({program.stem}.md)", "", f"[![{title}](pictures/{picture})]({program.stem}.md)", ""]
    lines += ["```{toctree}", ":hidden:", "", *(program.stem for program in programs), "```"]
    tree.write("examples/index.md", "\n".join(lines) + "\n")
