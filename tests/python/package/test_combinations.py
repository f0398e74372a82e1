"""What does not go together, or is not there for such a body, is refused in one line that says why."""

import re

import numpy as np
import pytest
import stoss
from stoss import quasistatic
from wrong_values import BODIES, nan

BALL, DISK, ROD = stoss.Sphere(poisson=0.3), stoss.Disk(poisson=0.33), stoss.Rod()
STEEL, GLASS = stoss.materials["structural steel"], stoss.materials["glass"]
SHOT, STEEL_DISK = stoss.Sphere(radius=5e-3, material=STEEL), stoss.Disk(radius=0.01, material=STEEL)
RIGID, BLOCK, SOFT = stoss.Sphere(poisson=0.3, rigid=True), stoss.HalfSpace(), stoss.ExponentialWall()
PANE, FILM = stoss.Layer(thickness=4e-3, material=GLASS), stoss.Layer(thickness=8e-4, material=stoss.materials["PVB"])
RINGING = stoss.Oscillation(2, 0, 0.1)
AT = {"speed": 0.1}
HIT = {"speed": 0.1, "cutoff": 6}


def impact(body, against=None, **given):
    return stoss.impact(body, against=against, **{**HIT, **given})


def oblique(body=BALL, **given):
    return stoss.oblique(body, **{**AT, "friction": 0.1, **given})


def ensemble(**given):
    return stoss.restitution_distribution(BALL, **{**AT, "temperature": 0.01, "samples": 2, **given})


def rule(body=BALL, **given):
    return stoss.collision_rule(body, **{"speed": (1e-3, 1e-2), **given})


def function(body, against=None, **given):
    return stoss.restitution_function(body, against=against, **{"speed": (1e-8, 0.5), "error": 1e-7, **given})


def pairs(body=DISK, **given):
    return stoss.pair_table(body, **{"speed": (0.1, 0.2), "ratio": (1, 2), **given})


def predict(body=SHOT, **given):
    return stoss.predict(body, **{**AT, **given})


def sequence(**given):
    return stoss.bounce(BALL, **{**AT, **given})


def plate(*layers, **given):
    return stoss.Plate(layers=list(layers), **given)


