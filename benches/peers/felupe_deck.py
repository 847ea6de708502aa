"""Runs a deck of `mckibben simulate --export-inp` in FElupe and prints the pulls as JSON.

The brick is FElupe's nearly incompressible body (mean dilatation, one pressure an element), the strands are trusses whose force is
k (l − L) as in the deck, the pressure follows the inner faces. Newton's method is written out here so that every increment of
the deck is one increment of FElupe; the direct solver is Pardiso.

    python felupe_deck.py deck.inp
"""

import json
import math
import resource
import sys
import time

import felupe as fem
import numpy as np
import pypardiso
from scipy.sparse import csr_matrix

from deck import read


class MooneyRivlin:
    """P and ∂P/∂F of W = C10 (Ī1 − 3) + C01 (Ī2 − 3), written out: faster than automatic differentiation."""

    def __init__(self, c10, c01):
        self.c10, self.c01 = c10, c01
        self.x = [np.zeros((3, 3)), np.zeros(0)]

    @staticmethod
    def _invariants(f):
        j = fem.math.det(f)
        g = fem.math.transpose(fem.math.inv(f, j))
        c = np.einsum("kI...,kJ...->IJ...", f, f)
        i1 = np.einsum("II...->...", c)
        i2 = 0.5 * (i1**2 - np.einsum("IJ...,IJ...->...", c, c))
        return j, g, c, i1, i2, np.einsum("iK...,KJ...->iJ...", f, c)

    def gradient(self, x):
        f = x[0]
        j, g, _, i1, i2, fc = self._invariants(f)
        a, b = 2 * self.c10 * j ** (-2 / 3), 2 * self.c01 * j ** (-4 / 3)
        return [a * (f - i1 / 3 * g) + b * (i1 * f - fc - 2 * i2 / 3 * g), x[-1]]

    def hessian(self, x):
        f = x[0]
        j, g, c, i1, i2, fc = self._invariants(f)
        a, b = 2 * self.c10 * j ** (-2 / 3), 2 * self.c01 * j ** (-4 / 3)
        one, e = np.eye(3), np.einsum
        first, second, half = f - i1 / 3 * g, i1 * f - fc - 2 * i2 / 3 * g, i1 * f - fc
        unit = e("ik,JL->iJkL", one, one)[..., None, None]
        gg = e("iL...,kJ...->iJkL...", g, g)
        left = e("iM...,kM...->ik...", f, f)
        tangent = a * (
            unit
            - 2 / 3 * e("iJ...,kL...->iJkL...", g, f)
            + i1 / 3 * gg
            - 2 / 3 * e("iJ...,kL...->iJkL...", first, g)
        )
        of_fc = (
            e("ik,LJ...->iJkL...", one, c)
            + e("iL...,kJ...->iJkL...", f, f)
            + e("ik...,JL->iJkL...", left, one)
        )
        return [
            tangent
            + b
            * (
                2 * e("iJ...,kL...->iJkL...", f, f)
                + i1 * unit
                - of_fc
                - 4 / 3 * e("iJ...,kL...->iJkL...", g, half)
                + 2 * i2 / 3 * gg
                - 4 / 3 * e("iJ...,kL...->iJkL...", second, g)
            )
        ]


class Strand:
    """Stress over stretch of a strand of unit area; one that carries no compression keeps 1e-4 of its stiffness."""

    def __init__(self, stiffness, tension_only):
        self.k, self.tension_only = stiffness, tension_only

    def _share(self, strain):
        return (
            np.where(strain > 0, 1.0, 1e-4)
            if self.tension_only
            else np.ones_like(strain)
        )

    def gradient(self, x):
        strain = x[0] - 1
        return [self.k * strain * self._share(strain), x[-1]]

    def hessian(self, x):
        return [self.k * self._share(x[0] - 1)]


