"""Half-spaces and half-planes as --against, and --rigid-body."""

import json
import math

import pytest
from conftest import number, resume, rows

pytestmark = pytest.mark.numbers

BODIES = {"sphere": ("--body sphere --poisson 0.3", "half-space"), "disk": ("--body disk --poisson 0.33", "half-plane")}
STEEL = "--body sphere --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.005"
GLASS = "half-space,poisson=0.23,young=7e10,density=2500"


@pytest.mark.parametrize("kind", BODIES)
def test_a_hard_half_space_is_a_rigid_wall(stoss, kind):
    body, against = BODIES[kind]
    (wall,) = stoss.data("restitution --speed 0.1", body)
    (hard,) = stoss.data("restitution --speed 0.1", body, f"--against {against},young=1e5,density=1e5")
    errors = number(wall, "lost_fraction_error") + number(hard, "lost_fraction_error")
    assert abs(number(wall, "lost_fraction") - number(hard, "lost_fraction")) <= errors + 1e-4
    assert number(hard, "lost_to_second") < 1e-4


# A half-space that deforms much more than the sphere makes the sphere rigid.
def test_a_hard_sphere_is_a_rigid_one(stoss):
    body, against = BODIES["sphere"]
    (soft,) = stoss.data("restitution --speed 3e-3", body, f"--against {against},young=1e-3")
    speed = 3e-3 / math.sqrt(1e-3)  # of the same material as the half-space
    (rigid,) = stoss.data(f"restitution --rigid-body --speed {speed!r}", body, f"--against {against}")
    assert number(soft, "lost_fraction") == pytest.approx(number(rigid, "lost_fraction"), rel=5e-3)


# It is the second there, and the first here.
def test_a_rigid_sphere_meets_an_elastic_one(stoss):
    body, _ = BODIES["sphere"]
    (rigid,) = stoss.data("restitution --rigid-body --speed 0.1", body, "--against sphere")
    (hard,) = stoss.data("restitution --speed 0.1", body, "--against sphere,young=1e3")
    assert number(rigid, "lost_fraction") == pytest.approx(number(hard, "lost_fraction"), rel=1e-2)
    assert number(rigid, "lost_to_first") == 0
    assert number(rigid, "lost_to_second") == pytest.approx(number(hard, "lost_to_first"), rel=1e-2)


def test_si_is_the_ratios(stoss):
    (si,) = stoss.data("restitution --speed 1 --against", GLASS, STEEL)
    c = math.sqrt(2.1e11 / 7850)
    ratios = f"half-space,poisson=0.23,young={7e10 / 2.1e11!r},density={2500 / 7850!r}"
    (own,) = stoss.data(f"restitution --body sphere --poisson 0.3 --speed {1 / c!r} --against {ratios}")
    for name in ("restitution", "lost_fraction", "lost_to_second"):
        assert number(si, name) == pytest.approx(number(own, name), rel=1e-9)
    # Modes and Lamb's kernel give 0.0085314(75) and 46.0 us.
    assert abs(number(si, "lost_fraction") - 0.0085314) <= 7.5e-6 + number(si, "lost_fraction_error")
    assert float(si["contact_time_si[s]"]) == pytest.approx(46.0e-6, rel=3e-3)


@pytest.mark.parametrize("plane", ["stress", "strain"])
def test_si_is_the_ratios_in_a_plane(stoss, plane):
    disk = f"--body disk --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01 --plane {plane}"
    (si,) = stoss.data("restitution --speed 10", disk, "--against half-plane,poisson=0.23,young=7e10,density=2500")
    strain = plane == "strain"
    one, other = (e / (1 - nu**2) if strain else e for e, nu in ((2.1e11, 0.3), (7e10, 0.23)))
    nu1, nu2 = (nu / (1 - nu) if strain else nu for nu in (0.3, 0.23))
    ratios = f"half-plane,poisson={nu2!r},young={other / one!r},density={2500 / 7850!r}"
    speed = 10 / math.sqrt(one / 7850)
    (own,) = stoss.data(f"restitution --body disk --poisson {nu1!r} --speed {speed!r} --against {ratios}")
    assert number(si, "restitution") == pytest.approx(number(own, "restitution"), rel=1e-9)


def test_without_keys_it_is_like_the_first(stoss):
    for kind, (body, against) in BODIES.items():
        poisson = body.split()[-1]
        given = f"{against},poisson={poisson},young=1,density=1"
        one = stoss.run("restitution --speed 0.1", body, "--against", against).stdout
        assert one == stoss.run("restitution --speed 0.1", body, "--against", given).stdout, kind


