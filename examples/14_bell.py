"""A bell and its clapper: which partials sound after the blow of a small one and of a large one.

Run:     python examples/14_bell.py [FOLDER]        (default: out/)
Expect:  ε and the contact time of both, and the share of the energy that each partial takes, with errors;
         bell.png, these shares over the frequency; bell_small.wav and bell_large.wav, the sound. Some seconds.

    E_k = ½ φ_k² |∫ F(t) exp(iω_k t) dt|²

A partial takes energy as far as the force F changes within its period: a large clapper stays in touch for longer
and leaves the high ones silent. The bell, of bronze, 80 mm high, is examples/any_body/bell.json, which finite
elements made of bell.geo. A steel ball strikes it from outside at the sound bow. Partials come in pairs, turned
around the axis against each other; the ball drives one of each, and the file has that. The error of a share sums its
changes with a quarter of the modes left out and with the compliance, frequencies and displacements off by their errors.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

BELL = Path(__file__).resolve().parent / "any_body" / "bell.json"
SPEED = 0.1  # m/s
CLAPPERS = {"small": 8e-3, "large": 25e-3}  # their radii, m
LEAST = 1e-3  # of the energy: partials that are shown take more from one of both


def shares(ball: stoss.Sphere, bell: stoss.ModalBody, cutoff: float | None = None) -> tuple[stoss.Impact, np.ndarray]:
    """The impact, and for each partial its share of the energy before; those above the cutoff have none."""
    hit = stoss.impact(ball, against=bell, speed=SPEED, cutoff=cutoff)
    after = hit.mode_energies["after"][hit.mode_energies["body"] == 1]
    return hit, np.pad(after, (0, len(bell.frequency) - len(after)))


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    bell = stoss.ModalBody.read(BELL)
    found, errors = {}, {}
    for name, radius in CLAPPERS.items():
        ball = stoss.Sphere(radius=radius, material=stoss.materials["bearing steel"], loss_time=0)
        one = stoss.restitution(ball, against=bell, speed=SPEED, tolerance=0.3)
        hit, found[name] = shares(ball, bell)
        others = [shares(ball, each)[1] for each in bell.off_by_errors()] + [shares(ball, bell, 0.75 * hit.cutoff)[1]]
        errors[name] = np.sum([np.abs(each - found[name]) for each in others], axis=0)
        print(f"{name} clapper, {2e3 * radius:.0f} mm: ε = {stoss.with_error(one.restitution, one.restitution_error)}, "
              f"contact {one.contact_time_si * 1e6:.0f} µs")  # fmt: skip
        hit.sound(of=1, duration=3.0, quality=3000).save(folder / f"bell_{name}.wav")

    print("partial / Hz    share of the energy / %: small clapper, large clapper")
    shown = np.flatnonzero(np.maximum(*found.values()) > LEAST)
    for k in shown:
        cells = [f"{100 * found[name][k]:8.3f} ± {100 * errors[name][k]:5.3f}" for name in CLAPPERS]
        print(f"{bell.frequency[k]:7.0f} ± {bell.frequency_error[k]:3.0f}   {'   '.join(cells)}")

    figure, axes = plt.subplots(figsize=(7.2, 3.2), layout="constrained")
    place = np.arange(len(shown))
    for shift, (name, color) in enumerate(zip(CLAPPERS, ("#0072B2", "#D55E00"))):
        label = f"{name} clapper, Ø {2e3 * CLAPPERS[name]:.0f} mm"
        bars = 100 * found[name][shown], 100 * errors[name][shown]
        axes.bar(place + 0.4 * shift - 0.2, bars[0], 0.4, yerr=bars[1], color=color, ecolor="black", label=label)
    axes.set_xticks(place, labels=[f"{bell.frequency[k] / 1e3:.2f}" for k in shown])
    axes.set(xlabel="partial / kHz", ylabel="share of the energy / %", title=f"A bell struck at {SPEED} m/s")
    axes.set_yscale("log")
    axes.legend()
    figure.savefig(folder / "bell.png", dpi=150)
    print(f"written: {folder / 'bell.png'}, {folder / 'bell_small.wav'}, {folder / 'bell_large.wav'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
