"""Results hold what the core lists: every quantity of every kind, in its order, with its words and units, the same
numbers as the command, and in SI these times the units of the first body."""

import dataclasses
import math
import re

import numpy as np
import pytest
import stoss
from stoss.results._quantities import CLASSES, QUANTITIES, TABLES

Q = stoss.quasistatic
STEEL = "--young 2.1e11 --density 7850 --yield 1e9"
HARD = stoss.Material(young=2.1e11, poisson=0.3, density=7850, yield_strength=1e9)
BALL, DISK = stoss.Sphere(radius=0.01, material=HARD), stoss.Disk(radius=0.01, material=HARD)
BAR = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
ROD = stoss.Rod(length=0.5, area=1e-4, material=BAR)
OF_A_BALL, OF_A_ROD = f"--body sphere --poisson 0.3 --radius 0.01 {STEEL}", "--body rod --length 0.5 --area 1e-4 --young 2.1e11 --density 7850"
OF_A_DISK = "--body disk --poisson 0.3 --radius 0.01 --young 2.1e11 --density 7850"
HEATED = "--speed 0.1 --temperature 0.01 --highest 5 --samples 3 --seed 7"
RINGS, MODE = stoss.Oscillation(2, 0, energy=0.1, phase=2.0), "--mode 2,0,energy=0.1,phase=2"
WARM = {"speed": 0.1, "temperature": 0.01, "highest": 5.0, "samples": 3, "seed": 7}


def oblique_impact():
    return stoss.oblique_impact(DISK, speed=1.0, angle=30, friction=0.3, cutoff=8)


# A result of each kind, bare and with a material, and the call of the command that gives it, where there is one.
RESULTS = {
    "restitution": (lambda: stoss.restitution(poisson=0.33, speed=0.1), "restitution --body disk --poisson 0.33 --speed 0.1"),
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
        lambda: stoss.impact(BALL, speed=1.0, cutoff=20, against=stoss.Sphere(radius=0.02, material=HARD)),
        f"impact --speed 1 --cutoff 20 {OF_A_BALL} --against sphere,radius=0.02,young=2.1e11,density=7850,yield=1e9"),
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
        lambda: stoss.impact(poisson=0.33, speed=0.1, cutoff=15, against=stoss.ExponentialWall(hardness=99, strength=2)),
        "impact --body disk --poisson 0.33 --speed 0.1 --cutoff 15 --against exponential,hardness=99,strength=2"),
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
    "distribution": (lambda: stoss.restitution_distribution(poisson=0.33, **WARM), f"distribution --body disk --poisson 0.33 {HEATED}"),
    "distribution-si": (lambda: stoss.restitution_distribution(DISK, **WARM), f"distribution {OF_A_DISK} {HEATED}"),
    "modes": (lambda: stoss.modes(poisson=0.33, cutoff=8), "modes --body disk --poisson 0.33 --cutoff 8"),
    "modes-ball": (lambda: stoss.modes(stoss.Sphere(poisson=0.3), cutoff=8), "modes --body sphere --poisson 0.3 --cutoff 8"),
    "trajectory": (lambda: stoss.impact(ROD, speed=1.0, cutoff=20).trajectory(every=10), None),
    "oblique impact": (oblique_impact, None),
    "oblique ledger": (lambda: oblique_impact().energy, None),
    "oblique trajectory": (lambda: oblique_impact().trajectory(every=20), None),
    "slow impact": (lambda: Q.slow_impact(BALL, speed=0.01), None),
}  # fmt: skip
# What one of the faces has in another form: the command as lists, Python as properties and inputs.
ELSEWHERE = {"poisson", "angle", "runs", "modes", "half_width", "family"}
pytestmark = pytest.mark.filterwarnings("ignore::stoss.StossWarning")


@pytest.fixture(scope="module")
def computed():
    """A result of that name, computed once."""
    made = {}
    return lambda name: made.setdefault(name, RESULTS[name][0]())


