"""The Python package beside Rust: the same questions in turn, medians over several runs of the best of each, and their ratio.

    cargo build --release --manifest-path studies/Cargo.toml --target-dir target/studies --bin array_speed
    RAYON_NUM_THREADS=1 python benches/python.py target/studies/release/array_speed

`unchecked` is Rust's formula alone; else Rust checks range and slack as Python does. With one thread, as the Rust side has one; without the
variable Python's arrays are worked on by all cores. A number behind the path says how many runs.
"""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable
from statistics import median

import numpy as np

import mckibben as mk


def best(rounds: int, work: Callable[[], object]) -> float:
    """The quickest of so many, in seconds."""
    quickest = float("inf")
    for _ in range(rounds):
        begun = time.perf_counter()
        work()
        quickest = min(quickest, time.perf_counter() - begun)
    return quickest


def points(n: int) -> tuple[np.ndarray, np.ndarray]:
    """The same as those of Rust."""
    i = np.arange(n)
    return 0.01 + 0.24 * (i * 0.618033988749895 % 1), 0.15 * (i * 0.414213562373095 % 1)


def python() -> dict[str, float]:
    """Seconds by case."""
    muscle = mk.Muscle.prototype(outer_diameter_mm=50, wall_mm=2)
    out = {}
    for name, n, rounds in [("paper", 10_000, 300), ("paper", 1_000_000, 40), ("universal", 100_000, 5)]:
        model, (p, e) = muscle.model(name), points(n)
        out[f"{name} {n}"] = best(rounds, lambda: model.force(p, e))
    fe, pressures = muscle.model(), np.arange(26) / 100
    out["fe forces 26"] = best(60, lambda: fe.force(pressures, 0.1))
    out["fe curve 26"] = best(60, lambda: muscle.curve("isometric", pressures_mpa=pressures, contractions=[0.1]))
    return out


def main() -> None:
    rounds = []
    for _ in range(int(sys.argv[2]) if len(sys.argv) > 2 else 5):
        text = subprocess.run([sys.argv[1]], capture_output=True, text=True, check=True).stdout
        rust = {name: float(seconds) for name, seconds in (line.split(": ") for line in text.splitlines())}
        rounds.append((rust, python()))
    print(f"{'case':<28} {'Rust [ms]':>10} {'Python [ms]':>12} {'ratio':>6}")
    for name in rounds[0][0]:
        pairs = [(rust[name], ours[name.removesuffix(" unchecked")]) for rust, ours in rounds]
        middle = [median(values) for values in (*zip(*pairs), [b / a for a, b in pairs])]
        print(f"{name:<28} {middle[0] * 1e3:>10.4f} {middle[1] * 1e3:>12.4f} {middle[2]:>6.2f}")


if __name__ == "__main__":
    main()
