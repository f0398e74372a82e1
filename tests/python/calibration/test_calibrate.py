"""Constants from measurements: those that made the data come back, and what data cannot tell is said."""

import dataclasses
import json

import numpy as np
import pytest
import stoss

GLASS = stoss.Material(young=7e10, poisson=0.22, density=2500, quality=60)
BALL = stoss.Sphere(radius=0.008, material=GLASS)
VISCOUS = stoss.Sphere(radius=0.008, material=stoss.Material(young=7e10, poisson=0.22, density=2500, loss_time=4e-8))
BLOCK = stoss.HalfSpace(material=stoss.Material(young=6e10, poisson=0.25, density=2700))
SPEEDS = np.array([0.3, 0.6, 1.2, 2.4])


def made_by(body, against=None, speeds=SPEEDS, noise=1e-3, random=None):
    """Data that stoss made itself: ε and contact times, with noise."""
    found = stoss.restitution(body, against=against, speed=speeds, tolerance=1e-4)
    columns = {
        "speed": speeds,
        "restitution": found.restitution,
        "restitution_uncertainty": np.full(speeds.size, noise),
    }
    columns |= {"contact_time": found.contact_time_si, "contact_time_uncertainty": noise * found.contact_time_si}
    if random is not None:
        for name in ("restitution", "contact_time"):
            columns[name] = columns[name] + columns[name + "_uncertainty"] * random.standard_normal(speeds.size)
    return columns


@pytest.mark.long
def test_constants_come_back_within_their_uncertainty():
    """Twelve sets of two constants each: 95 % within two standard uncertainties."""
    random = np.random.default_rng(7)
    exact = made_by(BALL, speeds=SPEEDS[1:], noise=2e-3)
    pulls = []
    for _ in range(12):
        noisy = {name: value + 2e-3 * (value if name == "contact_time" else 1.0) * random.standard_normal(value.size)
                 if name in ("restitution", "contact_time") else value for name, value in exact.items()}  # fmt: skip
        found = stoss.calibrate(noisy, BALL, unknown={"quality": 30.0, "young": 5e10})
        pulls += [(each.value - true) / each.uncertainty for each, true in zip(found.constants, (60.0, 7e10))]
    pulls = np.array(pulls)
    assert np.count_nonzero(np.abs(pulls) < 2.0) >= 21
    assert 0.6 < pulls.std() < 1.4


@pytest.mark.parametrize(("unknown", "true", "body", "against"), [
    ("quality", 60.0, BALL, BLOCK),
    ("against.young", 6e10, BALL, BLOCK),
    ("radius", 0.008, BALL, None),
    pytest.param("quality", 60.0, BALL, "same", marks=pytest.mark.long),
    pytest.param("loss_time", 4e-8, VISCOUS, None, marks=pytest.mark.long),
])  # fmt: skip
def test_each_constant_comes_back(unknown, true, body, against):
    data = made_by(body, against)
    found = stoss.calibrate(data, body, against=against, unknown={unknown: 0.7 * true})
    (its,) = found.constants
    assert its.value == pytest.approx(true, abs=0.1 * its.uncertainty + 2.0 * its.numerical)
    assert its.uncertainty < 0.2 * true
    assert found.fitted == pytest.approx(found.measured, rel=2e-3)
    assert found.degrees_of_freedom == 7 and found.chi_squared < 4.0


@pytest.mark.long
def test_a_yield_strength_comes_back():
    soft = stoss.Material(young=7e10, poisson=0.33, density=2700, yield_strength=2e8)
    block = stoss.HalfSpace(material=soft)
    speeds = np.array([0.5, 2.0])
    known = stoss.restitution(BALL, against=dataclasses.replace(block, yield_strength=2e8), speed=speeds)
    data = {"speed": speeds, "restitution": known.restitution, "restitution_uncertainty": [0.005, 0.005]}
    found = stoss.calibrate(data, BALL, against=block, unknown={"against.yield_strength": 3e8})
    assert found.constants[0].value == pytest.approx(2e8, rel=2e-3)
    assert found.against.material.yield_strength == found.constants[0].value


