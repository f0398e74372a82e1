"""Oblique impact of slow round bodies with friction, and the statics of a contact that is pushed along the wall."""

from __future__ import annotations

import functools
from typing import NamedTuple

from numpy.typing import ArrayLike

from stoss import _core
from stoss._arguments import number
from stoss.quasistatic._compression import over
from stoss.results._quantities import Number


class MawImpact(NamedTuple):
    """What an oblique impact with friction leaves, a number or an array each.

    Attributes:
        psi2: ψ₂ = κs′/(μv), below 0 where the contact point returns: ε_t = −ψ₂/ψ₁.
        psi2_error: Of ψ₂.
        impulse: Impulse of friction over μ times the normal impulse.
        impulse_error: Error of the impulse.
        friction_loss: Energy that becomes heat, in ½mv²μ²/κ.
        sliding: Share of the contact time in which the whole contact slides as before.
        sticking: In which nothing slips.
        slipping: In which a ring at the edge slips.
        reversed: In which the whole contact slides back.
    """

    psi2: Number
    psi2_error: Number
    impulse: Number
    impulse_error: Number
    friction_loss: Number
    sliding: Number
    sticking: Number
    slipping: Number
    reversed: Number


def maw(*, psi1: ArrayLike, chi: ArrayLike, tolerance: float = 1e-4) -> MawImpact:
    """Oblique impact of round bodies, slow enough for Hertz' contact: ψ₂ of ψ₁ and χ alone.

    With the sliding speed s of the contact, the normal speed v of approach, friction μ and κ =
    `mindlin_ratio`, ψ = κs/(μv) and χ = ½κ(1 + mR²/I), 1.75κ of a sphere (N. Maw, J. R. Barber and
    J. N. Fawcett, Wear 38, 101, 1976). The coupling of both directions is neglected, which equal
    bodies do not have.

    Parameters:
        psi1 (array_like): ψ₁ before, −10⁶ to 10⁶.
        chi (array_like): χ, above 0 to 1000; broadcasts with `psi1`.
        tolerance (float, optional): Largest error, 10⁻⁸ to 0.1.

    Examples:
        >>> chi = 1.75 * stoss.quasistatic.mindlin_ratio(poisson=0.3)
        >>> stoss.quasistatic.maw(psi1=[0.5, 2.0, 6.0], chi=chi).psi2.round(3)
        array([ 0.048, -0.837,  0.235])
    """
    return MawImpact(*over(functools.partial(_core.maw, tolerance=number("tolerance", tolerance)), psi1=psi1, chi=chi))


def mindlin_ratio(*, poisson: ArrayLike) -> Number:
    """κ = 2(1 − ν)/(2 − ν), tangential over normal stiffness of a contact, at ν = −0.95 to 0.4999.

    κ is for one material, or with a rigid body. For two materials 1/κ is the mean of both, weighted with
    (1 − ν²)/E.

    Parameters:
        poisson (array_like): ν.

    Examples:
        >>> round(stoss.quasistatic.mindlin_ratio(poisson=0.3), 6)
        0.823529
    """
    return over(_core.mindlin_ratio, poisson=poisson)  # type: ignore[no-any-return]


def mindlin_force(*, displacement: ArrayLike) -> Number:
    """T/μN of a contact that is pushed along the wall under a constant force N.

    1 − (1 − δ/δ_max)^{3/2}, with the displacement δ of distant points and δ_max = μd/κ of the normal
    approach d, from where on the whole contact slides (Cattaneo 1938, Mindlin 1949).

    Parameters:
        displacement (array_like): δ/δ_max, any; the force has its sign.

    Examples:
        >>> stoss.quasistatic.mindlin_force(displacement=[0.19, 1.0, -2.0])
        array([ 0.271,  1.   , -1.   ])
    """
    return over(_core.mindlin_force, displacement=displacement)  # type: ignore[no-any-return]


def mindlin_displacement(*, tangential: ArrayLike) -> Number:
    """δ/δ_max of a force T/μN of −1 to 1, the inverse of `mindlin_force`.

    Parameters:
        tangential (array_like): T/μN.

    Examples:
        >>> round(stoss.quasistatic.mindlin_displacement(tangential=0.271), 6)
        0.19
    """
    return over(_core.mindlin_displacement, tangential=tangential)  # type: ignore[no-any-return]


def mindlin_stick_radius(*, tangential: ArrayLike) -> Number:
    """c/a, the radius of the circle that sticks under a force T/μN of −1 to 1.

    Parameters:
        tangential (array_like): T/μN.

    Examples:
        >>> round(stoss.quasistatic.mindlin_stick_radius(tangential=0.271), 6)
        0.9
    """
    return over(_core.mindlin_stick_radius, tangential=tangential)  # type: ignore[no-any-return]


def mindlin_traction(*, tangential: ArrayLike, distance: ArrayLike) -> Number:
    """Traction along the wall over μp₀, at the distance r/a from the axis, under a force T/μN.

    Parameters:
        tangential (array_like): T/μN, −1 to 1.
        distance (array_like): r/a, 0 or more; broadcasts with `tangential`.

    Examples:
        >>> stoss.quasistatic.mindlin_traction(tangential=0.271, distance=[0.0, 0.95, 1.0]).round(6)
        array([0.1    , 0.31225, 0.     ])
    """
    return over(_core.mindlin_traction, tangential=tangential, distance=distance)  # type: ignore[no-any-return]
