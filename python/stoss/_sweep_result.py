"""The values of a sweep, complete or not."""

from __future__ import annotations

import dataclasses
import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stoss import _core, _store
from stoss._arguments import boolean
from stoss._grid import Grid


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class Sweep:
    """The values of a sweep, in arrays over bodies, partners and speeds.

    Besides the attributes below it has all quantities of a `Restitution` by the same names, in
    units of the first body: `restitution`, `restitution_error`, `lost_fraction`, `contact_time`, ….
    What is not computed yet is NaN, 0 or False there.

    Attributes
    ----------
    grid : Grid
        What was asked for.
    computed : ndarray of bool
        Which values are there.
    versions : tuple of str
        Versions of stoss that computed them.
    """

    grid: Grid
    computed: NDArray[np.bool_]
    versions: tuple[str, ...]
    rows: NDArray[Any]

    def __getattr__(self, name: str) -> NDArray[Any]:
        if name.startswith("_") or name not in (_core.restitution_row.names or ()):
            raise AttributeError(f"'Sweep' object has no attribute {name!r}")
        column: NDArray[Any] = self.rows[name]
        return column

    def __repr__(self) -> str:
        return f"Sweep({self.grid!r}: {np.count_nonzero(self.computed)} of {self.computed.size} values)"

    @property
    def complete(self) -> bool:
        """Whether all values are there."""
        return bool(self.computed.all())

    def to_netcdf(self, path: str | os.PathLike[str]) -> None:
        """Write all values to a NetCDF-4 file with units and provenance, which xarray opens.

        Dimensions are body, against and speed. What is missing has fill values. The file appears
        whole or not at all. Needs the package netCDF4.

        Parameters
        ----------
        path : str or path
            Where to; an existing file is replaced.
        """
        from stoss._netcdf import write

        write(self, os.fspath(path))


def open_sweep(store: str | os.PathLike[str], *, mix: bool = False) -> Sweep:
    """Read what the store of a sweep has so far, also while workers write to it.

    Parameters
    ----------
    store : path
        Directory of the store.
    mix : bool, optional
        Take values of other versions of stoss too, where this one has none, and leave out those of
        other grids. Without it such a store is refused.

    Returns
    -------
    Sweep

    Raises
    ------
    InvalidInput
        If it is no store, is damaged, or has rows of another version or grid.

    Examples
    --------
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
    rows = np.zeros(grid.shape, dtype=_core.restitution_row)
    for name, kind in _store.KINDS.items():
        if kind == "f":
            rows[name] = np.nan
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


def merge(store: str | os.PathLike[str], path: str | os.PathLike[str], *, mix: bool = False) -> Sweep:
    """Write what the store of a sweep has to one NetCDF-4 file.

    Parameters
    ----------
    store : path
        Directory of the store.
    path : str or path
        Where to; an existing file is replaced.
    mix : bool, optional
        As of `open_sweep`.

    Returns
    -------
    Sweep
        What was written; its `complete` says whether anything is missing.

    Examples
    --------
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
