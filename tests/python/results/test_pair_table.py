"""stoss.pair_table: ε of two bodies against the speed and the ratio of their radii."""

import pickle

import matplotlib.pyplot as plt
import numpy as np
import pytest

import stoss


@pytest.fixture(scope="module")
def disks():
    return stoss.pair_table(poisson=0.33, speed=(0.02, 0.2), ratio=(1, 2), error=5e-3)


def test_values_are_those_of_restitution(disks):
    assert disks.greatest_error <= 5e-3 and disks.alike
    for v, r in ((0.03, 1.3), (0.15, 1.9), (0.1, 1.0)):
        direct = stoss.restitution(stoss.Disk(poisson=0.33), against=stoss.Disk(poisson=0.33, radius=r), speed=v)
        assert abs(disks(v, r) - direct.restitution) < disks.error(v, r) + direct.restitution_error


def test_arrays_broadcast_and_inverses_are_the_same(disks):
    speed, ratio = np.array([[0.03], [-0.1]]), np.array([1.0, 1.5, 1.9])
    values = disks(speed, ratio)
    assert values.shape == (2, 3) == disks.error(speed, ratio).shape
    np.testing.assert_allclose(disks(speed, 1 / ratio), values, rtol=1e-13)
    assert isinstance(disks(0.1, 1.5), float) and disks(0.1, 1.5) == values[1, 1]


def test_a_table_can_be_pickled(disks):
    again = pickle.loads(pickle.dumps(disks))
    assert again(0.05, 1.2) == disks(0.05, 1.2) and repr(again) == repr(disks)
    assert repr(disks).startswith("PairTable(Disk(poisson=0.33), speed=0.02 to 0.2 c, ratio=1 to 2: ")
    with pytest.raises(ValueError):
        disks.restitution[0] = 1.0


def test_two_materials_in_si():
    steel = stoss.Sphere(radius=5e-3, material=stoss.materials["structural steel"], loss_time=0)
    glass = stoss.Sphere(radius=5e-3, material=stoss.materials["glass"], loss_time=0)
    table = stoss.pair_table(steel, against=glass, speed=(10, 100), ratio=(0.9, 1.1), error=1e-2, beyond="clamp")
    assert not table.alike and "m/s" in repr(table)
    direct = stoss.restitution(steel, against=glass, speed=40.0)
    assert abs(table(40.0, 1.0) - direct.restitution) < table.error(40.0, 1.0) + direct.restitution_error
    assert table(0.0, 1.0) == table(1.0, 1.0) == table(10.0, 1.0) and table.error(0.0, 1.0) == np.inf
    with pytest.raises(stoss.InvalidInput, match="speed: got nan"):
        table(np.nan, 1.0)
    assert table.error(200.0, 1.0) == np.inf and table(200.0, 1.0) == pytest.approx(table(100.0, 1.0), abs=1e-9)


def test_the_picture_has_a_curve_for_each_ratio(disks):
    axes = disks.plot()
    assert len(axes.lines) == 5 and "v / c" in axes.get_xlabel()
    plt.close(axes.figure)


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"ratio": 2.0}, "ratio"),
        ({"ratio": (2, 1)}, "ratio"),
        ({"ratio": (1, np.nan)}, "ratio"),
        ({"speed": (0.1,)}, "speed"),
        ({"speed": (0.2, 0.1)}, "speed"),
        ({"error": 0.0}, "error"),
        ({"beyond": "law"}, "beyond"),
        ({"against": stoss.HalfPlane()}, "against"),
        ({"against": stoss.Disk(poisson=0.3, rigid=True)}, "against"),
        ({"against": stoss.Disk(poisson=0.3, loss_time=0.1)}, "loss_time"),
        ({"threads": -1}, "threads"),
    ],
)
def test_what_makes_no_table_is_refused(changed, said):
    with pytest.raises(stoss.InvalidInput, match=said):
        stoss.pair_table(**({"poisson": 0.33, "speed": (0.1, 0.2), "ratio": (1, 2)} | changed))


def test_values_beyond_the_range_are_refused(disks):
    for speed, ratio in ((0.3, 1.0), (0.1, 2.5), (0.1, 0.4), (0.0, 1.0), (0.1, -1.0), (np.nan, 1.0)):
        with pytest.raises(stoss.InvalidInput):
            disks(speed, ratio)
