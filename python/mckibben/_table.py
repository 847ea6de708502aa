"""Columns with names, and data frames of any library as such."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _quantity

if TYPE_CHECKING:
    import pandas

# Rows that a notebook shows.
_SHOWN = 20


class Fixed:
    """An object that does not change."""

    __slots__ = ()

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a {type(self).__name__} does not change: {name}")


class Tabled:
    """What has a table, and gives it to data frames."""

    __slots__ = ()

    def to_table(self) -> Table:
        """The table."""
        raise NotImplementedError

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a ``pandas.DataFrame``."""
        return self.to_table().to_pandas()



def _column(values: Any) -> Any:
    """A column: an array of float64, int64 or bool, or a list of texts. Missing numbers are NaN."""
    if isinstance(values, np.ma.MaskedArray):
        # What is masked is missing.
        values = np.where(np.ma.getmaskarray(values), np.nan, values.data) if values.dtype.kind == "f" else values.tolist()
    if isinstance(values, np.ndarray) and values.ndim == 1 and values.dtype.kind in "fiub":
        kind = {"f": np.float64, "b": np.bool_}.get(values.dtype.kind, np.int64)
        # Its own: what the caller writes later must not change it.
        return np.array(values, dtype=kind)
    values = [None if isinstance(v, float) and v != v else v for v in values]
    known = [v for v in values if v is not None]
    if known and all(isinstance(v, (bool, np.bool_)) for v in known) and len(known) == len(values):
        return np.array(values, dtype=np.bool_)
    if known and all(isinstance(v, (int, np.integer)) and not isinstance(v, bool) for v in known) and len(known) == len(values):
        return np.array(values, dtype=np.int64)
    if all(isinstance(v, (int, float, np.integer, np.floating)) and not isinstance(v, bool) for v in known):
        return np.array([np.nan if v is None else v for v in values], dtype=np.float64)
    return [None if v is None else str(v) for v in values]


class Table(Fixed):
    """Columns with names, all of one length: NumPy arrays of numbers, lists of texts.

    ``polars.DataFrame(dict(table))`` and ``pyarrow.table(dict(table))`` take it over.
    """

    __slots__ = ("_columns",)
    _columns: dict[str, Any]

    def __init__(self, columns: Mapping[str, Any]) -> None:
        held = {str(name): _column(values) for name, values in columns.items()}
        lengths = {len(values) for values in held.values()}
        if len(lengths) > 1:
            raise ValueError(f"columns of different length: {sorted(lengths)}")
        self._hold(held)

    def _hold(self, columns: dict[str, Any]) -> None:
        for values in columns.values():
            if isinstance(values, np.ndarray):
                values.flags.writeable = False
        object.__setattr__(self, "_columns", columns)

    @classmethod
    def of(cls, data: Any) -> Table:
        """The table of a data frame (pandas, Polars, Arrow, any that has ``__arrow_c_stream__``), of an answer, or of columns by name, in
        which a single value applies to all rows.
        """
        if isinstance(data, Tabled):
            return data.to_table()
        return data if isinstance(data, Table) else cls(columns_of(data))

    @classmethod
    def from_rows(cls, rows: Sequence[Mapping[str, Any]]) -> Table:
        """The table of rows; values that are lists or maps themselves are left out."""
        names = dict.fromkeys(name for row in rows for name, value in row.items() if not isinstance(value, (list, dict)))
        return cls({name: [row.get(name) for row in rows] for name in names})

    @property
    def columns(self) -> list[str]:
        """The names of the columns."""
        return list(self._columns)

    def __len__(self) -> int:
        return len(next(iter(self._columns.values()), ()))

    def __getitem__(self, name: str) -> Any:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __contains__(self, name: object) -> bool:
        return name in self._columns

    def keys(self) -> list[str]:
        """The names of the columns."""
        return list(self._columns)

    def rows(self) -> list[dict[str, Any]]:
        """The rows; what is missing is left out."""
        lists = {name: values.tolist() if isinstance(values, np.ndarray) else values for name, values in self._columns.items()}
        return [{n: v[i] for n, v in lists.items() if v[i] is not None and v[i] == v[i]} for i in range(len(self))]

    def to_pandas(self) -> pandas.DataFrame:
        """The same as a ``pandas.DataFrame``."""
        import pandas as pd

        return pd.DataFrame({name: values.copy() if isinstance(values, np.ndarray) else values for name, values in self._columns.items()})

    def to_csv(self) -> str:
        """The same as CSV."""
        out = io.StringIO()
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(self._columns)
        lists = [values.tolist() if isinstance(values, np.ndarray) else values for values in self._columns.values()]
        for row in zip(*lists):
            writer.writerow(["" if v is None or v != v else repr(v) if isinstance(v, float) else str(v).lower() if isinstance(v, bool) else v for v in row])
        return out.getvalue()

    def _key(self) -> Any:
        # Zeros without a sign.
        kept = [(v.dtype.char, (v + 0).tobytes()) if isinstance(v, np.ndarray) else tuple(v) for v in self._columns.values()]
        return tuple(zip(self._columns, kept))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Table) and self._key() == other._key()

    def __hash__(self) -> int:
        return hash(("Table", self._key()))

    def __reduce__(self) -> tuple[Any, ...]:
        return Table, (self._columns,)

    def __repr__(self) -> str:
        return f"Table({len(self)} rows: {', '.join(self._columns)})"

    def _repr_html_(self) -> str:
        def cell(value: Any) -> str:
            if value is None or value != value:
                return ""
            return f"{value:.6g}" if isinstance(value, float) else escape(str(value))

        head = "".join(f"<th>{escape(name)}</th>" for name in self._columns)
        lists = [list(values[:_SHOWN]) for values in self._columns.values()]
        rows = "".join("<tr>" + "".join(f"<td>{cell(v)}</td>" for v in row) + "</tr>" for row in zip(*lists))
        more = f"<p>{len(self) - _SHOWN} rows more</p>" if len(self) > _SHOWN else ""
        return f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>{more}"


