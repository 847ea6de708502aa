"""Values as users give them: numbers in the unit of their name, texts with a unit, quantities of pint, arrays, data frames."""

from __future__ import annotations

import csv
import io
import os
import re
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Protocol, TypedDict, Union

from . import _native
from ._errors import InputError, UnitWarning, warned

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from ._formula import Formula
    from ._muscle import Muscle
    from ._rubber import Rubber


class Measured(Protocol):
    """A quantity of pint."""

    @property
    def magnitude(self) -> Any: ...

    def to(self, unit: Any, /) -> Any: ...


# A number in the unit of its name, a text with its unit, or a quantity of pint.
Number = Union[float, str, Measured]
# Several; a text may be a range with both ends in, such as "0..2.5:0.5 bar".
Numbers = Union[Sequence[Number], "NDArray[np.floating[Any]]", str, Measured]
# What a search goes through: one value, a list of values, or all between the two of a tuple or of "30..50 mm".
Choice = Union[Number, Numbers, Mapping[str, Number]]
# What a table of a request, and an option, may hold.
Plain = Union[None, bool, Number, "NDArray[np.floating[Any]]", Sequence["Plain"], Mapping[str, "Plain"]]
# What a model is asked for: anything that NumPy reads as numbers, texts with a unit, quantities of pint.
Floats = Union["ArrayLike", Number, Numbers]
# A path, or the content of the file as {"name": …, "text": …}.
FileLike = Union[str, "os.PathLike[str]", Mapping[str, str]]
# The same, or a data frame, an answer with a table, or columns by name.
TableLike = Union[str, "os.PathLike[str]", Mapping[str, Any], Any]
FormulaLike = Union[str, "os.PathLike[str]", Mapping[str, str], "Formula"]
MuscleLike = Union[str, "os.PathLike[str]", Mapping[str, str], "Muscle"]
RubberLike = Union[str, "Rubber"]
# True for a line on standard error, or a function that is called with (done, total).
Progress = Union[bool, Callable[[int, int], object], None]


class Options(TypedDict, total=False):
    """Which model of a muscle answers, and how: ``model`` (``fe`` where it is left out, ``universal``, ``thick-wall``, …, a fitted formula), ``mesh``, ``match`` and
    ``terminal`` of finite elements, ``extrapolate``, ``two_sided`` (a push is negative, not 0), ``direction`` of the friction hysteresis.
    """

    model: FormulaLike | None
    formulas: Sequence[FormulaLike] | None
    mesh: str | None
    match: str | None
    terminal: Mapping[str, Plain] | None
    extrapolate: bool
    two_sided: bool
    direction: str


class Fixed:
    """An object that does not change; two are equal where they are of one class and have one key."""

    __slots__ = ()

    def _key(self) -> Any:
        raise NotImplementedError

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and isinstance(other, Fixed) and bool(self._key() == other._key())

    def __hash__(self) -> int:
        return hash((type(self).__name__, self._key()))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a {type(self).__name__} does not change: {name}")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"a {type(self).__name__} does not change: {name}")


def unit_for_pint(name: str) -> str:
    """The unit of a name as pint writes it."""
    return re.sub(r"(?<=[a-z])(?=[23]\b)", "**", _native.unit_of(name) or "dimensionless").replace("²", "**2").replace("³", "**3")


def bare(name: str, value: Any) -> Any:
    """The magnitude of a quantity of pint in the unit of a name; anything else as it is."""
    if not (hasattr(value, "magnitude") and hasattr(value, "to")):
        return value
    try:
        return value.to(unit_for_pint(name)).magnitude
    except Exception as error:
        raise InputError(f"{value} is not in {unit_for_pint(name)}: {error}", kind="quantity", field=name) from None


def plain(name: str, value: Any) -> Any:
    """An argument as JSON has it: quantities of pint in the unit of their name, arrays as lists; texts with a unit stay, the program reads them."""
    value = bare(name, value)
    if getattr(value, "mask", None) is not None and hasattr(value, "compressed") and value.mask.any():
        raise InputError("some values are masked", kind="quantity", field=name, hint="leave them out: values.compressed()")
    if hasattr(value, "tolist") and not isinstance(value, (str, bytes)):
        value = value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Mapping):
        return {str(key): plain(str(key) if _native.unit_of(str(key)) else name, item) for key, item in value.items() if item is not None}
    if isinstance(value, (list, tuple, range)):
        return [plain(name, item) for item in value]
    return value


