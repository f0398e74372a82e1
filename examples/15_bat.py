"""The sweet spots of a bat: ε and the speed of the ball after it was hit, against the place.

Run:     python examples/15_bat.py [FOLDER]        (default: out/)
Expect:  for each place ε, the share of the energy that rings on in the bat, and the speed at which the ball
         comes back, with errors; where ε is best, and where the ball comes back fastest; bat.png. Some seconds.

    u′/u = (ε − r)/(1 + r),    r = m/m_p,    1/m_p = 1/M + (d × n)·I⁻¹(d × n)

A ball of mass m and speed u meets a bat at rest that nothing holds. At the place p the bat has the mass m_p, less
the farther (d) from its centre of mass, for it turns away. ε is best where the first modes have their nodes, for there
they take least; the ball comes back fastest nearer to the centre of mass. The bats are examples/any_body/bat_*.json,
one for each place, which finite elements made of bat.geo: wood that is as stiff in all directions. The ball, as large
and as heavy as one of baseball, is elastic all through and takes hardly any: ε is that of the bat.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

FILES = Path(__file__).resolve().parent / "any_body"
PLACES = (30, 100, 140, 170, 210, 250, 290)  # mm from the end of the barrel
SPEED = 5.0  # m/s
BALL = stoss.Sphere(radius=0.037, material=stoss.Material(young=1e8, poisson=0.3, density=683), loss_time=0)


def mass_at_point(bat: stoss.ModalBody) -> float:
    lever = np.cross(bat.rotation["point"], bat.rotation["normal"])
    return 1 / (1 / bat.mass + lever @ np.linalg.solve(bat.rotation["inertia"], lever))


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    mass = BALL.material.density * 4 / 3 * np.pi * BALL.radius**3
    rows = []
    print("place/mm  mass there/kg            ε        rings on/%      ball's speed after/before")
    for place in PLACES:
        bat = stoss.ModalBody.read(FILES / f"bat_{place}.json")
        hit = stoss.restitution(BALL, against=bat, speed=SPEED, tolerance=0.1)
        ratio = mass / mass_at_point(bat)
        back, error = (hit.restitution - ratio) / (1 + ratio), hit.restitution_error / (1 + ratio)
        ringing = 100 * hit.lost_to_second
        rows.append((place, hit.restitution, hit.restitution_error, back, error, ringing))
        print(f"{place:8d}  {mass / ratio:13.3f}  {hit.restitution:.4f} ± {hit.restitution_error:.4f}  "
              f"{ringing:10.2f}  {back:14.4f} ± {error:.4f}")  # fmt: skip
    place, restitution, error, back, back_error, _ = np.array(rows).T
    best, fastest = place[np.argmax(restitution)], place[np.argmax(back)]
    print(f"of these places ε is best at {best:.0f} mm, the ball comes back fastest at {fastest:.0f} mm")

    figure, (left, right) = plt.subplots(1, 2, figsize=(7.6, 3.2), layout="constrained")
    for axes, value, bar, label in (
        (left, restitution, error, "restitution ε"),
        (right, back, back_error, "speed of the ball, after / before"),
    ):
        axes.errorbar(place, value, yerr=bar, fmt="o", color="#0072B2", markersize=4, capsize=3)
        axes.set(xlabel="distance from the end of the barrel / mm", ylabel=label)
        axes.grid(alpha=0.3)
    for axes, there, name in ((left, best, "ε is best"), (right, fastest, "the ball is fastest")):
        axes.axvline(there, color="0.6", linewidth=0.8, zorder=0)
        axes.annotate(name, (there, axes.get_ylim()[0]), (4, 4), textcoords="offset points", color="0.4")
    figure.suptitle(f"A ball meets a bat at {SPEED:g} m/s")
    figure.savefig(folder / "bat.png", dpi=150)
    print(f"written: {folder / 'bat.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
