"""The Debian packages: built from the tracked files, clean for lintian, with the same numbers as the build tree, and
installed and tested by autopkgtest in a Debian that has nothing else."""

import os
import platform
import re
import shutil
import signal
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
DEB = ROOT / "build/deb"
CHROOT = ROOT / "build/deb-chroot"
NAMES = ("libstoss2", "libstoss-dev", "stoss", "python3-stoss", "stoss-doc")
pytestmark = pytest.mark.long


def run(*words, timeout=600, **options):
    """What a program prints; it must succeed."""
    done = subprocess.run(words, capture_output=True, text=True, timeout=timeout, cwd=ROOT, **options)
    assert done.returncode == 0, f"{words}\n{done.stdout[-8000:]}\n{done.stderr[-8000:]}"
    return done.stdout


@pytest.fixture(scope="module")
def built():
    """What `make deb` says: of it all that does not touch the environment build/venv, which other tests use."""
    run("scripts/docs.sh", timeout=3600)
    return run("scripts/deb.sh", timeout=5400)


@pytest.fixture(scope="module")
def packages(built):
    """The files of the packages, by name."""
    found = {file.name.partition("_")[0]: file for file in DEB.glob("*.deb")}
    assert set(NAMES) <= set(found), found
    return {name: found[name] for name in NAMES}


@pytest.fixture(scope="module")
def unpacked(packages, tmp_path_factory):
    """All of them in one folder."""
    folder = tmp_path_factory.mktemp("root")
    for file in packages.values():
        run("dpkg-deb", "--extract", str(file), str(folder))
    return folder


def only(files):
    (file,) = files
    return file


def test_lintian_finds_no_error(built):
    assert "built: " in built
    assert not re.findall(r"^E: .*", built, re.MULTILINE)


def test_each_file_is_in_the_package_that_it_belongs_to(packages):
    version = run("dpkg-parsechangelog", "--show-field", "Version").strip()
    held = {name: run("dpkg-deb", "--contents", str(file)) for name, file in packages.items()}
    for name, path in {
        "libstoss2": f"/libstoss.so.{version.partition('-')[0]}",
        "libstoss-dev": "/usr/include/stoss/stoss.h",
        "stoss": "/usr/bin/stoss",
        "python3-stoss": "/usr/lib/python3/dist-packages/stoss/__init__.py",
        "stoss-doc": "/usr/share/doc/stoss-doc/html/page/index.html",
    }.items():
        assert path in held[name], path
        assert not [other for other in NAMES if other != name and re.search(re.escape(path) + r"\b", held[other])], path
        assert run("dpkg-deb", "--field", str(packages[name]), "Version").strip() == version
    for path in ("/libstoss.so ->", "/stoss.pc", "/stoss-config.cmake", "/usr/include/stoss/stoss.f90"):
        assert path in held["libstoss-dev"], path
    for path in ("/man1/stoss.1.gz", "/bash-completion/completions/stoss"):
        assert path in held["stoss"], path
    # Of the library there is one copy, which the others use.
    for name in ("stoss", "python3-stoss"):
        assert re.search(r"\blibstoss2 \(", run("dpkg-deb", "--field", str(packages[name]), "Depends"))


def test_programs_are_hardened_and_look_for_libraries_where_debian_has_them(unpacked):
    library = only(unpacked.glob("usr/lib/*/libstoss.so.*.*"))
    command = unpacked / "usr/bin/stoss"
    module = only(unpacked.glob("usr/lib/python3/dist-packages/stoss/_core.*.so"))
    assert re.search(r"SONAME.*\[libstoss\.so\.2\]", run("readelf", "--dynamic", str(library)))
    for file in (library, command, module):
        dynamic = run("readelf", "--dynamic", "--wide", str(file))
        headers = run("readelf", "--program-headers", "--wide", str(file))
        assert "BIND_NOW" in dynamic and "GNU_RELRO" in headers, file  # what was relocated is read-only
        assert re.search(r"GNU_STACK.* RW ", headers), file  # not executable
        assert not re.search(r"R(UN)?PATH", dynamic), file
        assert "__stack_chk_fail" in run("readelf", "--dyn-syms", "--wide", str(file)), file
    assert "DYN (" in run("readelf", "--file-header", str(command))  # at any address


@pytest.fixture
def packaged_command(unpacked):
    """Runs the command of the packages; returns what it prints."""
    folder = only(unpacked.glob("usr/lib/*/libstoss.so.2")).parent
    environment = {**os.environ, "LD_LIBRARY_PATH": str(folder)}
    return lambda *words: run(str(unpacked / "usr/bin/stoss"), *words, env=environment)


def test_the_command_names_version_and_commit(packaged_command):
    version = run("dpkg-parsechangelog", "--show-field", "Version").partition("-")[0]
    commit = run("git", "rev-parse", "HEAD")[:7]
    assert re.fullmatch(rf"stoss {version} \(commit {commit}(, changed)?\)\n", packaged_command("--version"))


