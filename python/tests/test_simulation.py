"""A drive in a control loop is the drive that runs at once."""

from __future__ import annotations

import copy
import importlib
import shutil
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import mckibben as mk

DT = 0.002
DRIVES: dict[str, Any] = {
    "elbow": ("elbow-drive.toml", lambda c: f'pressure_1 = {c(0)}\npressure_2 = {c(1)}', 2),
    "muscle on a valve that switches": ("drive.toml", lambda c: f"pressure = {c(0)}", 1),
}


@pytest.fixture(params=list(DRIVES))
def drive(request: pytest.FixtureRequest, root: Path, tmp_path: Path) -> Any:
    """A drive file whose commands are steps of DT, and these."""
    for file in (root / "examples").glob("*.toml"):
        shutil.copy(file, tmp_path)
    name, lines, muscles = DRIVES[request.param]
    rng = np.random.default_rng(4)
    steps = np.repeat(rng.uniform(0.02, 0.3, (10, muscles)), 10, axis=0)
    if muscles == 1:
        # It is lifted, falls and lies again.
        steps[:, 0] = np.repeat([0.3, 0.3, 0.3, 0.3, 0.0, 0.0, 0.25, 0.25, 0.1, 0.3], 10)
        steps[0] = 0.0

    def command(i: int) -> str:
        return "[" + ", ".join(f'["{k * DT!r} s", "{value!r} MPa"]' for k, value in enumerate(steps[:, i].tolist())) + "]"

    text = (tmp_path / name).read_text("utf-8").split("[command]")[0]
    text += f'[command]\n{lines(command)}\nuntil = "{len(steps) * DT!r} s"\noutput_step = "{DT!r} s"\n'
    (tmp_path / "steps.toml").write_text(text, "utf-8")
    return tmp_path / "steps.toml", steps


@pytest.mark.parametrize("model", ["universal", "thick-wall"])
def test_a_simulation_is_the_motion_to_the_last_bit(drive: Any, model: str) -> None:
    file, steps = drive
    motion = mk.motion(file, model=model)
    simulation = mk.Simulation(file, DT, model=model)
    for command in steps:
        state = simulation.step(command)
    table = motion.to_table()
    assert len(simulation.to_table()) == len(table) == len(steps) + 1
    for name in table:
        assert np.array_equal(simulation.to_table()[name], table[name]), name
        assert state[name] == table[name][-1] == getattr(state, name)
    # An event twice at one time is told apart by its kind.
    assert [(e["time_s"], e["kind"]) for e in simulation.events] == [(e["time_s"], e["kind"]) for e in motion.events]
    assert list(simulation.to_pandas().columns) == list(table)


def test_with_finite_elements_too(root: Path, tmp_path: Path) -> None:
    """Ten steps; their warm starts are those of the run."""
    for file in (root / "examples").glob("*.toml"):
        shutil.copy(file, tmp_path)
    text = (tmp_path / "elbow-drive.toml").read_text("utf-8").split("[command]")[0]
    values = [0.15, 0.16, 0.18, 0.2, 0.2, 0.2, 0.19, 0.18, 0.15, 0.1]
    line = "[" + ", ".join(f'["{k * 0.01!r} s", "{v!r} MPa"]' for k, v in enumerate(values)) + "]"
    (tmp_path / "steps.toml").write_text(text + f'[command]\npressure_1 = {line}\npressure_2 = "1.5 bar"\nuntil = "{10 * 0.01!r} s"\noutput_step = "0.01 s"\n', "utf-8")
    motion, simulation = mk.motion(tmp_path / "steps.toml"), mk.Simulation(tmp_path / "steps.toml", 0.01)
    for value in values:
        simulation.step([value, "1.5 bar"])
    for name in motion.to_table():
        assert np.array_equal(simulation.to_table()[name], motion.to_table()[name]), name


def test_copies_go_their_own_way_and_a_reset_is_the_start(drive: Any) -> None:
    file, steps = drive
    simulation = mk.Simulation(file, DT, model="universal")
    first = simulation.state
    assert first.time_s == 0 and simulation.commanded == "pressure" and simulation.dt == DT
    for command in steps[:40]:
        simulation.step(command)
    other = simulation.copy()
    assert other.state == simulation.state and copy.deepcopy(simulation).state == simulation.state
    for command in steps[40:]:
        assert simulation.step(command) == other.step(command)
    other.step(steps[0])
    assert other.state.time_s > simulation.state.time_s and simulation.to_table() != other.to_table()
    assert simulation.reset() == first and simulation.events == [] and len(simulation.to_table()) == 1
    for command in steps[:40]:
        simulation.step(command)
    assert simulation.state.to_dict() == {name: other.to_table()[name][40] for name in other.to_table()}


