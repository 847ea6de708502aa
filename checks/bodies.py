"""Plugs and moulds of `build` in a mesh library (watertight, one body, walls), turned plugs in Open CASCADE (valid solids with the mass
of the bill): checks/bodies.py PROGRAM"""

import csv
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import trimesh
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepGProp import BRepGProp
from OCP.GProp import GProp_GProps
from OCP.STEPControl import STEPControl_Reader

PROGRAM = sys.argv[1]
# Outer diameter and wall in mm, pressure, rubber: tied, clamped and crimped ends, the mould of a cast tube.
MUSCLES = [
    (5, 0.8, "1bar", "ecoflex-00-50"),
    (8, 1, "1bar", "latex"),
    (9.525, 1.5875, "2bar", "latex"),
    (12, 2, "1.5bar", "latex"),
    (12, 2, "1.5bar", "ecoflex-00-50"),
    (20, 2.5, "0.5bar", "latex"),
    (20, 2.5, "0.5bar", "ecoflex-00-50"),
    (30, 3, "2.5bar", "ecoflex-00-50"),
    (60, 4, "1bar", "ecoflex-00-50"),
    (88, 4, "1.86bar", "dragon-skin-30"),
]
FITTINGS = ["m3", "m5", "g1/8", "g1/4", "barb:4"]
LEAST_WALL_MM = 0.6
# Aluminium in g/mm³.
DENSITY = 2.7e-3


def walls(mesh: trimesh.Trimesh) -> float:
    """The wall in mm that 98 % of the surface has: inwards along its normal; at edges it ends in nothing."""
    points, faces = trimesh.sample.sample_surface(mesh, 2000, seed=1)
    inwards = -mesh.face_normals[faces]
    hits, rays, _ = mesh.ray.intersects_location(
        points + 1e-4 * inwards, inwards, multiple_hits=False
    )
    return float(np.percentile(np.linalg.norm(hits - points[rays], axis=1), 2))


def volume(path: Path) -> float:
    """The volume in mm³ of a valid solid."""
    reader = STEPControl_Reader()
    reader.ReadFile(str(path))
    reader.TransferRoots()
    solid = reader.OneShape()
    assert BRepCheck_Analyzer(solid).IsValid(), path
    found = GProp_GProps()
    BRepGProp.VolumeProperties_s(solid, found)
    return found.Mass()


def main() -> None:
    bodies, solids = 0, 0
    for outer, wall, pressure, rubber in MUSCLES:
        for fitting in FITTINGS:
            with tempfile.TemporaryDirectory() as folder:
                muscle = [
                    "-D",
                    str(outer),
                    "-s",
                    str(wall),
                    "-L",
                    "150",
                    "--rubber",
                    rubber,
                    "--angle",
                    "25",
                ]
                subprocess.run(
                    [
                        PROGRAM,
                        "build",
                        *muscle,
                        "-p",
                        pressure,
                        "--fitting",
                        fitting,
                        "-o",
                        f"{folder}/out",
                    ],
                    check=True,
                    capture_output=True,
                )
                for path in sorted(Path(folder).glob("out/bodies/*.stl")):
                    mesh = trimesh.load(path)
                    what = f"{outer} × {wall} mm of {rubber}, {fitting}: {path.name}"
                    assert mesh.is_watertight and mesh.is_winding_consistent, what
                    assert mesh.body_count == 1 and mesh.volume > 0, what
                    assert abs(mesh.bounds[0][2]) < 1e-6, (
                        f"{what}: it does not stand on the printer"
                    )
                    assert (least := walls(mesh)) > LEAST_WALL_MM, (
                        f"{what}: a wall of {least:.2f} mm"
                    )
                    bodies += 1
                with open(f"{folder}/out/bom.csv", encoding="utf-8") as bill:
                    grams = {
                        row["part"]: row["mass (g)"] for row in csv.DictReader(bill)
                    }
                for path in sorted(Path(folder).glob("out/bodies/*.step")):
                    mass = float(grams[path.stem.replace("-", " ")])
                    off = DENSITY * volume(path) / mass - 1
                    assert abs(off) < 6e-3, (
                        f"{outer} × {wall} mm, {fitting}: {path.name} {off}"
                    )
                    solids += 1
    assert bodies >= 20 and solids >= 20, (bodies, solids)
    print(
        f"{bodies} bodies are watertight, of one piece, with walls above {LEAST_WALL_MM} mm; {solids} solids are valid"
    )


main()
