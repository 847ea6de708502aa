"""The same one-eighth muscle in mckibben, FElupe and CalculiX: pulls and times side by side.

    python compare.py [--quick] [--csv data/peers]

Run from the root of the repository. Needs cargo, ccx (Debian: calculix-ccx) and, from PyPI, felupe, pypardiso, numpy and scipy.
mckibben exports the mesh, the material and the steps as an input deck; the other two run that very deck. Every program has one
thread; they run one after the other, repeated in turn, and medians are shown. `--csv` writes the pulls that the docs draw.
"""

import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ONE = dict(os.environ, OMP_NUM_THREADS="1", MKL_NUM_THREADS="1", RAYON_NUM_THREADS="1")
# Pulls in N of FElupe 11.3 on the mesh 2 x 12 x 39, as first found: (contraction, pressure in MPa, pull).
KNOWN = [(0.0, 0.25, 843.49), (0.1, 0.10, 99.37), (0.1, 0.25, 438.93)]


def run(words):
    done = subprocess.run(words, env=ONE, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(words)} failed:\n{done.stdout}{done.stderr}")
    return json.loads(done.stdout.splitlines()[-1])


def ours(binary, contraction, mesh, deck):
    return run(
        [binary, os.path.join("examples", "peers.toml"), str(contraction), mesh, deck]
    )


def at(result, contraction, pressure):
    for p in result["points"]:
        if (
            abs(p["pressure_mpa"] - pressure) < 1e-9
            and abs(p["contraction"] - contraction) < 1e-9
        ):
            return p["force_n"]
    return float("nan")


def main():
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument(
        "--quick",
        action="store_true",
        help="contraction 0 only, once; for continuous integration",
    )
    options.add_argument("--repeat", type=int, default=3)
    options.add_argument("--csv", metavar="DIR")
    options = options.parse_args()
    build = [
        "cargo",
        "build",
        "--release",
        "--locked",
        "-q",
        "--manifest-path",
        "studies/Cargo.toml",
    ]
    subprocess.run(
        [*build, "--target-dir", "target/studies", "--bin", "peers"], check=True
    )
    binary = "target/studies/release/peers"
    felupe = [sys.executable, os.path.join(HERE, "felupe_deck.py")]
    ccx = [sys.executable, os.path.join(HERE, "ccx_deck.py")]
    worst = near = 0.0
    pulls = []
    with tempfile.TemporaryDirectory() as folder:
        for contraction in [0.0] if options.quick else [0.0, 0.1]:
            deck = os.path.join(folder, f"muscle_{contraction}.inp")
            first = ours(binary, contraction, "2x12", deck)
            programs = {
                "mckibben fe3d": lambda: ours(binary, contraction, "2x12", deck),
                "FElupe": lambda: run([*felupe, deck]),
            }
            programs["CalculiX, K 30"] = lambda: run([*ccx, deck, "--bulk", "30"])
            if not options.quick:
                programs["CalculiX, K 300"] = lambda: run([*ccx, deck])
            results = {name: [] for name in programs}
            for _ in range(1 if options.quick else options.repeat):
                for name, program in programs.items():
                    results[name].append(program())
            increments = first["increments"]
            print(
                f"\ncontraction {contraction}: {increments} increments, 2 x 12 x 39 bricks, {first['unknowns']} unknowns\n"
            )
            print(
                f"{'':<18}{'time':>9}{'ratio':>8}{'iterations':>12}{'memory':>10}{'F(.10)':>10}{'F(.25)':>10}"
            )
            base = statistics.median(r["seconds"] for r in results["mckibben fe3d"])
            for name, runs in results.items():
                seconds = statistics.median(r["seconds"] for r in runs)
                last = runs[-1]
                memory = (
                    f"{last['memory_mib']:.0f} MiB" if "memory_mib" in last else "-"
                )
                print(
                    f"{name:<18}{seconds:>7.2f} s{seconds / base:>8.1f}{last['iterations']:>12}{memory:>10}"
                    f"{at(last, contraction, 0.10):>10.2f}{at(last, contraction, 0.25):>10.2f}  {last['failure']}"
                )
                rows = [
                    p
                    for p in last["points"]
                    if abs(p["contraction"] - contraction) < 1e-9
                ]
                pulls += [
                    (name, p["pressure_mpa"], contraction, p["force_n"]) for p in rows
                ]
            for p in (0.10, 0.25):
                apart = at(first, contraction, p) - at(
                    results["CalculiX, K 30"][0], contraction, p
                )
                near = max(near, abs(apart) / KNOWN[0][2])
            for e, p, known in KNOWN:
                if e == contraction:
                    here, there = at(first, e, p), at(results["FElupe"][0], e, p)
                    worst = max(
                        worst, abs(here - there) / abs(there), abs(here - known) / known
                    )
        if not options.quick:
            quadratic = ours(
                binary, 0.1, "1x8:quadratic", os.path.join(folder, "none.inp")
            )
            print(
                f"\n1 x 8 x 26 quadratic bricks: F(.10, .25) = {at(quadratic, 0.1, 0.25):.2f} N (limit of refined meshes 440.6 +- 0.5)"
            )
            for mesh, known in [("2x24x78", 440.18), ("3x36x117", 440.43)]:
                fine = ours(binary, 0.1, mesh, os.path.join(folder, "fine.inp"))
                pull = at(fine, 0.1, 0.25)
                worst = max(worst, abs(pull - known) / known)
                print(
                    f"{mesh}: F(.10, .25) = {pull:.2f} N (FElupe 11.3: {known} N), {fine['seconds']:.1f} s"
                )
    print(f"\nlargest difference from FElupe on the same mesh: {100 * worst:.4f} %")
    print(
        f"largest memory of a program that ran here: {resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024:.0f} MiB"
    )
    if options.csv:
        os.makedirs(options.csv, exist_ok=True)
        for name in dict.fromkeys(row[0] for row in pulls):
            file = os.path.join(
                options.csv, name.lower().replace(", ", "_").replace(" ", "_") + ".csv"
            )
            with open(file, "w", encoding="utf-8") as out:
                out.write("pressure_mpa,contraction,force_n\n")
                out.writelines(
                    f"{p:.2f},{e:.2f},{f:.4f}\n" for n, p, e, f in pulls if n == name
                )
    if near > 0.015:
        raise SystemExit(
            "mckibben and CalculiX with K 30 differ by more than 1.5 % of the blocked force"
        )
    if worst > 1e-4:
        raise SystemExit("mckibben and FElupe differ by more than 0.01 %")


if __name__ == "__main__":
    main()
