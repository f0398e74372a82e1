"""The force of an impact in time, and what a receiver records of it."""

import builtins
import csv
import pickle
import sys
import types

import numpy as np
import pytest
import stoss

STEEL, GLASS = stoss.materials["bearing steel"], stoss.materials["glass"]
BALL = stoss.Sphere(radius=1.5e-3, material=STEEL)
PLATE = stoss.Plate(thickness=0.02, material=GLASS)
OF_IT = "--body sphere --material 'bearing steel' --radius 0.0015 --against plate,material=glass,thickness=0.02"


pytestmark = pytest.mark.filterwarnings("ignore::stoss.StossWarning")  # glass may be cracked


@pytest.fixture(scope="module")
def hit():
    return stoss.pulse(BALL, speed=0.5, against=PLATE)


@pytest.fixture(scope="module")
def below(hit):
    return hit.at(depth=0.02)


def test_it_is_that_of_the_command(hit, command):
    made = command(f"pulse {OF_IT} --speed 0.5 --depth 0.02")["records"][0]
    for name in ("peak_force", "contact_time", "impulse", "asymmetry", "corner_frequency", "from_hertz"):
        assert getattr(hit, name) == made[name]
    assert hit.peak_force_si == made["peak_force_si"] and hit.contact_time_si_error == made["contact_time_si_error"]
    assert np.allclose(hit.force_si, made["force"], rtol=1e-15) and np.array_equal(hit.amplitude, made["amplitude"])
    seen = hit.at(depth=0.02, points=400)
    for name in ("normal", "normal_velocity", "radial"):
        assert np.allclose(getattr(seen, f"{name}_si"), made[name], rtol=1e-14)
    assert seen.arrival_si == made["arrival_si"]


def test_its_force_moves_the_ball(hit):
    step = hit.time_si[1] - hit.time_si[0]
    assert np.sum(hit.force_si) * step == pytest.approx(hit.impulse_si, rel=1e-4)
    assert hit.impulse_si == pytest.approx(4 / 3 * np.pi * 1.5e-3**3 * STEEL.density * 0.5 * (1 + hit.restitution), rel=2e-3)
    assert hit.hertz_si.max() == pytest.approx(hit.peak_force_si, rel=0.1)
    assert len(hit) == hit.time.size == 400 and hit.converged and not hit.reason


def test_it_is_pickled_as_its_inputs(hit, below):
    again = pickle.loads(pickle.dumps(hit))
    assert np.array_equal(again.force, hit.force) and repr(again) == repr(hit)
    assert np.array_equal(pickle.loads(pickle.dumps(below)).normal, below.normal)


def test_a_receiver_on_the_other_face_moves_when_waves_arrive(below):
    quiet = below.time_si < 0.98 * below.arrival_si
    assert (np.abs(below.normal_si[quiet]) <= below.normal_si_error[quiet]).all()
    assert np.abs(below.normal_si[quiet]).max() < 1e-3 * below.normal_si.max()
    assert below.arrival_si == pytest.approx(0.02 / 5654.0, rel=0.01)  # c_p of glass
    assert below.radial.max() == 0.0 and len(below) == 500
    assert (below.normal_error < 0.01 * below.normal.max()).all()
    slope = np.gradient(below.normal_si, below.time_si)
    assert np.abs(slope - below.normal_velocity_si).max() < 0.05 * np.abs(slope).max()


def test_units_are_those_of_the_first_body():
    own = stoss.pulse(stoss.Sphere(poisson=0.3), speed=1e-3, against=stoss.HalfSpace(poisson=0.3))
    steel = stoss.Sphere(radius=0.01, material=stoss.Material(young=2e11, poisson=0.3, density=7850))
    scaled = stoss.pulse(steel, speed=1e-3 * steel.scales.speed, against=stoss.HalfSpace(material=steel.material))
    one, other = own.at(20.0), scaled.at(0.2)
    assert np.allclose(one.normal, other.normal, atol=1e-9 * one.normal.max())
    assert np.allclose(other.normal_si, 0.01 * other.normal) and other.distance_si == pytest.approx(0.2)
    with pytest.raises(AttributeError, match="no material"):
        _ = one.normal_si


def test_rows_and_tables(hit, below, tmp_path):
    hit.to_csv(tmp_path / "pulse.csv")
    table = stoss.read_csv(tmp_path / "pulse.csv")
    assert table.kind == "pulse" and np.array_equal(table["force"], hit.force) and table.units["force_si"] == "N"
    below.to_csv(tmp_path / "seismogram.csv")
    table = stoss.read_csv(tmp_path / "seismogram.csv")
    assert table.kind == "seismogram" and table.units["normal_velocity_si"] == "m/s" and table.size == 500
    assert below[3]["normal"] == below.normal[3] and len(below[10:20]) == 10


