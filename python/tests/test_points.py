"""Points of a muscle: arrays in and out, the whole point, grids, quantities of pint."""

from __future__ import annotations

import pickle
import warnings
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


def test_a_number_has_its_point_with_it(thin: mk.Muscle) -> None:
    pull = thin.force(0.2, 0.1)
    assert isinstance(pull, float) and pull == thin.state(0.2, 0.1).force_n == pull.force_n and pull.state == thin.state(0.2, 0.1)
    assert pull.uncertainty_n == pull.state.uncertainty_n > 0 and pull.state.volume_mm3 > 0 and pull + 1 == float(pull) + 1
    assert repr(pull).startswith("1243.34 N ± ") and f"{pull:.1f}" == "1243.3" and str(pull) == str(float(pull))
    assert pickle.loads(pickle.dumps(pull)) == pull and np.asarray([pull]).dtype == np.float64
    assert thin.pressure(pull, 0.1) == pytest.approx(0.2, rel=1e-8) and thin.contraction(pull, 0.2) == pytest.approx(0.1, rel=1e-6)
    with pytest.raises(mk.OutOfRangeError):
        thin.force(0.3, model="paper")


def test_points_without_an_answer_are_nan_with_one_warning(thin: mk.Muscle) -> None:
    p = [0.1, 0.3, 0.2, 0.4]
    with pytest.warns(mk.OutsideWarning, match="2 of 4 points have no answer; point 1: outside the range of the paper model: pressure 0.3") as caught:
        pulls = thin.force(p, 0.1, model="paper")
    assert len(caught) == 1 and caught[0].filename == __file__ and np.isnan(pulls).tolist() == [False, True, False, True]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with mk.errstate("nan"):
            assert np.array_equal(thin.force(p, 0.1, model="paper"), pulls, equal_nan=True)
            assert np.array_equal(thin.model("paper").force(p, 0.1), pulls, equal_nan=True)
        with mk.errstate("raise"), pytest.raises(mk.OutOfRangeError) as error:
            thin.force(p, 0.1, model="paper")
        assert error.value.index == 1
        with pytest.raises(mk.OutOfRangeError):
            thin.model("paper").force(p, 0.1)
    with pytest.raises(ValueError):
        mk.errstate("ignore").__enter__()  # type: ignore[arg-type]


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
        assert pull.check("[force]") and pull[0].to("kN").magnitude == pytest.approx(float(thin.model("ideal")._fill("force", "", 0.2, "", 0.0, False, None, None)) / 1000)
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
    # A weight of 10 kg pulls 98.0665 N.
    assert thin.contraction(pressure_mpa=0.25, load="mass:10kg", model="universal") == pytest.approx(thin.contraction(98.0665, 0.25, model="universal"), rel=1e-6)
    for wrong in ({"lod": 1}, {"outer_diameter_mm": 30}, {"pressure": 0.2}):
        with pytest.raises(TypeError):
            thin.force(contraction=0.1, **wrong)
    with pytest.raises(mk.InputError, match="missing"):
        thin.force()
