"""The lines of fitted laws for other programs: every program has them, and their formulas give the law back."""

import re
from pathlib import Path

import numpy as np
import pytest
from glass_ball import BALL, RANGE, fitted

import stoss
from stoss import _core
from stoss.laws._names import LAWS, PROGRAMS


def lines_of(law, program):
    """What is written for a program of a law that is fitted once."""
    if program == "kratos":  # which knows no loss as small
        return fitted_by(law, program, quality=30).lines
    return PROGRAMS[program].laws[law].write(fitted(law).fitted)


def test_programs_are_those_of_the_core():
    laws = {name: tuple(of.laws) for name, of in PROGRAMS.items()}
    assert laws == {name: laws for name, (_, laws, _) in _core.fitted_programs().items()}
    assert list(LAWS) == _core.fitted_laws()


def test_the_pages_name_every_program():
    root = Path(__file__).parents[3] / "docs"
    laws, chooser = ((root / each).read_text(encoding="utf-8") for each in ("reference/laws.md", "howto/programs.md"))
    for name, (title, its, tried) in _core.fitted_programs().items():
        rows = [line.split("|") for line in laws.splitlines() if line.count("|") == 7]
        (row,) = (row for row in rows if f"`{name}`" in row[2])
        assert title.removeprefix("Altair ") in row[1] and all(f"`{law}`" in row[3] for law in its), name
        assert row[6].strip() == ("not tried" if tried == "never run" else tried.removeprefix("in tests, ")), name
        (line,) = (line for line in chooser.splitlines() if re.search(rf"(--program |or `){name}`", line))
        assert title in line and line.endswith("| never run |" if tried == "never run" else "| yes |"), name


@pytest.mark.parametrize("law, program", [(law, name) for name, of in PROGRAMS.items() for law in of.laws])
def test_every_program_has_lines(law, program):
    lines = lines_of(law, program)
    assert lines and all("nan" not in line for line in lines)


@pytest.mark.parametrize(
    "law, program, line",
    [("mujoco", "mujoco", 'condim="3" friction="0.2 0 0"'), ("linear", "chrono", "material->SetFriction(0.2);"),
     ("linear", "mercurydpm", "species->setSlidingFrictionCoefficient(0.2);"),
     ("linear", "mfix", "mew = 0.2"), ("tsuji", "lethe", "set friction coefficient particles = 0.2"),
     ("tsuji", "kratos", '"DYNAMIC_FRICTION": 0.2'), ("hunt-crossley", "simbody", ", 0.2, 0.2, 0);"),
     ("hunt-crossley", "drake", "CoulombFriction(static_friction=0.2, dynamic_friction=0.2)"),
     ("walton", "gazebo", "<mu>0.2</mu><mu2>0.2</mu2>"), ("walton", "physx", "createMaterial(0.2f, 0.2f, 0."),
     ("walton", "isaac", "physics:dynamicFriction = 0.2"), ("walton", "newton", ", mu=0.2)"),
     ("linear", "yade", "frictionAngle=0.1973955598"), ("linear", "lammps", " 0 0.2"),
     ("linear", "liggghts", "coefficientFriction peratomtypepair 1 0.2")],
)  # fmt: skip
def test_friction_is_in_the_lines(law, program, line):
    ball = stoss.Sphere(radius=5e-3, material=BALL.material, quality=30) if program == "kratos" else BALL
    fit = stoss.fit(ball, against="same", law=law, speed=RANGE, friction=0.2, program=program)
    assert line in "\n".join(fit.lines)


def test_constants_per_mass_are_those_of_the_force():
    """Chrono and MercuryDPM, which do not run here: their numbers in the formulas of their sources."""
    its, text, x, u = fitted("viscoelastic").fitted, "\n".join(lines_of("viscoelastic", "chrono")), 1e-6, 0.02
    kn, gn = (float(text.split(f"Set{name}(")[1].split(")")[0]) for name in ("Kn", "Gn"))
    force = its.pair.radius * np.sqrt(x) * (kn * x + its.pair.mass * gn * u)
    assert force == pytest.approx(its.stiffness * x**1.5 + its.damping * x**0.5 * u)
    its, text = fitted("tsuji").fitted, "\n".join(lines_of("tsuji", "mercurydpm"))
    names = "EffectiveElasticModulus", "Dissipation"
    modulus, alpha = (float(text.split(f"set{name}(")[1].split(")")[0]) for name in names)
    stiffness = 4 / 3 * modulus * np.sqrt(its.pair.radius * x)
    force = stiffness * x + alpha * np.sqrt(its.pair.mass * stiffness) * u
    assert force == pytest.approx(its.stiffness * x**1.5 + its.damping * x**0.25 * u)


