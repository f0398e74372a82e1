"""The eigenmodes of a disk: spectrum, three shapes, and their share of the static compliance.

Run:     python examples/02_modes.py [FOLDER]        (default: out/)
Expect:  the six lowest frequencies; modes.png with the spectrum and the modes (2,0), (0,0) and
         (3,0); modes.csv with all 421 modes up to ω = 30 c/R. One second.

Every mode (n, l) has a frequency ω and the amplitudes C (radial) and S (tangential) at the edge.
Over all modes of one order n ≥ 2 they obey the sum rule of the static compliance,

    Σ_l C²/ω² = (2n − (1 − ν)) / (n² − 1).

The modes up to the cutoff carry 98 % of it for n = 2. A truncated sum would lose the rest; stoss
adds the rest exactly.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

POISSON, CUTOFF = 0.33, 30.0


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    modes = stoss.modes(poisson=POISSON, cutoff=CUTOFF)
    print(modes)

    print(" n  l  omega / (c/R)   C = u_r(R)   S = u_phi(R)")
    for k in np.argsort(modes.omega)[:6]:
        name = f"{modes.order[k]:2d} {modes.index[k]:2d}"
        print(f"{name}  {modes.omega[k]:13.6f}  {modes.radial[k]:11.6f}  {modes.tangential[k]:12.6f}")

    # The sum rule. What is missing falls like 1/cutoff.
    n = 2
    kept = modes.order == n
    summed = np.sum((modes.radial[kept] / modes.omega[kept]) ** 2)
    exact = (2 * n - (1 - POISSON)) / (n**2 - 1)
    tail = 2 * np.sqrt(1 - POISSON**2) / (np.pi * CUTOFF)
    print(f"compliance of order 2: {summed:.4f} from {kept.sum()} modes, {exact:.4f} from all")
    print(f"missing: {exact - summed:.4f}, expected about 2 sqrt(1 - nu^2)/(pi cutoff) = {tail:.4f}")

    modes.to_csv(folder / "modes.csv")
    plt.rcParams["font.size"] = 9
    layout = [["spectrum", "a"], ["spectrum", "b"], ["spectrum", "c"]]
    widths = {"width_ratios": [2, 1]}
    figure, axes = plt.subplot_mosaic(layout, figsize=(8, 8.5), gridspec_kw=widths, layout="constrained")
    figure.get_layout_engine().set(w_pad=0.1, h_pad=0.1)  # inches around the axes
    stoss.plot.spectrum(modes, axes["spectrum"])
    for place, order in zip("abc", (2, 0, 3)):
        stoss.plot.mode_shape(modes, axes[place], order=order, index=0, amplitude=0.15)
    figure.savefig(folder / "modes.png", dpi=150)
    print(f"written: {folder / 'modes.csv'}, {folder / 'modes.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
