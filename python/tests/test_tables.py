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
    assert mk.rubber(frames[tension]).laws == mk.rubber(tension).laws


def test_several_data_frames_are_several_tables(root: Path) -> None:
    bench = root / "examples/bench.csv"
    found = mk.identify(root / "examples/bench.toml", [bench, pd.DataFrame(numbers(read(bench)))], model="thick-wall")
    assert len(found.understood) == 2 and found.understood[0].rows == found.understood[1].rows


def test_a_formula_of_a_plan_in_memory(root: Path) -> None:
    """A data frame of points is fitted as its file is, bit by bit."""
    path = root / "data/campaign/paper.csv"
    frame = pl.DataFrame(numbers(read(path)))
    points: dict[str, Any] = {"pressure_mpa": np.linspace(0.05, 0.25, 5)[:, None], "contraction": np.linspace(0.0, 0.2, 5)}
    assert np.array_equal(*(mk.Muscle.prototype().force(**points, model=mk.fit(table).formula) for table in (frame, path)))


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
            mk.rubber(bad)


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


BENCH: dict[str, Any] = {"pressure_mpa": [0.2, 0.2, 0.2, 0.2, 0.3], "contraction": [0.0, 0.08, 0.15, 0.22, 0.1], "force_n": [483.0, 242.0, 133.0, 42.0, 400.0]}
# The same with a row that lacks its pull, and a column that no fit needs.
GAPS: dict[str, Any] = {name: [*values[:2], 0.1, *values[2:]] for name, values in BENCH.items()} | {"temperature": [np.nan] * 5 + [20.0]}
GAPS["force_n"][2] = np.nan


def identified(root: Path, data: Any, **options: Any) -> Any:
    return mk.identify(root / "examples/bench.toml", data, model="universal", free=["mu"], **options)


@pytest.mark.parametrize("form", ["columns", "pandas", "polars", "index", "recarray", "masked", "file", "several"])
def test_rows_that_are_not_filled_in_are_left_out_and_counted(root: Path, tmp_path: Path, form: str) -> None:
    """Bit by bit the fit of the rows that are whole."""
    frame = pd.DataFrame(GAPS)
    (tmp_path / "gaps.csv").write_text("# measured\npressure_mpa;contraction;force_n;note\n" + "".join(f"{p!r};{e!r};{'' if f != f else repr(f)};x\n".replace(".", ",") for p, e, f in zip(*list(GAPS.values())[:3])))
    made: dict[str, Any] = {
        "columns": GAPS, "pandas": frame, "polars": pl.DataFrame(GAPS), "index": frame.set_index(["pressure_mpa", "contraction"]), "recarray": frame.to_records(index=False),
        "masked": {**GAPS, "force_n": np.ma.masked_invalid(GAPS["force_n"])}, "file": tmp_path / "gaps.csv", "several": [frame, BENCH],
    }
    found = identified(root, made[form])
    assert np.array_equal(found.x, identified(root, BENCH if form != "several" else [BENCH, BENCH]).x)
    assert (found.understood[0].rows, found.understood[0].not_filled) == (5, 1)
    compared = mk.compare(root / "examples/bench.toml", models=["universal"], data=made[form] if form != "several" else frame)
    assert compared.models[0].rms_n == mk.compare(root / "examples/bench.toml", models=["universal"], data=BENCH).models[0].rms_n


def test_a_formula_of_a_table_with_gaps(root: Path) -> None:
    whole = pd.DataFrame(numbers(read(root / "data/campaign/paper.csv")))
    gaps = pd.concat([whole[:5], whole[5:6].assign(force_n=np.nan), whole[5:]])
    point: dict[str, Any] = {"pressure_mpa": 0.2, "contraction": 0.1, "wall_mm": 2.0, "outer_diameter_mm": np.linspace(30, 50, 5)}
    assert np.array_equal(mk.fit(gaps).formula(**point), mk.fit(whole).formula(**point))


def test_decimal_commas_and_headings_by_keyword(root: Path) -> None:
    """The same numbers, written as in a German file, and under headings that say nothing."""
    expected = identified(root, BENCH).x
    commas = {name: [repr(v).replace(".", ",") for v in values] for name, values in BENCH.items()}
    assert np.array_equal(identified(root, commas).x, expected) and np.array_equal(identified(root, pd.DataFrame(commas)).x, expected)
    other = pd.DataFrame({"P1": [10 * p for p in BENCH["pressure_mpa"]], "x": [100 * e for e in BENCH["contraction"]], "F": BENCH["force_n"]})
    found = identified(root, other, columns={"pressure": "P1:bar", "contraction": "x:%", "force": "F:N"})
    assert np.allclose(found.x, expected, rtol=1e-12) and [c.column for c in found.understood[0].columns] == ["P1", "x", "F"]
    other.loc[len(other)] = [2.0, 10.0, np.nan]
    assert np.array_equal(identified(root, other, columns={"pressure": "P1:bar", "contraction": "x:%", "force": "F:N"}).x, found.x)
    with pytest.raises(mk.InputError, match="P2"):
        identified(root, other, columns={"pressure": "P2:bar"})
