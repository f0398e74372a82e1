"""Reads the runs of stoss_yield, and what is taken from each."""

import numpy as np


class Run:
    """One loading and unloading; depths, forces and works in units of the onset of yield."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            words = file.readline().split()
            lines = [line.strip().split(",") for line in file]
        of = dict(zip(words[1::2], words[2::2]))
        self.poisson, self.depth = float(of["nu"]), float(of["depth"])
        self.elements, self.steps, self.size = int(of["elements"]), int(of["steps"]), float(of["size"])
        self.hardening = float(of.get("hardening", 0))  # H/E
        rows = {name: np.array([row[1:] for row in lines if row[0] == name], float) for name in ("load", "unload", "surface")}
        self.load, self.unload = rows["load"], np.vstack([rows["load"][-1], rows["unload"]])
        self.surface = rows["surface"]
        self.force, self.radius = self.load[-1, 1], self.load[-1, 2]

    @property
    def imbalance(self):
        """|work − stored − dissipated| over the work, at the greatest depth."""
        work, stored, dissipated = self.load[-1, 5:8]
        return abs(work - stored - dissipated) / work

    @property
    def residual_depth(self):
        """Where the contact is lost: f^{2/3} is a line there, as in Hertz' law."""
        d, f = self.unload[:, 0], self.unload[:, 1] / self.force
        last = (f > 0.01) & (f < 0.2)
        slope, start = np.polyfit(d[last], f[last] ** (2 / 3), 1)
        lost = np.argmax(f <= 0)
        return float(np.clip(-start / slope, d[lost], d[lost - 1]))

    @property
    def released(self):
        """Work of the unloading; f^{2/3}, which is nearly linear, is interpolated."""
        d, s = self.shape(np.linspace(0, 1, 2001))
        return self.force * np.trapz(s, d)

    def shape(self, part):
        """(d, f/f_max) at these parts of the way from the residual to the greatest depth."""
        depths, forces = self.unload[::-1, 0], (self.unload[::-1, 1] / self.force) ** (2 / 3)
        there = depths > self.residual_depth
        depths = np.append(self.residual_depth, depths[there])
        forces = np.append(0.0, forces[there])
        d = self.residual_depth + part * (self.depth - self.residual_depth)
        return d, np.interp(d, depths, forces) ** 1.5

    def impression(self):
        """Curvature of the residual impression over that of the indenter, by a parabola through its inner half."""
        r, z = self.surface[self.surface[:, 0] < 0.6 * self.radius].T
        return 2 * np.polyfit(r**2, z, 1)[0]
