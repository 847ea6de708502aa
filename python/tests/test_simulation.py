"""Joints, drives and simulations: each is its file, and a simulation is the motion that runs at once."""

from __future__ import annotations

import copy
import importlib
import pickle
import shutil
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import mckibben as mk

DT = 0.002
DRIVES: dict[str, Any] = {
    "elbow": (
        "elbow-drive.toml",
        lambda c: f"pressure_1 = {c(0)}\npressure_2 = {c(1)}",
        2,
    ),
    "muscle on a valve that switches": (
        "drive.toml",
        lambda c: f"pressure = {c(0)}",
        1,
    ),
}
ELBOW = "examples/elbow-drive.toml"


@pytest.fixture(params=list(DRIVES))
def drive(request: pytest.FixtureRequest, root: Path, tmp_path: Path) -> Any:
    """A drive file whose commands are steps of DT, and these."""
    for file in (root / "examples").glob("*.toml"):
        shutil.copy(file, tmp_path)
    name, lines, muscles = DRIVES[request.param]
    steps = np.repeat(
        np.random.default_rng(4).uniform(0.02, 0.3, (10, muscles)), 10, axis=0
    )
    if muscles == 1:
        # It is lifted, falls and lies again.
        steps[:, 0] = np.repeat(
            [0.3, 0.3, 0.3, 0.3, 0.0, 0.0, 0.25, 0.25, 0.1, 0.3], 10
        )
        steps[0] = 0.0

    def command(i: int) -> str:
        return (
            "["
            + ", ".join(
                f'["{k * DT!r} s", "{value!r} MPa"]'
                for k, value in enumerate(steps[:, i].tolist())
            )
            + "]"
        )

    text = (tmp_path / name).read_text("utf-8").split("[command]")[0]
    (tmp_path / "steps.toml").write_text(
        text
        + f'[command]\n{lines(command)}\nuntil = "{len(steps) * DT!r} s"\noutput_step = "{DT!r} s"\n',
        "utf-8",
    )
    return mk.load(tmp_path / "steps.toml"), steps


@pytest.mark.parametrize("model", ["universal", "thick-wall"])
def test_a_simulation_is_the_motion_to_the_last_bit(drive: Any, model: str) -> None:
    file, steps = drive
    motion, simulation, light = (
        file.motion(model=model),
        mk.Simulation(file, DT, model=model),
        mk.Simulation(file, DT, model=model, record=False),
    )
    for command in steps:
        state = simulation.step(command)
        assert light.step(command) == state
    columns = motion.to_columns()
    assert (
        list(simulation.to_pandas().columns) == list(columns)
        and len(light.to_columns()["time_s"]) == 1
    )
    for name in columns:
        assert (
            np.array_equal(simulation.to_columns()[name], columns[name])
            and getattr(state, name) == columns[name][-1]
        ), name
    # An event twice at one time is told apart by its kind.
    assert [(e["time_s"], e["kind"]) for e in simulation.events] == [
        (e["time_s"], e["kind"]) for e in motion.events
    ]


def test_with_finite_elements_too(root: Path, tmp_path: Path) -> None:
    """Ten steps; their warm starts are those of the run."""
    for file in (root / "examples").glob("*.toml"):
        shutil.copy(file, tmp_path)
    text = (tmp_path / "elbow-drive.toml").read_text("utf-8").split("[command]")[0]
    values = [0.15, 0.16, 0.18, 0.2, 0.2, 0.2, 0.19, 0.18, 0.15, 0.1]
    line = (
        "["
        + ", ".join(f'["{k * 0.01!r} s", "{v!r} MPa"]' for k, v in enumerate(values))
        + "]"
    )
    (tmp_path / "steps.toml").write_text(
        text
        + f'[command]\npressure_1 = {line}\npressure_2 = "1.5 bar"\nuntil = "{10 * 0.01!r} s"\noutput_step = "0.01 s"\n',
        "utf-8",
    )
    motion, simulation = (
        mk.load(tmp_path / "steps.toml").motion(),
        mk.Simulation(tmp_path / "steps.toml", 0.01),
    )
    for value in values:
        simulation.step([value, "1.5 bar"])
    for name, column in motion.to_columns().items():
        assert np.array_equal(simulation.to_columns()[name], column), name


