"""The pictures of `make demo`: out/restitution.png and out/collision.gif."""

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import stoss

out = Path(sys.argv[1])
out.mkdir(exist_ok=True)

speed = np.concatenate([np.geomspace(0.005, 0.02, 12), np.linspace(0.024, 0.3, 70)])
curve = stoss.restitution(poisson=[[0.33], [0.9]], speed=speed)
figure, ax = plt.subplots(figsize=(5.2, 3.4), layout="constrained")
stoss.plot.restitution(curve, ax, scale="linear", markersize=2.5)
ax.plot(0.3, 0.65, "x", color="black", markersize=8, label="paper's text, ν = 0.9: ε ≈ 0.65 at v = 0.3 c")
ax.set_title("Elastic disk against a hard wall", fontsize="medium")
ax.legend(frameon=False, loc="lower left")
figure.savefig(out / "restitution.png", dpi=200)

hit = stoss.impact(poisson=0.33, speed=0.2, cutoff=25)
stoss.animate(hit, out / "collision.gif", quantity="von_mises")

for name in ("restitution.png", "collision.gif"):
    print(f"Picture: {(out / name).resolve()}")
