"""The Python package beside Rust: the same questions, seconds of the best of several rounds, and their ratio.

    cargo build --release -p mckibben-app --example array_speed
    RAYON_NUM_THREADS=1 python benches/python.py target/release/examples/array_speed

With one thread, as the Rust side has one; without the variable Python's arrays are worked on by all cores.
"""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable

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
    muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=2)
    out = {}
    for name, n, rounds in [("paper", 10_000, 300), ("paper", 1_000_000, 40), ("universal", 100_000, 5)]:
        model, (p, e) = muscle.model(name), points(n)
        out[f"{name} {n}"] = best(rounds, lambda: model.force(p, e))
    fe, pressures = muscle.model(), np.arange(26) / 100
    out["fe forces 26"] = best(60, lambda: fe.force(pressures, 0.1))
    out["fe curve 26"] = best(60, lambda: muscle.curve("isometric", pressures_mpa=pressures, contractions=[0.1]))
    return out


def main() -> None:
    ours = python()
    text = subprocess.run([sys.argv[1]], capture_output=True, text=True, check=True).stdout
    rust = {name: float(seconds) for name, seconds in (line.split(": ") for line in text.splitlines())}
    print(f"{'case':<20} {'Rust [ms]':>10} {'Python [ms]':>12} {'ratio':>6}")
    for name, seconds in ours.items():
        print(f"{name:<20} {rust[name] * 1e3:>10.4f} {seconds * 1e3:>12.4f} {seconds / rust[name]:>6.2f}")


if __name__ == "__main__":
    main()