@pytest.mark.long
def test_a_roughness_comes_back():
    rough = stoss.Sphere(radius=0.008, material=GLASS, roughness=2e-7)
    speeds = np.array([0.02, 0.2])
    known = stoss.restitution(rough, against=BLOCK, speed=speeds, tolerance=1e-4)
    data = {
        "speed": speeds,
        "contact_time": known.contact_time_si,
        "contact_time_uncertainty": 0.002 * known.contact_time_si,
    }
    (its,) = stoss.calibrate(data, BALL, against=BLOCK, unknown={"roughness": 1e-7}).constants
    assert its.value == pytest.approx(2e-7, abs=0.1 * its.uncertainty + its.numerical)


@pytest.mark.long
def test_friction_comes_back():
    speed, angle = np.full(4, 1.0), np.array([10.0, 30.0, 50.0, 65.0])
    known = stoss.oblique(BALL, speed=speed, angle=angle, friction=0.25, tolerance=1e-3)
    data = {
        "speed": speed,
        "angle": angle,
        "tangential_restitution": known.tangential_restitution,
        "tangential_restitution_uncertainty": [0.02] * 4,
    }
    found = stoss.calibrate(data, BALL, unknown="friction")
    assert found.constants[0].value == pytest.approx(0.25, abs=0.1 * found.constants[0].uncertainty)
    assert found.friction == found.constants[0].value


def test_a_factor_on_relaxation_comes_back():
    rubber = stoss.Material(young=5e6, poisson=0.48, density=1100, relaxation=[(0.2, 1e-4), (0.2, 1e-3)])
    ball = stoss.Sphere(radius=0.02, material=rubber)
    speeds = np.array([0.3, 1.0])
    known = stoss.restitution(ball, speed=speeds)
    data = {"speed": speeds, "restitution": known.restitution, "restitution_uncertainty": [0.005, 0.005]}
    found = stoss.calibrate(data, ball, unknown={"relaxation": 1.3})
    assert found.constants[0].value == pytest.approx(1.0, abs=0.02)


def test_what_is_found_is_ready_for_other_calls():
    found = stoss.calibrate(made_by(BALL, BLOCK), BALL, against=BLOCK, unknown="quality")
    assert found.body.material == found.material and found.material.quality == found.constants[0].value
    told = stoss.predict(found.body, against=found.against, speed=1.0, uncertainties=found.uncertainties)
    assert told.by_constants > 0.0
    text = json.dumps(found.to_dict())
    assert json.loads(text)["encounter"]["first"]["material"]["quality"] == found.material.quality
    assert "quality" in repr(found) and "degrees of freedom" in str(found)


@pytest.mark.long
def test_held_constants_are_a_third_uncertainty():
    data = {
        "speed": SPEEDS,
        "restitution": made_by(BALL, BLOCK)["restitution"],
        "restitution_uncertainty": np.full(4, 1e-3),
    }
    found = stoss.calibrate(data, BALL, against=BLOCK, unknown="quality", uncertainties={"against.density": 0.2})
    (its,) = found.constants
    other = dataclasses.replace(BLOCK.material, density=2700 * 1.2)
    moved = stoss.calibrate(data, BALL, against=stoss.HalfSpace(material=other), unknown="quality").constants[0]
    assert its.by_constants == pytest.approx(abs(moved.value - its.value), rel=0.25)
    assert stoss.calibrate(data, BALL, against=BLOCK, unknown="quality").constants[0].by_constants == 0.0


@pytest.mark.long
def test_without_uncertainties_the_scatter_tells():
    data = made_by(BALL, random=np.random.default_rng(3))
    given = stoss.calibrate(data, BALL, unknown="quality").constants[0]
    data = {name: value for name, value in data.items() if "uncertainty" not in name and "time" not in name}
    found = stoss.calibrate(data, BALL, unknown="quality")
    assert found.constants[0].value == pytest.approx(given.value, rel=0.05)
    assert found.chi_squared == pytest.approx(found.degrees_of_freedom)
    assert np.isnan(found.probability)


