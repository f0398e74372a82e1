"""The examples in the docstrings run, and give what they say."""

import doctest
import importlib
import pkgutil

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
import pytest

import stoss

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
