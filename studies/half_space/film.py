"""The film of README: a ball that meets a block of its own material, and the energy in both: film.py FILM.gif."""

import sys

import numpy as np
import stoss
from ball_on_block import ABOVE, BALL, BLOCK, DEPTH, HALF, SPEED, panel
from matplotlib import pyplot
from matplotlib.animation import FuncAnimation, PillowWriter

FIRST, LAST, FRAMES, PER_SECOND = -0.8, 12.0, 65, 13  # R/c; the last frame stays for a second


def main():
    time = np.linspace(FIRST, LAST, FRAMES)
    hit = stoss.impact(BALL, against=BLOCK, speed=SPEED, cutoff=16)
    waves = stoss.restitution(BALL, against=BLOCK, speed=SPEED).lost_to_second
    after = np.maximum(time, 0.0)
    wave = hit.wave(time=after, distance=np.linspace(0.0, 1.05 * HALF, 85), depth=np.linspace(0.0, DEPTH, 63))
    ball = hit.field(time=time)
    figure, axes = pyplot.subplots(figsize=(5.6, 3.5), dpi=100)
    figure.subplots_adjust(left=0.0, right=1.0, bottom=0.0, top=1.0)

    def draw(k):
        axes.clear()
        panel(axes, ball, wave, min(k, FRAMES - 1))
        t = time[min(k, FRAMES - 1)]
        words = "it falls" if t < 0 else "it pushes, and waves run off" if t < hit.contact_time else "it leaves, slower"
        axes.text(-HALF + 0.2, ABOVE - 0.6, words, fontsize=12)
        axes.text(HALF - 0.2, -DEPTH + 0.3, f"waves in the block: {waves:.0%} of the energy".replace("%", " %")
                  if t > hit.contact_time else "", fontsize=11, ha="right")  # fmt: skip

    film = FuncAnimation(figure, draw, frames=FRAMES + PER_SECOND)
    film.save(sys.argv[1], writer=PillowWriter(fps=PER_SECOND))


if __name__ == "__main__":
    main()
