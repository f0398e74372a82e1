"""Modes of two meshes become one list with errors, in which equal frequencies are one mode."""

from __future__ import annotations

from typing import Mapping

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]
Modes = Mapping[str, Vector]
"""Modes of one mesh: frequency in Hz, displacement and its curvature at the point, in rising order."""

CLOSE = 1e-3
"""Modes further apart than this share of their frequency are never taken as one, unless meshes mix them."""
MIXED = 1e-2, 0.1
"""Up to which share of their frequency modes may be mixed, and the share of the motion that says that they are.

With edges of R/3 a mesh splits the modes of one frequency of a sphere by up to a hundredth, and two meshes mix them
with others in different ways: what they move the point together is known ten times better than what each does.
"""
SHAPES = 1.5
"""Least relative error of a displacement, in errors of order 2 of its frequency (docs/developer/bodies.md)."""


def groups(frequencies: Vector, errors: Vector, close: float = CLOSE) -> list[slice]:
    """Neighbours in a list of frequencies that differ by less than their errors.

    >>> groups(np.array([1.0, 2.0, 2.0001, 3.0]), np.full(4, 0.001))
    [slice(0, 1, None), slice(1, 3, None), slice(3, 4, None)]
    """
    between = np.maximum(errors[1:], errors[:-1])
    allowed = np.minimum(between, close * frequencies[1:]) + 1e-6 * frequencies[1:]
    apart = np.diff(frequencies) > allowed
    ends = [0, *(np.flatnonzero(apart) + 1), len(frequencies)]
    return [slice(int(start), int(end)) for start, end in zip(ends, ends[1:])]


def combined(modes: Modes, clusters: list[slice]) -> dict[str, Vector]:
    """Each cluster as the combinations of its modes that move the point: one, or with a tangent two.

    The first one of two moves it along the normal and the second along the tangent, as far as they
    can be told apart: the greater of both motions is in one of them as a whole. `cluster` is the
    number of each.
    """
    names: tuple[str, ...] = ("displacement", "displacement_curvature")
    if "tangential_displacement" in modes:
        names += tuple(f"tangential_{name}" for name in names)
    rows = []
    for number, cluster in enumerate(clusters):
        f, *motions = (modes[name][cluster] for name in ("frequency", *names))
        shares = [_direction(motions[0])]
        if len(names) > 2 and len(f) > 1:
            shares = _two_directions(motions[0], motions[2])
        for each in shares:
            rows.append((number, np.sqrt(each**2 @ f**2), *(each @ motion for motion in motions)))
    return dict(zip(("cluster", "frequency", *names), np.array(rows).T))


def _two_directions(normal: Vector, tangential: Vector) -> list[Vector]:
    """Displacements of combinations perpendicular to each other, along the normal and along the tangent."""
    swapped = np.linalg.norm(tangential) > np.linalg.norm(normal)
    greater, less = (tangential, normal) if swapped else (normal, tangential)
    first = _direction(greater)
    for _ in range(2):  # twice is enough
        less = less - (first @ less) * first
    both = [first, _direction(less)]
    return both[::-1] if swapped else both


def _direction(moved: Vector) -> Vector:
    """Shares of modes in the combination that moves like this, with the sum of their squares 1."""
    whole = float(np.linalg.norm(moved))
    return moved / whole if whole > 0.0 else np.full(len(moved), len(moved) ** -0.5)


def mixed(fine: Modes, coarse: Modes, errors: Vector) -> list[slice]:
    """Groups of modes, and those as one whose shares of what they move together differ between both meshes."""
    f = fine["frequency"]
    near = groups(f, errors)
    found: list[slice] = []
    for wide in groups(f, errors, MIXED[0]):
        parts = [each for each in near if wide.start <= each.start < wide.stop]
        differ = 0.0
        if wide.stop <= len(coarse["frequency"]):
            for name in {"displacement", "tangential_displacement"} & set(fine):
                one, other = (_shares(modes[name], wide, parts) for modes in (fine, coarse))
                differ = max(differ, float(np.max(np.abs(one - other))))
        found += [wide] if differ > MIXED[1] else parts
    return found


def _shares(moved: Vector, wide: slice, parts: list[slice]) -> Vector:
    """What parts of a group have of the sum of squares of its displacements."""
    whole = float(np.sum(moved[wide] ** 2)) or 1.0
    return np.array([np.sum(moved[each] ** 2) / whole for each in parts])


def merged(
    fine: Modes, coarse: Modes | None, finer: float, bounds: tuple[float, float] | None = None
) -> dict[str, Vector]:
    """One list of modes, as in the file, `complete_to` and of how many modes; without a coarse mesh it has no errors.

    Modes of both meshes belong together by their place in the list. `finer` is by what an error of
    the fine mesh may exceed the difference between both. Those of frequencies are such differences
    times a number between these `bounds`, and are taken off as far as they are known.
    """
    f = fine["frequency"]
    if coarse is None:
        clusters = groups(f, 1e-4 * f)
        return {**_rising(combined(fine, clusters)), "complete_to": f[-1:], "count": np.array([len(f)])}
    least, most = bounds or (-finer, finer)
    common = min(len(f), len(coarse["frequency"]))
    errors = finer * np.abs(f[:common] - coarse["frequency"][:common])
    errors = np.append(errors, np.full(len(f) - common, errors.max()))
    clusters = [each for each in mixed(fine, coarse, errors) if each.stop <= common]
    ours, theirs = combined(fine, clusters), combined(coarse, clusters)
    number, count = ours["cluster"].astype(int), clusters[-1].stop
    spreads = np.array([np.ptp(f[each]) for each in clusters])[number]
    fall = np.array([np.mean(f[each] - coarse["frequency"][each]) for each in clusters])[number]
    differ = np.maximum(np.abs(ours["frequency"] - theirs["frequency"]), np.abs(fall))
    # A difference may be small by chance: shapes are not known as well as frequencies.
    shares = SHAPES * (finer * differ + spreads) / ours["frequency"]
    for name in ("displacement", "tangential_displacement"):
        if name in ours:  # the sign of a mode is any
            changed = finer * np.abs(np.abs(ours[name]) - np.abs(theirs[name]))
            ours[f"{name}_error"] = np.maximum(changed, shares * np.abs(ours[name]))
    ours["frequency_error"] = 0.5 * (most - least) * differ + spreads
    middle = 0.5 * (least + most)
    ours["frequency"] = ours["frequency"] + middle * fall
    last = f[count - 1] + middle * (f[count - 1] - coarse["frequency"][count - 1])
    return {**_rising(ours), "complete_to": np.array([max(last, *ours["frequency"])]), "count": np.array([count])}


def _rising(modes: dict[str, Vector]) -> dict[str, Vector]:
    """In the order of their frequencies, without the numbers of clusters."""
    order = np.argsort(modes["frequency"], kind="stable")
    return {name: each[order] for name, each in modes.items() if name != "cluster"}
