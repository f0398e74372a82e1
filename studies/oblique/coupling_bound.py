"""Whether a bound by β, μ and the slip says as much as the estimate of neglected coupling of spheres (docs/developer/numerics.md,
§15): draws impacts from a seed, has them computed, and prints how a table of the estimates' own quantiles does.

    coupling_bound.py STOSS IMPACTS [SEED]
"""

import json
import random
import subprocess
import sys

import numpy as np

SLIPS = (0.05, 0.2, 0.5, 1, 1.5, 2, 3, 5, 8)  # s/μv
NOISE = 0.03  # of the estimate of ε_t
POISSONS = (-0.3, 0, 0.1, 0.2, 0.3, 0.4, 0.45)


def bodies(draw):
    kind, own = draw.choice(("wall", "half-space", "half-space", "sphere")), draw.choice(POISSONS)
    other = f"poisson={draw.choice(POISSONS)},young={10 ** draw.uniform(-1, 1):.3g}"
    other += f",density={10 ** draw.uniform(-0.5, 0.5):.3g}"
    if kind == "sphere":
        other += f",radius={10 ** draw.uniform(-0.5, 0.5):.3g}"
    return f"--poisson {own}" if kind == "wall" else f"--poisson {own} --against {kind},{other}"


def rows(stoss, count, seed):
    """μ/β, slip and the estimated change of ε_t, for all slips of each impact."""
    draw = random.Random(seed)
    for _ in range(count):
        who, speed, friction = bodies(draw), 10 ** draw.uniform(-6, -1), 10 ** draw.uniform(-2, 0.3)
        tangential = ",".join(f"{friction * speed * slip:.6g}" for slip in SLIPS)
        words = f"oblique --body sphere {who} --speed {speed:.4g} --friction {friction:.4g} --tangential {tangential}"
        done = subprocess.run(
            [stoss, *words.split(), "--tolerance", "0.5", "--format", "json", "--quiet"], capture_output=True, text=True
        )
        for slip, row in zip(SLIPS, json.loads(done.stdout)["records"]):
            change = row["coupling_tangential_restitution"]
            if row["dundurs"] > 1e-6 and change is not None:
                yield friction / row["dundurs"], slip, abs(change)


def main(stoss, count, seed=2):
    ratio, slip, change = np.array(list(rows(stoss, int(count), int(seed)))).T
    cell = np.clip(np.searchsorted(np.quantile(ratio, np.linspace(0, 1, 11)), ratio) - 1, 0, 9)
    bound = np.zeros_like(change)
    for here in ((cell == k) & (slip == each) for k in range(10) for each in SLIPS):
        if here.any():
            bound[here] = np.quantile(change[here], 0.97)
    over, matters = bound / np.maximum(change, NOISE), change > NOISE
    print(f"{len(change)} values, {matters.mean():.2f} of them above {NOISE}")
    print("bound over estimate, quantiles 0.5, 0.9, 0.97:", np.quantile(over[matters], (0.5, 0.9, 0.97)).round(1))
    print(f"within a factor of 3, of all and of those above: {(over <= 3).mean():.2f}, {(over[matters] <= 3).mean():.2f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
