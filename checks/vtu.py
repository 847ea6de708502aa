#!/usr/bin/env python3
"""Reads a series for ParaView with meshio (and with VTK itself where it is installed) and compares it with what was printed.

Usage: vtu.py FOLDER JSON [PNG]

JSON: {"points": [{"pressure_mpa", "contraction", "force_n", "volume_mm3", "bulged_diameter_mm"}, ...]}, one per step.
With PNG the steps are drawn by matplotlib.
"""

import json
import pathlib
import sys
import xml.etree.ElementTree as xml

import meshio
import numpy as np

folder = pathlib.Path(sys.argv[1])
printed = json.loads(pathlib.Path(sys.argv[2]).read_text())["points"]
picture = sys.argv[3] if len(sys.argv) > 3 else None
AROUND = 48

steps = {}
for part in xml.parse(folder / "muscle.pvd").getroot().iter("DataSet"):
    steps.setdefault(int(part.get("timestep")), {})[part.get("name")] = (
        folder / part.get("file")
    )
assert sorted(steps) == list(range(len(printed))), (
    f"{len(steps)} steps, {len(printed)} printed"
)
left = [path.name for path in folder.iterdir() if path.name.startswith(".vtu-")]
assert not left, f"left half-written: {left}"


def near(found, expected, tolerance, what):
    error = abs(found / expected - 1) if expected else abs(found)
    assert error < tolerance, f"{what}: {found} in the file, {expected} printed"
    return error


def finite(mesh, names):
    assert set(names) <= set(mesh.point_data), f"only {sorted(mesh.point_data)}"
    assert np.isfinite(mesh.points).all()
    for name, values in mesh.point_data.items():
        assert len(values) == len(mesh.points) and np.isfinite(values).all(), name


def lines(mesh):
    """meshio knows no poly-lines; their points stand one after another. A line ends at the far terminal."""
    ends = np.flatnonzero(np.diff(mesh.points[:, 2]) < 0) + 1
    return np.split(mesh.points, ends)


