"""Bodies that meet bodies: --body and --against of stoss restitution and stoss impact."""

import json
import math
import subprocess

import pytest
from conftest import number, rows

pytestmark = pytest.mark.numbers

DISK = "restitution --body disk --poisson 0.33 --speed 0.2"
STEEL = "--body disk --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01"
GLASS = "poisson=0.22,young=7e10,density=2500,radius=0.02"
PAIR_IMPACT = "impact --body disk --poisson 0.33 --speed 0.2 --cutoff 25 --against disk,radius=2"


@pytest.mark.parametrize(
    "against, known, uncertainty",
    [("same", 0.103067, 2.1e-5), ("disk,radius=2", 0.368291, 1.7e-5), ("disk,young=4", 0.233945, 1.2e-5)],
)
def test_disks_agree_with_finite_elements(stoss, against, known, uncertainty):
    (row,) = stoss.data(DISK, "--against", against)
    assert abs(number(row, "lost_fraction") - known) <= number(row, "lost_fraction_error") + uncertainty


# Finite elements of a disk on a half-plane: 0.67529(1).
def test_a_disk_of_thousand_times_the_radius_is_a_half_plane(stoss):
    (row,) = stoss.data("restitution --body disk --poisson 0.33 --speed 0.1 --against disk,radius=1000")
    assert abs(number(row, "lost_fraction") - 0.67529) <= number(row, "lost_fraction_error") + 1e-5
    lost = number(row, "lost_to_first") + number(row, "lost_to_second")
    assert lost == pytest.approx(number(row, "lost_fraction"), rel=1e-12)


@pytest.mark.parametrize("against", ["same", "disk", "disk,poisson=0.33,radius=1,young=1,density=1"])
def test_equal_disks_are_the_wall_at_half_the_speed(stoss, against):
    (pair,) = stoss.data(DISK, "--against", against)
    (wall,) = stoss.data("restitution --body disk --poisson 0.33 --speed 0.1 --against wall")
    for name in ("restitution", "lost_fraction", "contact_time"):
        assert number(pair, name) == pytest.approx(number(wall, name), rel=1e-12)
    half = number(wall, "lost_to_first") / 2
    assert number(pair, "lost_to_first") == pytest.approx(half, rel=1e-10)
    assert number(pair, "lost_to_second") == pytest.approx(half, rel=1e-10)
    assert number(wall, "lost_to_second") == 0


def test_rods_tend_to_their_exact_answer(stoss):
    # Transit times 10 and 25, impedances 3 and 1, in units of the first: E = rho = 1 for both.
    against = "--against rod,length=2.5,area=0.3333333333333333"
    (row,) = stoss.data("restitution --body rod --speed 0.1", against, "--tolerance 2e-2")
    assert abs(number(row, "restitution") - 0.7875) <= number(row, "restitution_error")
    errors = []
    for cutoff in (100, 400, 1600):
        (row,) = stoss.data(f"impact --body rod --speed 0.1 --cutoff {cutoff}", against)
        errors.append(abs(number(row, "restitution") - 0.7875))
    assert errors[2] < errors[0] / 8 and errors[2] < 1e-3
    assert "max_force[EA]" in row and "contact_time[L/c]" in row and "poisson" not in row


def test_who_is_first_does_not_matter(stoss):
    (here,) = stoss.data(DISK, "--against disk,poisson=0.2,radius=0.5,young=2,density=3")
    there_speed = 0.2 / math.sqrt(2 / 3)
    (there,) = stoss.data(
        f"restitution --body disk --poisson 0.2 --speed {there_speed!r}",
        f"--against disk,poisson=0.33,radius=2,young=0.5,density={1 / 3!r}",
    )
    assert abs(number(here, "restitution") - number(there, "restitution")) <= number(here, "restitution_error")
    assert number(here, "lost_to_first") == pytest.approx(number(there, "lost_to_second"), abs=1e-4)
    assert number(here, "lost_to_second") == pytest.approx(number(there, "lost_to_first"), abs=1e-4)


@pytest.mark.parametrize("plane", ["stress", "strain"])
def test_two_materials_are_their_ratios(stoss, plane):
    (si,) = stoss.data(f"restitution {STEEL} --speed 20 --plane {plane} --against disk,{GLASS}")

    def in_plane(nu):
        return nu if plane == "stress" else nu / (1 - nu)

    def modulus(young, nu):
        return young if plane == "stress" else young / (1 - nu**2)

    young, c = modulus(7e10, 0.22) / modulus(2.1e11, 0.3), math.sqrt(modulus(2.1e11, 0.3) / 7850)
    against = f"disk,poisson={in_plane(0.22)!r},radius=2,young={young!r},density={2500 / 7850!r}"
    (ratios,) = stoss.data(f"restitution --body disk --poisson {in_plane(0.3)!r} --speed {20 / c!r} --against {against}")
    assert number(si, "restitution") == pytest.approx(number(ratios, "restitution"), abs=1e-11)
    assert float(si["speed_si[m/s]"]) == pytest.approx(20)
    scale = {"contact_time_si[s]": 0.01 / c, "max_compression_si[m]": 0.01}
    for name, unit in scale.items():
        assert float(si[name]) == pytest.approx(number(ratios, name.partition("_si")[0]) * unit, rel=1e-10)


