"""help() explains every parameter of the public functions, shared words are not said twice, and the examples in the
docstrings run and give what they say."""

import ast
import doctest
import importlib
import inspect
import pkgutil
import re
from pathlib import Path

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
import pytest
import stoss
import stoss.plot
from stoss import _documentation

FUNCTIONS = {
    f"{module.__name__}.{name}": getattr(module, name)
    for module in (stoss, stoss.quasistatic, stoss.plot)
    for name in module.__all__
    if inspect.isfunction(getattr(module, name))
}


def explained(said):
    section = re.search(r"^Parameters:\n((?:    .*\n?)+)", inspect.cleandoc(said), re.MULTILINE)
    entries = re.findall(r"^    (\S[^:(]*)", section[1] if section else "", re.MULTILINE)
    return [name for entry in entries for name in re.findall(r"\w+", entry)]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_parameter_is_explained_once(name):
    function = FUNCTIONS[name]
    names = explained(function.__doc__)
    assert set(inspect.signature(function).parameters) <= set(names)
    assert len(names) == len(set(names))


def test_types_come_from_annotations_and_own_words_come_first():
    @_documentation.documented
    def made(  # names without a meaning: only their words count
        body: "Body | None" = None,  # noqa: F821
        *,
        speed: "ArrayLike",  # noqa: F821
        threads: "int" = 0,
        **style: "Any",  # noqa: F821
    ) -> None:
        """Make it.

        Parameters:
            speed: One's own, which a shorter
                line continues.

        Examples:
            >>> 1
            1
        """

    assert made.__doc__ == (
        "Make it.\n\nParameters:\n"
        "    body (Disk, Sphere, HollowSphere, Rod or ModalBody, optional): The first body, in whose units\n"
        "        all results are.\n"
        "    speed (array_like): One's own, which a shorter line continues.\n"
        "    threads (int, optional): 0: as many as the machine has. Results do not depend on it.\n"
        "    **style: Handed on to `matplotlib.axes.Axes.plot`: color, linestyle, …\n\n"
        "Examples:\n    >>> 1\n    1"
    )


MODULES = ["stoss"] + [
    info.name for info in pkgutil.walk_packages(stoss.__path__, "stoss.") if "_core" not in info.name
]


@pytest.mark.parametrize("name", MODULES)
def test_examples(name, tmp_path, monkeypatch):
    matplotlib.use("Agg")
    monkeypatch.chdir(tmp_path)
    if name.startswith("stoss.modal."):
        pytest.importorskip("dolfinx")  # the rest of the package does without
    module = importlib.import_module(name)
    names = {"stoss": stoss, "np": np}
    found = doctest.testmod(module, extraglobs=names, optionflags=doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS)
    plt.close("all")
    assert found.failed == 0


@pytest.mark.parametrize("module", ["stoss", "stoss.quasistatic", "stoss.plot"])
def test_every_public_function_has_an_example(module):
    shown = importlib.import_module(module)
    for name in shown.__all__:
        thing = getattr(shown, name)
        if callable(thing) and getattr(thing, "__module__", "").startswith("stoss") and name[0].islower():
            assert ">>>" in (thing.__doc__ or ""), name


def test_every_public_name_is_on_one_page_of_the_site():
    source = (Path(__file__).resolve().parents[3] / "docs/site/generate/package.py").read_text()
    pages, elsewhere = (ast.literal_eval(each.value) for each in ast.parse(source).body
                        if isinstance(each, ast.Assign) and each.targets[0].id in ("PAGES", "ELSEWHERE"))  # fmt: skip
    names = [name for page in pages.values() for name in page.split()]
    assert sorted([*names, *elsewhere]) == sorted(stoss.__all__)
