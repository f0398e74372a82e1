"""Bodies on a line: cradles by finite elements, the command, motion in time, shapes, refusals, pictures, films."""

import copy
import json
import pickle

import numpy as np
import pytest
import stoss

BALL, ROD = stoss.Sphere(poisson=0.3), stoss.Rod()
STEEL = stoss.Sphere(radius=5e-3, material=stoss.materials["bearing steel"])
LEDGER = ("translation", "vibration", "contact", "unresolved", "dissipated", "yielded")
OF_STEEL = "row --body sphere --material 'bearing steel' --radius 0.005"


@pytest.fixture(scope="module")
def cradle():
    return stoss.row([BALL] * 3, speed=[0.1])


@pytest.fixture(scope="module")
def motion():
    return stoss.row_impact([BALL] * 3, speed=[0.1])


# Velocities over the first speed, by spectral finite elements of our own, to 2e-5 (ball after ball, smooth and hard).
@pytest.mark.parametrize("count, speed, expected", [
    (3, 0.1, [-0.02709, 0.03197, 0.99512]), (3, 0.02, [-0.04760, 0.05040, 0.99720]),
    (5, 0.1, [-0.02709, -0.00827, -0.00279, 0.04338, 0.99477]),
])  # fmt: skip
def test_cradles_by_finite_elements(count, speed, expected):
    found = stoss.row([BALL] * count, speed=[speed])
    after, error = found.velocities_after / speed, found.velocities_after_error / speed
    assert found.converged and (error < 1e-3).all() and (np.abs(after - expected) < error + 2e-5).all()


def test_momentum_and_energy(cradle):
    assert cradle.velocities_after.sum() == pytest.approx(0.1, abs=1e-13)
    shares = cradle.translation + cradle.vibration + cradle.unresolved + cradle.dissipated + cradle.yielded
    assert shares == pytest.approx(1, abs=1e-4)
    assert abs(cradle.energy_error) < 1e-4 and abs(cradle.momentum_error) < 1e-12
    assert (cradle.velocities_after**2).sum() / 0.01 == pytest.approx(cradle.translation, abs=1e-12)
    assert cradle.contacts["impulse"][1] == pytest.approx(cradle.velocities_after[2], abs=1e-12)


@pytest.mark.parametrize("words, ask", [
    ("row --body sphere --poisson 0.3 --count 3 --speed 0.1", lambda: stoss.row([BALL] * 3, speed=0.1)),
    ("row --body disk --poisson 0.3 --count 2 --speed 0.01,0.01 --against wall --gap 0.001 --tolerance 0.01",
     lambda: stoss.row([stoss.Disk(poisson=0.3)] * 2, speed=[0.01, 0.01], against="wall", gaps=1e-3, tolerance=0.01)),
    (f"{OF_STEEL} --count 2 --speed=-0.1,-0.1 --before wall --tolerance 0.01",
     lambda: stoss.row([STEEL] * 2, speed=[-0.1] * 2, before="wall", tolerance=0.01)),
    ("row --body sphere --poisson 0.3 --count 2 --speed 0.01 --mode 2,0,energy=0.1,phase=2,body=1 --tolerance 0.01",
     lambda: stoss.row([BALL] * 2, speed=0.01, tolerance=0.01,
                       vibration=stoss.Oscillation(2, 0, energy=0.1, phase=2.0, of=1))),
])  # fmt: skip
@pytest.mark.filterwarnings("ignore::stoss.StossWarning")
def test_values_of_the_command(words, ask, command):
    result, (record,) = ask(), command(words)["records"]
    assert result.velocity_unit == record["velocity_unit"]
    for name in ("velocities", "velocities_after", "velocities_after_error"):
        assert getattr(result, name).tolist() == pytest.approx(record[name], rel=1e-12, abs=1e-300)
    assert result.translation == record["translation"] and result.duration == record["duration"]
    assert result.to_dict()["contacts"] == [{name: each.get(name) for name in result.contacts.dtype.names}
                                            for each in record["contacts"]]  # fmt: skip


def test_files_have_the_columns_of_the_command(tmp_path):
    result = stoss.row([STEEL] * 3, speed=[0.1], tolerance=0.01)
    result.to_csv(tmp_path / "row.csv")
    table = stoss.read_csv(tmp_path / "row.csv")
    assert table["number"].tolist() == [0, 1, 2]
    assert table["velocity_after_si"].tolist() == result.velocities_after.tolist()
    assert table["velocity_after"] == pytest.approx(result.velocities_after / STEEL.scales.speed)
    assert (table.units["velocity_after"], table.units["velocity_after_si"]) == ("c", "m/s")


