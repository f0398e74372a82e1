"""Draws the waves that run away below a ball on a half-space of its material: wave.py PICTURE."""

import sys

import stoss


def main():
    hit = stoss.impact(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(), speed=0.1, cutoff=12)
    hit.wave().plot().figure.savefig(sys.argv[1], dpi=150)


if __name__ == "__main__":
    main()