def test_impact_with_its_ledger_and_trajectory(stoss, tmp_path):
    path = tmp_path / "t.csv"
    command = f"impact {BODIES['sphere'][0]} --speed 0.01 --cutoff 12 --against half-space"
    document = json.loads(stoss.run(command, f"--format json --trajectory {path}").stdout)
    (record,) = document["records"]
    assert record["lost_fraction"] == pytest.approx(0.078692, rel=5e-3)
    assert document["inputs"]["against"] == {"kind": "half-space"}
    shares = [record[name] for name in ("translation", "vibration", "unresolved", "energy_error")]
    assert sum(shares) == pytest.approx(1, abs=1e-12)
    waves = [mode for mode in document["modes"] if mode["body"] == "second"]
    assert sum(mode["after"] for mode in waves) == pytest.approx(record["lost_to_second"], rel=1e-2)
    instants = rows(path.read_text())
    impulse = sum(number(row, "force") for row in instants) * record["step"]
    assert impulse == pytest.approx(0.01 * (1 + record["restitution"]), rel=1e-6)
    table = stoss.run(command).stdout
    assert "most energetic modes" in table and "second" not in table.partition("most energetic modes")[2]


# The half-space is made for contacts as long as that of this speed.
@pytest.mark.parametrize("speed", ["1e-5", "1e-3", "0.3"])
def test_impact_lasts_as_long_as_its_speed_needs(stoss, speed):
    words = f"{BODIES['sphere'][0]} --speed {speed} --against half-space"
    (row,) = stoss.data("impact --cutoff 12", words)
    (known,) = stoss.data("restitution", words)
    assert number(row, "lost_fraction") == pytest.approx(number(known, "lost_fraction"), rel=5e-3)


def test_rigid_body_in_the_table_and_the_inputs(stoss):
    words = "--body sphere --poisson 0.3 --rigid-body --speed 0.1 --against half-space --cutoff 12"
    assert "most energetic" not in stoss.run("impact", words).stdout
    document = json.loads(stoss.run("impact", words, "--format json").stdout)
    assert document["inputs"]["first"]["rigid"] is True
    assert document["records"][0]["lost_to_first"] == 0


@pytest.mark.parametrize(
    "rigid, strengths, expected",
    [
        ("", "", None),
        ("--yield 1e9", "", (1 / 2.1e11, 1e9)),
        ("--yield 1e9", ",yield=4e8", (1 / 2.1e11, 4e8)),
        ("--rigid-body", ",yield=4e8", (0, 4e8)),
    ],
)
def test_record_says_where_yielding_begins(stoss, rigid, strengths, expected):
    (row,) = stoss.data("impact --speed 0.1 --cutoff 12 --quiet", rigid, STEEL, f"--against {GLASS}{strengths}")
    if expected is None:
        assert not [key for key in row if "yield" in key]
        return
    first, strength = expected
    compliance = first * (1 - 0.3**2) + (1 - 0.23**2) / 7e10
    # Johnson, eq. 11.35, with the exact constant.
    square = 16 / 15 * 3 / (4 * math.pi * 7850 * compliance) * (math.pi * 1.6 * strength * compliance / 2) ** 5
    assert float(row["yield_speed_si[m/s]"]) == pytest.approx(math.sqrt(square), rel=1e-12)


def test_resume_keeps_to_the_half_space(stoss, tmp_path):
    path = tmp_path / "curve.csv"
    job = "restitution --body sphere --poisson 0.3 --speed 0.1,0.2 --tolerance 0.1"
    given = "--against half-space,young=2 --rigid-body"
    whole = stoss.run(job, given, "--format csv").stdout
    path.write_text(whole[: whole.rindex("\n", 0, -1) + 1])
    before = path.read_text()
    others = ("half-space,young=2", "half-space --rigid-body", "sphere,young=2")
    for other in (*(f"--against {each}" for each in others), given.replace("young=2", "young=2,loss_time=1")):
        result = resume(stoss, path, f"{job} {other}")
        assert result.returncode == 3 and "another job needs another file" in result.stderr
        assert path.read_text() == before
    assert resume(stoss, path, f"{job} {given}").returncode == 0
    assert rows(path.read_text()) == rows(whole)


# To first order of the loss times heat adds up, the less well the more high frequencies take part.
@pytest.mark.parametrize("body, against", BODIES.values(), ids=BODIES)
def test_lossy_half_space(stoss, body, against):
    job = f"restitution {body} --speed 1e-3 --against {against}"
    given = (",loss_time=0", ",loss_time=1e-3", " --loss-time 1e-3", ",loss_time=1e-3 --loss-time 1e-3")
    (none,), (lossy,), (ball,), (both,) = (stoss.data(job + each) for each in given)
    assert none == stoss.data(job)[0]
    heat = [number(row, "dissipated") for row in (none, lossy, ball, both)]
    assert heat[0] == 0 and heat[3] == pytest.approx(heat[1] + heat[2], rel=0.01 if against == "half-space" else 0.1)
    shares = number(lossy, "lost_to_first") + number(lossy, "lost_to_second")
    assert shares == pytest.approx(number(lossy, "lost_fraction"), rel=1e-12)
    assert number(lossy, "lost_to_second") > heat[1] > 0


