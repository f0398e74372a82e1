"""The page of the command, from its own help."""

import re
import subprocess
from pathlib import Path

from tree import Tree


def said(stoss: Path, *arguments: str) -> str:
    done = subprocess.run([stoss, *arguments, "--help"], capture_output=True, encoding="utf-8", check=True)
    return done.stdout.strip()


def write(tree: Tree, stoss: Path) -> None:
    general = said(stoss)
    names = re.findall(r"^  ([a-z]+) ", general.partition("Subcommands:")[2], re.MULTILINE)
    text = ["# Command line", "", "What `stoss --help` and `stoss SUBCOMMAND --help` print.", ""]
    for title, help_text in [("stoss", general), *((f"stoss {name}", said(stoss, name)) for name in names)]:
        text += [f"## {title}", "", "```text", help_text, "```", ""]
    tree.write("reference/command.md", "\n".join(text))
