"""Results: shapes, frozen, a line that says the essential, to_dict, to_csv."""

import copy
import csv
import dataclasses
import json
import os
import pickle
import pydoc
import stat
import tempfile
from pathlib import Path

import numpy as np
import pytest

import stoss

NOBODY = 65534  # whom modes of files bind even where the tests run as root


@pytest.fixture(scope="module")
def results(hit, curve, steel):
    """One of every kind, with and without a material."""
    return {
        "number": stoss.restitution(poisson=0.33, speed=0.1, tolerance=1e-2),
        "curve": curve,
        "empty": stoss.restitution(poisson=0.33, speed=[], tolerance=1e-2),
        "steel": stoss.restitution(steel, speed=[5, 50], tolerance=1e-2),
        "impact": hit,
        "soft impact": stoss.impact(steel, speed=50, cutoff=8, against=stoss.ExponentialWall()),
        "rod": stoss.impact(stoss.Rod(), speed=0.1, cutoff=50),
        "pair": stoss.impact(steel, against="same", speed=50, cutoff=4),
        "pairs": stoss.restitution(poisson=[0.3, 0.4], against="same", speed=0.1, tolerance=1e-2),
        "oblique": stoss.oblique(stoss.Sphere(poisson=0.3), speed=0.1, tangential=0.1, friction=0.1),
        "oblique steel": stoss.oblique(steel, speed=50, angle=[30, 60], friction=0.1, tolerance=0.1),
        "trajectory": hit.trajectory(every=10),
        "field": hit.field(time=[2, 1], radius=[0.0, 0.5, 1.0], angle=[0.0, 3.0]),
        "frame": hit.field(time=2, radius=[0.0, 1.0], angle=[0.0, 3.0]),
        "modes": stoss.modes(poisson=0.33, cutoff=6),
        "steel modes": stoss.modes(steel, cutoff=6),
    }


KINDS = ("number", "curve", "empty", "steel", "impact", "soft impact", "rod", "oblique", "oblique steel", "trajectory",
         "field", "frame", "modes", "steel modes")  # fmt: skip


@pytest.fixture(params=KINDS)
def result(request, results):
    return results[request.param]


def values(result):
    return {field.name: getattr(result, field.name) for field in dataclasses.fields(result)}


def test_fields_are_read_only(result):
    for name, value in values(result).items():
        with pytest.raises(dataclasses.FrozenInstanceError):
            setattr(result, name, value)
        with pytest.raises(dataclasses.FrozenInstanceError):
            delattr(result, name)
        if isinstance(value, np.ndarray):
            assert not value.flags.writeable, name
            if value.size:
                with pytest.raises(ValueError, match="read-only"):
                    value[...] = value
    with pytest.raises(dataclasses.FrozenInstanceError):
        result.something_new = 1


def test_bodies_walls_and_materials_are_values(steel):
    for one, other in (
        (stoss.Disk(poisson=0.3), stoss.Disk(poisson=0.4)), (stoss.Rod(), stoss.Disk(poisson=0.3)),
        (stoss.HardWall(), stoss.HalfPlane()), (stoss.ExponentialWall(), stoss.ExponentialWall(hardness=9)),
        (steel, stoss.Disk(radius=0.01, material=steel.material, plane="strain")),
        (steel.material, dataclasses.replace(steel.material, poisson=0.2)),
        (stoss.Disk(poisson=0.3, radius=2), stoss.Disk(poisson=0.3, young=2)), (stoss.Rod(area=2), stoss.Rod(length=3)),
        (stoss.Rod(length=1, area=1e-4, material=steel.material), stoss.Rod()),
    ):  # fmt: skip
        twin = copy.deepcopy(pickle.loads(pickle.dumps(one)))
        assert one == twin and hash(one) == hash(twin) and repr(one) == repr(twin)
        assert one != other and len({one, twin, other}) == 2
        assert eval(repr(one), {**vars(stoss)}) == one
        for field in dataclasses.fields(one):
            with pytest.raises(dataclasses.FrozenInstanceError):
                setattr(one, field.name, getattr(one, field.name))


def test_arrays_are_not_copied(hit):
    for array in (hit.mode_energies, hit.trajectory().force, stoss.modes(poisson=0.33, cutoff=6).omega):
        assert not array.flags.owndata
    # The memory stays while an array is in use.
    omega = stoss.modes(poisson=0.33, cutoff=6).omega
    energies = stoss.impact(poisson=0.33, speed=0.1, cutoff=6).mode_energies
    expected = omega.tolist()
    _ = [stoss.impact(poisson=0.2, speed=0.1, cutoff=6).trajectory() for _ in range(9)]
    assert omega.tolist() == expected and sorted(energies["omega"].tolist()) == sorted(expected)


def test_repr_is_a_line_that_says_the_essential(result):
    text = repr(result)
    assert text.startswith(type(result).__name__ + "(") and text.isprintable() and len(text) <= 160
    if hasattr(result, "restitution") and np.ndim(result.restitution) == 0:
        shown = float(text.partition("restitution ")[2].split()[0].rstrip(",)"))
        assert abs(shown - result.restitution) < 0.005 and str(result.speed)[:6] in text
    assert str(result) == text


