"""What a drop test would show: a ball of R = 5 mm on a block, and where its energy goes.

Run:     python examples/08_drop_test.py [FOLDER]        (default: out/)
Expect:  a table for five pairs of materials at three speeds each, drop_test.csv and drop_test.png.
         Some 10 s on one core.

    radiation  energy that waves carry away through the block        computed
    ringing    energy that the ball keeps as vibration               computed
    material   heat inside both, with the typical qualities of
               stoss.materials                                       computed, as far as Q is known
    yield      plastic flow, of what has a yield strength            a model
    adhesion   of smooth and clean surfaces, of what has a surface
               energy                                                a model

All are shares of ½mv², of one motion: together they are 1 − ε². Of ε there are three uncertainties:
the numerical error, the spread of the models, and what is not known of the constants.
A block is thick enough if the first wave needs longer than the contact to reach its other side and
come back. Air is left out: the fall from v²/2g and the rise lose another ¾ C_D (ρ_air/ρ) v²/(2gR).
"""

import argparse
import warnings
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

RADIUS = 5e-3  # m
PAIRS = [
    ("bearing steel", "glass", (0.01, 0.1, 1.0)),
    ("glass", "glass", (0.01, 0.1, 1.0)),
    ("bearing steel", "bearing steel", (0.01, 0.1, 1.0)),
    ("rubber", "structural steel", (0.1, 1.0, 5.0)),
    ("ice", "ice", (0.01, 0.1, 1.0)),
]
BETWEEN = (0.03, 0.3, 3.0)  # m/s, of the picture alone
CHANNELS = ("radiation", "ringing", "material", "yield", "adhesion")
COLUMNS = (
    "ball,block,speed_m_s,restitution,numerical,models,constants,restitution_without_models,lost_fraction,"
    f"{','.join(CHANNELS)},dominant,contact_time_s,block_m,sticking_m_s,yield_m_s"
)


def pressure_wave_speed(material: stoss.Material) -> float:
    nu = material.poisson
    return np.sqrt(material.young * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / material.density)


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    warnings.simplefilter("ignore", stoss.StossWarning)  # printed below the rows that they are about
    figure, axes = plt.subplots(figsize=(6, 4.2), layout="constrained")
    lines = [COLUMNS]
    names = "ball           block             m/s      eps  numerical   models  constants  1 - eps^2"
    print(names, *(f"{name:>9}" for name in CHANNELS), sep="  ")
    for one, other, speeds in PAIRS:
        ball = stoss.Sphere(radius=RADIUS, material=stoss.materials[one])
        block = stoss.HalfSpace(material=stoss.materials[other])
        drop = stoss.predict(ball, against=block, speed=speeds)
        shares = (drop.radiation, drop.ringing, drop.material, drop.yielding, drop.adhesion)
        begins = f"{drop.yield_speed:.4g}" if drop.yield_speed else "unknown"
        for k, speed in enumerate(speeds):
            thick = 0.5 * drop.contact_time[k] * pressure_wave_speed(block.material)
            uncertain = (drop.restitution_error[k], drop.by_models[k], drop.by_constants[k])
            lost = 1 - drop.restitution[k] ** 2
            print(f"{one:14} {other:14} {speed:6g}  {drop.restitution[k]:.5f}", end="  ")
            print("{:9.1e}  {:7.4f}  {:9.4f}".format(*uncertain), end="  ")
            print(f"{lost:9.3e}", *(f"{share[k]:9.2e}" for share in shares), sep="  ")
            numbers = (speed, drop.restitution[k], *uncertain, drop.restitution_without_models[k], lost)
            numbers += tuple(share[k] for share in shares)
            said = [f"{value:.9g}" for value in numbers] + [drop.dominant[k]]
            said += [f"{value:.9g}" for value in (drop.contact_time[k], thick, drop.sticking_speed)]
            lines.append(",".join([one, other, *said, begins]))
        for said in dict.fromkeys(each for row in drop.warnings for each in row):
            print(f"  {said}")
        more = stoss.predict(ball, against=block, speed=BETWEEN, tolerance=0.02)
        curve = sorted(zip((*drop.speed, *more.speed), 1 - np.concatenate([drop.restitution, more.restitution]) ** 2))
        axes.loglog(*np.transpose(curve), label=f"{one} on {other}")
    (folder / "drop_test.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    axes.set(xlabel="speed / (m/s)", ylabel="lost share of the energy 1 − ε²", title="balls of 5 mm radius")
    axes.set_ylim(top=2.0)
    axes.legend(ncol=2, fontsize="small", loc="upper left")
    figure.savefig(folder / "drop_test.png", dpi=150)
    print(f"written: {folder / 'drop_test.csv'}, {folder / 'drop_test.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
