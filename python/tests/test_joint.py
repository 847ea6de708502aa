"""A joint as a function of pressures and an angle, and the linear systems of joints and drives."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import mckibben as mk

ANGLES = [-40.0, -20.0, 0.0, 20.0, 40.0, 55.0]
# The second muscle is slack at the last ones.
PRESSURES = [[0.2, 0.1], [0.3, 0.1], [0.1, 0.1], [0.25, 0.02]]


@pytest.fixture(scope="module")
def elbow(root: Path) -> mk.Joint:
    joint: mk.Joint = mk.load(root / "examples/elbow.toml")
    return joint


@pytest.fixture(scope="module")
def with_points(root: Path) -> mk.Joint:
    """A muscle between two points against a torsion spring: its moment arm changes."""
    muscle = mk.load(root / "examples/biceps.toml")
    return mk.Joint(
        muscle,
        joint={"range_deg": (-50, 50), "inertia_kg_m2": 0.02},
        geometry_1={
            "contraction_at_neutral": 0.1,
            "origin_mm": [-30.0, 250.0],
            "insertion_mm": [-30.0, -20.0],
        },
        spring={"angular_rate": "2 N m/rad"},
    )


@pytest.mark.parametrize("model", ["universal", "thick-wall", "fe"])
def test_torque_and_stiffness_are_those_of_the_command(
    elbow: mk.Joint, model: str
) -> None:
    """`joint` sums its muscles itself, with their slopes; the arrays here are sums of muscles that are asked by themselves."""
    p = np.array(PRESSURES[:2] if model == "fe" else PRESSURES)
    found = elbow.solve(pressures_mpa=p.tolist(), angles_deg=ANGLES, model=model)
    pair = [p[:, :1], p[:, 1:]]
    torque = elbow.torque(pair, ANGLES, model=model)
    assert torque.shape == (len(p), len(ANGLES))
    assert torque.ravel() == pytest.approx(found["torque_nm"], rel=1e-9, abs=1e-9)
    stiffness = elbow.stiffness(pair, ANGLES, model=model)
    assert stiffness.ravel() == pytest.approx(found["stiffness_nm_per_rad"], rel=1e-6)
    assert elbow.torque(["2 bar", "1 bar"], 20, model=model) == torque[0, 3]


def test_a_joint_is_between_both_branches_of_its_muscles(elbow: mk.Joint) -> None:
    """Also where the job of a muscle names one: as `joint` answers."""
    text = elbow.muscles["biceps.toml"].to_toml()
    job = '\n[job]\npressure = "2 bar"\nbranch = "contraction"\n'
    muscle = mk.Muscle.from_toml(
        text + "\n[friction]\ncoefficient = 20\nexponent = 0.7\n" + job
    )
    joint = elbow.replace(muscle_1=muscle, muscle_2=muscle)
    found = joint.solve(
        pressures_mpa=[[0.2, 0.1]], angles_deg=ANGLES, model="universal"
    )
    torque = joint.torque([0.2, 0.1], ANGLES, model="universal")
    assert torque == pytest.approx(found["torque_nm"], rel=1e-9)


@pytest.mark.parametrize("name", ["elbow", "with_points"])
def test_derivatives_are_differences_of_the_torque(
    name: str, request: pytest.FixtureRequest
) -> None:
    """∂τ/∂P of each muscle and ∂τ/∂φ by central differences; the stiffness is -∂τ/∂φ per radian."""
    joint = request.getfixturevalue(name)
    count = len(joint._parts[1])
    at = [0.2, 0.12][:count] + [12.0]

    def torque(x: list[float]) -> float:
        return float(joint.torque(x[:-1], x[-1], model="universal"))

    value, jac = joint.torque(at[:-1], at[-1], jac=True, model="universal")
    assert value == torque(at) and jac.shape == (count + 1,)
    for i, h in enumerate([1e-4] * count + [1e-2]):
        up, down = list(at), list(at)
        up[i] += h
        down[i] -= h
        assert jac[i] == pytest.approx(
            (torque(up) - torque(down)) / (2 * h), rel=2e-6
        ), i
    assert joint.stiffness(at[:-1], at[-1], model="universal") == pytest.approx(
        -jac[-1] * 180 / math.pi, rel=1e-12
    )


def test_angles_and_pressures_that_are_none_are_named(elbow: mk.Joint) -> None:
    calls: list[Any] = [
        ([0.2, 0.1], 61, "angles_deg"),
        ([0.2], 0, "pressures_mpa"),
        (["2 mm", 0.1], 0, "pressures_mpa"),
    ]
    for pressures, angle, field in calls:
        with pytest.raises(mk.InputError) as caught:
            elbow.torque(pressures, angle)
        assert caught.value.field == field
    found = elbow.torque([0.2, 0.1], [0, 61], errors="nan", model="universal")
    assert np.isnan(found).tolist() == [False, True]


def test_masks_and_grids_of_a_joint(elbow: mk.Joint) -> None:
    """What is masked is not asked for; rows of the command are pressures times angles."""
    first = np.ma.masked_array([0.2, 9.9], mask=[False, True])
    found, jac = elbow.torque([first, 0.1], 10, jac=True, model="universal")
    assert found.mask.tolist() == [False, True] and jac.mask[1].all()
    assert found[0] == elbow.torque([0.2, 0.1], 10, model="universal")
    held = elbow.solve(
        pressures_mpa=PRESSURES[:3], angles_deg=ANGLES, model="universal"
    )
    rows = np.transpose(PRESSURES[:3])[:, :, None]
    torques = elbow.torque(rows, ANGLES, model="universal")  # type: ignore[arg-type]
    assert held.grid("torque_nm") == pytest.approx(torques, rel=1e-12)
    pytest.importorskip("xarray")
    labelled = held.to_xarray()
    assert labelled.torque_nm.dims == ("case", "angle_deg")
    assert labelled.torque_nm.attrs["units"] == "N m"
    column = labelled.torque_nm.sel(angle_deg=20).values
    assert column == pytest.approx(torques[:, 3], rel=1e-12)


def test_jax_takes_a_joint(elbow: mk.Joint) -> None:
    """Slopes are those of `jac`, second derivatives differences of these; `jit` and `vmap` give the same numbers."""
    jax = pytest.importorskip("jax")
    from mckibben.jax import torque

    jax.config.update("jax_enable_x64", True)
    f = torque(elbow, model="universal")
    value, jac = elbow.torque([0.2, 0.1], 10, jac=True, model="universal")
    assert float(jax.jit(f)([0.2, 0.1], 10.0)) == value
    by_pressures, by_angle = jax.grad(f, argnums=(0, 1))([0.2, 0.1], 10.0)
    assert [*by_pressures, by_angle] == pytest.approx(jac, rel=1e-12)
    curved = jax.hessian(lambda a: f([0.2, 0.1], a))(10.0)
    slopes = [
        elbow.torque([0.2, 0.1], 10 + h, jac=True, model="universal")[1][2]
        for h in (0.05, -0.05)
    ]
    assert float(curved) == pytest.approx((slopes[0] - slopes[1]) / 0.1, rel=1e-4)
    angles = np.array(ANGLES)
    assert np.array_equal(
        jax.vmap(lambda a: f([0.2, 0.1], a))(angles),
        elbow.torque([0.2, 0.1], angles, model="universal"),
    )


def test_a_linear_joint_has_the_frequency_of_its_stiffness_and_inertia(
    elbow: mk.Joint,
) -> None:
    """|λ|² = K/I and -2 Re λ = d/I of a pendulum; SciPy takes the system, and its gain at rest is ∂φ/∂τ = 1/K."""
    signal = pytest.importorskip("scipy.signal")
    linear = elbow.linearise([0.2, 0.1], 10, model="universal")
    stiffness = elbow.stiffness([0.2, 0.1], 10, model="universal")
    poles = np.linalg.eigvals(linear.a)
    assert abs(poles[0]) ** 2 == pytest.approx(stiffness / 0.03, rel=1e-12)
    assert -2 * poles[0].real == pytest.approx(0.3 / 0.03, rel=1e-12)
    system = signal.StateSpace(*linear)
    gain = -system.C @ np.linalg.solve(system.A, system.B) + system.D
    assert gain[0, 2] == pytest.approx(1 / stiffness, rel=1e-12)


def test_a_linear_drive_follows_a_small_step_and_has_the_poles_of_motion(
    root: Path,
) -> None:
    """Against the simulation of the same drive after steps of 0.1 mbar, of each muscle alone; `motion` prints the poles of the state that its first step reaches."""
    signal = pytest.importorskip("scipy.signal")
    joint = mk.load(root / "examples/elbow.toml")
    at = [0.2, 0.1]
    command: dict[str, Any] = {f"pressure_{i + 1}_mpa": p for i, p in enumerate(at)} | {
        "until_s": 1
    }
    # A regulator has no kink at its command.
    drive = mk.Drive(joint, regulator={"time_constant_s": 0.05}, command=command)
    linear = drive.linearise(model="universal")
    for muscle in (0, 1):
        simulation = mk.Simulation(drive, 0.01, model="universal")
        step = np.array(at)
        step[muscle] += 1e-5
        begin = simulation.state.angle_deg
        ends = [simulation.step(step).angle_deg - begin for _ in range(60)]
        times = np.arange(61) * 0.01
        u = np.zeros((61, 2))
        u[:, muscle] = 1e-5
        found = np.degrees(signal.lsim(signal.StateSpace(*linear), u, times)[1])[1:]
        assert np.abs(found - ends).max() < 5e-3 * np.abs(ends).max()
    motion = drive.motion(model="universal")
    poles = sorted(map(complex, np.linalg.eigvals(linear.a)), key=abs)
    printed = sorted((complex(*pole) for pole in motion.poles_per_s), key=abs)
    assert np.abs(poles) == pytest.approx(np.abs(printed), rel=1e-6, abs=1e-6)
    fastest = max(printed, key=lambda pole: pole.imag)
    assert motion.eigenfrequency_hz == pytest.approx(fastest.imag / (2 * math.pi))


def test_monte_carlo_the_parts_of_two_opposed_muscles(elbow: mk.Joint) -> None:
    """What both muscles share (rubber, angle, braid) shifts both pulls at once, friction opposes the turn in both, the rest is drawn for each muscle: half widths of
    95 % of 200 000 torques against those of `joint`, each by its cause."""
    at, angle = [0.2, 0.12], 15.0
    row = elbow.solve(pressures_mpa=[at], angles_deg=[angle], model="universal").points[
        0
    ]
    native, muscles = elbow._parts
    levers = native.levers(angle, False)
    parts = []
    for i, muscle in enumerate(muscles):
        e, arm = levers[2 + 3 * i : 4 + 3 * i]
        points = muscle.solve(at[i], e, model="universal", branch="mean")
        held = {
            name.removeprefix("uncertainty_").removesuffix("_n"): 1e-3 * arm * value
            for name, value in points._arrays().items()
            if name.startswith("uncertainty_") and name != "uncertainty_n"
        }
        total = math.sqrt(sum(float(v) ** 2 for v in held.values()))
        assert total == pytest.approx(1e-3 * abs(arm) * points["uncertainty_n"].item())
        parts.append(held)
    rng = np.random.default_rng(5)
    printed = row.uncertainty_parts_nm
    assert printed is not None
    for name, first in parts[0].items():
        z = rng.standard_normal((2, 200_000))
        if name in ("rubber", "angle", "braid"):
            z[1] = z[0]
        elif name == "friction":
            z[1] = -z[0]
        torques = first * z[0] + parts[1][name] * z[1]
        expected = getattr(printed, name)
        # 1/√400000 = 0.16 % is the error of a standard deviation from 200 000 draws; three times that.
        assert torques.std() == pytest.approx(expected, rel=5e-3), name


def test_closed_form_a_loose_joint_is_a_free_body_under_a_torque(
    elbow: mk.Joint,
) -> None:
    """Without pressure the muscles hang loose: φ = φ0 + τ (t - t0)²/2I of a drive that starts at an angle, and with pressures its first point has them."""
    muscle = next(iter(elbow.muscles.values()))
    loose = mk.Joint(
        muscle,
        muscle,
        joint={"radius_mm": 25, "range_deg": (-60, 60), "inertia_kg_m2": 0.03},
        contraction_at_neutral=0.2,
    )

    def moved(pressure_mpa: float, **start: Any) -> Any:
        drive = mk.Drive(
            loose,
            regulator={"time_constant_s": 0.05},
            command={"pressure_mpa": pressure_mpa, "until_s": 0.4},
            start=start,
            external={"torque_nm": [[0.0, 0.0], [0.1, 0.1]]},
        )
        assert mk.Drive.__reduce__(drive)[0](*drive.__reduce__()[1]) == drive
        return drive.motion(model="universal")

    motion = moved(0.0, position_deg=-20)
    t, angle = motion["time_s"], np.radians(motion["angle_deg"])
    expected = np.radians(-20) + 0.1 * np.maximum(t - 0.1, 0) ** 2 / (2 * 0.03)
    assert np.abs(angle - expected).max() < 1e-8
    filled = moved(0.2, pressures_mpa=[0.1, 0.15], position_deg=5)
    first = [filled[f"pressure_{i}_mpa"][0] for i in (1, 2)]
    assert [*first, filled["angle_deg"][0]] == pytest.approx([0.1, 0.15, 5])
    with pytest.raises(mk.InputError, match="torque"):
        mk.Drive(loose, **DRIVE, external={"force_n": 1}).motion(model="universal")


def test_closed_form_a_torque_of_a_table_is_joined_by_straight_lines(
    elbow: mk.Joint, tmp_path: Path
) -> None:
    """A loose joint under τ = k t from a table is φ = φ0 + k t³/6I, also from the files that it writes."""
    muscle = next(iter(elbow.muscles.values()))
    loose = mk.Joint(
        muscle,
        muscle,
        joint={"radius_mm": 25, "range_deg": (-60, 60), "inertia_kg_m2": 0.03},
        contraction_at_neutral=0.2,
    )
    drive = mk.Drive(
        loose,
        **DRIVE,
        start={"position_deg": -20},
        external={"torque": "table:wind.csv"},
        tables={
            "wind.csv": {
                "time_s": np.linspace(0, 1, 5),
                "torque_nm": np.linspace(0, 0.5, 5),
            }
        },
    )
    drive.save(tmp_path / "drive.toml")
    for made in (drive, mk.load(tmp_path / "drive.toml", mk.Drive)):
        motion = made.motion(model="universal")
        t, angle = motion["time_s"], np.radians(motion["angle_deg"])
        expected = np.radians(-20) + 0.5 * t**3 / (6 * 0.03)
        assert np.abs(angle - expected).max() < 1e-8


DRIVE: Any = {
    "regulator": {"time_constant_s": 0.05},
    "command": {"pressure_mpa": 0, "until_s": 0.4},
}
