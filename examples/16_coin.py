"""A coin that a small ball strikes in the middle of its face, near its rim and on its edge: ε, and what rings.

Run:     python examples/16_coin.py [FOLDER]        (default: out/)
Expect:  for each place ε, the contact time, the mass that the ball meets, and the partials that take most, with
         their shares of the energy, which err by what the numbers of the file do; coin.png, the shares over
         the frequency. Some seconds.

    E_k = ½ φ_k² |∫ F(t) exp(iω_k t) dt|²

Where a mode has a node (φ_k = 0) it stays silent: struck in the middle, a coin rings in modes whose nodes are rings
alone, at 28 kHz and above; near the rim the lowest mode, with two lines of nodes across the face, takes most. There
the coin also turns away, as if it were a third as heavy. On its edge it is stiff: the lowest mode in its plane has
97 kHz, which the ball is too slow for. It is of steel, 25 mm wide and 2 mm thick, with a half-round rim;
examples/any_body/coin_*.json are made of coin.geo by finite elements.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

FILES = Path(__file__).resolve().parent / "any_body"
PLACES = {"0": "in the middle", "9": "9 mm from the middle", "edge": "on its edge"}
COLORS = ("#0072B2", "#D55E00", "#009E73")
SPEED = 0.1  # m/s
BALL = stoss.Sphere(radius=2e-3, material=stoss.materials["bearing steel"], loss_time=0)


def mass_at_point(body: stoss.ModalBody) -> float:
    lever = np.cross(body.rotation["point"], body.rotation["normal"])
    return 1 / (1 / body.mass + lever @ np.linalg.solve(body.rotation["inertia"], lever))


def shares(coin: stoss.ModalBody) -> np.ndarray:
    """What each partial takes of the energy before, in per cent; those above the cutoff nothing."""
    modes = stoss.impact(BALL, against=coin, speed=SPEED).mode_energies
    after = modes["after"][modes["body"] == 1]
    return 100 * np.pad(after, (0, len(coin.frequency) - len(after)))


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    figure, axes = plt.subplots(1, 3, figsize=(8.4, 3), sharey=True, layout="constrained")
    for axis, (name, where), color in zip(axes, PLACES.items(), COLORS):
        coin = stoss.ModalBody.read(FILES / f"coin_{name}.json")
        one = stoss.restitution(BALL, against=coin, speed=SPEED, tolerance=0.3)
        share, kilohertz = shares(coin), coin.frequency / 1e3
        error = np.sum([np.abs(shares(each) - share) for each in coin.off_by_errors()], axis=0)
        print(f"{where}: ε = {stoss.with_error(one.restitution, one.restitution_error)}, "
              f"contact {one.contact_time_si * 1e6:.1f} µs, mass {1e3 * mass_at_point(coin):.2f} g")  # fmt: skip
        for k in np.argsort(-share)[:2]:
            print(f"    {kilohertz[k]:6.1f} kHz takes {share[k]:.2f} ± {error[k]:.2f} %")
        axis.bar(kilohertz, share, 4, yerr=error, color=color, ecolor="black")
        axis.set(xlabel="partial / kHz", title=f"{where}\nε = {one.restitution:.4f}", xlim=(0, 200),
                 xticks=(0, 50, 100, 150))
        axis.set(yscale="log", ylim=(1e-3, 50))
    axes[0].set_ylabel("share of the energy / %")
    figure.savefig(folder / "coin.png", dpi=150)
    print(f"written: {folder / 'coin.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
