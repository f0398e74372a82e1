"""Programs of rigid bodies: Simbody and Drake with the law of Hunt and Crossley; one ε; coefficients by the angle."""

from __future__ import annotations

from typing import Any

from stoss.laws._law import Spring
from stoss.laws._power import LinearHuntCrossley
from stoss.laws._program import PUSHES, Program, Wording, digits

# Simbody: the ContactMaterial of both bodies, whose second number is c of F = k δ^{3/2} (1 + (3/2) c δ̇). Of two bodies
# with the moduli E₁ and E₂ it takes E = (s E₁^{2/3})^{3/2} with s = E₂^{2/3}/(E₁^{2/3} + E₂^{2/3}), and c = s c₁ +
# (1 − s) c₂: with the same material on both E is 2^{−3/2} of that material's, and c its own. Friction brakes sliding
# and has no spring. Tried with version 3.7. Source: its class HuntCrossleyForce.


def _simbody_lines(law: Any) -> list[str]:
    numbers = (2.0**1.5 * law.modulus, law.hysteresis / 1.5, law.friction, law.friction, 0.0)
    return [f"SimTK::ContactMaterial material({', '.join(map(digits, numbers))});  // of both bodies"]


SIMBODY = Program({"hunt-crossley": Wording(_simbody_lines, PUSHES, None)}, comment="// ")


# Drake: the proximity properties of both geometries, for point contact: F = k δ (1 + d δ̇) with k = k₁k₂/(k₁ + k₂) and
# d = k₂/(k₁ + k₂) d₁ + k₁/(k₁ + k₂) d₂, so with the same properties on both k is half of theirs, and d theirs. In
# hydroelastic contact d is the same, and the stiffness follows from the pressure fields. Discrete plants take d by the
# approximations TAMSI, Similar and Lagged, not by SAP. Not tried here. Source: multibody/plant/contact_properties.h,
# geometry/proximity_properties.h.


def _drake_lines(law: Any) -> list[str]:
    friction = f"static_friction={digits(law.friction)}, dynamic_friction={digits(law.friction)}"
    return [
        "properties = ProximityProperties()  # of both geometries, with ContactModel.kPoint",
        f"AddContactMaterial(dissipation={digits(law.hysteresis)}, point_stiffness={digits(2.0 * law.stiffness)},",
        f"    friction=CoulombFriction({friction}), properties=properties)",
    ]


DRAKE = Program({"hunt-crossley": Wording(_drake_lines, PUSHES, None, LinearHuntCrossley)})


# One ε for all speeds. What approaches slower than the fitted range is left to rest where the program has a threshold.
# The friction of these programs can stop sliding, not reverse it: ε_t is not fitted. None was tried here.


def _gazebo_lines(law: Any) -> list[str]:
    """Gazebo Classic takes the smaller ε of two surfaces. Source: the specification of SDFormat, collision/surface."""
    mu = digits(law.friction)
    return [
        "<surface>",
        f"  <bounce><restitution_coefficient>{digits(law.e)}</restitution_coefficient>"
        f"<threshold>{digits(law.slowest)}</threshold></bounce>",
        f"  <friction><ode><mu>{mu}</mu><mu2>{mu}</mu2></ode></friction>",
        "</surface>",
    ]


def _physx_lines(law: Any) -> list[str]:
    """Source: PhysX' classes PxMaterial and PxSceneDesc."""
    mu, e, slowest = (f"{float(digits(value))!r}f" for value in (law.friction, law.e, law.slowest))
    return [
        f"physx::PxMaterial* material = physics->createMaterial({mu}, {mu}, {e});",
        "material->setRestitutionCombineMode(physx::PxCombineMode::eMAX);",
        f"sceneDesc.bounceThresholdVelocity = {slowest};",
    ]


def _isaac_lines(law: Any) -> list[str]:
    """Source: the schemas UsdPhysics and PhysxSchema."""
    return [
        'over "physicsScene" (',
        '    prepend apiSchemas = ["PhysxSceneAPI"]',
        ")",
        "{",
        f"    float physxScene:bounceThreshold = {digits(law.slowest)}",
        "}",
        'def Material "bounces" (',
        '    prepend apiSchemas = ["PhysicsMaterialAPI", "PhysxMaterialAPI"]',
        ")",
        "{",
        f"    float physics:restitution = {digits(law.e)}",
        f"    float physics:staticFriction = {digits(law.friction)}",
        f"    float physics:dynamicFriction = {digits(law.friction)}",
        '    uniform token physxMaterial:restitutionCombineMode = "max"',
        "}",
    ]


def _newton_lines(law: Any) -> list[str]:
    """Newton's solver XPBD bounces only if it is told to. Source: its classes ModelBuilder.ShapeConfig, SolverXPBD."""
    return [
        f"cfg = newton.ModelBuilder.ShapeConfig(restitution={digits(law.e)}, mu={digits(law.friction)})  # of all",
        "solver = newton.solvers.SolverXPBD(model, enable_restitution=True)",
    ]


def _one(write: Any) -> dict[str, Wording]:
    return {"walton": Wording(write, Spring(), None)}


GAZEBO = Program(_one(_gazebo_lines), comment="<!-- ", end=" -->")
PHYSX = Program(_one(_physx_lines), comment="// ")
ISAAC = Program(_one(_isaac_lines))
NEWTON = Program(_one(_newton_lines))


# Ansys Fluent: coefficients of the polynomials of the impact angle for `reflect` at a wall of the discrete phase, the
# lowest power first. Its tangential coefficient is that of the centre's velocity. Not tried here. Source: its user's
# guide, Discrete Phase Boundary Condition Types.


def _fluent_lines(law: Any) -> list[str]:
    return [f"normal  {' '.join(map(digits, law.normal))}", f"tangent {' '.join(map(digits, law.tangent))}"]


FLUENT = Program({"polynomial": Wording(_fluent_lines, Spring())}, balls=False)