def test_shapes():
    one = stoss.row([BALL] * 3, speed=[0.1, 0.02, 0.0], tolerance=0.01)
    assert one.velocities.tolist() == [0.1, 0.02, 0.0] and one.velocities_after.shape == (3,)
    assert one.contacts.shape == (2,) and type(one.translation) is float and one.reason == ""
    with pytest.raises(TypeError):
        len(one)
    several = stoss.row([BALL] * 3, speed=[[0.02, 0], [0.1, 0.02]], tolerance=0.01)
    assert several.velocities_after.shape == several.velocities_after_error.shape == several.velocities.shape == (2, 3)
    assert several.contacts.shape == (2, 2) and several.translation.shape == (2,) and len(several) == 2
    assert several[1].velocities_after.tolist() == one.velocities_after.tolist()
    assert several[several.velocities[:, 0] > 0.05].velocities.shape == (1, 3) and len(list(several)) == 2
    table = several.to_dataframe()
    assert table["case"].tolist() == [0, 0, 0, 1, 1, 1] and table["number"].tolist() == [0, 1, 2] * 2
    assert table["velocity_after"].tolist() == several.velocities_after.ravel().tolist()
    none = stoss.row([BALL] * 3, speed=np.empty((0, 3)))
    assert len(none) == 0 and none.velocities_after.shape == (0, 3)
    between = stoss.row_impact([BALL], speed=[0.05], before="wall", against="wall", gaps=[1, 1], until=60)
    assert between.contacts["left"].tolist() == [-1, 0] and (between.contacts["touches"] == 1).all()
    assert between.contacts["first_touch"][1] == pytest.approx(0, abs=0.1)


def test_threads_give_the_same_bits():
    speeds = [[0.1], [0.02], [0.05], [0.01]]
    one, two = (stoss.row([BALL] * 3, speed=speeds, tolerance=0.01, threads=threads) for threads in (1, 2))
    assert one.velocities_after.tobytes() == two.velocities_after.tobytes()
    assert one.contacts.tobytes() == two.contacts.tobytes()


def test_a_pair_is_a_pair(cradle):
    pair = stoss.row([BALL] * 2, speed=[0.1])
    restitution = (pair.velocities_after[1] - pair.velocities_after[0]) / 0.1
    its = stoss.restitution(BALL, against="same", speed=0.1)
    assert abs(restitution - its.restitution) < its.restitution_error + 2 * pair.velocities_after_error[0] / 0.1


def test_rods_are_exact():
    """Equal rods pass the velocity on."""
    assert stoss.row([ROD] * 3, speed=[0.1], tolerance=0.02).velocities_after == pytest.approx([0, 0, 0.1], abs=2e-3)


def test_motion(cradle, motion):
    times = len(motion)
    assert motion.time[0] <= 0 < motion.time[-1] and (np.diff(motion.time) > 0).all()
    assert motion.displacement.shape == motion.velocity.shape == (times, 3) and motion.force.shape == (times, 2)
    assert sum(getattr(motion, name) for name in LEDGER) == pytest.approx(1, abs=2e-3)
    assert (motion.velocity.sum(axis=1) == pytest.approx(0.1, abs=1e-12)) and (motion.force >= 0).all()
    assert motion.velocity[-1].tolist() == motion.velocities_after.tolist()
    assert (np.abs(motion.velocities_after - cradle.velocities_after) < 2 * cradle.velocities_after_error).all()
    assert motion.cutoff == 16.0 and motion.steps >= times - 1 and motion.contacts["left"].tolist() == [0, 1]
    assert motion.contacts["max_force"] == pytest.approx(motion.force.max(axis=0), rel=1e-2)
    fewer = stoss.row_impact([BALL] * 3, speed=[0.1], every=7, until=5.0)
    assert fewer.time[-1] == pytest.approx(5.0, abs=0.5) and len(fewer) < times / 7
    smaller = stoss.row_impact([BALL, stoss.Sphere(poisson=0.3, radius=0.1)], speed=[0.1], cutoff=8, until=1)
    assert smaller.cutoff > 8


def test_a_block_stands_on_the_right():
    found = stoss.row_impact([BALL], speed=[0.1], against=stoss.HalfSpace(), cutoff=2)
    assert found.against == stoss.HalfSpace(poisson=0.3) and found.velocities_after.shape == (1,)
    its = stoss.restitution(BALL, against=stoss.HalfSpace(), speed=0.1).restitution
    assert found.velocities_after[0] == pytest.approx(-0.1 * its, rel=2e-2)


