"""The package's types hold: its own sources, and the stubs of the compiled module against what it
really has."""

import re
import runpy
import subprocess
import sys
from pathlib import Path

import stoss
import stoss._core

OPAQUE = ("Contact", "Encounter", "Frames", "GivenRow", "Impact", "ObliqueImpact", "PairTable", "Pulse",
          "RefinableContact", "RestitutionFunction", "RodChain", "RuleTable", "SlowLaw")  # fmt: skip
PYPROJECT = Path(__file__).parents[3] / "pyproject.toml"


CACHE = ("--cache-dir", str(PYPROJECT.parent / "build/mypy"))  # what numpy declares is read once


def run(*command, folder):
    # Away from the sources, so that the installed package is what is looked at.
    result = subprocess.run([sys.executable, "-m", *command], cwd=folder, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + result.stderr


def test_sources_are_typed(tmp_path):
    run("mypy", *CACHE, "--config-file", str(PYPROJECT), "-p", "stoss", folder=tmp_path)


def test_stubs_are_those_of_the_compiled_module(tmp_path):
    # pybind11's classes have a metaclass and an __init__ of their own, which nobody is meant to
    # see.
    allowed = tmp_path / "allowed"
    allowed.write_text("".join(f"stoss._core.{name}(.__init__)?\n" for name in OPAQUE))
    # What the stubs import need not be read to compare them.
    settings_file = tmp_path / "mypy.ini"
    settings_file.write_text("[mypy]\nfollow_imports = skip\nfollow_imports_for_stubs = True\n")
    settings = ("--mypy-config-file", str(settings_file), "--allowlist", str(allowed))
    run("mypy.stubtest", *settings, "stoss._core", folder=tmp_path)
    for name in OPAQUE:
        assert isinstance(getattr(stoss._core, name), type)


def test_types_are_shipped():
    package = Path(stoss.__file__).parent
    assert (package / "py.typed").is_file()
    stubs = runpy.run_path(str(PYPROJECT.parent / "python/stubs.py"))["stubs"]()
    for name, text in stubs.items():
        assert (package / name).read_text(encoding="utf-8") == text  # written by the setup of the package
    assert re.findall(r"\b(?:stoss\.|numpy\.nd|List\[|Optional\[|object\b)", stubs["_core.pyi"]) == []  # all are translated


def test_users_get_types(tmp_path):
    (tmp_path / "user.py").write_text(
        "import numpy as np\n"
        "import stoss\n"
        "curve = stoss.restitution(poisson=0.33, speed=np.geomspace(1e-4, 0.3, 50))\n"
        "reveal_type(curve.restitution)\n"
        "stoss.restitution(poison=0.33, speed=0.1)\n"
    )
    command = [sys.executable, "-m", "mypy", *CACHE, "--config-file", str(PYPROJECT), "user.py"]
    report = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True).stdout
    assert "float" in report and "ndarray" in report, report
    assert 'Unexpected keyword argument "poison"' in report, report
