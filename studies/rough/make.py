"""Rough and coated balls: make.py STOSS FOLDER writes the tables of docs/results/rough
(docs/understand/findings/rough.md)."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1] / "relaxing"))
from commands import listed, run, write  # noqa: E402 (beside the other studies)

PAGE = "rough"
LENGTH = 0.45  # u₀ over the rms height of the asperities


def lost(row):
    return {"lost_fraction": f"{float(row['lost_fraction']):.6g}",
            "lost_fraction_error": f"{float(row['lost_fraction_error']):.1e}"}  # fmt: skip


# Steel balls without loss in the material

BALL = "restitution --body sphere --material 'bearing steel' --radius 0.005 --loss-time 0"
PARTNERS = {"wall": "wall", "block": "half-space,material='bearing steel',loss_time=0"}
HEIGHTS = (0.0, 24e-9, 272e-9, 1e-6)  # rms, m
SPEEDS = tuple(10 ** (k / 2 - 3) for k in range(7))  # m/s
SMALLEST = {"wall": 1e-9, "block": 1e-7}  # absolute error of 1 − ε² that is good enough


def of_steel(program, partner, height, speeds=SPEEDS):
    job = f"{BALL} --against {PARTNERS[partner]} --roughness {height:g} --speed {listed(speeds)} --tolerance 0.01"
    for row in run(program, f"{job} --absolute {SMALLEST[partner]}"):
        if row["lost_fraction"] != "nan":  # a contact on a block longer than the waves that are computed
            yield {"partner": partner, "roughness[m]": f"{height:g}", "speed[m/s]": f"{float(row['speed_si']):.5g}",
                   **lost(row), "contact_time[s]": f"{float(row['contact_time_si']):.4g}",
                   "compression[m]": "" if height else f"{float(row['max_compression_si']):.4g}",
                   "yield_speed[m/s]": f"{float(row['yield_speed_si']):.4g}"}  # fmt: skip


# Short asperities at a rigid wall

BODIES = (("sphere", 0.3), ("sphere", 0.45), ("disk", 0.33))
SCALED = (0.01, 0.03, 0.1, 0.3, 1.0)  # u₀c/Rv
AT = (1e-4, 1e-3, 1e-2, 0.1)  # c


def of_short(program, body, poisson, speed, scaled=SCALED):
    job = f"restitution --body {body} --poisson {poisson} --speed {speed:g} --tolerance 1e-3 --absolute 0"
    (smooth,) = run(program, job)
    loss, compression = float(smooth["lost_fraction"]), float(smooth["max_compression"])
    for each in scaled:
        (row,) = run(program, f"{job} --u0 {each * speed:.9g}")
        yield {"body": body, "poisson": poisson, "speed[c]": f"{speed:g}", "u0[Rv/c]": each,
               "u0_over_compression": f"{each * speed / compression:.4g}", "smooth": f"{loss:.6g}", **lost(row),
               "saved": f"{1 - float(row['lost_fraction']) / loss:.4g}"}  # fmt: skip


# The extrapolation of the paper

HARDNESSES = (250, 1000 / 3, 500, 1000, 2000, 4000)  # αR
DISKS = (0.02, 0.1)  # c


def of_hardness(program, speed, hardness):
    """Infinite: the hard wall."""
    wall = f"exponential,hardness={hardness:.12g}" if hardness < float("inf") else "wall"
    job = f"restitution --body disk --poisson 0.33 --speed {speed} --against {wall} --tolerance 3e-4"
    (row,) = run(program, job)
    return {"speed[c]": speed, "hardness[1/R]": f"{hardness:.6g}", **lost(row)}


# Coats

GLASS = "restitution --body sphere --material glass --radius 0.005 --loss-time 0 --tolerance 0.01"
RUBBER, PAINT = "coat_young=3e6,coat_poisson=0.45", "coat_young=3e9,coat_poisson=0.35"
FOILS = (3e-5, 1e-4, 3e-4, 1e-3)  # m, at 0.03 m/s
PAINTS = (0.0, 3e-6, 1e-5, 3e-5)  # m, at 0.1 m/s


def of_coat(program, coat, thickness, quality):
    """On a block; rubber in place of it on the ball at a rigid wall, as a block of glass is to rubber."""
    if coat == "rubber":
        keys = f"--coat {thickness:g} --coat-young 3e6 --coat-poisson 0.45"
        job = f"{GLASS} --speed 0.03 {keys}" + (f" --coat-quality {quality}" if quality else "")
    else:
        keys = f",coat={thickness:g},{PAINT}" + (f",coat_quality={quality}" if quality else "") if thickness else ""
        job = f"{GLASS} --speed 0.1 --against half-space,material=glass,loss_time=0{keys}"
    (row,) = run(program, job)
    return {"coat": coat, "thickness[m]": f"{thickness:g}", "quality": quality,
            "restitution": f"{float(row['restitution']):.5f}", **lost(row),
            "dissipated": f"{float(row['dissipated']):.5g}", "contact_time[s]": f"{float(row['contact_time_si']):.4g}",
            "compression[m]": f"{float(row['max_compression_si']):.4g}"}  # fmt: skip


def main(program, folder):
    folder = Path(folder)
    folder.mkdir(exist_ok=True)
    about = "Glass balls, R = 5 mm: rubber at a rigid wall, 0.03 m/s; paint on a block of glass, 0.1 m/s"
    kinds = (("rubber", FOILS, 5), ("paint", PAINTS, 50))
    jobs = [(coat, each, quality) for coat, sizes, best in kinds for each in sizes for quality in (best, 0)]
    rows = (of_coat(program, *job) for job in jobs)
    write(folder, "coats", about, rows, PAGE)
    about = "Disks with nu = 0.33 at exponential walls and at the hard wall"
    rows = (of_hardness(program, speed, each) for speed in DISKS for each in (*HARDNESSES, float("inf")))
    write(folder, "extrapolation", about, rows, PAGE)
    rows = (row for body, poisson in BODIES for speed in AT for row in of_short(program, body, poisson, speed))
    write(folder, "short", "Bodies with short asperities at a rigid wall", rows, PAGE)
    rows = (row for partner in PARTNERS for height in HEIGHTS for row in of_steel(program, partner, height))
    write(folder, "steel", "Balls of bearing steel, R = 5 mm, without loss in the material", rows, PAGE)


if __name__ == "__main__":
    main(*sys.argv[1:])