@pytest.mark.filterwarnings("ignore::stoss.StossWarning")
def test_with_a_material_all_is_in_si():
    ball, large = (stoss.Sphere(radius=r, material=stoss.materials["bearing steel"], loss_time=0) for r in (5e-3, 8e-3))
    bare, unit = [stoss.Sphere(poisson=ball.poisson, radius=r) for r in (1, 1.6)], ball.scales.speed
    found = stoss.row([ball, large], speed=[0.02 * unit, -0.01 * unit], against="wall", gaps=[0, 1e-4], tolerance=0.01)
    own = stoss.row(bare, speed=[0.02, -0.01], against="wall", gaps=[0, 0.02], tolerance=0.01)
    assert found.velocities_after / unit == pytest.approx(own.velocities_after, rel=1e-6)
    assert found.velocity_unit == "m/s" and own.velocity_unit == "c"
    assert found.duration_si == pytest.approx(own.duration * ball.scales.time, rel=1e-6)


def test_si():
    found = stoss.row_impact([STEEL] * 2, speed=[0.1], until=5e-5, every=20)
    scales = STEEL.scales
    assert found.time_si.tolist() == (found.time * scales.time).tolist()
    assert found.time_si[-1] == pytest.approx(5e-5, rel=0.1)
    assert found.velocity_si[0, 0] == pytest.approx(0.1) and found.force_si.shape == found.force.shape
    assert found.displacement_si[-1] == pytest.approx(found.displacement[-1] * scales.length)
    assert found.contacts_si["max_force"][0] == pytest.approx(found.contacts["max_force"][0] * scales.force)
    assert found.contacts_si["touches"].tolist() == found.contacts["touches"].tolist()
    assert {"time_si", "velocity_1_si", "force_0_si"} <= set(found.to_dataframe().columns)
    assert (found._unit("force_0_si"), found._unit("velocity_1")) == ("N", "c")
    with pytest.raises(AttributeError, match="no material"):
        stoss.row([BALL] * 2, speed=0.1).contacts_si  # noqa: B018
    with pytest.warns(stoss.StossWarning, match="yields above"):
        stoss.row([STEEL] * 2, speed=[3.0], tolerance=0.01)


@pytest.mark.parametrize("bodies, given, message", [
    ([], {}, "bodies: got \\[\\], allowed a list of bodies"),
    (BALL, {}, "bodies: got Sphere.*, allowed a list"),
    ([BALL, 3], {}, "bodies: got 3, allowed a stoss.Disk or"),
    ([BALL], {}, "bodies"),
    ([BALL] * 101, {}, "bodies: got 101, allowed 2 to 100"),
    ([BALL, STEEL], {}, "bodies: got .*, allowed all with a material, or all without"),
    ([BALL, ROD], {}, ".*(sphere|rod)"),
    ([BALL] * 2, {"speed": [0.1, 0, 0]}, "speed: got 3 values, allowed 1 to 2"),
    ([BALL] * 2, {"speed": []}, "speed: got 0 values"),
    ([BALL] * 2, {"speed": np.zeros((1, 1, 1))}, "speed: got an array of shape"),
    ([BALL] * 2, {"speed": [float("nan")]}, "speed: got nan, allowed -1 to 1"),
    ([BALL] * 2, {"speed": [[0.1], [1.5]]}, "speed: got 1.5, allowed -1 to 1"),
    ([BALL] * 2, {"speed": "fast"}, "speed: got 'fast'"),
    ([BALL] * 2, {"speed": [-0.1]}, "speed: got no two bodies that meet"),
    ([BALL] * 2, {"gaps": [0, 0]}, "gaps: got 2 values, allowed 1"),
    ([BALL] * 2, {"gaps": -1.0}, "gap: got -1, allowed 0 to 1000"),
    ([BALL] * 2, {"gaps": [[0]]}, "gaps: got .*, allowed one finite number, or one"),
    ([BALL] * 2, {"before": stoss.HalfSpace()}, "before: got .*, allowed None, 'wall'"),
    ([BALL] * 2, {"before": stoss.HardWall(roughness=0.1)}, "before: got .* smooth"),
    ([BALL] * 2, {"against": stoss.ExponentialWall()}, "against: got .*, allowed None, 'wall'"),
    ([BALL] * 2, {"against": "same"}, "against: got 'same'"),
    ([BALL] * 2, {"tolerance": 0}, "tolerance: got 0, allowed 1e-06 to 1|tolerance: got 0, allowed 1e-6 to 1"),
    ([BALL] * 2, {"threads": -1}, "threads: got -1"),
    ([BALL] * 2, {"progress": 1}, "progress: got 1"),
    ([BALL] * 2, {"vibration": 0.1}, "vibration: got 0.1"),
    ([BALL] * 2, {"vibration": stoss.Oscillation(2, 0, energy=float("nan"))}, "energy: got nan"),
    ([BALL] * 2, {"vibration": stoss.Oscillation(2, 0, energy=0.1, of=2)}, "vibration body: got 2, allowed 0 to 1"),
])  # fmt: skip
def test_refusals(bodies, given, message):
    with pytest.raises(stoss.InvalidInput, match=f"^{message}") as caught:
        stoss.row(bodies, **{"speed": [0.1], **given})
    assert str(caught.value).isprintable() and len(str(caught.value)) < 300


