"""A result of every kind, bare and with a material, and the call of the command that gives it, where there is one."""

import functools
import tempfile
import warnings

import numpy as np
import stoss

Q = stoss.quasistatic
STEEL = "--young 2.1e11 --density 7850"
BAR = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
BALL, DISK = stoss.Sphere(radius=0.01, material=BAR), stoss.Disk(radius=0.01, material=BAR)
ROD = stoss.Rod(length=0.5, area=1e-4, material=BAR)
OF_A_BALL = f"--body sphere --poisson 0.3 --radius 0.01 {STEEL}"
OF_A_ROD = "--body rod --length 0.5 --area 1e-4 --young 2.1e11 --density 7850"
OF_A_DISK = "--body disk --poisson 0.3 --radius 0.01 --young 2.1e11 --density 7850"
HEATED = "--speed 0.1 --temperature 0.01 --highest 5 --samples 3 --seed 7"
RINGS, MODE = stoss.Oscillation(2, 0, energy=0.1, phase=2.0), "--mode 2,0,energy=0.1,phase=2"
WARM = {"speed": 0.1, "temperature": 0.01, "highest": 5.0, "samples": 3, "seed": 7}


STEEL_BALL = stoss.Sphere(radius=5e-3, material=stoss.materials["bearing steel"])
PANE = stoss.HalfSpace(material=stoss.materials["glass"])
OF_A_STEEL_BALL = "--body sphere --material 'bearing steel' --radius 0.005 --against half-space,material=glass"


def oblique_impact():
    return stoss.oblique_impact(DISK, speed=1.0, angle=30, friction=0.3, cutoff=8)


def small_hit():
    return stoss.impact(poisson=0.33, speed=0.1, cutoff=10)


def swept(bodies, speed):
    with tempfile.TemporaryDirectory() as store:
        grid = {"bodies": bodies, "against": ["wall", "same"], "speed": speed, "tolerance": 1e-2}
        return stoss.sweep(grid, store=store)


DROPS = {"speed": [0.5, 1.0], "contact_time": [6e-5, 5.2e-5], "contact_time_uncertainty": [1e-6, 1e-6]}

