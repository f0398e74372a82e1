"""The values of a sweep, complete or not."""

from __future__ import annotations

import dataclasses
import json
import os
import re
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from stoss._arguments import boolean
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.bodies._solid import describe
from stoss.results._distribution import summary_of
from stoss.results._result import Column, Result, unit
from stoss.results._si import si_name
from stoss.sweeps import _store
from stoss.sweeps._grid import Grid
from stoss.sweeps._specification import label, numbers_of_bodies, unit_of_body

DIMENSIONS = {"speed": "speed", "tangential": "speed", "spin": "frequency", "second_spin": "frequency"}
"""Units of axes; an angle is in degrees, the others are pure numbers."""


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class Sweep(Result):
    """The values of a sweep, in arrays over bodies, partners, speeds and all other axes.

    In addition to the attributes below it has all quantities of a `Restitution` by the same names, in
    units of the first body: `restitution`, `restitution_error`, `lost_fraction`, `contact_time`, …; with
    friction those of an `ObliqueRestitution`, of ensembles those of the samples of a
    `RestitutionDistribution`, and of rows those of a `Row` for each of its bodies.
    A value that is not computed yet is NaN, 0 or False there. Tables, as of `to_csv` and `to_dataframe`, have
    a row for each value, with the names of the body and of what it meets; data sets of xarray have
    the dimensions body, against, speed and so on, as the file of `to_netcdf`.

    Attributes:
        grid (Grid): Values that were asked for.
        computed: Which values are there.
        versions (tuple of str): Versions of stoss that computed them.
    """

    _name: ClassVar[str] = "sweep"

    grid: Grid = dataclasses.field(repr=False)
    computed: NDArray[np.bool_]
    versions: tuple[str, ...]
    rows: NDArray[Any] = dataclasses.field(repr=False)

    def __getattr__(self, name: str) -> NDArray[Any]:
        if name.startswith("_") or name not in self.grid.computation.columns:
            raise AttributeError(f"'Sweep' object has no attribute {name!r}")
        return self.rows[name]

    def __repr__(self) -> str:
        return f"Sweep({self.grid!r}: {np.count_nonzero(self.computed)} of {self.computed.size} values)"

    @property
    def complete(self) -> bool:
        """Whether all values are there."""
        return bool(self.computed.all())

    def to_dict(self) -> dict[str, Any]:
        """Return all that the sweep holds in plain Python types, ready for json: the grid as of
        `Grid.to_dict`, and quantities as lists over bodies, partners and speeds.
        """
        return {"grid": self.grid.to_dict()} | super().to_dict()

    def summary(self) -> NDArray[Any]:
        """Sum up the samples of each ensemble that are there.

        Returns:
            A structured array over bodies, partners, speeds and temperatures, with the fields mean,
            mean_error, numerical_error, spread and above_one, as of a `RestitutionDistribution`.
        """
        if "sample" not in self.grid.axes:
            raise InvalidInput.out_of_range("summary", "a sweep without samples", "one of ensembles", "temperature")
        shape = self.grid.shape[:-1]
        values, errors = self.rows["restitution"].reshape(-1, self.grid.shape[-1]), self.rows["restitution_error"]
        each = [summary_of(*pair) for pair in zip(values, errors.reshape(values.shape))]
        sums = np.array([tuple(one.values()) for one in each], dtype=[(name, np.float64) for name in each[0]])
        return sums.reshape(shape)

    @documented
    def to_netcdf(self, path: str | os.PathLike[str]) -> None:
        """Write all values to a NetCDF-4 file with units and provenance, which xarray opens.

        Dimensions are body, against, speed and all other axes. Missing values are fill values. The file appears
        whole or not at all. Needs the package netCDF4.
        """
        from stoss.export._netcdf import write

        write(self, os.fspath(path))

    def _inputs(self) -> dict[str, Any]:
        accuracy = self.grid.computation.accuracy
        return {**accuracy, "versions": ", ".join(self.versions), "grid": json.dumps(self.grid.to_dict())}

    def _quantities(self) -> dict[str, str]:
        """Dimensions of what was found."""
        known = self.grid.computation.quantities
        return {name: known[name] for name in self.grid.computation.columns}

    def _derived(self) -> dict[str, Any]:
        quantities = {name: self.rows[name] for name in self._quantities()}
        if not self.grid.in_si:
            return quantities
        for name, dimension in self._quantities().items():
            if dimension:
                scales = np.array([getattr(body.scales, dimension) for body in self.grid.bodies])
                quantities[si_name(name)] = self.rows[name] * scales.reshape(-1, *[1] * (self.rows.ndim - 1))
        return quantities

    def _columns(self) -> dict[str, Column]:
        dimensions = self.grid.dimensions

        def along(values: Column, name: str) -> Column:
            return values.reshape([-1 if each == name else 1 for each in dimensions])

        labels = self._labels()
        columns = {"body": along(labels["body"], "body")}
        columns |= {name: along(each, "body") for name, each in self._of_bodies().items()}
        columns |= {"against": along(labels["against"], "against")}
        columns |= {name: along(each, name) for name, each in self.grid.axes.items()}
        columns |= {**self._derived(), "computed": self.computed}
        return {name: np.broadcast_to(each, self.grid.shape) for name, each in columns.items()}

    def _arranged_columns(self) -> tuple[dict[str, Column], tuple[str, ...]]:
        return self._columns() | self._of_bodies(), self.grid.dimensions

    def _labels(self) -> dict[str, Column]:
        """What the bodies are called, and what they meet."""
        if "number" in self.grid.axes:
            called = {"body": [case.against.label() for case in self.grid.cases()], "against": ["row"]}
        else:
            called = {"body": [label(describe(each)) for each in self.grid.bodies],
                      "against": [label(each) for each in self.grid.against]}  # fmt: skip
        return {name: np.array(several, dtype=object) for name, several in called.items()}

    def _of_bodies(self) -> dict[str, Column]:
        return {f"body_{name}": each for name, each in numbers_of_bodies(self.grid.bodies).items()}

    def _unit(self, name: str) -> str:
        if name.startswith("body_"):
            return unit_of_body(name.removeprefix("body_"), self.grid.in_si)
        if name == "angle":
            return "deg"
        own = re.sub(r"_si(?=$|_error$)", "", name)
        dimension = {**self._quantities(), **DIMENSIONS}.get(own, "")
        si = own != name or name in self.grid.axes and self.grid.in_si
        return " or ".join(sorted({unit(dimension, body=each, si=si) for each in self._kinds_of_bodies()}))

    def _kinds_of_bodies(self) -> set[str]:
        return {body._kind for body in self.grid.bodies}


