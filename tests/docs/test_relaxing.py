"""The numbers of docs/understand/findings/relaxing.md: those of the tables that studies/relaxing writes, and these against
the command."""

import importlib.util
import os
import sys

import pytest
from conftest import ROOT, line, page, table

pytest.importorskip("numpy")
sys.path.insert(0, str(ROOT / "studies/relaxing"))
SPEC = importlib.util.spec_from_file_location("make_relaxing", ROOT / "studies/relaxing/make.py")
make = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(make)
one_ball = sys.modules["one_ball"]

PAGE, WORDS = page("docs/understand/findings/relaxing.md")
LAW, TERMS, RUBBER, LAMINATE, DROP, CHANNELS = (
    table(f"docs/results/relaxing/{name}.csv") for name in ("laws", "terms", "rubber", "laminate", "drop", "channels")
)
PROGRAM = os.environ["STOSS"]


def having(rows, **values):
    return [row for row in rows if all(row[name] == value for name, value in values.items())]


def one(rows, **values):
    (row,) = having(rows, **values)
    return row


def percent(share, digits=3):
    return f"{100 * share:.{digits}g} %"


def laws():
    for ball, places in (("rubber", 4), ("glass", 5)):
        for law in one_ball.LAWS:
            its = [one(LAW, ball=ball, law=law, speed=speed)["restitution"] for speed in (0.001, 0.01, 0.1, 1, 3.1623)]
            yield line(f"{ball}, {law.replace('-', '–')}", *(f"{value:.{places}f}" for value in its))


def change(row):
    best = one(TERMS, quality=row["quality"], terms=15, speed=row["speed"])
    return row["lost_fraction"] / best["lost_fraction"] - 1


def counts():
    for count in (3, 5, 7, 10):
        its = having(TERMS, terms=count)
        ripples = [one(its, quality=quality, speed=1e-3)["ripple"] for quality in (10, 100)]
        yield line(count, *(percent(each, 2) for each in ripples),
                   *(f"{100 * change(row):+.2g} %".replace("-", "−") for row in its if row["quality"] == 10))  # fmt: skip


def rubbers():
    for row in RUBBER:
        if row["height"] == 1:
            yield line(row["ball"], f"{row['temperature']:g} °C", f"{row['contact_time'] * 1e3:.2f} ms",
                       f"{row['frequency']:.0f} Hz", f"{row['storage'] / 1e6:.2g} MPa", f"{row['tan_delta']:.2g}",
                       f"{100 * row['rebound']:.1f} %", f"{100 * row['rebound_of_constant_quality']:.1f} %")  # fmt: skip


def laminates():
    for row in LAMINATE:
        yield line(row["plate"], f"{row['restitution']:.4f}", percent(row["lost_fraction"]),
                   f"{100 * row['dissipated']:.2f} %", f"{row['contact_time'] * 1e6:.0f} µs",
                   f"{row['restitution_without_loss']:.4f}")  # fmt: skip


def drops():
    for row in DROP:
        yield line(f"{row['quality']:g}", f"{row['restitution']:.5f}", f"{row['times_quality']:.4f}",
                   f"{row['of_slow_limit']:.4f}", f"{row['quality_by_3.54']:.4g}", f"{row['quality_by_2.41']:.4g}")  # fmt: skip


def shares():
    for row in CHANNELS:
        if row["speed"] in (0.01, 0.1, 1, 10):
            parts = {name: 100 * row[name] for name in make.CHANNELS}
            cells = ("0" if part <= 0 else f"{part:.{2 if part < 10 else 1}f} %" for part in parts.values())
            yield line(f"{row['ball']}, {row['speed']:g} m/s", f"{row['restitution']:.4f}", *cells)


@pytest.mark.parametrize("expected", [*laws(), *counts(), *rubbers(), *laminates(), *drops(), *shares()])
def test_lines_of_tables(expected):
    assert expected in PAGE.splitlines(), expected


