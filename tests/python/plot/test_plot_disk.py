"""The disk at the wall, its stress and sequences: what is drawn is what the fields hold."""

import re

import numpy as np
import pytest
import stoss
from matplotlib.collections import LineCollection, QuadMesh


pytestmark = pytest.mark.usefixtures("closed")

RADIUS = np.linspace(0.0, 1.0, 13)
ANGLE = np.linspace(-np.pi, np.pi, 49)


@pytest.fixture(scope="module")
def hit():
    return stoss.impact(poisson=0.33, speed=0.2, cutoff=12.5)


@pytest.fixture(scope="module")
def field(hit):
    return hit.field(time=hit.contact_time / 2, radius=RADIUS, angle=ANGLE)


@pytest.fixture(scope="module")
def several(hit):
    return hit.field(time=np.array([[-1.0, 1.0], [2.0, 9.0]]), radius=RADIUS, angle=ANGLE)


def of(ax, kind):
    return [each for each in ax.collections if isinstance(each, kind)]


def mesh_of(ax):
    (mesh,) = of(ax, QuadMesh)
    return mesh


def test_disk(field):
    ax = stoss.plot.disk(field, circles=3, spokes=8)
    (grid,) = of(ax, LineCollection)
    segments = grid.get_segments()
    assert len(segments) == 3 + 8
    for segment, i in zip(segments, (4, 8, 12)):
        assert np.array_equal(segment, np.column_stack((field.x[i], field.y[i])))
    for segment, j in zip(segments[3:], range(0, 48, 6)):
        assert np.array_equal(segment, np.column_stack((field.x[:, j], field.y[:, j])))
    wall = [line for line in ax.lines if np.array_equal(line.get_xdata(), [0, 0])]
    assert len(wall) == 1
    assert ax.get_aspect() == 1.0 and (ax.get_xlabel(), ax.get_ylabel()) == ("x / R", "y / R")
    assert ax.get_title() == f"t = {field.time:.4g} R/c"
    assert ax.get_xlim()[0] < field.x.min() and ax.get_ylim()[1] > field.y.max()


def test_outline_stays_before_the_wall(field):
    outline = stoss.plot.disk(field).lines[0].get_xydata()
    seen = np.isfinite(outline[:, 0])
    assert seen.any() and not seen.all() and outline[seen, 0].max() <= 0.0
    np.testing.assert_allclose(np.hypot(outline[seen, 0] - field.center, outline[seen, 1]), 1.0)
    assert len(stoss.plot.disk(field, outline=False).lines) == 1


@pytest.mark.parametrize("frame, place", [(2, (1, 0)), (-1, (1, 1))])
def test_one_frame_of_several(several, frame, place):
    mesh = mesh_of(stoss.plot.stress(several, frame=frame))
    assert np.array_equal(mesh.get_array().ravel(), several.von_mises[place].ravel())
    (grid,) = of(stoss.plot.disk(several, frame=frame, circles=1), LineCollection)
    assert np.array_equal(grid.get_segments()[0][:, 0], several.x[place][-1])


@pytest.mark.parametrize(
    "quantity, name", [("von_mises", "von Mises stress / E"), ("principal_difference", "|σ₁ − σ₂| / E")]
)
def test_stress(field, quantity, name):
    ax = stoss.plot.stress(field, quantity=quantity)
    mesh, values = mesh_of(ax), getattr(field, quantity)
    assert np.array_equal(mesh.get_array().reshape(values.shape), values)
    assert np.array_equal(mesh.get_coordinates(), np.stack((field.x, field.y), axis=-1))
    bar = ax.figure.axes[-1]
    assert bar.get_ylabel() == name
    assert mesh.norm.vmin == 0.0 and mesh.get_cmap().name in ("viridis", "cividis")


def test_colours_cover_most_of_the_area():
    slow = stoss.impact(poisson=0.33, speed=1e-3, cutoff=12.5)
    angle = np.linspace(-1.0, 1.0, 61) ** 3 * np.pi  # dense at the wall, where the stress is
    field = slow.field(time=slow.contact_time / 2, radius=np.linspace(0.0, 1.0, 33), angle=angle)
    mesh = mesh_of(field.plot())
    top = mesh.norm.vmax
    assert top < field.von_mises.max()
    assert mesh.colorbar.extend == "max"
    area = field.radius[:, None] * np.gradient(angle)
    assert 0.98 < area[field.von_mises <= top].sum() / area.sum() < 0.995


