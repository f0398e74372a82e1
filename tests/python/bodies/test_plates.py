"""Plates, strips and their layers: what they are made of, documents, sweeps."""

import json

import pytest
import stoss
from stoss.bodies._encounter import encounter
from stoss.bodies._solid import describe
from stoss.sweeps._specification import make

BALL, IN_SI = stoss.Sphere(poisson=0.3), stoss.Sphere(radius=5e-3, material=stoss.materials["structural steel"])
GLASS, PVB = stoss.materials["glass"], stoss.materials["PVB"]
PANE, FILM = stoss.Layer(thickness=4e-3, material=GLASS), stoss.Layer(thickness=0.8e-3, material=PVB)
LAMINATED = stoss.Plate(layers=[PANE, FILM, PANE], loss_time=0)
COATED = stoss.Plate(layers=[stoss.Layer(thickness=0.1, young=4), stoss.Layer(poisson=0.2)])
PLATES = {
    "of one layer": stoss.Plate(thickness=2, young=0.5), "lossy": stoss.Plate(thickness=2, loss_time=0.1),
    "of a material": stoss.Plate(thickness=0.01, material=GLASS), "coated": COATED, "laminated": LAMINATED,
    "strip": stoss.Strip(thickness=0.5, density=2),
    "strip in SI": stoss.Strip(thickness=0.01, material=GLASS, plane="strain"),
}  # fmt: skip


@pytest.mark.parametrize("plate", PLATES.values(), ids=list(PLATES))
def test_descriptions_make_them_again(plate):
    assert make("against", json.loads(json.dumps(describe(plate)))) == plate


def test_one_layer_is_a_plate_of_it():
    assert stoss.Plate(layers=[stoss.Layer(thickness=2, young=3)]) == stoss.Plate(thickness=2, young=3)
    assert stoss.Plate(layers=(PANE,)) == stoss.Plate(thickness=4e-3, material=GLASS)
    assert COATED != stoss.Plate(thickness=0.1, young=4) and COATED != LAMINATED


def test_the_numbers_are_those_of_the_first_layer():
    assert (LAMINATED.thickness, LAMINATED.poisson, LAMINATED.young, LAMINATED.material) == (4e-3, 0.22, 7e10, GLASS)
    assert (LAMINATED.loss_time, len(LAMINATED.layers)) == (0.0, 3) and LAMINATED.layers[1] == FILM
    assert stoss.Plate(layers=[PANE, PANE]).quality == GLASS.quality
    assert COATED.poisson is None and COATED.layers[1].thickness is None


def test_layers_have_the_losses_of_their_materials():
    relaxing = stoss.Material(young=1e9, poisson=0.4, density=1000, relaxation=[(0.5, 1e-5)])
    plate = stoss.Plate(layers=[PANE, stoss.Layer(thickness=1e-3, material=relaxing), PANE])
    assert (plate.loss_time, plate.quality, plate.relaxation) == (None, None, None)
    assert repr(plate).endswith("])") and make("against", json.loads(json.dumps(describe(plate)))) == plate
    assert set(document_of(IN_SI, plate)) == {"kind", "layers"}
    hits = [stoss.impact(IN_SI, against=each, speed=0.1, cutoff=4)
            for each in (plate, stoss.Plate(layers=plate.layers, relaxation=[(0.5, 1e-5)]), LAMINATED)]
    assert hits[1].dissipated > 2 * hits[0].dissipated > 0.001 and hits[2].dissipated < hits[0].dissipated


def document_of(body, against):
    return json.loads(encounter(body, against._beside(body)).to_json())["against"]


def test_documents_are_those_of_the_core():
    assert document_of(BALL, stoss.Plate(thickness=2)) == {
        "kind": "plate", "thickness": 2.0, "poisson": 0.3, "young": 1.0, "density": 1.0, "loss_time": 0.0,
        "quality": 0.0,
    }  # fmt: skip
    one = {"thickness": 0.1, "poisson": 0.3, "young": 4.0, "density": 1.0}
    block = {"poisson": 0.2, "young": 1.0, "density": 1.0}
    assert document_of(BALL, COATED) == {"kind": "plate", "layers": [one, block], "loss_time": 0.0}
    layers = document_of(IN_SI, LAMINATED)["layers"]
    assert [each["thickness"] for each in layers] == [4e-3, 0.8e-3, 4e-3]
    assert [each["material"]["poisson"] for each in layers] == [0.22, PVB.poisson, 0.22]


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
