"""Oblique impacts: pictures and films show what the results hold."""

import os

import matplotlib
import numpy as np
import pytest
import stoss
from matplotlib import pyplot
from matplotlib.colors import to_rgb
from matplotlib.container import ErrorbarContainer
from PIL import Image


pytestmark = pytest.mark.usefixtures("closed")
BALL, PLATE = stoss.Sphere(poisson=0.3), stoss.Disk(poisson=0.33)


def drawn(ax):
    return [each for each in ax.containers if isinstance(each, ErrorbarContainer)]


def words(ax):
    return [text.get_text() for text in ax.get_legend().get_texts()]


def test_tangential_and_normal_restitution_against_the_angle():
    fan = stoss.oblique(BALL, speed=0.05, angle=[60, 5, -30], friction=0.2)
    ax = fan.plot()
    (curve,) = drawn(ax)
    assert curve.lines[0].get_xdata() == pytest.approx([-30, 5, 60])
    assert curve.lines[0].get_ydata().tolist() == fan.tangential_restitution[[2, 1, 0]].tolist()
    normal = next(line for line in ax.lines if line.get_label() == "$\\varepsilon_n$")
    assert normal.get_ydata().tolist() == fan.restitution.tolist()
    assert words(ax) == ["$\\varepsilon_n$", "$\\varepsilon_t$"] and "degrees" in ax.get_xlabel()


def test_a_curve_for_each_speed_friction_and_spin():
    fan = stoss.oblique(BALL, speed=[[0.02], [0.05]], tangential=[0.01, 0.02], friction=0.2)
    ax = stoss.plot.oblique(fan, over="sliding")
    assert [curve.lines[0].get_xdata().tolist() for curve in drawn(ax)] == [
        pytest.approx([0.01 / 0.004, 0.02 / 0.004]), pytest.approx([0.01 / 0.01, 0.02 / 0.01])
    ]  # fmt: skip
    assert words(ax)[1:] == ["$\\varepsilon_t$, v = 0.02 c", "$\\varepsilon_t$, v = 0.05 c"]
    steel = stoss.Sphere(radius=0.01, material=stoss.Material(young=2.1e11, poisson=0.3, density=7850))
    spins = stoss.oblique(steel, speed=1.0, angle=30, spin=[0, 100], friction=[[0.1], [0.2]]).plot()
    assert words(spins)[2] == "$\\varepsilon_t$, μ = 0.1, Ω = 100 rad/s" and len(drawn(spins)) == 4


def test_where_nothing_slides_there_is_no_tangential_restitution():
    ax = stoss.oblique(BALL, speed=0.05, tangential=[0.0, 0.01], friction=0.2).plot()
    assert drawn(ax)[0].lines[0].get_xdata().size == 1
    smooth = stoss.plot.oblique(stoss.oblique(BALL, speed=0.05, tangential=0.01, friction=0.0), over="sliding")
    assert drawn(smooth)[0].lines[0].get_xdata().size == 0


def test_doubtful_values_are_hollow():
    with pytest.warns(stoss.StossWarning):
        fan = stoss.oblique(BALL, speed=0.1, tangential=[0.02, 0.5], friction=0.2, tolerance=1e-5)
    ax = fan.plot()
    (hollow,) = [line for line in ax.lines if line.get_markerfacecolor() == "white"]
    assert hollow.get_ydata().tolist() == [fan.tangential_restitution[0]]


@pytest.fixture(scope="module")
def hit():
    return stoss.oblique_impact(BALL, speed=0.05, angle=25, friction=0.3, cutoff=20)


@pytest.fixture(scope="module")
def plate():
    return stoss.oblique_impact(PLATE, speed=0.05, angle=20, friction=0.3, cutoff=12.5)


def test_three_pictures_of_one_time(hit):
    ax, path = hit.plot(), hit.trajectory()
    velocities, forces, grip = ax.child_axes
    assert velocities.get_xlim() == forces.get_xlim() == grip.get_xlim()
    curves = {line.get_label(): line.get_ydata() for line in (*velocities.lines, *forces.lines)}
    assert curves["$v_t$"].tolist() == path.tangential.tolist() and curves["$F$"].tolist() == path.force.tolist()
    assert curves["$Q/\\mu$"] == pytest.approx(path.friction / 0.3) and words(velocities)[2] == "$\\Omega R$"
    assert forces.get_ylabel() == "force / (mc²/R)" and "time" in grip.get_xlabel()
    assert words(grip) == ["sticks", "slips along +y", "slips along −y"]
    (figure,) = {each.figure for each in (ax, *ax.child_axes)}
    figure.canvas.draw()  # labels of no picture reach into another
    boxes = [each.get_tightbbox() for each in ax.child_axes]
    assert boxes[0].y0 > boxes[1].y1 and boxes[1].y0 > boxes[2].y1


