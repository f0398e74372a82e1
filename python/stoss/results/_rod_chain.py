"""Chains of rods that remember their collisions."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import boolean, choice, integer, number, numbers, optional_number, refusal
from stoss._errors import Interrupted, InvalidInput, NotConverged
from stoss.bodies._losses import relaxes
from stoss.bodies._bodies import Rod
from stoss.bodies._encounter import choose_tail
from stoss.export._tables import span
from stoss.results._progress import waiting
from stoss.results._result import Column, Result, columns, picture

SI = {"time": "s", "translation": "J", "vibration": "J", "dissipated": "J", "unresolved": "J", "momentum": "kg m/s"}


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class RodChain(Result):
    """A chain of rods in time.

    Values are in the units in which the rods were given, with materials in SI.

    Attributes:
        rods (tuple of Rod):
        circumference:
        velocities: Before all collisions.
        method, modes, pieces, tail, decay_time: As they were given.
        impacts: All collisions, a structured array with the fields time, pair (the first of two
            rods), speed (of approach), restitution, vibration_before, vibration_after (energy in
            both rods) and unresolved (energy).
        velocity: After all collisions.
        time, collisions: Samples: at the start, after each of the first 50 collisions, then 2 %
            apart in their number, and at the end.
        translation: Kinetic energy of the rods' centres in the frame of their centre of mass, at
            these times.
        vibration: Energy of all vibrations.
        dissipated: Energy of vibrations that has decayed so far.
        unresolved: Energy taken so far by modes above the cutoff, or lost to merged pieces.
        momentum:
        speed, restitution, pair: Columns of `impacts`.
    """

    plot = picture("Energies against time, with t⁻². See `stoss.plot.cooling`.")
    histogram = picture("How often each ε occurs. See `stoss.plot.restitution_histogram`.", "histogram")
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
        return self.impacts["speed"]

    @property
    def restitution(self) -> NDArray[np.float64]:
        return self.impacts["restitution"]

    @property
    def pair(self) -> NDArray[np.uint64]:
        return self.impacts["pair"]

    def _unit(self, name: str) -> str:
        return SI.get(name, "") if self.rods[0].material is not None else ""

    def _inputs(self) -> dict[str, Any]:
        names = ("circumference", "method", "modes", "pieces", "tail", "decay_time")
        return {"rods": len(self.rods)} | {name: getattr(self, name) for name in names}

    def _table(self) -> dict[str, Column]:
        names = ("time", "collisions", "translation", "vibration", "dissipated", "unresolved", "momentum")
        return {name: getattr(self, name) for name in names}


def rod_chain(
    rods: Sequence[Rod],
    *,
    circumference: float,
    velocities: ArrayLike | None = None,
    temperature: float | None = None,
    seed: int = 0,
    collisions: int | None = None,
    time: float | None = None,
    decay_time: float | None = None,
    method: str = "modes",
    modes: int = 50,
    pieces: int = 400,
    tail: str = "radiating",
    progress: bool = False,
) -> RodChain:
    """Let elastic rods move on a ring, meet head-on and vibrate from what they met.

    Rods fly freely between collisions, and each keeps its vibration: the one-dimensional granular
    gas of Giese and Zippelius, PRE 54, 4828 (1996). All numbers are in the units in which the rods
    are given, with materials in SI. A collision of 50 modes each takes 0.5 ms, one of
    characteristics 0.2 ms or less. Collisions that accumulate at one time (inelastic collapse) raise
    `NotConverged`.

    Parameters:
        rods (sequence of Rod): From 2, in their order on the ring, unexcited; at first the gaps are
            equal.
        circumference (float): Length of the ring, above the sum of the lengths. A collision is
            instantaneous compared with the flights: what rods move while they touch is neglected
            against the gaps.
        velocities (array_like, optional): One for each rod.
        temperature, seed (float, int, optional): In place of `velocities`: twice the mean kinetic
            energy of a rod, from which they are drawn.
        collisions (int, optional): How many there are, up to 1e9.
        time (float, optional): How long the chain runs; with `collisions` whichever ends first.
        decay_time (float, optional): In which the energy of a vibration falls to 1/e. None: it does
            not decay; 0: it is gone at the next collision.
        method ({'modes', 'characteristics'}): Collisions by `impact`, or by waves in pieces of
            constant velocity.
        modes (int, optional): Kept modes of the rod of the shortest transit time; the others keep
            all up to its frequency.
        pieces (int, optional): With characteristics: most of the wave in a rod; beyond them pieces
            are merged.
        tail ({'radiating', 'static'}): With modes: those above the cutoff take energy for good, or
            none.
        progress (bool, optional): Say on stderr for how long it has gone on.

    Examples:
        >>> rods = [stoss.Rod(length=length) for length in (1.0, 1.1, 0.9, 1.05)]
        >>> chain = stoss.rod_chain(rods, circumference=40, temperature=1, collisions=200, decay_time=0)
        >>> chain.restitution.max() < 1
        True
    """
    several: Sequence[Any] = rods if isinstance(rods, (list, tuple, np.ndarray)) else [None]
    if wrong := [each for each in several if not isinstance(each, Rod)]:
        raise refusal("rods", wrong[0] if several is rods else rods, "a list of stoss.Rod")
    if len({each.material is None for each in rods}) > 1:
        raise InvalidInput.out_of_range("rods", "some with and some without a material", "all with one or none")
    if wrong := [each for each in rods if relaxes(each)]:
        raise refusal("rods", wrong[0], "rods with a loss_time or none, in a chain")
    if collisions is None and time is None:
        raise InvalidInput.out_of_range("collisions", "none and no `time`", "a number", "when the chain ends")
    values = [(each.length, each.young, each.density, each.area, each.loss_time) for each in rods]
    if (velocities is None) == (temperature is None):
        got = "none and no `temperature`" if velocities is None else "both velocities and `temperature`"
        raise InvalidInput.out_of_range("velocities", got, "one of the two")
    if velocities is None:
        if integer("seed", seed) < 0:
            raise refusal("seed", seed, "0 or more")
        start = _core.thermal_velocities(values, number("temperature", temperature), integer("seed", seed))
    else:
        start = numbers("velocities", velocities)
        if start.ndim != 1:
            raise refusal("velocities", velocities, "one number for each rod")
        start.flags.writeable = False
    way = choice("method", method, ("modes", "characteristics"))
    kind = choose_tail(tail)
    chain = _core.rod_chain(
        values, number("circumference", circumference), start, way == "modes", integer("modes", modes),
        integer("pieces", pieces), kind, optional_number("decay_time", decay_time),
    )  # fmt: skip

    def result() -> RodChain:
        table = columns(chain.samples())
        return RodChain(
            tuple(rods), float(circumference), start, way, int(modes), int(pieces), kind, decay_time,
            impacts=chain.collisions(), velocity=chain.velocities(), **table,
        )  # fmt: skip

    shows = boolean("progress", progress)
    most = 1_000_000_000 if collisions is None else integer("collisions", collisions)
    try:
        with waiting(shows, "rod_chain"):
            chain.run(most, np.inf if time is None else number("time", time))
    except KeyboardInterrupt:
        done = result()
        raise Interrupted(f"rod_chain: interrupted after {len(done)} collisions (they are in .best)", done) from None
    except NotConverged as error:
        raise NotConverged(str(error), result()) from None
    return result()
