"""Draws the waves that run away in a plate below a ball of its material, as thick as the ball: wave.py PICTURE."""

import sys

import stoss


def main():
    hit = stoss.impact(stoss.Sphere(poisson=0.3), against=stoss.Plate(thickness=2), speed=0.1, cutoff=12)
    hit.wave().plot().figure.savefig(sys.argv[1], dpi=150, bbox_inches="tight")


if __name__ == "__main__":
    main()
