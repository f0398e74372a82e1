"""Rows of balls: make.py STOSS FOLDER writes tables of docs/results/rows (docs/understand/findings/rows.md)."""

import json
import math
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

import hertz

sys.path.append(str(Path(__file__).parents[1] / "relaxing"))
from commands import run, write  # noqa: E402 (beside the other studies)

PAGE = "rows"


def row(program, job):
    """What the command prints of a row, and its warnings."""
    found = subprocess.run([program, "row", *shlex.split(job), "--format", "json"], check=False, capture_output=True, text=True)
    if found.returncode not in (0, 1):  # 1: a value misses its tolerance
        raise RuntimeError(found.stderr)
    return json.loads(found.stdout)["records"][0], found.stderr


def given(program, document, speeds, options=""):
    """The same of a document."""
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump({"format": "stoss row 1", **document}, file)
        file.flush()
        return row(program, f"--bodies {file.name} --speed={listed(speeds)} {options}")[0]


def listed(speeds):
    return ",".join(f"{each:.12g}" for each in speeds)


def velocities(its, speed):
    """Velocities after and their errors, over the speed before."""
    for value, error in zip(its["velocities_after"], its["velocities_after_error"], strict=True):
        yield f"{value / speed:.5f}", f"{error / speed:.1e}"


# Cradles of real materials

MATERIALS = ("bearing steel", "glass", "rubber", "bouncy rubber")
YIELD = 1.7e9  # Pa, of bearing steel


def of_cradle(program, material, count, speed, strength=0.0):
    job = f"--body sphere --material '{material}' --radius 0.01 --count {count} --speed {speed}"
    its, said = row(program, job + (f" --yield-strength {strength:g}" if strength else ""))
    for body, (value, error) in enumerate(velocities(its, speed)):
        yield {"material": material, "balls": count, "speed[m/s]": speed, "yield_strength[Pa]": f"{strength:g}",
               "body": body, "velocity": value, "velocity_error": error, "translation": f"{its['translation']:.6f}",
               "vibration": f"{its['vibration']:.2e}", "heat": f"{its['dissipated']:.2e}",
               "yielded": f"{its['yielded']:.3g}", "would_yield": str("yields above" in said).lower(),
               "converged": str(its["converged"]).lower()}  # fmt: skip


def cradles(program):
    for material in MATERIALS:
        for count in (3, 5):
            for speed in (0.1, 1):
                yield from of_cradle(program, material, count, speed)
                if material == "bearing steel":
                    yield from of_cradle(program, material, count, speed, YIELD)


# From Hertz's row to fast balls

SPEEDS = (1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 3e-3, 0.01, 0.02, 0.03, 0.05, 0.1, 0.15, 0.2)


def of_speed(program, count, speed):
    its, _ = row(program, f"--body sphere --poisson 0.3 --count {count} --speed {speed:g}")
    for body, (value, error) in enumerate(velocities(its, speed)):
        yield {"balls": count, "speed[c]": f"{speed:g}", "body": body, "velocity": value, "velocity_error": error,
               "translation": f"{its['translation']:.6f}"}  # fmt: skip


def slow(program):
    for count in (3, 5):
        for body, value in enumerate(hertz.chain([1.0] + [0.0] * (count - 1))):
            yield {"balls": count, "speed[c]": "0", "body": body, "velocity": f"{value:.6f}", "velocity_error": "0",
                   "translation": "1"}  # fmt: skip
        for speed in SPEEDS:
            yield from of_speed(program, count, speed)


# The wave in a row of point balls


def of_wave():
    """In mc²/R, 2R and R/c: m ẍ = k δ^{3/2} with k/m = (4/3) E* (R/2)^{1/2}/m, whose unit of time is that of balls of
    unit mass and stiffness over (k/m)^{1/2} R^{1/4}."""
    stiffness = 4 / 3 / (2 * (1 - 0.3**2)) * 0.5**0.5 / (4 / 3 * math.pi)
    speed, width = hertz.wave()
    yield {"over_sixth_root": f"{2 * speed * stiffness ** (1 / 3):.4f}", "width[balls]": f"{width:.4f}"}


# A small ball on a large one

RATIOS = (1.0, 1.5, 2.0, 3.0, 4.0)
GAPS = (1e-4, 1e-3, 0.01, 0.1)


