"""Layers of a plate that lose energy in different ways."""

import pytest

BALL = "restitution --material 'bearing steel' --loss-time 0 --radius 5e-3 --speed 0.3"
PANE, FILM = "thickness=4e-3,material=glass", "thickness=8e-4,material=PVB"


def of(stoss, plate):
    return {name: float(stoss.data(f"{BALL} --against {plate}")[0][name]) for name in ("restitution", "dissipated")}


@pytest.mark.numbers
def test_a_laminate_has_the_losses_of_its_materials(stoss):
    own = of(stoss, f"plate,{PANE}/{FILM}/{PANE}")
    elastic = of(stoss, f"plate,loss_time=0,{PANE}/{FILM}/{PANE}")
    glass = of(stoss, f"plate,quality=1000,{PANE}/{FILM}/{PANE}")
    assert 0.0 == elastic["dissipated"] < glass["dissipated"] < 0.5 * own["dissipated"] < 0.05
    # Without loss PVB has E(0). What moves the ball is its modulus at about 10 kHz, 5.7e8 Pa.
    soft = of(stoss, f"plate,loss_time=0,{PANE}/thickness=8e-4,young=5.7e8,poisson=0.45,density=1070/{PANE}")
    assert own["restitution"] == pytest.approx(soft["restitution"], abs=0.01)
    assert elastic["restitution"] > soft["restitution"] + 0.03


@pytest.mark.numbers
def test_a_lossy_layer_on_top_takes_more_than_one_below(stoss):
    above, below = of(stoss, f"plate,{FILM}/{PANE}"), of(stoss, f"plate,{PANE}/{FILM}")
    assert above["dissipated"] > 5.0 * below["dissipated"] > 0.0


def test_a_loss_of_one_layer_alone_comes_with_its_material(stoss):
    refused = stoss.run(f"{BALL} --against plate,{PANE}/{FILM},loss_time=1e-6")
    said = "stoss: error: against: got 'loss_time', allowed thickness, poisson, young, density, material, c_p, c_s with plate\n"
    assert (refused.returncode, refused.stderr) == (3, said)