TOGETHER = [
    # One body, who meets whom, and with a material or without.
    *((lambda call=call: call(**AT), "body: got .*, allowed one of body and poisson") for call in (stoss.restitution,
     stoss.impact)),
    (lambda: stoss.restitution(ROD, poisson=0.3, **AT), "body: got .*, allowed one of body and poisson"),
    *((lambda call=call, body=body: call(body, **AT), "body: got ") for body in BODIES for call in (stoss.impact,
     quasistatic.slow_impact)),
    *((lambda call=call: call(ROD, **AT), "body: got Rod.., allowed a stoss.Disk") for call in (quasistatic.slow_impact,
     quasistatic.rayleigh)),
    (lambda: stoss.modes(ROD, cutoff=6), "body: got Rod.., allowed a stoss.Disk"),
    (lambda: stoss.modes(RIGID, cutoff=5), "body: got Sphere"),
    (lambda: quasistatic.slow_impact(stoss.Disk(poisson=0.3, rigid=True), speed=1e-3), "body: got Disk"),
    (lambda: impact(DISK, STEEL_DISK), "against: got .*two bodies with a material, or two without"),
    (lambda: impact(STEEL_DISK, DISK), "against: got .*two bodies with a material"),
    (lambda: impact(BALL, stoss.HalfSpace(material=STEEL)), "against: got .*or two without"),
    (lambda: impact(DISK, ROD), "against: got .*a disk meets disks"),
    (lambda: impact(DISK, BLOCK), "against: got .*HalfPlane"),
    (lambda: impact(BALL, stoss.HalfPlane()),
     "against: got .*a stoss.Sphere, HollowSphere, ModalBody, HalfSpace"),
    (lambda: impact(DISK, stoss.Plate(thickness=1)), "against: got .*HalfPlane, Strip"),
    (lambda: impact(STEEL_DISK, stoss.Disk(radius=0.01, material=STEEL, plane="strain")),
     "against: got .*the same plane"),
    (lambda: impact(RIGID), "against: got HardWall.*, allowed"),
    (lambda: impact(RIGID, "same"), ".*allowed a body that deforms"),
    (lambda: impact(DISK, stoss.Disk(poisson=0.3, radius=1e-4)), "radius ratio: got 0.0001, allowed"),
    (lambda: impact(BALL, stoss.HalfSpace(young=1e-7)), "young ratio: got"),
    (lambda: impact(BALL, stoss.HalfSpace(density=1e7)), "density ratio: got"),
    # Bodies in one list.
    *((lambda bodies=bodies: stoss.restitution(bodies, **AT), f"body: got .*{said}") for bodies, said in (
        ([], r"\[\], allowed one body, or a list"), ([BALL, DISK], r"Disk\(poisson=0.33\), allowed one kind of bodies"),
        ([ROD], r"Rod\(\), allowed a stoss.Disk or a stoss.Sphere"), ([[BALL], 3],
         "allowed a stoss.Disk or a stoss.Sphere"),
        (np.array([0.3]), "0.3, allowed a stoss.Disk or a stoss.Sphere"), ([SHOT],
         "allowed bodies without a material in a list"))),
    # Bodies and materials by themselves.
    (lambda: stoss.Disk(material=STEEL), "radius: missing .a material needs it too, in SI"),
    (lambda: stoss.HalfPlane(plane="strain"), "plane: got 'strain', allowed none without a material"),
    (lambda: stoss.Sphere(poisson=0.3, loss_time=0.1, rigid=True), "loss_time: got 0.1, allowed 0 of a rigid body"),
    (lambda: stoss.Material(young=1, poisson=0, density=1, quality=(10, 1), loss_time=1),
     "quality: got a quality beside a loss_time"),
    (lambda: stoss.HalfSpace(material=3), "material: got 3"),
    (lambda: stoss.HalfPlane(material=STEEL, plane="flat"), "plane: got 'flat'"),
    (lambda: stoss.Sphere(poisson=0.3, rigid=1), "rigid: got 1, allowed True or False"),
    (lambda: plate(), r"layers: got \[\]"),
    (lambda: plate(1), "layers: got 1"),
    (lambda: stoss.Plate(layers=PANE), r"layers: got Layer\("),
    (lambda: stoss.Layer(thickness=0), "thickness: got 0"),
    (lambda: plate(stoss.Layer(thickness=1), thickness=2), "thickness: got 2"),
    (lambda: plate(stoss.Layer()), "thickness: missing"),
    (lambda: plate(PANE, stoss.Layer(material=GLASS), PANE), "layer 2 thickness: missing"),
    (lambda: plate(*[PANE] * 21), "layers: got 21, allowed 1 to 20"),
    (lambda: plate(PANE, FILM, quality=10, loss_time=1e-6), "quality: got a quality beside a loss_time"),
    (lambda: plate(PANE, stoss.Layer(thickness=1)), "layer 2 material: missing"),
    # What vibrates before, which modes, and what is inside of whom.
    (lambda: impact(BALL, state=stoss.Oscillation(2, 0, nan)), "energy: got nan, allowed 0 to 1e12"),
    (lambda: impact(BALL, state=stoss.Oscillation(2, 0, 0.1, nan)), "phase: got nan"),
    (lambda: impact(BALL, state=stoss.Oscillation(2, 400, 0.1)), "vibration: got"),
    (lambda: impact(BALL, state=[RINGING, RINGING]), ".*twice, allowed once"),
    (lambda: impact(BALL, state=stoss.Oscillation(2, 0, 0.1, of=1)),
     r".*mode of body 1, allowed 0 \(a wall has no modes\)"),
    (lambda: impact(BALL, BLOCK, state=stoss.Oscillation(0, 0, 0.1, of=1)),
     ".*allowed modes of bodies that are there as a whole"),
    *((lambda keep=keep: impact(DISK, SOFT, tail="none", keep=np.full(*keep)),
     "keep: got .*allowed 1 to 20 of the 20") for keep in ((21, True), (20, False))),
    *((lambda tail=tail: impact(DISK, keep=np.ones(20, bool), tail=tail),
     "keep: .*HardWall.*allowed only at a wall with tail='none'") for tail in ("radiating", "static")),
    (lambda: impact(DISK, keep=np.ones(20, bool), tail="none"), "tail: got none at smooth faces"),
    (lambda: impact(DISK, "same", keep=[True]), "keep: got a selection"),
    (lambda: impact(ROD, cutoff=20).field(time=1), "body: got Rod.., allowed a stoss.Disk"),
    (lambda: impact(RIGID, BLOCK).field(time=0), "body: .*a rigid one has no field"),
    (lambda: impact(BALL, BLOCK).field(time=0, of=1), "of: .*a half-space has no field"),
    (lambda: impact(BALL, stoss.Plate(thickness=2)).field(time=0, of=1), "of: .*a plate has no field"),
    (lambda: impact(DISK, stoss.Disk(poisson=0.3, radius=900.0)).field(time=1, of=1),
     "body: got number 1 .*, allowed 0 .*near side"),
    (lambda: impact(DISK).field(time=1, of=1), "of: got 1, allowed 0 .a wall has no field"),
    (lambda: impact(DISK, "same").field(time=1, of=2), "of: got 2, allowed 0 or 1"),
    (lambda: impact(BALL).wave(), "against: got .*HalfSpace, HalfPlane, Plate or Strip"),
    (lambda: impact(BALL, stoss.Plate(thickness=0.5)).wave(depth=[0.0, 0.6]),
     "depth: got .*0 to 0.5 .R, the thickness of the plate"),
    (lambda: impact(DISK).sound(), ".*one with a material"),
    (lambda: impact(SHOT, speed=1.0).sound(), "slower: got 1.0, allowed a larger one"),
    (lambda: impact(SHOT, SOFT, speed=1.0, keep=np.arange(stoss.modes(SHOT,
     cutoff=6).order.size) < 5).sound(slower=100), "keep: "),
    (lambda: stoss.modes(DISK, cutoff=6).find(2, 99), r"mode: got \(n, l\) = \(2, 99\), allowed"),
    # Sequences, ensembles, friction.
    (lambda: sequence(), "flight_time: got neither"), (lambda: sequence(flight_time=1, against="same"), "against: got"),
    (lambda: ensemble(temperature=None), "temperature: got neither, allowed one of temperature and spectrum"),
    (lambda: ensemble(spectrum=[RINGING]), "temperature: got temperature and spectrum"),
    (lambda: ensemble(highest=0.5), "highest: got 0.5, allowed from 1.64"),
    (lambda: ensemble(speed=[0.1, 0.2]), r"speed: got \[0.1, 0.2\], allowed one number"),
    (lambda: oblique(angle=3, tangential=0.1), "angle: cannot be combined with tangential .give one of them.$"),
    (lambda: oblique(second_spin=0.1), "second_spin: got one that is not 0, allowed only 0"),
    (lambda: oblique(ROD), "friction: not available for 'rod', but for disks"),
    (lambda: oblique(SHOT, speed=1, spin=1e9), "spin: got 1000000000, allowed -[-+e0-9.]+ to [-+e0-9.]+ rad/s "),
    (lambda: oblique(SHOT, speed=1, tangential=1e4), "tangential: got 10000, allowed -5176.96 to 5176.96 m/s "),
    (lambda: stoss.oblique_impact(BALL, friction=0.1, speed=[0.1, 0.2]),
     "speed: got 2 of them, allowed one impact .use stoss.oblique for several"),
    (lambda: stoss.oblique_impact(BALL, friction=[0.1, 0.2], speed=0.1), "friction: got 2 of them, allowed one"),
    (lambda: impact(SHOT, speed=6000), "speed: got .*5176.* m/s"),
    (lambda: stoss.restitution(SHOT, speed=1e308), "speed: got"),
    # Functions, rules and the atlas.
    *((lambda pair=pair: function(*pair, beyond="law"), ".*law") for pair in (
        (ROD,), (BALL, stoss.Sphere(poisson=0.3, radius=2)), (DISK, stoss.HalfPlane()), (RIGID, BALL), (BALL,
         stoss.Plate(thickness=2)),
        (stoss.Sphere(poisson=0.3, loss_time=1), BLOCK))),
    (lambda: function(BALL, beyond="law", speed=(1e-3, 0.1), error=0.01).to_c("x.h"),
     "beyond: got law, allowed error or clamp"),
    *((lambda given=given: pairs(**given), said) for given, said in (
        ({"against": stoss.HalfPlane()}, "against"), ({"against": stoss.Disk(poisson=0.3, rigid=True)}, "against"),
        ({"against": stoss.Disk(poisson=0.3, loss_time=0.1)}, ".*loss_time"), ({"beyond": "law"}, "beyond"))),
    (lambda: rule(DISK), "friction: missing"),
    (lambda: rule(friction=0.3), "friction: got 0.3"),
    (lambda: rule(beyond="law"), "beyond"),
    *((lambda body=body, met=met, speed=speed: stoss.atlas(body, against=met, speed=speed), said) for body, met, speed,
     said in (
        (ROD, None, 0.1, "body: got Rod"), (stoss.Disk(poisson=0.3, loss_time=0.1), None, 0.1, "body: got Disk"),
        (stoss.Disk(poisson=-0.1), None, 0.1, "poisson: got -0.1, allowed 0 to 0.9"), (BALL, None, 1e-5,
         "speed in c: got 1e-05, allowed 0.0001 to 0.3"),
        (BALL, stoss.Sphere(poisson=0.2), 0.1, "against: got Sphere"), (BALL, stoss.Plate(thickness=2), 0.01,
         ".*in the atlas"),
        (BALL, stoss.Sphere(poisson=0.3, radius=11), 0.1, "ratio of the radii: got 11.0, allowed 1 to 10"))),
    # Drop tests, chains and the quasi-static theory.
    (lambda: predict(STEEL_DISK), "body: got a disk, allowed a sphere"),
    (lambda: predict(BALL), "material: missing .the ball needs one"),
    (lambda: predict(height=1.0), "speed: got speed and height, allowed one"),
    (lambda: predict(speed=None), "speed: got neither, allowed one"),
    (lambda: predict(against=BLOCK), "against: needs a material too"),
    (lambda: predict(against=SOFT), "against: got exponential, allowed wall, same"),
    (lambda: stoss.rod_chain([stoss.Rod(loss_time=0.1)] * 2, circumference=10, temperature=1, collisions=1),
     ".*decay_time"),
    (lambda: stoss.rod_chain([ROD, ROD], circumference=9, collisions=1), ".*allowed"),
    (lambda: stoss.rod_chain([ROD, ROD], circumference=9, temperature=1), ".*allowed"),
    (lambda: quasistatic.slow_impact(BALL, speed=0.01, law="diameter"),
     "law: got 'diameter', allowed 'center' or 'hertz'$"),
    (lambda: quasistatic.compression(poisson=0.3, force=0.01, law="hertz"),
     "law: got 'hertz', allowed 'center' or 'diameter'$"),
    (lambda: quasistatic.hertz_pressure(BALL, force=0.01, y=-0.1), "distance: got -0.1, allowed"),
    *((lambda given=given: quasistatic.yield_speed(**given),
     r"(body|against): got Sphere\(.*\), allowed") for given in (
        {"body": BALL}, {"body": SHOT, "against": BALL}, {"body": stoss.Sphere(radius=1, material=STEEL, rigid=True),
         "against": "same"})),
]  # fmt: skip


