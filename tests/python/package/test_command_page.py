"""The lines of docs/command.md run as they stand, and print what the page shows, warnings included."""

import os
import re
import subprocess
import sys
from pathlib import Path

from test_guide import ROOT, agrees

PAGE = (ROOT / "docs/command.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```sh\n(.*?)^```\n(?:```text\n(.*?)^```$)?", PAGE, re.MULTILINE | re.DOTALL)


def test_page(tmp_path):
    folders = Path(os.environ["STOSS"]).parent, Path(sys.executable).parent  # with the package, for `stoss fit`
    environment = {**os.environ, "PATH": os.pathsep.join([*map(str, folders), os.environ["PATH"]])}
    wrong = []
    for lines, shown in BLOCKS:
        done = subprocess.run(
            ["bash", "-e", "-c", lines], cwd=tmp_path, env=environment, encoding="utf-8", stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )  # fmt: skip
        assert done.returncode == 0, lines + done.stdout
        if not agrees(done.stdout, shown):
            wrong.append(f"{lines}printed\n{done.stdout}the page says\n{shown}")
    assert not wrong, "\n".join(wrong)
    assert sum(bool(shown) for _, shown in BLOCKS) > 5


def test_page_shows_every_subcommand():
    help_text = subprocess.run([os.environ["STOSS"], "--help"], capture_output=True, encoding="utf-8").stdout
    names = re.findall(r"^  ([a-z]+) ", help_text.partition("Subcommands:")[2], re.MULTILINE)
    assert len(names) > 5 and all(f"stoss {name}" in PAGE for name in names)