def slope(ball, law):
    """ε at 1 cm/s and at 1 m/s."""
    return [one(LAW, ball=ball, law=law, speed=speed)["restitution"] for speed in (0.01, 1)]


def test_slopes_are_opposite():
    for ball in one_ball.BALLS:
        (slow, fast), (same, later), (low, high) = (slope(ball, law) for law in one_ball.LAWS)
        assert slow > fast and low < high and abs(later - same) < 0.1 * (slow - fast)
    viscous, constant, peak = (slope("rubber", law) for law in one_ball.LAWS)
    assert f"falls from {viscous[0]:.3f} to {viscous[1]:.3f}" in WORDS
    assert f"within {abs(constant[1] - constant[0]) + 5e-4:.3f} for a constant Q" in WORDS
    assert f"rises from {peak[0]:.3f} to {peak[1]:.3f} above a peak" in WORDS


def test_frequencies_of_contacts():
    slow, fast = (one_ball.frequency("rubber", speed) for speed in (one_ball.SPEEDS[0], one_ball.SPEEDS[-1]))
    assert f"from {slow:.0f} to {fast:.0f} Hz" in WORDS and f"grows {10**3.5:.0f} times" in WORDS
    kept = [row["lost_fraction"] - row["dissipated"] for speed in (0.01, 3.1623)
            for row in having(LAW, ball="rubber", law="constant Q", speed=speed)]  # fmt: skip
    assert f"{percent(kept[0], 2)} of its energy at 1 cm/s, {percent(kept[1], 2)} at 3.16 m/s" in WORDS


def test_terms_per_decade():
    ten, five = (having(TERMS, terms=count) for count in (10, 5))
    assert f"keep 1/Q within {percent(max(row['ripple'] for row in ten), 2)}" in WORDS
    assert max(abs(change(row)) for row in ten) < 5e-4 and "by less than 0.05 %" in WORDS
    assert f"off by up to {percent(max(abs(change(row)) for row in five), 1)} in" in WORDS


def test_rebounds_of_rubber():
    for rebound, said in ((0.53, "0.25"), (0.03, "1.65")):
        assert f"{make.tangent_of_rebound(rebound):.2f}" == said and WORDS.count(said) >= 2
    assert max(row["rebound_error"] for row in RUBBER if row["height"] == 1) < 3e-3 and "right to 0.3 %" in WORDS
    off = [(row["rebound"] - row["rebound_of_constant_quality"], row) for row in RUBBER if row["height"] == 1]
    far = [row for each, row in off if abs(each) > 0.03]
    assert [(row["ball"], row["temperature"]) for row in far] == [("unhappy", 60)]
    happy, unhappy = (make.fitted(PROGRAM, name) for name in make.RUBBERS)
    speed = (2 * 9.81) ** 0.5 / (unhappy["relaxed"] / make.RUBBERS["unhappy"]) ** 0.5
    assert f"hits at {speed:.2f} of the speed of sound" in WORDS
    misfits = [round(100 * each[name]) for each in (unhappy, happy) for name in ("storage_misfit", "loss_misfit")]
    assert "{} % of E′ and {} % of E″ for the unhappy rubber, {} % and {} % for the happy one".format(*misfits) in WORDS
    percents = {(row["ball"], row["temperature"]): round(100 * row["rebound"]) for row in RUBBER if row["height"] == 1}
    assert "from {} % to {} % between 20 and 40 °C".format(*(percents["unhappy", each] for each in (20, 40))) in WORDS
    assert "from {} % to {} % between 20 and 10 °C".format(*(percents["happy", each] for each in (20, 10))) in WORDS


