"""ε(v) as a function for event-driven simulations: with its error, and a gas that cools by it.

Run:     python examples/05_event_driven.py [FOLDER]        (default: out/)
Expect:  ε at a few speeds of approach, with errors that include the interpolation; the energy that
         a gas of 20 disks on a ring has left after 1000 collisions: with ε(v) 400 times as much as
         with ε held at its first value; event_driven.png. Three seconds.

    u₁′ = u₁ − ½ (1 + ε(v)) v,    u₂′ = u₂ + ½ (1 + ε(v)) v,    v = u₁ − u₂

Here v is the speed at which two equal disks approach each other. `restitution_function` computes ε
where the wave needs it, and its error includes the interpolation; below its range it follows the
law of slow impacts. In a callback such as REBOUND's sim.coefficient_of_restitution use
`lambda simulation, v: restitution(v)`: the sign of v does not matter. The example assumes that
disks stop ringing before they meet again, and ignores material damping (docs/reference/materials.md).
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss


def cool(restitution, collisions, speed, count=20, length=2.0):
    """Time in s and share of the energy left after each collision of equal disks on a ring.

    `length` is the free length of the ring, m.
    """
    random = np.random.default_rng(1)
    x, u = np.sort(random.uniform(0.0, length, count)), random.normal(size=count)
    u = (u - u.mean()) * speed / u.std()
    time, energy = np.zeros(collisions + 1), np.ones(collisions + 1)
    for k in range(collisions):
        gap, approach = np.append(x[1:], x[0] + length) - x, u - np.append(u[1:], u[0])
        wait = np.divide(np.maximum(gap, 0.0), approach, out=np.full(count, np.inf), where=approach > 0)
        i = int(wait.argmin())
        kick = 0.5 * (1 + restitution(approach[i])) * approach[i]
        x += u * wait[i]
        u[[i, (i + 1) % count]] += -kick, kick
        time[k + 1], energy[k + 1] = time[k] + wait[i], np.mean(u**2) / speed**2
    return time, energy


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    rubber = stoss.Disk(radius=0.01, material=stoss.materials["rubber"], loss_time=0)
    restitution = stoss.restitution_function(
        rubber, against="same", speed=(0.002, 30.0), error=1e-4, beyond="law"
    )
    print(restitution)
    for v in (0.005, 0.1, 2.0, 25.0):
        print(f"speed of approach {v:6.3f} m/s: eps = {restitution(v):.6f} ± {restitution.error(v):.6f}")

    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    figure.get_layout_engine().set(w_pad=0.1, h_pad=0.1)  # inches around the axes
    restitution.plot(left)
    v = np.geomspace(*restitution.range, 1000)[1:-1]
    inset = left.inset_axes([0.12, 0.16, 0.5, 0.38], xscale="log", title="error of ε / 10⁻⁵")
    inset.plot(v, restitution.error(v) / 1e-5, color="C3")
    inset.set_ylim(0)

    start = 5.0  # m/s, root mean square
    first = restitution(np.sqrt(2) * start)
    for law, name in ((restitution, "ε(v)"), (lambda v: first, f"ε = {first:.4f}")):
        time, energy = cool(law, 1000, start)
        print(f"gas with {name}: {energy[-1]:.3e} of the energy left after 1000 collisions, {time[-1]:.2f} s")
        right.loglog(time[1:], energy[1:], label=name)
    right.set(xlabel="time / s", ylabel="energy / initial energy")
    right.legend()
    figure.savefig(folder / "event_driven.png", dpi=150)
    print(f"written: {folder / 'event_driven.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
