"""A calibration sheet for acoustic sensors by ball drop: the force of each drop, and how the other face moves.

Run:     python examples/18_ball_drop_calibration.py [FOLDER]        (default: out/)
Expect:  for each ball and height the speed, peak force, contact time, impulse, corner frequency and first null of
         the force, whether something yields, and the greatest displacement of a sensor straight below, on the other
         face of a plate of 50 mm, with errors: ball_drop.csv, ball_drop.png, and the force and the motion of one
         drop as two columns for seismic codes, ball_drop_force.txt and ball_drop_below.txt. Some seconds.

A ball that is dropped is a known source: its force follows from elasticity, without a measurement (G. C. McLaskey and
S. D. Glaser, J. Nondestruct. Eval. 31, 157, 2012). A sensor is good where the spectrum of its signal follows that of
the computed motion: below the first null, at which the force has no power. Small balls reach higher frequencies and
push less. A drop that dents the plate or the ball is softer than computed; choose another.
"""

import argparse
import warnings
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

RUBY = stoss.Material(young=4.0e11, poisson=0.25, density=3980)
STEEL, GLASS = stoss.materials["bearing steel"], stoss.materials["glass"]
BALLS = {"ruby 1.0 mm": (0.5e-3, RUBY), "steel 1.5 mm": (0.75e-3, STEEL), "ruby 5.0 mm": (2.5e-3, RUBY)}  # diameters
HEIGHTS = (0.02, 0.2)  # m
PLATES = {"glass": GLASS, "steel": STEEL}
THICKNESS = 0.05  # m
COLORS = ("#0072B2", "#D55E00", "#009E73")


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    warnings.simplefilter("ignore", stoss.StossWarning)  # of yield: the sheet says so itself
    print("plate  ball          fall/m  speed/(m/s)                 peak/N  contact/us  impulse/(uN s)  corner/kHz"
          "  null/kHz  yields               moves/nm")  # fmt: skip
    lines = ["plate,ball,fall_m,speed_m_s,peak_force_N,peak_force_error_N,contact_time_s,impulse_N_s,corner_Hz,null_Hz,"
             "yields,displacement_m,displacement_error_m"]  # fmt: skip
    figure, (force, spectrum, motion) = plt.subplots(1, 3, figsize=(10, 3.4), layout="constrained")
    for plate, material in PLATES.items():
        for (name, (radius, of)), color in zip(BALLS.items(), COLORS):
            ball = stoss.Sphere(radius=radius, material=of, loss_time=0)
            block = stoss.Plate(thickness=THICKNESS, material=material, loss_time=0)
            for height in HEIGHTS:
                speed = float(np.sqrt(2 * 9.81 * height))
                hit = stoss.pulse(ball, speed=speed, against=block)
                below = hit.at(depth=THICKNESS)
                yields = getattr(hit, "beyond_yield", None)
                most = int(np.argmax(np.abs(below.normal_si)))
                moves, error = below.normal_si[most], below.normal_si_error[most]
                corner, null = (each / (2 * np.pi) for each in (hit.corner_frequency_si, hit.first_null_si))
                shown = "?" if yields is None else "yes" if yields else "no"
                peak = stoss.with_error(hit.peak_force_si, hit.peak_force_si_error)
                lasts, impulse = hit.contact_time_si, hit.impulse_si
                print(f"{plate:5s}  {name:12s}  {height:6.2f}  {speed:11.3f}  {peak:>21s}  {lasts * 1e6:10.2f}"
                      f"  {impulse * 1e6:14.3f}  {corner / 1e3:10.1f}  {null / 1e3:8.1f}  {shown:>6s}"
                      f"  {stoss.with_error(moves * 1e9, error * 1e9):>21s}")  # fmt: skip
                numbers = (height, speed, hit.peak_force_si, hit.peak_force_si_error, lasts, impulse, corner, null)
                lines.append(f"{plate},{name}," + ",".join(f"{each:.9g}" for each in numbers) +
                             f",{shown},{moves:.9g},{error:.9g}")  # fmt: skip
                if plate == "steel" and height == HEIGHTS[0]:
                    force.plot(hit.time_si * 1e6, hit.force_si, color=color, label=name)
                    kilohertz = hit.frequency_si[1:] / (2e3 * np.pi)
                    spectrum.loglog(kilohertz, hit.amplitude[1:] * impulse, color=color)
                    spectrum.plot(corner / 1e3, impulse / np.sqrt(2), "o", color=color, markersize=4)
                    label = f"at most {moves * 1e9:.2g} nm"
                    motion.plot(below.time_si * 1e6, below.normal_si / moves, color=color, label=label)
                    hit.write(folder / "ball_drop_force.txt")
                    below.write(folder / "ball_drop_below.txt")
    (folder / "ball_drop.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")

    force.set(xlabel="time / µs", ylabel="force / N", yscale="log", ylim=(0.1, None), xlim=(0, None))
    force.legend(frameon=False)
    spectrum.set(xlabel="frequency / kHz", ylabel="spectrum of the force / (N s)", xlim=(3, 3000), ylim=(1e-8, None))
    motion.set(xlabel="time / µs", ylabel="motion straight below / its maximum", xlim=(0, 60), ylim=(-0.1, 1.4))
    motion.legend(frameon=False, loc="upper right")
    for axes in (force, spectrum, motion):
        axes.grid(alpha=0.3)
    figure.suptitle(f"Balls that fall {HEIGHTS[0] * 100:.0f} cm on {THICKNESS * 1e3:.0f} mm of steel")
    figure.savefig(folder / "ball_drop.png", dpi=150)
    print(f"written: {folder / 'ball_drop.csv'}, {folder / 'ball_drop.png'}, two files of columns")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
