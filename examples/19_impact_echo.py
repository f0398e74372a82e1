"""Which ball for an impact-echo test? Its contact time sets the frequencies, and these the thinnest slab that is told.

Run:     python examples/19_impact_echo.py [FOLDER]        (default: out/)
Expect:  for steel balls of 5 to 20 mm diameter, dropped 0.2 m on concrete, the contact time, the frequency up
         to which they are of use, and the thinnest slab whose echo they show: impact_echo.csv; the spectrum of
         a sensor 5 cm from the ball on a slab of 0.2 m, beside the frequency of its thickness: impact_echo.png.
         Ten seconds.

    f = 0.96 c_p/(2h)

A slab that is hit rings in thickness at this frequency: waves between its faces pass a sensor beside the ball (M.
Sansalone and W. Streett, Impact-Echo, 1997; the factor of 0.96 is the minimum of the first symmetric branch of Lamb's
waves, and hardly depends on Poisson's ratio of concrete). A ball is of use up to where the spectrum of its force has
fallen to a tenth. A larger ball pushes harder, and is blind for thin slabs. Steel balls begin to crush concrete; the
force is then softer and the contact a little longer.
"""

import argparse
import warnings
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

CONCRETE = stoss.Material(young=3.0e10, poisson=0.2, density=2400)
DIAMETERS = (5e-3, 8e-3, 12.5e-3, 20e-3)  # m
FALL, SLAB, DISTANCE = 0.2, 0.2, 0.05  # m
SHARE = 0.1  # of the amplitude at low frequencies, down to which a ball is of use
COLORS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7")


def pressure_speed(material: stoss.Material) -> float:
    nu = material.poisson
    return float(np.sqrt(material.young * (1 - nu) / (material.density * (1 + nu) * (1 - 2 * nu))))


def useful(hit: stoss.Pulse) -> float:
    """Frequency up to which the ball excites, Hz."""
    first = int(np.argmax(hit.amplitude < SHARE))
    return float(hit.frequency_si[first] / (2 * np.pi))


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    warnings.simplefilter("ignore", stoss.StossWarning)
    slab, echo = stoss.Plate(thickness=SLAB, material=CONCRETE), 0.96 * pressure_speed(CONCRETE)
    print(f"c_p of concrete {pressure_speed(CONCRETE):.0f} m/s; a slab of {SLAB} m rings at {echo / (2 * SLAB):.0f} Hz")
    print("diameter/mm  peak/N  contact/us  useful to/kHz  thinnest slab/mm  echo seen/Hz")
    lines = ["diameter_m,peak_force_N,contact_time_s,useful_Hz,thinnest_m,echo_Hz"]
    figure, (force, spectrum) = plt.subplots(1, 2, figsize=(9, 3.8), layout="constrained")
    for diameter, color in zip(DIAMETERS, COLORS):
        ball = stoss.Sphere(radius=diameter / 2, material=stoss.materials["bearing steel"], loss_time=0)
        hit = stoss.pulse(ball, speed=float(np.sqrt(2 * 9.81 * FALL)), against=slab)
        seen = hit.at(DISTANCE, until=4e-3, points=2000)
        highest = useful(hit)
        # The velocity of the surface after the first waves along it, without their end: a window.
        late = seen.time_si > 2.5e-4
        signal = seen.normal_velocity_si[late] * np.hanning(np.count_nonzero(late))
        frequency = np.fft.rfftfreq(16 * signal.size, seen.time_si[1])
        size = np.abs(np.fft.rfft(signal, 16 * signal.size))
        near = (frequency > 5e3) & (frequency < 15e3)
        peak = float(frequency[near][np.argmax(size[near])])
        print(f"{diameter * 1e3:11.1f}  {hit.peak_force_si:6.0f}  {hit.contact_time_si * 1e6:10.1f}"
              f"  {highest / 1e3:13.1f}  {echo / (2 * highest) * 1e3:16.0f}  {peak:12.0f}")  # fmt: skip
        numbers = (diameter, hit.peak_force_si, hit.contact_time_si, highest, echo / (2 * highest), peak)
        lines.append(",".join(f"{each:.9g}" for each in numbers))
        label = f"{diameter * 1e3:g} mm"
        force.plot(hit.frequency_si / (2e3 * np.pi), hit.amplitude, color=color, label=label)
        spectrum.plot(frequency / 1e3, size / size[near].max(), color=color, label=label)
    (folder / "impact_echo.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")

    force.axhline(SHARE, color="0.5", linestyle="--", linewidth=0.8)
    force.axvline(echo / (2e3 * SLAB), color="black", linestyle=":", label="echo of the slab")
    force.set(xlabel="frequency / kHz", ylabel="spectrum of the force / impulse", xlim=(0, 60), ylim=(0, 1.02))
    spectrum.axvline(echo / (2e3 * SLAB), color="black", linestyle=":", label="0.96 $c_p/2h$")
    spectrum.set(xlabel="frequency / kHz", ylabel=f"velocity {DISTANCE * 100:.0f} cm from the ball / its peak",
                 xlim=(0, 25), ylim=(0, 1.1))  # fmt: skip
    for axes in (force, spectrum):
        axes.legend(frameon=False)
        axes.grid(alpha=0.3)
    figure.suptitle(f"Steel balls that fall {FALL} m on {SLAB} m of concrete")
    figure.savefig(folder / "impact_echo.png", dpi=150)
    print(f"written: {folder / 'impact_echo.csv'}, {folder / 'impact_echo.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
