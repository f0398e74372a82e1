"""One impact at a fixed resolution."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import flags, instance, integer, number, optional_number
from stoss._bodies import Body, ExponentialWall, HardWall, Wall, choose_body, contact_with
from stoss._errors import InvalidInput
from stoss._impact_result import Impact
from stoss._material import Material, speeds_in_si


def impact(
    *,
    speed: float,
    poisson: float | None = None,
    material: Material | None = None,
    body: Body | None = None,
    cutoff: float = 50.0,
    wall: Wall = HardWall(),
    step: float | None = None,
    nodes: int | None = None,
    half_width: float | None = None,
    keep: ArrayLike | None = None,
) -> Impact:
    """One impact of an elastic body on a wall at a fixed resolution, with its energy ledger.

    The modes with ω ≤ `cutoff` move by m Q̈ = −m ω² Q − F·(their amplitude at the contact); all
    others answer the wall together. For a value with an error bar use `restitution`.

    Parameters
    ----------
    speed : float
        Of the centre of mass towards the wall, 1e-8 to 1, c (with a material: m/s). Two equal
        bodies that each move at `speed` towards each other are the same problem.
    poisson : float
        2-D Poisson number of a disk, −0.95 to 0.995. Or
    material : Material
        a material and radius in SI, or
    body : Disk or Rod
        a body.
    cutoff : float, optional
        Highest frequency of the modes that are kept, c/R.
    wall : HardWall or ExponentialWall, optional
        Default: hard.
    step : float, optional
        Time step, R/c.
    nodes : int, optional
        Of the contact grid.
    half_width : float, optional
        Of the contact grid, R.
    keep : array_like of bool, optional
        Which of the modes with ω ≤ `cutoff` are kept, in the order of `Impact.mode_energies`; only
        with an `ExponentialWall`, because a hard wall would need what the others give way. Default:
        all.

    Returns
    -------
    Impact

    Raises
    ------
    InvalidInput
        For arguments out of range.
    NotConverged
        If the contact cannot be solved or does not end.

    Examples
    --------
    >>> hit = stoss.impact(poisson=0.33, speed=0.1)
    >>> hit
    Impact(Disk(poisson=0.33), speed=0.1 c: restitution 0.94705, contact time 5.898 R/c, 1146 modes)
    >>> round(hit.translation + hit.vibration + hit.unresolved, 3)
    1.0

    With a soft wall the modes may be chosen, for example those that a first run finds to be the
    most energetic.

    >>> soft = stoss.ExponentialWall(hardness=500)
    >>> average = stoss.impact(poisson=0.33, speed=0.1, wall=soft).mode_energies["average"]
    >>> stoss.impact(poisson=0.33, speed=0.1, wall=soft, keep=average >= np.sort(average)[-300]).modes
    300
    """
    chosen = choose_body(poisson, material, body)
    initial = number("speed", speed)
    if material is not None:
        initial /= material.scales.speed
    at = number("cutoff", cutoff)
    instance("wall", wall, (HardWall, ExponentialWall))
    count = None if nodes is None else integer("nodes", nodes)
    duration, width = optional_number("step", step), optional_number("half_width", half_width)
    kept = None if keep is None else flags("keep", keep)
    if kept is not None and not isinstance(wall, ExponentialWall):
        hint = "a hard wall would need what the other modes give way"
        raise InvalidInput(
            f"keep: got a selection of modes and {wall!r}, allowed only with a stoss.ExponentialWall ({hint})"
        )
    with speeds_in_si(material):
        return repeated(chosen, wall, initial, at, duration, count, width, kept, material)


def repeated(
    body: Body,
    wall: Wall,
    speed: float,
    cutoff: float,
    step: float | None,
    nodes: int | None,
    half_width: float | None,
    keep: NDArray[np.bool_] | None,
    material: Material | None,
) -> Impact:
    """The impact with these inputs, checked before."""
    radiating = not (isinstance(wall, HardWall) and wall.tail == "static")
    handle = _core.impact(contact_with(body, wall, cutoff, keep), radiating, speed, step, nodes, half_width)
    energies = handle.modes()
    return Impact(
        body=body, wall=wall, keep=keep, material=material, modes=len(energies), mode_energies=energies, _handle=handle,
        **handle.numbers(),
    )  # fmt: skip
