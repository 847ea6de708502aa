"""Fits, files and figures of results."""

from __future__ import annotations

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
    things = [found, fitted, design, thin.curve(model="universal"), thin.state(0.2, 0.1), thin, ogden, mk.Braid("25 deg", strands=48, strand_area_mm2=0.3, strand_modulus_mpa=2500), mk.fit(root / "data/campaign/paper.csv").formula]
    for i, thing in enumerate(things):
        thing.save(tmp_path / f"thing {i}")
        again = mk.load(tmp_path / f"thing {i}")
        assert type(again) is type(thing) and again == thing and repr(again) == repr(thing)
    assert again.model(thin).force(0.25, 0.1) > 1400
    assert mk.Muscle(**thin.to_dict()) == thin and mk.Rubber(**{k: v for k, v in ogden.to_dict().items()}) == ogden
    thin.replace(rubber=ogden).save(tmp_path / "m.toml")
    assert mk.Rubber.load(tmp_path / "m.toml").stress("planar", 2.0) == ogden.stress("planar", 2.0)
    assert "best D0 25 mm" in repr(design) and "± 227" in repr(design) and "burst margin" in repr(design) and "extended-tube: gc" in repr(fitted)
    solution = thin.solve([0.1, 0.2], 0.1, model="universal")
    solution.save(tmp_path / "s.csv")
    assert mk.Table.from_csv((tmp_path / "s.csv").read_text())["force_n"].tolist() == solution.force_n.tolist()


def test_a_file_that_is_not_of_its_kind_is_not_replaced(thin: mk.Muscle, root: Path, tmp_path: Path) -> None:
    """Each kind over a file of each: its own is replaced, another one stays as it is, and no temporary file is left."""
    joint = mk.Joint(thin, contraction_at_neutral=0.1, radius_mm=25, range_deg=(-30, 30))

    def drive(until_s: float) -> mk.Drive:
        return mk.Drive(joint, valve="festo-mh2", command={"pressure_1_mpa": 0.2, "until_s": until_s})

    # Two of each kind.
    things: dict[str, list[Any]] = {
        "muscle": [thin, thin.replace(wall_mm=2)], "part": [thin.terminals, thin.replace(grip_mm=5).terminals], "tube": [thin.tube, thin.tube.replace(wall_mm=2)],
        "rubber": [mk.Rubber("gent", mu=0.2, jm=30), mk.Rubber("neo-hookean", mu=0.2)], "joint": [joint, mk.Joint(thin, contraction_at_neutral=0.1, radius_mm=20, range_deg=(-30, 30))],
        "valve": [mk.Valve("festo-mh2"), mk.Valve(sonic_conductance="0.5 L/(s bar)", critical_ratio=0.3)], "drive": [drive(1), drive(2)],
        "state": [thin.state(p, 0.1, model="universal") for p in (0.1, 0.2)], "curve": [thin.curve("isometric", contractions=[e], model="universal") for e in (0.0, 0.1)],
        "formula": [mk.fit(root / "data/campaign" / name).formula for name in ("paper.csv", "paper.csv")], "points": [thin.solve(p, 0.1, model="universal") for p in (0.1, 0.2)],
    }
    places = {kind: tmp_path / kind for kind in things}
    for kind, (one, two) in things.items():
        places[kind].touch()
        one.save(places[kind])
        two.save(places[kind])
        assert kind == "points" or mk.load(places[kind]) == two
    for name, text in {"notes": "what I measured", "settings": "[tool]\nname = 'mine'\n", "data": '{"mine": 1}', "table": "a,b\n1,2\n", "package": "name = 'x'\n[package]\n"}.items():
        places[name] = tmp_path / name
        places[name].write_text(text)
    for kind, (one, _) in things.items():
        for other, place in places.items():
            if kind != other:
                before = place.read_bytes()
                with pytest.raises(FileExistsError, match="overwrite=True"):
                    one.save(place)
                    raise AssertionError((kind, other))
                assert place.read_bytes() == before
        one.save(places["notes"], overwrite=True)
        places["notes"].write_text("what I measured")
    assert {path.name for path in tmp_path.iterdir()} == {*places, "joint.toml", "muscle_1.toml"}
    files = thin.export("python")
    first = files.save(tmp_path / "files")
    assert files.save(tmp_path / "files") == first
    first.write_text("mine")
    with pytest.raises(FileExistsError):
        files.save(tmp_path / "files")
    assert files.save(tmp_path / "files", overwrite=True).read_text() != "mine"
    for missing in (lambda: thin.save(tmp_path / "no" / "m.toml"), lambda: mk.Tube.load(tmp_path / "no.toml")):
        with pytest.raises(FileNotFoundError):
            missing()
    with pytest.raises(mk.FileError, match="directory"):
        thin.save(tmp_path / "files")


