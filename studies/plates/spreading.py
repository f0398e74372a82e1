"""Draws the waves that run away in a plate below a ball of its material, as thick as the ball: spreading.py PICTURE."""

import sys

import stoss
import stoss.plot


def main():
    hit = stoss.impact(stoss.Sphere(poisson=0.3), against=stoss.Plate(thickness=2), speed=0.1, cutoff=12)
    stoss.plot.wave(hit.wave(), columns=1).figure.savefig(sys.argv[1], dpi=220, bbox_inches="tight")


if __name__ == "__main__":
    main()