def test_a_copy_goes_its_own_way_from_where_it_is(drive: Any) -> None:
    file, steps = drive
    simulation = mk.Simulation(file, DT, model="universal")
    first = simulation.state
    for command in steps[:40]:
        simulation.step(command)
    other = simulation.copy()
    assert (
        other.state == simulation.state == copy.deepcopy(simulation).state
        and len(other.to_columns()["time_s"]) == 1
    )
    for command in steps[40:]:
        assert simulation.step(command) == other.step(command)
    assert (
        simulation.reset() == first
        and simulation.events == []
        and len(simulation.to_columns()["time_s"]) == 1
    )


def test_a_state_is_an_array_that_is_set_and_pickled(drive: Any) -> None:
    """It goes on from there to the last bit."""
    file, steps = drive
    simulation = mk.Simulation(file, DT, model="universal")
    for command in steps[:40]:
        simulation.step(command)
    kept, state = simulation.get_state(), simulation.state
    other = mk.Simulation(file, DT, model="universal")
    assert (
        isinstance(kept, np.ndarray)
        and other.set_state(kept) == state
        and np.array_equal(other.get_state(), kept)
    )
    restored = pickle.loads(pickle.dumps(simulation))
    assert restored.state == other.state and restored.dt_s == DT
    for command in steps[40:]:
        end, same, third = (
            simulation.step(command),
            other.step(command),
            restored.step(command),
        )
        assert end == same == third
    bads: list[Any] = [kept[:-1], np.append(kept, 1.0), kept * np.nan, []]
    for wrong in bads:
        with pytest.raises(mk.MckibbenError):
            other.set_state(wrong)


def test_a_copy_takes_as_long_after_many_steps(root: Path) -> None:
    """In time of the processor, best of five of each, the new one and the old one in turn; and so does a step: the last ones and the first ones."""
    young, old = (
        mk.Simulation(root / ELBOW, 0.001, model="universal") for _ in range(2)
    )

    def seconds(work: Callable[[], object], count: int) -> float:
        begun = time.process_time()
        for _ in range(count):
            work()
        return time.process_time() - begun

    steps = [seconds(lambda: old.step([0.2, 0.1]), 300) for _ in range(20)]
    copies = [(seconds(young.copy, 200), seconds(old.copy, 200)) for _ in range(5)]
    assert len(old.to_columns()["time_s"]) == 6001
    assert min(late for _, late in copies) < 3 * min(
        early for early, _ in copies
    ) and min(steps[10:]) < 3 * min(steps[:10])


def test_a_rollout_is_its_copies(drive: Any) -> None:
    """To the last bit of steps one by one, in the order of the commands; the simulation stays where it was."""
    file, steps = drive
    simulation = mk.Simulation(file, DT, model="universal")
    simulation.step(steps[0])
    state = simulation.state
    commands = np.stack([steps[1:30], steps[30:59], 0.5 * steps[1:30]])
    ends = mk.rollout(simulation, commands)
    assert (
        simulation.state == state
        and set(ends) == set(state.to_dict())
        and ends["time_s"].shape == (3, 30)
    )
    for i, own in enumerate(commands):
        other = simulation.copy()
        for k, command in enumerate(own):
            end = other.step(command)
            assert all(
                ends[name][i, k + 1] == value for name, value in end.to_dict().items()
            )
    wrong = commands.copy()
    wrong[1, 5] = 9.0
    with pytest.raises(mk.MckibbenError) as caught:
        mk.rollout(simulation, wrong)
    assert caught.value.index == 29 + 5
    ends = mk.rollout(simulation, wrong, errors="nan")
    assert (
        np.isnan(ends["time_s"][1, 6:]).all()
        and np.isfinite(ends["time_s"][[0, 2]]).all()
        and np.isfinite(ends["time_s"][1, :6]).all()
    )
    with pytest.raises(ValueError):
        mk.rollout(simulation, commands[..., :0])
    # Without a step each copy is at its start.
    assert mk.rollout(simulation, commands[:, :0])["time_s"].tolist() == [
        [state.time_s]
    ] * len(commands)


