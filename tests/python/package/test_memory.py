"""What would take more than 2 GB is refused before anything is allocated."""

import resource

import numpy as np
import pytest

import stoss
from stoss import quasistatic

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
        monkeypatch.setattr(stoss._arguments, "LARGEST", 0.9 * size)
        with pytest.raises(stoss.InvalidInput, match="GB, allowed"):
            call()
        monkeypatch.setattr(stoss._arguments, "LARGEST", 6.0 * size)
        call()
