"""A small grid of each kind that a store takes, as TOML, and the same values by a direct call."""

from pathlib import Path

import numpy as np

import stoss

RING = Path(__file__).parents[3] / "examples/any_body/ring_4.json"

TOMLS = {
    "restitution": """
against = ["wall", {kind = "half-space"}]
speed = [0.01, 0.1]
tolerance = 1e-2
bodies = {kind = "sphere", poisson = [0.1, 0.2, 0.3]}
""",
    "oblique": """
speed = [0.01, 0.05]
angle = [20, 60]
friction = [0.1, 0.4]
spin = [0, 0.01]
bodies = {kind = "sphere", poisson = [0.1, 0.3]}
""",
    "ensemble": """
speed = [0.01]
temperature = [0.01, 0.02]
samples = 7
seed = 5
error = 1e-2
bodies = {kind = "sphere", poisson = [0.1, 0.3]}
""",
    "modal": f"""
speed = [0.1, 0.2]
tolerance = 0.1
against = [{{kind = "modal", file = "{RING}"}}]
bodies = {{kind = "sphere", radius = [6e-3, 8e-3], material = "structural steel"}}
""",
}


def grid_of(kind, folder):
    """The grid of its TOML file, which is written there."""
    path = folder / f"{kind}.toml"
    path.write_text(TOMLS[kind], encoding="utf-8")
    return stoss.Grid.from_toml(path)


def direct(kind, body, against):
    """An array along the axes of a quantity, and its name, without a sweep."""
    if kind == "oblique":
        speed, angle, spin, friction = np.meshgrid([0.01, 0.05], [20, 60], [0, 0.01], [0.1, 0.4], indexing="ij")
        found = stoss.oblique(body, speed=speed, angle=angle, spin=spin, friction=friction)
        return "tangential_restitution", found.tangential_restitution
    if kind == "ensemble":
        every = [
            stoss.restitution_distribution(body, speed=0.01, temperature=each, samples=7, seed=5, error=1e-2).restitution
            for each in (0.01, 0.02)
        ]
        return "restitution", np.array([every])
    speeds, tolerance = ([0.1, 0.2], 0.1) if kind == "modal" else ([0.01, 0.1], 1e-2)
    met = None if isinstance(against, stoss.HardWall) else against
    return "restitution", stoss.restitution(body, against=met, speed=speeds, tolerance=tolerance).restitution
