"""Which files a program makes or changes, for tests of the command and of the package."""

import functools
import os
import re
import shutil
import subprocess
from pathlib import Path

# Where programs leave things that nobody has named.
PLACES = ("HOME", "TMPDIR", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR")
CALLS = "openat,open,openat2,creat,mkdir,mkdirat,mknod,mknodat,rename,renameat,renameat2,link,linkat,symlink,symlinkat,truncate"


@functools.cache
def strace():
    """Whether the machine has it, and lets it look."""
    program = shutil.which("strace")
    return program if program and subprocess.run([program, "-qq", "-o", os.devnull, "true"], capture_output=True).returncode == 0 else None


class Watched:
    """An empty folder to work in, `here`, and empty ones in all PLACES."""

    def __init__(self, folder):
        self.folder, self.here = folder, folder / "here"
        self.environment = dict(os.environ)
        for name in PLACES:
            (folder / name).mkdir()
            self.environment[name] = str(folder / name)
        self.here.mkdir()
        self.environment |= {"ASAN_OPTIONS": "detect_leaks=0", "PYTHONDONTWRITEBYTECODE": "1"}  # no leaks under strace

    def run(self, *words, **options):
        """Runs the program; returns it, and the names in `here` that it wrote to, whether they are still there or not.

        Whatever is written elsewhere fails the test.
        """
        log = self.folder / "strace.log"
        traced = [strace(), "-f", "-qq", "-e", f"trace={CALLS}", "-o", log] if strace() else []
        done = subprocess.run([*traced, *words], cwd=self.here, env=self.environment, capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, timeout=300, **options)  # fmt: skip
        found = {path.relative_to(self.here) for path in self.here.rglob("*")}
        for name in PLACES:
            assert not list((self.folder / name).iterdir()), name
        if traced:
            found |= {path for line in log.read_text(errors="replace").splitlines() for path in self._written(line)}
        return done, {str(path) for path in found}

    def _written(self, line):
        """Names that a system call made or opened to be written."""
        call = re.search(r"\b(\w+)\((.*)\) += (-?\d+)", line)
        if call is None or int(call[3]) < 0:
            return
        if call[1].startswith("open") and not re.search(r"O_WRONLY|O_RDWR|O_CREAT|O_TRUNC", call[2]):
            return
        names = re.findall(r'"((?:[^"\\]|\\.)*)"', call[2])
        for name in names if not call[1].startswith("open") else names[:1]:
            path = Path(os.path.normpath(self.here / name))
            if path.is_relative_to("/dev"):  # terminals, /dev/null, shared memory, which is no file
                continue
            gcov = os.environ.get("GCOV_ERROR_FILE")  # of a build for coverage, beside which its counts are
            if gcov and path.is_relative_to(Path(gcov).parent):
                continue
            assert path.is_relative_to(self.here), line
            yield path.relative_to(self.here)
