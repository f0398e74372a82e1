"""Spheres: --body sphere and --against sphere; --absolute."""

import json
import math

import pytest
from conftest import number, rows

pytestmark = pytest.mark.numbers

SPHERE = "restitution --body sphere --poisson 0.3"


@pytest.mark.parametrize("against", ["same", "sphere", "sphere,poisson=0.3,radius=1,young=1,density=1"])
def test_equal_spheres_are_the_wall_at_half_the_speed(stoss, against):
    (pair,) = stoss.data(f"{SPHERE} --speed 0.2 --against", against)
    (wall,) = stoss.data(f"{SPHERE} --speed 0.1")
    for name in ("restitution", "lost_fraction", "contact_time"):
        assert number(pair, name) == pytest.approx(number(wall, name), rel=1e-11)
    for name in ("lost_to_first", "lost_to_second"):
        assert number(pair, name) == pytest.approx(number(wall, "lost_to_first") / 2, rel=1e-9)


def test_who_is_first_does_not_matter(stoss):
    (here,) = stoss.data(f"{SPHERE} --speed 0.2 --against sphere,radius=2,young=4,poisson=0.2,density=3")
    there_speed = 0.2 / math.sqrt(4 / 3)
    (there,) = stoss.data(
        f"restitution --body sphere --poisson 0.2 --speed {there_speed!r}",
        f"--against sphere,poisson=0.3,radius=0.5,young=0.25,density={1 / 3!r}",
    )
    errors = number(here, "lost_fraction_error") + number(there, "lost_fraction_error")
    assert abs(number(here, "lost_fraction") - number(there, "lost_fraction")) <= errors
    assert number(here, "lost_to_first") == pytest.approx(number(there, "lost_to_second"), abs=1e-4)
    assert number(here, "lost_to_second") == pytest.approx(number(there, "lost_to_first"), abs=1e-4)
    lost = number(here, "lost_to_first") + number(here, "lost_to_second")
    assert lost == pytest.approx(number(here, "lost_fraction"), rel=1e-12)


def test_impact_with_its_ledger_and_trajectory(stoss, tmp_path):
    path = tmp_path / "t.csv"
    words = f"impact --body sphere --poisson 0.3 --speed 0.1 --cutoff 25 --trajectory {path}"
    document = json.loads(stoss.run(words, "--format json").stdout)
    (record,) = document["records"]
    assert record["modes"] == len(document["modes"]) == 268
    assert record["lost_fraction"] == pytest.approx(0.017346412, rel=5e-3)
    shares = [record[name] for name in ("translation", "vibration", "unresolved", "energy_error")]
    assert sum(shares) == pytest.approx(1, abs=1e-12)
    assert document["units"]["max_force"] == "mc^2/R"
    assert document["inputs"]["first"] == {"kind": "sphere", "poisson": 0.3}
    instants = rows(path.read_text())
    assert "force[mc^2/R]" in instants[0]
    impulse = sum(number(row, "force") for row in instants) * record["step"]
    assert impulse == pytest.approx(0.1 * (1 + record["restitution"]), rel=1e-6)
    assert stoss.run(words).stdout.splitlines()[0].split() == ["poisson", "0.3"]


def test_exponential_wall_tends_to_the_hard_one(stoss):
    lost = []
    for hardness in (300, 1000, 3000):
        (row,) = stoss.data(
            f"impact --body sphere --poisson 0.3 --speed 0.1 --against exponential,hardness={hardness}"
        )
        lost.append(abs(number(row, "lost_fraction") - 0.017346412))
        assert abs(number(row, "energy_error")) < 1e-4
    assert lost[0] > 2 * lost[1] and lost[1] > lost[2] and lost[2] < 5e-4


def test_absolute_is_enough_where_the_loss_is_small(stoss):
    slow = f"{SPHERE} --speed 1e-4"
    (default,) = stoss.data(slow)
    assert 1e-3 * number(default, "lost_fraction") < number(default, "lost_fraction_error") <= 1e-6
    assert default["converged"] == "true"
    (loose,) = stoss.data(slow, "--absolute 1e-5")
    assert int(loose["runs"]) <= int(default["runs"]) and number(loose, "lost_fraction_error") <= 1e-5
    (strict,) = stoss.data(slow, "--absolute 0 --tolerance 1e-2")
    assert strict["converged"] == "true"
    assert number(strict, "lost_fraction_error") <= 1e-2 * number(strict, "lost_fraction")
    result = stoss.run(slow, "--absolute 0 --tolerance 1e-9")
    assert result.returncode == 1 and "!" in result.stdout


