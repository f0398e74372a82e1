"""The numbers of docs/understand/findings/rough.md: those of the tables that studies/rough writes, and these against
the command."""

import importlib.util
import math
import os

import pytest
from conftest import ROOT, line, page, table

SPEC = importlib.util.spec_from_file_location("make_rough", ROOT / "studies/rough/make.py")
make = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(make)

PAGE, WORDS = page("docs/understand/findings/rough.md")
STEEL, SHORT, EXTRAPOLATION, COATS = (
    table(f"docs/results/rough/{name}.csv") for name in ("steel", "short", "extrapolation", "coats")
)
PROGRAM = os.environ["STOSS"]
RADIUS, SOUND = 0.005, (2.1e11 / 7810) ** 0.5  # of bearing steel, m, m/s
TENFOLD = (0.001, 0.01, 0.1, 1)  # m/s
UP = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def having(rows, **values):
    return [row for row in rows if all(row[name] == value for name, value in values.items())]


def one(rows, **values):
    (row,) = having(rows, **values)
    return row


def short(value, smallest=1e-9, places=2):
    """2.3·10⁻⁵, of what is above the smallest that was computed."""
    if value < smallest:
        return "< 10⁻⁹"
    digits, power = f"{value:.{places}e}".split("e")
    return f"{digits}·10{str(int(power)).translate(UP)}"


def steel(partner, height, speed):
    found = having(STEEL, partner=partner, roughness=height, speed=speed)
    return found[0] if found else None


def losses():
    for partner in make.PARTNERS:
        for height in make.HEIGHTS:
            its = [steel(partner, height, speed) for speed in TENFOLD]
            name = f"{1e9 * height:g} nm" if height else "smooth"
            yield line(f"{partner}, {name}", *(short(row["lost_fraction"]) if row else "–" for row in its))


def times():
    for height in make.HEIGHTS:
        its = [steel("wall", height, speed) for speed in TENFOLD]
        name = f"{1e9 * height:g} nm" if height else "smooth"
        yield line(name, *(f"{1e6 * row['contact_time']:.3g} µs" if row["contact_time"] < 1e-3
                           else f"{1e3 * row['contact_time']:.2g} ms" for row in its))  # fmt: skip


def saved():
    for body, poisson in make.BODIES:
        for speed in make.AT:
            its = [one(SHORT, body=body, poisson=poisson, speed=speed, u0=each) for each in make.SCALED]
            yield line(f"{body}, {poisson:g}", f"10{str(round(math.log10(speed))).translate(UP)}",
                       short(its[0]["smooth"], places=1),
                       *(f"{100 * row['saved']:.{1 if row['saved'] < 0.99 else 2}f} %" for row in its))  # fmt: skip


def bound(partner, height, share):
    """The speed from which on roughness changes 1 − ε² by less than a share."""
    if partner == "wall":
        return 2 * height * SOUND / (RADIUS * share)
    at = one(STEEL, partner="block", roughness=0, speed=0.1)
    return 0.1 * (2 * make.LENGTH * height / (share * at["compression"])) ** 1.25


def bounds():
    for height in make.HEIGHTS[1:]:
        yield line(f"{1e9 * height:g} nm", *(f"{float(f'{bound(partner, height, share):.2g}'):g} m/s"
                   for partner in make.PARTNERS for share in (0.01, 0.1)))  # fmt: skip


def walls():
    for hardness in (*make.HARDNESSES, float("inf")):
        its = [one(EXTRAPOLATION, speed=speed, hardness=hardness if hardness != 1000 / 3 else 333.333)
               for speed in make.DISKS]  # fmt: skip
        name = f"{hardness:.0f}" if hardness < float("inf") else "hard wall"
        yield line(name, *(f"{row['lost_fraction']:.5f}" for row in its))


def coats():
    for row in COATS:
        if row["quality"]:
            free = one(COATS, coat=row["coat"], thickness=row["thickness"], quality=0)
            yield line(f"{row['coat']}, {1e6 * row['thickness']:g} µm" if row["thickness"] else "bare block",
                       f"{row['restitution']:.{2 if row['coat'] == 'rubber' else 4}f}",
                       f"{100 * row['lost_fraction']:.{1 if row['coat'] == 'rubber' else 2}f} %",
                       f"{100 * row['dissipated']:.{1 if row['coat'] == 'rubber' else 2}f} %",
                       f"{1e3 * row['contact_time']:.3g} ms", f"{1e6 * row['compression']:.2g} µm",
                       f"{abs(100 * free['lost_fraction']):.3f} %")  # fmt: skip


@pytest.mark.parametrize("expected", [*losses(), *times(), *saved(), *bounds(), *walls(), *coats()])
def test_lines_of_tables(expected):
    assert expected in PAGE.splitlines(), expected


