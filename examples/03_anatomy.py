"""Anatomy of one collision: the motion of the disk, the force of the wall, and where the energy goes.

Run:     python examples/03_anatomy.py [FOLDER]        (default: out/)
Expect:  the energy ledger of an impact at a tenth of the bar speed, where the mode (2,0) absorbs
         the largest part of the loss; anatomy.png with the disk at six times, force, velocity,
         energies and contact width against time, the energies of the modes, and the stress
         half-way; anatomy.csv, the trajectory. Two or three seconds.

The force drops when the pressure wave of the first contact comes back from the far side of the
disk, after the time 4R/c_p with c_p = c/√(1 − ν²). The half-width is a staircase, because the
contact grows and shrinks by whole nodes of its grid.

    m dv/dt = −F,    ½ m v² + energy of the modes + energy absorbed by the tail = constant
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    hit = stoss.impact(poisson=0.33, speed=0.1)
    path = hit.trajectory()
    field = hit.field(time=hit.contact_time / 2)
    echo = 4.0 * np.sqrt(1.0 - hit.body.poisson**2)  # R/c

    impulse = np.sum(0.5 * (path.force[1:] + path.force[:-1]) * np.diff(path.time))
    print(hit)
    print(f"maximum force        {hit.max_force:.5f} pi R E")
    print(f"maximum compression  {hit.max_compression:.5f} R")
    print(f"pressure wave back at {echo:.4f} R/c")
    print(f"impulse / (m v)       {impulse / hit.speed:.5f} = 1 + eps = {1 + hit.restitution:.5f}")
    print("energy after the impact, shares of the initial energy:")
    for name in ("translation", "vibration", "unresolved", "energy_error"):
        print(f"  {name:12s} {getattr(hit, name):9.6f}")
    strongest = np.argsort(hit.mode_energies["after"])[::-1][:4]
    for n, l, omega, after in hit.mode_energies[strongest][["order", "index", "omega", "after"]]:
        print(f"  mode ({n},{l})   {after:9.6f}   omega = {omega:.4f} c/R")
    print(f"maximum von Mises stress at half time {field.von_mises.max():.3f} E")

    path.to_csv(folder / "anatomy.csv")
    plt.rcParams.update({"font.size": 8, "axes.titlesize": 8, "legend.fontsize": 6.5, "legend.columnspacing": 1.0})
    layout = [["sequence"] * 3, ["force", "velocity", "energies"], ["half_width", "ledger", "stress"]]
    heights = {"height_ratios": [0.8, 1, 1]}
    figure, axes = plt.subplot_mosaic(layout, figsize=(11.5, 8.4), gridspec_kw=heights, layout="constrained")
    figure.get_layout_engine().set(w_pad=0.1, h_pad=0.1, rect=(0.01, 0.0, 0.98, 1.0))
    stoss.plot.sequence(hit, axes["sequence"], count=6, columns=6)
    for name in ("force", "velocity", "energies", "half_width"):
        getattr(stoss.plot, name)(path, axes[name])
    axes["force"].axvline(echo, color="0.5", linewidth=0.8, linestyle=":")
    axes["force"].set_title("dotted: the pressure wave is back from the far side")
    axes["half_width"].set_title("steps: one node of the contact grid each")
    stoss.plot.ledger(hit, axes["ledger"])
    stoss.plot.stress(field, axes["stress"])
    figure.savefig(folder / "anatomy.png", dpi=150)
    print(f"written: {folder / 'anatomy.csv'}, {folder / 'anatomy.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
