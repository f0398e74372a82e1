"""The files of a map: VTU for viewers of meshes, CSV for programs, and a picture."""

from __future__ import annotations

import argparse
from typing import Any

import numpy as np

from stoss import __version__
from stoss.export._files import whole_file, write_lines
from stoss.modal._map_options import beside

TRIANGLE = 5
"""Type of a cell of VTK."""
COLUMNS = ("point", "x[m]", "y[m]", "z[m]", "normal_x", "normal_y", "normal_z", "speed[m/s]",
           "restitution", "restitution_error", "contact_time[s]", "reason")  # fmt: skip


def write_map(given: argparse.Namespace, made: Any) -> list[str]:
    """Writes all three. Returns their names."""
    names = names_of(given)
    codes = _codes(made)
    write_lines(names[0], _vtu(made, codes))
    write_lines(names[1], _csv(given, made, codes))
    _picture(names[2], made)
    return names


def names_of(given: argparse.Namespace) -> list[str]:
    """VTU, CSV and PNG."""
    return [beside(given.map, ending) for ending in (".vtu", ".csv", ".png")]


def _codes(made: Any) -> Any:
    """The number of the reason of each point, 0 where it has its values."""
    number = {reason: code for code, (reason, _) in enumerate(made.counts(), 1)}
    return np.array([number.get(reason, 0) for reason in made.reasons])


def _vtu(made: Any, codes: Any) -> list[str]:
    """An unstructured grid of triangles: https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html."""

    def array(name: str, values: Any, kind: str = "Float64", parts: int = 1) -> str:
        text = " ".join("nan" if value != value else f"{value:.9g}" for value in np.ravel(values))
        return (
            f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{parts}" format="ascii">{text}</DataArray>\n'
        )

    places = made.places
    count, cells = len(places.points), len(places.triangles)
    lines = [
        '<?xml version="1.0"?>\n',
        '<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">\n<UnstructuredGrid>\n',
        f'<Piece NumberOfPoints="{count}" NumberOfCells="{cells}">\n<PointData Scalars="restitution {made.speeds[0]:g} m/s">\n',
    ]
    for at, speed in enumerate(made.speeds):
        for name, values in (
            ("restitution", made.restitution),
            ("restitution_error", made.error),
            ("contact_time", made.contact_time),
        ):
            lines.append(array(f"{name} {speed:g} m/s", values[at]))
    lines += [array("normal", places.normals, parts=3), array("reason", codes, "Int32"), "</PointData>\n<Points>\n"]
    lines += [
        array("points", places.points, parts=3),
        "</Points>\n<Cells>\n",
        array("connectivity", places.triangles, "Int64"),
    ]
    lines += [array("offsets", 3 * np.arange(1, cells + 1), "Int64"), array("types", np.full(cells, TRIANGLE), "UInt8")]
    return [*lines, "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"]


def _csv(given: argparse.Namespace, made: Any, codes: Any) -> list[str]:
    """A row for each point and speed, as `stoss.read_csv` takes it."""
    lines = [f"# stoss {__version__}: bounce map\n", f"# against: {given.against!r}\n", f"# origin: {made.origin}\n"]
    lines += [f"# reason {code}: {reason} ({count} points)\n" for code, (reason, count) in enumerate(made.counts(), 1)]
    lines.append(",".join(COLUMNS) + "\n")
    for row, speed in enumerate(made.speeds):
        for at, (point, normal) in enumerate(zip(made.places.points, made.places.normals)):
            its = (made.restitution[row, at], made.error[row, at], made.contact_time[row, at])
            numbers = ",".join(f"{value:.9g}" for value in (*point, *normal, speed, *its))
            lines.append(f"{at},{numbers},{codes[at]}\n")
    return lines


def _coloured(colours: Any, scale: Any, values: Any) -> Any:
    """Colours of values, grey where they are not known."""
    known = np.isfinite(values)
    found = np.full((len(values), 4), GREY)
    found[known] = colours(scale(values[known]))
    return found


GREY = (0.75, 0.75, 0.75, 1.0)
VIEWS = ((25, -60), (25, 120), (-25, 30))
"""From where the picture looks, elevation and azimuth in degrees."""


def _picture(path: str, made: Any) -> None:
    """A row of views for each speed, all on one scale; grey where ε is not known."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    points, triangles = made.places.points, made.places.triangles
    rows = len(made.speeds)
    figure = plt.figure(figsize=(9.6, 3.4 * rows + 0.3), layout="constrained")
    scale = plt.Normalize(float(np.nanmin(made.restitution)), float(np.nanmax(made.restitution)))
    colours = plt.get_cmap("viridis")
    low, high = points.min(axis=0), points.max(axis=0)
    axes: list[Any] = []
    for row, speed in enumerate(made.speeds):
        values = made.restitution[row][triangles].mean(axis=1)
        for column, (elevation, azimuth) in enumerate(VIEWS):
            view: Any = figure.add_subplot(rows, len(VIEWS), len(VIEWS) * row + column + 1, projection="3d")
            view.add_collection3d(Poly3DCollection(points[triangles], facecolors=_coloured(colours, scale, values)))
            view.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
            view.set_box_aspect(high - low)
            view.set_axis_off()
            view.view_init(elevation, azimuth)
            axes.append(view)
        axes[-2].set_title(f"{speed:g} m/s")
    figure.colorbar(plt.cm.ScalarMappable(scale, colours), ax=axes, label="coefficient of restitution", shrink=0.8)
    with whole_file(path, ".png") as temporary:
        figure.savefig(temporary, dpi=150)
    plt.close(figure)