def test_both_spins_of_a_pair():
    pair = stoss.oblique_impact(BALL, speed=0.05, angle=40, second_spin=0.02, friction=0.1, against="same", cutoff=12)
    assert words(pair.plot().child_axes[0]) == ["$v_n$", "$v_t$", "$\\Omega_1R$", "$\\Omega_2R$"]


@pytest.mark.parametrize("of", ["ball", "plate"])
def test_the_map_of_stick_and_slip(hit, plate, of):
    path = (hit if of == "ball" else plate).trajectory()
    ax = stoss.plot.grip(path)
    (mesh,) = ax.collections
    assert (mesh.get_array().reshape(path.grip.T.shape) == path.grip.T).all()
    assert ax.get_ylabel() == ("radius of ring / R" if of == "ball" else "y / R")
    low, high = ax.get_ylim()
    touched = path.place[(path.grip != 2).any(axis=0)]
    assert low == (0 if of == "ball" else -high) and touched.max() < high < 1.5 * touched.max()


def test_shades_differ_without_colour():
    from stoss.plot._trajectory import BACKWARD, FORWARD, OPEN, STICK

    shades = sorted(float(np.dot(to_rgb(color), (0.299, 0.587, 0.114))) for color in (BACKWARD, FORWARD, OPEN, STICK))
    assert np.diff(shades).min() > 0.2


def test_smooth_impacts_and_few_rows_are_drawn():
    smooth = stoss.oblique_impact(PLATE, speed=0.05, angle=20, friction=0, cutoff=12)
    assert words(smooth.plot().child_axes[2]) == ["slips along +y"]
    stoss.plot.grip(smooth.trajectory()[:1])
    still = stoss.oblique_impact(BALL, speed=0.05, friction=0.2, cutoff=12)
    assert words(stoss.plot.grip(still.trajectory())) == ["sticks"]


def test_energies_in_time(hit):
    ax = stoss.plot.energies(hit.trajectory())
    labels = [line.get_label() for line in ax.lines]
    assert labels == ["translation", "across", "rotation", "elastic", "friction", "sum"]
    assert np.abs(ax.lines[-1].get_ydata() - 1).max() < 2e-3


def test_ledgers(hit):
    ax = stoss.plot.oblique_ledger(hit)
    assert [patch.get_width() for patch in ax.patches][:3] == [
        hit.energy.translation, hit.energy.across, hit.energy.rotation
    ]  # fmt: skip
    fan = stoss.oblique(BALL, speed=0.05, angle=[60, 5, -30], friction=0.2)
    stacked = stoss.plot.oblique_ledger(fan)
    assert stacked.get_xlim() == pytest.approx((-30, 60)) and "translation, normal" in words(stacked)
    assert stacked.lines[0].get_ydata().tolist() == fan.energy.translation[[2, 1, 0]].tolist()
    with pytest.raises(stoss.InvalidInput, match=r"result: got shape \(1, 1\), allowed one impact or a row of them"):
        stoss.plot.oblique_ledger(stoss.oblique(BALL, speed=[[0.05]], angle=60, friction=0.2))


@pytest.mark.parametrize("suffix", [".gif", ".mp4"])
def test_film(hit, plate, tmp_path, suffix):
    if suffix == ".mp4" and not matplotlib.animation.FFMpegWriter.isAvailable():
        pytest.skip("no ffmpeg")
    pair = stoss.oblique_impact(BALL, speed=0.05, angle=40, friction=0.1, against="same", cutoff=12)
    for k, each in enumerate((hit, plate, pair)):
        path = tmp_path / f"{k}{suffix}"
        assert stoss.animate(each, path, frames=8, size=(321, 200)) is path and path.stat().st_size > 1000
    assert sorted(os.listdir(tmp_path)) == [f"{k}{suffix}" for k in range(3)] and pyplot.get_fignums() == []


def test_film_moves_and_turns(hit, tmp_path):
    stoss.animate(hit, tmp_path / "hit.gif", frames=12)
    with Image.open(tmp_path / "hit.gif") as film:
        assert (film.n_frames, film.size) == (12, (640, 380))
        pictures = []
        for k in range(12):
            film.seek(k)
            pictures.append(np.asarray(film.convert("RGB"), dtype=int))
    # Below the time, at the top.
    scene, contact = ([each[40:, part] for each in pictures] for part in (slice(0, 320), slice(320, 640)))
    assert all(np.abs(one - two).max() > 50 for one, two in zip(scene, scene[1:]))
    assert (contact[0] == contact[1]).all() and np.abs(contact[0] - contact[5]).max() > 50
    assert (tmp_path / "hit.gif").stat().st_size < 300e3


def test_refused(hit, tmp_path):
    with pytest.raises(stoss.InvalidInput, match="quantity: got 'von_mises', allowed None for an oblique impact"):
        stoss.animate(hit, tmp_path / "hit.gif", quantity="von_mises")
    with pytest.raises(stoss.InvalidInput, match="trajectory: got"):
        stoss.plot.grip(hit)
    assert os.listdir(tmp_path) == []