def test_forces_from_outside(root: Path) -> None:
    """A torque as large as that of the muscles at the angle they are held at by it: the joint's own answer. A weight from outside is a load."""
    elbow = mk.Simulation(root / "examples/elbow-drive.toml", 0.05, model="universal")
    torque = mk.joint(root / "examples/elbow.toml", pressures_mpa=[[0.2, 0.1]], angles_deg=[10], model="universal").points[0].torque_nm
    for _ in range(200):
        state = elbow.step([0.2, 0.1], torque_nm=-torque)
    assert state.angle_deg == pytest.approx(10, abs=1e-3) and abs(state.velocity_deg_per_s) < 1e-3
    muscle = mk.Simulation(root / "examples/drive.toml", 0.05, model="universal")
    for _ in range(200):
        end = muscle.step("3 bar", force_n=50.0)
    assert end.force_n == pytest.approx(10 * 9.80665 + 50, rel=1e-4)
    assert mk.Muscle(root / "examples/prototype.toml").force(0.3, end.contraction, model="universal") == pytest.approx(end.force_n, rel=1e-3)


def test_what_is_wrong_leaves_it_where_it_was(root: Path) -> None:
    elbow = mk.Simulation(root / "examples/elbow-drive.toml", 0.01, model="universal")
    elbow.step([0.2, 0.1])
    state, rows = elbow.state, elbow.to_table()
    wrong: list[Any] = [([0.2], {}), ([0.2, 9.0], {}), ([0.2, float("nan")], {}), ([0.2, -0.1], {}), ([0.2, "3 mm"], {}), ([0.2, 0.1], {"force_n": 3.0}), ([0.2, 0.1], {"torque_nm": 1e12}), ([0.2, 0.1], {"torque_nm": float("nan")})]
    for command, outside in wrong:
        with pytest.raises((mk.MckibbenError, TypeError)):
            elbow.step(command, **outside)
        assert elbow.state == state and elbow.to_table() == rows
    with pytest.raises(AttributeError, match="angle_deg"):
        state.angle
    with pytest.raises(mk.MckibbenError):
        mk.Simulation(root / "examples/elbow-drive.toml", 0.0)
    assert elbow.step([0.2, 0.1]).time_s == 0.02


def test_simulations_run_in_threads(root: Path) -> None:
    """Each is what it is alone."""
    first = mk.Simulation(root / "examples/elbow-drive.toml", 0.005, model="universal")

    def run(pressure: float) -> list[float]:
        own = first.copy()
        return [own.step([pressure, 0.1]).angle_deg for _ in range(20)]

    pressures = [0.1 + 0.002 * i for i in range(40)]
    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(run, pressures)) == [run(p) for p in pressures]


def test_a_step_is_quick(root: Path) -> None:
    """By the formula a step takes less than a millisecond of the processor on any machine; measured: see docs/python.md."""
    import time

    elbow = mk.Simulation(root / "examples/elbow-drive.toml", 0.001, model="universal")
    elbow.step([0.2, 0.1])
    begun = time.process_time()
    for i in range(500):
        elbow.step([0.2, 0.1])
    assert (time.process_time() - begun) / 500 < 1e-3


def test_the_environment_of_gymnasium(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("gymnasium")
    from gymnasium.utils.env_checker import check_env

    monkeypatch.syspath_prepend(str(root / "python" / "examples"))
    made: Any = importlib.import_module("elbow_gymnasium")
    environment = made.Elbow()
    check_env(environment, skip_render_check=True)
    # A controller of two lines brings it within two degrees of where it should be.
    observed, _ = environment.reset(seed=1)
    for _ in range(200):
        observed, reward, ended, cut, info = environment.step(made.proportional(observed))
    assert abs(info["angle_deg"] - info["target_deg"]) < 2


def test_the_elbow_in_mujoco_rests_where_the_joint_does(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("mujoco")
    monkeypatch.syspath_prepend(str(root / "python" / "examples"))
    made: Any = importlib.import_module("elbow_mujoco")
    motion = mk.motion(root / "examples/elbow-drive.toml", model="universal")
    assert made.main((0.2, 0.1)) == pytest.approx(motion.equilibrium_angle_deg, abs=1e-3)
