#!/usr/bin/env python3
"""Reads folders of `build` with another program: the plugs by OpenSCAD.

Usage: build.py PROGRAM
"""
import pathlib
import struct
import subprocess
import sys
import tempfile

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
        done = subprocess.run([program, "build", *words, "-o", place], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
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