def test_forces_from_outside(root: Path) -> None:
    """A torque as large as that of the muscles at the angle they are held at by it: the joint's own answer. A weight from outside is a load."""
    elbow = mk.Simulation(root / ELBOW, 0.05, model="universal")
    torque = (
        mk.load(root / "examples/elbow.toml")
        .solve(pressures_mpa=[[0.2, 0.1]], angles_deg=[10], model="universal")
        .points[0]
        .torque_nm
    )
    for _ in range(200):
        state = elbow.step([0.2, 0.1], torque_nm=-torque)
    assert (
        state.angle_deg == pytest.approx(10, abs=1e-3)
        and abs(state.velocity_deg_per_s) < 1e-3
    )
    muscle = mk.Simulation(root / "examples/drive.toml", 0.05, model="universal")
    for _ in range(200):
        end = muscle.step("3 bar", force_n=50.0)
    assert end.force_n == pytest.approx(10 * 9.80665 + 50, rel=1e-4)


def test_what_acts_on_a_drive_acts_on_its_simulation(root: Path) -> None:
    """It rests where it begins, as in the motion; a torque of a step is added to it."""
    elbow = mk.load(root / "examples/elbow.toml", mk.Joint)
    command = {"pressure_1_mpa": 0.2, "pressure_2_mpa": 0.1, "until_s": 1}

    def drive(torque_nm: Any) -> mk.Drive:
        return mk.Drive(
            elbow,
            command=command,
            regulator={"time_constant_s": 0.05},
            external={"torque_nm": torque_nm},
        )

    both = [
        mk.Simulation(drive(given), 0.05, model="universal") for given in (1.0, 0.0)
    ]
    start = both[0].state.angle_deg
    for _ in range(20):
        held = both[0].step([0.2, 0.1]).angle_deg
    assert held == pytest.approx(start, abs=1e-6)
    for _ in range(60):
        against = both[1].step([0.2, 0.1], torque_nm=1.0).angle_deg
    assert against == pytest.approx(start, abs=1e-3)
    for _ in range(60):
        less = both[0].step([0.2, 0.1], torque_nm=-1.0).angle_deg
    without = mk.Simulation(drive(0.0), 0.05, model="universal").state.angle_deg
    assert less == pytest.approx(without, abs=1e-3)
    # What begins after three steps, as the joint of a drive file has it.
    late = mk.Simulation(drive([[0, 0.0], [0.15, 1.0]]), 0.05, model="universal")
    ends = [late.step([0.2, 0.1]).angle_deg - without for _ in range(60)]
    assert abs(ends[2]) < 1e-6 < ends[3] < ends[-1]
    assert ends[-1] == pytest.approx(start - without, abs=1e-3)


def test_a_step_takes_numbers_of_any_kind(root: Path) -> None:
    pint = pytest.importorskip("pint")
    elbow = mk.Simulation(root / ELBOW, 0.01, model="universal")
    ones: list[Any] = [
        [0.2, 0.1],
        np.array([0.2, 0.1]),
        np.array([0.2, 0.1], dtype=np.float64)[::1],
        ["2 bar", "1 bar"],
        [np.float64(0.2), np.array(0.1)],
        [0.2 * pint.UnitRegistry().MPa, 0.1],
        (0.2, 0.1),
    ]
    assert len({elbow.copy().step(command) for command in ones}) == 1
    single: list[Any] = [np.float32(0.25), 0.25, np.array(0.25), "2.5 bar"]
    assert len({elbow.copy().step(command) for command in single}) == 1
    with pytest.warns(mk.UnitWarning), pytest.raises(mk.MckibbenError):
        elbow.step([2.0, 1.0])


def test_the_position_of_a_joint_is_an_angle(root: Path, tmp_path: Path) -> None:
    valve = (root / ELBOW).read_text().partition("[command]")[0]
    joint = root / "examples/elbow.toml"
    (tmp_path / "held.toml").write_text(
        valve.replace("elbow.toml", joint.as_posix())
        + '[controller]\nproportional = "5 bar/rad"\nbias = "2 bar"\n'
        + '[command]\nposition = "0 deg"\nuntil = "1 s"\n'
    )
    elbow = mk.Simulation(tmp_path / "held.toml", 0.01, model="universal")
    number, text = elbow.copy().step(5.0), elbow.copy().step("5 deg")
    assert number == text
    assert elbow.step("0.01 rad").angle_deg < number.angle_deg


