"""Two steel disks of unequal size: ε against the ratio of their radii, and which absorbs more.

Run:     python examples/06_two_disks.py [FOLDER]        (default: out/)
Expect:  restitution and the loss to each disk for radii from 1 : 1 to 1 : 8 at 1 m/s; two_disks.png
         with the collision of a soft pair below. Three seconds.

    1 − ε² = lost energy / ½ μ v²,    μ = m₁m₂/(m₁ + m₂),    v = speed of approach

From a ratio of about 3 on, the contact is long for the small disk, which hardly rings, and short
for the large one, which absorbs the loss.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

SMALL, SPEED = 5e-3, 1.0  # m, m/s
RATIOS = np.array([1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0])


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    steel = stoss.materials["bearing steel"]
    small = stoss.Disk(radius=SMALL, material=steel, loss_time=0)
    pairs = [
        stoss.restitution(small, against=stoss.Disk(radius=SMALL * ratio, material=steel, loss_time=0), speed=SPEED)
        for ratio in RATIOS
    ]
    print("radii    restitution          lost to the small disk   to the large one")
    for ratio, pair in zip(RATIOS, pairs):
        value = f"{pair.restitution:.6f} ± {pair.restitution_error:.6f}"
        print(f"1 : {ratio:3.1f}  {value}  {pair.lost_to_first:15.6f}  {pair.lost_to_second:15.6f}")

    figure, (above, below) = plt.subplots(2, 1, figsize=(7, 7), layout="constrained")
    above.plot(RATIOS, [pair.lost_fraction for pair in pairs], "ko-", label="both, 1 − ε²")
    above.plot(RATIOS, [pair.lost_to_first for pair in pairs], "C0s--", label="small disk")
    above.plot(RATIOS, [pair.lost_to_second for pair in pairs], "C1^--", label="large disk")
    above.set(xlabel="ratio of the radii", ylabel="share of the energy", yscale="log")
    above.set_title(f"steel, R₁ = {SMALL * 1000:g} mm, {SPEED:g} m/s")
    above.legend()
    disk = stoss.Disk(poisson=0.33)
    hit = stoss.impact(disk, against=stoss.Disk(poisson=0.33, radius=2), speed=0.2, cutoff=12)
    stoss.plot.sequence(hit, below, count=4, columns=4)
    figure.savefig(folder / "two_disks.png", dpi=150)
    print(f"written: {folder / 'two_disks.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
