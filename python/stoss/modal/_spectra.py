"""Modes of two meshes become one list with errors, in which equal frequencies are one mode."""

from __future__ import annotations

from typing import Mapping

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]
Modes = Mapping[str, Vector]
"""Of one mesh: frequency in Hz, displacement and its curvature at the point, in rising order."""

CLOSE = 1e-3
"""Modes further apart than this share of their frequency are never taken as one."""


def groups(frequencies: Vector, errors: Vector) -> list[slice]:
    """Neighbours in a list of frequencies that differ by less than their errors.

    >>> groups(np.array([1.0, 2.0, 2.0001, 3.0]), np.full(4, 0.001))
    [slice(0, 1, None), slice(1, 3, None), slice(3, 4, None)]
    """
    between = np.maximum(errors[1:], errors[:-1])
    allowed = np.minimum(between, CLOSE * frequencies[1:]) + 1e-6 * frequencies[1:]
    apart = np.diff(frequencies) > allowed
    ends = [0, *(np.flatnonzero(apart) + 1), len(frequencies)]
    return [slice(int(start), int(end)) for start, end in zip(ends, ends[1:])]


def combined(modes: Modes, clusters: list[slice]) -> dict[str, Vector]:
    """Each cluster as the one combination of its modes that moves the point."""
    names = ("frequency", "displacement", "displacement_curvature")
    rows = []
    for cluster in clusters:
        f, moved, bent = (modes[name][cluster] for name in names)
        whole = float(np.linalg.norm(moved))
        shares = moved / whole if whole > 0.0 else np.full(len(f), len(f) ** -0.5)
        rows.append((np.sqrt(shares**2 @ f**2), whole, shares @ bent))
    return dict(zip(names, np.array(rows).T))


def merged(fine: Modes, coarse: Modes | None, finer: float) -> dict[str, Vector]:
    """One list of modes, as in the file, and `complete_to`; without a coarse mesh it has no errors.

    Modes of both meshes belong together by their place in the list. `finer` is by what an error of
    the fine mesh may exceed the difference between both.
    """
    f = fine["frequency"]
    if coarse is None:
        clusters = groups(f, 1e-4 * f)
        return {**combined(fine, clusters), "complete_to": f[-1:]}
    common = min(len(f), len(coarse["frequency"]))
    errors = finer * np.abs(f[:common] - coarse["frequency"][:common])
    errors = np.append(errors, np.full(len(f) - common, errors.max()))
    clusters = [each for each in groups(f, errors) if each.stop <= common]
    ours, theirs = combined(fine, clusters), combined(coarse, clusters)
    spreads = np.array([np.ptp(f[each]) for each in clusters])
    for name in ("frequency", "displacement"):
        ours[f"{name}_error"] = finer * np.abs(ours[name] - theirs[name])
    ours["frequency_error"] += spreads
    # A difference may be small by chance: shapes are not known better than frequencies.
    shares = ours["frequency_error"] / ours["frequency"]
    ours["displacement_error"] = np.maximum(
        ours["displacement_error"], shares * np.abs(ours["displacement"])
    )
    return {**ours, "complete_to": f[clusters[-1].stop - 1 : clusters[-1].stop]}