def columns_of(data: Any) -> dict[str, Any]:
    """The columns of a data frame, of an answer, or of a map in which a single value applies to all rows."""
    if isinstance(data, np.ndarray) and data.dtype.names:
        # Records, and those with masks.
        return {name: data[name] for name in data.dtype.names}
    if isinstance(data, Mapping):
        return _spread({str(name): _values(str(name), values) for name, values in data.items()})
    if hasattr(data, "columns") and hasattr(data, "items"):
        if not data.columns.is_unique:
            raise ValueError("two columns of one name")
        if any(name is not None for name in data.index.names):
            # An index with a name is a column.
            data = data.reset_index()
        return {str(name): _of_pandas(values) for name, values in data.items()}
    if hasattr(data, "get_columns"):
        return {column.name: column.to_list() for column in data.get_columns()}
    if hasattr(data, "to_pydict"):
        return dict(data.to_pydict())
    if hasattr(data, "__arrow_c_stream__"):
        try:
            import pyarrow as pa

            return dict(pa.table(data).to_pydict())
        except ImportError:
            import polars as pl

            return dict(pl.DataFrame(data).to_dict(as_series=False))
    raise TypeError(f"a table is a path, a data frame or columns by name, not {type(data).__name__}")


def _of_pandas(values: Any) -> Any:
    if isinstance(values.dtype, np.dtype) and values.dtype.kind in "fiub":
        return values.to_numpy()
    return values.astype(object).where(values.notna(), None).tolist()


def _values(name: str, values: Any) -> Any:
    """Several values of a column as a list or an array; a single one as it is."""
    values = _quantity.unpinted(name, values)
    if isinstance(values, (str, bytes)) or not hasattr(values, "__iter__") or getattr(values, "shape", None) == ():
        return values
    if hasattr(values, "notna"):
        return _of_pandas(values)
    if getattr(values, "ndim", 1) != 1:
        raise ValueError(f"{name}: a column has one dimension, not {values.ndim}")
    return values if isinstance(values, np.ndarray) else [_quantity.unpinted(name, value) for value in values]


def _spread(columns: dict[str, Any]) -> dict[str, Any]:
    several = {name: len(values) for name, values in columns.items() if isinstance(values, (list, np.ndarray))}
    rows = max(several.values(), default=1)
    return {name: values if name in several else [values] * rows for name, values in columns.items()}
