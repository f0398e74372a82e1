"""Plates, strips and their layers: values, equality, documents, SI and ratios, sweeps, what they refuse."""

import copy
import dataclasses
import json
import math
import pickle

import pytest
import stoss
from stoss.bodies._encounter import encounter
from stoss.bodies._solid import describe
from stoss.sweeps._specification import make

BALL = stoss.Sphere(poisson=0.3)
STEEL, GLASS, PVB = (stoss.materials[name] for name in ("structural steel", "glass", "PVB"))
IN_SI = stoss.Sphere(radius=5e-3, material=STEEL)
PANE, FILM = stoss.Layer(thickness=4e-3, material=GLASS), stoss.Layer(thickness=0.8e-3, material=PVB)
LAMINATED = stoss.Plate(layers=[PANE, FILM, PANE], loss_time=0)
COATED = stoss.Plate(layers=[stoss.Layer(thickness=0.1, young=4), stoss.Layer(poisson=0.2)])
PLATES = {
    "of one layer": stoss.Plate(thickness=2, young=0.5), "lossy": stoss.Plate(thickness=2, loss_time=0.1),
    "of a material": stoss.Plate(thickness=0.01, material=GLASS), "coated": COATED, "laminated": LAMINATED,
    "strip": stoss.Strip(thickness=0.5, density=2),
    "strip in SI": stoss.Strip(thickness=0.01, material=GLASS, plane="strain"),
}  # fmt: skip
EACH = pytest.mark.parametrize("plate", PLATES.values(), ids=list(PLATES))


@EACH
def test_plates_are_values(plate):
    for other in (copy.deepcopy(plate), pickle.loads(pickle.dumps(plate)), dataclasses.replace(plate)):
        assert other == plate and hash(other) == hash(plate) and repr(other) == repr(plate)
    assert make("against", json.loads(json.dumps(describe(plate)))) == plate
    names = vars(stoss) | {"Material": stoss.Material}
    assert eval(repr(plate), names) == plate


def test_one_layer_is_a_plate_of_it():
    assert stoss.Plate(layers=[stoss.Layer(thickness=2, young=3)]) == stoss.Plate(thickness=2, young=3)
    assert stoss.Plate(layers=(PANE,)) == stoss.Plate(thickness=4e-3, material=GLASS)
    assert COATED != stoss.Plate(thickness=0.1, young=4) and COATED != LAMINATED


def test_the_numbers_are_those_of_the_first_layer():
    assert (LAMINATED.thickness, LAMINATED.poisson, LAMINATED.young, LAMINATED.material) == (4e-3, 0.22, 7e10, GLASS)
    assert (LAMINATED.loss_time, len(LAMINATED.layers)) == (0.0, 3) and LAMINATED.layers[1] == FILM
    assert stoss.Plate(layers=[PANE, PANE]).loss_time == GLASS.loss_time
    assert COATED.poisson is None and COATED.layers[1].thickness is None


def document_of(body, against):
    return json.loads(encounter(body, against._beside(body)).to_json())["against"]


def test_documents_are_those_of_the_core():
    assert document_of(BALL, stoss.Plate(thickness=2)) == {
        "kind": "plate", "thickness": 2.0, "poisson": 0.3, "young": 1.0, "density": 1.0, "loss_time": 0.0,
    }  # fmt: skip
    one = {"thickness": 0.1, "poisson": 0.3, "young": 4.0, "density": 1.0}
    block = {"poisson": 0.2, "young": 1.0, "density": 1.0}
    assert document_of(BALL, COATED) == {"kind": "plate", "layers": [one, block], "loss_time": 0.0}
    layers = document_of(IN_SI, LAMINATED)["layers"]
    assert [each["thickness"] for each in layers] == [4e-3, 0.8e-3, 4e-3]
    assert [each["poisson"] for each in layers] == [0.22, PVB.poisson, 0.22]


def loss(*bodies, speed=0.1):
    return stoss.restitution(bodies[0], against=bodies[1], speed=speed, tolerance=0.02).lost_fraction


def test_si_is_a_matter_of_units():
    c = IN_SI.scales.speed

    def layer(of, thickness):
        return stoss.Layer(
            thickness=thickness / IN_SI.radius, poisson=of.poisson, young=of.young / STEEL.young,
            density=of.density / STEEL.density,
        )  # fmt: skip

    layers = [layer(GLASS, 4e-3), layer(PVB, 0.8e-3), layer(GLASS, 4e-3)]
    plain = stoss.Sphere(poisson=0.3, loss_time=STEEL.loss_time / IN_SI.scales.time)
    assert loss(IN_SI, LAMINATED, speed=1e-2 * c) == pytest.approx(
        loss(plain, stoss.Plate(layers=layers), speed=1e-2), rel=1e-9
    )


def test_against_plates_as_against_all_else(command):
    plate = stoss.Plate(thickness=2, young=0.5)
    (row,) = command("restitution --body sphere --poisson 0.3 --speed 0.1 --against plate,thickness=2,young=0.5")["records"]
    found = stoss.restitution(BALL, against=plate, speed=0.1)
    assert (found.restitution, found.lost_to_second) == (row["restitution"], row["lost_to_second"])
    assert "Plate(thickness=2, poisson=0.3, young=0.5)" in repr(found)
    assert "Plate(3 layers)" in repr(stoss.restitution(IN_SI, against=LAMINATED, speed=1.0, tolerance=0.05))
    disk, strip = stoss.Disk(poisson=0.3), stoss.Strip(thickness=3)
    assert 0 < loss(disk, strip) < 1


