"""What cmake/hardening.cmake asks for, as readelf sees it in a program or a library, and whether a build tree has it."""

import re
import shutil
import subprocess


def cached(tree, name):
    """A variable of a build tree; "" where the folder is none."""
    cache = tree / "CMakeCache.txt"
    found = re.search(rf"^{name}:[A-Z]+=(.*)$", cache.read_text() if cache.exists() else "", re.MULTILINE)
    return found[1] if found else ""


def reason_to_skip(tree):
    """Why nothing can be said of what a build tree holds; "" where it can."""
    if cached(tree, "CMAKE_BUILD_TYPE") != "Release":
        return "not built for release"
    return "" if shutil.which("readelf") else "readelf is missing"


def readelf(option, path):
    return subprocess.run(["readelf", option, path], capture_output=True, text=True, check=True).stdout


# Memory is not data and code at once, and functions of libraries are bound before anything runs.
GUARDED = {
    "stack": "RW ",
    "read-only from the start": "R  ",
    "is loaded": True,
    "both written and run": [],
    "bound at the start": True,
    "changes its code": False,
}


def guards(path):
    """What `GUARDED` has, of a file."""
    segments = re.findall(r"^ +(\w+)(?: +0x\w+){5} ([R ][W ][E ])", readelf("-lW", path), re.MULTILINE)
    flags, dynamic = dict(segments), readelf("-dW", path)
    return {
        "stack": flags.get("GNU_STACK"),
        "read-only from the start": flags.get("GNU_RELRO"),
        "is loaded": "LOAD" in flags,
        "both written and run": [name for name, each in segments if "WE" in each],
        "bound at the start": bool(re.search(r"\(FLAGS\) +BIND_NOW|\(FLAGS_1\) .*\bNOW\b", dynamic)),
        "changes its code": "TEXTREL" in dynamic,
    }


def has_no_fixed_address(path):
    """Whether a program runs wherever the system puts it."""
    return bool(re.search(r"Type: +DYN", readelf("-hW", path)) and re.search(r"\(FLAGS_1\) .*\bPIE\b", readelf("-dW", path)))