def test_same_of_a_material(stoss):
    (same,) = stoss.data(f"restitution {STEEL} --speed 20 --against same")
    (disk,) = stoss.data(f"restitution {STEEL} --speed 20 --against disk,young=2.1e11,density=7850,radius=0.01")
    assert number(same, "restitution") == pytest.approx(number(disk, "restitution"), abs=1e-12)


def test_poisson_number_of_the_second_follows_the_first(stoss):
    table = stoss.data("restitution --body disk --poisson 0.2,0.33 --speed 0.2 --against disk,radius=2")
    (alone,) = stoss.data("restitution --body disk --poisson 0.2 --speed 0.2 --against disk,radius=2,poisson=0.2")
    assert table[0] == alone and number(table[1], "restitution") < number(table[0], "restitution")


def test_who_takes_the_loss(stoss):
    (record,) = json.loads(stoss.run(DISK, "--against disk,radius=2 --format json").stdout)["records"]
    ledger = record["ledger"]
    lost = record["lost_to_first"] + record["lost_to_second"]
    assert lost == pytest.approx(record["lost_fraction"], rel=1e-12)
    assert ledger["vibration"] < lost < ledger["vibration"] + ledger["unresolved"]  # of which some would be given back
    assert record["lost_to_second"] > 5 * record["lost_to_first"]


def test_impact_says_which_body_a_mode_is_of(stoss):
    document = json.loads(stoss.run(PAIR_IMPACT, "--format json").stdout)
    (record,) = document["records"]
    modes = document["modes"]
    assert {mode["body"] for mode in modes} == {"first", "second"} and len(modes) == record["modes"]
    for body in ("first", "second"):
        after = sum(mode["after"] for mode in modes if mode["body"] == body)
        assert 0 <= record[f"lost_to_{body}"] - after <= record["unresolved"] * (1 + 1e-12)
    lines = stoss.run(PAIR_IMPACT).stdout.splitlines()
    assert [line.split()[0] for line in lines[-11:-9]] == ["body", "second"]


def test_trajectory_and_static_tail_of_a_pair(stoss, tmp_path):
    path = tmp_path / "t.csv"
    (record,) = stoss.data(PAIR_IMPACT, f"--tail static --step 0.005 --every 5 --trajectory {path}")
    assert record["unresolved"] == "0"
    instants = rows(path.read_text())
    assert number(instants[0], "velocity") == 0.2
    assert number(instants[-1], "velocity") == pytest.approx(-0.2 * number(record, "restitution"), rel=1e-12)
    assert '# against: {"kind":"disk",' in path.read_text() and '"radius":2.0' in path.read_text()


def test_inputs_are_the_document_of_the_encounter(stoss):
    def inputs(*words):
        return json.loads(stoss.run(*words, "--format json").stdout)["inputs"]

    pair = inputs(DISK, "--against disk,radius=0.5,density=3")
    assert pair["first"]["kind"] == "disk" and pair["against"] == {"kind": "disk", "radius": 0.5, "density": 3}
    steel = inputs(f"restitution {STEEL} --speed 20 --against disk,{GLASS}")
    assert steel["against"]["radius"] == 0.02 and steel["against"]["material"]["young"] == 7e10
    assert steel["speed[m/s]"] == 20
    rod = inputs("impact --body rod --speed 0.1 --against rod,length=2")
    assert rod["first"] == {"kind": "rod"} and rod["against"] == {"kind": "rod", "length": 2}
    soft = inputs("impact --body disk --poisson 0.3 --speed 0.1 --cutoff 12.5 --against exponential,hardness=300")
    assert soft["against"] == {"kind": "exponential", "hardness": 300}
    assert (soft["speed"], soft["cutoff"]) == (0.1, 12.5)


def test_spaces_around_keys_and_numbers_do_not_count(stoss):
    command = [stoss.path, *DISK.split(), "--against", " disk , radius = 2 ", "--format", "csv"]
    text = subprocess.run(command, capture_output=True, text=True).stdout
    assert rows(text) == stoss.data(DISK, "--against disk,radius=2")
