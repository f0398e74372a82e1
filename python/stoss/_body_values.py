"""What all bodies do with the numbers that users give."""

from __future__ import annotations

from typing import Any

from stoss._arguments import brief, instance, number, refusal
from stoss._errors import InvalidInput
from stoss._material import Material


def size(name: str, value: Any, material: Any) -> float:
    """A size in SI, which has no default."""
    instance("material", material, (Material,))
    if value is None:
        raise InvalidInput(f"{name}: got none, allowed a number in SI (the body has a material)")
    return number(name, value)


def fill(body: Any, made: dict[str, float], material: Material | None, **given: Any) -> None:
    """Set numbers to what was given, or what is made of the material or usual; with a material never both."""
    for name, value in given.items():
        if value is None and name not in made:
            raise InvalidInput(f"{name}: got none, allowed a number, or a material instead")
        known = made[name] if value is None else number(name, value)
        if material is not None and known != made[name]:
            raise refusal(name, value, f"none with a material, which makes it {made[name]:.6g}")
        object.__setattr__(body, name, known)


def fill_loss_time(body: Any, given: Any, material: Material | None, rigid: bool = False) -> None:
    """Set the loss time of a body to what was given, or that of its material; a rigid one has none."""
    usual = 0.0 if material is None or rigid else material.loss_time or 0.0
    fill(body, {"loss_time": usual}, None, loss_time=given)
    if rigid and body.loss_time != 0.0:
        raise refusal("loss_time", given, "0 of a rigid body, which loses nothing")


def call(body: Any, ratios: tuple[str, ...], si: tuple[str, ...]) -> str:
    """The call that makes the body, without what is usual."""
    names = si if body.material is not None else ratios
    usual: dict[str, Any] = {"plane": "stress", "poisson": None, "loss_time": 0.0, "rigid": False}
    if body.material is not None and not getattr(body, "rigid", False):
        usual["loss_time"] = body.material.loss_time or 0.0
    if body.material is None:
        usual |= {name: 1.0 for name in ratios if name not in usual}
    values = {name: getattr(body, name) for name in names}
    said = ", ".join(f"{name}={brief(value)}" for name, value in values.items() if usual.get(name) != value)
    return f"{type(body).__name__}({said})"


def own_loss_time(body: Any, length: float) -> float:
    """The loss time of a body in units of its own."""
    return float(body.loss_time * (body.young / body.density) ** 0.5 / length)


def known_material(body: Any) -> Material:
    """The material of a body that has one."""
    material: Material | None = body.material
    if material is None:
        raise AttributeError(f"scales: {body!r} has no material (make it with material=stoss.Material(...))")
    return material
