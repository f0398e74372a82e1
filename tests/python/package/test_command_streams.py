"""What the command hands over to Python ends as the rest of the command does, whatever its streams, locale and signals
are: exit codes 0 to 4, 130, or the signal; one line; never a traceback."""

import os
import resource
import shutil
import signal
import stat
import subprocess
import sys
import time

import pytest

pytestmark = pytest.mark.skipif("STOSS" not in os.environ, reason="needs the command in STOSS")

FIT = ("fit --body sphere --young 1e9 --poisson 0.3 --density 1000 --radius 0.01 --against same --speed 0.01:0.1 "
       "--law linear --threads 1").split()  # fmt: skip
GRID = 'speed = [0.01, 0.1]\ntolerance = 1e-2\nbodies = {kind = "sphere", poisson = [0.1, 0.3]}\n'
SWEEP = "sweep grid.toml --store store --threads 1".split()
MERGE = "merge store -o all.nc".split()
JOBS = [FIT, SWEEP, MERGE]
IDS = ["fit", "sweep", "merge"]


class Place:
    """The command in a folder of its own, with the Python of the tests first in PATH."""

    def __init__(self, folder, interpreter):
        self.folder = folder
        (folder / "grid.toml").write_text(GRID)
        path = os.pathsep.join([os.path.dirname(sys.executable), os.environ.get("PATH", os.defpath)])
        self.environment = {**interpreter.environment, "PATH": path}
        self.command = os.path.abspath(os.environ["STOSS"])

    def start(self, words, environment=None, **options):
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, **options}
        return subprocess.Popen([self.command, *words], cwd=self.folder, env=environment or self.environment, **pipes)

    def run(self, words, environment=None, **options):
        process = self.start(words, environment, **options)
        out, error = process.communicate(timeout=300)
        assert "Traceback" not in (error or "") and "Exception" not in (error or ""), error
        return process.returncode, out, error


@pytest.fixture
def place(tmp_path, interpreter):
    pytest.importorskip("scipy")
    pytest.importorskip("netCDF4")
    return Place(tmp_path, interpreter)


@pytest.fixture
def filled(place):
    assert place.run(SWEEP)[0] == 0
    return place


def closed(*descriptors):
    return lambda: [os.close(descriptor) for descriptor in descriptors]


@pytest.mark.parametrize("words", JOBS, ids=IDS)
@pytest.mark.parametrize("descriptors", [(0,), (2,), (0, 2)])
def test_closed_stderr_changes_nothing(filled, words, descriptors):
    assert filled.run(words, preexec_fn=closed(*descriptors))[0] == 0
    with open("/dev/full", "w") as full:
        assert filled.run(words, stderr=full)[0] == 0
    reader, writer = os.pipe()
    os.close(reader)
    assert filled.run(words, stderr=writer)[0] == 0
    os.close(writer)
    assert filled.run([*words, "--threads=x"], preexec_fn=closed(*descriptors))[0] == 2
    bad = {"fit": "--friction=-1", "sweep": "--shard=0/3"}.get(words[0])
    assert bad is None or filled.run([*words, bad], preexec_fn=closed(*descriptors))[0] == 3


def test_stdout_that_cannot_be_written(place):
    code, _, error = place.run(FIT, preexec_fn=closed(1))
    assert code == 4 and error.startswith("stoss: error: output: cannot write to stdout: ") and error.count("\n") == 1
    with open("/dev/full", "w") as full:
        code, _, error = place.run(FIT, stdout=full)
    assert (code, error) == (4, "stoss: error: output: cannot write to stdout: No space left on device\n")


@pytest.mark.parametrize("ignored", [False, True])
def test_a_pipe_that_nobody_reads(place, ignored):
    """Ends it as it ends the rest of the command."""
    reader, writer = os.pipe()
    os.close(reader)
    how = lambda: signal.signal(signal.SIGPIPE, signal.SIG_IGN if ignored else signal.SIG_DFL)  # noqa: E731
    code, _, error = place.run(FIT, stdout=writer, preexec_fn=how, restore_signals=False)
    os.close(writer)
    assert (code, error) == (4 if ignored else -signal.SIGPIPE, "")


