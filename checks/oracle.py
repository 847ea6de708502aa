#!/usr/bin/env python3
"""Holds the program against an independent calculation in 30-digit arithmetic (mpmath).

The thick-wall model is written down here again from its energy alone: no derivative is taken by hand, the radius is
found by minimising, and the pull is a numerical derivative. The paper's formula is evaluated from its CSV table.
Usage: oracle.py PROGRAM
"""

import csv
import json
import subprocess
import sys
import tempfile

from mpmath import cos, diff, findroot, mp, mpf, pi, quad, radians, sin, sqrt

mp.dps = 30
program = sys.argv[1]
failures = 0


def ask(*args):
    out = subprocess.run(
        [program, *map(str, args), "--format", "json"], capture_output=True, text=True
    )
    if out.returncode != 0:
        raise SystemExit(f"{args}: exit {out.returncode}: {out.stderr}")
    return json.loads(out.stdout)


def file_of(text):
    with tempfile.NamedTemporaryFile("w", suffix=".toml", delete=False) as out:
        out.write(text)
    return out.name


def check(name, ours, reference, tolerance):
    global failures
    error = abs(mpf(ours) - reference) / max(abs(reference), mpf("1e-6"))
    ok = error < tolerance
    failures += not ok
    print(
        f"{'ok  ' if ok else 'FAIL'} {name:<62} {mp.nstr(mpf(ours), 12):>18} {mp.nstr(reference, 12):>18} {mp.nstr(error, 2):>9}"
    )


def energy(d0, s, angle, k, p, law):
    """Pi(lambda, r) per unit length at rest, incompressible wall."""
    ro = mpf(d0) / 2
    ri = ro - mpf(s)
    c2, s2 = cos(radians(mpf(angle))) ** 2, sin(radians(mpf(angle))) ** 2

    def total(lam, r):
        def shell(R):
            hoop = sqrt((R * R - ro * ro) / lam + r * r) / R
            return law(1 / (hoop * lam), hoop, lam) * 2 * pi * R

        strain = sqrt(c2 * lam**2 + s2 * (r / ro) ** 2) - 1
        braid = 2 * pi * ro * mpf(k) * strain**2 if strain > 0 else mpf(0)
        return (
            quad(shell, [ri, ro])
            + braid
            - mpf(p) * pi * (r * r * lam - (ro * ro - ri * ri))
        )

    def pull(contraction):
        lam0 = 1 - mpf(contraction)
        guess = ro * sqrt((1 - lam0**2 * c2) / s2) * mpf("1.01")
        r = findroot(lambda x: diff(lambda y: total(lam0, y), x), guess)
        # At equilibrium dPi/dlambda at fixed r is the pull.
        return diff(lambda lam: total(lam, r), lam0), r

    return pull


def invariants(a, b, c):
    q = [a * a, b * b, c * c]
    return q[0] + q[1] + q[2], q[0] * q[1] + q[1] * q[2] + q[2] * q[0]


def mooney(a, b, c):
    i1, i2 = invariants(a, b, c)
    return mpf("0.112") * (i1 - 3)


def yeoh(a, b, c):
    x = invariants(a, b, c)[0] - 3
    return mpf("0.1789") * x - mpf("0.001219") * x**2 + mpf("3.678e-5") * x**3