def test_impacts_and_their_pictures(closed):
    hit = stoss.impact(BALL, against=stoss.Plate(thickness=2), speed=0.1, cutoff=6)
    with pytest.raises(stoss.InvalidInput, match="a plate has no field"):
        hit.field(time=0, of=1)
    assert hit.wave(time=[0.0, hit.contact_time]).depth[[0, -1]] == pytest.approx([0.0, 2.0])
    assert stoss.plot.ledger(hit).get_legend().get_texts()[-1].get_text() == "plate"


def test_functions_have_no_law_of_slow_impacts():
    plate = stoss.Plate(thickness=2)
    with pytest.raises(stoss.InvalidInput, match="there is no law of slow impacts of these bodies"):
        stoss.restitution_function(BALL, against=plate, speed=(0.05, 0.1), error=0.01, beyond="law")
    function = stoss.restitution_function(BALL, against=plate, speed=(0.05, 0.1), error=0.01)
    assert function(0.07) == pytest.approx(stoss.restitution(BALL, against=plate, speed=0.07).restitution, abs=0.01)


def test_a_sweep_of_thicknesses(tmp_path):
    grid = stoss.Grid(
        bodies=BALL,
        against=[{"kind": "plate", "thickness": "lin:1:3:3"}, {"kind": "plate", "layers": [{"thickness": 1}, {}]}, COATED],
        speed=0.1, tolerance=0.05,
    )  # fmt: skip
    assert grid.shape == (1, 5, 1) and stoss.Grid.from_dict(json.loads(json.dumps(grid.to_dict()))) == grid
    thicknesses = [case.against.thickness for case in grid.cases()]
    assert thicknesses == [1, 2, 3, 1, 0.1] and grid.cases()[4].against == COATED._beside(BALL)
    values = stoss.sweep(grid, store=tmp_path).to_xarray()
    labels = ["plate,thickness=1", "plate,thickness=2", "plate,thickness=3", "plate,thickness=1,young=1,density=1/"]
    assert values["against"].values.tolist()[:3] == labels[:3]
    assert str(values["against"].values[3]).startswith("plate,thickness=1")


def test_a_sweep_in_si():
    layers = [{"thickness": 4e-3, "material": "glass"}, {"material": "PVB"}]
    grid = stoss.Grid(
        bodies=IN_SI, against=[{"kind": "plate", "loss_time": 0, "layers": layers}, LAMINATED], speed=1.0
    )  # fmt: skip
    assert stoss.Grid.from_dict(json.loads(json.dumps(grid.to_dict()))) == grid
    first, second = grid.cases()
    assert first.against.layers[1] == stoss.Layer(material=PVB) and second.against == LAMINATED


def test_a_plate_yields_as_a_block():
    ball = stoss.Sphere(radius=5e-3, material=stoss.materials["bearing steel"])
    speeds = [
        stoss.quasistatic.yield_speed(ball, against=met)
        for met in (stoss.Plate(thickness=0.01, material=GLASS), stoss.HalfSpace(material=GLASS))
    ]
    assert speeds[0] == speeds[1]


@pytest.mark.parametrize(
    "call, said",
    [
        (lambda: stoss.Plate(), "thickness: missing"),
        (lambda: stoss.Plate(material=GLASS), "thickness: missing"),
        (lambda: stoss.Plate(thickness=0), "thickness: got 0"),
        (lambda: stoss.Plate(thickness=-1), "thickness: got -1"),
        (lambda: stoss.Plate(thickness=math.nan), "thickness: got nan"),
        (lambda: stoss.Plate(thickness=math.inf), "thickness: got inf"),
        (lambda: stoss.Strip(thickness="x"), "thickness: got 'x'"),
        (lambda: stoss.Layer(thickness=0), "thickness: got 0"),
        (lambda: stoss.Layer(poisson=0.6), "poisson: got 0.6"),
        (lambda: stoss.Plate(layers=[]), "layers: got []"),
        (lambda: stoss.Plate(layers=PANE), "layers: got Layer("),
        (lambda: stoss.Plate(layers=[1]), "layers: got 1"),
        (lambda: stoss.Plate(layers=[PANE, 1]), "layers: got 1"),
        (lambda: stoss.Plate(thickness=2, layers=[stoss.Layer(thickness=1)]), "thickness: got 2"),
        (lambda: stoss.Plate(layers=[stoss.Layer()]), "thickness: missing"),
        (lambda: stoss.Plate(layers=[PANE, stoss.Layer(material=GLASS), PANE]), "layer 2 thickness: missing"),
        (lambda: stoss.Plate(layers=[PANE] * 21), "layers: got 21, allowed 1 to 20"),
        (lambda: stoss.Plate(layers=[PANE, FILM]), "loss_time: the layers' materials have "),
        (lambda: stoss.Plate(layers=[PANE, stoss.Layer(thickness=1)]), "layer 2 material: missing"),
        (lambda: loss(stoss.Disk(poisson=0.3), stoss.Plate(thickness=1)), "a stoss.HalfPlane or a stoss.Strip"),
        (lambda: loss(IN_SI, COATED), "two bodies with a material"),
        (lambda: stoss.atlas(BALL, against=stoss.Plate(thickness=2), speed=0.01), "in the atlas"),
        (lambda: stoss.Grid(bodies=BALL, against={"kind": "plate", "layers": [{"radius": 1}]}, speed=1), "layers: got"),
        (lambda: stoss.Grid(bodies=BALL, against={"kind": "plate", "layers": 3}, speed=1), "layers: got 3"),
    ],
)
def test_refusals(call, said):
    with pytest.raises(stoss.InvalidInput) as caught:
        call()
    assert said in str(caught.value) and "\n" not in str(caught.value)
