"""A superball in a box: it flies, bounces off floor, walls and lid, and trades velocity for spin.

Run:     python examples/11_superball_in_a_box.py [FOLDER]        (default: out/)
Expect:  a table of the first bounces; superball.csv and superball.png, the path in the colour of its
         spin: thrown to the right under the lid, the ball comes back from it. Some seconds, nearly
         all for the rule.

The rule is that of a ball of rubber, without the losses of the material, on rigid walls, with μ = 1.
The ball touches a wall with s = v_t + ΩR and leaves with s′: friction changes v_t by 2/7 (s′ − s) and
ΩR by 5/7 (s′ − s). In flight gravity acts, and what vibrates dies down. The energy over mass,

    v²/2 + gz + (RΩ)²/5,

falls at each bounce, by what becomes vibration and what is rubbed away; it never grows.
"""

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import LinearSegmentedColormap

import stoss

RADIUS, FRICTION, GRAVITY = 0.025, 1.0, 9.81  # m, –, m/s²
WIDTH, HEIGHT = 1.0, 0.7  # of the box, m
START, THROW = (0.1, 0.5), (3.5, -3.0)  # of the centre, m and m/s; without spin
BOUNCES = 24
NORMALS = {"left": (-1, 0), "right": (1, 0), "floor": (0, -1), "lid": (0, 1)}  # from the ball to a wall


def next_touch(place: np.ndarray, velocity: np.ndarray) -> tuple[float, str]:
    """When the ball meets a side that it flies towards, and which."""
    (x, z), (u, w) = place, velocity
    floor = (w + np.sqrt(w**2 + 2 * GRAVITY * max(z - RADIUS, 0))) / GRAVITY
    times = {"floor": floor}
    if u != 0:
        times["left" if u < 0 else "right"] = ((RADIUS if u < 0 else WIDTH - RADIUS) - x) / u
    room = w**2 - 2 * GRAVITY * (HEIGHT - RADIUS - z)  # w² at the lid
    if w > 0 and room > 0:
        times["lid"] = (w - np.sqrt(room)) / GRAVITY
    side = min(times, key=lambda name: times[name])
    return max(times[side], 0.0), side


def energies(place: np.ndarray, velocity: np.ndarray, spin: float) -> tuple[float, float]:
    """Of flight and of rotation, over mass, J/kg."""
    return 0.5 * float(velocity @ velocity) + GRAVITY * (place[1] - RADIUS), (RADIUS * spin) ** 2 / 5


def main(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    ball = stoss.Sphere(radius=RADIUS, material=stoss.materials["rubber"], loss_time=0)
    rule = stoss.collision_rule(ball, speed=(0.05, 5), tolerance=0.1, beyond="clamp")
    place, velocity, spin, now = np.array(START), np.array(THROW), 0.0, 0.0
    first = sum(energies(place, velocity, spin))
    rows, paths = [], []
    for _ in range(BOUNCES):
        flight, side = next_touch(place, velocity)
        time = np.linspace(0, flight, 40)[:, np.newaxis]
        fall = np.array([0, -GRAVITY])
        paths.append((place + velocity * time + 0.5 * fall * time**2, spin))
        place, velocity, now = paths[-1][0][-1], velocity + fall * flight, now + flight
        normal = np.array(NORMALS[side])
        along = np.array([-normal[1], normal[0]])
        towards, before = velocity @ normal, velocity @ along + RADIUS * spin
        velocity, turning, *_ = rule.collide(velocity, spin, normal, friction=FRICTION)
        spin = float(turning)
        after = velocity @ along + RADIUS * spin
        flying, rotating = energies(place, velocity, spin)
        rows.append((now, side, towards, before, after, spin / (2 * np.pi), flying / first, rotating / first))

    print("bounce  side   v / (m/s)  s / (m/s)  s' / (m/s)  turns/s   energy   of it in spin")
    for k, (_, side, towards, before, after, turns, flying, rotating) in enumerate(rows[:12], 1):
        numbers = f"{towards:9.4f}  {before:9.4f}  {after:10.4f}  {turns:7.3f}  {flying + rotating:.5f}  {rotating:.5f}"
        print(f"{k:6}  {side:5}  {numbers}")
    print(f"left after {BOUNCES} bounces, {now:.2f} s: {sum(rows[-1][-2:]):.5f} of the energy")
    lines = ["time_s,side,speed_m_s,sliding_m_s,sliding_after_m_s,turns_1_s,flying,rotating"]
    lines += [",".join([f"{row[0]:.9g}", row[1], *(f"{value:.9g}" for value in row[2:])]) for row in rows]
    (folder / "superball.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")

    figure, axes = plt.subplots(figsize=(6.4, 4), layout="constrained")
    fastest = max(abs(spin) for _, spin in paths) / (2 * np.pi)
    colours = LinearSegmentedColormap.from_list("spin", ["#0072B2", "black", "#D55E00"])
    shown = LineCollection([path for path, _ in paths], cmap=colours, linewidths=1.2)
    shown.set(array=[spin / (2 * np.pi) for _, spin in paths], clim=(-fastest, fastest))
    figure.colorbar(axes.add_collection(shown), label="turns per second (+: anticlockwise)")
    axes.add_patch(plt.Rectangle((0, 0), WIDTH, HEIGHT, fill=False, linewidth=2))
    axes.add_patch(plt.Circle(START, RADIUS, color="0.6"))
    axes.set(xlabel="x / m", ylabel="z / m", xlim=(-0.02, WIDTH + 0.02), ylim=(-0.02, HEIGHT + 0.02), aspect="equal",
             title=f"{BOUNCES} bounces of a rubber ball, μ = {FRICTION:g}")  # fmt: skip
    figure.savefig(folder / "superball.png", dpi=150)
    print(f"written: {folder / 'superball.csv'}, {folder / 'superball.png'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default="out", help="for the files that it writes")
    main(parser.parse_args().folder)