@documented
def open_sweep(store: str | os.PathLike[str], *, mix: bool = False) -> Sweep:
    """Read what the store of a sweep has so far, also while workers write to it; a damaged store is refused.

    Examples:
        >>> import tempfile
        >>> grid = stoss.Grid(bodies={"kind": "disk", "poisson": 0.33}, speed=[0.1, 0.2])
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     _ = stoss.sweep(grid, store=folder)
        ...     stoss.open_sweep(folder).complete
        True
    """
    path = Path(store)
    return values_of(_store.read_grid(path), path, boolean("mix", mix))


def values_of(grid: Grid, path: Path, mix: bool = False) -> Sweep:
    """What the store of this grid has."""
    found = _store.read(path, grid, mix)
    computed = found.version >= 0
    for array in (found.rows, computed):
        array.flags.writeable = False
    versions = {found.versions[number] for number in np.unique(found.version[computed]).tolist()}
    return Sweep(grid, computed, tuple(sorted(versions)), found.rows)


@documented
def merge(store: str | os.PathLike[str], path: str | os.PathLike[str], *, mix: bool = False) -> Sweep:
    """Write what the store of a sweep has to one NetCDF-4 file, and return it; `Sweep.complete` says whether it is all.

    Examples:
        >>> import os, tempfile
        >>> grid = stoss.Grid(bodies={"kind": "disk", "poisson": 0.33}, speed=[0.1, 0.2])
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     _ = stoss.sweep(grid, store=folder)
        ...     _ = stoss.merge(folder, os.path.join(folder, "values.nc"))
        ...     os.path.exists(os.path.join(folder, "values.nc"))
        True
    """
    result = open_sweep(store, mix=mix)
    result.to_netcdf(path)
    return result
