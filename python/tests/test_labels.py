"""Dimensions of xarray and indices of pandas go in, and come back."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import mckibben as mk

OPTIONS: Any = {"model": "universal"}


@pytest.fixture(scope="module")
def muscle() -> mk.Muscle:
    return mk.Muscle.prototype()


def test_dimensions_are_broadcast_by_their_names(muscle: mk.Muscle) -> None:
    """In whichever order they stand; numbers are those of arrays, and coordinates and units stay."""
    xr = pytest.importorskip("xarray")
    p = xr.DataArray([0.1, 0.2, 0.3], dims="p", coords={"p": ["low", "mid", "high"]})
    e = xr.DataArray([[0.0, 0.1], [0.05, 0.15]], dims=("day", "run"))
    pull = muscle.force(p, e, **OPTIONS)
    assert pull.dims == ("p", "day", "run") and pull.attrs["units"] == "N"
    assert pull.name == "force_n" and pull.p.values.tolist() == ["low", "mid", "high"]
    plain = muscle.force(p.values[:, None, None], e.values, **OPTIONS)
    assert np.array_equal(pull.values, plain)
    assert muscle.force(p, e.T, **OPTIONS).transpose(*pull.dims).equals(pull)
    value, slopes = muscle.force(p, 0.1, jac=True, **OPTIONS)
    assert getattr(slopes, "dims") == ("p", "derivative") and value.dims == ("p",)
    assert muscle.pressure(pull, e, **OPTIONS).values == pytest.approx(
        np.broadcast_to(p.values[:, None, None], pull.shape)
    )
    points = muscle.solve(p, e, **OPTIONS).to_xarray()
    assert points.force_n.equals(pull) and points.uncertainty_n.dims == pull.dims


def test_units_of_a_data_array_are_read(muscle: mk.Muscle) -> None:
    xr = pytest.importorskip("xarray")
    bars = xr.DataArray([1.0, 2.0], dims="p", attrs={"units": "bar"})
    assert muscle.force(bars, 0.1, **OPTIONS).values == pytest.approx(
        muscle.force([0.1, 0.2], 0.1, **OPTIONS)
    )
    curve = muscle.curve(pressures_mpa=bars, contractions=[0.1], **OPTIONS)
    assert curve.fixed == pytest.approx([0.1, 0.2])
    wrong = xr.DataArray([1.0], dims="p", attrs={"units": "mm"})
    with pytest.raises(mk.InputError) as caught:
        muscle.force(wrong, 0.1, **OPTIONS)
    assert caught.value.field == "pressure_mpa"
    assert str(caught.value).count("pressure_mpa") == 1


def test_arrays_of_texts_and_indices_are_numbers(muscle: mk.Muscle) -> None:
    """A column of texts as it comes from a table; an index is an array, and points that are none have no labels."""
    pd, _ = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    expected = muscle.force([0.1, 0.2], 0.1, **OPTIONS)
    texts = pd.Series(["1 bar", "2 bar"], ["a", "b"])
    pull: Any = muscle.force(texts, 0.1, **OPTIONS)
    assert pull.index.equals(texts.index) and pull.to_numpy() == pytest.approx(expected)
    for given in (np.array(["1 bar", "2 bar"]), pd.Index([0.1, 0.2])):
        assert muscle.force(given, 0.1, **OPTIONS) == pytest.approx(expected)
    assert muscle.solve([], 0.1, **OPTIONS).to_xarray().force_n.shape == (0,)


def test_what_does_not_match_is_refused(muscle: mk.Muscle) -> None:
    xr, pd = pytest.importorskip("xarray"), pytest.importorskip("pandas")
    a = xr.DataArray([0.1, 0.2], dims="p", coords={"p": [1, 2]})
    pairs = [
        (a, xr.DataArray([0.0, 0.1], dims="p", coords={"p": [1, 3]})),
        (a, np.array([0.0, 0.1])),
        (pd.Series([0.1, 0.2], ["a", "b"]), pd.Series([0.0, 0.1], ["b", "a"])),
    ]
    for first, second in pairs:
        with pytest.raises((mk.InputError, TypeError)):
            muscle.force(first, second, **OPTIONS)


def test_a_series_keeps_its_index(muscle: mk.Muscle) -> None:
    pd = pytest.importorskip("pandas")
    index = pd.date_range("2026-11-28", periods=3, freq="s", name="time")
    p = pd.Series([0.1, 0.2, 0.3], index)
    pull = muscle.force(p, pd.Series([0.0, 0.1, 0.2], index), **OPTIONS)
    assert pull.index.equals(index) and pull.name == "force_n"
    assert pull.tolist() == muscle.force(p.values, [0.0, 0.1, 0.2], **OPTIONS).tolist()
    assert muscle.force(p.iloc[1], 0.1, **OPTIONS) == pull.iloc[1]


def test_a_solution_of_a_series_keeps_its_index(muscle: mk.Muscle) -> None:
    pd = pytest.importorskip("pandas")
    pressures = pd.Series([0.1, 0.2], index=["a", "b"])
    found = muscle.solve(pressures, 0.1, model="universal").to_pandas()
    assert found.index.tolist() == ["a", "b"] and found.force_n["b"] > 0


def test_a_formula_takes_labels(root: Any) -> None:
    xr, pd = pytest.importorskip("xarray"), pytest.importorskip("pandas")
    formula: Any = mk.fit(root / "data/campaign/paper.csv").formula
    walls = xr.DataArray([1.0, 2.0], dims="wall", coords={"wall": ["thin", "thick"]})
    pull = formula(0.2, xr.DataArray([0.0, 0.1], dims="e"), walls, 40)
    assert pull.dims == ("e", "wall") and pull.attrs["units"] == "N"
    assert pull.sel(e=1, wall="thick").item() == formula(0.2, 0.1, 2.0, 40)
    row = formula(pd.Series([0.1, 0.2], ["a", "b"]), 0.1, 2.0, 40)
    assert row["b"] == formula(0.2, 0.1, 2.0, 40) and row.name == "force_n"


def test_a_joint_takes_labels(root: Any) -> None:
    xr = pytest.importorskip("xarray")
    elbow = mk.load(root / "examples/elbow.toml")
    angle = xr.DataArray([-10.0, 0.0, 10.0], dims="phi", coords={"phi": [-10, 0, 10]})
    p = xr.DataArray([0.2, 0.3], dims="p")
    torque = elbow.torque([p, 0.1], angle, **OPTIONS)
    assert set(torque.dims) == {"p", "phi"} and torque.attrs["units"] == "N m"
    assert torque.sel(phi=10, p=1).item() == elbow.torque([0.3, 0.1], 10, **OPTIONS)
