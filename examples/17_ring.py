"""A steel ring that a ball strikes from outside: ε against the ring's thickness, and which partials sound.

Run:     python examples/17_ring.py [FOLDER]        (default: out/)
Expect:  for each thickness the mass of the ring, ε, the contact time, and the partials that take most, with their
         shares of the energy, which err by what the numbers of the file do; ring.png, 1 − ε² against the thickness
         and the shares over the frequency. Some seconds.

    E_k = ½ φ_k² |∫ F(t) exp(iω_k t) dt|²,    ω_n = n(n² − 1)/√(n² + 1) · √(EI/(ρA)) / R²   (a thin ring, n = 2, 3, …)

The partials of a ring bend it in its plane with 2n nodes; their frequencies rise with the thickness t (I/A = t²/12).
The ball leaves most in a ring of 4 mm. A thicker one is too stiff for it. A thinner one gives a part back: it is in
touch with the ball for most of a period of its lowest partial, and throws it. The rings are 60 mm wide outside and
10 mm high; examples/any_body/ring_*.json are made of ring.geo by finite elements.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

FILES = Path(__file__).resolve().parent / "any_body"
THICKNESSES = (3, 4, 6, 9)  # mm
SPEED = 0.1  # m/s
COLORS = {3: "#0072B2", 4: "#009E73", 9: "#D55E00"}  # of those whose partials are drawn
MARKERS = {3: "o", 4: "s", 9: "^"}
BALL = stoss.Sphere(radius=8e-3, material=stoss.materials["bearing steel"], loss_time=0)


def shares(ring: stoss.ModalBody) -> np.ndarray:
    """What each partial takes of the energy before, in per cent; those above the cutoff nothing."""
    modes = stoss.impact(BALL, against=ring, speed=SPEED).mode_energies
    after = modes["after"][modes["body"] == 1]
    return 100 * np.pad(after, (0, len(ring.frequency) - len(after)))


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    figure, (left, right) = plt.subplots(1, 2, figsize=(7.6, 3.2), layout="constrained")
    lost = []
    for thickness in THICKNESSES:
        ring = stoss.ModalBody.read(FILES / f"ring_{thickness}.json")
        one = stoss.restitution(BALL, against=ring, speed=SPEED, tolerance=0.1)
        lost.append((one.lost_fraction, one.lost_fraction_error))
        share, kilohertz = shares(ring), ring.frequency / 1e3
        error = np.sum([np.abs(shares(each) - share) for each in ring.off_by_errors()], axis=0)
        epsilon = stoss.with_error(one.restitution, one.restitution_error)
        print(f"{thickness} mm thick, {1e3 * ring.mass:.0f} g: ε = {epsilon}, contact {one.contact_time_si * 1e6:.0f} µs")
        for k in np.argsort(-share)[:4]:
            print(f"    {kilohertz[k]:6.2f} kHz takes {share[k]:.2f} ± {error[k]:.2f} %")
        if thickness in COLORS:
            right.plot(kilohertz, share, MARKERS[thickness], color=COLORS[thickness], label=f"{thickness} mm thick")
            right.vlines(kilohertz, 1e-3, share, color=COLORS[thickness], linewidth=1.2)
    value, bar = np.transpose(lost)
    left.errorbar(THICKNESSES, 100 * value, yerr=100 * bar, fmt="o", color="black", markersize=4, capsize=3)
    left.set(xlabel="thickness of the ring / mm", ylabel="energy lost, 1 − ε² / %", ylim=(0, None))
    right.set(xlabel="partial / kHz", ylabel="share of the energy / %", yscale="log", ylim=(1e-2, 100), xlim=(0, 60))
    right.legend()
    figure.suptitle(f"A ball of Ø {2e3 * BALL.radius:.0f} mm strikes a ring at {SPEED} m/s")
    figure.savefig(folder / "ring.png", dpi=150)
    print(f"written: {folder / 'ring.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
