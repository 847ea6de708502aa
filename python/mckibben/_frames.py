"""Data frames of any library as columns by name."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from . import _quantity


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