def test_asperities_on_steel():
    smooth, rough = (steel("wall", height, 0.01)["lost_fraction"] for height in (0, 24e-9))
    assert rough < 1e-4 * smooth and "less than a ten-thousandth" in WORDS
    smooth, rough = ([steel("wall", height, speed)["lost_fraction"] for speed in (0.1, 1)] for height in (0, 24e-9))
    off = [1 - each / whole for each, whole in zip(rough, smooth)]
    assert "{:.0f} % less at 10 cm/s and {:.0f} % less at 1 m/s".format(*(100 * each for each in off)) in WORDS
    for partner, said in (("wall", "0.13 m/s at a wall"), ("block", "0.51 m/s on the block")):
        assert f"{steel(partner, 0, 0.1)['yield_speed']:.2g}" == said[:4] and said in WORDS
    half = steel("block", 24e-9, 0.001)["lost_fraction"] / steel("block", 0, 0.001)["lost_fraction"]
    assert f"{100 * (1 - half):.0f} % less at 1 mm/s" in WORDS


def test_radiation_changes_by_twice_the_length_over_the_compression():
    found = []
    for row in having(STEEL, partner="block"):
        if row["roughness"]:
            smooth = steel("block", 0, row["speed"])
            length = make.LENGTH * row["roughness"] / smooth["compression"]
            if length < 0.1:
                found.append((1 - row["lost_fraction"] / smooth["lost_fraction"]) / length)
    assert f"by {min(found):.1f} to {max(found):.1f} times u₀/δ" in WORDS


def test_scale_of_ringing():
    slopes = [row["saved"] / 0.01 for row in having(SHORT, u0=0.01)]
    assert f"from {min(slopes):.1f} to {max(slopes):.1f}" in WORDS
    assert max(slopes) < 2 * 4.5 and min(slopes) > 4.5 / 2
    assert bound("wall", 24e-9, 0.1) > 2 * steel("wall", 0, 0.1)["yield_speed"]
    assert "None of these balls is smooth" in WORDS
    assert f"smooth to 1 % from {bound('block', 24e-9, 0.01):.2g} m/s on" in WORDS
    other = [row["saved"] / row["u0_over_compression"] for row in having(SHORT, u0=0.01)]
    assert f"from {min(other):.0f} to {max(other):.0f}" in WORDS
    assert all(row["saved"] > 0.99 for row in having(SHORT, u0=1)) and "rings less than 1 %" in WORDS


def end(speed, walls):
    """Where the line through walls ends at 1/α = 0, relative to the hard wall."""
    x, y = zip(*((1 / each, one(EXTRAPOLATION, speed=speed, hardness=each)["lost_fraction"]) for each in walls))
    mean = sum(x) / len(x)
    slope = sum((a - mean) * b for a, b in zip(x, y)) / sum((a - mean) ** 2 for a in x)
    hard = one(EXTRAPOLATION, speed=speed, hardness=float("inf"))
    return (sum(y) / len(y) - slope * mean) / hard["lost_fraction"] - 1


def test_lines_of_the_paper():
    cases = (
        (0.1, (333.333, 500, 1000), "{} % below the hard wall"),
        (0.02, (333.333, 500, 1000), "{} % too low"),
        (0.02, (1000, 2000, 4000), "ends {} % below"),
    )
    for speed, walls, said in cases:
        assert said.format(f"{-100 * end(speed, walls):.2g}") in WORDS


def test_coats():
    rubber = [row for row in COATS if row["coat"] == "rubber"]
    assert max(row["lost_fraction_error"] for row in rubber) < 3e-3 and "right to 0.003" in WORDS
    assert all(row["lost_fraction"] < 1e-11 for row in rubber if not row["quality"]) and "less than 10⁻¹¹" in WORDS
    heat = [row["dissipated"] / row["lost_fraction"] for row in rubber if row["quality"]]
    assert f"{100 * min(heat):.0f} to {100 * max(heat):.0f} % is heat" in WORDS
    bare, thick = (one(COATS, coat="paint", thickness=each, quality=0)["lost_fraction"] for each in (0, 3e-5))
    assert f"{100 * (1 - thick / bare):.0f} % less" in WORDS
    lossy = one(COATS, coat="paint", thickness=1e-5, quality=50)
    assert f"{100 * lossy['dissipated'] / lossy['lost_fraction']:.0f} % of the loss is heat" in WORDS


def test_tables_are_those_of_the_command():
    (row,) = make.of_steel(PROGRAM, "wall", 24e-9, [0.1])
    stored = steel("wall", 24e-9, 0.1)
    assert float(row["lost_fraction"]) == pytest.approx(stored["lost_fraction"], abs=2 * stored["lost_fraction_error"])
    row, stored = make.of_hardness(PROGRAM, 0.1, 500), one(EXTRAPOLATION, speed=0.1, hardness=500)
    assert float(row["lost_fraction"]) == pytest.approx(stored["lost_fraction"], abs=2 * stored["lost_fraction_error"])
    row, stored = make.of_coat(PROGRAM, "paint", 1e-5, 50), one(COATS, coat="paint", thickness=1e-5, quality=50)
    assert float(row["lost_fraction"]) == pytest.approx(stored["lost_fraction"], abs=2 * stored["lost_fraction_error"])
