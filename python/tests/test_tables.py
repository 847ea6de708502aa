"""Tables of users: data frames of any library, columns by name, and what is wrong with them."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest

import mckibben as mk


def read(path: Path) -> dict[str, list[str]]:
    """Columns of a file as they stand there."""
    lines = [line for line in path.read_text("utf-8").splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    return {name: [row[name] for row in rows] for name in rows[0]}


def numbers(columns: dict[str, list[str]]) -> dict[str, Any]:
    def several(texts: list[str]) -> Any:
        try:
            return np.array([float(text) for text in texts])
        except ValueError:
            return texts

    return {name: several(texts) for name, texts in columns.items()}


class Stream:
    """A data frame of a library that nobody knows."""

    def __init__(self, table: Any) -> None:
        self.table = table

    def __arrow_c_stream__(self, requested_schema: object = None) -> Any:
        return self.table.__arrow_c_stream__(requested_schema)


FORMS: dict[str, Any] = {
    "columns": dict,
    "pandas": pd.DataFrame,
    "pandas with arrow": lambda columns: pd.DataFrame(columns).convert_dtypes(dtype_backend="pyarrow"),
    "pandas with categories": lambda columns: pd.DataFrame(columns).astype({name: "category" for name, v in columns.items() if isinstance(v, list)}),
    "polars": pl.DataFrame,
    "arrow": pa.table,
    "stream": lambda columns: Stream(pa.table(columns)),
    "table": mk.Table,
    "series": lambda columns: {name: pd.Series(values) for name, values in columns.items()},
}


@pytest.mark.parametrize("form", FORMS)
def test_a_data_frame_is_its_file(root: Path, form: str) -> None:
    """The same numbers as from the file, to the last bit."""
    make = FORMS[form]
    bench, static, tension = root / "examples/bench.csv", root / "data/tondu2012/static_force_20deg.csv", root / "data/treloar/tension.csv"
    frames = {path: make(numbers(read(path))) for path in (bench, static, tension)}
    muscle = root / "examples/bench.toml"
    assert mk.identify(muscle, frames[bench], model="thick-wall").parameters == mk.identify(muscle, bench, model="thick-wall").parameters
    tondu = root / "examples/tondu2012.toml"
    assert mk.compare(tondu, models=["ideal"], data=frames[static]).models == mk.compare(tondu, models=["ideal"], data=static).models
    assert mk.rubber_fit(frames[tension]).laws == mk.rubber_fit(tension).laws


def test_several_data_frames_are_several_tables(root: Path) -> None:
    bench = root / "examples/bench.csv"
    found = mk.identify(root / "examples/bench.toml", [bench, pd.DataFrame(numbers(read(bench)))], model="thick-wall")
    assert len(found.understood) == 2 and found.understood[0].rows == found.understood[1].rows


def test_a_formula_of_a_plan_in_memory(root: Path) -> None:
    """A data frame of points is fitted as its file is, bit by bit."""
    path = root / "data/campaign/paper.csv"
    frame = pl.DataFrame(numbers(read(path)))
    points: dict[str, Any] = {"pressure_mpa": np.linspace(0.05, 0.25, 5)[:, None], "contraction": np.linspace(0.0, 0.2, 5)}
    assert np.array_equal(*(mk.fit(table).formula.model().force(**points) for table in (frame, path)))


def test_awkward_numbers_come_through() -> None:
    """What is read is what was given: digits, missing values, thousands that are none, quantities in units of their own."""
    pull = [1.234, 12.345, 1e-7, 718.5999999999999, 1234.567, 0.1 + 0.2]
    columns: dict[str, Any] = {"pressure_mpa": [0.1] * 6, "contraction": [0.0, 0.01, 0.02, 0.03, 0.04, 0.05], "force_n": pull, "note": ["a, b", "#", None, '"', "1,5", "x"]}
    for make in (dict, pd.DataFrame, pl.DataFrame, pa.table):
        found = mk.identify(data=make(columns), model="ideal", free=["contraction_offset"])
        assert [p.force_n for p in found.points] == pull
    missing = pd.DataFrame({"a": [1.0, np.nan], "b": pd.array([1, None], dtype="Int64"), "c": ["x", None], "d": pd.Series([pd.Timestamp("2026-01-01"), pd.NaT])})
    table = mk.Table.of(missing)
    assert np.isnan(table["a"][1]) and np.isnan(table["b"][1]) and table["c"] == ["x", None] and table["d"][1] is None


def test_a_single_value_stands_for_all_rows() -> None:
    table = mk.Table.of({"pressure_mpa": "2 bar", "force_n": [1.0, 2.0], "length_mm": 285, "wall_mm": np.float64(2)})
    assert table["pressure_mpa"] == ["2 bar", "2 bar"] and table["length_mm"].tolist() == [285, 285] and table["wall_mm"].tolist() == [2.0, 2.0]


def test_quantities_of_pint_are_columns() -> None:
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    table = mk.Table.of({"pressure_mpa": np.array([1.0, 2.0]) * unit.bar, "length_mm": 0.3 * unit.m})
    assert np.allclose(table["pressure_mpa"], [0.1, 0.2]) and np.allclose(table["length_mm"], 300)
    with pytest.raises(mk.InputError):
        mk.Table.of({"pressure_mpa": [1.0] * unit.mm})
    with pytest.raises(mk.InputError):
        mk.Table.of({"pressure": [1.0] * unit.bar})


def test_what_is_no_table() -> None:
    bads: list[Any] = [3, object(), [1, 2], {"a": np.zeros((2, 2))}, {"a": [1.0], "b": [1.0, 2.0]}, pd.DataFrame([[1, 2]], columns=["a", "a"]), b"a,b"]
    for bad in bads:
        with pytest.raises((TypeError, ValueError)):
            mk.rubber_fit(bad)


def test_a_table_is_nobody_elses() -> None:
    """What the caller writes into an array later does not change the table, and the array stays writable."""
    own = np.array([1.0, 2.0])
    table = mk.Table({"a": own})
    own[0] = 5.0
    assert table["a"].tolist() == [1.0, 2.0]
    with pytest.raises(ValueError):
        table["a"][0] = 3.0


def test_tables_are_equal_where_their_columns_are() -> None:
    assert mk.Table({"a": [1.0, None]}) == mk.Table({"a": [1.0, float("nan")]}) and mk.Table({"a": [0.0]}) == mk.Table({"a": [-0.0]})
    different: list[dict[str, Any]] = [{"a": [1.0]}, {"a": ["1.0"]}, {"a": [1]}, {"a": [True]}, {"b": [1.0]}, {"a": [None]}, {"a": [""]}, {}]
    tables = [mk.Table(columns) for columns in different]
    assert len(set(tables)) == len(tables)


def test_records_and_frames_with_an_index_are_tables() -> None:
    """The same rows however they are held."""
    columns = {"pressure_mpa": [0.1, 0.1, 0.2], "contraction": [0.0, 0.1, 0.0], "force_n": [200.0, 90.0, 480.0]}
    frame = pd.DataFrame(columns)
    records = frame.to_records(index=False)
    for same in (frame.set_index("pressure_mpa"), frame.set_index(["pressure_mpa", "contraction"]), records, np.ma.asarray(records), frame.set_axis([7, 3, 5])):
        table = mk.Table.of(same)
        assert sorted(table.columns) == sorted(columns) and all(table[name].tolist() == values for name, values in columns.items())