@pytest.mark.parametrize(("unknown", "data", "said"), [
    ("quality", {"speed": [1.0], "restitution": [1.2]}, "restitution"),
    (["quality", "young"], {"speed": [1.0], "restitution": [0.9], "restitution_uncertainty": [0.01]}, "1 values for 2"),
    ("quality", {"speed": [1.0], "restitution": [0.9]}, "more than 1, or their uncertainties"),
    ("young", {"speed": SPEEDS, "restitution": [0.96] * 4, "restitution_uncertainty": [0.01] * 4}, "young.*tell"),
    ("quality", {"speed": [1.0], "restitution": [0.99999], "restitution_uncertainty": [1e-6]}, "end of its range"),
    ("friction", {"speed": SPEEDS, "restitution": [0.96] * 4}, "needs angle"),
    ("quality", {"speed": [1.0, 2.0], "angle": [20.0, 20.0], "tangential_restitution": [0.2, 0.2]}, "friction"),
    ("hardness", {"speed": [1.0], "restitution": [0.9]}, "hardness"),
    ("against.young", {"speed": [1.0], "restitution": [0.9]}, "against.young"),
    ("relaxation", {"speed": [1.0], "restitution": [0.9]}, "series"),
    ([], {"speed": [1.0], "restitution": [0.9]}, "one to 3"),
    ({"quality": -3.0}, {"speed": [1.0], "restitution": [0.9]}, "begin"),
    ("quality", {"speed": [1.0, 2.0], "restitution": [0.9, 0.9], "restitution_uncertainty": [0.0, 0.1]}, "above 0"),
])  # fmt: skip
def test_what_data_cannot_tell_is_refused(unknown, data, said):
    with pytest.raises(stoss.InvalidInput, match=said):
        stoss.calibrate(data, BALL, unknown=unknown)


def test_what_cannot_be_told_apart_is_said():
    data = {
        "speed": SPEEDS[1:3],
        "restitution": made_by(BALL, BLOCK)["restitution"][1:3],
        "restitution_uncertainty": [1e-3] * 2,
    }
    lossy = stoss.HalfSpace(material=dataclasses.replace(BLOCK.material, quality=100))
    found = stoss.calibrate(data, BALL, against=lossy, unknown="quality")
    assert any("quality cannot be told from against.quality" in each for each in found.not_told_apart)
    at_wall = stoss.calibrate(data, BALL, unknown="quality")
    assert any("rigid wall" in each for each in at_wall.not_told_apart)


@pytest.mark.long
def test_what_a_body_has_of_its_own_stays_its_own():
    """A body that loses nothing, of a material that does, and one whose strength is not that of its material."""
    lossless = stoss.Sphere(radius=0.008, material=GLASS, loss_time=0)
    data = {"speed": [1.0], "contact_time": [5e-5], "contact_time_uncertainty": [1e-6]}
    found = stoss.calibrate(data, lossless, unknown="young")
    assert found.body.loss_time == found.body.quality == 0.0 and not any(
        "quality" in each for each in found.not_told_apart
    )
    soft = stoss.HalfSpace(material=BLOCK.material, yield_strength=3e8)
    known = stoss.restitution(BALL, against=soft, speed=[0.5, 2.0]).restitution
    data = {"speed": [0.5, 2.0], "restitution": known, "restitution_uncertainty": [0.01, 0.01]}
    (its,) = stoss.calibrate(data, BALL, against=soft, unknown={"against.yield_strength": 4e8}).constants
    assert its.value == pytest.approx(3e8, rel=5e-3)


def test_a_wall_has_no_constants():
    with pytest.raises(stoss.InvalidInput, match="against.roughness"):
        stoss.calibrate(made_by(BALL, speeds=SPEEDS[:2]), BALL, unknown="against.roughness")


def test_bodies_without_a_material_are_refused():
    data = {"speed": [1.0], "restitution": [0.9], "restitution_uncertainty": [0.01]}
    for body in (stoss.Sphere(poisson=0.3), "ball", None):
        with pytest.raises(stoss.InvalidInput, match="body"):
            stoss.calibrate(data, body, unknown="quality")


def test_report_and_picture(tmp_path):
    found = stoss.calibrate(made_by(BALL), BALL, unknown="quality")
    found.report(tmp_path / "report.html")
    page = (tmp_path / "report.html").read_text()
    assert "data:image/png;base64," in page and "quality" in page and "degrees of freedom" in page
    found.to_csv(tmp_path / "values.csv")
    assert "measured" in (tmp_path / "values.csv").read_text()
    assert len(found.plot().child_axes) == 2
