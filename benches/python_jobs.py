"""What a roboticist does with the Python package: each job in as few lines as it takes, with its time.

    python benches/python_jobs.py            in the root of the repository; jobs whose libraries are missing are left out

The table has the lines of a job (without those that all share) and the median time of five runs after a first one, in ms.
"""

from __future__ import annotations

import inspect
import os
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median

import numpy as np

import mckibben as mk
from mckibben.answers import Fit

os.environ.setdefault("MPLBACKEND", "Agg")
MUSCLE = mk.Muscle(outer_diameter_mm=50, wall_mm=1, length_mm=285)
PRESSURES = np.linspace(0.05, 0.25, 1_000_000)
FOLDER = Path(tempfile.mkdtemp())


def number() -> None:
    """A pull of two numbers, by `fe`"""
    MUSCLE.force("2.5 bar", "10%")


def uncertain() -> None:
    """A pull with its ±, by `fe`"""
    print(MUSCLE.solve("2.5 bar", "10%").uncertainty_n)


def inverse() -> None:
    """The pressure for 700 N, by `fe`"""
    MUSCLE.pressure(700, 0.1)


def broadcast() -> None:
    """10⁶ pressures at one contraction, by `paper`"""
    MUSCLE.force(PRESSURES, 0.1, model="paper")


def universal() -> None:
    """10⁵ points by `universal`"""
    MUSCLE.force(PRESSURES[::10], 0.1, model="universal")


def slopes() -> None:
    """Pulls at 100 points with slopes by modulus and wall, by `universal`"""
    MUSCLE.force(
        PRESSURES[::10000], 0.1, jac=["tube.material.c10", "wall_mm"], model="universal"
    )


def isobars() -> None:
    """Isobars, drawn"""
    MUSCLE.curve(pressures_mpa=[0.1, 0.2, 0.3], model="universal").plot(
        units="bar"
    ).figure.savefig(FOLDER / "isobars.png")


def table() -> None:
    """A map of 50 points with all results, by `fe`, as a data frame"""
    MUSCLE.solve(
        np.linspace(0.05, 0.25, 10)[:, None], np.linspace(0, 0.15, 5)
    ).to_pandas()


def load() -> None:
    """The contraction under a load of 20 kg at five pressures"""
    MUSCLE.curve(load="mass:20kg", pressures_mpa="0.5..2.5:0.5 bar", model="universal")


def design() -> None:
    """A muscle for a specification"""
    print(
        mk.design(
            force_n=700,
            contraction="15%",
            max_pressure_mpa="2.5 bar",
            model="universal",
        ).best
    )


def identify() -> None:
    """Constants of a measured muscle with error bars"""
    found = mk.identify("examples/bench.toml", "examples/bench.csv", model="universal")
    print(found.x, found.stderr)


def compare() -> None:
    """Three models beside measurements"""
    mk.load("examples/tondu2012.toml").compare(
        models=["ideal", "universal", "thick-wall"],
        data="data/tondu2012/static_force_20deg.csv",
    )


def rubber() -> None:
    """A rubber from tension data, used in a muscle"""
    MUSCLE.replace(rubber=mk.fit_rubber("data/treloar/tension.csv").rubber()).force(
        0.2, 0.1
    )


def formula() -> None:
    """1,271 muscles by a fitted formula"""
    fitted = FORMULA.formula if FORMULA else mk.fit("data/campaign/paper.csv").formula
    fitted(
        pressure_mpa=0.2,
        contraction=0.1,
        outer_diameter_mm=np.linspace(30, 50, 41)[:, None],
        wall_mm=np.linspace(1, 5, 31),
    )


def fit() -> None:
    """A formula of a table of finite-element tests"""
    mk.fit("data/campaign/paper.csv")


def elbow() -> None:
    """The torque of an elbow at 25 angles"""
    mk.load("examples/elbow.toml").solve(
        pressures_mpa=[["3 bar", "1 bar"]],
        angles_deg=np.linspace(-60, 60, 25),
        model="universal",
    )


def motion() -> None:
    """Two seconds of an elbow on its valves"""
    mk.load("examples/elbow-drive.toml").motion(model="universal")


def loop() -> None:
    """A second of an elbow in a control loop of 1 kHz"""
    simulation, angle = (
        mk.Simulation(
            "examples/elbow-drive.toml", 1e-3, record=False, model="universal"
        ),
        0.0,
    )
    for _ in range(1000):
        angle = simulation.step(
            [0.15 + 0.004 * (20 - angle), 0.15 - 0.004 * (20 - angle)]
        ).angle_deg


def rollout() -> None:
    """100 rollouts of a second of an elbow in steps of 50 ms"""
    mk.rollout(
        mk.Simulation("examples/elbow-drive.toml", 0.05, model="universal"),
        np.random.default_rng(1).uniform(0.1, 0.2, (100, 20, 2)),
    )


def jax_batch() -> None:
    """Value and slopes of 1,000 points by JAX, traced each time"""
    import jax

    from mckibben.jax import force

    jax.vmap(jax.value_and_grad(force(MUSCLE, model="universal")))(
        np.linspace(0.1, 0.3, 1000), np.full(1000, 0.1)
    )


def optimise() -> None:
    """The wall for 1000 N at 2 bar and 10 %, by SciPy"""
    from scipy.optimize import brentq

    brentq(
        lambda wall: (
            MUSCLE.replace(wall_mm=wall).force(0.2, 0.1, model="universal") - 1000
        ),
        1.1,
        5,
    )


def export() -> None:
    """C code of a muscle for a controller"""
    MUSCLE.export("c", model="universal").write(FOLDER / "c", overwrite=True)


def build() -> None:
    """Drawing, plugs and steps to build a muscle"""
    MUSCLE.build("2 bar").write(FOLDER / "build", overwrite=True)


def saved() -> None:
    """A muscle saved, and read again"""
    MUSCLE.save(FOLDER / "muscle.toml")
    mk.load(FOLDER / "muscle.toml")


FORMULA: Fit | None = None
JOBS: list[Callable[[], None]] = [
    number,
    uncertain,
    inverse,
    broadcast,
    universal,
    slopes,
    isobars,
    table,
    load,
    design,
    identify,
    compare,
    rubber,
    formula,
    fit,
    elbow,
    motion,
    loop,
    rollout,
    jax_batch,
    optimise,
    export,
    build,
    saved,
]


def lines(job: Callable[[], None]) -> int:
    body = [line for line in inspect.getsource(job).splitlines()[2:] if line.strip()]
    return len(body)


def main() -> None:
    global FORMULA
    FORMULA = mk.fit("data/campaign/paper.csv")
    shown = sys.stdout
    print("| job | lines | ms |\n|---|---|---|")
    for job in JOBS:
        times = []
        try:
            with open(os.devnull, "w") as sys.stdout:
                for _ in range(6):
                    begun = time.perf_counter()
                    job()
                    times.append(1e3 * (time.perf_counter() - begun))
        except ImportError as error:
            times = []
            print(f"{error}", file=sys.stderr)
        finally:
            sys.stdout = shown
        spent = f"{median(times[1:]):.3g}" if times else "(not installed)"
        print(f"| {job.__doc__} | {lines(job)} | {spent} |", flush=True)


if __name__ == "__main__":
    main()