def test_files(hit, below, tmp_path):
    hit.write(tmp_path / "source.txt")
    assert np.array_equal(np.loadtxt(tmp_path / "source.txt"), np.column_stack([hit.time_si, hit.force_si]))
    below.write(tmp_path / "below.txt", trace="normal_velocity")
    assert np.array_equal(np.loadtxt(tmp_path / "below.txt")[:, 1], below.normal_velocity_si)
    below.write(tmp_path / "below.npz")
    with np.load(tmp_path / "below.npz") as held:
        assert np.array_equal(held["normal_si"], below.normal_si) and "normal_velocity_si_error" in held
    below.write(tmp_path / "below.csv")
    with open(tmp_path / "below.csv", encoding="utf-8") as stream:
        rows = list(csv.DictReader(line for line in stream if not line.startswith("#")))
    assert len(rows) == 500


def test_seismic_files_are_written_by_obspy(below, hit, tmp_path, monkeypatch):
    try:
        import obspy
    except ModuleNotFoundError:
        obspy = None
    if obspy is not None:
        for name, count in (("below.sac", 1), ("below.mseed", 4)):
            below.write(tmp_path / name)
            stream = obspy.read(str(tmp_path / name))
            assert len(stream) == count and stream[0].stats.npts == 500
            assert stream[0].stats.delta == pytest.approx(below.time_si[1] - below.time_si[0], rel=1e-5)
            assert np.allclose(stream[0].data, below.normal_si, rtol=1e-6, atol=1e-6 * below.normal_si.max())
        return
    written = []

    class Stream(list):
        def write(self, path, format):
            written.append((format, [(trace.header["channel"], trace.data) for trace in self]))

    class Trace:
        def __init__(self, data, header):
            self.data, self.header = data, header

    made = types.ModuleType("obspy")
    made.Stream, made.Trace, made.UTCDateTime = Stream, Trace, lambda second: float(second)
    monkeypatch.setitem(sys.modules, "obspy", made)
    below.write(tmp_path / "below.sac", trace="radial")
    below.write(tmp_path / "below.mseed")
    hit.write(tmp_path / "force.sac")
    assert [(kind, [name for name, _ in traces]) for kind, traces in written] == [
        ("SAC", ["XYR"]), ("MSEED", ["XYZ", "XYR", "XVZ", "XVR"]), ("SAC", ["XYF"])]  # fmt: skip
    assert np.array_equal(written[1][1][2][1], below.normal_velocity_si)


def test_without_obspy_a_refusal_names_it(below, tmp_path, monkeypatch):
    usual = builtins.__import__

    def none(name, *others):
        if name == "obspy":
            raise ModuleNotFoundError("no obspy", name="obspy")
        return usual(name, *others)

    monkeypatch.delitem(sys.modules, "obspy", raising=False)
    monkeypatch.setattr(builtins, "__import__", none)
    with pytest.raises(stoss.InvalidInput, match=r"needs obspy: pip install obspy"):
        below.write(tmp_path / "below.sac")
    assert not (tmp_path / "below.sac").exists()


@pytest.mark.parametrize("given, line", {
    "distance=-1.0": "distance: got -1", "depth=0.03": "depth: got", "distance=1e-5": "twice the radius of the contact",
    "depth=0.02, points=1": "points: got 1", "depth=0.02, until=0.0": "until: got 0",
}.items())  # fmt: skip
def test_receivers_are_refused_in_one_line(hit, given, line):
    with pytest.raises(stoss.InvalidInput, match=line):
        eval(f"hit.at({given})", {"hit": hit})


def test_others_are_refused(tmp_path):
    wall = stoss.pulse(stoss.Sphere(poisson=0.3), speed=0.1)
    with pytest.raises(stoss.InvalidInput, match="against: got .*, allowed a half-space or a plate"):
        wall.at(3.0)
    with pytest.raises(stoss.InvalidInput, match="without a material"):
        wall.write(tmp_path / "force.sac")
    with pytest.raises(stoss.InvalidInput, match="a name that ends with .csv"):
        wall.write(tmp_path / "force.wav")
    with pytest.raises(stoss.NotConverged, match="pulse: no cutoff") as caught:
        stoss.pulse(poisson=0.3, speed=0.1, tolerance=1e-4)
    assert not caught.value.best.converged and caught.value.best.peak_force > 0.0