def test_loss_time_of_a_half_space_in_si_is_in_seconds(stoss):
    wave = (2.1e11 / 7850) ** 0.5
    si = f"impact {STEEL} --cutoff 6 --speed {0.01 * wave!r} --against {GLASS},loss_time={0.1 * 0.005 / wave!r}"
    ratios = f"half-space,poisson=0.23,young={7e10 / 2.1e11!r},density={2500 / 7850!r},loss_time=0.1"
    (one,) = stoss.data(si)
    (other,) = stoss.data(f"impact --body sphere --poisson 0.3 --cutoff 6 --speed 0.01 --against {ratios}")
    for name in ("restitution", "dissipated", "lost_to_second"):
        assert number(one, name) == pytest.approx(number(other, name), rel=1e-9)
    text = stoss.run(si, "--format json").stdout
    assert json.loads(text)["inputs"]["against"]["loss_time"] == 0.1 * 0.005 / wave


@pytest.mark.parametrize("poisson", ["-0.95", "-0.4873", "0.995"])
def test_half_planes_have_the_poissons_ratios_of_disks(stoss, poisson):
    (row,) = stoss.data(f"restitution --body disk --poisson 0.3 --speed 0.1 --tolerance 1e-2 --against half-plane,poisson={poisson}")
    assert row["converged"] == "true" and number(row, "lost_to_second") > number(row, "lost_to_first") > 0


SPHERE = "--body sphere --poisson 0.3"
REFUSED = [
    (f"{SPHERE} --against half-plane", "against", "allowed wall, same, sphere, half-space, plate or modal"),
    ("--body disk --poisson 0.3 --against half-space", "against", "allowed wall, same, disk, half-plane or strip"),
    ("--body rod --against half-space", "against", "allowed wall, same or rod"),
    (f"{SPHERE} --against halfspace", "against", "did you mean half-space?"),
    (f"{SPHERE} --against half-space,radius=2", "against", "young, density, loss_time, yield, material with half-space"),
    ("--body disk --poisson 0.3 --against half-plane,yield=1e9", "against", "young, density, loss_time, material with half-plane"),
    (f"{SPHERE} --against half-space,poisson=0.5", "against poisson", "0.5, allowed -0.95 to 0.4999"),
    ("--body disk --poisson 0.3 --against half-plane,poisson=-0.96", "against poisson", "got -0.96, allowed -0.95 to 0.995"),
    (f"{SPHERE} --against half-space,young=0", "against young", "0"),
    (f"{SPHERE} --against half-space,young=-1", "against young", "-1"),
    (f"{SPHERE} --against half-space,density=nan", "against density", "nan"),
    (f"{SPHERE} --against half-space,density=inf", "against density", "inf"),
    (f"{SPHERE} --against half-space,young=1e-4", "young ratio", "0.001 to 1e6"),
    (f"{SPHERE} --against half-space,young=1e7", "young ratio", "0.001 to 1e6"),
    (f"{SPHERE} --against half-space,yield=1e9", "against", "yield without a material"),
    (f"{STEEL} --against half-space,young=1e9", "against", "half-space without density, allowed young, density"),
    (f"{STEEL} --yield 1e9 --rigid-body --against {GLASS}", "yield", "--rigid-body"),
    (f"{SPHERE} --rigid-body --loss-time 1 --against half-space", "loss_time", "a rigid body"),
    (f"{SPHERE} --against half-space,loss_time=-1", "against loss_time", "-1"),
    (f"{SPHERE} --against half-space,loss_time=nan", "against loss_time", "nan"),
    (f"{SPHERE} --rigid-body", "rigid", "against wall, allowed only against an elastic sphere, half-space, plate or modal"),
    (f"{SPHERE} --rigid-body --against same", "rigid", "against same"),
    ("--body disk --poisson 0.3 --rigid-body", "rigid", "allowed only against an elastic disk, half-plane or strip"),
    ("--body rod --rigid-body", "rigid-body", "--body rod, allowed only with --body sphere or disk"),
]


@pytest.mark.parametrize("arguments, name, said", REFUSED)
@pytest.mark.parametrize("command", ["restitution", "impact"])
def test_refusals(stoss, command, arguments, name, said):
    result = stoss.run(f"{command} --speed 0.1", arguments)
    assert (result.returncode, result.stdout) == (3, "")
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"stoss: error: {name}: got ") and said in line and "allowed" in line
