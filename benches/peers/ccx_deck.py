"""Runs a deck of `mckibben simulate --export-inp` in CalculiX and prints the pulls as JSON.

    python ccx_deck.py deck.inp [--bulk 30]

`--bulk` replaces the bulk modulus: CalculiX's eight-node brick locks for nearly incompressible rubber.
"""

import argparse
import json
import math
import os
import re
import resource
import shutil
import subprocess
import tempfile
import time

import numpy as np

from deck import read

GAUSS = 1 / math.sqrt(3)


def pressure_force(x, faces, p):
    """Nodal forces of a pressure on deformed faces whose normals point out of the body."""
    f, corners = np.zeros_like(x), x[faces]
    for u in (-GAUSS, GAUSS):
        for v in (-GAUSS, GAUSS):
            shape = (
                np.array(
                    [
                        (1 - u) * (1 - v),
                        (1 + u) * (1 - v),
                        (1 + u) * (1 + v),
                        (1 - u) * (1 + v),
                    ]
                )
                / 4
            )
            by_u = np.array([v - 1, 1 - v, 1 + v, -1 - v]) / 4
            by_v = np.array([u - 1, -1 - u, 1 + u, 1 - u]) / 4
            area = np.cross(
                np.einsum("a,eai->ei", by_u, corners),
                np.einsum("a,eai->ei", by_v, corners),
            )
            for k in range(4):
                np.add.at(f, faces[:, k], -p * shape[k] * area)
    return f


def increments(path):
    """Of each increment: the sum of the reactions of the end, and the displacements of the inner nodes."""
    found, keys, rows = {}, [], None
    with open(path, encoding="utf-8") as file:
        for line in file:
            if "for set" in line:
                at = round(float(line.split("time")[1].split()[0]), 9)
                if at not in found:
                    found[at] = {}
                    keys.append(at)
                rows = found[at].setdefault(
                    re.search(r"for set (\S+)", line).group(1), []
                )
            elif line.strip() and rows is not None:
                try:
                    rows.append([float(w) for w in line.split()])
                except ValueError:
                    pass
    return [(k, {name: np.array(v) for name, v in found[k].items()}) for k in keys]


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("deck")
    options.add_argument("--bulk", type=float)
    options = options.parse_args()
    deck = read(options.deck)
    if shutil.which("ccx") is None:
        raise SystemExit("ccx is not installed (Debian: calculix-ccx)")
    with tempfile.TemporaryDirectory() as folder:
        text = open(options.deck, encoding="utf-8").read()
        if options.bulk:
            pattern = r"(\*HYPERELASTIC[^\n]*\n(?:[^,\n]+,)+)([^,\n]+)\n"
            text = re.sub(
                pattern, lambda m: f"{m.group(1)}{2 / options.bulk:.10g}\n", text
            )
        with open(os.path.join(folder, "job.inp"), "w", encoding="utf-8") as file:
            file.write(text)
        env = dict(os.environ, OMP_NUM_THREADS="1", CCX_NPROC_EQUATION_SOLVER="1")
        began = time.time()
        ran = subprocess.run(
            ["ccx", "-i", "job"],
            cwd=folder,
            env=env,
            capture_output=True,
            text=True,
            timeout=3600,
        )
        seconds = time.time() - began
        memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
        iterations = len(re.findall(r"^ iteration \d+", ran.stdout, re.M))
        results = increments(os.path.join(folder, "job.dat"))
    version = re.search(r"Version (\S+)", ran.stdout)
    faces = deck.bricks[deck.loaded][:, [0, 4, 7, 3]]
    end = deck.sets["NEND"]
    radius, half = deck.number("inner_radius_mm"), deck.number("half_length_mm")
    rows = []
    for at, data in results:
        number = min(int(math.ceil(at - 1e-9)) - 1, len(deck.steps) - 1)
        share = at - number
        before = deck.steps[number - 1] if number else None
        e0, p0 = (before.end_mm, before.pressure_mpa) if before else (0.0, 0.0)
        step = deck.steps[number]
        e, p = e0 + share * (step.end_mm - e0), p0 + share * (step.pressure_mpa - p0)
        x = deck.nodes.copy()
        u = data["NIN"]
        x[u[:, 0].astype(int) - 1] += u[:, 1:4]
        reaction = data["NEND"][0][2] - pressure_force(x, faces, p)[end, 2].sum()
        pull = 4 * reaction - p * math.pi * radius**2
        rows.append({"pressure_mpa": p, "contraction": -e / half, "force_n": pull})
    wanted = sum(s.increments for s in deck.steps)
    failure = "" if len(rows) == wanted else f"{len(rows)} of {wanted} increments"
    print(
        json.dumps(
            {
                "program": f"CalculiX {version.group(1) if version else ''}".strip(),
                "bulk_mpa": options.bulk or deck.bulk_mpa,
                "seconds": seconds,
                "iterations": iterations,
                "increments": len(rows),
                "memory_mib": memory,
                "failure": failure,
                "points": rows,
            }
        )
    )


if __name__ == "__main__":
    main()
