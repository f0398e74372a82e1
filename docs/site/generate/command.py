"""The pages of the command, from its own help: every option is an entry of its own, which a search finds by name."""

import re
import subprocess
import textwrap
from pathlib import Path

from tree import Tree

COLUMN = 30  # of the help, where it says what an option does
HELP = re.compile(r"^-h,--help\b")  # every subcommand has it


def said(stoss: Path, *arguments: str) -> str:
    done = subprocess.run([stoss, *arguments, "--help"], capture_output=True, encoding="utf-8", check=True)
    return done.stdout.strip()


def literal(lines: list[str]) -> list[str]:
    return [".. code-block:: text", "", textwrap.indent(textwrap.dedent("\n".join(lines)), "   "), ""]


def heading(text: str, line: str) -> list[str]:
    return [text, line * len(text), ""]


def signature(option: str) -> str:
    """As Sphinx reads it: `-o,--output FILE` is `-o FILE, --output FILE`."""
    names, _, value = option.partition(" ")
    return ", ".join(f"{name} {value}".strip() for name in names.split(","))


def described(lines: list[str]) -> list[str]:
    """What an option does, as text, and the values that it takes, which are indented further, as they stand."""
    first = next((k for k, line in enumerate(lines) if line.startswith(" ")), len(lines))
    text = [re.sub(r"(--[a-z-]+)", r"``\1``", " ".join(lines[:first]).replace("*", r"\*").replace("|", r"\|")), ""]
    return text + (literal(lines[first:]) if first < len(lines) else [])


def options(block: list[str]) -> list[str]:
    """The entries of a group."""
    made: list[str] = []
    for entry in re.split(r"\n(?=  \S)", "\n".join(block)):
        head, *rest = entry.split("\n")
        name, _, text = head[2:].partition("  ")
        if not HELP.match(name):
            lines = [text.strip()] * bool(text.strip()) + [line[COLUMN:] for line in rest]
            made += [f".. option:: {signature(name)}", "", textwrap.indent("\n".join(described(lines)), "   "), ""]
    return made


def subcommand(name: str, text: str) -> list[str]:
    head, *groups = re.split(r"\n\n+(?=\S.*:\n  )", text)
    what, _, usage = head.partition("\nUsage: ")
    lines = [*heading(f"stoss {name}", "="), f"{' '.join(what.split())}.", "", *literal([usage])]
    lines += [f".. program:: stoss {name}", ""]
    for group in groups:
        title, _, block = group.partition(":\n")
        if title.startswith("Example"):
            lines += [f".. rubric:: {title}", "", *literal(block.split("\n"))]
        elif title == "Positionals":
            lines += literal(block.split("\n"))
        elif shown := options(block.split("\n")):
            lines += [f".. rubric:: {title}", "", *shown]
    return lines


def write(tree: Tree, stoss: Path) -> None:
    general = said(stoss)
    names = re.findall(r"^  ([a-z]+) ", general.partition("Subcommands:")[2], re.MULTILINE)
    lines = [*heading("Options of the command", "="), "What ``stoss --help`` and ``stoss SUBCOMMAND --help`` say;"]
    lines += [":doc:`the command </reference/command>` shows them at work.", "", *literal(general.split("\n"))]
    lines += [".. toctree::", "   :hidden:", "", *(f"   {name}" for name in names)]
    for name in names:
        tree.write(f"reference/command/{name}.rst", "\n".join(subcommand(name, said(stoss, name))) + "\n")
    tree.write("reference/command/index.rst", "\n".join(lines) + "\n")
