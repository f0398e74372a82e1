"""The same indentation with CalculiX at finite strain: calculix.py Y/E* DEPTH RADIUS ELEMENTS FOLDER.

A stiff sphere is pressed into a half-space of quadratic axisymmetric elements, by contact from surface to surface. RADIUS
is the expected radius of contact at DEPTH over that at the onset. The outer boundary is held, at 40 radii of contact, so
that only ratios of runs at the same DEPTH on the same mesh compare: a run at Y/E* = 1e-3 is nearly the limit of small strain.
Prints d and f of every increment.
"""

import math
import subprocess
import sys
from pathlib import Path

import numpy as np

POISSON, ONSET, STIFF = 0.3, 1.612797, 1e4
WEDGES = 180  # CalculiX turns axisymmetric elements into wedges of 2 degrees
SIZE, FINE = 40.0, 1.25


def axis(elements):
    """Corner places of a half-space's elements along r and depth, the largest radius of contact being 1."""
    step, places = 1 / elements, list(np.arange(round(FINE * elements) + 1) / elements)
    while places[-1] < SIZE:
        step *= 1 + 3.6 / elements
        places.append(places[-1] + step)
    places[-1] = SIZE
    return np.array(places)


class Deck:
    """Numbers the nodes of structured patches of elements with eight nodes."""

    def __init__(self):
        self.nodes, self.elements, self.sets, self.surfaces = [], [], {}, {}

    def patch(self, name, places):
        """places: arrays (rows, columns, 2) on a grid of half elements, rows upwards."""
        rows, columns, _ = places.shape
        number = {}
        for i in range(rows):
            for k in range(columns):
                if i % 2 and k % 2:
                    continue
                self.nodes.append(places[i, k])
                number[i, k] = len(self.nodes)
        own = []
        for i in range(0, rows - 1, 2):
            for k in range(0, columns - 1, 2):
                corners = ((0, 0), (0, 2), (2, 2), (2, 0), (0, 1), (1, 2), (2, 1), (1, 0))
                self.elements.append((name, [number[i + a, k + b] for a, b in corners]))
                own.append(len(self.elements))
        across = (columns - 1) // 2
        self.surfaces[name] = {"bottom": own[:across], "top": own[-across:]}
        self.sets[name] = {
            "axis": [number[i, 0] for i in range(rows)],
            "bottom": [number[0, k] for k in range(columns)],
            "top": [number[rows - 1, k] for k in range(columns)],
            "side": [number[i, columns - 1] for i in range(rows)],
        }


def halved(places):
    return np.sort(np.append(places, 0.5 * (places[1:] + places[:-1])))


def deck(strength, depth, contact, elements):
    """The input, and the depth and force at the onset. Lengths in the expected radius of contact, stresses in E*."""
    edge = math.pi * ONSET * strength / 2  # a/R at the onset
    radius = 1 / (contact * edge)
    onset, force = radius * edge**2, 4 / 3 * radius**2 * edge**3
    parts = Deck()
    places = halved(axis(elements))
    parts.patch("HALF", np.array([[(r, -z) for r in places] for z in places[::-1]]))
    wide = np.linspace(0, 1.5, 2 * round(1.5 * elements) + 1)
    low = radius - np.sqrt(radius**2 - wide**2)
    high = low[-1] + 0.6
    parts.patch("BALL", np.array([[(r, z + (high - z) * part) for r, z in zip(wide, low)] for part in np.linspace(0, 1, 9)]))
    young = 1 - POISSON**2
    lines = ["*NODE,NSET=ALL"]
    lines += [f"{k},{r:.12g},{z:.12g}" for k, (r, z) in enumerate(parts.nodes, 1)]
    for name in ("HALF", "BALL"):
        lines.append(f"*ELEMENT,TYPE=CAX8R,ELSET={name}")
        lines += [f"{k}," + ",".join(map(str, nodes)) for k, (of, nodes) in enumerate(parts.elements, 1) if of == name]
        for side, nodes in parts.sets[name].items():
            lines.append(f"*NSET,NSET={name}_{side}".upper())
            lines += [f"{node}," for node in nodes]
    lines.append("*SURFACE,NAME=FLAT,TYPE=ELEMENT")
    lines += [f"{k},S3" for k in parts.surfaces["HALF"]["top"][: round(1.6 * elements)]]
    lines.append("*SURFACE,NAME=ROUND,TYPE=ELEMENT")
    lines += [f"{k},S1" for k in parts.surfaces["BALL"]["bottom"]]
    lines += ["*MATERIAL,NAME=SOFT", "*ELASTIC", f"{young},{POISSON}", "*PLASTIC", f"{strength:.10g},0.", f"{strength * 1.0001:.10g},10."]
    lines += ["*MATERIAL,NAME=HARD", "*ELASTIC", f"{STIFF * young},{POISSON}"]
    lines += ["*SOLID SECTION,ELSET=HALF,MATERIAL=SOFT", "*SOLID SECTION,ELSET=BALL,MATERIAL=HARD"]
    lines += ["*SURFACE INTERACTION,NAME=TOUCH", "*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR", f"{200 * elements},{1e-3 * strength:.6g}"]
    lines += ["*CONTACT PAIR,INTERACTION=TOUCH,TYPE=SURFACE TO SURFACE", "FLAT,ROUND"]
    lines += ["*BOUNDARY", "HALF_AXIS,1,1", "BALL_AXIS,1,1", "HALF_BOTTOM,1,2", "HALF_SIDE,1,2", "BALL_TOP,1,1"]
    for target in (depth, depth * (0.4 if depth < 50 else 0.6)):
        lines += ["*STEP,NLGEOM,INC=400", "*STATIC", "0.02,1.,1e-4,0.04"]
        lines += ["*BOUNDARY", f"BALL_TOP,2,2,{-target * onset:.10g}"]
        lines += ["*NODE PRINT,NSET=BALL_TOP,TOTALS=ONLY", "RF", "*NODE PRINT,NSET=PIN", "U", "*END STEP"]
    lines.insert(lines.index("*BOUNDARY"), f"*NSET,NSET=PIN\n{parts.sets['BALL']['top'][0]},")
    return "\n".join(lines) + "\n", onset, force


def main():
    strength, depth, contact, elements, folder = *map(float, sys.argv[1:4]), int(sys.argv[4]), Path(sys.argv[5])
    text, onset, force = deck(strength, depth, contact, elements)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "run.inp").write_text(text)
    with open(folder / "log", "w", encoding="utf-8") as log:
        subprocess.run(["ccx", "run"], cwd=folder, stdout=log, check=False)
    report(folder, onset, force)


def report(folder, onset, force):
    d, f = [], []
    lines = (folder / "run.dat").read_text().split("\n")
    for k, line in enumerate(lines):
        if "total force" in line:
            f.append(-WEDGES * float(lines[k + 2].split()[1]) / force)
        if "displacements" in line:
            d.append(-float(lines[k + 2].split()[2]) / onset)
    print("d,f")
    for each in zip(d, f):
        print(f"{each[0]:.6g},{each[1]:.6g}")


if __name__ == "__main__":
    main()