def of_drop(program, ratio, speed, gap):
    balls = [{"kind": "sphere", "poisson": 0.3, "radius": radius} for radius in (1.0, ratio)]
    document = {"bodies": balls, "after": "wall", "gaps": [gap, 0.0]}
    its = given(program, document, [speed, speed])
    (small, error), (large, _) = velocities(its, speed)
    masses = [1.0, ratio**3]
    # Of the same material: E* is that of a ball and a wall at the wall, half of it between balls.
    stiffness = [0.5 * (ratio / (1 + ratio)) ** 0.5, ratio**0.5]
    point = hertz.chain([1.0, 1.0], masses=masses, stiffness=stiffness, wall=True, until=400.0) if gap == 0 else [0, 0]
    return {"ratio": ratio, "speed[c]": f"{speed:g}", "gap[R]": f"{gap:g}", "small": small, "large": large, "error": error,
            "textbook": f"{-(3 * masses[1] - 1) / (masses[1] + 1):.4f}", "hertz": f"{point[0]:.4f}" if gap == 0 else "",
            "vibration": f"{its['vibration']:.4f}", "converged": str(its["converged"]).lower()}  # fmt: skip


def drops(program):
    for speed in (1e-4, 0.01, 0.1):
        for ratio in RATIOS:
            yield of_drop(program, ratio, speed, 0.0)
        for gap in GAPS:
            yield of_drop(program, 4.0, speed, gap)


# What the ε of a pair gets wrong

CASES = {
    "3 balls": (1, 0, 0),
    "5 balls": (1, 0, 0, 0, 0),
    "2 on 2": (1, 1, 0, 0),
    "2 on a wall": (1, 1),
}
BALLS = (("elastic", 0.001, ""), ("elastic", 0.1, ""), ("Q = 10", 0.001, "--quality 10"), ("Q = 10", 0.1, "--quality 10"))


def of_rule(program, name, material, speed, loss):
    ball, wall = f"--body sphere --poisson 0.3 {loss}", name.endswith("wall")
    ratios = CASES[name]
    its, _ = row(program, f"{ball} --count {len(ratios)} --speed {listed(speed * each for each in ratios)}"
                 + (" --against wall" if wall else ""))  # fmt: skip
    of = {}
    for partner in ("same", "wall"):
        (its_pair,) = run(program, f"restitution {ball} --against {partner} --speed {speed:g}")
        of[partner] = float(its_pair["restitution"])
    rule = hertz.pairwise(ratios, lambda b: of["wall" if b + 1 == len(ratios) else "same"], wall=wall)
    stiffness = [0.5**1.5] * (len(ratios) - 1) + [1.0] if wall else None
    until = 200.0 if wall else None
    chain = hertz.chain(ratios, wall=wall, stiffness=stiffness, until=until)
    damped = hertz.chain(ratios, wall=wall, stiffness=stiffness, until=until, restitution=of["same"])
    for body, (value, error) in enumerate(velocities(its, speed)):
        yield {"row": name, "material": material, "speed[c]": f"{speed:g}", "restitution": f"{of['same']:.5f}",
               "body": body, "velocity": value, "velocity_error": error, "pairwise": f"{rule[body]:.5f}",
               "hertz": f"{chain[body]:.5f}", "hertz_with_dashpot": f"{damped[body]:.5f}"}  # fmt: skip


def main(program, folder):
    folder = Path(folder)
    folder.mkdir(exist_ok=True)
    write(folder, "cradles", "Cradles of balls, R = 1 cm, of which the first moves; velocities over its speed",
          cradles(program), PAGE)  # fmt: skip
    write(folder, "slow", "Rows of balls, nu = 0.3, of which the first moves; at 0 of point balls with Hertz's law",
          slow(program), PAGE)  # fmt: skip
    write(folder, "point_wave", "The wave in a row of point balls with Hertz's law, nu = 0.3", of_wave(), PAGE)
    write(folder, "drops", "A small ball on a large one of its material, both falling on a rigid wall, nu = 0.3",
          drops(program), PAGE)  # fmt: skip
    rows = (each for name in CASES for ball in BALLS for each in of_rule(program, name, *ball))
    write(folder, "pairwise", "Rows of balls, nu = 0.3, and rules for them; velocities over the speed before", rows, PAGE)


if __name__ == "__main__":
    main(*sys.argv[1:])
