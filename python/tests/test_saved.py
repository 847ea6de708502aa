"""Fits and files of results."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import ROOT

import mckibben as mk


@pytest.fixture(scope="module")
def found(root: Path) -> Any:
    return mk.identify(root / "examples/bench.toml", root / "examples/bench.csv", model="universal")


def test_a_fit_is_that_of_least_squares(found: Any) -> None:
    """Identities: rms² = Σr²/n, the deviation squared is Σr²/(n − p), cov has the squares of the standard errors, and the residuals are those of the model found."""
    r, n, p = found.residuals, len(found.points), len(found.x)
    assert found.names == ["tube.material.mu", "braid.stiffness"] and found.x.shape == found.stderr.shape == (2,) and found.cov.shape == (2, 2)
    assert np.sqrt((r**2).mean()) == pytest.approx(found.rms_n) and np.sqrt((r**2).sum() / (n - p)) == pytest.approx(found.deviation)
    assert np.allclose(np.sqrt(np.diag(found.cov)), found.stderr) and np.allclose(found.cov, found.cov.T)
    pulls = found.identified.force([q.pressure_mpa for q in found.points], [q.contraction for q in found.points], model="universal")
    assert np.allclose(pulls - [q.force_n for q in found.points], r, atol=1e-6)
    # The covariance is deviation² (JᵀJ)⁻¹.
    at = found.identified.model("universal").force([q.pressure_mpa for q in found.points], [q.contraction for q in found.points], jac=found.names)[1][:, 2:]
    assert np.allclose(found.cov, found.deviation**2 * np.linalg.inv(at.T @ at), rtol=1e-3)
    assert "tube.material.mu 0.41043 ±" in found.summary() and "0.41043 ± 0.0157 MPa" in repr(found) and "rms 3.73 N of 10 points" in repr(found)


def test_results_muscles_and_rubbers_are_saved_and_loaded(found: Any, thin: mk.Muscle, root: Path, tmp_path: Path) -> None:
    fitted = mk.rubber(root / "data/treloar/tension.csv")
    ogden = mk.Rubber("ogden", mu=[0.4, 0.01], alpha=[2, 5])
    design = mk.design(force_n=700, contraction=0.15, max_pressure_mpa=0.25, model="universal")
    things = [found, fitted, design, thin.curve(model="universal"), thin.state(0.2, 0.1), thin, ogden, mk.fit(root / "data/campaign/paper.csv").formula]
    for i, thing in enumerate(things):
        thing.save(tmp_path / f"thing {i}")
        again = mk.load(tmp_path / f"thing {i}")
        assert type(again) is type(thing) and again == thing and repr(again) == repr(thing)
    assert thin.force(0.25, 0.1, model=again) > 1400
    assert mk.Muscle(**thin.to_dict()) == thin and mk.Rubber(**{k: v for k, v in ogden.to_dict().items()}) == ogden
    thin.replace(rubber=ogden).save(tmp_path / "m.toml")
    assert mk.Rubber.load(tmp_path / "m.toml").stress("planar", 2.0) == ogden.stress("planar", 2.0)
    assert repr(design).startswith("Take tube ") and "\nSure to 95 %" in repr(design) and "extended-tube: gc" in repr(fitted)
    solution = thin.solve([0.1, 0.2], 0.1, model="universal")
    solution.save(tmp_path / "s.csv")
    assert [float(row["force_n"]) for row in csv.DictReader((tmp_path / "s.csv").open())] == solution.force_n.tolist()


def test_another_file_is_not_replaced(thin: mk.Muscle, root: Path, tmp_path: Path) -> None:
    """What is there stays, unless it is empty, the same, or to be overwritten; and no temporary file is left."""
    joint = mk.Joint(thin, contraction_at_neutral=0.1, radius_mm=25, range_deg=(-30, 30))
    drive = mk.Drive(joint, valve="festo-mh2", command={"pressure_1_mpa": 0.2, "until_s": 1})
    things = [thin, mk.Rubber("gent", mu=0.2, jm=30), joint, drive, thin.state(0.1, 0.1, model="universal"), mk.fit(root / "data/campaign/paper.csv").formula, thin.solve(0.1, 0.1, model="universal")]
    place = tmp_path / "notes"
    for thing in things:
        place.write_text("what I measured")
        with pytest.raises(FileExistsError, match="overwrite=True"):
            thing.save(place)
        assert place.read_text() == "what I measured"
        thing.save(place, overwrite=True)
        thing.save(place)
    assert {path.name for path in tmp_path.iterdir()} == {"notes", "joint.toml", "muscle_1.toml"}
    files = thin.export("python")
    first = files.save(tmp_path / "files")
    first.write_text("mine")
    with pytest.raises(FileExistsError):
        files.save(tmp_path / "files")
    assert files.save(tmp_path / "files", overwrite=True).read_text() != "mine"
    missing_places: list[Any] = [lambda: thin.save(tmp_path / "no" / "m.toml"), lambda: mk.Rubber.load(tmp_path / "no.toml")]
    for missing in missing_places:
        with pytest.raises(FileNotFoundError):
            missing()
    with pytest.raises(mk.FileError, match="directory"):
        thin.save(tmp_path / "files")


def test_what_no_field_states_is_kept_as_the_text_of_the_file() -> None:
    pressure = mk.Muscle.from_toml("[tube]\nouter_diameter = 14\nwall_thickness = 2\nlength = 200\n[model.tondu-lopez]\nend_factor = { a = 1, b = 1.2 }\n")
    carries = mk.Muscle.from_toml("[tube]\nouter_diameter = 14\nwall_thickness = 2\nlength = 200\n[braid]\nangle = 25\nstrands = 48\nstrand_area = 0.3\nstrand_modulus = 2500\ncompression = true\n")
    for muscle in (mk.Muscle("lib:dmsp-20-300"), pressure, carries):
        assert list(muscle.to_dict()) == ["base"] and mk.Muscle(**json.loads(json.dumps(muscle.to_dict()))) == muscle
    assert list(mk.Muscle(outer_diameter_mm=20, wall_mm=1, length_mm=200, braid="flexo-overexpanded-0.75in").to_dict())[-1] == "braid"


@pytest.mark.parametrize("path", [path for path in sorted((ROOT / "examples").glob("*.toml")) if "[tube]" in path.read_text("utf-8")], ids=lambda path: path.stem)
def test_a_muscle_is_made_of_its_dict_again(path: Path) -> None:
    """The same muscle, by plain values that JSON holds."""
    muscle = mk.Muscle(path)
    given = json.loads(json.dumps(muscle.to_dict()))
    assert mk.Muscle(**given) == muscle and mk.Muscle(**given).to_dict() == muscle.to_dict()


def test_stress_of_a_rubber_is_that_of_treloar() -> None:
    """Neo-Hookean, nominal (Treloar 1975): µ(λ − λ⁻²), µ(λ − λ⁻³), µ(λ − λ⁻⁵); Mooney-Rivlin in uniaxial tension 2(c10 + c01/λ)(λ − λ⁻²)."""
    stretch = np.array([[0.8, 1.0], [1.5, 3.0]])
    rubber = mk.Rubber("neo-hookean", mu="400 kPa")
    for mode, power in (("uniaxial", 2), ("planar", 3), ("equibiaxial", 5)):
        assert np.allclose(rubber.stress(mode, stretch), 0.4 * (stretch - stretch**-power), rtol=1e-12)
    rivlin = mk.Rubber("mooney-rivlin", c10=0.2, c01=0.1)
    assert rivlin.stress("uniaxial", 2.0) == pytest.approx(2 * (0.2 + 0.1 / 2) * (2 - 2**-2))
    with pytest.raises(ValueError):
        rubber.stress("shear", 2.0)
    with pytest.raises(mk.InputError):
        rubber.stress("uniaxial", [1.0, -1.0])