def test_film_of_a_laminate():
    piece, *films = LAMINATE
    between, top = films[:2], films[2:]
    heat = {percent(row["dissipated"], 2) for row in between}
    assert len(heat) == 1 and f"Heat is {heat.pop()} of the energy" in WORDS
    falls = [piece[name] - row[name] for name in ("restitution", "restitution_without_loss") for row in between]
    assert "lowers ε by {:.2f} to {:.2f}, without relaxation by {:.2f} to {:.2f}".format(*falls) in WORDS
    longer = [row["contact_time"] / piece["contact_time"] for row in top]
    assert "{:.0f} to {:.0f} times as long".format(*longer) in WORDS
    assert "ε rises to {:.2f} and {:.2f}".format(*(row["restitution"] for row in top)) in WORDS
    heat = {percent(row["dissipated"], 2) for row in top}
    assert len(heat) == 1 and f"though {heat.pop()} of the energy becomes heat" in WORDS


def test_quality_of_a_drop():
    for quality, said in ((100, "1 % too high at Q = 100"), (10, "11 % at Q = 10")):
        found = one(DROP, quality=quality)["quality_by_2.41"]
        assert f"{100 * (found / quality - 1):.0f} %" == said[: said.index("%") + 1] and said in WORDS
    assert f"{100 * (3.5443 / 2.4094 - 1):.0f} % too high" in WORDS


def test_tables_are_those_of_the_command():
    near = pytest.approx
    (row,) = one_ball.impacts(PROGRAM, "rubber", "one peak", [0.1])
    stored = one(LAW, ball="rubber", law="one peak", speed=0.1)
    assert float(row["restitution"]) == near(stored["restitution"], abs=2 * stored["restitution_error"])
    (row,) = make.of_terms(PROGRAM, 10, 5, [1e-3])
    stored = one(TERMS, quality=10, terms=5, speed=1e-3)
    assert float(row["lost_fraction"]) == near(stored["lost_fraction"], abs=2 * stored["lost_fraction_error"])
    (row,) = make.of_rubber(PROGRAM, "happy", 20, [1])
    stored = one(RUBBER, ball="happy", temperature=20, height=1)
    assert float(row["rebound"]) == near(stored["rebound"], abs=2 * stored["rebound_error"])
    row, stored = make.of_laminate(PROGRAM, "1.52 mm of PVB on top"), one(LAMINATE, plate="1.52 mm of PVB on top")
    assert float(row["restitution"]) == near(stored["restitution"], abs=2 * stored["restitution_error"])
    row, stored = make.of_drop(PROGRAM, 100), one(DROP, quality=100)
    assert float(row["lost_fraction"]) == near(stored["lost_fraction"], abs=2 * stored["lost_fraction_error"])


def test_channels():
    its = {ball: having(CHANNELS, ball=ball) for ball in make.DROPPED}
    first = {ball: next(row["speed"] for row in rows if row["radiation"] > row["material"])
             for ball, rows in its.items() if ball in ("bearing steel", "glass")}  # fmt: skip
    assert "from {:.2g} m/s on for steel and from {:.2g} m/s on for glass".format(*first.values()) in WORDS
    heat = {ball: [row["material"] for row in rows] for ball, rows in its.items()}
    assert all(0.0015 < each < 0.0025 for ball in first for each in heat[ball]) and "heat stays at 0.2 %" in WORDS
    slow = {percent(row["material"], 2) for row in its["POM"] if row["speed"] < 0.1}
    assert len(slow) == 1 and f"Heat is {slow.pop()} below 0.1 m/s" in WORDS
    assert f"heat falls to {percent(heat['POM'][-1], 2)} at 10 m/s" in WORDS
    assert max(row["radiation"] for row in its["rubber"]) < 1e-4 and "less than 0.01 %" in WORDS
    assert f"Ringing reaches {percent(its['rubber'][-1]['ringing'], 1)} at 10 m/s" in WORDS
    assert f"At 1 cm/s adhesion takes {percent(its['rubber'][0]['adhesion'], 2)}" in WORDS
    yields = next(row["speed"] for row in its["POM"] if row["yield"] > row["material"])
    assert f"From {yields:g} m/s on, yield takes more" in WORDS