@pytest.mark.parametrize("call, said", TOGETHER, ids=[re.sub(r"\W+", " ", said) for _, said in TOGETHER])
def test_refused_in_one_line(call, said):
    with pytest.raises(stoss.InvalidInput, match=f"^{said}") as caught:
        call()
    assert str(caught.value).isprintable() and len(str(caught.value)) < 400


def test_what_a_result_has_no_material_for():
    for missing in (lambda: DISK.scales, lambda: impact(DISK).speed_si, lambda: stoss.quasistatic.slow_impact(DISK,
     speed=0.01).contact_time_si):
        with pytest.raises(AttributeError, match="no material"):
            missing()
    with pytest.raises(AttributeError, match="no sphere of this result has a yield strength"):
        _ = impact(stoss.Sphere(radius=0.01, material=GLASS), speed=0.01).beyond_yield


def test_materials_are_refused_by_the_core():
    both = "'structural steel' (yields at 235 MPa) or 'bearing steel' (at 1.7 GPa)"
    with pytest.raises(stoss.InvalidInput) as old:
        _ = stoss.materials["steel"]
    assert str(old.value).startswith(f"material: got 'steel', allowed {both}") and "\n" not in str(old.value)
    with pytest.raises(stoss.InvalidInput, match="^material: got 'steal', allowed structural steel, glass, "):
        _ = stoss.materials["steal"]
    assert "steel" not in stoss.materials and stoss.materials.get("steel") is None
    with pytest.raises(stoss.InvalidInput) as in_a_grid:
        stoss.Grid(bodies={"kind": "sphere", "radius": 1.0, "material": "steel"}, against=["wall"], speed=[1.0])
    assert str(in_a_grid.value) == f"bodies: {old.value}"


def test_a_hard_wall_says_where_its_tail_went():
    with pytest.raises(TypeError, match=r"^HardWall: got tail, .*stoss\.impact\(\.\.\., tail='static'\)$"):
        stoss.HardWall(tail="static")
