#!/usr/bin/env python3
"""Reads what the program writes with other programs: JSON and CSV by Python, PNG by Pillow, SVG and HTML by Chromium.

Usage: outputs.py PROGRAM [CHROMIUM]
"""

import csv
import io
import json
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

from PIL import Image

program = pathlib.Path(sys.argv[1]).resolve()
chromium = sys.argv[2] if len(sys.argv) > 2 else None


def run(*args):
    done = subprocess.run([program, *args], capture_output=True, text=True)
    assert done.returncode == 0, f"{args}: exit {done.returncode}: {done.stderr}"
    return done.stdout


def ink(path):
    """Share of pixels that are not the background."""
    image = Image.open(path).convert("L")
    histogram = image.histogram()
    return 1 - max(histogram) / sum(histogram), image.size


curve = [
    "curve",
    "isobaric",
    "-D",
    "50",
    "-s",
    "1",
    "-p",
    "0.05..0.25:0.05",
    "-e",
    "0..0.2:0.01",
]
points = json.loads(run(*curve, "--format", "json"))["points"]
rows = list(csv.DictReader(io.StringIO(run(*curve, "--format", "csv"))))
assert len(points) == len(rows) == 105
for point, row in zip(points, rows):
    assert (
        float(row["force_n"]) == point["force_n"]
        and float(row["contraction"]) == point["contraction"]
    )
print("JSON and CSV: 105 points each, the same numbers")

figures = {
    "design": [
        "design",
        "--force",
        "700N",
        "--contraction",
        "15%",
        "--max-pressure",
        "2.5bar",
        "--format",
        "json",
    ],
    "curve": curve,
    "study": ["curve", "--study", "thickness", "--model", "thick-wall"],
    "compare": [
        "compare",
        "--models",
        "ideal,thick-wall",
        "--muscle",
        "examples/tondu2012.toml",
        "--data",
        "data/tondu2012/static_force_20deg.csv",
    ],
}
with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    for name, args in figures.items():
        for ending in ("svg", "png", "html"):
            run(*args, "--plot", str(folder / f"{name}.{ending}"))
        assert xml.parse(folder / f"{name}.svg").getroot().tag.endswith("svg")
        share, size = ink(folder / f"{name}.png")
        assert share > 0.01, f"{name}.png is empty"
        print(f"{name}.png: {size[0]} x {size[1]}, {100 * share:.1f} % drawn")
        if not chromium:
            continue
        page = (folder / f"{name}.html").read_text()
        assert (
            "http://" not in page.replace("http://www.w3.org/", "")
            and "https://" not in page
        ), "the page asks the network"
        assert "<script" not in page and page.count("<td>") > 20, (
            "the page needs a script or lacks its table"
        )
        for ending in ("svg", "html"):
            shot = folder / f"{name}-{ending}.png"
            flags = [
                "--headless",
                "--no-sandbox",
                "--disable-gpu",
                "--no-first-run",
                "--disable-sync",
                "--disable-quic",
                "--disable-background-networking",
                "--disable-component-update",
                f"--user-data-dir={folder / 'profile'}",
                "--window-size=1200,900",
                f"--screenshot={shot}",
            ]
            subprocess.run(
                [chromium, *flags, (folder / f"{name}.{ending}").as_uri()],
                capture_output=True,
                timeout=120,
            )
            share, size = ink(shot)
            assert share > 0.01, f"the browser shows nothing of {name}.{ending}"
            print(f"{name}.{ending} in the browser: {100 * share:.1f} % drawn")
    if len(sys.argv) > 3:
        for shot in folder.glob("*-*.png"):
            shot.rename(pathlib.Path(sys.argv[3]) / shot.name)
