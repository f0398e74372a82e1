"""Sweeps and columns of results as NetCDF-4 files."""

from __future__ import annotations

import json
import os
from typing import Any, Mapping, Protocol

import numpy as np
from numpy.typing import NDArray

from stoss import _core
from stoss.export import _files
from stoss.export._files import whole_file
from stoss.results._si import si_name


class Swept(Protocol):
    """What a sweep has for a file."""

    @property
    def grid(self) -> Any: ...
    @property
    def computed(self) -> NDArray[np.bool_]: ...
    @property
    def versions(self) -> tuple[str, ...]: ...
    def _labels(self) -> dict[str, Any]: ...
    def _of_bodies(self) -> dict[str, Any]: ...
    def _derived(self) -> dict[str, Any]: ...
    def _unit(self, name: str) -> str: ...


SAID = {"speed": "speed of approach", "temperature": "mean energy of each mode over the translational one"}
"""What axes are; the others are what they are called."""


def write(sweep: Swept, path: str) -> None:
    """Make the file in memory, where no write fails that HDF5 does not survive; then write it whole."""
    try:
        import netCDF4
    except ImportError:
        raise ImportError("netcdf: a sweep is written with the package netCDF4 (python3-netcdf4), which is missing") from None

    file = netCDF4.Dataset("sweep", "w", format="NETCDF4", memory=1)  # bytes to begin with
    _describe(file, sweep)
    _coordinates(file, sweep)
    _results(file, sweep)
    _write(file, path)


def write_columns(
    path: str,
    columns: Mapping[str, Any],
    dimensions: tuple[str, ...],
    units: Mapping[str, str],
    inputs: Mapping[str, Any],
    form: str,
) -> None:
    """The columns of a result; those named as dimensions are its coordinates."""
    try:
        import netCDF4
    except ImportError:
        raise ImportError("netcdf: needs the package netCDF4 (python3-netcdf4), which is missing") from None

    file = netCDF4.Dataset("result", "w", format="NETCDF4", memory=1)
    file.setncatts({"Conventions": "CF-1.8", "format": form, "source": f"stoss {_core.version}"})
    file.setncatts({key: str(value) for key, value in inputs.items()})
    shape = next(iter(columns.values())).shape
    for axis, (name, size) in enumerate(zip(dimensions, shape)):
        file.createDimension(name, size)
        variable = file.createVariable(name, "f8", (name,))
        variable[:] = np.moveaxis(columns[name], axis, 0).reshape(size, -1)[:, 0]
    for name, values in columns.items():
        if name not in dimensions:
            file.createVariable(name, "f8", dimensions, zlib=True, shuffle=True)[:] = values
        file[name].setncatts({"long_name": name.replace("_", " "), "units": units.get(name, "1")})
    _write(file, path)


def _write(file: Any, path: str) -> None:
    content = file.close()
    with whole_file(path) as temporary, open(temporary, "wb") as stream:
        stream.write(content)
        stream.flush()
        os.fsync(stream.fileno())


def _describe(file: Any, sweep: Swept) -> None:
    missing = sweep.computed.size - int(np.count_nonzero(sweep.computed))
    file.setncatts(
        {
            "Conventions": "CF-1.8",
            "format": _files.SWEEP,
            "title": "Coefficient of restitution of elastic bodies",
            "source": f"stoss {', '.join(sweep.versions) or _core.version}",
            **sweep.grid.computation.accuracy,
            "missing_values": missing,
            "complete": "false" if missing else "true",
            "grid": json.dumps(sweep.grid.to_dict()),
            "units_of_results": "of the first body: its radius R or length L, c = sqrt(E/rho), its mass; "
            "with materials SI values have names that end in _si",
        }
    )


def _coordinates(file: Any, sweep: Swept) -> None:
    for name, size in zip(sweep.grid.dimensions, sweep.grid.shape):
        file.createDimension(name, size)
    for name, values in sweep.grid.axes.items():
        along = file.createVariable(name, "f8", (name,))
        along.setncatts({"long_name": SAID.get(name, name.replace("_", " ")), "units": sweep._unit(name) or "1"})
        along[:] = values
    labels = sweep._labels()
    for name, said in (("body", "what meets"), ("against", "what it meets")):
        names = file.createVariable(name, str, (name,))
        names.long_name = said
        names[:] = labels[name]
    for name, values in sweep._of_bodies().items():
        variable = file.createVariable(name, "f8", ("body",), fill_value=np.nan)
        variable.units = sweep._unit(name) or "1"
        variable[:] = values


def _results(file: Any, sweep: Swept) -> None:
    import netCDF4

    quantities = sweep._derived()
    for own in sweep.grid.computation.columns:
        for name, said in ((own, own), (si_name(own), f"{own} in SI")):
            if name not in quantities:
                continue
            values = quantities[name]
            code = {"f": "f8", "i": "i8", "b": "i1"}[values.dtype.kind]
            fill = None if code == "i1" else netCDF4.default_fillvals[code]
            variable = file.createVariable(name, code, sweep.grid.dimensions, fill_value=fill, zlib=True, shuffle=True)
            variable.long_name = said.replace("_", " ")
            variable.setncatts(_flags("false true") if code == "i1" else {"units": sweep._unit(name) or "1"})
            variable[:] = np.where(sweep.computed, values, 0 if fill is None else fill)
    state = file.createVariable("computed", "i1", sweep.grid.dimensions, zlib=True)
    state.setncatts({"long_name": "whether the value is there"} | _flags("missing computed"))
    state[:] = sweep.computed


def _flags(meanings: str) -> dict[str, Any]:
    return {"flag_values": np.array([0, 1], "i1"), "flag_meanings": meanings}
