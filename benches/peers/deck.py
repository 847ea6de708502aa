"""Reads the input deck that `mckibben simulate --model fe3d --export-inp` writes, and the steps in it.

Units: mm, MPa, N. Numbers of nodes and elements in the deck start at 1, here at 0.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Step:
    """Increments of equal size that end at an end displacement (mm) and a pressure (MPa)."""

    increments: int
    end_mm: float
    pressure_mpa: float


@dataclass
class Deck:
    nodes: np.ndarray
    bricks: np.ndarray
    strands: np.ndarray
    spring_n_per_mm: np.ndarray
    tension_only: bool
    loaded: np.ndarray  # bricks whose face P6 carries the pressure
    sets: dict[str, np.ndarray]
    c10_mpa: float
    c01_mpa: float
    bulk_mpa: float
    about: dict[str, str]
    steps: list[Step] = field(default_factory=list)

    def number(self, key: str) -> float:
        """A number that the deck's head tells: inner_radius_mm, half_length_mm, angle_deg."""
        return float(self.about[key])


def _blocks(path: str):
    """(keyword, options, data lines) of each keyword; `**` lines as keyword `**`."""
    keyword, options, lines = "", {}, []
    with open(path, encoding="utf-8") as file:
        for line in file:
            line = line.strip()
            if line.startswith("**"):
                if keyword:
                    yield keyword, options, lines
                yield "**", {}, [line[2:].strip()]
                keyword, options, lines = "", {}, []
            elif line.startswith("*"):
                if keyword:
                    yield keyword, options, lines
                words = [w.strip() for w in line[1:].split(",")]
                keyword = words[0].upper()
                pairs = (w.partition("=") for w in words[1:])
                options = {k.strip().upper(): v.strip() for k, _, v in pairs}
                lines = []
            elif line:
                lines.append(line)
            elif keyword == "SPRING":
                lines.append("")
    if keyword:
        yield keyword, options, lines


def _numbers(lines, kind):
    return [[kind(w) for w in line.split(",") if w.strip()] for line in lines if line]


def read(path: str) -> Deck:
    """The deck of a file."""
    nodes, bricks, strands, sets, elsets = [], [], {}, {}, {}
    springs, tension_only, about, steps = {}, False, {}, []
    c10 = c01 = compressibility = 0.0
    ids: list[int] = []
    for keyword, options, lines in _blocks(path):
        if keyword == "**":
            key, _, value = lines[0].partition("=")
            if value:
                about[key.strip()] = value.strip()
        elif keyword == "NODE":
            nodes = [row[1:] for row in _numbers(lines, float)]
        elif keyword == "ELEMENT" and options["TYPE"] == "C3D8":
            rows = _numbers(lines, int)
            ids = [row[0] for row in rows]
            bricks = [row[1:] for row in rows]
        elif keyword == "ELEMENT":
            strands[options["ELSET"]] = [row[1:] for row in _numbers(lines, int)]
        elif keyword == "NSET":
            sets[options["NSET"]] = np.array(sum(_numbers(lines, int), []), int) - 1
        elif keyword == "ELSET":
            elsets[options["ELSET"]] = np.array(sum(_numbers(lines, int), []), int)
        elif keyword == "HYPERELASTIC":
            values = _numbers(lines, float)[0]
            if "NEO HOOKE" in options:
                c10, compressibility = values
            else:
                c10, c01, compressibility = values
        elif keyword == "SPRING":
            rows = _numbers(lines, float)
            if "NONLINEAR" in options:
                tension_only = True
                springs[options["ELSET"]] = rows[-1][0] / rows[-1][1]
            else:
                springs[options["ELSET"]] = rows[0][0]
        elif keyword == "STEP":
            steps.append(
                Step(
                    1,
                    steps[-1].end_mm if steps else 0.0,
                    steps[-1].pressure_mpa if steps else 0.0,
                )
            )
        elif keyword == "STATIC":
            size, whole = _numbers(lines, float)[0][:2]
            steps[-1].increments = round(whole / size)
        elif keyword == "BOUNDARY" and steps:
            steps[-1].end_mm = float(lines[0].split(",")[3])
        elif keyword == "DLOAD":
            steps[-1].pressure_mpa = float(lines[0].split(",")[2])
    pairs = [(pair, springs[name]) for name, rows in strands.items() for pair in rows]
    first = ids[0]
    return Deck(
        nodes=np.array(nodes),
        bricks=np.array(bricks, int) - 1,
        strands=np.array([p for p, _ in pairs], int) - 1,
        spring_n_per_mm=np.array([k for _, k in pairs]),
        tension_only=tension_only,
        loaded=elsets["EIN"] - first,
        sets=sets,
        c10_mpa=c10,
        c01_mpa=c01,
        bulk_mpa=2.0 / compressibility,
        about=about,
        steps=steps,
    )
