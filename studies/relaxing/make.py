"""Balls of materials that relax: make.py STOSS FOLDER writes the tables of docs/results/relaxing
(docs/understand/findings/relaxing.md)."""

import importlib.util
import json
import math
import subprocess
import sys
from pathlib import Path

import numpy as np
from commands import listed, run, write
from one_ball import BALLS, CONTACT, LAWS, impacts, power

HERE = Path(__file__).parent


def slow_loss(quality):
    """1 − ε² of a slow ball of constant Q."""
    spec = importlib.util.spec_from_file_location("constant_quality", HERE.parent / "loss/constant_quality.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.fitted(quality)


# How many terms

BAND = 5e-4, 50.0  # c/R
TERMS = (3, 5, 7, 10, 15)


def series(quality, count):
    """Terms of a material of constant Q, and by how much its 1/Q is off in the band at most: by least squares of E*,
    relative to E′ and E″, with times equally spaced on a logarithmic scale."""
    low, high = BAND
    omega, times = np.geomspace(low, high, 121), np.geomspace(1 / (2 * high), 2 / low, count)
    wanted = (1j * omega) ** power(quality)
    each = np.column_stack([1j * np.outer(omega, times) / (1 + 1j * np.outer(omega, times)), np.ones_like(omega)])
    matrix = np.vstack([each.real / wanted.real[:, None], each.imag / wanted.imag[:, None]])
    moduli = np.linalg.lstsq(matrix, np.ones(2 * omega.size), rcond=None)[0]
    assert (moduli > 0).all()
    made = each @ moduli
    return list(zip(moduli[:-1] / moduli.sum(), times)), np.abs(made.imag / made.real * quality - 1).max()


def of_terms(program, quality, count, speeds=(1e-6, 1e-3, 0.1)):
    terms, ripple = series(quality, count)
    words = "+".join(f"{share:.12g}:{time:.12g}" for share, time in terms)
    job = f"restitution --body sphere --poisson 0.3 --relaxation {words} --speed {listed(speeds)}"
    for row in run(program, f"{job} --tolerance 1e-4 --absolute 0"):
        yield {"quality": quality, "terms": count, "ripple": f"{ripple:.3g}", "speed[c]": row["speed"],
               "lost_fraction": f"{float(row['lost_fraction']):.7g}",
               "lost_fraction_error": f"{float(row['lost_fraction_error']):.1e}"}  # fmt: skip


# Rubber balls from their DMA

RUBBERS = {"happy": 1390.0, "unhappy": 1250.0}  # density, kg/m³
RADIUS, HEIGHTS = 0.0125, (0.1, 1.0)  # m
TEMPERATURES = (10, 20, 30, 40, 60)  # °C; measured at 20


def fitted(program, name, temperature=20):
    """What `stoss relaxation` makes of a table at a temperature."""
    words = [program, "relaxation", str(HERE / f"{name}.csv"), "--wlf", "8.86:101.6:20", "--temperature", str(temperature)]
    found = subprocess.run([*words, "--format", "json", "--quiet"], check=True, capture_output=True, text=True)
    return json.loads(found.stdout)


def modulus(found, hertz):
    """E* at frequencies."""
    s = 2j * math.pi * hertz
    parts = [each["share"] / (1 + s * each["time"]) for each in found["records"]]
    return found["young"] * (1 - sum(parts))


def of_rubber(program, name, temperature, heights=HEIGHTS):
    found = fitted(program, name, temperature)
    job = f"restitution --body sphere --poisson 0.49 --young {found['young']!r} --density {RUBBERS[name]} --radius "
    job += f"{RADIUS} --relaxation {found['relaxation']} --height {listed(heights)} --tolerance 3e-3"
    for height, row in zip(heights, run(program, job), strict=True):
        hertz = CONTACT / float(row["contact_time_si"])
        its = modulus(found, hertz)
        yield {"ball": name, "temperature[C]": temperature, "height[m]": height, "terms": len(found["records"]),
               "storage_misfit": f"{found['storage_misfit']:.3g}", "loss_misfit": f"{found['loss_misfit']:.3g}",
               "contact_time[s]": f"{float(row['contact_time_si']):.4g}", "frequency[Hz]": f"{hertz:.4g}",
               "storage[Pa]": f"{its.real:.4g}", "tan_delta": f"{its.imag / its.real:.4g}",
               "rebound": f"{float(row['restitution']) ** 2:.5f}",
               "rebound_of_constant_quality": f"{1 - slow_loss(its.real / its.imag):.4f}",
               "rebound_error": f"{float(row['lost_fraction_error']):.1e}"}  # fmt: skip


# Laminated glass

SHEET, FILM = "thickness=0.004,material=glass", "thickness={:g},material=PVB"
PLATES = {
    "one piece of glass": ["thickness=0.008,material=glass"],
    "0.38 mm of PVB between": [SHEET, FILM.format(3.8e-4), SHEET],
    "1.52 mm of PVB between": [SHEET, FILM.format(1.52e-3), SHEET],
    "0.38 mm of PVB on top": [FILM.format(3.8e-4), "thickness=0.008,material=glass"],
    "1.52 mm of PVB on top": [FILM.format(1.52e-3), "thickness=0.008,material=glass"],
}


def of_laminate(program, name, speed=0.2):
    """Of a plate whose layers lose as their materials do, and of the same without losses."""
    top, *below = PLATES[name]
    found = []
    for loss in ("", ",loss_time=0"):
        job = f"restitution --body sphere --material 'bearing steel' --radius 0.005 --speed {speed} --against plate,"
        found += run(program, job + "/".join([top + loss, *below]))
    lossy, elastic = found
    return {"plate": name, "restitution": f"{float(lossy['restitution']):.5f}",
            "restitution_error": f"{float(lossy['restitution_error']):.1e}",
            "lost_fraction": f"{float(lossy['lost_fraction']):.5g}", "dissipated": f"{float(lossy['dissipated']):.4g}",
            "contact_time[s]": f"{float(lossy['contact_time_si']):.4g}",
            "restitution_without_loss": f"{float(elastic['restitution']):.5f}"}  # fmt: skip


# What a drop test measures


def tangent_of_rebound(rebound):
    """tan δ of constant Q with which a slow ball rebounds to this share of its height: by halving."""
    low, high = 1e-3, 2.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if 1 - slow_loss(1 / middle) > rebound else (low, middle)
    return low


def of_drop(program, quality):
    job = f"restitution --body sphere --poisson 0.3 --quality {quality} --speed 1e-6 --tolerance 1e-4 --absolute 0"
    (row,) = run(program, job)
    loss, error = float(row["lost_fraction"]), float(row["lost_fraction_error"])
    return {"quality": quality, "restitution": f"{float(row['restitution']):.6f}", "lost_fraction": f"{loss:.7g}",
            "lost_fraction_error": f"{error:.1e}", "times_quality": f"{loss * quality:.4f}",
            "of_slow_limit": f"{slow_loss(quality) * quality:.4f}", "quality_by_3.54": f"{3.5443 / loss:.5g}",
            "quality_by_2.41": f"{2.4094 / loss:.5g}"}  # fmt: skip


# Where the energy goes

FLOOR = "half-space,material=glass"
DROPPED = ("bearing steel", "glass", "rubber", "POM")
SPEEDS = np.geomspace(0.01, 10, 13)
CHANNELS = ("ringing", "radiation", "material", "yield", "adhesion")


def of_channels(program, material, speeds=SPEEDS):
    job = f"predict --body sphere --material '{material}' --radius 0.005 --against {FLOOR} --speed {listed(speeds)}"
    for row in run(program, job):
        yield {"ball": material, "speed[m/s]": f"{float(row['speed']):.5g}",
               "restitution": f"{float(row['restitution']):.5f}",
               **{name: f"{float(row[name]):.4g}" for name in CHANNELS}, "dominant": row["dominant"]}  # fmt: skip


def main(program, folder):
    folder = Path(folder)
    folder.mkdir(exist_ok=True)
    write(folder, "laws", "Balls of three materials, R = 1 cm, at a rigid wall",
          (row for ball in BALLS for law in LAWS for row in impacts(program, ball, law)))  # fmt: skip
    write(folder, "terms", "Constant Q by so many terms: a sphere at a rigid wall, nu = 0.3",
          (row for quality in (10, 100) for count in TERMS for row in of_terms(program, quality, count)))  # fmt: skip
    write(folder, "rubber", "Rubber balls from studies/relaxing, R = 12.5 mm, at a rigid wall",
          (row for name in RUBBERS for each in TEMPERATURES for row in of_rubber(program, name, each)))  # fmt: skip
    write(folder, "laminate", "A ball of bearing steel, R = 5 mm, at 0.2 m/s on laminated glass",
          (of_laminate(program, name) for name in PLATES))  # fmt: skip
    write(folder, "drop", "Slow spheres of constant Q at a rigid wall, 1e-6 c, nu = 0.3",
          (of_drop(program, quality) for quality in (1000, 300, 100, 30, 10)))  # fmt: skip
    write(folder, "channels", "Balls of R = 5 mm on a block of glass",
          (row for material in DROPPED for row in of_channels(program, material)))  # fmt: skip


if __name__ == "__main__":
    main(*sys.argv[1:])
