"""Modes, one impact in time, and its ledger: what is drawn is what the results hold."""

import builtins
import sys

import numpy as np
import pytest
import stoss
from matplotlib.collections import LineCollection


pytestmark = pytest.mark.usefixtures("closed")


@pytest.fixture(scope="module")
def modes():
    return stoss.modes(poisson=0.33, cutoff=10)


@pytest.fixture(scope="module")
def hit():
    return stoss.impact(poisson=0.33, speed=0.2, cutoff=12.5)


@pytest.fixture(scope="module")
def path(hit):
    return hit.trajectory(every=4)


def test_spectrum(modes):
    ax = modes.plot()
    radial, tangential = ax.lines
    is_radial = modes.radial > abs(modes.tangential)
    for line, where in ((radial, is_radial), (tangential, ~is_radial)):
        assert np.array_equal(line.get_xdata(), modes.order[where])
        assert np.array_equal(line.get_ydata(), modes.omega[where])
    assert radial.get_marker() != tangential.get_marker()
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("angular order n", "frequency ω / (c/R)")
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["radial, C > |S|", "tangential, C ≤ |S|"]


@pytest.mark.parametrize("order, index, amplitude", [(0, 0, 0.15), (2, 0, 0.1), (3, 1, -0.2)])
def test_mode_shape(modes, order, index, amplitude):
    ax = stoss.plot.mode_shape(modes, order=order, index=index, amplitude=amplitude)
    (grid,) = [each for each in ax.collections if isinstance(each, LineCollection)]
    angle = np.linspace(-np.pi, np.pi, 193)
    radius = np.linspace(0.0, 1.0, 25)
    u_r, u_phi = modes.displacement(order=order, index=index, radius=radius)
    out, along = np.outer(u_r, np.cos(order * angle)), np.outer(u_phi, np.sin(order * angle))
    scale = amplitude / np.hypot(out, along).max()
    edge = np.exp(1j * angle) * (1.0 + scale * (out[-1] + 1j * along[-1]))
    (drawn,) = [line for line in grid.get_segments() if len(line) == 193 and np.isclose(line[0, 0], edge[0].real)]
    np.testing.assert_allclose(drawn, np.column_stack((edge.real, edge.imag)), atol=1e-12)
    outline = ax.lines[0].get_xydata()
    np.testing.assert_allclose(np.hypot(*outline.T), 1.0)
    assert ax.get_title().startswith(f"(n, l) = ({order}, {index}), ω = ")
    assert ax.get_aspect() == 1.0 and ax.get_xlabel() == "x / R"


@pytest.mark.parametrize(
    "function, name, label",
    [
        ("force", "force", "force F / (πRE)"),
        ("velocity", "velocity", "velocity towards the wall / c"),
        ("half_width", "contact_half_width", "contact half-width / R"),
    ],
)
def test_against_time(path, function, name, label):
    ax = getattr(stoss.plot, function)(path, label="one", color="black")
    line = ax.lines[-1]
    assert np.array_equal(line.get_xdata(), path.time)
    assert np.array_equal(line.get_ydata(), getattr(path, name))
    assert line.get_color() == "black"
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("time t / (R/c)", label)
    assert ax.get_legend().get_texts()[0].get_text() == "one"


def test_energies(path):
    ax = stoss.plot.energies(path)
    lines = {line.get_label(): line for line in ax.lines}
    for name in ("translation", "vibration", "stored", "unresolved"):
        assert np.array_equal(lines[name].get_ydata(), getattr(path, name))
    total = path.translation + path.vibration + path.stored + path.unresolved
    np.testing.assert_allclose(lines["sum"].get_ydata(), total, rtol=1e-15)
    assert len({(line.get_color(), line.get_linestyle()) for line in ax.lines}) == 5
    assert ax.get_ylabel() == "energy / initial energy"


@pytest.mark.parametrize("when", ["after", "average"])
def test_ledger(hit, when):
    ax = stoss.plot.ledger(hit, when=when, orders=5, indices=3)
    heights = {(round(bar.get_x() + bar.get_width() / 2 - (group_l - 1) * 0.28), group_l): bar.get_height()
               for group_l, group in enumerate(ax.containers) for bar in group}  # fmt: skip
    held = hit.mode_energies
    expected = {(row["order"], row["index"]): row[when] for row in held if row["order"] < 5 and row["index"] < 3}
    assert heights == expected
    assert ax.get_yscale() == "log" and ax.get_ylim()[0] <= min(heights.values())
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["l = 0", "l = 1", "l = 2"]
    assert len({group.patches[0].get_hatch() for group in ax.containers}) == 3


def test_ledger_of_a_rod():
    rod = stoss.impact(stoss.Rod(), speed=0.1, cutoff=100)
    bars = [bar for group in stoss.plot.ledger(rod).containers for bar in group]
    assert [bar.get_height() for bar in bars] == rod.mode_energies["after"][:4].tolist()


def test_without_matplotlib(monkeypatch):
    for name in [name for name in sys.modules if name.startswith(("stoss.plot", "matplotlib"))]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.delattr(stoss, "plot", raising=False)
    real = builtins.__import__

    def refuse(name, *arguments, **named):
        if name.split(".")[0] == "matplotlib":
            raise ModuleNotFoundError("No module named 'matplotlib'", name="matplotlib")
        return real(name, *arguments, **named)

    monkeypatch.setattr(builtins, "__import__", refuse)
    with pytest.raises(ImportError) as caught:
        _ = stoss.plot
    assert "pip install matplotlib" in str(caught.value) and "\n" not in str(caught.value)


def test_pictures_of_a_lossy_impact_have_its_heat(closed):
    lossy = stoss.impact(stoss.Sphere(poisson=0.3, loss_time=0.03), speed=0.1, cutoff=12.5)
    path = lossy.trajectory()
    lines = {line.get_label(): line for line in stoss.plot.energies(path).lines}
    assert list(lines) == ["translation", "vibration", "stored", "dissipated", "unresolved", "sum"]
    assert np.array_equal(lines["dissipated"].get_ydata(), path.dissipated)
    np.testing.assert_allclose(lines["sum"].get_ydata(), 1.0, atol=2e-3)
    ax = stoss.plot.ledger(lossy)
    assert ax.get_legend().get_texts()[-1].get_text() == "heat"
    assert ax.containers[-1][0].get_height() == lossy.dissipated < ax.get_ylim()[1]
    assert "heat" not in [text.get_text() for text in stoss.plot.ledger(lossy, when="average").get_legend().get_texts()]
