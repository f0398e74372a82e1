"""A sweep as a NetCDF-4 file."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any

import numpy as np

from stoss import _core
from stoss.bodies._solid import describe
from stoss.export._files import whole_file
from stoss.results._result import QUANTITIES, unit
from stoss.results._si import si_name
from stoss.sweeps._specification import label, numbers_of_bodies, unit_of_body

if TYPE_CHECKING:
    from stoss.sweeps._values import Sweep

DIMENSIONS = ("body", "against", "speed")


def write(sweep: Sweep, path: str) -> None:
    """Make the file in memory, where no write fails that HDF5 does not survive; then write it whole."""
    try:
        import netCDF4
    except ImportError:
        raise ImportError("netcdf: a sweep is written with the package netCDF4 (python3-netcdf4), which is missing") from None

    file = netCDF4.Dataset("sweep", "w", format="NETCDF4", memory=1)  # bytes to begin with
    _describe(file, sweep)
    _coordinates(file, sweep)
    _results(file, sweep)
    content = file.close()
    with whole_file(path) as temporary, open(temporary, "wb") as stream:
        stream.write(content)
        stream.flush()
        os.fsync(stream.fileno())


def _describe(file: Any, sweep: Sweep) -> None:
    missing = sweep.computed.size - int(np.count_nonzero(sweep.computed))
    file.setncatts(
        {
            "Conventions": "CF-1.8",
            "title": "Coefficient of restitution of elastic bodies",
            "source": f"stoss {', '.join(sweep.versions) or _core.version}",
            "tolerance": sweep.grid.tolerance,
            "absolute": sweep.grid.absolute,
            "missing_values": missing,
            "complete": "false" if missing else "true",
            "grid": json.dumps(sweep.grid.to_dict()),
            "units_of_results": "of the first body: its radius R or length L, c = sqrt(E/rho), its mass; "
            "with materials SI values have names that end in _si",
        }
    )


def _coordinates(file: Any, sweep: Sweep) -> None:
    for name, size in zip(DIMENSIONS, sweep.grid.shape):
        file.createDimension(name, size)
    speed = file.createVariable("speed", "f8", ("speed",))
    speed.setncatts({"long_name": "speed of approach", "units": "m/s" if sweep.grid.in_si else "c"})
    speed[:] = sweep.grid.speed
    bodies = [describe(body) for body in sweep.grid.bodies]
    for name, given in (("body", bodies), ("against", sweep.grid.against)):
        names = file.createVariable(name, str, (name,))
        names.long_name = "what meets" if name == "body" else "what it meets"
        names[:] = np.array([label(each) for each in given], dtype=object)
    for name, values in numbers_of_bodies(sweep.grid.bodies).items():
        variable = file.createVariable(f"body_{name}", "f8", ("body",), fill_value=np.nan)
        variable.units = unit_of_body(name, sweep.grid.in_si) or "1"
        variable[:] = values


def _results(file: Any, sweep: Sweep) -> None:
    import netCDF4

    kinds = sorted({body._kind for body in sweep.grid.bodies})

    def create(name: str, code: str, values: Any, attributes: dict[str, Any]) -> None:
        fill = None if code == "i1" else netCDF4.default_fillvals[code]
        variable = file.createVariable(name, code, DIMENSIONS, fill_value=fill, zlib=True, shuffle=True)
        variable.setncatts(attributes)
        variable[:] = np.where(sweep.computed, values, 0 if fill is None else fill)

    for name, dimension in QUANTITIES["restitution"].items():
        values = sweep.rows[name]
        code = {"f": "f8", "i": "i8", "b": "i1"}[values.dtype.kind]
        units = sorted({unit(dimension, body=each, si=False) for each in kinds})
        attributes: dict[str, Any] = {"long_name": name.replace("_", " "), "units": " or ".join(units) or "1"}
        if code == "i1":
            attributes = {"long_name": name.replace("_", " "), "flag_values": np.array([0, 1], "i1")}
            attributes["flag_meanings"] = "false true"
        create(name, code, values, attributes)
        if dimension and sweep.grid.in_si:
            scales = np.array([getattr(body.scales, dimension) for body in sweep.grid.bodies])
            units = sorted({unit(dimension, body=each, si=True) for each in kinds})
            attributes = {"long_name": f"{name.replace('_', ' ')} in SI", "units": " or ".join(units)}
            create(si_name(name), "f8", values * scales[:, None, None], attributes)
    state = file.createVariable("computed", "i1", DIMENSIONS, zlib=True)
    state.setncatts({"long_name": "whether the value is there", "flag_values": np.array([0, 1], "i1")})
    state.flag_meanings = "missing computed"
    state[:] = sweep.computed
