"""A steel ball strikes the bar of a glockenspiel: ε of a body by its modes, and the note that it leaves.

Run:     python examples/13_bar.py [FOLDER]        (default: out/)
Expect:  a table of the partials; bar.json, the body as the command reads it too (--against @bar.json);
         bar.wav, its sound; bar.png, ε(v) and the sound. Some seconds.

A bar with free ends bends at the frequencies (with the shear and the rotation of its cross-sections)

    ω = (βL)² √(EI/ρA) / L² / √(1 + (βh)²/12 · (1 + E/κG)),   cosh βL cos βL = 1.

In the middle the odd modes do not move. Of the rest, `ModalBody` needs what the point moves in each,
φ = Y(0)/√m with ⟨Y²⟩ = 1, and the compliance of all of them: c₀ = Σ φ²/ω², to which cross-sections
add by shear. The correction of bending is half known, as its errors say; what the surface gives way
beyond that is in the error of c₀. So few modes give ε to some percent: finite elements give more.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

LENGTH, WIDTH, HEIGHT = 0.20, 0.03, 0.01  # m
SPEED, RADIUS = 0.5, 0.01  # of the ball, m/s and m
KEPT, ALL = 4, 400  # modes: to 30 kHz, below those across the bar; enough for c₀


def bar(steel: stoss.Material) -> stoss.ModalBody:
    """Struck in the middle of its upper face."""
    area, inertia = WIDTH * HEIGHT, WIDTH * HEIGHT**3 / 12
    mass = steel.density * area * LENGTH
    number = np.arange(ALL)
    half = (number + 0.75) * np.pi  # βL/2 of the even modes, tan x + tanh x = 0
    hyperbolic = 1 / np.cosh(np.minimum(half, 300))
    for _ in range(3):
        half -= (np.tan(half) + np.tanh(half)) / (1 / np.cos(half) ** 2 + hyperbolic**2)
    middle = 1 / np.cos(half) + 1 / np.cosh(np.minimum(half, 300))  # of Y = cos βx/cos(βL/2) + cosh βx/cosh(βL/2)
    displacement = middle / np.sqrt(mass)
    thin = (2 * half / LENGTH) ** 2 * np.sqrt(steel.young * inertia / (steel.density * area))
    shear = steel.young / (5 / 6 * steel.young / (2 * (1 + steel.poisson)))  # E/κG
    thick = np.sqrt(1 + (2 * half * HEIGHT / LENGTH) ** 2 / 12 * (1 + shear))
    frequency = thin / thick / (2 * np.pi)
    waves = displacement**2 / (thin**2) * (1 + (2 * half * HEIGHT / LENGTH) ** 2 / 12 * shear)
    long = 2 * half * HEIGHT / LENGTH < np.pi  # shorter ones do not bend as a beam
    surface = (1 - steel.poisson**2) / (np.pi * steel.young * HEIGHT)
    return stoss.ModalBody(
        name="bar", origin="bending of a thin bar with free ends", mass=mass, curvature=0.0,
        young=steel.young, poisson=steel.poisson, density=steel.density,
        compliance=float(np.sum(waves[long])), compliance_error=2 * surface, complete_to=30e3,
        frequency=frequency[:KEPT], frequency_error=0.1 * (thin / (2 * np.pi) - frequency)[:KEPT],
        displacement=displacement[:KEPT], displacement_error=0.02 * np.abs(displacement[:KEPT]),
    )  # fmt: skip


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    steel = stoss.materials["structural steel"]
    struck, ball = bar(steel), stoss.Sphere(radius=RADIUS, material=stoss.materials["bearing steel"], loss_time=0)
    struck.save(folder / "bar.json")
    curve = stoss.restitution(ball, against=struck, speed=np.geomspace(0.02, SPEED, 12), tolerance=0.1)  # beyond, it yields
    one = stoss.restitution(ball, against=struck, speed=SPEED, tolerance=0.1)
    print(f"ε at {SPEED} m/s: {stoss.with_error(one.restitution, one.restitution_error)}, "
          f"contact {one.contact_time_si * 1e6:.0f} µs")  # fmt: skip

    hit = stoss.impact(ball, against=struck, speed=SPEED)
    partials = hit.mode_energies[hit.mode_energies["body"] == 1]
    hertz = partials["omega"] * ball.scales.frequency / (2 * np.pi)
    print("partial / Hz   over the first   share of the energy")
    for frequency, share in zip(hertz, partials["after"]):
        print(f"{frequency:12.0f}   {frequency / hertz[0]:14.3f}   {share:.5f}")
    heard = hit.sound(of=1, duration=2.0, quality=1500)
    heard.save(folder / "bar.wav")

    figure, (left, right) = plt.subplots(1, 2, figsize=(7.2, 3), layout="constrained")
    curve.plot(left)
    shown = heard.time < 5e-3
    right.plot(1e3 * heard.time[shown], 1e3 * heard.samples[shown], color="black", linewidth=0.7)
    right.set(xlabel="time after the impact / ms", ylabel="struck point / (mm/s)", title=f"{hertz[0]:.0f} Hz and above")
    figure.savefig(folder / "bar.png", dpi=150)
    print(f"written: {', '.join(str(folder / name) for name in ('bar.json', 'bar.wav', 'bar.png'))}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
