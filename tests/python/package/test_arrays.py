"""Numbers and arrays of any shape and layout give the same; what would take more than 2 GB is refused at once."""

import dataclasses
import resource
import warnings

import numpy as np
import pytest
import stoss
from stoss import quasistatic


def test_shapes_broadcast():
    one = stoss.restitution(poisson=0.3, speed=0.1, tolerance=1e-2)
    inputs = ("body", "bodies", "against", "tolerance", "absolute", "state")
    fields = [field.name for field in dataclasses.fields(one) if field.name not in inputs]
    assert all(type(getattr(one, name)) in (float, int, bool, str) for name in fields)
    for speed in (np.array(0.1), np.float32(0.125), 1, np.int8(1)):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", stoss.StossWarning)
            assert type(stoss.restitution(poisson=0.3, speed=speed, tolerance=0.1).restitution) is float
    for poisson, speed, shape in (
        (0.3, [0.1], (1,)), ([0.3], 0.1, (1,)), (0.3, [[0.1, 0.2], [0.2, 0.1]], (2, 2)), ([], [], (0,)),
        ([[0.3], [0.5]], (0.1, 0.2, 0.1), (2, 3)), ([0.3, 0.5, 0.3], 0.1, (3,)), (np.empty((0, 3)), 0.1, (0, 3)),
    ):  # fmt: skip
        many = stoss.restitution(poisson=poisson, speed=speed, tolerance=1e-2)
        assert all(np.shape(getattr(many, name)) == shape for name in fields)
        nus, speeds = np.broadcast_arrays(poisson, speed)
        for at in np.ndindex(shape):
            alone = stoss.restitution(poisson=nus[at], speed=speeds[at], tolerance=1e-2)
            assert all(getattr(many, name)[at] == getattr(alone, name) for name in fields)


def test_any_layout_and_any_threads_give_the_same_bits():
    speeds = np.geomspace(0.01, 0.3, 12).reshape(3, 4)
    plain = stoss.restitution(poisson=0.4, speed=speeds, tolerance=1e-2).restitution
    padded = np.repeat(speeds, 2, axis=1)[:, ::2]
    frozen = speeds.copy()
    frozen.flags.writeable = False
    swapped = speeds.astype(speeds.dtype.newbyteorder())
    for same_speeds in (padded, np.asfortranarray(speeds), frozen, swapped, speeds.tolist()):
        assert np.array_equal(stoss.restitution(poisson=0.4, speed=same_speeds, tolerance=1e-2).restitution, plain)
    for threads in (0, 1, 2, 7):
        again = stoss.restitution(poisson=0.4, speed=speeds, tolerance=1e-2, threads=threads)
        assert np.array_equal(again.restitution, plain)


MANY, THOUSAND = np.linspace(0.0, 6.0, 10**5), np.linspace(0.0, 1.0, 1000)
PAIRS = {"poisson": np.linspace(0.0, 0.5, 10**5)[:, None], "speed": np.geomspace(1e-9, 0.1, 10**5)}
TOO_MUCH = {
    "times x radii": lambda hit: hit.field(time=MANY, radius=THOUSAND),
    "times": lambda hit: hit.field(time=np.linspace(0.0, 6.0, 10**7), radius=1.0, angle=0.0),
    "radii x angles": lambda hit: hit.field(time=1.0, radius=np.linspace(0, 1, 10**5), angle=np.linspace(-3, 3, 1000)),
    "radii x modes": lambda hit: hit.field(time=1.0, radius=np.linspace(0.0, 1.0, 10**7), angle=0.0),
    "energies": lambda hit: hit.energies_at(time=np.linspace(0.0, 6.0, 10**7)),
    "slow impacts": lambda hit: quasistatic.slow_impact(**PAIRS),
    "restitution": lambda hit: stoss.restitution(**PAIRS),
    "compression": lambda hit: quasistatic.compression(poisson=PAIRS["poisson"], force=PAIRS["speed"]),
    "stress": lambda hit: quasistatic.hertz_stress(force=0.1, depth=PAIRS["poisson"], y=PAIRS["speed"]),
}


def megabytes():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1000


@pytest.mark.parametrize("what", TOO_MUCH)
def test_too_much_is_refused(hit, what):
    before = megabytes()
    with pytest.raises(stoss.InvalidInput) as caught:
        TOO_MUCH[what](hit)
    text = str(caught.value)
    assert " GB, allowed 2 GB (" in text and text.endswith(")")
    assert "\n" not in text and len(text) < 160
    assert megabytes() - before < 500


def test_a_film_is_refused(hit, tmp_path):
    pytest.importorskip("matplotlib")
    with pytest.raises(stoss.InvalidInput, match="frames: got 2000 of 4000 x 4000 pixels, 32 GB, allowed 2 GB"):
        stoss.animate(hit, tmp_path / "much.gif", frames=2000, size=(4000, 4000))
    assert not list(tmp_path.iterdir())


def test_the_size_is_that_of_the_arrays(hit, monkeypatch):
    path, field = hit.trajectory(), hit.field(time=[1.0, 2.0], radius=THOUSAND)
    rows = sum(getattr(path, name).nbytes for name in path._table())
    points = sum(column.nbytes for name, column in field._table().items() if name in ("x", "y", "von_mises"))
    for call, size in ((hit.trajectory, rows), (lambda: hit.field(time=[1.0, 2.0], radius=THOUSAND), points)):
        monkeypatch.setattr("stoss._arguments.LARGEST", 0.9 * size)
        with pytest.raises(stoss.InvalidInput, match="GB, allowed"):
            call()
        monkeypatch.setattr("stoss._arguments.LARGEST", 6.0 * size)
        call()
