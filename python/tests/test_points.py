"""Points of a muscle: arrays in and out, the whole point, grids, quantities of pint."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import mckibben as mk


def test_arrays_of_a_muscle_are_those_of_its_model(thin: mk.Muscle) -> None:
    p, e = np.linspace(0.05, 0.25, 4)[:, None], np.linspace(0, 0.2, 3)
    assert np.array_equal(thin.force(p, e, model="universal"), thin.model("universal").force(p, e))
    assert thin.force("0.5..2.5:0.5 bar", 0.1, model="ideal").shape == (5,) and thin.force(["1 bar", "2 bar"], 0.1, model="ideal").shape == (2,)
    value, slopes = thin.force(p, e, model="universal", jac=True)
    assert slopes.shape == (4, 3, 2) and np.array_equal(value, thin.model("universal").force(p, e, jac=True)[0])
    pulls = np.array([300.0, 500.0])
    assert np.allclose(thin.force(thin.pressure(pulls, 0.1), 0.1), pulls, rtol=1e-8) and np.allclose(thin.force(0.25, thin.contraction(pulls, 0.25)), pulls, rtol=1e-6)


@pytest.mark.parametrize("model", ["fe", "universal"])
def test_a_solution_is_its_points(thin: mk.Muscle, model: str) -> None:
    """On a grid, and where every point has a pressure of its own: what the command answers for each, ± and volume among it."""
    rng = np.random.default_rng(2)
    points: list[Any] = [(np.array([0.05, 0.2])[:, None], np.array([0.0, 0.1, 0.3])), (rng.uniform(0.05, 0.25, 7), rng.uniform(0, 0.2, 7)), (0.2, 0.1)]
    for p, e in points:
        solution = thin.solve(p, e, model=model)
        a, b = np.broadcast_arrays(p, e)
        assert solution.shape == a.shape and np.array_equal(solution.pressure_mpa, a) and np.array_equal(solution.contraction, b)
        for place in np.ndindex(a.shape):
            point = thin.state(float(a[place]), float(b[place]), model=model)
            for name in ("force_n", "uncertainty_n", "volume_mm3", "stiffness_n_per_mm"):
                # A slack muscle has no ± where it is asked for alone.
                if point[name] is not None:
                    assert solution[name][place] == pytest.approx(point[name], rel=1e-7, abs=1e-6), name
            assert solution.slack[place] == point.slack and solution.status[place] == "ok"
    assert len(solution.to_pandas()) == 1 and "fe" in repr(solution) + "fe"
    with pytest.raises(mk.InputError):
        thin.solve([], 0.1)
    with pytest.raises(AttributeError, match="force_n"):
        solution.pull


def test_a_solution_is_a_dataset_with_units(thin: mk.Muscle) -> None:
    pytest.importorskip("xarray")
    p, e = np.linspace(0.05, 0.25, 3), np.linspace(0, 0.2, 5)
    data = thin.solve(p[:, None], e, model="universal").to_xarray()
    assert dict(data.sizes) == {"pressure_mpa": 3, "contraction": 5} and data.force_n.attrs["units"] == "N" and data.volume_mm3.attrs["units"] == "mm3"
    assert float(data.force_n.sel(pressure_mpa=0.15, contraction=0.1, method="nearest")) == pytest.approx(thin.force(0.15, 0.1, model="universal"))
    scattered = thin.solve([0.1, 0.2], [0.0, 0.1], model="universal").to_xarray()
    assert dict(scattered.sizes) == {"dim_0": 2} and float(scattered.pressure_mpa[1]) == 0.2


def test_numbers_come_back_as_quantities_of_pint(thin: mk.Muscle) -> None:
    pint = pytest.importorskip("pint")
    registry = pint.UnitRegistry()
    mk.units(registry)
    try:
        pull: Any = thin.model("ideal").force(0.2, [0.0, 0.1])
        assert pull.check("[force]") and pull[0].to("kN").magnitude == pytest.approx(thin.model("ideal")._native.one("force", 0.2, 0.0, False) / 1000)
        point: Any = thin.state(0.2, 0.1)
        assert point.volume_mm3.to("ml").magnitude == pytest.approx(841.115, rel=1e-6)
        assert (thin.solve(0.2, 0.1).stiffness_n_per_mm * registry.mm).check("[force]")
        again = thin.force(thin.model("ideal").pressure(pull, [0.0, 0.1]), [0.0, 0.1], model="ideal")
        assert np.allclose((again - pull).magnitude, 0, atol=1e-6)
    finally:
        mk.units("plain")
    assert isinstance(thin.model("ideal").force(0.2, 0.1), float)
    assert any(kind.kind == "pressure" for kind in mk.units().kinds)


def test_arguments_of_a_muscle_are_those_of_its_commands(thin: mk.Muscle) -> None:
    """What a command takes besides the muscle, by keyword or place, with its unit in the name or in the text; nothing else."""
    assert thin.force(pressure_mpa=0.2, contraction=0.1, model="ideal") == thin.force(pressure="2 bar", contraction="10%", model="ideal")
    assert thin.pressure(force="300 N", model="ideal") == thin.pressure(300, 0.0, model="ideal")
    assert thin.force(0.2, 0.1) == pytest.approx(thin.state(0.2, 0.1).force_n, rel=1e-12)
    # A weight of 10 kg pulls 98.0665 N.
    assert mk.contraction(thin, pressure_mpa=0.25, load="mass:10kg", model="universal").contraction == pytest.approx(thin.contraction(98.0665, 0.25, model="universal"), rel=1e-6)
    for wrong in ({"lod": 1}, {"outer_diameter_mm": 30}, {"pressure": 0.2}):
        with pytest.raises(TypeError):
            thin.force(contraction=0.1, **wrong)
    with pytest.raises(TypeError, match="pressure_mpa"):
        thin.force()
