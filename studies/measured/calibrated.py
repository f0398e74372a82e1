"""One constant from half of each measured series, and the other half predicted: a table of docs/understand/measured.md.

calibrated.py: prints the rows. Every second point is calibrated on, the others are predicted. Wherever a ball is a
shell, it is taken as solid all the same.
"""

import math
import warnings

import stoss
from compare import points

WOOD = stoss.HalfSpace(material=stoss.Material(young=1e10, poisson=0.3, density=700))
STONE = stoss.HalfSpace(material=stoss.Material(young=6e10, poisson=0.25, density=2700))
LIQUIDMETAL = stoss.HalfSpace(material=stoss.Material(young=9.6e10, poisson=0.36, density=6000, quality=300))


def ball(radius, mass, young, poisson, quality=20.0):
    density = mass / (4.0 / 3.0 * math.pi * radius**3)
    material = stoss.Material(young=young, poisson=poisson, density=density, quality=quality)
    return stoss.Sphere(radius=radius, material=material)


def given(name, columns):
    """Columns of a set, by the names that `calibrate` knows."""
    rows = [row for row in points(name) if all(row[each] for each in columns) and float(row.get("restitution", 0)) < 1]
    return {known: [float(row[each]) for row in rows] for each, known in columns.items()}


RESTITUTION = {"speed_m_s": "speed", "restitution": "restitution"}
WITH_ERROR = RESTITUTION | {"restitution_error": "restitution_uncertainty"}
HEIGHTS = {"drop_height_m": "drop_height", "rebound_height_m": "rebound_height",
           "rebound_height_uncertainty_m": "rebound_height_uncertainty"}  # fmt: skip

ICE = stoss.materials["ice"]
SERIES = {
    "golf ball on marble": (given("golf_on_marble", HEIGHTS), ball(0.021, 0.0415, 1e8, 0.45), STONE, "quality",
                            "nothing: the rest is scatter"),
    "croquet ball on a mallet": (given("croquet_on_mallet", RESTITUTION), ball(0.046, 0.4536, 7e8, 0.4), WOOD, "quality",
                                 "a loss that grows with the strain"),
    "steel on Liquidmetal": (given("steel_on_liquidmetal", RESTITUTION), stoss.Sphere(radius=0.005, material=stoss.materials["bearing steel"]),
                             LIQUIDMETAL, "against.quality", "the radius of the ball and the thickness of the plate"),
    "frosted ice, Ø 50 mm": (given("hatzes_1988_frosted_law", RESTITUTION), stoss.Sphere(radius=0.025, material=ICE),
                             stoss.HalfSpace(material=ICE), "quality", "frost that is crushed: the loss grows with the speed"),
    "tennis ball on stone": (given("tennis_on_stone", WITH_ERROR), ball(0.033, 0.056, 1e6, 0.45, 10.0), STONE, "quality",
                             "a shell under pressure, which buckles"),
    "table-tennis ball on parquet": (given("table_tennis_on_parquet", WITH_ERROR), ball(0.02, 0.0027, 1e8, 0.4), WOOD, "quality",
                                     "a shell, and its own ringing"),
}  # fmt: skip


def half(data, first):
    return {name: column[first::2] for name, column in data.items()}


def rows():
    """Series, number of points, constant, measured and predicted ε of the other half, largest difference, what is missing."""
    for name, (data, body, against, unknown, missing) in SERIES.items():
        points_of_it = len(next(iter(data.values())))
        try:
            found = stoss.calibrate(half(data, 0), body, against=against, unknown=unknown)
        except stoss.InvalidInput:  # the search came to the end of its range
            yield name, points_of_it, "none: Q would be below 3", "–", "–", "–", missing
            continue
        there = stoss.calibrate(half(data, 1), body, against=against, unknown=unknown)  # has the air taken off
        speed, measured = there.speed, there.measured
        predicted = stoss.restitution(found.body, against=found.against, speed=speed).restitution
        (constant,) = found.constants
        spans = (f"{each.min():.3f} to {each.max():.3f}" for each in (measured, predicted))
        said = stoss.with_error(constant.value, constant.uncertainty)
        yield name, points_of_it, said, *spans, f"{abs(predicted - measured).max():.3f}", missing


if __name__ == "__main__":
    warnings.simplefilter("ignore", stoss.StossWarning)
    for cells in rows():
        print("| " + " | ".join(map(str, cells)) + " |")
