#!/usr/bin/env python3
"""Reads the whole muscle that `simulate --model fe3d --vtu DIR --whole` writes with meshio, and holds it against what was printed.

Usage: vtu3d.py FOLDER JSON

Contraction and diameter follow from the points; the rubber keeps its volume; and the pull is what crosses the middle: axial stress of the
rubber, axial part of the strands' tension, less the pressure on the cavity's section.
"""

import json
import pathlib
import sys
import xml.etree.ElementTree as xml

import meshio
import numpy as np

folder = pathlib.Path(sys.argv[1])
printed = json.loads(pathlib.Path(sys.argv[2]).read_text())["points"]
steps = {}
for part in xml.parse(folder / "muscle.pvd").getroot().iter("DataSet"):
    steps.setdefault(int(part.get("timestep")), {})[part.get("name")] = (
        folder / part.get("file")
    )
assert sorted(steps) == list(range(len(printed))), (
    f"{len(steps)} steps, {len(printed)} printed"
)


def volume(points, cells):
    """Of trilinear hexahedra, by 2 × 2 × 2 points."""
    corners = np.array(
        [
            (-1, -1, -1),
            (1, -1, -1),
            (1, 1, -1),
            (-1, 1, -1),
            (-1, -1, 1),
            (1, -1, 1),
            (1, 1, 1),
            (-1, 1, 1),
        ]
    )
    x, total = points[cells], 0.0
    for at in np.array(np.meshgrid(*[[-1, 1]] * 3)).reshape(3, 8).T / np.sqrt(3):
        f = 1 + corners * at
        slope = (
            corners / 8 * np.c_[f[:, 1] * f[:, 2], f[:, 2] * f[:, 0], f[:, 0] * f[:, 1]]
        )
        total += np.linalg.det(np.einsum("eai,aj->eij", x, slope)).sum()
    return total


def polygon(points):
    x, y = points[:, 0], points[:, 1]
    return 0.5 * abs(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)))


worst = {"volume": 0.0, "pull": 0.0}
for step, point in enumerate(printed):
    tube, braid = meshio.read(steps[step]["tube"]), meshio.read(steps[step]["braid"])
    for mesh in (tube, braid):
        for name, values in mesh.point_data.items():
            assert len(values) == len(mesh.points) and np.isfinite(values).all(), name
    (block,) = tube.cells
    assert block.type == "hexahedron"
    rest = tube.points - tube.point_data["displacement"]
    now, then = volume(tube.points, block.data), volume(rest, block.data)
    worst["volume"] = max(worst["volume"], abs(now / then - 1))
    z = tube.points[:, 2]
    contraction = 1 - (z.max() - z.min()) / (rest[:, 2].max() - rest[:, 2].min())
    assert abs(contraction - point["contraction"]) < 1e-9, contraction

    # The plane z = 0, ring by ring from the bore.
    (middle,) = np.nonzero(np.abs(rest[:, 2]) < 1e-9)
    radius = np.hypot(rest[middle, 0], rest[middle, 1])
    rings = [middle[np.abs(radius - r) < 1e-6] for r in np.unique(radius.round(6))]
    rings = [
        ring[np.argsort(np.arctan2(rest[ring, 1], rest[ring, 0]))] for ring in rings
    ]
    areas = [polygon(tube.points[ring]) for ring in rings]
    stress = [tube.point_data["stress_axial_mpa"][ring].mean() for ring in rings]
    wall = sum(
        (b - a) * 0.5 * (s + t)
        for a, b, s, t in zip(areas, areas[1:], stress, stress[1:])
    )
    tension, angle = (
        braid.point_data["mesh_strand_tension_n"][::2],
        np.radians(braid.point_data["angle_deg"][::2]),
    )
    ends = braid.points.reshape(-1, 2, 3)[:, :, 2]
    # Pieces of the row above the middle.
    row = np.abs(ends.min(axis=1)) < 1e-9
    strands = np.sum((tension * np.cos(angle))[row])
    pull = wall + strands - point["pressure_mpa"] * areas[0]
    share = abs(pull - point["force_n"]) / strands
    worst["pull"] = max(worst["pull"], share)
assert worst["volume"] < 1e-6, worst
# One brick through the wall: its stress is one number.
assert worst["pull"] < 0.01, worst
print(
    f"{len(printed)} steps: volume of the rubber kept within {worst['volume']:.1e}, pull across the middle within {100 * worst['pull']:.2f} % of the strands' part"
)
