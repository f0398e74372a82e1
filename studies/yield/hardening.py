"""Table of indentation with linear hardening: hardening.py FOLDER_OF_RUNS.

Runs of several H/E on the same meshes, H = 0 among them, by whose ratios the errors of the meshes mostly cancel: the
curves without hardening are those of fits.csv. The runs are named h*.csv.
"""

import sys
from pathlib import Path

import numpy as np

from runs import Run
from tables import Curve, Law

HERE = Path(__file__).parent


class Fits:
    """The curves of fits.csv at ν = 0.3."""

    def __init__(self):
        for line in (HERE / "fits.csv").read_text().splitlines():
            words = line.split(",")
            if words[0] == "nu=0.3":
                first, terms = int(words[1]), np.array(words[3:-2], float)
                setattr(self, words[2], self.curve(first, terms, 1.5 if words[2] == "exponent" else 1.0))

    @staticmethod
    def curve(first, terms, onset):
        curve = Curve.__new__(Curve)
        curve.powers, curve.terms, curve.onset = range(first, first + len(terms)), terms, onset
        return curve

    force, work = Law.force, Law.work


def read(folder):
    runs = [Run(path) for path in sorted(Path(folder).glob("h*.csv"))]
    return {h: Law([run for run in runs if run.hardening == h]) for h in sorted({run.hardening for run in runs})}


def main():
    laws, fits = read(sys.argv[1]), Fits()
    plain = laws.pop(0.0)
    with open(HERE / "hardening.csv", "w", encoding="utf-8") as file:
        print("# Linear hardening, nu = 0.3: as restitution.csv, with H/E; ratio: over the value without hardening", file=file)
        print("H_over_E,d_max,V_over_V_y,f_max,f_ratio,d_r,W_unload_over_W_load,W_ratio_ratio,restitution", file=file)
        for h, law in laws.items():
            for d in sorted({run.depth for run in law.runs}):
                force, work = law.force(d) / plain.force(d), law.work(d) / plain.work(d)
                way = fits.way(d) * law.way(d) / plain.way(d)
                ratio = law.restitution2(d) / plain.restitution2(d)
                regained = fits.restitution2(d) * ratio
                print(f"{h:g},{d:g},{np.sqrt(work * fits.work(d) / 0.4):.5g},{force * fits.force(d):.6g},{force:.4f},"
                      f"{d * (1 - way):.5g},{regained:.5f},{ratio:.4f},{np.sqrt(regained):.5f}", file=file)
    for h, law in {0.0: plain, **laws}.items():
        for run in sorted(law.runs, key=lambda run: run.depth):
            print(f"H/E {h:g} d {run.depth:6g} f {run.force / law.force(run.depth) - 1:+.4f} "
                  f"e2 {run.released / law.work(run.depth) / law.restitution2(run.depth) - 1:+.4f} imbalance {run.imbalance:.4f}")


if __name__ == "__main__":
    main()
