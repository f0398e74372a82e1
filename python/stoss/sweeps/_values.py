"""The values of a sweep, complete or not."""

from __future__ import annotations

import dataclasses
import json
import os
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss._arguments import boolean
from stoss._documentation import documented
from stoss.bodies._solid import describe
from stoss.results._curves import empty_rows
from stoss.results._result import QUANTITIES, Column, Result
from stoss.results._si import si_name
from stoss.sweeps import _store
from stoss.sweeps._grid import Grid
from stoss.sweeps._specification import label, numbers_of_bodies, unit_of_body


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class Sweep(Result):
    """The values of a sweep, in arrays over bodies, partners and speeds.

    Besides the attributes below it has all quantities of a `Restitution` by the same names, in
    units of the first body: `restitution`, `restitution_error`, `lost_fraction`, `contact_time`, ….
    What is not computed yet is NaN, 0 or False there. Tables, as of `to_csv` and `to_dataframe`, have
    a row for each value, with the names of the body and of what it meets; data sets of xarray have
    the dimensions body, against and speed, as the file of `to_netcdf`.

    Attributes:
        grid (Grid): What was asked for.
        computed: Which values are there.
        versions (tuple of str): Versions of stoss that computed them.
    """

    _name: ClassVar[str] = "sweep"
    _kind = "restitution"
    _given = {"speed": "speed"}

    grid: Grid = dataclasses.field(repr=False)
    computed: NDArray[np.bool_]
    versions: tuple[str, ...]
    rows: NDArray[Any] = dataclasses.field(repr=False)

    def __getattr__(self, name: str) -> NDArray[Any]:
        if name.startswith("_") or name not in (_core.restitution_row.names or ()):
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

    @documented
    def to_netcdf(self, path: str | os.PathLike[str]) -> None:
        """Write all values to a NetCDF-4 file with units and provenance, which xarray opens.

        Dimensions are body, against and speed. What is missing has fill values. The file appears
        whole or not at all. Needs the package netCDF4.
        """
        from stoss.export._netcdf import write

        write(self, os.fspath(path))

    def _inputs(self) -> dict[str, Any]:
        accuracy = {"tolerance": self.grid.tolerance, "absolute": self.grid.absolute}
        return {**accuracy, "versions": ", ".join(self.versions), "grid": json.dumps(self.grid.to_dict())}

    def _derived(self) -> dict[str, Any]:
        quantities = {name: self.rows[name] for name in QUANTITIES["restitution"]}
        if not self.grid.in_si:
            return quantities
        for name, dimension in QUANTITIES["restitution"].items():
            if dimension:
                scales = np.array([getattr(body.scales, dimension) for body in self.grid.bodies])
                quantities[si_name(name)] = self.rows[name] * scales[:, np.newaxis, np.newaxis]
        return quantities

    def _columns(self) -> dict[str, Column]:
        labels = self._labels()
        of_bodies = {"body": labels["body"]} | self._of_bodies()
        columns = {name: each[:, np.newaxis, np.newaxis] for name, each in of_bodies.items()}
        columns |= {"against": labels["against"][:, np.newaxis], "speed": self.grid.speed}
        columns |= {**self._derived(), "computed": self.computed}
        return {name: np.broadcast_to(each, self.grid.shape) for name, each in columns.items()}

    def _arranged_columns(self) -> tuple[dict[str, Column], tuple[str, ...]]:
        return self._columns() | self._of_bodies(), ("body", "against", "speed")

    def _labels(self) -> dict[str, Column]:
        """What the bodies are called, and what they meet."""
        called = {"body": map(describe, self.grid.bodies), "against": self.grid.against}
        return {name: np.array([label(each) for each in several], dtype=object) for name, several in called.items()}

    def _of_bodies(self) -> dict[str, Column]:
        return {f"body_{name}": each for name, each in numbers_of_bodies(self.grid.bodies).items()}

    def _unit(self, name: str) -> str:
        if name.startswith("body_"):
            return unit_of_body(name.removeprefix("body_"), self.grid.in_si)
        return "m/s" if name == "speed" and self.grid.in_si else super()._unit(name)

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
    grid = _store.read_grid(path)
    cases = grid.cases()
    found = _store.read(path, {case.key for case in cases}, boolean("mix", mix))
    rows = empty_rows(grid.shape)
    computed = np.zeros(grid.shape, dtype=bool)
    versions = set()
    for case in cases:
        for k, speed in enumerate(grid.speed.tolist()):
            stored = found.get((case.key, speed))
            if stored is not None:
                rows[(*case.place, k)] = stored.row
                computed[(*case.place, k)] = True
                versions.add(stored.version)
    for array in (rows, computed):
        array.flags.writeable = False
    return Sweep(grid, computed, tuple(sorted(versions)), rows)


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