@pytest.mark.parametrize("given, message", [
    ({"speed": [[0.1]]}, "speed: got .*, allowed one row"), ({"cutoff": 0}, "cutoff: got 0"),
    ({"cutoff": float("nan")}, "cutoff"), ({"until": 0}, "until: got 0"), ({"until": float("inf")}, "until"),
    ({"every": 0}, "every: got 0"), ({"every": 1.5}, "every: got 1.5"),
])  # fmt: skip
def test_refusals_of_motions(given, message):
    with pytest.raises(stoss.InvalidInput, match=f"^{message}"):
        stoss.row_impact([BALL] * 2, **{"speed": [0.1], **given})


def test_a_body_by_its_modes_stands_at_an_end():
    metal = stoss.Material(young=2.1e11, poisson=0.3, density=7850)
    ball = stoss.Sphere(radius=0.01, material=metal)
    modes, mass = stoss.modes(ball, cutoff=12.0), 4 / 3 * np.pi * 0.01**3 * 7850
    rising, unit = np.argsort(modes.omega), ball.scales.frequency / (2 * np.pi)
    modal = stoss.ModalBody(
        mass=mass, curvature=100.0, young=2.1e11, poisson=0.3, density=7850, compliance=-2.409003500541093e-10,
        complete_to=12.0 * unit, frequency=modes.omega[rising] * unit,
        displacement=modes.radial[rising] / np.sqrt(mass),
    )  # fmt: skip
    with pytest.raises(stoss.InvalidInput, match="."):
        stoss.row([ball, modal, ball], speed=[1.0])
    end, itself = (stoss.row([ball, ball, each], speed=[1.0], tolerance=0.01) for each in (modal, ball))
    error = end.velocities_after_error + itself.velocities_after_error
    assert (np.abs(end.velocities_after - itself.velocities_after) <= error).all()


def test_what_does_not_converge_is_marked():
    with pytest.raises(stoss.NotConverged, match="^row: ") as caught:
        stoss.row([ROD, stoss.Rod(length=1.3)], speed=[0.1], tolerance=1e-6)
    assert isinstance(caught.value.best, stoss.Row) and not caught.value.best.converged
    assert "not converged" in repr(caught.value.best)
    with pytest.warns(stoss.StossWarning, match="1 of 1 rows not as accurate"):
        several = stoss.row([ROD, stoss.Rod(length=1.3)], speed=[[0.1]], tolerance=1e-6)
    assert several.converged.tolist() == [False] and several.reason[0] and "1 not converged" in repr(several)


def test_copies(cradle, motion):
    for each in (cradle, motion):
        for again in (copy.deepcopy(each), pickle.loads(pickle.dumps(each))):
            assert json.dumps(again.to_dict()) == json.dumps(each.to_dict()) and repr(again) == repr(each)
    assert repr(cradle).startswith("Row(3 × Sphere(poisson=0.3): after -0.002708 ± ")
    assert repr(motion).startswith("RowImpact(3 × Sphere(poisson=0.3): after -0.0027")


def test_pictures(cradle, motion, closed):
    pytest.importorskip("matplotlib")
    bars = cradle.plot()
    before, after = (each for each in bars.containers if hasattr(each, "patches"))
    assert [each.get_height() for each in after.patches] == cradle.velocities_after.tolist()
    assert [each.get_height() for each in before.patches] == [0.1, 0, 0] and after.errorbar is not None
    upper, lower, *_ = motion.plot().child_axes
    assert [line.get_ydata().tolist() for line in upper.lines[:3]] == motion.velocity.T.tolist()
    assert lower.collections[0].get_array().max() == motion.force.max()
    several = stoss.row([BALL] * 3, speed=[[0.02], [0.1]], tolerance=0.01).plot()
    assert several.get_xlabel() == "greatest difference of speeds / c" and len(several.lines) > 3


def test_films(motion, tmp_path):
    pytest.importorskip("matplotlib")
    from PIL import Image

    assert motion.animate(tmp_path / "row.gif", frames=4) == tmp_path / "row.gif"
    two = [stoss.Rod(), stoss.Rod(length=2)]
    stopped = stoss.row_impact(two, speed=[0.1], against="wall", gaps=[0.01, 0.01], until=9)
    stoss.animate(stopped, tmp_path / "rods.gif", frames=3, size=(300, 120))
    for name, count in (("row.gif", 4), ("rods.gif", 3)):
        with Image.open(tmp_path / name) as film:
            assert film.n_frames == count and film.size[0] in (640, 300)
    with pytest.raises(stoss.InvalidInput, match="^quantity: got .*, allowed None for a row"):
        stoss.animate(motion, tmp_path / "row.gif", quantity="von_mises")
