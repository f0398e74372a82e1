"""Results hold what the core lists: every quantity of every kind, in its order, with its words and units, the same
numbers as the command, and in SI these times the units of the first body."""

import dataclasses
import math
import re

import numpy as np
import pytest
import stoss
from every_result import RESULTS, computed
from stoss.results._quantities import CLASSES, QUANTITIES, TABLES

# What one of the faces has in another form: the command as lists, Python as properties and inputs.
ELSEWHERE = {"poisson", "angle", "runs", "modes", "half_width", "family"}
pytestmark = pytest.mark.filterwarnings("ignore::stoss.StossWarning")


def tables_of(result):
    return [CLASSES[base.__name__] for base in type(result).__mro__ if base.__name__ in CLASSES]


def test_every_class_of_the_table_has_a_result():
    assert {made.kind for name in RESULTS for made in tables_of(computed(name))} == {made.kind for made in CLASSES.values()}


@pytest.mark.parametrize("name", RESULTS)
def test_fields_are_the_quantities_and_are_explained(name):
    result = computed(name)
    fields = [field.name for field in dataclasses.fields(result)]
    entries = re.findall(r"^    (\w+(?:,\s+\w+)*)(?=[ :])", type(result).__doc__, re.MULTILINE)
    explained = {each for entry in entries for each in re.findall(r"\w+", entry)}
    for made in tables_of(result):
        assert set(fields) <= explained | {"_handle", "impact"}
        assert [each for each in fields if each in made.types()] == list(made.types())
        assert all(getattr(type(result), si).__doc__ for si in made.si_values())


@pytest.mark.parametrize("name", RESULTS)
def test_si_values_are_values_times_units(name):
    result = computed(name)
    for made, si in [(each, si) for each in tables_of(result) for si in each.si_values()]:
        if result.material is None:
            with pytest.raises(AttributeError, match="no material"):
                getattr(result, si)
            continue
        own = re.sub("_si(?=$|_error$)", "", si)
        expected = np.asarray(getattr(result, own)) * getattr(result.body.scales, QUANTITIES[made.kind][own])
        assert np.array_equal(getattr(result, si), expected), si


def told(column):
    """A column as files have it."""
    return [math.inf if each == "unknown" else each for each in np.ravel(column).tolist()]


@pytest.mark.parametrize("name", [name for name, (_, words) in RESULTS.items() if words])
def test_values_columns_and_units_are_those_of_the_command(command, name):
    result, document = computed(name), command(RESULTS[name][1])
    columns, records = result._columns(), document["records"]
    units = result._units_of(columns)
    theirs = [each for each in records[0] if not isinstance(records[0][each], (list, dict))]
    early = {"poisson", "speed", "speed_si", *result._given, *(f"{each}_si" for each in result._given)}
    shared = [each for each in theirs if each in columns]
    assert set(TABLES[tables_of(result)[0].kind][0].columns) <= set(shared)
    other = ({*theirs} ^ {*columns}) - ELSEWHERE
    assert not other
    ours = [each for each in columns if each in shared]
    assert [each for each in ours if each not in early] == [each for each in shared if each not in early]
    for each in shared:
        assert units.get(each, "") == document["units"].get(each, ""), each
        ours, found = told(columns[each]), [math.inf if one[each] == "unknown" else one[each] for one in records]
        assert ours == found if "_si" not in each and each != "speed" else ours == pytest.approx(found, rel=1e-12), each
    for each in [each for each in ("influences", "warnings") if each in records[0]]:
        assert result.to_dict()[each] == [one[each] for one in records]
    if hasattr(result, "energy"):
        assert [told(share) for share in result.energy.entries().values()] == [
            [one["ledger"][share] for one in records] for share in result.energy.entries()
        ]
    modes = getattr(result, "mode_energies", None)
    if modes is not None:
        driven = [{**each, "body": ("first", "second").index(each["body"])} if "body" in each else each
                  for each in document["modes"]]  # fmt: skip
        assert [dict(zip(modes.dtype.names, row)) for row in modes.tolist()] == driven


def test_arrays_have_the_quantities_of_the_core():
    slow = stoss.quasistatic.rayleigh(poisson=0.33, speed=1e-3, cutoff=10)
    for kind, array in (("mode energy", computed("impact").mode_energies), ("driven mode", slow.mode_energies)):
        assert sorted(array.dtype.names) == sorted(QUANTITIES[kind])


def test_rods_have_their_own_units_at_every_instant():
    path = computed("trajectory")
    units = path._units_of(path._columns())
    assert (units["time"], units["force"], units["time_si"], units["force_si"]) == ("L/c", "EA", "s", "N")
    assert "R/c" not in repr(path) and "contact time 2" in repr(computed("impact-rod"))