def test_a_file_of_another_absolute_is_not_resumed(stoss, tmp_path):
    path = tmp_path / "curve.csv"
    job = f"{SPHERE} --speed 0.1,0.2"
    assert stoss.run(job, "--resume", str(path)).returncode == 0
    whole = path.read_text()
    assert "# absolute: 1e-06\n" in whole and '# first: {"kind":"sphere","poisson":0.3}\n' in whole
    result = stoss.run(job, "--absolute 1e-4 --resume", str(path))
    assert (result.returncode, path.read_text()) == (3, whole)
    assert result.stderr.startswith("stoss: error: absolute: got 0.0001, allowed 1e-06 as in ")
    path.write_text("".join(whole.splitlines(True)[:-1]))
    assert stoss.run(job, "--resume", str(path)).returncode == 0
    assert path.read_text() == whole
    other = stoss.run("restitution --body disk --poisson 0.3 --speed 0.1,0.2 --resume", str(path))
    assert other.returncode == 3 and 'first: got {"kind":"disk"' in other.stderr


@pytest.mark.parametrize("poisson", ["-0.95", "0.4999"])
def test_range_of_the_poisson_number(stoss, poisson):
    assert stoss.run(f"modes --body sphere --poisson {poisson} --cutoff 5").returncode == 0
    (row,) = stoss.data(f"restitution --body sphere --poisson {poisson} --speed 0.2 --tolerance 0.1")
    assert 0 < number(row, "restitution") < 1


REFUSED = [
    ("--poisson 0.5", "poisson", "0.5, allowed -0.95 to 0.4999"),
    ("--poisson -1", "poisson", "-1"),
    ("--poisson 0.3 --plane strain", "plane", "--body sphere, allowed only with --body disk"),
    ("--poisson 0.3 --length 1", "length", "--body sphere, allowed only with --body rod"),
    ("--poisson 0.3 --area 1", "area", "--body sphere, allowed only with --body rod"),
    ("--poisson 0.3 --against disk", "against", "a disk meets disks, half-planes and strips; a sphere spheres"),
    ("--poisson 0.3 --against rod", "against", "a sphere spheres"),
    ("--poisson 0.3 --against sphere,length=2", "against", "allowed poisson, radius, young, density, loss_time, yield"),
    ("--poisson 0.3 --against spere", "against", "did you mean sphere?"),
    ("--poisson 0.3 --against sphere,radius=-2", "against radius", "-2"),
    ("--poisson 0.3 --against sphere,poisson=0.5", "against poisson", "0.5"),
    ("--poisson 0.3 --against sphere,radius=1e4", "radius ratio", "10000"),
    ("--poisson 0.3 --against sphere,yield=1e9", "against", "yield without a material"),
    ("--poisson 0.3 --yield 1e9", "yield", "without a material"),
]


@pytest.mark.parametrize("arguments, name, said", REFUSED)
@pytest.mark.parametrize("command", ["restitution", "impact"])
def test_refusals(stoss, command, arguments, name, said):
    result = stoss.run(f"{command} --body sphere --speed 0.1", arguments)
    assert (result.returncode, result.stdout) == (3, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {name}: got ") and said in line and "allowed" in line


@pytest.mark.parametrize(
    "arguments, name, said",
    [
        ("--body disk --poisson 0.3 --against sphere", "against", "for a disk, allowed wall, same, disk, half-plane or strip"),
        ("--body disk --poisson 0.3 --yield 1e9", "yield", "--body disk, allowed only with --body sphere"),
        ("--body rod --against sphere", "against", "for a rod, allowed wall, same or rod"),
        ("--body sphere --poisson 0.3 --against exponential", "against", "stoss impact meets an exponential wall"),
        ("--body sphere --poisson 0.3 --absolute -1", "absolute", "-1"),
        ("--body sphere --poisson 0.3 --absolute 0.6", "absolute", "0.6"),
        ("--body disk --poisson 0.3 --absolute nan", "absolute", "nan"),
    ],
)
def test_what_does_not_go_together(stoss, arguments, name, said):
    result = stoss.run("restitution --speed 0.1", arguments)
    assert (result.returncode, result.stdout) == (3, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {name}: got ") and said in line and "allowed" in line


def test_a_sphere_needs_its_poisson_number(stoss):
    result = stoss.run("restitution --body sphere --speed 0.1")
    assert result.returncode == 2 and "--poisson" in result.stderr