def test_fringes(field):
    ax = stoss.plot.stress(field, quantity="fringes", fringe=0.05)
    mesh = mesh_of(ax)
    light = np.asarray(mesh.get_array()).reshape(mesh.get_coordinates().shape[:2])
    # The field's own points, between them others.
    np.testing.assert_allclose(light[::3, ::3], np.sin(np.pi * field.principal_difference / 0.05) ** 2, atol=1e-12)
    between = (2.0 * field.principal_difference[:-1] + field.principal_difference[1:]) / 3.0
    np.testing.assert_allclose(light[1::3, ::3], np.sin(np.pi * between / 0.05) ** 2, atol=1e-9)
    assert np.array_equal(mesh.get_coordinates()[::3, ::3, 0], field.x)
    assert (mesh.norm.vmin, mesh.norm.vmax) == (0.0, 1.0)
    assert "f = 0.05 E" in ax.figure.axes[-1].get_ylabel()


def test_field_refusals(hit, field, several):
    with pytest.raises(stoss.InvalidInput, match="field: got 4 times, allowed one .*frame="):
        several.plot()
    with pytest.raises(stoss.InvalidInput, match="field: got 1 x 49 points, allowed at least 2 radii and 2 angles"):
        stoss.plot.disk(hit.field(time=1.0, radius=1.0, angle=ANGLE))
    with pytest.raises(stoss.InvalidInput, match="circles: got 0, allowed 1 to 1000"):
        stoss.plot.disk(field, circles=0)


def test_sequence(hit):
    times = [-0.5, 2.0, 9.0, 3.0, 4.0]
    ax = stoss.plot.sequence(hit, times=times, columns=3)
    grids = of(ax, LineCollection)
    assert [text.get_text() for text in ax.texts] == ["t = −0.50 R/c", "2.00", "9.00", "3.00", "4.00"]
    where = np.array([text.get_position() for text in ax.texts])
    edge = hit.field(time=times, radius=[1.0], angle=np.linspace(-np.pi, np.pi, 193))
    pitch = where[1, 0] - where[0, 0]
    walls = sorted((line.get_ydata()[0] for line in ax.lines if line.get_color() == "#000000"), reverse=True)
    assert len(grids) == 5 and len(walls) == 2
    for k, grid in enumerate(grids):
        (drawn,) = [line for line in grid.get_segments() if len(line) == 193][-1:]
        np.testing.assert_allclose(drawn[:, 0], edge.y[k, 0] + (k % 3) * pitch, atol=1e-12)
        np.testing.assert_allclose(drawn[:, 1], walls[k // 3] - edge.x[k, 0], atol=1e-12)
    assert pitch > 2 * np.abs(edge.y).max()  # no disk over another
    # The times are below their disks and nothing else is, which would read as the title of what follows.
    assert ax.get_aspect() == 1.0 and ax.get_xlabel() == ""


@pytest.mark.parametrize("wall", [stoss.HardWall(), stoss.ExponentialWall()])
def test_default_times(wall):
    hit = stoss.impact(poisson=0.33, speed=0.2, cutoff=12.5, against=wall)
    ax = stoss.plot.sequence(hit, count=4)
    times = [float(re.sub("t = | R/c", "", text.get_text()).replace("−", "-")) for text in ax.texts]
    gaps = -hit.field(time=times, radius=[1.0], angle=np.linspace(-np.pi, np.pi, 193)).x.max(axis=(1, 2))
    assert gaps[0] > 0.1 and gaps[-1] > 0.1 and min(gaps[1:-1]) < 0.03  # an exponential wall keeps its distance
    np.testing.assert_allclose(np.diff(times), np.diff(times)[0], atol=0.02)


def test_only_disks_have_pictures():
    rod = stoss.impact(stoss.Rod(), speed=0.1, cutoff=100)
    with pytest.raises(stoss.InvalidInput, match="allowed a stoss.Disk"):
        stoss.plot.sequence(rod)
