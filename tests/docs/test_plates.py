"""The numbers of docs/understand/findings/plates.md and docs/theory/plates.md are those of the tables in docs/results/plates."""

import itertools
import math
import re

import pytest
from conftest import ROOT, line, page, rows, table, with_error

PAGE, WORDS = page("docs/understand/findings/plates.md")
THEORY, _ = page("docs/theory/plates.md")
FAST, MAP, BLOCK, LAYERS = (table(f"docs/results/plates/{name}.csv") for name in ("fast", "map", "block", "layers"))
# Both speeds and both thicknesses have a unit more in this table.
TEXT = (ROOT / "docs/results/plates/materials.csv").read_text(encoding="utf-8").replace("speed[c]", "own_speed")
MATERIALS = rows(TEXT.replace("thickness[m]", "si_thickness").splitlines())
PAIRS = (("bearing steel", "bearing steel"), ("bearing steel", "glass"), ("glass", "glass"), ("ice", "ice"))
SOLIDS = {"bearing steel": (2.1e11, 0.3, 7810), "glass": (7e10, 0.22, 2500), "ice": (9.3e9, 0.33, 917)}


def test_finite_elements_are_within_both_errors():
    both = [row for row in FAST if row["elements"] != ""]
    assert len(both) == 17 and f"all {len(both)}" in WORDS
    (row,) = [row for row in both if (row["ball"], row["thickness"], row["speed"]) == ("elastic", 2, 0.1)]
    assert f"1 − ε² = {with_error(row['elements'], row['elements_error'])} on a plate" in WORDS
    assert f"stoss gives {with_error(row['lost_fraction'], row['lost_fraction_error'])}" in WORDS
    assert all(abs(row["lost_fraction"] - row["elements"]) < row["lost_fraction_error"] + row["elements_error"] for row in both)


def of(ball, plate, speed):
    """The rows of a pair at a speed by thickness in R; infinity: the block."""
    its = [row for row in MATERIALS if (row["ball"], row["plate"], row["speed"]) == (ball, plate, speed)]
    return {float(text["thickness"]): text for text in its}


def materials_lines():
    its = [of(*pair, 0.5) for pair in PAIRS]
    for wanted in (0.4, 0.63, 1, 2, 10, math.inf):
        h = min(its[0], key=lambda each: abs(math.log(each / wanted)) if math.isfinite(each + wanted) else each != wanted)
        mm = "block" if math.isinf(h) else f"{5 * h:.3g} mm"
        cells = [f"{each[h]['restitution']:.4f}" for each in its[:2]]
        yield line(mm, *cells, "1" if math.isinf(h) else f"{its[0][h]['zener']:.4f}", f"{its[1][h]['contact_time'] * 1e6:.1f}")


@pytest.mark.parametrize("cells", materials_lines())
def test_table_of_materials(cells):
    assert cells in PAGE


def pressure_speed(name):
    young, nu, density = SOLIDS[name]
    return math.sqrt(young * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / density)


def crossing(places, excess, level):
    """The least place from which on the excess is below the level; its logarithms are joined by lines."""
    for k in range(len(places) - 1, 0, -1):
        low, high = (max(abs(each), 1e-7) for each in excess[k - 1 : k + 1])
        if low > level >= high:
            share = math.log(low / level) / math.log(low / high)
            return places[k - 1] + share * (places[k] - places[k - 1])
    raise AssertionError(level)


def block_lines():
    for pair, group in itertools.groupby(BLOCK, lambda row: row["pair"]):
        found = {level: [] for level in (0.1, 0.01, 0.001)}
        for _, its in itertools.groupby(group, lambda row: row["speed"]):
            its = list(its)
            excess = [row["lost_fraction"] / row["on_block"] - 1 for row in its]
            for level, values in found.items():
                values.append(crossing([row["x"] for row in its], excess, level))
        cells = (f"{min(values):.3f} … {max(values):.3f}" for values in found.values())
        yield pair, found[0.01], line(pair.replace("nu=", "ν = "), *cells)


def test_table_of_blocks():
    shown = [cells for _, _, cells in block_lines() if cells in PAGE]
    assert len(shown) == len(re.findall(r"^\| .* … .* \|$", PAGE, re.MULTILINE)) == 3


def test_formula_for_a_block():
    places = {pair: values for pair, values, _ in block_lines()}
    hard = [value for pair, values in places.items() if "0.45" not in pair for value in values]
    assert 0.77 < min(hard) and max(hard) < 0.82 and "0.77 to 0.82" in WORDS
    assert max(places["one material nu=0.45"]) < 0.65
    for ball, plate in PAIRS:
        block = of(ball, plate, 0.5)[math.inf]
        enough = 0.82 * 0.5 * pressure_speed(plate) * block["contact_time"]
        name = f"{ball} on {plate}".replace("bearing ", "")
        assert f"{name} {100 * enough:.1f} cm" in WORDS
        beyond = [row for h, row in of(ball, plate, 0.5).items() if 5e-3 * h > enough]
        assert all(abs(row["lost_fraction"] / block["lost_fraction"] - 1) < 0.01 for row in beyond)


