"""The pages of the Python package: every public name, from its docstring."""

import importlib
import inspect
import sys

import stoss
import stoss.plot
from sphinx.pycode import ModuleAnalyzer
from tree import Tree

# Title of a page: the names on it.
PAGES = {
    "Restitution": "restitution Restitution with_error",
    "Bodies and walls": (
        "Disk Sphere HollowSphere Rod ModalBody HalfSpace HalfPlane Plate Strip Layer HardWall ExponentialWall Body Wall"
    ),
    "Materials": "Material Scales materials relaxation_of_measurement FittedRelaxation shifted",
    "Drop tests": "predict Prediction Influence",
    "Calibration": "calibrate Calibration CalibratedConstant",
    "Oblique impacts": "oblique ObliqueRestitution oblique_impact ObliqueImpact ObliqueTrajectory ObliqueLedger",
    "One impact": "impact Impact Trajectory Sound DiskField SphereField Field Wave",
    "Pulses": "pulse Pulse Seismogram",
    "Modes": "modes Modes",
    "Bodies that vibrate": (
        "Oscillation restitution_distribution RestitutionDistribution bounce Bounces rod_chain RodChain"
    ),
    "Rows": "row Row row_impact RowImpact",
    "Functions and tables": (
        "restitution_function RestitutionFunction pair_table PairTable collision_rule CollisionRule read_csv Table"
    ),
    "Force laws": "fit Fit Misfit",
    "Sweeps": "Grid sweep Sweep merge open_sweep atlas AtlasValue",
    "Errors and warnings": "InvalidInput NotConverged Interrupted StossWarning",
}
ELSEWHERE = {"__version__", "plot", "animate", "quasistatic"}  # the modules have pages of their own

# All other classes are what functions return: their constructors are of no use.
MADE_BY_USERS = (
    "Disk Sphere HollowSphere Rod ModalBody HalfSpace HalfPlane Plate Strip Layer HardWall ExponentialWall Material "
    "Oscillation Grid"
).split()


def said_of(name: str) -> list[str]:
    """The docstring below a value in the module that defines it."""
    for module in [module for module in sys.modules if module.startswith("stoss.")]:
        if module != "stoss._core":
            said = ModuleAnalyzer.for_module(module).find_attr_docs()
            if ("", name) in said:
                return said["", name]
    raise SystemExit(f"docs/site/generate/package.py: {name} has no docstring")


def directive(module: str, name: str) -> list[str]:
    value = getattr(importlib.import_module(module), name)
    if inspect.isclass(value):
        options = [":members:"]
        if not issubclass(value, BaseException):
            options += [":inherited-members: tuple"]
        if issubclass(value, tuple):  # the docstring of the class says what they are
            options += [f":exclude-members: {', '.join(value._fields)}"]
        signature = "" if name in MADE_BY_USERS else "()"
        return [f".. autoclass:: {module}.{name}{signature}", *(f"   {option}" for option in options), ""]
    if callable(value) and not hasattr(value, "__args__"):
        return [f".. autofunction:: {module}.{name}", ""]
    return [f".. py:data:: {name}", "", *(f"   {line}" for line in said_of(name)), ""]


def page(title: str, module: str, names: list[str], introduction: list[str]) -> str:
    lines = [title, "=" * len(title), "", *introduction, "", f".. currentmodule:: {module}", ""]
    for name in names:
        lines += directive(module, name)
    return "\n".join(lines)


def write(tree: Tree) -> None:
    names = [name for page_names in PAGES.values() for name in page_names.split()]
    missing = set(stoss.__all__) ^ ELSEWHERE ^ set(names)
    if missing or len(set(names)) != len(names):
        raise SystemExit(f"docs/site/generate/package.py: not on one page each: {sorted(missing)}")
    files = []
    for title, page_names in PAGES.items():
        files.append(title.lower().replace(" ", "_"))
        tree.write(f"reference/python/{files[-1]}.rst", page(title, "stoss", page_names.split(), []))
    for module in ("quasistatic", "plot"):
        whole = f"stoss.{module}"
        text = page(whole, whole, getattr(stoss, module).__all__, [f".. automodule:: {whole}"])
        tree.write(f"reference/python/{module}.rst", text)
        files.append(module)
    index = ["Python package", "==============", "", ".. automodule:: stoss", "", ".. toctree::", "   :maxdepth: 1", ""]
    tree.write("reference/python/index.rst", "\n".join([*index, *(f"   {name}" for name in files)]) + "\n")
