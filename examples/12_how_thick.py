"""How thick is this glass? A ball that is dropped on a pane tells it by its rebound and its contact time.

Run:     python examples/12_how_thick.py [FOLDER]        (default: out/)
Expect:  ε and contact time of a steel ball of 5 mm radius at 1 m/s for panes of 2.5 to 20 mm, how well
         each of the two measures the thickness, and a pane whose thickness both find: how_thick.csv and
         how_thick.png. Ten seconds.

    ẇ = F/(8√(Dρh)),    D = Eh³/12(1 − ν²)

A thin pane gives way as a dashpot does, the faster the thinner it is: the ball stays in touch for longer and comes back
more slowly. On a thick one it is as on a block. The contact time, which an electric circuit through ball and a coating
measures, tells thin panes, ε thick ones. The pane must be wide: 24 cm from its rim no echo is back within any of these
contacts.
"""

import argparse
import warnings
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

RADIUS, SPEED = 5e-3, 1.0  # m, m/s: a fall of 5 cm
THICKNESS = np.array([2.5, 2.8, 3.2, 3.6, 4.0, 4.5, 5.0, 5.6, 6.5, 8.0, 10.0, 14.0, 20.0])  # mm
UNKNOWN = 4.7  # mm: computed too, in place of a measurement
ERROR, TIME_ERROR = 0.005, 0.3  # of a measured ε and of a contact time, µs


def drop(thickness: float) -> stoss.Restitution:
    ball = stoss.Sphere(radius=RADIUS, material=stoss.materials["bearing steel"], loss_time=0)
    pane = stoss.Plate(thickness=thickness * 1e-3, material=stoss.materials["glass"], loss_time=0)
    return stoss.restitution(ball, against=pane, speed=SPEED)


def thickness_of(value: float, values: np.ndarray) -> float:
    """The thickness with this value, mm, between those of the table, whose logarithms are joined by lines."""
    order = np.argsort(values)
    return np.exp(np.interp(value, values[order], np.log(THICKNESS[order])))


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    warnings.simplefilter("ignore", stoss.StossWarning)  # of small ε: this pane has no rim near
    drops = [drop(thickness) for thickness in THICKNESS]
    restitution = np.array([each.restitution for each in drops])
    time = np.array([each.contact_time_si * 1e6 for each in drops])
    # By how much a thickness is uncertain: the error of a measurement over the slope.
    by_restitution = ERROR / np.abs(np.gradient(restitution, THICKNESS))
    by_time = TIME_ERROR / np.abs(np.gradient(time, THICKNESS))
    print("glass/mm  restitution  contact/us   by restitution/mm     by time/mm")
    lines = ["thickness_mm,restitution,restitution_error,contact_time_us,error_by_restitution_mm,error_by_time_mm"]
    for k, each in enumerate(drops):
        row = (THICKNESS[k], restitution[k], time[k], by_restitution[k], by_time[k])
        print("{:8.1f}  {:11.5f}  {:10.2f}  {:18.2f}  {:13.2g}".format(*row))
        numbers = (THICKNESS[k], restitution[k], each.restitution_error, *row[2:])
        lines.append(",".join(f"{value:.9g}" for value in numbers))
    (folder / "how_thick.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")

    unknown = drop(UNKNOWN)
    measured = (unknown.restitution, unknown.contact_time_si * 1e6)
    found = [thickness_of(value, values) for value, values in zip(measured, (restitution, time))]
    print(f"a pane with restitution {measured[0]:.3f} and {measured[1]:.1f} us of contact:", end=" ")
    print(f"{found[0]:.2f} mm by the restitution, {found[1]:.2f} mm by the time; it has {UNKNOWN} mm")

    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8), layout="constrained")
    for axes, values, value, label in (
        (left, restitution, measured[0], "restitution ε"),
        (right, time, measured[1], "contact time / µs"),
    ):
        axes.plot(THICKNESS, values, "o-", color="#0072B2", markersize=4)
        axes.plot([THICKNESS[0], UNKNOWN, UNKNOWN], [value, value, values.min()], color="#D55E00", linestyle="--")
        axes.set(xscale="log", xlabel="thickness of the glass / mm", ylabel=label)
        axes.set_xticks((3, 5, 10, 20), labels=("3", "5", "10", "20"))
        axes.minorticks_off()
        axes.grid(alpha=0.3)
    figure.suptitle("A steel ball of 5 mm radius on glass at 1 m/s")
    figure.savefig(folder / "how_thick.png", dpi=150)
    print(f"written: {folder / 'how_thick.csv'}, {folder / 'how_thick.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
