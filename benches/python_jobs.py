"""What a roboticist does with the Python package: each job in as few lines as it takes, with its time.

    python benches/python_jobs.py            in the root of the repository; jobs whose libraries are missing are left out

The table has the lines of a job (without those that all share) and the median time of five runs after a first one, in ms.
"""

from __future__ import annotations

import importlib
import inspect
import os
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median
from typing import Any

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
    print(found["value"], found["standard_error"])


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


def torques() -> None:
    """Torque, its slopes and the stiffness of an elbow over 25 angles and 4 pressures"""
    pressures = [[[0.1], [0.2], [0.3], [0.4]], 0.1]
    angles = np.linspace(-40, 40, 25)
    ELBOW.torque(pressures, angles, jac=True, model="universal")
    ELBOW.stiffness(pressures, angles, model="universal")


def linear() -> None:
    """Poles of an elbow as `control` has them"""
    import control

    control.ss(*ELBOW.linearise(["2 bar", "2 bar"], 0, model="universal")).poles()


def linear_drive() -> None:
    """The steps of an elbow on its valves, linearised, by `control`"""
    import control

    drive = mk.load("examples/elbow-drive.toml", mk.Drive)
    control.step_response(control.ss(*drive.linearise(model="universal")))


def labels() -> None:
    """A map of 10,000 points by the names of its dimensions, by xarray"""
    import xarray as xr

    p = xr.DataArray(np.linspace(0.05, 0.25, 100), dims="p", attrs={"units": "MPa"})
    e = xr.DataArray(np.linspace(0, 0.15, 100), dims="e")
    MUSCLE.force(p, e, model="universal").sel(e=7)


def series() -> None:
    """A log of 10,000 rows as a column beside the others, by pandas"""
    import pandas as pd

    log = pd.DataFrame({"p": PRESSURES[::100], "e": 0.1})
    log["pull"] = MUSCLE.force(log.p, log.e, model="universal")


def jax_scalar() -> None:
    """1,000 calls of a jitted pull of two numbers, by JAX"""
    import jax

    from mckibben.jax import force

    f = JITTED.setdefault("f", jax.jit(force(MUSCLE, model="universal")))
    for _ in range(1000):
        f(0.2, 0.1).block_until_ready()


def jax_constants() -> None:
    """Pulls of 100 moduli and walls with their slopes by both, by JAX"""
    import jax

    from mckibben.jax import force

    names = ["tube.material.c10", "wall_mm"]
    f = force(MUSCLE, names, model="universal")
    g = jax.vmap(jax.value_and_grad(lambda theta: f(0.2, 0.1, theta)))
    g({names[0]: np.linspace(0.09, 0.11, 100), names[1]: np.linspace(1.1, 1.3, 100)})


def bounded() -> None:
    """The point of most work within the bounds of a model, by SciPy"""
    from scipy.optimize import minimize

    def lost(at: list[float]) -> float:
        return -MUSCLE.force(at[0], at[1], model="universal", two_sided=True) * at[1]

    minimize(lost, [0.2, 0.1], bounds=MUSCLE.bounds(model="universal"))


def posterior() -> None:
    """1,600 samples of two identified constants, by emcee"""
    import emcee

    p, e, names = PRESSURES[::100_000], 0.1, ["tube.material.c10", "braid.angle"]
    measured = MUSCLE.force(p, e, model="universal")

    def likelihood(theta: np.ndarray) -> float:
        made = MUSCLE.with_parameters(dict(zip(names, theta)))
        pull = made.force(p, e, errors="nan", model="universal")
        return float(np.nan_to_num(-(((pull - measured) / 5) ** 2).sum(), nan=-1e9))

    start = [MUSCLE.parameters[n] for n in names] * (
        1 + 0.01 * np.random.default_rng(1).standard_normal((8, 2))
    )
    emcee.EnsembleSampler(8, 2, likelihood).run_mcmc(start, 200)


def predictive() -> None:
    """A move of 20 steps of the linear elbow as one quadratic programme, by CasADi"""
    import casadi
    from scipy.signal import cont2discrete

    model = ELBOW.linearise([0.2, 0.2], 0, model="universal")
    a, b, *_ = cont2discrete(tuple(model), 0.05)
    problem = casadi.Opti("conic")
    x, u = problem.variable(2, 21), problem.variable(2, 20)
    problem.minimize(casadi.sumsqr(x[0, :] - np.radians(20)) + 0.1 * casadi.sumsqr(u))
    problem.subject_to(x[:, 0] == 0)
    for k in range(20):
        problem.subject_to(x[:, k + 1] == a @ x[:, k] + b[:, :2] @ u[:, k])
    problem.subject_to(problem.bounded(-0.1, casadi.vec(u), 0.1))
    quiet = {"print_time": False, "print_iter": False, "print_header": False}
    problem.solver("qrqp", quiet)
    problem.solve()


def torch_module() -> None:
    """Pulls of 10,000 points with their slopes in a module of PyTorch"""
    import torch

    place = MUSCLE.export("python", model="universal").write(FOLDER, overwrite=True)
    sys.path.insert(0, str(FOLDER))
    muscle = importlib.import_module(place.stem)
    p = torch.linspace(0.05, 0.25, 10_000, dtype=torch.float64, requires_grad=True)
    muscle.force(p, torch.full_like(p, 0.9 * 285)).sum().backward()


def notebook() -> None:
    """The first notebook, by nbclient"""
    import nbformat
    from nbclient import NotebookClient

    book = nbformat.read("python/examples/1_first_muscle.ipynb", 4)
    NotebookClient(book, resources={"metadata": {"path": "python/examples"}}).execute()


ELBOW = mk.load("examples/elbow.toml", mk.Joint)
JITTED: dict[str, Callable[..., Any]] = {}
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
    torques,
    linear,
    linear_drive,
    labels,
    series,
    jax_scalar,
    jax_constants,
    bounded,
    posterior,
    predictive,
    torch_module,
    notebook,
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
