"""Prints the table of docs/understand/measured.md: measurements beside what stoss predicts, nothing fitted.

compare.py [COMMAND]: COMMAND is the stoss command, build/release/cli/stoss unless given.
"""

import csv
import json
import subprocess
import sys
from pathlib import Path

DATA = Path(__file__).parent / "data"


def points(name):
    """Rows of a set, as dictionaries."""
    lines = [line for line in (DATA / f"{name}.csv").read_text().splitlines() if not line.startswith("#")]
    return list(csv.DictReader(lines))


def predicted(command, material, radius, against, speeds):
    words = [command, "predict", "--body", "sphere", "--material", material, "--radius", str(radius)]
    words += ["--against", against, "--speed", ",".join(map(str, speeds)), "--format", "json", "--quiet"]
    return json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)["records"]


def losses(measured, row):
    """Measured over predicted loss of energy."""
    return f"{(1 - measured**2) / (1 - row['restitution'] ** 2):.2g}"


def rounded(value):
    """To one digit, small numbers with a power of ten."""
    digits, power = f"{value:.0e}".split("e")
    return f"{value:.1g}" if value == 0 or int(power) > -4 else f"{digits}·10⁻{'⁰¹²³⁴⁵⁶⁷⁸⁹'[-int(power)]}"


def said(row):
    uncertain = [rounded(row[name]) for name in ("restitution_error", "by_models", "by_constants")]
    return f"{row['restitution']:.3f}", *uncertain, row["dominant"]


def law(command, name, what, radius, chosen):
    """A law of ice on a block, at some of its speeds."""
    rows = [row for row in points(name) if float(row["speed_m_s"]) in chosen]
    found = predicted(command, "ice", radius, "half-space,material=ice", [float(row["speed_m_s"]) for row in rows])
    for measured, row in zip(rows, found):
        value = float(measured["restitution"])
        yield what, f"{1e3 * row['speed']:g} mm/s", f"{value:.2f}, law", *said(row), losses(value, row)


def beads(command):
    """Beads of glass and of HDPE. Their speed is not given; it decides little of what is predicted."""
    met = {"glass bead on glass bead": ("glass", "same"), "glass bead on acrylic": ("glass", "half-space,material=PMMA"),
           "glass bead on HDPE bead": ("glass", "sphere,material=PE,radius=0.00158"),
           "HDPE bead on HDPE bead": ("PE", "same")}  # fmt: skip
    for measured in points("lamarche_2022_beads"):
        value, error = float(measured["restitution"]), float(measured["restitution_error"])
        (row,) = predicted(command, met[measured["pair"]][0], 0.00155, met[measured["pair"]][1], [1.0])
        yield (f"{measured['pair']}, Ø 3.1 mm (LaMarche and others 2022)", "not given", f"{value:.3f} ± {error:.3f}", *said(row),
               losses(value, row))  # fmt: skip


def lines(command):
    block = "half-space,material="
    (row,) = predicted(command, "alumina", 0.0025, block + "glass", [3.9])
    yield "alumina, Ø 5 mm, on thick glass (Kharaz and others 2001)", "3.9 m/s", "0.98", *said(row), losses(0.98, row)
    chosen = (1e-3, 1e-2)
    yield from law(command, "hatzes_1988_frosted_law", "frosted ice, Ø 50 mm, on ice, 85 to 145 K (Hatzes and others 1988)",
                   0.025, chosen)  # fmt: skip
    yield from law(command, "hatzes_1988_compacted_law", "the same, compacted", 0.025, chosen)
    (ice,) = points("heisselmann_2010_ice")
    (row,) = predicted(command, "ice", 0.0075, "same", [0.14])
    low, high, mean = (ice[f"restitution_{each}"] for each in ("min", "max", "mean"))
    yield ("rough ice, Ø 15 mm, on its like (Heißelmann and others 2010)", "0.06 to 0.22 m/s", f"{low} to {high}, mean {mean}",
           *said(row), losses(float(mean), row))  # fmt: skip
    for each in points("deckers_2016_ice"):
        value = float(each["restitution_plateau"])
        (row,) = predicted(command, "ice", float(each["diameter_m"]) / 2, block + "ice", [1.0])
        yield (f"ice, Ø {1e3 * float(each['diameter_m']):g} mm, on ice, 256 K (Deckers and Teiser 2016, quoted)", "plateau",
               f"{value}", *said(row), losses(value, row))  # fmt: skip
    (granite,) = points("durda_2011_granite")
    (row,) = predicted(command, "granite", 0.5, "same", [1.0])
    value = float(granite["restitution"])
    yield ("granite, Ø 1 m, on its like (Durda and others 2011)", "1 m/s", f"{value} ± {granite['restitution_error']}",
           *said(row), losses(value, row))  # fmt: skip
    yield from beads(command)
    (phenolic,) = points("phenolic_on_phenolic")
    value = float(phenolic["restitution"])
    (row,) = predicted(command, "phenolic resin", 0.0286, "same", [1.0])
    yield ("pool balls of phenolic resin, Ø 57 mm (Alciatore, quoted)", "not given", f"{value} ± {phenolic['restitution_error']}",
           *said(row), losses(value, row))  # fmt: skip
    (sticks,) = points("gundlach_2014_sticking")
    (row,) = predicted(command, "ice", 1.5e-6, "same", [float(sticks["sticking_speed_m_s"])])
    yield ("ice, R = 1.5 µm, on aggregates of it (Gundlach and Blum 2014)", "9.6 m/s", "0: it sticks below", *said(row), "–")


if __name__ == "__main__":
    command = sys.argv[1] if len(sys.argv) > 1 else str(Path(__file__).parents[2] / "build/release/cli/stoss")
    for cells in lines(command):
        print("| " + " | ".join(cells) + " |")
