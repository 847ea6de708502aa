"""Fits, files and figures of results."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

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
    fitted = mk.rubber_fit(root / "data/treloar/tension.csv")
    ogden = mk.Rubber("ogden", mu=[0.4, 0.01], alpha=[2, 5])
    design = mk.design(force_n=700, contraction=0.15, max_pressure_mpa=0.25, model="universal")
    things = [found, fitted, design, thin.curve(model="universal"), thin.state(0.2, 0.1), thin, ogden, mk.Braid("25 deg", strands=48, strand_area_mm2=0.3, strand_modulus_mpa=2500), mk.fit(root / "data/campaign/paper.csv").formula]
    for thing in things:
        thing.save(tmp_path / "thing")
        again = mk.load(tmp_path / "thing")
        assert type(again) is type(thing) and again == thing and repr(again) == repr(thing)
    assert mk.load(tmp_path / "thing").model(thin).force(0.25, 0.1) > 1400
    assert mk.Muscle(**thin.to_dict()) == thin and mk.Rubber(**{k: v for k, v in ogden.to_dict().items()}) == ogden
    thin.replace(rubber=ogden).save(tmp_path / "m.toml")
    assert mk.Rubber.load(tmp_path / "m.toml").stress("planar", 2.0) == ogden.stress("planar", 2.0)
    assert "best D0 25 mm" in repr(design) and "± 227" in repr(design) and "burst margin" in repr(design) and "extended-tube: gc" in repr(fitted)
    solution = thin.solve([0.1, 0.2], 0.1, model="universal")
    solution.save(tmp_path / "s.csv")
    assert mk.Table.from_csv((tmp_path / "s.csv").read_text())["force_n"].tolist() == solution.force_n.tolist()


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
