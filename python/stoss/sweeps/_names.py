"""What the bodies and partners of a sweep are called in tables and files, and their numbers."""

from __future__ import annotations

import dataclasses

import numpy as np
from numpy.typing import NDArray

from stoss._arguments import brief
from stoss.bodies._solid import Specification
from stoss.sweeps._grid import Grid

SI = {"radius": "m", "length": "m", "area": "m2", "young": "Pa", "density": "kg/m3", "loss_time": "s"}
"""Units of the numbers of bodies with a material."""


def label(words: Specification) -> str:
    """What a body or a partner is, in the manner of --against."""
    usual = {"loss_time": 0.0, **({} if "material" in words else dict.fromkeys(SI, 1.0) | {"loss_time": 0.0})}
    numbers = {name: value for name, value in words.items() if name != "kind" and usual.get(name) != value}
    numbers |= {f"material_{name}": value for name, value in numbers.pop("material", {}).items()}
    return ",".join((words["kind"], *(f"{name}={brief(value)}" for name, value in numbers.items())))


def numbers_of_bodies(grid: Grid) -> dict[str, NDArray[np.float64]]:
    """Poisson's ratio, radius and so on of the first bodies; NaN of a body that has none."""
    names = {field.name for each in grid.bodies for field in dataclasses.fields(each)}
    return {
        name: np.array([getattr(each, name, np.nan) for each in grid.bodies], dtype=np.float64)
        for name in sorted(names - {"material", "plane", "rigid"})
    }


def unit_of_body(name: str, grid: Grid) -> str:
    """Unit of one of these numbers; "" of a pure one."""
    return SI.get(name, "") if grid.in_si else ""
