"""Predicts what a drop test of a real ball shows."""

from __future__ import annotations

import warnings
from typing import Any, Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, boolean, instance, integer, number, numbers, optional_number, refusal
from stoss._documentation import documented
from stoss._errors import InvalidInput, StossWarning
from stoss.bodies._bodies import BODIES, PARTNERS, Sphere
from stoss.bodies._encounter import Against, drop_encounter
from stoss.bodies._walls import ExponentialWall, HardWall, Unbounded
from stoss.results._prediction import CHANNELS, Influence, Prediction
from stoss.results._progress import waiting
from stoss.results._quantities import QUANTITIES


@documented
def predict(
    body: Sphere,
    *,
    against: HardWall | Sphere | Unbounded | str | None = None,
    speed: ArrayLike | None = None,
    height: ArrayLike | None = None,
    adhesion: float | None = None,
    uncertainties: Mapping[str, float] | None = None,
    tolerance: float = 1e-3,
    threads: int = 0,
    progress: bool = False,
) -> Prediction:
    """Predict ε of a real ball, with all that takes energy, channel by channel.

    Ringing, radiation and loss in the material are computed from elasticity, with a numerical error.
    Yield and adhesion are models, with a spread of their own. All are in one motion, so that they
    take of each other. Materials of `stoss.materials` bring how well their constants are known, and
    have their quality at all frequencies; a `loss_time` is Kelvin and Voigt's. All is in SI. What
    ends within the range of what was computed is in `warnings`, and a `StossWarning` says it once.

    Parameters:
        body: The ball: with a material.
        against: What it meets, with a material: a rigid wall (default), an identical ball ('same'),
            another one, a half-space or a plate.
        speed: Of approach, m/s, 1e-8 to 1 c of the ball.
        height: In its place, that from which the ball falls without air, m.
        adhesion: Work of adhesion of both surfaces, J/m², 0 to 1e6; default: 2√(γ₁γ₂) of the
            `surface_energy` of both materials, 0 where one has none.
        uncertainties (mapping of str to float, optional): Of constants, as ``{"young": 0.05,
            "against loss_time": 2}``: each is known within a factor of 1 + u, u from 0 to 10.
            Default: those of `stoss.materials`.
        tolerance: Of the computed channels: relative error of 1 − ε², 1e-15 to 0.5.

    Examples:
        >>> ball = stoss.Sphere(radius=5e-3, material=stoss.materials["bearing steel"])
        >>> block = stoss.HalfSpace(material=stoss.materials["bearing steel"])
        >>> gentle = stoss.predict(ball, against=block, speed=0.1)
        >>> round(gentle.restitution, 4), gentle.dominant
        (0.9987, 'radiation')
        >>> fall = stoss.predict(ball, against=block, height=[1e-4, 1e-3])
        >>> fall.speed.round(4)
        array([0.0443, 0.14  ])
    """
    ball: Any = instance("body", body, BODIES)
    met = _choose_met(ball, against)
    if (speed is None) == (height is None):
        raise InvalidInput.out_of_range("speed", "neither" if speed is None else "speed and height", "one of them")
    speeds = numbers("speed", speed) if height is None else _speeds_of_drops(numbers("height", height))
    work, known = optional_number("adhesion", adhesion), _choose_uncertainties(uncertainties)
    limit, count = number("tolerance", tolerance), integer("threads", threads)
    meeting = drop_encounter(ball, met)
    with waiting(boolean("progress", progress), "predict"):
        rows = _core.predict(meeting, speeds.ravel(), work, known, limit, count)
    for row in rows:
        row["influences"] = tuple(Influence(*each) for each in row["influences"])
        row["warnings"] = tuple(row["warnings"])
    kinds: dict[str, Any] = dict.fromkeys(QUANTITIES["prediction"], np.float64)
    kinds |= dict.fromkeys(("dominant", "influences", "warnings"), object)
    columns = {CHANNELS.get(name, name): _column(rows, name, kind, speeds.shape) for name, kind in kinds.items()}
    begins, ends, sticks, adheres = _core.thresholds(meeting, work)
    for said in dict.fromkeys(each for row in rows for each in row["warnings"]):
        warnings.warn(said, StossWarning, stacklevel=2)
    return Prediction(
        ball, met, **columns, yield_speed=begins, impression_speed=ends, sticking_speed=sticks, adhesion_speed=adheres,
        work_of_adhesion=work, uncertainties=known or None, tolerance=limit,
    )  # fmt: skip


def _column(rows: list[dict[str, Any]], name: str, kind: Any, shape: tuple[int, ...]) -> Any:
    column = np.empty(len(rows), dtype=kind)
    for k, row in enumerate(rows):  # one by one, as some are tuples
        column[k] = row[name]
    return arranged(column, shape)


def _choose_met(ball: Any, against: Any) -> Against | str:
    if against is None:
        return HardWall()
    if isinstance(against, str) and against != "same":
        raise refusal("against", against, "None, 'same', a stoss.Sphere, a stoss.HalfSpace or a stoss.Plate")
    if isinstance(against, str):
        return against
    met: Against = instance("against", against, (HardWall, ExponentialWall, *PARTNERS))
    return met


def _speeds_of_drops(heights: NDArray[np.float64]) -> NDArray[np.float64]:
    if not np.all(heights > 0.0):
        raise refusal("height", float(heights[~(heights > 0.0)][0]), "above 0 (of a fall, m)")
    return _core.speed_of_drop(heights.ravel()).reshape(heights.shape)


def _choose_uncertainties(given: Any) -> dict[str, float]:
    if given is None:
        return {}
    if not isinstance(given, Mapping) or not all(isinstance(name, str) for name in given):
        raise refusal("uncertainties", given, "a mapping of names to numbers, as {'young': 0.05}")
    return {name: number(f"uncertainties {name}", each) for name, each in given.items()}
