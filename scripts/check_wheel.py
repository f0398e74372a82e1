"""On which Linux systems a wheel runs: the shared libraries that its modules need, and the versions of their symbols.

    check_wheel.py WHEEL [--into FOLDER]

Modules may need only what the C and C++ runtime of any Linux with glibc has, no newer than one of the platforms
manylinux_2_N of PEP 600, where N is the minor version of glibc; the oldest such N is printed. With --into the wheel is
written there with this platform in its name and tags, for pip to take it on these systems and refuse it on older ones.
The exit code is 0, or 1 with a line for each thing that would keep it from running elsewhere.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from pathlib import Path

LIBRARIES = ("libc.so.6", "libm.so.6", "libdl.so.2", "librt.so.1", "libutil.so.1", "libpthread.so.0", "libgcc_s.so.1",
             "libstdc++.so.6")
LOADER = re.compile(r"ld-linux.*\.so\.\d+|ld64\.so\.\d+")

# The newest symbols that systems with glibc 2.N have at least: the policies of auditwheel 6, x86_64.
NEWEST = {
    28: {"GLIBCXX": "3.4.24", "CXXABI": "1.3.11", "GCC": "7.0.0"},
    31: {"GLIBCXX": "3.4.28", "CXXABI": "1.3.12", "GCC": "7.0.0"},
    34: {"GLIBCXX": "3.4.29", "CXXABI": "1.3.13", "GCC": "7.0.0"},
    35: {"GLIBCXX": "3.4.30", "CXXABI": "1.3.13", "GCC": "12.0.0"},
    39: {"GLIBCXX": "3.4.33", "CXXABI": "1.3.15", "GCC": "14.0.0"},
}


def numbers(version: str) -> tuple[int, ...]:
    return tuple(map(int, version.split(".")))


def needs(module: Path) -> tuple[list[str], dict[str, str], list[str]]:
    """Libraries that a module needs, the newest version of each family of symbols, and paths that it searches."""
    words = ["readelf", "--wide", "--dynamic", "--version-info", str(module)]
    read = subprocess.run(words, capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"})
    if read.returncode != 0 or "Dynamic section" not in read.stdout:
        raise ValueError(f"{module.name}: got no shared library, allowed one in the ELF format")
    libraries = re.findall(r"\(NEEDED\)\s+Shared library: \[(.*)\]", read.stdout)
    paths = re.findall(r"\(R(?:UN)?PATH\)\s+.*\[(.*)\]", read.stdout)
    newest: dict[str, str] = {}
    for family, version in re.findall(r"Name: (\w+?)_([\d.]+)\s", read.stdout):
        newest[family] = max(newest.get(family, "0"), version, key=numbers)
    return libraries, newest, paths


def oldest(newest: dict[str, str]) -> int | None:
    """The smallest N such that all systems with glibc 2.N have such symbols; None if that is not known."""
    glibc = numbers(newest.get("GLIBC", "2.0"))[1]
    runtime = [n for n, limits in NEWEST.items()
               if all(numbers(version) <= numbers(limits.get(family, "0")) for family, version in newest.items()
                      if family != "GLIBC")]
    return max(glibc, min(runtime)) if runtime else None


def problems(name: str, libraries: list[str], newest: dict[str, str], paths: list[str]) -> list[str]:
    """What keeps a module from running on other systems, a line each."""
    known = ["GLIBC", *NEWEST[28]]
    found = [f"{name}: needs {library}, allowed {', '.join(LIBRARIES)} (link it in)"
             for library in libraries if library not in LIBRARIES and not LOADER.fullmatch(library)]
    found += [f"{name}: needs symbols {family}_{version}, allowed those of {', '.join(known)}"
              for family, version in newest.items() if family not in known]
    found += [f"{name}: searches {path}, allowed no path of its own (no RPATH, no RUNPATH)" for path in paths]
    if not found and oldest(newest) is None:
        most = NEWEST[max(NEWEST)]
        found += [f"{name}: needs {family}_{version}, allowed up to {family}_{most[family]} (an older compiler)"
                  for family, version in newest.items() if family in most and numbers(version) > numbers(most[family])]
    return found


def tagged(wheel: Path, unpacked: Path, platform: str, into: Path) -> Path:
    """The same wheel for another platform, written to a folder."""
    from wheel.wheelfile import WheelFile

    (description,) = unpacked.glob("*.dist-info/WHEEL")
    text = description.read_text(encoding="utf-8")
    description.write_text(re.sub(r"^(Tag: [^-]+-[^-]+)-.*$", rf"\1-{platform}", text, flags=re.M), encoding="utf-8")
    target = into / f"{wheel.stem.rpartition('-')[0]}-{platform}.whl"
    target.unlink(missing_ok=True)
    with WheelFile(target, "w") as written:
        written.write_files(unpacked)
    return target


def check(wheel: Path, unpacked: Path) -> tuple[list[str], int]:
    """What is wrong with a wheel, and the oldest minor version of glibc that its modules run with."""
    *_, abi, platform = wheel.stem.split("-")
    modules = sorted(path for path in unpacked.rglob("*") if re.search(r"\.so(\.\d+)*$", path.name))
    if not modules:
        return [f"{wheel.name}: got no compiled module, allowed one at least"], 0
    wrong: list[str] = []
    least = 0
    for module in modules:
        name = str(module.relative_to(unpacked))
        libraries, newest, paths = needs(module)
        versions = ", ".join(f"{family}_{version}" for family, version in sorted(newest.items()))
        print(f"{name}\n  needs {' '.join(libraries)}\n  symbols up to {versions}")
        suffix = f"cpython-{abi.removeprefix('cp')}-"
        if suffix not in module.name:
            wrong.append(f"{name}: got a name without {suffix}, allowed that of the Python of the wheel's tag {abi}")
        wrong += problems(name, libraries, newest, paths)
        least = max(least, oldest(newest) or 0)
    return wrong, least


def main(words: list[str]) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("wheel", type=Path)
    parser.add_argument("--into", type=Path)
    given = parser.parse_args(words)
    with tempfile.TemporaryDirectory() as folder:
        unpacked = Path(folder)
        with zipfile.ZipFile(given.wheel) as archive:
            for each in archive.infolist():
                path = Path(archive.extract(each, unpacked))
                path.chmod(each.external_attr >> 16 or 0o644)
        wrong, least = check(given.wheel, unpacked)
        for line in wrong:
            print(f"check_wheel: {line}", file=sys.stderr)
        if wrong:
            return 1
        machine = re.sub(r"\W", "_", sysconfig.get_platform().removeprefix("linux-"))
        platform = f"manylinux_2_{least}_{machine}"
        print(f"runs with glibc 2.{least} and newer: {platform}")
        if given.into:
            given.into.mkdir(parents=True, exist_ok=True)
            print(f"written: {tagged(given.wheel, unpacked, platform, given.into)}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