polygon = np.sin(2 * np.pi / AROUND) / (2 * np.pi / AROUND)
gauss = [(-np.sqrt(0.6), 5 / 9), (0.0, 8 / 9), (np.sqrt(0.6), 5 / 9)]
worst = {"volume": 0.0, "hexahedra": 0.0, "diameter": 0.0}
drawn = []
for step, point in enumerate(printed):
    tube = meshio.read(steps[step]["tube"])
    braid = meshio.read(steps[step]["braid"])
    finite(
        tube,
        [
            "displacement",
            "hoop_stretch",
            "meridional_stretch",
            "max_stretch",
            "stress_hoop_mpa",
        ],
    )
    finite(braid, ["stretch", "angle_deg", "tension_per_width_n_per_mm", "family"])
    for mesh in (tube, braid):
        for name in (
            "pressure_mpa",
            "contraction",
            "force_n",
            "volume_mm3",
            "bulged_diameter_mm",
        ):
            near(float(np.ravel(mesh.field_data[name])[0]), point[name], 1e-12, name)

    # Rings station by station, each from the bore outwards.
    (block,) = tube.cells
    assert block.type == "hexahedron"
    z = tube.points[::AROUND, 2]
    across = int(np.argmax(z > z[0] + 1e-9))
    rings = tube.points.reshape(-1, across, AROUND, 3)
    assert len(block.data) == (len(rings) - 1) * (across - 1) * AROUND
    assert len(np.unique(block.data)) == len(tube.points), "points without a cell"
    radius, height = np.hypot(rings[..., 0, 0], rings[..., 0, 1]), rings[:, :, 0, 2]
    assert np.allclose(height, -height[::-1]) and np.allclose(radius, radius[::-1])

    length = height[-1, 0] - height[0, 0]
    rest = tube.points - tube.point_data["displacement"]
    near(
        1 - length / (rest[:, 2].max() - rest[:, 2].min()),
        point["contraction"],
        1e-9,
        "contraction",
    )
    # The highest place of the outer line, which is quadratic through three rings each, may lie between them.
    a, b, c = radius[:-2:2, -1], radius[1::2, -1], radius[2::2, -1]
    bend = a - 2 * b + c
    x = np.clip(
        np.divide(a - c, 2 * bend, out=np.zeros_like(bend), where=bend < 0), -1, 1
    )
    highest = b + (c - a) / 2 * x + bend / 2 * x**2
    error = near(
        2 * max(highest.max(), radius.max()),
        point["bulged_diameter_mm"],
        1e-9,
        "bulged diameter",
    )
    worst["diameter"] = max(worst["diameter"], error)

    # The cavity under quadratic lines through three rings each: what the elements enclose.
    r, h = radius[:, 0], height[:, 0]
    volume = 0.0
    for k in range(0, len(r) - 1, 2):
        for x, w in gauss:
            n = np.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2])
            volume += (
                w
                * np.pi
                * (n @ r[k : k + 3]) ** 2
                * (np.array([x - 0.5, -2 * x, x + 0.5]) @ h[k : k + 3])
            )
    error = near(volume, point["volume_mm3"], 1e-9, "volume")
    worst["volume"] = max(worst["volume"], error)
    # The cavity inside the hexahedra: a polygon around, straight lines along. A chord over the length dz is off the line
    # by up to |r''| dz²/8, which second differences of the rings tell.
    faces = (
        (np.diff(h) * (r[:-1] ** 2 + r[:-1] * r[1:] + r[1:] ** 2) / 3).sum()
        * np.pi
        * polygon
    )
    slope = np.diff(r) / np.diff(h)
    bend = np.abs(np.diff(slope)) / (0.5 * (h[2:] - h[:-2]))
    chord = (
        2
        * (
            np.concatenate([bend[:1], bend])[: len(h) - 1]
            * np.diff(h) ** 2
            / 8
            * np.diff(h)
        ).sum()
        / (r.min() * length)
    )
    worst["its bound"] = max(worst.get("its bound", 0.0), float(chord))
    error = near(faces, point["volume_mm3"] * polygon, chord, "volume of the hexahedra")
    worst["hexahedra"] = max(worst["hexahedra"], error)
    corner = tube.points[block.data]
    edge = [corner[:, k] - corner[:, 0] for k in (1, 3, 4)]
    assert (np.einsum("ij,ij->i", np.cross(edge[0], edge[1]), edge[2]) > 0).all(), (
        "cells turned inside out"
    )

    strands = lines(braid)
    assert len(strands) == float(np.ravel(braid.field_data["strands_drawn"])[0])
    for line in strands:
        near(line[-1, 2] - line[0, 2], length, 1e-9, "length of the braid")
    outside = np.hypot(*braid.points[:, :2].T)
    near(outside.max(), radius[:, -1].max(), 1e-4, "strands on the outer surface")
    drawn.append((tube, block.data, rings, strands, braid.point_data["stretch"]))

    try:
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    except ImportError:
        continue
    for name, mesh, cells in (
        ("tube", tube, len(block.data)),
        ("braid", braid, len(strands)),
    ):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(steps[step][name]))
        reader.Update()
        grid = reader.GetOutput()
        assert grid.GetNumberOfCells() == cells and grid.GetNumberOfPoints() == len(
            mesh.points
        )
        assert grid.GetPointData().GetNumberOfArrays() == len(mesh.point_data)
        assert np.allclose(
            [grid.GetPoint(k) for k in range(0, len(mesh.points), 97)],
            mesh.points[::97],
        )
        assert grid.GetFieldData().GetArray("force_n").GetValue(0) == point["force_n"]
        if name == "braid":
            assert all(
                grid.GetCell(k).GetNumberOfPoints() == len(strands[k])
                for k in range(cells)
            )
        worst["read by VTK"] = worst.get("read by VTK", 0) + 1

print(
    f"{len(printed)} steps: {', '.join(f'{k} {v:.1e}' if isinstance(v, float) else f'{v} files {k}' for k, v in worst.items())}"
)

if picture:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    rows = [0, len(drawn) - 1]
    figure = plt.figure(figsize=(14, 5 * len(rows)))
    for row, k in enumerate(rows):
        tube, cells, rings, strands, _ = drawn[k]
        axes = figure.add_subplot(
            len(rows), 1, row + 1, projection="3d", computed_zorder=False
        )
        outer = np.concatenate([rings[:, -1], rings[:, -1, :1]], axis=1)
        value = tube.point_data["max_stretch"].reshape(rings.shape[:3])[:, -1]
        span = value.max() - value.min()
        colour = plt.cm.viridis(
            (np.concatenate([value, value[:, :1]], axis=1) - value.min()) / span
        )
        axes.plot_surface(
            outer[..., 2],
            outer[..., 0],
            outer[..., 1],
            facecolors=colour,
            rstride=1,
            cstride=1,
            shade=False,
        )
        for line in strands:
            # Only what faces the eye.
            seen = np.where(
                (line[:, 0] * -0.87 + line[:, 1] * 0.5 > 0)[:, None], line, np.nan
            )
            axes.plot(
                seen[:, 2], seen[:, 0] * 1.01, seen[:, 1] * 1.01, color="black", lw=0.6
            )
        axes.set_box_aspect(np.ptp(outer.reshape(-1, 3), axis=0)[[2, 0, 1]])
        axes.view_init(elev=30, azim=-90)
        axes.set_title(
            f"step {k}: {printed[k]['pressure_mpa']:.2f} MPa, max stretch {value.min():.3f} to {value.max():.3f}"
        )
    figure.savefig(picture, dpi=80, bbox_inches="tight")
