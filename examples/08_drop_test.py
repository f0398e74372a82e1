"""What a drop test would show: a ball of 5 mm on a block, and where its energy goes.

Run:     python examples/08_drop_test.py [FOLDER]        (default: out/)
Expect:  a table for five pairs of materials at three speeds each, drop_test.csv and drop_test.png.
         Half a minute on one core.

    ringing    energy that an elastic ball keeps as vibration        lost_to_first
    radiation  energy that waves carry away through an elastic block lost_to_second
    material   heat inside both, with the typical qualities of stoss.materials; it reduces
               the other two                                         dissipated
    adhesion   (v_s/v)², with the sticking speed of smooth surfaces,
               v_s² = 14.18 (Γ⁵R⁴/E*²)^(1/3)/m               (Johnson, Kendall, Roberts; Thornton and Ning)
    air        drag of the fall from v²/2g and the rise, ¾ C_D (ρ_air/ρ) v²/(2gR)

All are shares of ½mv²: the first three are computed, the others estimated. A block is thick enough
if the first wave needs longer than the contact to reach its other side and come back.
"""

import sys
import warnings
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

RADIUS = 5e-3  # m
ADHESION = 0.1  # Γ, J/m²: smooth and clean surfaces; real ones touch at their asperities only
DRAG, AIR, GRAVITY = 0.45, 1.2, 9.81  # C_D at some 1000 of Reynolds, kg/m³, m/s²
PAIRS = [
    ("bearing steel", "glass", (0.01, 0.1, 1.0)),
    ("glass", "glass", (0.01, 0.1, 1.0)),
    ("bearing steel", "bearing steel", (0.01, 0.1, 1.0)),
    ("rubber", "steel", (0.1, 1.0, 5.0)),
    ("ice", "ice", (0.01, 0.1, 1.0)),
]
COLUMNS = (
    "ball,block,speed_m_s,speed_c,restitution,lost_fraction,lost_fraction_error,ringing,radiation,contact_time_s,"
    "block_m,adhesion,air,lossy_restitution,lossy_lost_fraction,material,sticking_m_s,yield_m_s"
)


def sticking_speed(ball: stoss.Sphere, block: stoss.HalfSpace) -> float:
    """The speed below which an elastic ball sticks to the block, m/s."""
    compliance = sum((1 - body.poisson**2) / body.young for body in (ball, block))
    mass = 4 / 3 * np.pi * ball.radius**3 * ball.density
    return np.sqrt(14.18 * np.cbrt(ADHESION**5 * ball.radius**4 * compliance**2) / mass)


def pressure_wave_speed(material: stoss.Material) -> float:
    nu = material.poisson
    return np.sqrt(material.young * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / material.density)


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    warnings.simplefilter("ignore", stoss.StossWarning)  # the table says where a ball or a block begins to yield
    figure, axes = plt.subplots(figsize=(6, 4.2), layout="constrained")
    lines = [COLUMNS]
    names = "ball           block             m/s      eps     1 - eps^2  radiation    ringing   material"
    print(f"{names}   adhesion        air")
    for one, other, speeds in PAIRS:
        ball = stoss.Sphere(radius=RADIUS, material=stoss.materials[one])
        block = stoss.HalfSpace(material=stoss.materials[other])
        elastic = stoss.Sphere(radius=RADIUS, material=ball.material, loss_time=0)
        bed = stoss.HalfSpace(material=block.material, loss_time=0)
        drop = stoss.restitution(elastic, against=bed, speed=speeds)
        lossy = stoss.restitution(ball, against=block, speed=speeds)
        sticking = sticking_speed(ball, block)
        begins = stoss.quasistatic.yield_speed(ball, against=block)
        for k, speed in enumerate(speeds):
            thick = 0.5 * drop.contact_time_si[k] * pressure_wave_speed(stoss.materials[other])
            adhesion = (sticking / speed) ** 2
            air = 0.75 * DRAG * AIR / ball.density * speed**2 / (2 * GRAVITY * RADIUS)
            print(f"{one:14} {other:14} {speed:6g}  {drop.restitution[k]:.5f}  {drop.lost_fraction[k]:.3e}", end="  ")
            shares = (drop.lost_to_first[k], lossy.dissipated[k], adhesion, air)
            print(f"{drop.lost_to_second[k]:.3e}", *(f"{share:.2e}" for share in shares), sep="  ")
            numbers = (speed, drop.speed[k], drop.restitution[k], drop.lost_fraction[k], drop.lost_fraction_error[k])
            numbers += (drop.lost_to_first[k], drop.lost_to_second[k], drop.contact_time_si[k], thick, adhesion, air)
            numbers += (lossy.restitution[k], lossy.lost_fraction[k], lossy.dissipated[k])
            said = [f"{value:.9g}" for value in (*numbers, sticking)] + [f"{begins:.4g}" if begins else "unknown"]
            lines.append(",".join([one, other, *said]))
        fine = stoss.restitution(ball, against=block, speed=np.geomspace(0.01, 5.0, 15))
        axes.loglog(fine.speed_si, fine.lost_fraction, label=f"{one} on {other}")
    (folder / "drop_test.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    axes.set(xlabel="speed / (m/s)", ylabel="lost share of the energy 1 − ε²", title="balls of 5 mm radius")
    axes.legend()
    figure.savefig(folder / "drop_test.png", dpi=150)
    print(f"written: {folder / 'drop_test.csv'}, {folder / 'drop_test.png'}")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "out"))
