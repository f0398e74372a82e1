"""Runs the programs of examples/, each once, for their tests and for the documentation site.

A program runs again only if it, the package, or the body files have changed.
"""

import fcntl
import functools
import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

import stoss

ROOT = Path(__file__).resolve().parents[1]
EXAMPLES = ROOT / "examples"
KEPT = ROOT / "build/examples"
# What a program is warned of, its reader would not see. -W takes no warning of a package, and ignores it.
STRICTLY = """
import runpy, sys, warnings, stoss
warnings.simplefilter("error", stoss.StossWarning)
del sys.argv[0]
sys.path[0] = sys.argv[0].rpartition("/")[0]
runpy.run_path(sys.argv[0], run_name="__main__")
"""


@functools.cache
def package_state() -> bytes:
    state = hashlib.sha256()
    for file in sorted(Path(stoss.__path__[0]).rglob("*")):
        if file.suffix in (".py", ".so", ".npz"):
            state.update(file.read_bytes())
    return state.digest()


def files_state() -> bytes:
    """Of what programs may read: the body files."""
    state = hashlib.sha256()
    for file in sorted((EXAMPLES / "any_body").glob("*.json")):
        state.update(file.name.encode() + b"\0" + hashlib.sha256(file.read_bytes()).digest())
    return state.digest()


def run(name: str) -> Path:
    """The folder of a program: output.txt is what it printed, out/ what it wrote. Others that want it wait."""
    program = EXAMPLES / f"{name}.py"
    folder = KEPT / name
    folder.mkdir(parents=True, exist_ok=True)
    state = hashlib.sha256(package_state() + files_state() + program.read_bytes()).hexdigest()
    with open(folder / "lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (folder / "state").exists() or (folder / "state").read_text() != state:
            (folder / "state").unlink(missing_ok=True)
            shutil.rmtree(folder / "out", ignore_errors=True)
            # Without a display and without a chosen backend: as on a server.
            screen = ("MPLBACKEND", "DISPLAY", "WAYLAND_DISPLAY")
            environment = {key: value for key, value in os.environ.items() if key not in screen}
            command = [sys.executable, "-c", STRICTLY, str(program), "out"]
            done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, encoding="utf-8")
            assert done.returncode == 0, f"{program.name}: {done.stderr}"
            (folder / "output.txt").write_text(done.stdout, encoding="utf-8")
            (folder / "state").write_text(state)
    return folder