def test_a_report_replaces_reports_alone(thin: mk.Muscle, tmp_path: Path) -> None:
    page = thin.report(tmp_path / "r.html")
    assert (tmp_path / "r.html").read_text("utf-8") == page == thin.report(tmp_path / "r.html")
    (tmp_path / "r.html").write_text("<!DOCTYPE html><title>mine</title>")
    with pytest.raises(FileExistsError):
        thin.report(tmp_path / "r.html")


@pytest.mark.parametrize("path", [path for path in sorted((ROOT / "examples").glob("*.toml")) if "[tube]" in path.read_text("utf-8")], ids=lambda path: path.stem)
def test_a_muscle_is_made_of_its_dict_again(path: Path) -> None:
    """The same muscle, by plain values that JSON holds; and so are its parts."""
    muscle = mk.Muscle(path)
    given = json.loads(json.dumps(muscle.to_dict()))
    assert mk.Muscle(**given) == muscle == mk.Muscle.prototype(**given) and mk.Muscle(**given).to_dict() == muscle.to_dict()
    for part in (muscle.tube, muscle.braid, muscle.terminals, muscle.friction):
        assert type(part)(**json.loads(json.dumps(part.to_dict()))).to_toml() == part.to_toml() == type(part).from_toml(part.to_toml()).to_toml()


def test_stress_of_a_rubber_is_that_of_treloar() -> None:
    """Neo-Hookean, nominal (Treloar 1975): µ(λ − λ⁻²), µ(λ − λ⁻³), µ(λ − λ⁻⁵); Mooney-Rivlin in uniaxial tension 2(c10 + c01/λ)(λ − λ⁻²)."""
    stretch = np.array([[0.8, 1.0], [1.5, 3.0]])
    rubber = mk.Rubber("neo-hookean", mu="400 kPa")
    for mode, power in (("uniaxial", 2), ("planar", 3), ("equibiaxial", 5)):
        assert np.allclose(rubber.stress(mode, stretch), 0.4 * (stretch - stretch**-power), rtol=1e-12)  # type: ignore[arg-type]
    rivlin = mk.Rubber("mooney-rivlin", c10=0.2, c01=0.1)
    assert rivlin.stress("uniaxial", 2.0) == pytest.approx(2 * (0.2 + 0.1 / 2) * (2 - 2**-2))
    with pytest.raises(ValueError):
        rubber.stress("shear", 2.0)  # type: ignore[arg-type]
    with pytest.raises(mk.InputError):
        rubber.stress("uniaxial", [1.0, -1.0])


def test_figures_have_bands_of_the_uncertainty(found: Any, thin: mk.Muscle, root: Path) -> None:
    """The band is the pull with its ±, in the unit of the axis: 1 lbf is 4.4482216152605 N."""
    plt = pytest.importorskip("matplotlib.pyplot")
    axes: Any = mk.plot.isobars(thin, [0.1, 0.2], units="bar,lbf", model="universal")
    assert len(axes.collections) == 2 and "lbf" in axes.get_ylabel()
    tops = [collection.get_paths()[0].vertices[:, 1].max() for collection in axes.collections]
    for top, pressure in zip(tops, (0.1, 0.2)):
        at = thin.solve(pressure, 0.0, model="universal")
        assert top == pytest.approx(float(at.force_n + at.uncertainty_n) / 4.4482216152605, rel=1e-6)
    _, own = plt.subplots()
    assert mk.plot.isometric(thin, [0.0, 0.1], ax=own, model="universal") is own and len(own.collections) == 2
    assert "ε" in mk.plot.isotonic(thin, [100.0, 300.0], model="universal").get_ylabel()
    assert not mk.plot.isobars(thin, [0.1], band=False, model="universal").collections
    assert len(mk.plot.fit(found)) == 3 and mk.plot.design(mk.design(force_n=700, contraction=0.15, max_pressure_mpa=0.25, model="universal")) is not None
    joint = mk.joint(root / "examples/elbow.toml", pressures_mpa=[[0.3, 0.1], [0.2, 0.2]], angles_deg="-20..20:10 deg", model="universal")
    drawn: Any = mk.plot.joint(joint)
    assert len(drawn.lines) == 2 and drawn.lines[0].get_ydata().tolist() == [row.torque_nm for row in joint.points if row.pressure_1_mpa == 0.3]
    assert mk.plot.motion(mk.motion(root / "examples/elbow-drive.toml", model="universal")).lines
    lines: Any = mk.Rubber("neo-hookean", mu=0.4).plot(to_stretch=2.0).lines
    assert lines[0].get_ydata()[-1] == pytest.approx(0.4 * (2 - 2**-2))
    plt.close("all")