def number(name: str, value: Any) -> float:
    """One number in the unit of its name."""
    if isinstance(value, str):
        return _native.quantity(name, value)
    given, value = value, bare(name, value)
    if isinstance(value, (bool, bytes)) or getattr(value, "shape", ()) != () or not hasattr(value, "__float__"):
        raise TypeError(f"{name}: a number, a text with its unit or a quantity of pint, not {type(value).__name__}")
    out = float(value)
    if given is value and (said := _native.unlikely(name, out)):
        warned(said, UnitWarning)
    return out


def array(name: str, value: Any) -> NDArray[np.float64]:
    """Numbers in the unit of a name, without a copy where they are such already; masked ones stay masked."""
    import numpy as np

    if isinstance(value, str):
        several = ".." in value or "," in value
        return np.asarray(_native.quantities(name, value) if several else _native.quantity(name, value), dtype=np.float64)
    value = bare(name, value)
    if isinstance(value, (list, tuple)) and any(isinstance(v, str) or hasattr(v, "magnitude") for v in value):
        value = [number(name, item) for item in value]
    given: Any = value if isinstance(value, np.ma.MaskedArray) else np.asarray(value)
    if given.dtype.kind not in "fiu":
        raise TypeError(f"{name}: numbers, a text with its unit or quantities of pint, not {given.dtype}")
    if isinstance(given, np.ma.MaskedArray):
        return given.astype(np.float64)
    out = np.asarray(given, dtype=np.float64)
    return out if out.flags.aligned else out.copy()


def column(values: Any) -> Any:
    """A column: an array of float64, int64 or bool, or a list of texts. Missing numbers are NaN."""
    import numpy as np

    if isinstance(values, np.ma.MaskedArray):
        values = np.where(np.ma.getmaskarray(values), np.nan, values.data) if values.dtype.kind == "f" else values.tolist()
    if isinstance(values, np.ndarray) and values.ndim == 1 and values.dtype.kind in "fiub":
        return values.astype({"f": np.float64, "b": np.bool_}.get(values.dtype.kind, np.int64))
    values = [None if isinstance(v, float) and v != v else v for v in values]
    kinds = {type(v) for v in values}
    if kinds and kinds <= {bool, np.bool_}:
        return np.array(values, dtype=np.bool_)
    if kinds and kinds <= {int, np.int64}:
        return np.array(values, dtype=np.int64)
    if all(v is None or isinstance(v, (int, float, np.integer, np.floating)) and not isinstance(v, bool) for v in values):
        return np.array([np.nan if v is None else v for v in values], dtype=np.float64)
    return [None if v is None else str(v) for v in values]


def columns_of(data: Any) -> dict[str, Any]:
    """The columns of a data frame, of an answer, or of a map in which a single value applies to all rows."""
    if hasattr(data, "to_columns"):
        held: dict[str, Any] = data.to_columns()
        return held
    names = getattr(getattr(data, "dtype", None), "names", None)
    if names:
        # Records, and those with masks.
        data = {name: data[name] for name in names}
    if isinstance(data, Mapping):
        given = {str(name): bare(str(name), values) for name, values in data.items()}
        several = {n: len(v) for n, v in given.items() if hasattr(v, "__len__") and not isinstance(v, str) and getattr(v, "shape", None) != ()}
        if len(set(several.values())) > 1:
            raise ValueError(f"columns of different length: {several}")
        rows = max(several.values(), default=1)
        return {n: column([bare(n, x) for x in v] if isinstance(v, (list, tuple)) else v if n in several else [v] * rows) for n, v in given.items()}
    if hasattr(data, "columns") and hasattr(data, "items"):
        if not data.columns.is_unique:
            raise ValueError("two columns of one name")
        if any(name is not None for name in data.index.names):
            # An index with a name is a column.
            data = data.reset_index()
        return {str(n): column(v.to_numpy() if getattr(v.dtype, "kind", "") in "fiub" and v.notna().all() else v.astype(object).where(v.notna(), None).tolist()) for n, v in data.items()}
    if hasattr(data, "get_columns"):
        return {part.name: column(part.to_list()) for part in data.get_columns()}
    if not hasattr(data, "to_pydict") and hasattr(data, "__arrow_c_stream__"):
        import pyarrow as pa

        data = pa.table(data)
    if hasattr(data, "to_pydict"):
        return {str(name): column(values) for name, values in data.to_pydict().items()}
    raise TypeError(f"a table is a path, a data frame or columns by name, not {type(data).__name__}")


def to_csv(columns: Mapping[str, Any]) -> str:
    """Columns as CSV, numbers with as many digits as it takes to read back the same."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(columns)
    for row in zip(*(values.tolist() if hasattr(values, "tolist") else values for values in columns.values())):
        writer.writerow(["" if v is None or v != v else repr(v) if isinstance(v, float) else str(v).lower() if isinstance(v, bool) else v for v in row])
    return out.getvalue()