def named(name, d0, s, angle):
    """The Yeoh law of a named rubber: between two ranges of data constants between theirs, for 1.05 times the stretch that the bore reaches."""
    outer, inner, rest, end = (
        mpf(d0) / 2,
        mpf(d0) / 2 - mpf(s),
        radians(mpf(angle)),
        mp.acos(1 / sqrt(mpf(3))),
    )
    widest = (outer * sin(end) / sin(rest)) ** 2 - (outer**2 - inner**2) * cos(
        rest
    ) / cos(end)
    stretch = mpf("1.05") * sqrt(widest) / inner
    with open("crates/mckibben-core/data/rubber-laws.json") as file:
        windows = json.load(file)[name]
    below, above = next(
        pair
        for pair in zip(windows, windows[1:])
        if pair[0]["fitted_to_stretch"] < stretch < pair[1]["fitted_to_stretch"]
    )
    laws = [
        next(law for law in window["laws"] if law["name"] == "yeoh")
        for window in (below, above)
    ]
    start, stop = (mpf(repr(window["fitted_to_stretch"])) for window in (below, above))
    share = (stretch - start) / (stop - start)
    constants = [
        (1 - share) * mpf(repr(laws[0][c])) + share * mpf(repr(laws[1][c]))
        for c in ("c10", "c20", "c30")
    ]
    return lambda a, b, c: sum(
        k * (invariants(a, b, c)[0] - 3) ** (i + 1) for i, k in enumerate(constants)
    )


print("thick-wall: pull [N] and bulged diameter [mm] against the bare energy")
cases = [
    (30, 3, 28, 321, "0.25", "0.10", "paper", mooney),
    (50, 1, 28, 624, "0.25", "0.15", "paper", mooney),
    (20, 2, 20, 150, "0.40", "0.20", "paper", mooney),
    (
        40,
        4,
        33,
        467,
        "0.20",
        "0.05",
        "dragon-skin-20",
        named("dragon-skin-20", 40, 4, 33),
    ),
    (
        30,
        3,
        25,
        900,
        "0.50",
        "0.18",
        'law = "yeoh"\nc10 = 0.1789\nc20 = -0.001219\nc30 = 3.678e-5',
        yeoh,
    ),
]
for d0, s, angle, k, p, e, rubber, law in cases:
    flags = [
        "-D",
        d0,
        "-s",
        s,
        "--angle",
        angle,
        "--stiffness",
        k,
        "--model",
        "thick-wall",
    ]
    if "law" in rubber:
        flags += ["--muscle", file_of(f"[tube.material]\n{rubber}\n")]
    else:
        flags += ["--rubber", rubber]
    answer = ask("force", *flags, "-p", p, "-e", e)
    force, r = energy(d0, s, angle, k, p, law)(e)
    name = f"D0 {d0} s {s} {angle} deg k {k} P {p} e {e} {law.__name__ if 'law' in rubber else rubber}"
    check(name, answer["force_n"], force, 1e-9)
    check("  bulged diameter", answer["bulged_diameter_mm"], 2 * r, 1e-9)
    back = ask("pressure", *flags, "-F", mp.nstr(force, 17), "-e", e)
    check("  pressure that gives this pull", back["pressure_mpa"], mpf(p), 1e-9)

print("paper: formula (11) from Table 2")
with open("crates/mckibben-core/data/table2.csv") as table:
    rows = {
        (r["family"], int(r["row"])): [mpf(r[c]) for c in ("d2", "d1", "d0")]
        for r in csv.DictReader(table)
    }
for d0, s, p, e in [
    (50, 1, "0.25", "0.10"),
    (30, 3, "0.15", "0.05"),
    (37.5, 2.5, "0.2", "0.2"),
    (42, 5, "0.25", "0"),
]:
    D, S, P, E = mpf(d0), mpf(s), mpf(p), mpf(e)
    x = {key: (v[0] * D + v[1]) * D + v[2] for key, v in rows.items()}
    poly = lambda f: (
        (x[f, 1] * S**2 + x[f, 2] * S + x[f, 3]) * P
        + x[f, 4] * S**2
        + x[f, 5] * S
        + x[f, 6]
    )
    reference = poly("A") * E**2 + poly("B") * E + poly("C")
    answer = ask("force", "-D", d0, "-s", s, "-p", p, "-e", e, "--model", "paper")
    check(f"D0 {d0} s {s} P {p} e {e}", answer["force_n"], reference, 1e-10)

sys.exit(1 if failures else 0)
