"""The collision rule as a function, computed to its errors."""

from __future__ import annotations

from numpy.typing import ArrayLike

from stoss import _core
from stoss._arguments import boolean, choice, integer, number, numbers
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.bodies._bodies import Body
from stoss.bodies._encounter import choose_against, choose_body, encounter
from stoss.bodies._solid import own_units
from stoss.bodies._walls import Unbounded, Wall
from stoss.results._progress import waiting
from stoss.results._rule import CollisionRule
from stoss.results._si import warn_at


@documented
def collision_rule(
    body: Body | None = None,
    *,
    speed: ArrayLike,
    against: Wall | Body | Unbounded | str | None = None,
    poisson: float | None = None,
    ratio: ArrayLike | None = None,
    friction: float | None = None,
    error: float = 1e-3,
    tolerance: float = 2e-2,
    beyond: str = "error",
    threads: int = 0,
    progress: bool = False,
) -> CollisionRule:
    """Compute the whole collision rule with friction as a function, with errors that hold everywhere.

    For spheres and for equal disks it takes any friction. For other disks motion along the surface
    changes the restitution too, and the rule is for one friction.

    Parameters:
        speed (tuple of two float): Slowest and fastest speed of approach along the normal, 1e-8 to
            1, c (with a material: m/s).
        ratio (tuple of two float, optional): Smallest and largest radius of the second over that of
            the first, 1e-3 to 1e3, for mixtures of disks or spheres, as of `pair_table`.
        friction: Coefficient of Coulomb's law, up to 5, of disks that are not equal.
        error: Maximum error of ε_n, interpolation included, 1e-6 to 0.1.
        tolerance: Maximum error of s′ over |v_t| + |Ω₁|R₁ + |Ω₂|R₂ + μv_n, 1e-4 to 0.5. It bounds
            the speed: in larger contacts velocity and spin differ in their effect.
        beyond ({'error', 'clamp'}, optional): Beyond the range, refuse, or give the value at
            the nearest edge, with an infinite error.

    Examples:
        >>> ball = stoss.Sphere(poisson=0.3)
        >>> rule = stoss.collision_rule(ball, speed=(1e-3, 1e-2))
        >>> v, spin, *_ = rule.collide([0.005, 0.002, 0], [0, 0, 0], normal=[1, 0, 0], friction=0.3)
        >>> v.round(4).tolist(), spin.round(3).tolist()
        ([-0.005, 0.0012, 0.0], [0.0, 0.0, -0.002])
    """
    chosen = choose_body(body, poisson, rigid=True)
    met = choose_against(chosen, against)
    ranges = {"speed": numbers("speed", speed)}
    if ratio is not None:
        ranges["ratio"] = numbers("ratio", ratio)
    for name, ends in ranges.items():
        if ends.shape != (2,):
            raise InvalidInput.out_of_range(
                name, f"an array of shape {ends.shape}", "two numbers, smallest and largest"
            )
    outside = choice("beyond", beyond, ("error", "clamp"))
    rubbing = None if friction is None else number("friction", friction)
    limits, count = (number("error", error), number("tolerance", tolerance)), integer("threads", threads)
    pairs = dict(zip(ranges, (each.tolist() for each in own_units(chosen, "table", **ranges))))
    with waiting(boolean("progress", progress), "collision_rule"):
        made = _core.adaptive_rule(encounter(chosen, met), pairs["speed"], pairs.get("ratio"), *limits, rubbing, count)
    normal, along, alike = made.given()
    warn_at(chosen, met, pairs["speed"], 2)
    return CollisionRule(chosen, met, rubbing, outside, alike, *along, *normal)
