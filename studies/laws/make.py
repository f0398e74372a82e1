"""How near the force laws of particle codes come to elasticity: two balls of steel or glass, R = 5 mm."""

import sys

import stoss

# Slowest and fastest, m/s: two balls of bearing steel yield above 0.26 m/s.
BALLS = {"bearing steel": (0.01, 0.25), "glass": (0.01, 1.0)}
LAWS = ("linear", "tsuji", "viscoelastic", "hunt-crossley", "thornton", "walton", "table")
# Laws as programs integrate them, or as far as their constants are free.
OF_PROGRAMS = (("tsuji", "liggghts"), ("tsuji", "yade"))
FRICTION = 0.2
MISFITS = ("restitution", "contact_time", "tangential_restitution")


def row(material: str, law: str, program: str | None = None) -> str:
    """One line of the table: maximum and root mean square of each misfit, and the stiffness along the surface."""
    ball = stoss.Sphere(radius=5e-3, material=stoss.materials[material])
    fit = stoss.fit(ball, against="same", law=law, speed=BALLS[material], friction=FRICTION, program=program)
    values = [f"{value:.3g}" for name in MISFITS for value in fit.misfit.get(name, ())]
    missing = [""] * (2 * sum(name not in fit.misfit for name in MISFITS))
    if "contact_time" not in fit.misfit:
        values = values[:2] + ["", ""] + values[2:]
        missing = missing[2:]
    ratio = fit.constants.get("tangential_ratio")
    return ",".join([material, law, program or "", *values, *missing, "" if ratio is None else f"{ratio:.3g}"])


def main(path: str) -> None:
    names = ",".join(f"{name}_{each}" for name in MISFITS for each in ("maximum", "rms"))
    speeds = ", ".join(f"{ball} {slow:g} to {fast:g} m/s" for ball, (slow, fast) in BALLS.items())
    head = f"# Two equal balls, {speeds}, friction {FRICTION}: misfit of force laws; made by `make results`."
    rows = [row(ball, law) for ball in BALLS for law in LAWS]
    rows += [row(ball, law, program) for ball in BALLS for law, program in OF_PROGRAMS]
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join([head, f"ball,law,program,{names},tangential_ratio", *rows]) + "\n")


if __name__ == "__main__":
    main(sys.argv[1])