@pytest.mark.parametrize("more", [{"LC_ALL": "C"}, {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
                                  {"PYTHONIOENCODING": "ascii"}, {"LC_ALL": "POSIX", "PYTHONIOENCODING": "latin-1"}])  # fmt: skip
def test_any_locale_gives_the_same_text(place, more):
    environment = {**place.environment, **more}
    plain = place.run(FIT, encoding="utf-8")
    assert plain[0] == 0 and not plain[1].isascii()
    assert place.run(FIT, environment, encoding="utf-8") == plain
    code, out, _ = place.run([*FIT, "-o", "Maß.txt"], environment, encoding="utf-8")
    assert (code, out) == (0, "") and (place.folder / "Maß.txt").read_text(encoding="utf-8") == plain[1]
    (place.folder / "Gitter ß.toml").write_text(GRID, encoding="utf-8")
    assert place.run(["sweep", "Gitter ß.toml", "--store", "Größe"], environment, encoding="utf-8")[0] == 0
    code, _, error = place.run(["sweep", "Größen.toml", "--store", "s"], environment, encoding="utf-8")
    assert code == 4 and "Größen.toml" in error


def little_time():
    resource.setrlimit(resource.RLIMIT_CPU, (20, 20))


@pytest.mark.parametrize("name", ["none/x", "folder", "pipe"])
@pytest.mark.parametrize("words", [FIT, ["merge", "store"],
                                   "table --body sphere --poisson 0.3 --against same --oblique --speed 1e-3:1e-2 --format netcdf".split()],
                         ids=["fit", "merge", "table"])  # fmt: skip
def test_an_output_that_cannot_be_written_is_refused_first(filled, words, name):
    """Before anything is computed: the tests' own refusal comes after it."""
    (filled.folder / "folder").mkdir()
    os.mkfifo(filled.folder / "pipe")
    code, out, error = filled.run([*words, "-o", name], preexec_fn=little_time)
    assert (code, out) == (4, "") and name in error and error.count("\n") == 1
    if words is FIT:  # of which the law is looked at first of all that is computed
        assert filled.run([*words[:-2], "--threads", "1025", "-o", name])[0] == 4


def test_output_replaces_stdout(place):
    code, plain, _ = place.run(FIT)
    assert place.run([*FIT, "-o", "-"]) == (code, plain, "")
    assert place.run([*FIT, "-o", "x"])[:2] == (0, "") and (place.folder / "x").read_text() == plain


@pytest.mark.parametrize("path", [None, "", "/nowhere"])
def test_without_a_path(place, path):
    """Python is looked for beside the command, and where systems have it."""
    folder = place.folder / "bin"
    folder.mkdir()
    (folder / "python3").write_text(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n')
    (folder / "python3").chmod(0o755)
    place.command = shutil.copy(place.command, folder / "stoss")
    environment = {name: value for name, value in place.environment.items() if name != "PATH"}
    if path is not None:
        environment["PATH"] = path
    code, out, error = place.run(FIT, environment)
    if path is None and code == 4:  # libc looks into /bin and /usr/bin, whose Python may not have the package
        assert error.startswith("stoss: error: Python package: got ") and error.count("\n") == 1
    else:
        assert (code, error) == (0, "") and out.startswith("misfit ")


def test_a_home_that_cannot_be_written(filled):
    home = filled.folder / "home"
    home.mkdir()
    home.chmod(0o500)
    environment = {**filled.environment, "HOME": str(home)}
    for words in JOBS:
        assert filled.run(words, environment)[0] == 0
        assert filled.run(words, {**environment, "HOME": "/nowhere"})[0] == 0
    assert list(home.iterdir()) == [] and stat.S_IMODE(home.stat().st_mode) == 0o500


def in_removed_folder(folder):
    def prepare():
        little_time()
        folder.mkdir()
        os.chdir(folder)
        folder.rmdir()

    return prepare


@pytest.mark.parametrize("words", [[*FIT, "-o", "x"], ["sweep", "../grid.toml", "--store", "s"], ["merge", "s", "-o", "x"]], ids=IDS)
def test_removed_folder(place, words):
    code, out, error = place.run(words, preexec_fn=in_removed_folder(place.folder / "gone"))
    assert code in (3, 4) and out == "" and error.count("\n") == 1 and error.startswith("stoss: error: ")
    assert not (place.folder / "gone").exists()


LONG = 'speed = "log:1e-3:0.1:400"\ntolerance = 1e-4\nabsolute = 0\nbodies = {kind = "sphere", poisson = "lin:0:0.4:8"}\n'


@pytest.mark.parametrize("job", ["sweep", *(pytest.param(job, marks=pytest.mark.long) for job in ("fit", "merge", "module", "modal"))])
def test_interrupted_at_any_time(filled, job):
    """20 instants from 0 to 1 s after Python has begun: one line and 130, if it has not ended."""
    (filled.folder / "long.toml").write_text(LONG)
    module = [sys.executable, "-m"]
    words = {
        "fit": [filled.command, *FIT], "sweep": [filled.command, *"sweep long.toml --store long --threads 1".split()],
        "merge": [filled.command, *MERGE], "module": [*module, "stoss", *"sweep long.toml --store long --threads 1".split()],
        "modal": [*module, "stoss.modal", "--help"],
    }[job]  # fmt: skip
    for trial in range(20):
        process = subprocess.Popen(
            words, cwd=filled.folder, env=filled.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
        )  # fmt: skip
        wait_for_python(process, module=words[0] == sys.executable)
        time.sleep(trial / 20)
        process.send_signal(signal.SIGINT)
        _, error = process.communicate(timeout=100)
        assert process.returncode in (0, 130), (trial, process.returncode, error)
        if process.returncode == 130:
            assert error.count("\n") == 1 and "error: interrupted" in error, (trial, error)
    if job == "sweep":
        assert filled.run(SWEEP)[0] == 0


def wait_for_python(process, module):
    """Until it is Python that runs and, of a module, the package is being imported, before which is no code of it."""
    while process.poll() is None:
        try:
            name = os.path.basename(os.readlink(f"/proc/{process.pid}/exe"))
            if "python" in name and (not module or "_core" in open(f"/proc/{process.pid}/maps").read()):
                return
        except OSError:
            pass  # it has just ended
