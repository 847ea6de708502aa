"""Commands on the examples of the repository."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

import mckibben as mk


def test_curves_are_their_points(root: Path) -> None:
    muscle = mk.Muscle.prototype(outer_diameter_mm=50, wall_mm=1)
    curve = muscle.curve("isometric", contractions=[0.0, 0.1], pressures_mpa="0..2.5:0.5 bar")
    assert np.allclose(curve.grid("force_n"), muscle.model().force(np.linspace(0, 0.25, 6), np.array([[0.0], [0.1]])), atol=1e-6)
    json = mk.ask("curve", {"muscle": {"name": "m", "text": muscle.to_toml()}, "test": "isometric", "contractions": [0.0, 0.1], "pressures_mpa": curve.pressure_mpa[:6].tolist()})
    assert [p.force_n for p in curve.points] == [p["force_n"] for p in json["points"]]
    isotonic = muscle.curve("isotonic", forces_n=[500.0, 5000.0], pressures_mpa=[0.1, 0.2], model="universal")
    assert isotonic.status == ["ok", "ok", "no_answer", "no_answer"] and np.isnan(isotonic.contraction[2]) and isotonic.wanted_force_n[2] == 5000
    assert "no contraction" in isotonic.cause[2]


def test_identification_from_the_bench(root: Path) -> None:
    found = mk.identify(root / "examples/bench.toml", root / "examples/bench.csv")
    assert found.identified.model().force(0.3, 0.0) == pytest.approx(718.6, abs=10)
    assert [p.name for p in found.parameters] == list(found.to_pandas()["name"])
    lines = [line for line in (root / "examples/bench.csv").read_text("utf-8").splitlines() if not line.startswith("#")]
    frame = pd.DataFrame(list(csv.DictReader(lines)))
    again = mk.identify(root / "examples/bench.toml", frame)
    assert [p.value for p in again.parameters] == [p.value for p in found.parameters]


def test_a_measured_muscle_is_a_folder_or_its_files(root: Path) -> None:
    folder = root / "examples/measured/bench"
    found = mk.measured(cases=[folder])
    assert [fit.fit for fit in found.cases[0].fits] == ["nothing", "modulus, stiffness", "Gent, up to 2 bar"]
    # Noise of the pattern's points: nothing fitted is far off, two constants fitted are not.
    rms = {row.fit: row.rms_n for row in found.results if row.of == "all"}
    assert rms["modulus, stiffness"] < rms["nothing"]
    files = {"case": "case.toml", "muscle": "muscle.toml", "points": "points.csv"}
    texts = {"name": "bench", **{name: (folder / file).read_text("utf-8") for name, file in files.items()}}
    assert mk.measured(cases=[texts]) == found
    rubber = root / "crates/mckibben-fit/data/measured/rubber-rtv615"
    assert [r.name for r in mk.measured(cases=rubber).rubbers] == ["rubber-rtv615"]
    with pytest.raises(mk.FileError):
        mk.measured(cases=folder / "nowhere")


def test_a_fitted_formula_is_a_model_and_a_file(root: Path, tmp_path: Path) -> None:
    formula = mk.fit(root / "data/campaign/paper.csv").formula
    formula.save(tmp_path / "own.json")
    muscle = mk.Muscle.prototype(outer_diameter_mm=40, wall_mm=2)
    expected = muscle.force(0.2, [0.0, 0.1], model=formula)
    assert np.array_equal(muscle.model(tmp_path / "own.json").force(0.2, [0.0, 0.1]), expected)
    state = muscle.state(0.2, 0.1, model=formula)
    assert state.force_n == pytest.approx(expected[1], rel=1e-12) and not any("changed" in w for w in state.warnings)
    assert mk.Formula.load(tmp_path / "own.json") == formula
    fe = muscle.model().force(0.2, [0.0, 0.1])
    assert np.abs(expected / fe - 1).max() < 0.05
    assert mk.check_formula(formula, latex=True).latex


def test_joint_and_motion_read_the_files_beside_theirs(root: Path) -> None:
    joint = mk.joint(root / "examples/elbow.toml", pressures_mpa=[["2 bar", "1 bar"]], angles_deg="-30..30:30deg", model="universal")
    assert [p.angle_deg for p in joint.points] == [-30, 0, 30] and len(joint.to_pandas()) == 3
    torque = [p.torque_nm for p in joint.points]
    assert torque[0] > torque[1] > torque[2]
    motion = mk.motion(root / "examples/drive.toml", model="universal")
    series = motion.to_pandas()
    assert series["time_s"].is_monotonic_increasing and (motion.rise_time_s or 0) > 0
    assert motion.plot() is not None


def test_muscles_of_a_joint_and_a_drive_are_objects(root: Path) -> None:
    """The muscles that a joint or drive file names may be given: here those that are named, then others."""
    path = root / "examples/elbow.toml"
    asked: dict[str, Any] = {"pressures_mpa": [[0.2, 0.1]], "angles_deg": [0.0, 10.0], "model": "universal"}
    biceps = mk.Muscle(root / "examples/biceps.toml")
    plain = mk.joint(path, **asked)
    assert mk.joint(path, muscles={"biceps.toml": biceps}, **asked).points == plain.points
    text = {"name": "elbow.toml", "text": path.read_text("utf-8")}
    assert mk.joint(text, muscles={"biceps.toml": biceps}, **asked).points == plain.points
    # Where the ends give way a muscle pulls less, the one of higher pressure by more.
    seated = mk.joint(path, muscles={"biceps.toml": biceps.replace(seating_mm=3)}, **asked)
    assert 0 < seated.points[0].torque_nm < plain.points[0].torque_nm
    with pytest.raises(mk.InputError, match="triceps"):
        mk.joint(path, muscles={"triceps.toml": biceps}, **asked)
    with pytest.raises(mk.FileError):
        mk.joint(text, **asked)
    drive = root / "examples/drive.toml"
    prototype = mk.Muscle(root / "examples/prototype.toml")
    assert mk.motion(drive, muscle=prototype, model="universal").series == mk.motion(drive, model="universal").series
    assert mk.motion(drive, muscle=prototype.replace(wall_mm=2), model="universal").series != mk.motion(drive, model="universal").series


def test_compare_and_study_and_lists(root: Path) -> None:
    compared = mk.compare(root / "examples/tondu2012.toml", models=["ideal"], data=root / "data/tondu2012/static_force_20deg.csv")
    assert compared.models[0].rms_n == pytest.approx(95.2, abs=0.1)
    parts = mk.parts_list()
    assert "paper" in [r.name for r in parts.rubbers] and len(parts.sleeves) > 3 and "fe" in [m.name for m in parts.models]
    ideal = mk.parts_show("ideal").model
    assert ideal is not None and ideal.source
    shown = mk.Muscle.prototype().check(pressure_mpa=0.25)
    assert shown.characteristics is not None
    assert shown.characteristics.blocked_force_n == pytest.approx(mk.Muscle.prototype().force(0.25), rel=1e-9)


def test_a_shape_is_a_body(root: Path) -> None:
    shape = mk.Muscle.prototype(outer_diameter_mm=50, wall_mm=1).shape("2 bar", 0.1)
    r, z = shape.array("r_mm"), shape.array("z_mm")
    assert r.shape == z.shape == (shape.stations, shape.across)
    # The stations lie close, and none beyond the largest diameter.
    assert 2 * r.max() == pytest.approx(shape.bulged_diameter_mm, rel=1e-5) and 2 * r.max() <= (shape.bulged_diameter_mm or 0) * (1 + 1e-12)
    assert r[-1, -1] == pytest.approx(25.0)
    page = shape.to_html()
    assert page.startswith("<!DOCTYPE html>") and "http://" not in page.replace("http://www.w3.org", "") and len(page) < 200_000
    report = mk.Muscle.prototype().report()
    assert "SHA-256" in report
