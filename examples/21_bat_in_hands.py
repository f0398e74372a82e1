"""A bat that is free, in hands and in a clamp: the ball does not know the difference.

Run:     python examples/21_bat_in_hands.py [FOLDER]        (default: out/)
Expect:  for three places on the barrel the speed of the ball, after over before, with errors, from a bat that nothing
         holds, one whose handle is on springs of 30 kN/m in all, as hands may be, and one whose handle is clamped;
         bat_in_hands.png. Some seconds.

The bending waves of the bat need longer to the handle and back than the ball stays. ε of a body that is held is the
speed of the ball, u'/u, as the body stays where it is; from a free one it is u'/u = (ε − r)/(1 + r) with r = m/m_p
(15_bat.py). The files examples/any_body/bat_hands_*.json and bat_clamped_*.json are of the same bat, with --spring and
with --clamp on its handle from 65 to 80 cm.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

FILES = Path(__file__).resolve().parent / "any_body"
PLACES = (30, 140, 250)  # mm from the end of the barrel
GRIPS = {"free": "", "in hands": "hands_", "clamped": "clamped_"}
SPEED = 5.0  # m/s
BALL = stoss.Sphere(radius=0.037, material=stoss.Material(young=1e8, poisson=0.3, density=683), loss_time=0)


def speed_back(bat: stoss.ModalBody) -> tuple[float, float, float]:
    """Of the ball, after over before, with its error, and the time of contact."""
    hit = stoss.restitution(BALL, against=bat, speed=SPEED, tolerance=0.1)
    ratio = 0.0
    if not bat.held:
        lever = np.cross(bat.rotation["point"], bat.rotation["normal"])
        mass = BALL.material.density * 4 / 3 * np.pi * BALL.radius**3
        ratio = mass * (1 / bat.mass + lever @ np.linalg.solve(bat.rotation["inertia"], lever))
    return (hit.restitution - ratio) / (1 + ratio), hit.restitution_error / (1 + ratio), hit.contact_time_si


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    figure, axes = plt.subplots(figsize=(7.2, 3.6), layout="constrained")
    print("place/mm  grip      ball's speed after/before   contact/ms")
    for shift, (grip, name) in enumerate(GRIPS.items()):
        found = [speed_back(stoss.ModalBody.read(FILES / f"bat_{name}{place}.json")) for place in PLACES]
        for place, (back, error, time) in zip(PLACES, found):
            print(f"{place:8d}  {grip:8s}  {back:13.4f} ± {error:.4f}   {1e3 * time:10.2f}")
        back, error, _ = np.array(found).T
        color = ("#0072B2", "#D55E00", "#009E73")[shift]
        axes.errorbar(np.array(PLACES) + 4 * (shift - 1), back, yerr=error, fmt="os^"[shift], color=color,
                      markersize=6, capsize=4, label=grip)  # fmt: skip
    axes.set(xlabel="distance from the end of the barrel / mm", ylabel="speed of the ball, after / before")
    axes.set_title(f"A ball meets a bat at {SPEED:g} m/s, held in three ways")
    axes.grid(alpha=0.3)
    axes.legend()
    figure.savefig(folder / "bat_in_hands.png", dpi=150)
    print(f"written: {folder / 'bat_in_hands.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
