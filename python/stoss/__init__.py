"""Coefficient of restitution of elastic bodies from first principles.

>>> import stoss
>>> disk = stoss.Disk(poisson=0.33)
>>> stoss.restitution(disk, speed=0.1)
Restitution(poisson=0.33, speed=0.1 c: restitution 0.947042 ± 0.000038)

A body comes first, all other arguments are named; those out of range are refused with
`InvalidInput` before anything is computed. Units are those of the first body: radius R, bar
speed c = √(E/ρ), mass m; of bodies with a `Material`, speeds are in m/s.

What cannot meet its own conditions raises `NotConverged`, and Ctrl-C `Interrupted`: what is done is
their attribute `best`. Files appear whole or not at all; OSError says that one cannot be read or
written.

================================  ==================================================================
`restitution`                     ε(v) with errors, for numbers and arrays, at a wall or of two
                                  bodies
`restitution_function`            ε(v) as a function, to an error at every speed
`pair_table`                      ε of two bodies against the speed and the ratio of their radii
`collision_rule`                  the whole rule with friction as a function: velocities and spins
                                  after
`impact`                          one impact: energy ledger, trajectory, deformation and stress in
                                  time
`oblique`                         impacts at an angle, with spin and friction
`oblique_impact`                  one of them in time, with all that the contact points do
`predict`                         what a drop test of a real ball shows, with yield and adhesion as
                                  models
`calibrate`                       constants of materials from measured impacts
`fit`                             constants of a force law of a simulation program, and their misfit
`restitution_distribution`        ε of many bodies that vibrate at random before
`sweep`, `Grid`                   ε of many bodies, partners and speeds, with a store
`merge`, `open_sweep`             the values in such a store
`atlas`                           ε of spheres and disks at once, from a sweep; with errors
`bounce`                          a body that comes back to a wall with the vibration it has kept
`modes`                           the eigenmodes of a disk or a sphere
`rod_chain`                       rods on a ring that remember their collisions
`row`, `row_impact`               bodies on a line, as in a cradle: velocities after, motion in time
`pulse`                           the force of one impact in time, its spectrum, and what a sensor on or
                                  in a block or a plate records
`quasistatic`                     slow impacts, Rayleigh's estimate of the loss, static contacts
`Disk`, `Sphere`, `Rod`           bodies
`HollowSphere`                    a shell, as a table-tennis ball
`ModalBody`                       any body by its modes at a point, from a file
`HalfSpace`, `HalfPlane`          elastic blocks, which carry waves away
`Plate`, `Layer`, `Strip`         elastic plates of some thickness
`HardWall`, `ExponentialWall`     walls
`Oscillation`                     a mode that vibrates before an impact
`Material`, `materials`           SI; typical materials
`relaxation_of_measurement`       of a material, from its moduli; `shifted` to another temperature
`plot`                            pictures (needs matplotlib)
`read_csv`                        reads what `to_csv` or the command has written
`with_error`                      a number with the digits that its error leaves it, for reading
================================  ==================================================================
"""

# ruff: noqa: E402, F822 (_starting must come first; __getattr__ has the names)
from stoss import _starting

_starting.end_quietly()  # before what takes long

import importlib

# What the package has, by the modules that it is imported from when it is asked for.
_MODULES = {
    "_errors": "Interrupted InvalidInput NotConverged StossWarning",
    "bodies._bodies": "Body Disk HollowSphere Rod Sphere",
    "bodies._material": "Material Scales materials",
    "bodies._measurement": "FittedRelaxation relaxation_of_measurement shifted",
    "bodies._modal": "ModalBody",
    "bodies._state": "Oscillation",
    "bodies._walls": "ExponentialWall HalfPlane HalfSpace HardWall Layer Plate Strip Wall",
    "calibration._calibration": "CalibratedConstant Calibration calibrate",
    "export._csv": "Table read_csv",
    "export._tables": "with_error",
    "laws._fit": "Fit Misfit fit",
    "results._adaptive_rule": "collision_rule",
    "results._atlas": "AtlasValue atlas",
    "results._bounce": "Bounces bounce",
    "results._distribution": "RestitutionDistribution restitution_distribution",
    "results._field": "DiskField Field SphereField Trajectory Wave",
    "results._function": "RestitutionFunction restitution_function",
    "results._impact": "Impact impact",
    "results._modes": "Modes modes",
    "results._oblique": "ObliqueRestitution oblique",
    "results._oblique_impact": "ObliqueImpact ObliqueTrajectory oblique_impact",
    "results._obliquity": "ObliqueLedger",
    "results._pair_table": "PairTable pair_table",
    "results._prediction": "Influence Prediction predict",
    "results._pulse": "Pulse pulse",
    "results._restitution": "Restitution restitution",
    "results._rod_chain": "RodChain rod_chain",
    "results._rule": "CollisionRule",
    "results._seismogram": "Seismogram",
    "results._sound": "Sound",
    "rows._row": "Row row",
    "rows._row_impact": "RowImpact row_impact",
    "sweeps._grid": "Grid",
    "sweeps._sweep": "sweep",
    "sweeps._values": "Sweep merge open_sweep",
}
_PLACES = {name: module for module, names in _MODULES.items() for name in names.split()}
_PLACES |= {"quasistatic": "", "plot": "", "animate": "plot"}

__all__ = [*_PLACES, "__version__"]


def __getattr__(name: str) -> object:
    """Imports what is asked for: with all of it, NumPy and tables of the core, a program begins three times as late."""
    if name == "__version__":
        value: object = importlib.import_module("stoss._core").version
    elif name in _PLACES:
        module = importlib.import_module(f"stoss.{_PLACES[name] or name}")
        value = getattr(module, name) if _PLACES[name] else module
    else:
        raise AttributeError(f"module 'stoss' has no attribute {name!r}")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
