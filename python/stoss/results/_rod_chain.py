"""What became of a chain of rods."""

from __future__ import annotations

import dataclasses
import importlib
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from stoss.bodies._bodies import Rod
from stoss.results._result import Column, Result, span

SI = {"time": "s", "translation": "J", "vibration": "J", "dissipated": "J", "unresolved": "J", "momentum": "kg m/s"}


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class RodChain(Result):
    """A chain of rods in time.

    Values are in the units in which the rods were given, with materials in SI.

    Attributes
    ----------
    rods : tuple of Rod
    circumference : float
    velocities : ndarray
        Before all collisions.
    method, modes, pieces, tail, decay_time
        As they were given.
    impacts : ndarray
        All collisions, a structured array with the fields time, pair (the first of two rods), speed
        (of approach), restitution, vibration_before, vibration_after (energy in both rods) and
        unresolved (energy).
    velocity : ndarray
        After all collisions.
    time, collisions : ndarray
        Samples: at the start, after each of the first 50 collisions, then 2 % apart in their
        number, and at the end.
    translation : ndarray
        Kinetic energy of the rods' centres in the frame of their centre of mass, at these times.
    vibration : ndarray
        Energy of all vibrations.
    dissipated : ndarray
        Energy of vibrations that has decayed so far.
    unresolved : ndarray
        Energy taken so far by modes above the cutoff, or lost to merged pieces.
    momentum : ndarray
    speed, restitution, pair : ndarray
        Columns of `impacts`.
    """

    _name: ClassVar[str] = "rod_chain"

    rods: tuple[Rod, ...]
    circumference: float
    velocities: NDArray[np.float64]
    method: str
    modes: int
    pieces: int
    tail: str
    decay_time: float | None
    impacts: NDArray[Any]
    velocity: NDArray[np.float64]
    time: NDArray[np.float64]
    collisions: NDArray[np.int64]
    translation: NDArray[np.float64]
    vibration: NDArray[np.float64]
    dissipated: NDArray[np.float64]
    unresolved: NDArray[np.float64]
    momentum: NDArray[np.float64]

    def __len__(self) -> int:
        return len(self.impacts)

    def __repr__(self) -> str:
        unit = " s" if self._unit("time") else ""
        return (
            f"RodChain({len(self.rods)} rods, {len(self)} collisions, time 0 to {self.time[-1]:.6g}{unit}: "
            f"restitution {span(self.restitution)})"
        )

    @property
    def speed(self) -> NDArray[np.float64]:
        speed: NDArray[np.float64] = self.impacts["speed"]
        return speed

    @property
    def restitution(self) -> NDArray[np.float64]:
        restitution: NDArray[np.float64] = self.impacts["restitution"]
        return restitution

    @property
    def pair(self) -> NDArray[np.uint64]:
        pair: NDArray[np.uint64] = self.impacts["pair"]
        return pair

    def plot(self, ax: Any = None) -> Any:
        """Energies against time, with t⁻². See `stoss.plot.cooling`."""
        return self._picture(ax)

    def histogram(self, ax: Any = None) -> Any:
        """How often each ε occurs. See `stoss.plot.restitution_histogram`."""
        return importlib.import_module("stoss.plot").restitution_histogram(self, ax)

    def _unit(self, name: str) -> str:
        return SI.get(name, "") if self.rods[0].material is not None else ""

    def _inputs(self) -> dict[str, Any]:
        names = ("circumference", "method", "modes", "pieces", "tail", "decay_time")
        return {"rods": len(self.rods)} | {name: getattr(self, name) for name in names}

    def _table(self) -> dict[str, Column]:
        names = ("time", "collisions", "translation", "vibration", "dissipated", "unresolved", "momentum")
        return {name: getattr(self, name) for name in names}
