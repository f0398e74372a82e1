"""What a drop test shows: shapes, the numbers of the command, refusals, warnings, files."""

import json
import math
import os
import pickle
import subprocess
import warnings

import numpy as np
import pytest

import stoss

STEEL, GLASS, ICE = (stoss.materials[name] for name in ("bearing steel", "glass", "ice"))
BALL, BLOCK = stoss.Sphere(radius=5e-3, material=STEEL), stoss.HalfSpace(material=GLASS)
GRAIN = stoss.Sphere(radius=1e-6, material=ICE)
SPEEDS = [[0.1, 5.0], [10.0, 100.0]]
CHANNELS = ("ringing", "radiation", "material", "yielding", "adhesion")
NUMBERS = ("speed", "restitution", "restitution_error", "by_models", "by_constants", "models_low", "models_high",
           "restitution_without_models", "restitution_without_models_error", *CHANNELS, "drop_height", "rebound_height")  # fmt: skip


def quietly(*given, **named):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", stoss.StossWarning)
        return stoss.predict(*given, **named)


@pytest.fixture(scope="module")
def grains():
    return quietly(GRAIN, against="same", speed=SPEEDS, adhesion=0.2)


@pytest.fixture(scope="module")
def drop():
    return quietly(BALL, against=BLOCK, speed=0.1)


def test_a_number_gives_numbers(drop):
    assert all(type(getattr(drop, name)) is float for name in (*NUMBERS, "contact_time"))
    assert drop.dominant == "radiation" and isinstance(drop.warnings, tuple)
    assert all(isinstance(each, stoss.Influence) for each in drop.influences)
    with pytest.raises(TypeError, match="no len"):
        len(drop)


def test_arrays_have_the_shape_of_the_speed(grains):
    for name in (*NUMBERS, "contact_time", "dominant", "influences", "warnings"):
        column = getattr(grains, name)
        assert column.shape == (2, 2) and not column.flags.writeable, name
    assert grains.speed.tolist() == SPEEDS and len(grains) == 2
    assert isinstance(grains.influences[0, 0], tuple) and isinstance(grains.warnings[0, 0], tuple)


def test_indices_select(grains):
    one = grains[0, 1]
    alone = quietly(GRAIN, against="same", speed=5.0, adhesion=0.2)
    assert one.to_dict() == alone.to_dict()
    assert grains[0].restitution.tolist() == grains.restitution[0].tolist()
    fast = grains[grains.speed > 5]
    assert fast.speed.tolist() == [10, 100] and fast.warnings[1] == grains.warnings[1, 1]
    assert fast[0].influences == grains.influences[1, 0]


def test_no_speed_gives_nothing():
    empty = stoss.predict(BALL, against=BLOCK, speed=[])
    assert len(empty) == 0 and empty.restitution.shape == (0,)


def test_energy_is_that_of_the_channels(grains, drop):
    for made in (grains, drop):
        lost = sum(getattr(made, name) for name in CHANNELS)
        np.testing.assert_allclose(lost, 1 - np.square(made.restitution), rtol=1e-9, atol=1e-12)
        assert np.all(made.models_low <= made.restitution) and np.all(made.restitution <= made.models_high)


def test_without_models_it_is_the_restitution_of_lossy_bodies():
    ball = stoss.Sphere(radius=5e-3, material=STEEL, loss_time=1e-8)
    block = stoss.HalfSpace(material=GLASS, loss_time=2e-8)
    made = quietly(ball, against=block, speed=[0.01, 1], adhesion=0)
    direct = stoss.restitution(ball, against=block, speed=[0.01, 1])
    assert not made.yielding.any() and not made.adhesion.any()
    allowed = made.restitution_without_models_error + direct.restitution_error
    assert np.all(np.abs(made.restitution_without_models - direct.restitution) <= allowed)
    assert made.restitution == pytest.approx(made.restitution_without_models, rel=1e-9)


def test_balls_stick_below_a_speed(grains):
    slow = grains[0, 0]
    assert slow.speed < slow.sticking_speed and slow.restitution == 0 and slow.contact_time == math.inf
    assert slow.dominant == "adhesion" and slow.rebound_height == 0
    assert slow.adhesion_speed == pytest.approx(10 * slow.sticking_speed) and slow.yield_speed is None


def test_yielding_begins_where_it_does():
    made = quietly(BALL, against=stoss.HalfSpace(material=STEEL), speed=[0.3, 20.0])
    begins = stoss.quasistatic.yield_speed(BALL, against=stoss.HalfSpace(material=STEEL))
    assert made.yield_speed == pytest.approx(begins, rel=1e-12)
    assert 0.3 < made.yield_speed <= made.impression_speed
    assert made.yielding[0] == 0 and made.restitution[1] < 0.8 * made.restitution_without_models[1]
    assert made.dominant[1] == "yield" and made.models_low[1] < made.restitution[1]