def test_what_is_wrong_leaves_it_where_it_was(root: Path) -> None:
    elbow = mk.Simulation(root / ELBOW, 0.01, model="universal")
    elbow.step([0.2, 0.1])
    state, rows = elbow.state, len(elbow.to_columns()["time_s"])
    wrong: list[Any] = [
        ([0.2], {}),
        ([0.2, float("nan")], {}),
        ([0.2, -0.1], {}),
        ([0.2, "3 mm"], {}),
        ([0.2, "1"], {}),
        ([0.2, 0.1], {"force_n": 3.0}),
        ([0.2, 0.1], {"torque_nm": 1e12}),
    ]
    for command, outside in wrong:
        with pytest.raises((mk.MckibbenError, TypeError)):
            elbow.step(command, **outside)
        assert elbow.state == state and len(elbow.to_columns()["time_s"]) == rows
    with pytest.raises(AttributeError):
        state.angle  # type: ignore[attr-defined]
    with pytest.raises(mk.MckibbenError):
        mk.Simulation(root / ELBOW, 0.0)
    assert elbow.step([0.2, 0.1]).time_s == 0.02


def test_simulations_run_in_threads(root: Path) -> None:
    """Each is what it is alone."""
    first = mk.Simulation(root / ELBOW, 0.005, model="universal")

    def run(pressure: float) -> list[float]:
        own = first.copy()
        return [own.step([pressure, 0.1]).angle_deg for _ in range(20)]

    pressures = [0.1 + 0.002 * i for i in range(40)]
    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(run, pressures)) == [run(p) for p in pressures]


@pytest.fixture
def elbow(root: Path) -> mk.Joint:
    """That of examples/elbow.toml, by its numbers."""
    biceps = mk.load(root / "examples/biceps.toml")
    keys: dict[str, Any] = {
        "radius_mm": 25,
        "range_deg": (-60, 60),
        "inertia": "0.03 kg m2",
        "damping_nm_s_per_rad": 0.3,
    }
    return mk.Joint(
        biceps,
        biceps,
        joint=keys,
        contraction_at_neutral=0.12,
        link={"mass_kg": 1.2, "centre_mm": 150, "inclination_deg": -90},
        name="elbow",
    )


def test_a_joint_is_its_file(elbow: mk.Joint, root: Path, tmp_path: Path) -> None:
    asked: dict[str, Any] = {
        "pressures_mpa": [["2 bar", "1 bar"]],
        "angles_deg": [0.0, 10.0],
        "model": "universal",
    }
    points = mk.load(root / "examples/elbow.toml").solve(**asked).points
    elbow.save(tmp_path / "elbow.toml")
    saved = mk.load(tmp_path / "elbow.toml")
    for same in (elbow, saved, pickle.loads(pickle.dumps(elbow)), copy.deepcopy(elbow)):
        assert same.solve(**asked).points == points
    assert (
        saved == elbow
        and hash(saved) == hash(elbow)
        and list(elbow.muscles) == ["muscle_1.toml"]
    )
    other = elbow.replace(
        muscle_2=mk.load(root / "examples/biceps.toml").replace(wall_mm=1)
    )
    assert (
        other.solve(**asked).points != points
        and list(other.muscles) == ["muscle_1.toml", "muscle_2.toml"]
        and len(elbow.muscles) == 1
    )
    biceps = elbow.muscles["muscle_1.toml"]
    assert (
        elbow.replace(muscle_1=biceps.replace(wall_mm=1)).muscles["muscle_2.toml"]
        == biceps
    ), "the other side is as it was"
    for wrong, said in (({"radus_mm": 25}, "radus"), ({"radius": 25}, "no unit")):
        with pytest.raises(mk.InputError, match=said):
            mk.Joint(biceps, joint=wrong)
    spring = mk.Joint(
        biceps,
        biceps,
        joint={"range_deg": (-40, 40)},
        geometry_1={"origin_mm": [-20, 250], "insertion": ["-30 mm", "5 mm"]},
        geometry_2={"radius_mm": 20},
        spring={"angular_rate": "2 N m/rad"},
    )
    assert (
        len(
            spring.solve(
                pressures_mpa=[[0.2, 0.1]], angles_deg=[0.0], model="universal"
            ).points
        )
        == 1
    )


def test_a_drive_is_its_file_and_its_simulation_the_motion(
    elbow: mk.Joint, root: Path, tmp_path: Path
) -> None:
    steps: dict[str, Any] = {
        "pressure_1_mpa": [[0, 0.15], [0.1, 0.2]],
        "pressure_2": [["0 s", "1.5 bar"], ["0.1 s", "1 bar"]],
        "until_s": 2,
    }
    drive = mk.Drive(elbow, valve="festo-mh2", command=steps)
    series = mk.load(root / ELBOW).motion(model="universal").series
    drive.save(tmp_path / "drive.toml")
    for same in (
        drive,
        mk.load(tmp_path / "drive.toml"),
        pickle.loads(pickle.dumps(drive)),
    ):
        assert same.motion(model="universal").series == series
    assert mk.Simulation(drive, 0.01, model="universal").step(
        [0.2, 0.1]
    ) == mk.Simulation(root / ELBOW, 0.01, model="universal").step([0.2, 0.1])


