"""What finite strain changes, from runs of calculix.py: finite.py FOLDER, of files named STRENGTH_DEPTH.csv."""

import math
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
ONSET = 1.612797


def works(path):
    """Greatest depth and force, W_load, W_unload/W_load and residual depth."""
    d, f = np.genfromtxt(path, delimiter=",", names=True).view((float, 2)).T
    top = int(np.argmax(d))
    load = np.trapz(np.append(0, f[: top + 1]), np.append(0, d[: top + 1]))
    down, force = d[top:], np.maximum(f[top:], 0)
    return d[top], f[top], load, -np.trapz(force, down) / load


def main():
    law = np.genfromtxt(HERE / "loading.csv", delimiter=",", names=True, skip_header=1)
    again = np.genfromtxt(HERE / "restitution.csv", delimiter=",", names=True, skip_header=1)
    again = again[again["nu"] == 0.3]
    with open(HERE / "calculix.csv", "w", encoding="utf-8") as file:
        print("# CalculiX at finite strain, 6 quadratic elements along the contact, outer boundary held, nu = 0.3; "
              "ratios to the universal curves", file=file)
        print("Y_over_E,d,a_over_R,f,W_unload_over_W_load,f_ratio,W_ratio_ratio", file=file)
        for path in sorted(Path(sys.argv[1]).glob("*_*.csv"), key=lambda path: [float(x) for x in path.stem.split("_")[::-1]]):
            if path.stat().st_size < 50:
                continue
            strength = float(path.stem.split("_")[0])
            d, f, _, ratio = works(path)
            universal = np.exp(np.interp(np.log(d), np.log(law["d"]), np.log(law["f"])))
            returned = np.interp(np.log(d), np.log(again["d_max"]), again["W_unload_over_W_load"])
            radius = np.interp(d, law["d"], law["a"]) * math.pi * ONSET * strength / 2
            print(f"{strength:g},{d:g},{radius:.3f},{f:.4f},{ratio:.4f},{f / universal:.4f},{ratio / returned:.4f}", file=file)


if __name__ == "__main__":
    main()
