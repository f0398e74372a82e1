"""What a drop test shows: shapes, the numbers of the command, refusals, warnings, files."""

import json
import math
import warnings

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


def test_balls_stick_below_a_speed(grains):
    slow = grains[0, 0]
    assert slow.speed < slow.sticking_speed and slow.restitution == 0 and slow.contact_time == math.inf
    assert slow.dominant == "adhesion" and slow.rebound_height == 0
    assert slow.adhesion_speed == pytest.approx(10 * slow.sticking_speed) and slow.yield_speed is None


def test_a_material_of_ones_own_has_no_name(drop):
    ball = stoss.Sphere(radius=5e-3, material=stoss.Material(**vars(STEEL) | {"density": 7810.5}))
    made = quietly(ball, against=BLOCK, speed=0.1, uncertainties={"young": 0.05})
    assert {each.constant for each in made.influences if not each.constant.startswith("against")} == {"young"}
    assert {each.constant for each in drop.influences} >= {"young", "density", "loss", "against.young"}
    assert drop.by_constants == pytest.approx(math.hypot(*(each.change for each in drop.influences)), rel=1e-9)
    assert all(abs(a.change) >= abs(b.change) for a, b in zip(drop.influences, drop.influences[1:]))


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
    assert told["influences"][1][1][0]["constant"] == "loss" and "<table" in grains._repr_html_()
