"""Draws a ball that meets a block of its own material, at three instants: ball_on_block.py PICTURE.

The block is coloured by the speed at which it moves, the ball by the stress inside it. Deformations have their true
size.
"""

import sys

import numpy as np
import stoss
from matplotlib import pyplot
from matplotlib.colors import PowerNorm

BALL, BLOCK, SPEED = stoss.Sphere(poisson=0.3), stoss.HalfSpace(), 0.1  # c
TIMES = (2.0, 4.8, 11.0)  # R/c: on its way in, near the turn, just gone
HALF, DEPTH, ABOVE = 6.0, 4.6, 2.5  # of the picture, R
MOST_STRESS, MOST_SPEED = 0.12, 0.3  # where the colours end: E, and the speed of the impact


def both_sides(values, sign=1.0):
    """The picture is symmetric: both halves of it, from the half with distances from 0 up."""
    return np.concatenate((sign * values[..., :0:-1], values), axis=-1)


def panel(axes, ball, wave, k):
    across = both_sides(wave.distance + wave.lateral[k], -1.0)
    down = both_sides(wave.depth[:, None] + wave.normal[k])
    moves = both_sides(np.hypot(wave.lateral_velocity[k], wave.normal_velocity[k])) / SPEED
    block = axes.pcolormesh(
        across, -down, moves, cmap="magma_r", norm=PowerNorm(0.5, 0.0, MOST_SPEED),
        shading="gouraud", rasterized=True,
    )  # fmt: skip
    axes.plot(across[0], -down[0], color="black", linewidth=0.8)
    stressed = axes.pcolormesh(
        ball.y[k], -ball.x[k], ball.von_mises[k], cmap="viridis", vmin=0.0, vmax=MOST_STRESS, shading="gouraud",
        rasterized=True,
    )  # fmt: skip
    axes.plot(ball.y[k, -1], -ball.x[k, -1], color="black", linewidth=0.8)
    axes.set(xlim=(-HALF, HALF), ylim=(-DEPTH, ABOVE), aspect="equal")
    axes.set_axis_off()
    return block, stressed


def draw():
    hit = stoss.impact(BALL, against=BLOCK, speed=SPEED, cutoff=16)
    wave = hit.wave(time=TIMES, distance=np.linspace(0.0, 1.05 * HALF, 127), depth=np.linspace(0.0, DEPTH, 93))
    ball = hit.field(time=TIMES)
    figure, row = pyplot.subplots(1, len(TIMES), figsize=(8.4, 2.2), dpi=150)
    figure.subplots_adjust(left=0.01, right=0.99, bottom=0.24, top=1.0, wspace=0.03)
    for k, axes in enumerate(row):
        block, stressed = panel(axes, ball, wave, k)
        axes.text(-HALF, ABOVE - 0.9, f"t = {TIMES[k]:g} R/c", fontsize=8)
    stresses, speeds = (0.0, 0.04, 0.08, MOST_STRESS), (0.0, 0.02, 0.05, 0.1, 0.2, MOST_SPEED)
    for left, colors, ticks, label in (
        (0.06, stressed, stresses, "stress in the ball / E"),
        (0.56, block, speeds, "speed of the block / v"),
    ):
        place = figure.add_axes((left, 0.18, 0.38, 0.04))
        bar = figure.colorbar(colors, cax=place, orientation="horizontal", extend="max", ticks=ticks, format="{x:g}")
        bar.set_label(label, labelpad=1, fontsize=8)
        place.tick_params(labelsize=8)
    return figure


def main():
    draw().savefig(sys.argv[1])


if __name__ == "__main__":
    main()