def table_of(result):
    return next(CLASSES[base.__name__] for base in type(result).__mro__ if base.__name__ in CLASSES)


def test_every_class_of_the_table_has_a_result(computed):
    assert {table_of(computed(name)).kind for name in RESULTS} == {made.kind for made in CLASSES.values()}


@pytest.mark.parametrize("name", RESULTS)
def test_fields_are_the_quantities_and_are_explained(computed, name):
    result = computed(name)
    made = table_of(result)
    fields = [field.name for field in dataclasses.fields(result)]
    assert [each for each in fields if each in made.types()] == list(made.types())
    entries = re.findall(r"^    (\w+(?:,\s+\w+)*)(?=[ :])", type(result).__doc__, re.MULTILINE)
    assert set(fields) <= {each for entry in entries for each in re.findall(r"\w+", entry)} | {"_handle", "impact"}
    assert all(getattr(type(result), si).__doc__ for si in made.si_values())


@pytest.mark.parametrize("name", RESULTS)
def test_si_values_are_values_times_units(computed, name):
    result = computed(name)
    dimensions = QUANTITIES[table_of(result).kind]
    for si in table_of(result).si_values():
        if result.material is None:
            with pytest.raises(AttributeError, match="no material"):
                getattr(result, si)
            continue
        own = re.sub("_si(?=$|_error$)", "", si)
        expected = np.asarray(getattr(result, own)) * getattr(result.body.scales, dimensions[own])
        assert np.array_equal(getattr(result, si), expected), si


def told(column):
    """A column as files have it."""
    return [math.inf if each == "unknown" else each for each in np.ravel(column).tolist()]


@pytest.mark.parametrize("name", [name for name, (_, words) in RESULTS.items() if words])
def test_values_columns_and_units_are_those_of_the_command(computed, command, name):
    result, document = computed(name), command(RESULTS[name][1])
    columns, records = result._columns(), document["records"]
    units = result._units_of(columns)
    theirs = [each for each in records[0] if not isinstance(records[0][each], (list, dict))]
    early = {"poisson", "speed", "speed_si", *result._given, *(f"{each}_si" for each in result._given)}
    shared = [each for each in theirs if each in columns]
    assert set(TABLES[table_of(result).kind][0].columns) <= set(shared)
    other = ({*theirs} ^ {*columns}) - ELSEWHERE
    assert not other
    ours = [each for each in columns if each in shared]
    assert [each for each in ours if each not in early] == [each for each in shared if each not in early]
    for each in shared:
        assert units.get(each, "") == document["units"].get(each, ""), each
        ours, found = told(columns[each]), [math.inf if one[each] == "unknown" else one[each] for one in records]
        assert ours == found if "_si" not in each and each != "speed" else ours == pytest.approx(found, rel=1e-12), each


    if hasattr(result, "energy"):
        assert [told(share) for share in result.energy.entries().values()] == [
            [one["ledger"][share] for one in records] for share in result.energy.entries()
        ]
    modes = getattr(result, "mode_energies", None)
    if modes is not None:
        driven = [{**each, "body": ("first", "second").index(each["body"])} if "body" in each else each
                  for each in document["modes"]]  # fmt: skip
        assert [dict(zip(modes.dtype.names, row)) for row in modes.tolist()] == driven


def test_arrays_have_the_quantities_of_the_core(computed):
    slow = Q.rayleigh(poisson=0.33, speed=1e-3, cutoff=10)
    for kind, array in (("mode energy", computed("impact").mode_energies), ("driven mode", slow.mode_energies)):
        assert sorted(array.dtype.names) == sorted(QUANTITIES[kind])


def test_rods_have_their_own_units_at_every_instant(computed):
    path = computed("trajectory")
    units = path._units_of(path._columns())
    assert (units["time"], units["force"], units["time_si"], units["force_si"]) == ("L/c", "EA", "s", "N")
    assert "R/c" not in repr(path) and "contact time 2" in repr(computed("impact-rod"))