def main(path):
    deck = read(path)
    start = time.time()
    mesh = fem.Mesh(deck.nodes, deck.bricks, cell_type="hexahedron")
    field = fem.FieldContainer([fem.Field(fem.RegionHexahedron(mesh), dim=3)])
    rubber = fem.SolidBodyNearlyIncompressible(
        MooneyRivlin(deck.c10_mpa, deck.c01_mpa), field, bulk=deck.bulk_mpa
    )
    inner = np.zeros(len(deck.nodes), bool)
    inner[deck.sets["NIN"]] = True
    boundary = fem.RegionHexahedronBoundary(
        mesh, only_surface=True, mask=np.where(inner)[0]
    )
    pressure = fem.SolidBodyPressure(fem.FieldContainer([fem.Field(boundary, dim=3)]))
    ends = deck.nodes[deck.strands]
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    lines = fem.Mesh(deck.nodes, deck.strands, cell_type="line")
    braid = fem.TrussBody(
        Strand(1.0, deck.tension_only),
        fem.FieldContainer([fem.Field(fem.RegionTruss(lines), dim=3)]),
        area=deck.spring_n_per_mm * length,
    )
    items = [rubber, pressure, braid]
    n = 3 * len(deck.nodes)
    end = deck.sets["NEND"]
    held = np.unique(
        np.concatenate(
            [
                3 * deck.sets["SX"],
                3 * deck.sets["SY"] + 1,
                3 * deck.sets["SZ"] + 2,
                3 * end,
                3 * end + 1,
                3 * end + 2,
            ]
        )
    )
    free = np.setdiff1d(np.arange(n), held)
    solver = pypardiso.PyPardisoSolver()
    u = field[0].values

    def residual():
        r = np.zeros(n)
        for item in items:
            item.field.link(field)
            v = item.assemble.vector(field=item.field)
            v = (v.toarray() if hasattr(v, "toarray") else v).ravel()
            r += v if item.assemble.multiplier is None else v * item.assemble.multiplier
        return r

    def tangent():
        total = None
        for item in items:
            k = (
                item.assemble.matrix(field=item.field)
                if item is braid
                else item.assemble.matrix()
            )
            k = csr_matrix(
                k if item.assemble.multiplier is None else k * item.assemble.multiplier
            )
            total = k if total is None else total + k
        return total

    iterations = 0

    def increment(end_mm, pressure_mpa):
        nonlocal iterations
        pressure.update(pressure_mpa)
        pressure.results.pressure = pressure_mpa
        move = np.zeros(n)
        move[3 * end + 2] = end_mm - u[end, 2]
        for turn in range(25):
            r, k = residual(), tangent()
            load = r + k @ move if turn == 0 else r
            reduced = csr_matrix(k[free][:, free])
            reduced.sort_indices()
            step = np.zeros(n)
            step[free] = solver.solve(reduced, -load[free])
            if turn == 0:
                step += move
            u[:] += step.reshape(u.shape)
            iterations += 1
            size = np.abs(step).max()
            if not np.isfinite(size) or size > 1e3:
                raise RuntimeError("diverged")
            if size < 1e-6 * deck.number("half_length_mm"):
                return
        raise RuntimeError("no convergence")

    rows, failure = [], ""
    began = time.time()
    e0 = p0 = 0.0
    for step in deck.steps:
        for i in range(1, step.increments + 1):
            share = i / step.increments
            e, p = (
                e0 + share * (step.end_mm - e0),
                p0 + share * (step.pressure_mpa - p0),
            )
            try:
                increment(e, p)
            except RuntimeError as error:
                failure = f"{error} at {e} mm, {p} MPa"
                break
            pull = (
                4 * residual()[3 * end + 2].sum()
                - p * math.pi * deck.number("inner_radius_mm") ** 2
            )
            contraction = -e / deck.number("half_length_mm")
            rows.append(
                {"pressure_mpa": p, "contraction": contraction, "force_n": pull}
            )
        e0, p0 = step.end_mm, step.pressure_mpa
    print(
        json.dumps(
            {
                "program": f"FElupe {fem.__version__}",
                "seconds": time.time() - began,
                "setup_seconds": began - start,
                "iterations": iterations,
                "increments": len(rows),
                "memory_mib": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
                "failure": failure,
                "points": rows,
            }
        )
    )


if __name__ == "__main__":
    main(sys.argv[1])
