"""The tables of docs/results/oblique/, and what its page reads off them."""

import functools
import math
import runpy
import statistics

from conftest import ROOT, page
from conftest import table as table_of

PAGE, WORDS = page("docs/understand/findings/oblique.md")
CODES, CODES_WORDS = page("docs/understand/findings/particle_codes.md")
MEASURED_WORDS = page("docs/understand/measured.md")[1]
FASTER = (1e-6, 1e-3, 0.1)


def table(name):
    return table_of(f"docs/results/oblique/{name}.csv")


def having(rows, **values):
    return [row for row in rows if all(row[name] == value for name, value in values.items())]


def one(rows, **values):
    (row,) = having(rows, **values)
    return row


def signed(value, places=3):
    """With a minus sign that is one."""
    return f"{value:.{places}f}".replace("-", "−")


CURVES, SIZE, GLASS, DEM = table("curves"), table("size"), table("glass"), table("dem")
COUPLING, BEST, NORMAL = table("coupling"), table("superball"), table("normal")
FINITE_ELEMENTS, MEASURED = table("finite_elements"), table("measured")


@functools.cache
def curve(bodies, speed, friction=0.1):
    return {row["x"]: row for row in having(CURVES, bodies=bodies, speed=speed, friction=friction)}


def size_law(against, poisson, psi):
    """A and B of (Maw − ψ₂)R/a = A + B ln(R/a), by least squares from 1e-6 to 1e-4 c."""
    its = [row for row in having(SIZE, against=against, poisson=poisson, psi1=psi) if row["speed"] < 1.1e-4]
    over = [math.log(1 / row["contact_radius"]) for row in its]
    less = [(row["maw"] - row["psi2"]) / row["contact_radius"] for row in its]
    fit = statistics.linear_regression(over, less)
    rest = max(abs(y - fit.intercept - fit.slope * x) for x, y in zip(over, less))
    return fit.intercept, fit.slope, rest


DRAW = runpy.run_path(str(ROOT / "studies/oblique/figure.py"))["measured"]


def at(rows, angle, name):
    """A column of the ball on glass at an angle, between whole degrees by a line."""
    for low, high in zip(rows, rows[1:]):
        if low["angle"] <= angle <= high["angle"]:
            share = (angle - low["angle"]) / (high["angle"] - low["angle"])
            return (1 - share) * low[name] + share * high[name]
    raise ValueError(angle)


def measurements():
    for quantity, its in DRAW(ROOT / "docs/results/oblique").items():
        for angle, value in its:
            yield quantity, angle, value


def worst(law, speed):
    """The maximum error of ε_t for x of 0.2 and more, and where."""
    its = curve("sphere", speed)
    errors = {x: law[x] - row["tangential_restitution"] for x, row in its.items() if x >= 0.2}
    x = max(errors, key=lambda each: abs(errors[each]))
    return errors[x], x


def of_law(name):
    return {row["x"]: row["tangential_restitution"] for row in having(DEM, law=name)}


def walton(limit, speed=1e-6):
    return {x: min(limit, 3.5 * (1 + row["restitution"]) / x - 1) for x, row in curve("sphere", speed).items()}


def best_limit(speed):
    return min((0.005 * i for i in range(200)), key=lambda limit: abs(worst(walton(limit, speed), speed)[0]))
