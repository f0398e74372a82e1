"""docs/reference/laws.md: its table is docs/results/laws.csv, and what it says follows from it."""

import re

from conftest import line, page, power, table

PAGE, WORDS = page("docs/reference/laws.md")
ROWS = {(row["ball"], row["law"], row["program"]): row for row in table("docs/results/laws.csv")}
PROGRAMS = {"": "", "liggghts": ", LIGGGHTS", "yade": ", Yade"}


def both(row, name, shown):
    values = row[f"{name}_maximum"], row[f"{name}_rms"]
    return "–" if values[0] == "" else "{} ({})".format(*map(shown, values))


def test_the_table_is_the_file():
    glass = {key: row for key, row in ROWS.items() if key[0] == "glass"}
    for (ball, law, program), row in glass.items():
        epsilon = both(row, "restitution", lambda value: power(value, 2))
        time = both(row, "contact_time", lambda value: f"{100 * value:.2g} %")
        along = both(row, "tangential_restitution", lambda value: f"{value:.2g}")
        ratio = f"{row['tangential_ratio']:.2f}" if row["tangential_ratio"] else "–"
        assert line(ball, f"`{law}`{PROGRAMS[program]}", epsilon, time, along, ratio) in PAGE
    assert PAGE.count("\n| glass") == len(glass) == len(ROWS) // 2 == 9


def test_what_is_said_of_the_laws():
    def of(law, name, each="maximum"):
        return {ball: ROWS[ball, law, ""][f"{name}_{each}"] for ball in ("bearing steel", "glass")}

    assert "within 4·10⁻⁶" in WORDS and max(of("tsuji", "restitution").values()) < 4e-6
    assert "it is 5·10⁻⁴ off here" in WORDS and round(max(of("viscoelastic", "restitution").values()), 4) == 5e-4
    for law in ("tsuji", "viscoelastic"):
        assert 0.0042 < max(of(law, "contact_time").values()) < 0.0055
    springs = [ROWS[key] for key in ROWS if ROWS[key]["tangential_ratio"] != "" and not key[2]]
    low, high = map(float, re.search(r"best κ is ([\d.]+) to ([\d.]+)", WORDS).groups())
    assert all(low - 0.01 < row["tangential_ratio"] < high for row in springs)
    low, high = map(float, re.search(r"leaves errors of ([\d.]+) to ([\d.]+)\.", WORDS).groups())
    assert all(low - 0.005 < row["tangential_restitution_maximum"] < high for row in springs)
    for ball in ("bearing steel", "glass"):
        others = [row["restitution_maximum"] for key, row in ROWS.items() if key[0] == ball and key[1] != "thornton"]
        assert ROWS[ball, "thornton", ""]["restitution_maximum"] > max(others)