RESULTS = {
    "restitution": (lambda: stoss.restitution(poisson=0.33, speed=0.1),
     "restitution --body disk --poisson 0.33 --speed 0.1"),
    "restitution-rods": (
        lambda: stoss.restitution(stoss.Rod(), speed=0.1, tolerance=0.01, against=stoss.Rod(length=2.5)),
        "restitution --body rod --speed 0.1 --tolerance 0.01 --against rod,length=2.5"),
    "restitution-ball": (lambda: stoss.restitution(BALL, speed=0.01), f"restitution --speed 0.01 {OF_A_BALL}"),
    "restitution-disk": (lambda: stoss.restitution(DISK, speed=1.0), f"restitution --speed 1 {OF_A_DISK}"),
    "restitution-rods-si": (
        lambda: stoss.restitution(ROD, speed=1.0, tolerance=0.05, against=stoss.Rod(length=1, area=1e-4, material=BAR)),
        f"restitution --speed 1 --tolerance 0.05 {OF_A_ROD} --against rod,length=1,area=1e-4,young=2.1e11,density=7850"),
    "impact": (lambda: stoss.impact(DISK, speed=1.0, cutoff=20), f"impact --speed 1 --cutoff 20 {OF_A_DISK}"),
    "impact-rod": (lambda: stoss.impact(ROD, speed=1.0, cutoff=20), f"impact --speed 1 --cutoff 20 {OF_A_ROD}"),
    "impact-balls": (
        lambda: stoss.impact(BALL, speed=1.0, cutoff=20, against=stoss.Sphere(radius=0.02, material=BAR)),
        f"impact --speed 1 --cutoff 20 {OF_A_BALL} --against sphere,radius=0.02,young=2.1e11,density=7850"),
    "restitution-yielding": (
        lambda: stoss.restitution(stoss.Sphere(radius=0.01, material=BAR, yield_strength=1e9), speed=[0.1, 1.0]),
        f"restitution --speed 0.1,1 {OF_A_BALL} --yield-strength 1e9"),
    "restitution-strain": (
        lambda: stoss.restitution(stoss.Disk(radius=0.01, material=BAR, plane="strain"), speed=[5.0, 50.0]),
        f"restitution --speed 5,50 --plane strain {OF_A_DISK}"),
    "restitution-plate": (
        lambda: stoss.restitution(stoss.Sphere(poisson=0.3), against=stoss.Plate(thickness=2, young=0.5), speed=0.1),
        "restitution --body sphere --poisson 0.3 --speed 0.1 --against plate,thickness=2,young=0.5"),
    "restitution-ringing": (
        lambda: stoss.restitution(stoss.Sphere(poisson=0.3), speed=[0.01, 0.1], state=RINGS),
        f"restitution --body sphere --poisson 0.3 --speed 0.01,0.1 {MODE}"),
    "impact-ringing": (
        lambda: stoss.impact(stoss.Sphere(poisson=0.3), speed=0.01, cutoff=15, state=RINGS),
        f"impact --body sphere --poisson 0.3 --speed 0.01 --cutoff 15 {MODE}"),
    "impact-static": (lambda: stoss.impact(poisson=0.33, speed=0.1, cutoff=15, tail="static"),
                      "impact --body disk --poisson 0.33 --speed 0.1 --cutoff 15 --tail static"),
    "impact-soft": (
        lambda: stoss.impact(poisson=0.33, speed=0.1, cutoff=15, against=stoss.ExponentialWall(hardness=99,
         strength=2), tail="none"),
        "impact --body disk --poisson 0.33 --speed 0.1 --cutoff 15 --against exponential,hardness=99,strength=2 --tail none"),
    "impact-resolved": (lambda: stoss.impact(poisson=0.33, speed=0.1, cutoff=15, step=0.01, nodes=100),
                        "impact --body disk --poisson 0.33 --speed 0.1 --cutoff 15 --step 0.01 --nodes 100"),
    "oblique-balls": (
        lambda: stoss.oblique(stoss.Sphere(poisson=0.3), speed=0.05, angle=20, second_spin=0.01, friction=0.3,
                              against=stoss.Sphere(poisson=0.3, radius=2)),
        "oblique --body sphere --poisson 0.3 --speed 0.05 --angle 20 --second-spin 0.01 --friction 0.3 "
        "--against sphere,radius=2"),
    "oblique-ringing": (
        lambda: stoss.oblique(stoss.Sphere(poisson=0.3), speed=0.05, tangential=0.02, friction=0.3, state=RINGS),
        f"oblique --body sphere --poisson 0.3 --speed 0.05 --tangential 0.02 --friction 0.3 {MODE}"),
    "oblique": (
        lambda: stoss.oblique(stoss.Disk(poisson=0.33), speed=0.1, tangential=0.1, friction=0.3, tolerance=0.1),
        "oblique --body disk --poisson 0.33 --speed 0.1 --tangential 0.1 --friction 0.3 --tolerance 0.1"),
    "oblique-ball": (
        lambda: stoss.oblique(BALL, speed=[1.0, 2.0], tangential=0.5, friction=0.3),
        f"oblique --speed 1,2 --tangential 0.5 --friction 0.3 {OF_A_BALL}"),
    "rayleigh": (lambda: Q.rayleigh(poisson=0.33, speed=1e-3), "quasistatic --body disk --poisson 0.33 --speed 1e-3"),
    "rayleigh-ball": (lambda: Q.rayleigh(BALL, speed=[0.01, 0.02]), f"quasistatic --speed 0.01,0.02 {OF_A_BALL}"),
    "rayleigh-law": (lambda: Q.rayleigh(poisson=0.33, speed=[1e-100, 1e-4], law="diameter", cutoff=15),
                     "quasistatic --body disk --poisson 0.33 --speed 1e-100,1e-4 --law diameter --cutoff 15"),
    "rayleigh-hertz": (
        lambda: Q.rayleigh(stoss.Sphere(poisson=0.3), speed=[1e-12, 0.1], law="hertz", cutoff=15),
        "quasistatic --body sphere --poisson 0.3 --speed 1e-12,0.1 --law hertz --cutoff 15"),
    "predict": (lambda: stoss.predict(BALL, speed=[0.5, 1.0]), f"predict --speed 0.5,1 {OF_A_BALL}"),
    "bounce": (lambda: stoss.bounce(poisson=0.33, speed=0.1, count=3, flight_time=9),
               "bounce --body disk --poisson 0.33 --speed 0.1 --count 3 --flight-time 9"),
    "bounce-block": (
        lambda: stoss.bounce(stoss.Sphere(poisson=0.3), against=stoss.HalfSpace(), speed=0.05, count=2, gravity=0.01),
        "bounce --body sphere --poisson 0.3 --speed 0.05 --count 2 --gravity 0.01 --against half-space"),
    "bounce-si": (lambda: stoss.bounce(BALL, speed=1.0, count=2, flight_time=1e-3),
                  f"bounce --speed 1 --count 2 --flight-time 1e-3 {OF_A_BALL}"),
    "distribution": (lambda: stoss.restitution_distribution(poisson=0.33, **WARM),
     f"distribution --body disk --poisson 0.33 {HEATED}"),
    "distribution-si": (lambda: stoss.restitution_distribution(DISK, **WARM), f"distribution {OF_A_DISK} {HEATED}"),
    "modes": (lambda: stoss.modes(poisson=0.33, cutoff=8), "modes --body disk --poisson 0.33 --cutoff 8"),
    "modes-ball": (lambda: stoss.modes(stoss.Sphere(poisson=0.3), cutoff=8),
     "modes --body sphere --poisson 0.3 --cutoff 8"),
    "trajectory": (lambda: stoss.impact(ROD, speed=1.0, cutoff=20).trajectory(every=10), None),
    "oblique impact": (oblique_impact, None),
    "oblique ledger": (lambda: oblique_impact().energy, None),
    "oblique trajectory": (lambda: oblique_impact().trajectory(every=20), None),
    "slow impact": (lambda: Q.slow_impact(BALL, speed=0.01), None),
    "curve": (lambda: stoss.restitution(poisson=[[0.2], [0.33]], speed=[0.01, 0.1, 0.2], tolerance=1e-2),
              "restitution --body disk --poisson 0.2,0.33 --speed 0.01,0.1,0.2 --tolerance 1e-2"),
    "bounce-ringing": (
        lambda: stoss.bounce(poisson=0.33, speed=0.1, count=3, flight_time=20, state=RINGS),
        f"bounce --body disk --poisson 0.33 --speed 0.1 --count 3 --flight-time 20 {MODE}"),
    "predict-block": (
        lambda: stoss.predict(STEEL_BALL, against=PANE, speed=[0.1, 20], tolerance=0.01, uncertainties={"young": 0.5}),
        f"predict --speed 0.1,20 --tolerance 0.01 --uncertainty young=0.5 {OF_A_STEEL_BALL}"),
    "empty": (lambda: stoss.restitution(BALL, speed=[]), None),
    "pairs": (lambda: stoss.restitution(poisson=[0.3, 0.4], against="same", speed=0.1, tolerance=1e-2), None),
    "chosen modes": (lambda: stoss.impact(poisson=0.33, speed=0.1, cutoff=6, against=stoss.ExponentialWall(),
     tail="none", keep=np.arange(20) < 9), None),
    "field": (lambda: small_hit().field(time=[2, 1], radius=[0.0, 0.5, 1.0], angle=[0.0, 3.0]), None),
    "frame": (lambda: small_hit().field(time=2, radius=[0.0, 1.0], angle=[0.0, 3.0]), None),
    "field of a ball": (lambda: stoss.impact(BALL, speed=1.0, cutoff=8).field(time=2, radius=[0.5, 1.0], angle=[0.0,
     1.0]), None),
    "trajectory of a disk": (lambda: small_hit().trajectory(every=10), None),
    "wave": (lambda: stoss.impact(BALL, against=stoss.HalfSpace(material=BAR), speed=1.0, cutoff=4).wave(
        time=[2.0, 4.0], distance=[0.0, 1.0], depth=[0.0, 1.0, 2.0]), None),
    "static contact": (lambda: Q.static_contact(poisson=0.33, compression=0.01, nodes=20), None),
    "static contact of a ball": (lambda: Q.static_contact(BALL, compression=0.01, nodes=20), None),
    "slow impacts": (lambda: Q.slow_impact(poisson=[[0.1], [0.2]], speed=[1e-9, 1e-3]), None),
    "function": (lambda: stoss.restitution_function(BALL, speed=(1, 9), error=1e-2), None),
    "pair table": (lambda: stoss.pair_table(poisson=0.33, speed=(0.05, 0.2), ratio=(1, 1.5), error=2e-2), None),
    "rule": (lambda: stoss.collision_rule(BALL, speed=(1, 9), error=0.05, tolerance=0.1), None),
    "atlas": (lambda: stoss.atlas(stoss.Sphere(poisson=0.3), speed=[0.01, 0.1]), None),
    "atlas-si": (lambda: stoss.atlas(DISK, speed=[[1.0], [9.0]]), None),
    "sweep": (lambda: swept({"kind": "sphere", "poisson": [0.1, 0.3]}, [0.01, 0.1]), None),
    "sweep-si": (lambda: swept([STEEL_BALL, stoss.Sphere(radius=0.01, material=stoss.materials["glass"])], [0.5, 1.0]),
     None),
    "chain": (lambda: stoss.rod_chain([ROD, ROD], circumference=9, velocities=[0.1, 0], collisions=9), None),
    "row": (lambda: stoss.row([BALL] * 3, speed=[0.1], tolerance=1e-2), None),
    "rows": (lambda: stoss.row([stoss.Disk(poisson=0.33)] * 3, speed=[[0.02], [0.1]], before="wall", tolerance=1e-2),
     None),
    "row motion": (
        lambda: stoss.row_impact([BALL] * 2, speed=[1.0], against="wall", gaps=[0, 1e-5], cutoff=8, every=20), None),
    "row of rods": (lambda: stoss.row_impact([stoss.Rod(), stoss.Rod(length=2)], speed=[0.1], cutoff=8), None),
    "row ringing": (
        lambda: stoss.row([stoss.Sphere(poisson=0.3)] * 2, speed=[0.1], vibration=RINGS, tolerance=1e-2), None),
    "calibrate": (lambda: stoss.calibrate(DROPS, BALL, unknown="radius"), None),
    "pulse": (lambda: stoss.pulse(BALL, speed=1.0, against=stoss.HalfSpace(material=BAR)), None),
    "pulse of a disk": (lambda: stoss.pulse(poisson=0.33, speed=0.1, tolerance=0.05), None),
    "seismogram": (lambda: computed("pulse").at(0.1, points=50), None),
    "seismogram of a plate": (
        lambda: stoss.pulse(stoss.Sphere(poisson=0.3), against=stoss.Plate(thickness=2), speed=0.1).at(4, 2, points=20),
        None),
    "fit": (lambda: stoss.fit(BALL, law="linear", speed=(1, 9)), None),
}  # fmt: skip


@functools.cache
def computed(name):
    """A result of that name, computed once."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", stoss.StossWarning)
        return RESULTS[name][0]()