def test_zener_never_says_too_much():
    error = [1 - (1 - row["zener"] ** 2) / row["lost_fraction"] for row in MAP]
    weak = [row for row in MAP if 0.0 < row["restitution"] <= 0.08]
    strong = [each > -1.5 * row["lost_fraction_error"] for each, row in zip(error, MAP) if row["restitution"] > 0.08]
    assert all(strong) and "Wherever ε is above 0.08" in WORDS
    assert all(1 - row["zener"] ** 2 - row["lost_fraction"] < 5e-5 for row in weak) and "at most 5·10⁻⁵" in WORDS
    too_weak = min(row["zener"] / row["restitution"] - 1 for row in weak if row["speed"] < 2e-3)
    assert f"by up to {-100 * too_weak:.0f} %" in WORDS
    assert f"{len(MAP)} impacts" in WORDS
    assert all(row["converged"] == "true" for row in MAP)


def test_law_of_the_error_of_zener():
    shear = 1 / math.sqrt(2.6)
    law = []
    for row in MAP:
        error, share = 1 - (1 - row["zener"] ** 2) / row["lost_fraction"], row["thickness"] / (shear * row["contact_time"])
        if row["inelasticity"] < 0.1 and share < 0.5:
            law.append(error / share)
    assert len(law) > 80 and "0.94 to 1.14" in WORDS
    assert 0.94 < min(law) and max(law) < 1.145, (min(law), max(law))


def by_zeners_time(row):
    """Thickness that Zener's contact time gives for the contact time of a row, over the true one."""
    same = sorted((each for each in MAP if each["speed"] == row["speed"]), key=lambda each: each["thickness"])
    for thin, thick in itertools.pairwise(same):
        times = [each["zener_contact_time"] for each in (thin, thick)]
        if times[0] >= row["contact_time"] >= times[1]:
            share = math.log(times[0] / row["contact_time"]) / math.log(times[0] / times[1])
            return thin["thickness"] * (thick["thickness"] / thin["thickness"]) ** share / row["thickness"]
    return math.inf


def test_thickness_by_the_contact_time_of_zener():
    usual = [row for row in MAP if 0.99e-4 < row["speed"] < 1.01e-3 and row["restitution"] > 0]
    good = [by_zeners_time(row) - 1 for row in usual if 0.6 < row["inelasticity"] < 1.55]
    assert len(good) >= 6 and all(-0.012 < each < 0.018 for each in good) and "−1.1 to 1.7 %" in WORDS
    other = [by_zeners_time(row) - 1 for row in usual if 0.25 < row["inelasticity"] < 0.27]
    assert [round(100 * each) for each in other] == [7, 22] and "7 and 22 %" in WORDS


def layered(what, sheet, other):
    (row,) = [row for row in LAYERS if (row["what"], row["sheet"], row["other"]) == (what, sheet, other)]
    return row


def test_nothing_yields_that_is_not_said_to():
    assert all(row["yield_speed"] == "" or row["speed"] < float(row["yield_speed"]) for row in MATERIALS)
    beyond = {row["what"]: float(row["yield_speed"]) for row in LAYERS if float(row["yield_speed"]) < 0.2}
    assert beyond == {"aluminium": 0.0223} and "at 0.2 m/s" in WORDS
    assert "Aluminium yields from 0.022 m/s" in WORDS


def test_layers():
    assert f"ε = {layered('one sheet', 4, 0)['restitution']:.3f}" in WORDS
    for what, other in (("two sheets in one", 0), ("laminated", 0.38), ("laminated", 1.52)):
        assert f"{layered(what, 4, other)['restitution']:.3f}" in WORDS
    for coat, sheet, other in (("PMMA", 10, 0.1), ("PMMA", 40, 2), ("tungsten carbide", 40, 2), ("tungsten carbide", 10, 2)):
        ratio = layered(coat, sheet, other)["lost_fraction"] / layered("bare steel", sheet, 0)["lost_fraction"]
        assert f"{100 * ratio:.0f} %" in WORDS, (coat, sheet, ratio)


def test_duration_of_the_picture():
    (row,) = [row for row in FAST if (row["ball"], row["thickness"], row["speed"]) == ("elastic", 2, 0.1)]
    assert f"contact lasts {row['contact_time']:.2f} R/c" in THEORY


def test_numbers_of_the_theory():
    (row,) = [row for row in FAST if (row["ball"], row["thickness"], row["speed"]) == ("elastic", 0.5, 0.1)]
    assert row["contacts"] in (3, 4) and "three or four" in THEORY


def test_numbers_of_a_steel_ball():
    rows = of("bearing steel", "bearing steel", 0.5)
    h = min(rows, key=lambda each: abs(each - 0.4))
    assert f"\\lambda = {rows[h]['inelasticity'] * (h / 0.4) ** 2:.3f}$" in THEORY
    assert rows[0.2]["deflection"] == pytest.approx(0.0209, abs=5e-4) and "1 mm by 2 %" in THEORY.replace("\n", " ")


def test_table_of_zener():
    values = {0.05: 0.91777, 0.2: 0.71404, 0.5: 0.43690, 1.0: 0.18412, 1.5: 0.06640}
    assert all(f"{value:.5f}" in THEORY for value in values.values())


if __name__ == "__main__":
    for each in (*materials_lines(), "", *(cells for _, _, cells in block_lines())):
        print(each)