@pytest.mark.long
def test_one_restitution_makes_the_dashpot_of_the_law():
    """MFIX, Lethe and Kratos, which do not run here: their constants by the formulas of their sources."""
    value = lambda text, name: float(text.split(name)[1].split()[0].rstrip(","))  # noqa: E731
    its, text = fitted_by("linear", "mfix"), "\n".join(fitted_by("linear", "mfix").lines)
    log = np.log(value(text, "des_en_input(1) ="))
    eta = 2 * np.sqrt(value(text, "kn =") * its.fitted.pair.mass) * abs(log) / np.hypot(np.pi, log)
    assert eta == pytest.approx(its.fitted.damping, rel=1e-6)
    its = fitted_by("tsuji", "lethe")
    log = np.log(value("\n".join(its.lines), "restitution coefficient particles ="))
    prefactor = -2 * np.sqrt(5 / 6) * log / np.hypot(np.pi, log)  # times √(3/2 k δ^{1/2} m)
    assert prefactor * np.sqrt(1.5) == pytest.approx(its.fitted.alpha, rel=1e-6)
    its = fitted_by("tsuji", "kratos", quality=30)
    e = value("\n".join(its.lines), '"COEFFICIENT_OF_RESTITUTION":')
    powers = (-6.918798, -16.41105, 146.8049, -796.4559, 2928.711, -7206.864, 11494.29, -11342.18, 6276.757, -1489.915)
    exponent = sum(h * e**k for k, h in enumerate(powers, 1))
    gamma = np.sqrt(1 / (1 - (1 + e) ** 2 * np.exp(exponent)) - 1)
    assert np.sqrt(6) * gamma == pytest.approx(its.fitted.alpha, rel=1e-6)
    with pytest.raises(stoss.InvalidInput, match="alpha: got .*, allowed 0.01147 to .* Kratos"):
        fitted_by("tsuji", "kratos")
    for name in ("kratos", "lethe"):
        its = fitted_by("tsuji", name, quality=30)
        young, nu = (value("\n".join(its.lines), word) for word in (
            ('"YOUNG_MODULUS":', '"POISSON_RATIO":') if name == "kratos"
            else ("young modulus particles =", "poisson ratio particles =")))  # fmt: skip
        assert young / (2 * (1 - nu**2)) == pytest.approx(its.fitted.modulus, rel=1e-6)


def fitted_by(law, program, **of_glass):
    ball = stoss.Sphere(radius=5e-3, material=stoss.materials["glass"], **of_glass)
    return stoss.fit(ball, against="same", law=law, speed=RANGE, program=program)


def test_drake_and_simbody_combine_to_the_law():
    """By the rules of their sources, of two bodies with the same numbers."""
    its, x, u = fitted_by("hunt-crossley", "drake"), 1e-6, 0.02
    d, k = (float(each) for each in re.findall(r"=([0-9.e+-]+)", " ".join(its.lines))[:2])
    its = its.fitted
    assert k * k / (k + k) * x * (1 + d * u) == pytest.approx(its.stiffness * x + its.damping * x * u)
    its = fitted("hunt-crossley").fitted
    (line,) = lines_of("hunt-crossley", "simbody")
    young, c = (float(each) for each in line.split("(")[1].split(",")[:2])
    force = 4 / 3 * np.sqrt(its.pair.radius) * (0.5 * young ** (2 / 3)) ** 1.5 * x**1.5 * (1 + 1.5 * c * u)
    assert force == pytest.approx(its.stiffness * x**1.5 * (1 + its.hysteresis * u))
    # ε depends on λv alone, whatever the spring.
    drake = fitted_by("hunt-crossley", "drake").fitted
    assert drake.hysteresis == pytest.approx(its.hysteresis, rel=1e-3)


def test_polynomials_of_the_angle():
    """Of a ball that loses much: least squares of what is computed at the fastest speed, and of sliding throughout."""
    ball = stoss.Sphere(radius=5e-3, material=stoss.materials["rubber"])
    fit = stoss.fit(ball, law="polynomial", speed=(0.01, 1), friction=0.3, program="fluent")
    normal, tangent = (np.array(line.split()[1:], dtype=float) for line in fit.lines)
    angle = np.degrees(np.arcsin(fit.speed / 1.0))
    assert np.polynomial.Polynomial(normal)(angle) == pytest.approx(fit.law_restitution)
    assert np.abs(fit.law_restitution - fit.restitution)[fit.speed > 0.1].max() < 5e-3
    # At 10° it slides throughout: the velocity along the wall loses μ (1 + ε) tan θ.
    theta = np.radians(10)
    epsilon = np.interp(np.sin(theta), fit.speed, fit.restitution)
    kept = np.polynomial.Polynomial(tangent)(10.0)
    assert kept == pytest.approx(1 - 0.3 * (1 + epsilon) * np.tan(theta), abs=0.05)
    # ε_t and what the velocity along the wall keeps are the same number.
    along = fit.law_tangential_restitution[-1]
    degrees = np.degrees(np.arctan(1 / (0.3 * fit.sliding)))
    assert 1 - 2 / 7 * (1 + along) == pytest.approx(np.polynomial.Polynomial(tangent)(degrees))
    with pytest.raises(stoss.InvalidInput, match="against: got .*allowed a stoss.HalfSpace or a rigid wall for fluent"):
        stoss.fit(ball, against="same", law="polynomial", speed=(0.01, 1), program="fluent")