def test_identity_is_equality(result):
    assert result == result != copy.copy(result) and result != 1 and hash(result) == hash(result)


def test_dict_is_plain(result):
    def is_plain(value):
        if type(value) is dict:
            return all(type(key) is str and is_plain(each) for key, each in value.items())
        return all(map(is_plain, value)) if type(value) is list else type(value) in (float, int, bool, str)

    got = result.to_dict()
    assert is_plain(got) and json.loads(json.dumps(got)) == got
    for name, value in values(result).items():
        if isinstance(value, (float, int, str)):
            assert got[name] == value
        elif isinstance(value, np.ndarray) and not value.dtype.names:
            assert got[name] == value.tolist()
    assert all(name in got for name in ("speed_si", "max_force_si") if hasattr(result, name))


def read(path):
    """Provenance, names, units and columns of a CSV file."""
    lines = path.read_text(encoding="utf-8").splitlines()
    head = [line[2:] for line in lines if line.startswith("# ")]
    (names, *rows) = csv.reader(line for line in lines if not line.startswith("#"))
    units = {name.partition("[")[0]: name.partition("[")[2].rstrip("]") for name in names}
    return head, units, dict(zip(units, zip(*rows) if rows else [()] * len(units)))


def test_csv_has_every_bit(result, tmp_path):
    path = tmp_path / "result.csv"
    result.to_csv(path)
    head, units, columns = read(path)
    assert head[0].startswith(f"stoss {stoss.__version__}: ") and len(head) >= 2
    written = {"true": True, "false": False}
    for name, column in columns.items():
        expected = np.ravel(getattr(result, name)).tolist()
        if isinstance(result, stoss.Field) and len(expected) < len(column):  # values repeat, row by row
            expected, column = sorted(set(expected)), sorted(set(column), key=float)
        got = [written[text] if text in written else type(like)(text) for text, like in zip(column, expected)]
        assert len(column) == len(expected) and got == expected, name
    known = {"speed": "c", "contact_time": "R/c", "max_force": "piRE", "contact_time_si": "s", "max_force_si": "N/m",
             "omega": "c/R", "x": "R", "stress_rr": "E", "angle": "rad", "restitution": ""}  # fmt: skip
    if isinstance(getattr(result, "body", None), stoss.Rod):
        known |= {"contact_time": "L/c", "max_force": "EA"}
    assert all(known[name] == unit for name, unit in units.items() if name in known)
    assert len({len(column) for column in columns.values()}) == 1


def test_csv_goes_where_it_should(hit, tmp_path):
    target, link = tmp_path / "a file.csv", tmp_path / "link.csv"
    hit.to_csv(str(target))
    text = target.read_text()
    link.touch()  # with the mode of any new file
    assert target.stat().st_mode == link.stat().st_mode
    link.unlink()
    target.write_text("old")
    target.chmod(0o640)
    link.symlink_to(target.name)
    hit.to_csv(link)
    assert link.is_symlink() and target.read_text() == text and stat.S_IMODE(target.stat().st_mode) == 0o640
    for bad in (tmp_path, tmp_path / "none" / "x.csv", target / "x.csv"):
        with pytest.raises(OSError):
            hit.to_csv(bad)
    if os.path.exists("/dev/full"):
        with pytest.raises(OSError):
            hit.to_csv("/dev/full")
    assert sorted(os.listdir(tmp_path)) == ["a file.csv", "link.csv"]


# Files that may not be written, and a disk that is full after 100 bytes.
FORBIDDEN = """
import os, resource, signal, stoss
hit = stoss.impact(poisson=0.33, speed=0.1, cutoff=8)
def refused(path):
    try:
        hit.to_csv(path)
    except OSError:
        return True
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
unlimited = resource.getrlimit(resource.RLIMIT_FSIZE)
resource.setrlimit(resource.RLIMIT_FSIZE, (100, unlimited[1]))
assert refused("free/old.csv") and refused("free/new.csv")
resource.setrlimit(resource.RLIMIT_FSIZE, unlimited)
if os.geteuid() == 0:
    os.setuid({user})
assert refused("locked/new.csv") and refused("free/read-only.csv")
"""


def test_csv_appears_whole_or_not_at_all(interpreter):
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        for name, mode in (("locked", 0o555), ("free", 0o777)):
            place = Path(folder, name)
            place.mkdir()
            for old, its_mode in (("old.csv", 0o666), ("read-only.csv", 0o444)):
                (place / old).write_text("kept")
                (place / old).chmod(its_mode)
            place.chmod(mode)
        done = interpreter.run(FORBIDDEN.format(user=NOBODY), cwd=folder)
        assert done.returncode == 0, done.stderr
        left = {str(path.relative_to(folder)): path.read_text() for path in Path(folder).glob("*/*")}
        assert left == {f"{name}/{old}.csv": "kept" for name in ("locked", "free") for old in ("old", "read-only")}


def test_help():
    for name in set(stoss.__all__) - {"__version__"}:
        assert len(pydoc.render_doc(getattr(stoss, name), renderer=pydoc.plaintext)) > 100