def test_height_is_that_of_a_fall(drop):
    fallen = quietly(BALL, against=BLOCK, height=[0.01, drop.drop_height])
    assert fallen.speed[0] == pytest.approx(math.sqrt(2 * 9.80665 * 0.01), rel=1e-12)
    assert fallen.drop_height == pytest.approx([0.01, drop.drop_height], rel=1e-12)
    assert fallen.rebound_height == pytest.approx(fallen.restitution**2 * fallen.drop_height)
    assert fallen.restitution[1] == pytest.approx(drop.restitution, rel=1e-9)


PLATE = "plate,material=glass,thickness=0.01"
CASES = {
    "block": ("bearing steel", 0.005, "half-space,material=glass", "",
              lambda: quietly(BALL, against=BLOCK, speed=[0.1, 20])),
    "same": ("ice", 1e-6, "same", "--adhesion 0.2",
             lambda: quietly(GRAIN, against="same", speed=[0.1, 20], adhesion=0.2)),
    "wall": ("bearing steel", 0.005, "wall", "", lambda: quietly(BALL, speed=[0.1, 20])),
    "plate": ("bearing steel", 0.005, PLATE, "--tolerance 0.01",
              lambda: quietly(BALL, against=stoss.Plate(thickness=0.01, material=GLASS), speed=[0.1, 20],
                              tolerance=0.01)),
    "own loss": ("bearing steel", 0.005, "half-space,material=glass,loss_time=0", "--uncertainty young=0.5",
                 lambda: quietly(BALL, against=stoss.HalfSpace(material=GLASS, loss_time=0), speed=[0.1, 20],
                                 uncertainties={"young": 0.5})),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_numbers_are_those_of_the_command(case, run_command):
    material, radius, against, more, ours = CASES[case]
    words = ["predict", "--body", "sphere", "--material", material, "--radius", str(radius), "--against", against]
    document = run_command([*words, "--speed", "0.1,20", *more.split()])
    result = ours()
    told = result.to_dict()
    for k, record in enumerate(document["records"]):
        for name, value in record.items():
            same = told[name][k] == value if isinstance(value, (str, list, type(None))) else None
            assert same if same is not None else told[name][k] == pytest.approx(value, rel=1e-12), name


@pytest.fixture(scope="module")
def run_command():
    def run(words):
        whole = [os.environ["STOSS"], *words, "--format", "json", "--quiet"]
        return json.loads(subprocess.run(whole, capture_output=True, text=True, timeout=120, check=True).stdout)

    return run


def test_a_material_of_ones_own_has_no_name(drop):
    ball = stoss.Sphere(radius=5e-3, material=stoss.Material(**vars(STEEL) | {"density": 7810.5}))
    made = quietly(ball, against=BLOCK, speed=0.1, uncertainties={"young": 0.05})
    assert {each.constant for each in made.influences if not each.constant.startswith("against")} == {"young"}
    assert {each.constant for each in drop.influences} >= {"young", "density", "loss_time", "against.young"}
    assert drop.by_constants == pytest.approx(math.hypot(*(each.change for each in drop.influences)), rel=1e-9)
    assert all(abs(a.change) >= abs(b.change) for a, b in zip(drop.influences, drop.influences[1:]))


def test_surface_energies_make_bodies_stick():
    sticky = stoss.Material(young=2e6, poisson=0.49, density=1100, loss_time=0, surface_energy=0.05)
    meeting = {"body": stoss.Sphere(radius=1e-5, material=sticky), "against": "same", "speed": 1.0}
    made, given, smooth = (quietly(**meeting, **more) for more in ({}, {"adhesion": 0.1}, {"adhesion": 0}))
    assert made.sticking_speed == given.sticking_speed > smooth.sticking_speed == 0
    assert made.restitution == given.restitution < smooth.restitution


REFUSALS = [
    (dict(body=stoss.Disk(poisson=0.3), against=None), "body: got a disk, allowed a sphere"),
    (dict(body=3), "body: got 3"),
    (dict(body=stoss.Sphere(poisson=0.3), against=None), "material: missing .the ball needs one"),
    (dict(speed=1e9), "speed: got 1000000000, allowed 5.18"),
    (dict(speed=0), "speed: got 0, allowed 5.18"),
    (dict(speed="fast"), "speed: got 'fast', allowed a number"),
    (dict(height=1.0), "speed: got speed and height, allowed one"),
    (dict(speed=None), "speed: got neither, allowed one"),
    (dict(speed=None, height=[1.0, 0.0]), "height: got 0.0, allowed above 0"),
    (dict(speed=None, height=np.inf), "height: got inf, allowed 0 or more"),
    (dict(adhesion=-1), "adhesion: got -1, allowed 0 to 1e6"),
    (dict(adhesion=[1, 2]), r"adhesion: got \[1, 2\], allowed one number"),
    (dict(uncertainties={"yong": 0.1}), "uncertainties: got 'yong', allowed work_of_adhesion, young"),
    (dict(uncertainties={"young": 11}), "uncertainties young: got 11, allowed 0 to 10"),
    (dict(uncertainties={"young": "a"}), "uncertainties young: got 'a', allowed a number"),
    (dict(uncertainties=0.1), "uncertainties: got 0.1, allowed a mapping"),
    (dict(tolerance=2), "tolerance: got 2, allowed 1e-15 to 0.5"),
    (dict(threads=-1), "threads: got -1, allowed 0 to 1024"),
    (dict(against="wall"), "against: got 'wall', allowed None, 'same'"),
    (dict(against=stoss.HalfSpace()), "against: needs a material too"),
    (dict(against=stoss.ExponentialWall()), "against: got exponential, allowed wall, same"),
    (dict(against=stoss.Disk(poisson=0.3)), "against: got disk for a sphere"),
]  # fmt: skip


@pytest.mark.parametrize("given, said", REFUSALS, ids=[said for _, said in REFUSALS])
def test_refusals(given, said):
    named = {"body": BALL, "against": BLOCK, "speed": 0.1, **given}
    with pytest.raises(stoss.InvalidInput, match=f"^{said}") as raised:
        stoss.predict(named.pop("body"), **named)
    assert "\n" not in str(raised.value)


def test_a_surface_energy_is_in_range():
    for energy in (-0.1, 2e6, math.nan):
        with pytest.raises(stoss.InvalidInput, match="^surface_energy: got .*, allowed 0 to 1e6"):
            stoss.Material(young=1e9, poisson=0.3, density=1e3, surface_energy=energy)
    assert GLASS.surface_energy > 0 and STEEL.surface_energy is None and "surface_energy=" in repr(GLASS)


def test_each_warning_is_said_once():
    with pytest.warns(stoss.StossWarning) as caught:
        made = stoss.predict(GRAIN, against="same", speed=[0.1, 0.2, 5.0, 100.0], adhesion=0.2)
    said = [str(each.message) for each in caught]
    assert len(said) == len(set(said)) and set(said) == {text for each in made.warnings for text in each}
    assert any(text.startswith("sticks below") for text in said) and all(each.filename == __file__ for each in caught)
    assert any(text.startswith("sticks below") for text in made.warnings[0])
    assert not any(text.startswith("sticks below") for text in made.warnings[3])


def test_nothing_to_warn_of():
    known = stoss.Material(young=2.1e11, poisson=0.3, density=7850, yield_strength=1e10, loss_time=0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        made = stoss.predict(stoss.Sphere(radius=0.01, material=known), speed=0.1)
    assert made.warnings == () and made.influences == ()


def test_the_line_says_the_essential(drop, grains):
    of = "Prediction(Sphere(poisson=0.3, radius=0.005 m) against HalfSpace(poisson=0.22), speed=0.1 m/s: restitution "
    assert repr(drop).startswith(of)
    assert ", most to radiation)" in repr(drop)
    assert "4 values" in repr(grains) and "against 'same'" in repr(grains) and "0.1 to 100 m/s" in repr(grains)


def test_files_and_tables_name_the_channel_yield(grains, tmp_path):
    grains.to_csv(tmp_path / "drop.csv")
    table = stoss.read_csv(tmp_path / "drop.csv")
    assert table.kind == "predict" and table.size == 4 and "yielding" not in table
    for name, column in table.items():
        assert column.tolist() == getattr(grains, "yielding" if name == "yield" else name).ravel().tolist(), name
    assert table.units == {"speed": "m/s", "drop_height": "m", "rebound_height": "m", "contact_time": "s"}
    assert table.inputs["against"] == "same" and table.inputs["work_of_adhesion"] == "0.2"
    told = json.loads(json.dumps(grains.to_dict(), allow_nan=False))
    assert told["yield"] == grains.yielding.tolist() and told["contact_time"][0][0] is None
    assert told["influences"][1][1][0]["constant"] == "loss_time" and "<table" in grains._repr_html_()


def test_results_are_frozen_and_survive_pickle(grains):
    with pytest.raises(AttributeError):
        grains.restitution = 1.0
    assert pickle.loads(pickle.dumps(grains)).to_dict() == grains.to_dict()
