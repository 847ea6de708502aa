"""A fitted formula as a function of arrays."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import mckibben as mk


@pytest.fixture(scope="module", params=["paper", "global"])
def fitted(request: pytest.FixtureRequest, root: Path) -> Any:
    return mk.fit(root / "data/campaign/paper.csv", method=request.param)


def muscles(count: int) -> Any:
    """Pressures, contractions, walls and diameters within the range of the paper's table."""
    rng = np.random.default_rng(3)
    return rng.uniform(0.05, 0.25, count), rng.uniform(0, 0.2, count), rng.uniform(1, 3, count), rng.uniform(30, 50, count)


def test_a_formula_is_the_programs_own_answer(fitted: Any, tmp_path: Path) -> None:
    """An identity: by the model of each muscle, one after the other, to 1e-12."""
    fitted.formula.save(tmp_path / "own.json")
    formula = mk.Formula.load(tmp_path / "own.json")
    p, e, s, d = muscles(60)
    found = formula(p, e, s, d)
    expected = [mk.Muscle(outer_diameter_mm=d[i], wall_mm=s[i], length_mm=285).force(p[i], e[i], model=formula) for i in range(60)]
    assert (found == 0).sum() < 20 and np.allclose(found, expected, rtol=1e-12, atol=0)
    assert float(formula(p[0], e[0], s[0], d[0])) == found[0]
    # Broadcast as by NumPy: strides, orders, texts with a unit.
    grid = formula(p[:5, None, None], e[:4, None], 1.5, np.asfortranarray(d[:3])[::-1])
    assert grid.shape == (5, 4, 3) and grid[2, 1, 0] == formula(p[2], e[1], 1.5, d[2])
    assert formula("2 bar", "10%", "1 mm", "5 cm") == formula(0.2, 0.1, 1.0, 50.0) and formula([], 0.1, 1, 50).shape == (0,)


def test_1271_muscles_take_five_milliseconds(fitted: Any) -> None:
    formula, points = fitted.formula, muscles(1271)
    formula(*points)
    times = []
    for _ in range(9):
        begun = time.perf_counter()
        formula(*points)
        times.append(time.perf_counter() - begun)
    assert min(times) < 5e-3


def test_outside_of_the_range_and_slack(fitted: Any) -> None:
    formula = fitted.formula
    found = formula(0.2, 0.1, [2.0, 9.0], 40, errors="nan")
    assert found[0] > 0 and np.isnan(found[1])
    with pytest.raises(mk.OutOfRangeError) as caught:
        formula([0.2, 3.0], 0.1, 2.0, 40)
    assert caught.value.index == 1 and caught.value.field == "pressure_mpa"
    assert np.isnan(formula(np.nan, 0.1, 2.0, 40, errors="nan")) and np.isfinite(formula(0.2, 0.1, 9.0, 40, extrapolate=True))
    low, high = formula(0.05, np.linspace(0, 0.3, 31), 3.0, 30, extrapolate=True), formula(0.05, np.linspace(0, 0.3, 31), 3.0, 30, extrapolate=True, two_sided=True)
    assert (low >= 0).all() and (low == 0).any() and (high < 0).any() and np.array_equal(low, np.maximum(high, 0))
