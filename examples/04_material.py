"""A real material in SI: a steel disk of 1 cm radius, as a thin plate and as a long cylinder.

Run:     python examples/04_material.py [FOLDER]        (default: out/)
Expect:  restitution, contact time in µs and force in N per mm of thickness for speeds from 1 cm/s
         to 1 m/s, in plane stress (plate) and plane strain (cylinder); steel.png and two CSV
         files. Two seconds.

    plate: c = √(E/ρ), ν        cylinder: c = √(E/ρ(1 − ν²)), ν/(1 − ν)

Only vibrations absorb energy here, so ε is an upper bound of the real one. The steel is that of
bearings: the cylinder yields where Hertz's pressure √(F'E/πR(1 − ν²)) is 1.8 times its yield
strength, at 2.7 m/s. Of structural steel, which yields at 235 MPa, it would at 0.06 m/s.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

SPEEDS = np.geomspace(0.01, 1.0, 37)  # m/s


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    figure.get_layout_engine().set(w_pad=0.1, h_pad=0.1)  # inches around the axes
    for plane, marker in (("stress", "o"), ("strain", "s")):
        disk = stoss.Disk(radius=0.01, material=stoss.materials["bearing steel"], loss_time=0, plane=plane)
        curve = stoss.restitution(disk, speed=SPEEDS)

        print(f"plane {plane}: c = {disk.scales.speed:.0f} m/s, 2-D Poisson's ratio {disk.poisson:.4f}")
        print("  speed m/s    restitution          contact time us   maximum force N/mm")
        for k in range(0, SPEEDS.size, 12):
            value = f"{curve.restitution[k]:.6f} ± {curve.restitution_error[k]:.6f}"
            time, force = curve.contact_time_si[k] * 1e6, curve.max_force_si[k] * 1e-3
            print(f"  {curve.speed_si[k]:9.4f}  {value}  {time:13.3f}  {force:17.3f}")

        curve.to_csv(folder / f"steel_plane_{plane}.csv")
        label, time_error = f"plane {plane}", curve.contact_time_error * disk.scales.time
        style = {"marker": marker, "markersize": 3, "linewidth": 1, "capsize": 2, "label": label}
        left.errorbar(curve.speed_si, curve.restitution, curve.restitution_error, **style)
        right.errorbar(curve.speed_si, curve.contact_time_si * 1e6, time_error * 1e6, **style)

    for ax, quantity in ((left, "restitution ε"), (right, "contact time / µs")):
        ax.set(xscale="log", xlabel="speed / (m/s)", ylabel=quantity)
        ax.grid(alpha=0.3)
        ax.legend()
    figure.suptitle("Steel disk, R = 1 cm, against a hard wall")
    figure.savefig(folder / "steel.png", dpi=150)
    print(f"written: {folder / 'steel.png'} and steel_plane_stress.csv, steel_plane_strain.csv")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
