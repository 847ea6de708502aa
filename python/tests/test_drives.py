"""Joints and drives as objects: each is its file."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import mckibben as mk

LINK: dict[str, Any] = {"mass_kg": 1.2, "centre_mm": 150, "inclination_deg": -90}


@pytest.fixture
def elbow(root: Path) -> mk.Joint:
    """That of examples/elbow.toml, by its numbers."""
    biceps = mk.Muscle(root / "examples/biceps.toml")
    return mk.Joint(biceps, biceps, contraction_at_neutral=0.12, radius_mm=25, range_deg=(-60, 60), inertia="0.03 kg m2", damping_nm_s_per_rad=0.3, link=LINK, name="elbow")


def test_a_joint_is_its_file(elbow: mk.Joint, root: Path, tmp_path: Path) -> None:
    asked: dict[str, Any] = {"pressures_mpa": [[0.2, 0.1]], "angles_deg": [0.0, 10.0], "model": "universal"}
    points = mk.joint(root / "examples/elbow.toml", **asked).points
    loaded = mk.Joint.load(root / "examples/elbow.toml")
    (tmp_path / "new").mkdir()
    elbow.save(tmp_path / "new" / "elbow.toml")
    saved = mk.load(tmp_path / "new" / "elbow.toml")
    for same in (elbow, loaded, saved, tmp_path / "new" / "elbow.toml", pickle.loads(pickle.dumps(elbow)), copy.deepcopy(elbow)):
        assert mk.joint(same, **asked).points == points
    assert saved == elbow and hash(saved) == hash(elbow) and list(loaded.muscles) == ["biceps.toml"] and list(elbow.muscles) == ["muscle_1.toml"]
    assert elbow.to_toml().startswith("#:schema joint.schema.json\n")
    assert elbow.to_dict()["joint"]["radius"] == "25.0 mm" and elbow.to_dict()["joint"]["range"] == "-60.0..60.0 deg"
    other = mk.Muscle(root / "examples/biceps.toml").replace(wall_mm=1)
    assert mk.joint(elbow, muscles={"muscle_1.toml": other}, **asked).points != points
    (tmp_path / "new" / "muscle_1.toml").write_text("another")
    with pytest.raises(FileExistsError):
        elbow.save(tmp_path / "new" / "elbow.toml")


def test_two_muscles_by_points_and_a_spring(root: Path) -> None:
    biceps = mk.Muscle(root / "examples/biceps.toml")
    joint = mk.Joint(biceps, biceps.replace(wall_mm=2), geometry_1={"origin_mm": [-20, 250], "insertion": ["-30 mm", "5 mm"]}, geometry_2={"radius_mm": 20}, spring={"angular_rate": "2 N m/rad"}, range_deg=(-40, 40))
    assert list(joint.muscles) == ["muscle_1.toml", "muscle_2.toml"] and joint.to_dict()["muscle_1"]["origin"] == ["-20.0 mm", "250.0 mm"]
    assert len(mk.joint(joint, pressures_mpa=[[0.2, 0.1]], angles_deg=[0.0], model="universal").points) == 1
    with pytest.raises(mk.FileError, match="radus"):
        mk.Joint(biceps, radus_mm=25)
    with pytest.raises(AttributeError):
        joint.name = "other"


def test_a_drive_is_its_file_and_its_simulation_the_motion(elbow: mk.Joint, root: Path, tmp_path: Path) -> None:
    """To the last bit, as that of the file."""
    steps: dict[str, Any] = {"pressure_1_mpa": [[0, 0.15], [0.1, 0.2]], "pressure_2": [["0 s", "1.5 bar"], ["0.1 s", "1 bar"]], "until_s": 2}
    drive = mk.Drive(elbow, valve="festo-mh2", command=steps)
    motion = mk.motion(root / "examples/elbow-drive.toml", model="universal")
    loaded = mk.Drive.load(root / "examples/elbow-drive.toml")
    drive.save(tmp_path / "drive.toml")
    for same in (drive, loaded, mk.load(tmp_path / "drive.toml"), tmp_path / "drive.toml", pickle.loads(pickle.dumps(drive))):
        assert mk.motion(same, model="universal").series == motion.series
    assert isinstance(loaded.of, mk.Joint) and mk.load(tmp_path / "drive.toml").to_dict() == drive.to_dict()
    first, second = mk.Simulation(drive, 0.01, model="universal"), mk.Simulation(root / "examples/elbow-drive.toml", 0.01, model="universal")
    assert first.step([0.2, 0.1]) == second.step([0.2, 0.1])


def test_a_syringe_of_a_file_and_of_keys_and_a_step_at_a_time(root: Path) -> None:
    """The same numbers from the file, from keys with their units, and from a simulation whose command is the volume."""
    muscle = mk.Muscle(root / "examples/prototype.toml")
    given: dict[str, Any] = {"liquid": {"name": "water", "gas_share": "0.5 %", "dead_volume_mm3": 10e3}, "syringe": {"volume": "150 mL", "time_constant_s": 0.2}, "load": {"mass_kg": 10, "damping": "200 N s/m", "stops_mm": (0, 100)}}
    drive = mk.Drive(muscle, command={"volume_mm3": [[0, 0], [0.1, 100e3], [2, 20e3]], "until_s": 4}, **given)
    motion, of_file = mk.motion(drive, model="universal"), mk.motion(root / "examples/syringe-drive.toml", model="universal")
    assert motion.series == of_file.series and motion.liquid_volume_mm3 == pytest.approx(20e3, rel=1e-3)
    simulation = mk.Simulation(drive, 0.1, model="universal")
    simulation.step(0.0)
    for _ in range(19):
        state = simulation.step(100e3)
    at = np.searchsorted(np.asarray(motion.series["time_s"]), 2.0) - 1
    assert state.contraction == pytest.approx(np.asarray(motion.series["contraction"])[at], rel=1e-4)


def test_a_drive_of_one_muscle_with_a_table(root: Path, tmp_path: Path) -> None:
    muscle = mk.Muscle(root / "examples/prototype.toml")
    valve: dict[str, Any] = {"sonic_conductance": "0.5 L/(s bar)", "critical_ratio": 0.3}
    given: dict[str, Any] = {"supply": {"pressure_mpa": 0.6, "temperature": "20 degC"}, "air": {"dead_volume": "10 cm3", "heat": "isothermal"}, "load": {"mass_kg": 10, "damping": "200 N s/m", "stops_mm": (0, 100)}}
    drive = mk.Drive(muscle, valve=valve, command={"pressure": [["0 s", "0 bar"], ["0.1 s", "3 bar"], ["2 s", "0 bar"]], "until": "4 s"}, **given)
    assert mk.motion(drive, model="universal").series == mk.motion(root / "examples/drive.toml", model="universal").series
    table = {"time_s": [0.0, 1.0, 2.0], "pressure_mpa": [0.0, 0.3, 0.3]}
    ramp = mk.Drive(muscle, valve=valve, command={"pressure": "table:ramp.csv", "until_s": 2}, tables={"ramp.csv": table}, **given)
    same = mk.Drive(muscle, valve=valve, command={"pressure": "ramp 0..3 bar in 1 s", "until_s": 2}, **given)
    found, expected = (np.asarray(mk.motion(d, model="universal").to_table()["contraction"]) for d in (ramp, same))
    assert found[-1] == pytest.approx(expected[-1], rel=1e-4)
    # A table as people write it, from beside the file.
    ramp.save(tmp_path / "ramp.toml")
    (tmp_path / "ramp.csv").write_text("t [ms];pressure [bar]\n0;0,0\n1000;3,0\n2000;3,0\n")
    assert mk.motion(mk.Drive.load(tmp_path / "ramp.toml"), model="universal").series == mk.motion(tmp_path / "ramp.toml", model="universal").series
    assert np.asarray(mk.motion(mk.load(tmp_path / "ramp.toml"), model="universal").to_table()["contraction"])[-1] == pytest.approx(found[-1], rel=1e-6)
    assert mk.motion(drive, muscle=muscle.replace(wall_mm=2), model="universal").series != mk.motion(drive, model="universal").series
    for wrong in (mk.Drive(muscle, valve={"sonic_conductanc": "1 L/(s bar)"}, command={"pressure_mpa": 0.3, "until_s": 1}, load={"mass_kg": 10}), mk.Drive(muscle, valve=valve, command={"presure_mpa": 0.3, "until_s": 1}, load={"mass_kg": 10})):
        with pytest.raises(mk.FileError, match="sonic_conductance|pressure"):
            mk.motion(wrong, model="universal")