JOBS = (
    "restitution --body disk --poisson 0.33,0.9 --speed 0.005,0.1,0.3",
    "restitution --body sphere --poisson 0.3 --speed 1e-3,0.1 --against half-space",
    "restitution --body disk --poisson 0.33 --speed 0.1 --against disk,poisson=0.2,radius=0.5,young=2",
    "impact --body sphere --poisson 0.3 --speed 0.1",
    "modes --body disk --poisson 0.33",
)


@pytest.mark.parametrize("job", JOBS)
def test_flags_of_debian_change_no_bit(packaged_command, job):
    words = [*job.split(), "--format", "csv"]
    packaged = packaged_command(*words)
    numbers = [line for line in packaged.splitlines() if not line.startswith("#")]
    assert len(numbers) > 1
    assert numbers == [line for line in run(os.environ["STOSS"], *words).splitlines() if not line.startswith("#")]


def sources():
    """This system's release, where apt has it from, and lines for apt of all that it has from Debian."""
    form = "$(ORIGIN)|$(CREATED_BY)|$(SITE)|$(CODENAME)|$(COMPONENT)"
    rows = {tuple(line.split("|")) for line in run("apt-get", "indextargets", "--format", form).splitlines()}
    wanted = sorted(row[2:] for row in rows if row[:2] == ("Debian", "Packages"))
    suite = platform.freedesktop_os_release()["VERSION_CODENAME"]
    site = next(site for site, codename, _ in wanted if codename == suite)
    return suite, site, "".join(f"deb {site} {codename} {part}\n" for site, codename, part in wanted)


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can install into a Debian of its own (debootstrap, chroot)")
def test_packages_work_in_a_debian_that_has_nothing_else(packages):
    suite, site, lines = sources()
    shutil.rmtree(CHROOT, ignore_errors=True)
    try:
        # Where apt asks a mirror with a certificate, the new system must know who signs it.
        run("debootstrap", "--variant=minbase", "--include=ca-certificates", suite, str(CHROOT), site, timeout=1800)
        (CHROOT / "etc/apt/sources.list").write_text(lines, encoding="utf-8")
        proxies = [line for line in run("apt-config", "dump").splitlines() if re.match(r"Acquire::https?::Proxy", line)]
        (CHROOT / "etc/apt/apt.conf.d/99proxy").write_text("".join(line + "\n" for line in proxies), encoding="utf-8")
        # It is thrown away: dpkg need not wait for the disk after each file.
        (CHROOT / "etc/dpkg/dpkg.cfg.d/unsafe-io").write_text("force-unsafe-io\n", encoding="utf-8")
        kept = ("PATH", "HOME", "LANG", "TERM")
        # In a name space of mounts of its own, so that what the kernel makes up in the new system goes with the tests.
        tests = ["autopkgtest", "--no-built-binaries", "--apt-upgrade", "--timeout-factor=3"]
        tests += [*map(str, packages.values()), str(only(DEB.glob("*.dsc"))), "--", "chroot", str(CHROOT)]
        mounted = (
            'mount -t proc proc "$0/proc" && mount -t sysfs sysfs "$0/sys" && mount -t devpts devpts "$0/dev/pts" && '
            'exec "$@"'
        )
        done = subprocess.run(
            ["unshare", "--mount", "sh", "-c", mounted, str(CHROOT), *tests],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=7200,
            # Nothing else of this shell reaches them, such as a compiler cache that only this system has.
            env={name: value for name, value in os.environ.items() if name in kept or name.lower().endswith("_proxy")},
            # Tests there send this signal, which shells may ignore.
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
        )
        log = done.stdout
        (ROOT / "build/deb-tests.log").write_text(log, encoding="utf-8")
        named = re.findall(r"^Tests: (\w+)$", (ROOT / "debian/tests/control").read_text(encoding="utf-8"), re.MULTILINE)
        passed = re.findall(r"^(\w+) +PASS$", log.rpartition("summary")[2], re.MULTILINE)
        assert done.returncode == 0 and passed == named, log[-12000:]
        # They can be removed, and leave nothing.
        apt = ["chroot", str(CHROOT), "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "-y"]
        debs = [shutil.copy(file, CHROOT / "tmp") for file in packages.values()]
        run(*apt, "install", "--no-install-recommends", *(f"/tmp/{Path(deb).name}" for deb in debs), timeout=1800)
        assert run("chroot", str(CHROOT), "stoss", "--version")
        run(*apt, "purge", *NAMES)
        left = [file for file in CHROOT.glob("usr/**/*stoss*") if "/dist-packages/" in str(file) or file.is_file()]
        assert not left
    finally:
        shutil.rmtree(CHROOT, ignore_errors=True)