def test_a_drive_of_one_muscle_with_tables_and_liquids(
    root: Path, tmp_path: Path
) -> None:
    muscle = mk.load(root / "examples/prototype.toml")
    valve: dict[str, Any] = {
        "sonic_conductance": "0.5 L/(s bar)",
        "critical_ratio": 0.3,
    }
    given: dict[str, Any] = {
        "supply": {"pressure_mpa": 0.6, "temperature": "20 degC"},
        "air": {"dead_volume": "10 cm3", "heat": "isothermal"},
        "load": {"mass_kg": 10, "damping": "200 N s/m", "stops_mm": (0, 100)},
    }
    command: dict[str, Any] = {
        "pressure_mpa": [[0, "0 bar"], [0.1, "3 bar"], [2, "0 bar"]],
        "until": "4 s",
    }
    drive = mk.Drive(muscle, valve=valve, command=command, **given)
    assert (
        drive.motion(model="universal").series
        == mk.load(root / "examples/drive.toml").motion(model="universal").series
    )
    ramp = mk.Drive(
        muscle,
        valve=valve,
        command={"pressure": "table:ramp.csv", "until_s": 2},
        tables={
            "ramp.csv": {"time_s": [0.0, 1.0, 2.0], "pressure_mpa": [0.0, 0.3, 0.3]}
        },
        **given,
    )
    same = mk.Drive(
        muscle,
        valve=valve,
        command={"pressure": "ramp 0..3 bar in 1 s", "until_s": 2},
        **given,
    )
    ramp.save(tmp_path / "ramp.toml")
    ends = [
        d.motion(model="universal")["contraction"][-1]
        for d in (ramp, same, mk.load(tmp_path / "ramp.toml"))
    ]
    assert ends[0] == ends[2] == pytest.approx(ends[1], rel=1e-4)
    assert (
        drive.replace(muscle.replace(wall_mm=2)).motion(model="universal").series
        != drive.motion(model="universal").series
    )
    liquid: dict[str, Any] = {
        "liquid": {"name": "water", "gas_share": "0.5 %", "dead_volume_mm3": 10e3},
        "syringe": {"volume": "150 mL", "time_constant_s": 0.2},
        "load": given["load"],
    }
    command = {"volume_mm3": [[0, 0], [0.1, 100e3], [2, 20e3]], "until_s": 4}
    syringe = mk.Drive(muscle, command=command, **liquid)
    assert (
        syringe.motion(model="universal").series
        == mk.load(root / "examples/syringe-drive.toml")
        .motion(model="universal")
        .series
    )
    with pytest.raises(mk.InputError, match="sonic_conductance") as caught:
        mk.Drive(
            muscle,
            valve={"sonic_conductanc": "1 L/(s bar)"},
            command={"pressure_mpa": 0.3, "until_s": 1},
            load={"mass_kg": 10},
        ).motion(model="universal")
    assert not isinstance(caught.value, OSError), "there is no file"


def example(name: str, needs: str, root: Path, monkeypatch: pytest.MonkeyPatch) -> Any:
    pytest.importorskip(needs)
    monkeypatch.syspath_prepend(str(root / "python" / "examples"))
    return importlib.import_module(name)


def test_the_environment_of_gymnasium(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = example("elbow_gymnasium", "gymnasium", root, monkeypatch)
    from gymnasium.utils.env_checker import check_env

    check_env(made.Elbow(), skip_render_check=True)
    # A controller of two lines brings it within two degrees of where it should be.
    assert made.main() < 2


def test_the_elbow_in_mujoco_rests_where_the_joint_does(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = example("elbow_mujoco", "mujoco", root, monkeypatch)
    assert made.main((0.2, 0.1)) == pytest.approx(
        mk.load(root / ELBOW).motion(model="universal").equilibrium_angle_deg, abs=1e-3
    )


def test_a_predictive_controller_brings_the_elbow_to_its_angle(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert example("elbow_mpc", "scipy", root, monkeypatch).main() < 1
