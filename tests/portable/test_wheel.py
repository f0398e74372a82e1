"""The Python package for other machines: its sources are whole, and the wheel made of them runs where it says."""

import os
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile

import pytest

from conftest import OFFLINE, ROOT, TREE, VERSION, run

PIP = ["-m", "pip", "--disable-pip-version-check", "--quiet"]
CHECK = ROOT / "scripts/check_wheel.py"


@pytest.fixture(scope="session")
def sdist(tmp_path_factory):
    folder = tmp_path_factory.mktemp("sdist")
    code = f"from setuptools import build_meta; build_meta.build_sdist({str(folder)!r})"
    shutil.rmtree(ROOT / "python/stoss.egg-info", ignore_errors=True)
    run(sys.executable, "-c", code, cwd=ROOT)
    return folder / f"stoss-{VERSION}.tar.gz"


def built(sources, into, **environment):
    """The wheel that pip makes of the sources, without network."""
    words = [*PIP, "wheel", "--no-build-isolation", "--no-deps", "--no-index", "--wheel-dir", into, sources]
    run(sys.executable, *words, env={**OFFLINE, **environment}, timeout=3000)
    (wheel,) = into.iterdir()
    return wheel


@pytest.fixture(scope="session")
def wheel(sdist, tmp_path_factory):
    """The wheel as it is given away; its module is that of the build tree."""
    made = built(sdist, tmp_path_factory.mktemp("made"), STOSS_BUILD_TREE=str(TREE))
    folder = tmp_path_factory.mktemp("wheel")
    run(sys.executable, CHECK, made, "--into", folder)
    (tagged,) = folder.iterdir()
    return tagged


def epsilon_of(wheel, folder):
    """ε and the maximum force of an impact, by the wheel in an environment of its own."""
    run(sys.executable, "-m", "venv", "--system-site-packages", folder)
    python = folder / "bin/python"
    run(python, *PIP, "install", "--no-index", "--no-deps", wheel, env=OFFLINE)
    code = (
        "import stoss\n"
        f"assert stoss.__file__.startswith({str(folder)!r}), stoss.__file__\n"
        "r = stoss.impact(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(poisson=0.2), speed=0.02, cutoff=20)\n"
        "print(stoss.__version__, float(r.restitution).hex(), float(r.max_force).hex())\n"
    )
    version, *values = run(python, "-c", code, cwd=folder, env=OFFLINE).stdout.split()
    assert version == VERSION
    return [float.fromhex(value) for value in values]


def of_the_command(record):
    line = "impact --body sphere --poisson 0.3 --against half-space,poisson=0.2 --speed 0.02 --cutoff 20"
    row = record(line)
    return [row["restitution"], row["max_force"]]


def test_the_sources_are_whole(sdist):
    with tarfile.open(sdist) as archive:
        packed = {name.partition("/")[2] for name in archive.getnames()}
    listed = subprocess.run(["git", "ls-files", "src", "include", "cmake", "python"], cwd=ROOT, capture_output=True)
    if listed.returncode != 0:
        pytest.skip("not in a clone of the repository")
    needed = {"CMakeLists.txt", "LICENSE", "README.md", "pyproject.toml", "setup.py", *listed.stdout.decode().split()}
    assert not needed - packed
    assert not [name for name in packed if re.search(r"\.so$|\.pyc$|^build/|^tests/", name)]


def test_the_wheel_says_what_the_command_says(wheel, record, tmp_path):
    assert epsilon_of(wheel, tmp_path / "venv") == of_the_command(record)


def test_pip_takes_it_on_the_systems_of_its_name_only(wheel, tmp_path):
    least = int(re.search(r"manylinux_2_(\d+)_", wheel.name)[1])
    machine = re.search(r"manylinux_2_\d+_(\w+)", wheel.name)[1]

    def status(minor):
        words = ["install", "--no-index", "--no-deps", "--only-binary=:all:", "--target", tmp_path / str(minor)]
        platform = f"manylinux_2_{minor}_{machine}"
        words = [sys.executable, *PIP, *map(str, words), "--platform", platform, str(wheel)]
        return subprocess.run(words, env=OFFLINE, capture_output=True).returncode

    assert (status(least), status(least - 1)) == (0, 1)


# What keeps a module from running elsewhere: how it is linked, and the line that says so.
FAKE = "{ global: fake; };"
WRONG = {
    "a library": (["-Wl,--no-as-needed", "-l:libz.so.1"], r"needs libz\.so\.1, allowed libc\.so\.6, .* \(link it in\)"),
    "a path": (["-Wl,-rpath,/opt/lib"], r"searches /opt/lib, allowed no path of its own"),
    "new symbols": (["libstdc++.so.6"], r"needs GLIBCXX_9\.9, allowed up to GLIBCXX_3\.4\.\d+"),
    "other symbols": (["libm.so.6"], r"needs symbols OTHER_1\.0, allowed those of GLIBC, "),
}


def checked(wheel):
    done = subprocess.run([sys.executable, CHECK, wheel], capture_output=True, text=True, timeout=60)
    return done.returncode, done.stderr.splitlines()


def wheel_of(files, folder):
    path = folder / "any-1-cp311-cp311-linux_x86_64.whl"
    with zipfile.ZipFile(path, "w") as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return path


@pytest.fixture
def module(tmp_path):
    """Links a module of one function that calls fake(); returns its bytes."""
    (tmp_path / "module.c").write_text("void fake(void); void called(void) { fake(); }")
    (tmp_path / "own.c").write_text("void fake(void) {}")
    for name, version in {"libstdc++.so.6": "GLIBCXX_9.9", "libm.so.6": "OTHER_1.0"}.items():
        (tmp_path / "version").write_text(f"{version} {FAKE}")
        words = ["-shared", "-nostdlib", "own.c", "-o", name, f"-Wl,-soname,{name}", "-Wl,--version-script,version"]
        run("cc", *words, cwd=tmp_path)

    def linked(*with_):
        own = [] if with_ and with_[0] in os.listdir(tmp_path) else ["own.c"]
        run("cc", "-shared", "-fPIC", "module.c", *own, *with_, "-o", "module.so", cwd=tmp_path)
        return (tmp_path / "module.so").read_bytes()

    return linked


@pytest.mark.parametrize("words, line", WRONG.values(), ids=WRONG)
def test_a_module_that_runs_here_only_is_named(module, tmp_path, words, line):
    status, lines = checked(wheel_of({"any.cpython-311-x86_64.so": module(*words)}, tmp_path))
    assert (status, len(lines)) == (1, 1)
    assert re.fullmatch(rf"check_wheel: any\.cpython-311-x86_64\.so: {line}.*", lines[0])


def test_a_module_of_another_python_is_named(module, tmp_path):
    status, lines = checked(wheel_of({"any.cpython-39-x86_64.so": module()}, tmp_path))
    assert (status, len(lines)) == (1, 1) and "allowed that of the Python of the wheel's tag cp311" in lines[0]


def test_a_wheel_without_a_module_is_none(tmp_path):
    status, lines = checked(wheel_of({"any.py": ""}, tmp_path))
    assert (status, len(lines)) == (1, 1) and "got no compiled module" in lines[0]


@pytest.mark.long
def test_the_sources_alone_make_the_wheel(sdist, record, tmp_path):
    (tmp_path / "made").mkdir()
    made = built(sdist, tmp_path / "made", STOSS_BUILD_TREE="")
    assert epsilon_of(made, tmp_path / "venv") == pytest.approx(of_the_command(record), rel=1e-12, abs=0)
