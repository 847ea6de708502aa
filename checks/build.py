#!/usr/bin/env python3
"""Reads folders of `build` with other programs: the plugs by OpenSCAD, the drawing by ezdxf.

Usage: build.py PROGRAM
"""
import json
import pathlib
import struct
import subprocess
import sys
import tempfile

import ezdxf

program = pathlib.Path(sys.argv[1]).resolve()
MUSCLES = {
    "prototype": ["examples/prototype.toml"],
    "latex": "--rubber latex --braid flexo-overexpanded-0.38in -D 0.375in -s 0.0625in -L 200mm -p 2bar --fitting barb:4".split(),
    "large": "-D 60 -s 3 -L 600 -p 1bar --fitting g1/4".split(),
}


def binary(path):
    """Triangles of a binary STL."""
    data = path.read_bytes()
    (count,) = struct.unpack_from("<I", data, 80)
    assert len(data) == 84 + 50 * count, path
    numbers = (struct.unpack_from("<12f", data, 84 + 50 * i) for i in range(count))
    return [[n[3:6], n[6:9], n[9:12]] for n in numbers]


def text(path):
    """Triangles of an STL in text, as OpenSCAD writes it."""
    corners = [tuple(map(float, line.split()[1:])) for line in path.read_text().splitlines() if line.strip().startswith("vertex")]
    return [corners[i : i + 3] for i in range(0, len(corners), 3)]


def volume(triangles):
    """By the theorem of Gauss."""
    total = 0.0
    for a, b, c in triangles:
        total += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    return total / 6


def box(triangles):
    points = [p for t in triangles for p in t]
    return [f(p[k] for p in points) for k in range(3) for f in (min, max)]


with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    for name, words in MUSCLES.items():
        place = folder / name
        done = subprocess.run([program, "build", *words, "-o", place, "--format", "json"], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        answer = json.loads(done.stdout)
        for plug in ("air-plug", "eye-plug"):
            made = place / f"{plug}-openscad.stl"
            done = subprocess.run(["openscad", "-o", made, place / f"{plug}.scad"], capture_output=True, text=True)
            assert done.returncode == 0 and "Simple:        yes" in done.stderr and "WARNING" not in done.stderr, done.stderr
            ours, theirs = binary(place / f"{plug}.stl"), text(made)
            # The same facets; the numbers of both files are rounded.
            ratio = volume(ours) / volume(theirs)
            assert abs(ratio - 1) < 1e-4, (name, plug, ratio)
            assert all(abs(a - b) < 0.02 for a, b in zip(box(ours), box(theirs))), (name, plug, box(ours), box(theirs))
            print(f"{name} {plug}: {volume(ours):.1f} mm3, OpenSCAD {volume(theirs):.1f} mm3")
        for drawing in ("plugs.dxf", "drawing.dxf"):
            document = ezdxf.readfile(place / drawing)
            errors = document.audit().errors
            assert not errors and len(document.modelspace()) > 100, errors
        space = document.modelspace()
        lines = [e for e in space if e.dxftype() == "LINE" and e.dxf.layer == "OUTLINE"]
        lengths = [(e.dxf.start - e.dxf.end).magnitude for e in lines]
        length_mm = answer["muscle"]["length_mm"]
        assert any(abs(x - length_mm) < 1e-3 for x in lengths), "the free length is not in its true size"
        radii = {round(2 * e.dxf.radius, 3) for e in space if e.dxftype() == "CIRCLE"}
        assert round(answer["muscle"]["outer_diameter_mm"], 3) in radii, radii
        print(f"{name} drawing.dxf: {len(space)} bodies, no errors")
