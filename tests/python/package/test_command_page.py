"""The lines of pages for the shell run as they stand, and print what the pages show, warnings included. A ```c block that
follows the name of a file, `name.c`:, is that file."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from test_guide import FILES, ROOT, agrees

COMMAND = "docs/reference/command.md"


def of(page):
    return (ROOT / page).read_text(encoding="utf-8")


PAGES = sorted(page for each in ROOT.glob("docs/**/*.md") if "```sh\n" in of(page := str(each.relative_to(ROOT))))


@pytest.mark.parametrize("page", PAGES)
def test_page(page, tmp_path):
    text = of(page)
    blocks = re.findall(r"^```sh\n(.*?)^```\n(?:```text\n(.*?)^```$)?", text, re.MULTILINE | re.DOTALL)
    for name, source in re.findall(r"^`(\w+\.c)`:\n\n```c\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        if shutil.which("cc") is None:
            pytest.skip("needs cc")
        (tmp_path / name).write_text(source)
    if page in FILES:
        shutil.copy(ROOT / FILES[page], tmp_path)
    folders = Path(os.environ["STOSS"]).parent, Path(sys.executable).parent  # with the package, for `stoss fit`
    environment = {**os.environ, "PATH": os.pathsep.join([*map(str, folders), os.environ["PATH"]])}
    wrong = []
    for lines, shown in blocks:
        done = subprocess.run(
            ["bash", "-e", "-c", lines], cwd=tmp_path, env=environment, encoding="utf-8", stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )  # fmt: skip
        assert done.returncode == 0, lines + done.stdout
        if not agrees(done.stdout, shown):
            wrong.append(f"{lines}printed\n{done.stdout}the page says\n{shown}")
    assert not wrong, "\n".join(wrong)
    assert blocks and (page != COMMAND or sum(bool(shown) for _, shown in blocks) > 4)


def test_page_shows_every_subcommand():
    help_text = subprocess.run([os.environ["STOSS"], "--help"], capture_output=True, encoding="utf-8").stdout
    names = re.findall(r"^  ([a-z]+) ", help_text.partition("Subcommands:")[2], re.MULTILINE)
    assert len(names) > 5 and all(f"stoss {name}" in of(COMMAND) for name in names)
