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

# ruff: noqa: E402, F822 (_starting must come first; plot and animate come from __getattr__)
from stoss import _starting

_starting.end_quietly()  # before what takes long

import importlib

from stoss import quasistatic
from stoss._core import version as __version__
from stoss._errors import Interrupted, InvalidInput, NotConverged, StossWarning
from stoss.bodies._bodies import Body, Disk, HollowSphere, Rod, Sphere
from stoss.bodies._material import Material, Scales, materials
from stoss.bodies._measurement import FittedRelaxation, relaxation_of_measurement, shifted
from stoss.bodies._modal import ModalBody
from stoss.bodies._walls import ExponentialWall, HalfPlane, HalfSpace, HardWall, Layer, Plate, Strip, Wall
from stoss.bodies._state import Oscillation
from stoss.calibration._calibration import CalibratedConstant, Calibration, calibrate
from stoss.export._csv import Table, read_csv
from stoss.export._tables import with_error
from stoss.results._adaptive_rule import collision_rule
from stoss.laws._fit import Fit, Misfit, fit
from stoss.results._atlas import AtlasValue, atlas
from stoss.results._bounce import Bounces, bounce
from stoss.results._restitution import Restitution, restitution
from stoss.results._distribution import RestitutionDistribution, restitution_distribution
from stoss.results._field import DiskField, Field, SphereField, Trajectory, Wave
from stoss.results._function import RestitutionFunction, restitution_function
from stoss.results._impact import Impact, impact
from stoss.results._modes import Modes, modes
from stoss.results._oblique import ObliqueRestitution, oblique
from stoss.results._oblique_impact import ObliqueImpact, ObliqueTrajectory, oblique_impact
from stoss.results._obliquity import ObliqueLedger
from stoss.results._pair_table import PairTable, pair_table
from stoss.results._prediction import Influence, Prediction, predict
from stoss.results._pulse import Pulse, pulse
from stoss.results._result import Result
from stoss.results._rod_chain import RodChain, rod_chain
from stoss.rows._row import Row, row
from stoss.rows._row_impact import RowImpact, row_impact
from stoss.results._rule import CollisionRule
from stoss.results._seismogram import Seismogram
from stoss.results._sound import Sound
from stoss.sweeps._grid import Grid
from stoss.sweeps._sweep import sweep
from stoss.sweeps._values import Sweep, merge, open_sweep

__all__ = [
    "AtlasValue", "Body", "Bounces", "CalibratedConstant", "Calibration", "CollisionRule", "Disk", "DiskField", "ExponentialWall",
    "Field", "Fit", "FittedRelaxation", "Grid", "HalfPlane", "HalfSpace", "HardWall", "HollowSphere", "Impact",
    "Influence", "Interrupted", "InvalidInput", "Layer", "Material", "Misfit", "ModalBody", "Modes", "NotConverged",
    "ObliqueImpact", "ObliqueLedger", "ObliqueRestitution", "ObliqueTrajectory", "Oscillation",
    "PairTable", "Plate", "Prediction", "Pulse", "Restitution", "RestitutionDistribution", "RestitutionFunction", "Rod",
    "RodChain", "Row", "RowImpact", "Scales", "Seismogram", "Sound", "Sphere", "SphereField", "StossWarning", "Strip", "Sweep", "Table",
    "Trajectory", "Wall", "Wave",
    "__version__", "animate", "atlas", "bounce", "calibrate", "collision_rule",
    "fit", "impact", "materials", "merge", "modes", "oblique", "oblique_impact", "open_sweep",
    "pair_table", "plot", "predict", "pulse", "quasistatic", "read_csv", "relaxation_of_measurement", "restitution",
    "restitution_distribution", "restitution_function", "rod_chain", "row", "row_impact", "shifted", "sweep",
    "with_error",
]  # fmt: skip


def __getattr__(name: str) -> object:
    """Matplotlib is only loaded when a picture is asked for."""
    if name in ("plot", "animate"):
        plot = importlib.import_module("stoss.plot")
        return plot if name == "plot" else plot.animate
    raise AttributeError(f"module 'stoss' has no attribute {name!r}")


def _draw(result: Result, ax: object, name: str) -> object:
    pictures = importlib.import_module("stoss.plot").PICTURES
    return next(pictures[kind, name] for kind in type(result).__mro__ if (kind, name) in pictures)(result, ax)


Result._draw = _draw
