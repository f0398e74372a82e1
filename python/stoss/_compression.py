"""Force against compression of a disk that is pressed slowly against a wall."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stoss import _core
from stoss._arguments import arranged, broadcast, choice, numbers
from stoss._result import Number

LAWS = ("center", "diameter", "printed")


def _by_law(
    function: Callable[[str, NDArray[np.float64], NDArray[np.float64]], NDArray[np.float64]],
    law: Any,
    poisson: Any,
    name: str,
    value: Any,
) -> Any:
    chosen = choice("law", law, LAWS)
    given = {"poisson": numbers("poisson", poisson), name: numbers(name, value)}
    nu, argument = broadcast(**given)
    return arranged(function(chosen, nu.ravel(), argument.ravel()), nu.shape)


def compression(*, force: ArrayLike, poisson: ArrayLike, law: str = "center") -> Number:
    """Compression δ(F) = F (ln(s/F) − b) by a law of compression, R.

    The next order is smaller by about F.

    Parameters
    ----------
    force : array_like
        F, 0 to `limit_force`, πRE; broadcasts with `poisson`.
    poisson : array_like
        2-D Poisson number, −0.95 to 0.995.
    law : {'center', 'diameter', 'printed'}, optional
        See `stoss.quasistatic`.

    Returns
    -------
    float or ndarray

    Raises
    ------
    InvalidInput
        For arguments out of range.

    Examples
    --------
    >>> round(stoss.quasistatic.compression(force=0.001, poisson=0.33), 6)
    0.006575
    """
    return _by_law(_core.compression, law, poisson, "force", force)  # type: ignore[no-any-return]


def compression_force(*, compression: ArrayLike, poisson: ArrayLike, law: str = "center") -> Number:
    """Force F(δ) by a law of compression, πRE: the inverse of `compression`.

    Its relative error is 1e-14.

    Parameters
    ----------
    compression : array_like
        δ from 0 to that of `limit_force`, R; broadcasts with `poisson`.
    poisson, law
        As for `compression`.

    Returns
    -------
    float or ndarray

    Raises
    ------
    InvalidInput
        For arguments out of range.

    Examples
    --------
    >>> stoss.quasistatic.compression_force(compression=[0.01, 0.02], poisson=0.33).round(6)
    array([0.001645, 0.003821])
    """
    return _by_law(_core.compression_force, law, poisson, "compression", compression)  # type: ignore[no-any-return]


def compression_energy(*, force: ArrayLike, poisson: ArrayLike, law: str = "center") -> Number:
    """Energy ∫F dδ = F² [½ ln(s/F) − ½b − ¼] from no contact to the force F, mc².

    Parameters
    ----------
    force, poisson, law
        As for `compression`.

    Returns
    -------
    float or ndarray

    Raises
    ------
    InvalidInput
        For arguments out of range.

    Examples
    --------
    >>> impact = stoss.quasistatic.slow_impact(poisson=0.33, speed=0.01)
    >>> energy = stoss.quasistatic.compression_energy(force=impact.max_force, poisson=0.33)
    >>> round(energy / (0.5 * 0.01**2), 12)
    1.0
    """
    return _by_law(_core.compression_energy, law, poisson, "force", force)  # type: ignore[no-any-return]


def limit_force(*, poisson: ArrayLike, law: str = "center") -> Number:
    """Force s e^{−1−b} where δ(F) has its maximum and the law ends, πRE.

    The law means little from a tenth of this force on.

    Parameters
    ----------
    poisson, law
        As for `compression`.

    Returns
    -------
    float or ndarray

    Examples
    --------
    >>> round(stoss.quasistatic.limit_force(poisson=0.33), 4)
    0.2638
    """
    nu = numbers("poisson", poisson)
    return arranged(_core.limit_force(choice("law", law, LAWS), nu.ravel()), nu.shape)  # type: ignore[no-any-return]


def limit_speed(*, poisson: ArrayLike, law: str = "center") -> Number:
    """Highest speed of a slow impact, `limit_force`/√2, c.

    Parameters
    ----------
    poisson, law
        As for `compression`.

    Returns
    -------
    float or ndarray

    Examples
    --------
    >>> round(stoss.quasistatic.limit_speed(poisson=0.33), 4)
    0.1865
    """
    nu = numbers("poisson", poisson)
    return arranged(_core.limit_speed(choice("law", law, LAWS), nu.ravel()), nu.shape)  # type: ignore[no-any-return]
