"""What users give: numbers in the unit of their name, texts with a unit, quantities of pint, arrays, tables, files; and requests of these, in the words of JSON."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Protocol, TypeVar, Union

from . import _native
from ._errors import (
    TABLES,
    ExistingFileError,
    MckibbenError,
    InputError,
    blamed,
    checked,
    warned,
    wrong_type,
)

if TYPE_CHECKING:
    # Twice: other modules take it from here under its own name.
    import numpy as np, numpy as numpy
    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import Self

    from ._muscle import Muscle
    from ._parts import Formula, Rubber
    from ._record import Record

    class Measured(Protocol):
        """A quantity of pint."""

        @property
        def magnitude(self) -> Any: ...
        def to(self, unit: Any, /) -> Any: ...

    Answer = TypeVar("Answer", bound=Record)
    # An object of JSON, and values by name, such as arguments.
    Json = dict[str, Any]
    Named = Mapping[str, Any]
    # A number in the unit of its name, a text with its unit, or a quantity of pint.
    Number = float | str | Measured
    # Several; a text may be a range with both ends in, such as "0..2.5:0.5 bar".
    Numbers = Sequence[Number] | NDArray[np.floating[Any]] | str | Measured
    # What a search goes through: one value, a list of values, or all between the two of a tuple or of "30..50 mm".
    Choice = Number | Numbers | Mapping[str, Number]
    # What a table of a request, and an option, may hold.
    Plain = Union[None, bool, Number, Numbers, Sequence["Plain"], Mapping[str, "Plain"]]
    # What a model is asked for: anything that NumPy reads as numbers, texts with a unit, quantities of pint.
    Floats = ArrayLike | Number | Numbers
    PathLike = str | os.PathLike[str]
    # A path, or the content of the file as {"name": …, "text": …}.
    FileLike = PathLike | Mapping[str, str]
    # The same, or a data frame, an answer with a table, or columns by name.
    TableLike = Any
    FormulaLike = Union[FileLike, Formula]
    MuscleLike = Union[FileLike, Muscle]
    RubberLike = Union[FileLike, Rubber]
    # True for a line on standard error, or a function that is called with (done, total).
    Progress = bool | Callable[[int, int], object] | None
    Array = NDArray[np.float64]
    # Whether a point without an answer is an exception, or NaN.
    Errors = Literal["raise", "nan"]
else:

    class _NumPy:
        """NumPy, which is imported with the first array, not with the package."""

        def __getattr__(self, name: str) -> Any:
            import numpy

            found = self.__dict__[name] = getattr(numpy, name)
            return found

    np = numpy = _NumPy()

_NUMBERS = "numbers, a text with its unit or quantities of pint"
# What a design searches through.
CHOICES = ("outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "radius_mm")


class Fixed:
    """An object that does not change; two are equal where they are of one class and have one key."""

    def _hold(self, **values: Any) -> Self:
        self.__dict__.update(values)
        return self

    def _key(self) -> Any:
        raise NotImplementedError

    def _saved(self, path: Any) -> Any:
        return {path: self._key()}

    def save(self, path: PathLike, *, overwrite: bool = False) -> None:
        """Writes its file, and beside it those that it names, from which :func:`load` reads it again. Other files that are there are replaced only with ``overwrite``."""
        put(self._saved(path), overwrite)

    def __eq__(self, other: Any) -> bool:
        return type(self) is type(other) and bool(self._key() == other._key())

    def __hash__(self) -> int:
        return hash((type(self).__name__, self._key()))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a {type(self).__name__} does not change: {name}")

    def __delattr__(self, name: str) -> None:
        setattr(self, name, None)


class Saved(Fixed):
    """An object whose key is the text of its file."""

    def __reduce__(self: Any) -> Any:
        return type(self).from_toml, (self._key(),)


def unit_for_pint(name: str) -> str:
    """The unit of a name as pint writes it."""
    unit = _native.unit_of(name) or "dimensionless"
    return re.sub(r"(?<=[a-z])[23]", r"**\g<0>", unit)


def bare(name: str, value: Any) -> Any:
    """The magnitude of a quantity of pint, or of a DataArray that states its units, in the unit of a name; anything else as it is."""
    if hasattr(value, "dims") and (unit := value.attrs.get("units")):
        return value * _native.quantity(name, f"1 {unit}")
    if not (hasattr(value, "magnitude") and hasattr(value, "to")):
        return value
    unit = unit_for_pint(name)
    try:
        return value.to(unit).magnitude
    except Exception as error:
        said = f"{value} is not in {unit}: {error}"
        raise InputError(said, kind="quantity", field=name) from None


def plain(name: str, value: Any) -> Any:
    """An argument as JSON has it: quantities of pint in the unit of their name, arrays as lists, objects as their files; texts with a unit and paths stay,
    the program reads them.
    """
    if isinstance(value, Saved):
        return {"name": getattr(value, "name", name), "text": value._key()}
    value = bare(name, value)
    if hasattr(value, "dims"):
        value = value.values
    if hasattr(value, "tolist") and (value := value.tolist()) is None:
        raise wrong_type(name, "a number or text", value)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Mapping):
        # What is a muscle, a model or another object by its name or file.
        for key in {"name", "file"} & set(value):
            if isinstance(value[key], (int, float, list, tuple)):
                raise wrong_type(name, "a name, a path or an object", value[key])
        return {
            str(key): plain(str(key) if _native.unit_of(str(key)) else name, item)
            for key, item in value.items()
            if item is not None
        }
    if isinstance(value, (list, tuple, range)):
        return [plain(name, item) for item in value]
    if value is not None and not isinstance(value, (str, int, float)):
        raise wrong_type(name, "a number or text", value)
    return value


def number(name: str, value: Any) -> float:
    """One number in the unit of its name."""
    if isinstance(value, str):
        return _native.quantity(name, value)
    found = bare(name, value)
    if (
        isinstance(found, (bool, bytes))
        or getattr(found, "shape", ()) != ()
        or not hasattr(found, "__float__")
    ):
        raise wrong_type(name, _NUMBERS, found)
    out = float(found)
    if found is value and (said := _native.unlikely(name, out)):
        warned(said)
    return out


def array(name: str, value: Any) -> Array:
    """Numbers in the unit of a name, without a copy where they are such already; masked ones stay masked."""
    if isinstance(value, str):
        several = ".." in value or "," in value
        read = _native.quantities if several else _native.quantity
        return np.asarray(read(name, value), np.float64)
    own, value = value, bare(name, value)
    if hasattr(value, "is_symbolic"):
        raise wrong_type(name, _NUMBERS, value)
    # Texts, also in an array or a Series, and quantities of pint.
    kind = getattr(getattr(value, "dtype", None), "kind", None)
    items = value.tolist() if kind in ("O", "U") else value
    if isinstance(items, (list, tuple)) and any(
        v is None or isinstance(v, str) or hasattr(v, "magnitude") for v in items
    ):
        value = [np.nan if item is None else number(name, item) for item in items]
    given = (np.asanyarray if np.ma.isMA(value) else np.asarray)(value)
    if given.dtype.kind not in "fiu":
        raise wrong_type(name, _NUMBERS, value)
    out = np.require(given, np.float64, "A")
    highest = float(np.nanmax(np.ma.filled(out, 0.0), initial=0.0))
    if value is own and (said := _native.unlikely(name, highest)):
        warned(said)
    return out


def arrays(
    *given: tuple[str, Any], missing: float = 0.0
) -> tuple[list[Array], Callable[[str, Any], Any]]:
    """Arrays of named values, with a number where one of them is masked, and what puts their labels on an answer of a name: the mask; dimensions and coordinates of
    xarray, by which values are broadcast, or the index of pandas; both are to be the same. An answer without a dimension is a number.

    What is masked is asked as the muscle at rest, which every model answers.
    """
    if any(hasattr(value, "dims") for _, value in given):
        import xarray as xr

        held = [
            bare(name, value)
            if hasattr(value, "dims")
            else xr.DataArray(number(name, value))
            for name, value in given
        ]
        try:
            values = xr.broadcast(*xr.align(*held, join="exact"))
        except ValueError as error:
            raise InputError(str(error), field=given[0][0]) from None
        own = values[0]

        def labelled(name: str, found: Any) -> Any:
            dims = [*own.dims, "derivative"][: found.ndim]
            units = {"units": u} if (u := _native.unit_of(name)) else {}
            return xr.DataArray(found, own.coords, dims, name, units)

        return [array(n, v.values) for (n, _), v in zip(given, values)], labelled
    first = None
    for name, value in given:
        # An index of pandas has no index.
        if hasattr(value, "to_frame") and hasattr(value, "index"):
            first = value if first is None else first
            if not value.index.equals(first.index):
                raise InputError("another index", field=name)

    found = [array(name, value) for name, value in given]
    try:
        np.broadcast_shapes(*(values.shape for values in found))
    except ValueError as error:
        raise InputError(str(error), field=given[-1][0]) from None
    mask = None
    if any(map(np.ma.isMA, found)):
        mask = sum(np.ma.getmaskarray(values) for values in found) > 0
        found = [np.where(mask, missing, np.ma.getdata(values)) for values in found]

    def indexed(name: str, answer: Any) -> Any:
        if mask is not None:
            answer = np.ma.array(answer, mask=False)
            answer[mask] = np.ma.masked
        if not answer.ndim:
            return float(answer)
        if first is None or answer.ndim > 1:
            return answer
        return type(first)(answer, first.index, name=name)

    return found, indexed


def ask(
    command: str, request: Mapping[str, Any] | None = None, *, progress: Progress = None
) -> dict[str, Any]:
    """The answer to a request in the words of JSON: dicts in, dicts out.

    Parameters
    ----------
    command
        Its name: the words of the command line, joined by a hyphen, such as ``force`` or ``parts-list``.
    request
        What ``mckibben schema`` says: numbers in mm, MPa, N and degrees, or texts with their unit.
    progress
        True for a line on standard error, or a function that is called with (done, total).

    Raises
    ------
    InputError
        The request is wrong: `field` names what.
    NoAnswerError
        There is no answer.
    NotConvergedError
        It was not found, or the work was cancelled.

    Examples
    --------
    >>> import mckibben as mk
    >>> round(mk.ask("force", {"pressure_mpa": "2 bar", "contraction": 0.1, "model": "ideal"})["force_n"], 1)
    573.7
    """
    asked = checked("request", request or {}, Mapping)
    given = _native.given(checked("command", command, str), asked)
    return _native.ask(command, given, heard(progress, command))


def answered(
    kind: type[Answer],
    command: str,
    given: Json,
) -> Answer:
    """The answer to a command with these arguments."""
    from ._api import KEYS, Measures

    progress = heard(given.pop("progress", None), command)
    me = given.pop("self", None)
    if "measures" in given:
        measures = known(given.pop("measures"), Measures)
        given["muscle"] = {"file": given["muscle"], **measures}
    if "model" in given:
        given = modelled(given, command)
    own = me._files(command) if me else {}
    request = _native.given(command, fields({**own, **given}))
    # To draw takes less than to ask again; a curve is drawn when it is wanted.
    if hasattr(kind, "figure") and command != "curve":
        request["figure"] = command == "rubber" or "MPa"
    try:
        found = _native.ask(command, request, progress)
    except MckibbenError as error:
        # What is in quotes is what was given, and a measure is named by its key.
        quoted = re.split('["`]', error.message)[1:2]
        muscle = given.get("muscle")
        measures = muscle if isinstance(muscle, Mapping) else {}
        for name, value in {**given, **measures}.items():
            items = value if isinstance(value, (list, tuple)) else [value]
            is_quoted = any(str(item) in quoted for item in items)
            if error.field == KEYS.get(name, "") or (is_quoted and not error.field):
                error.field = name
        raise
    return kind._read(found, (command, request))


def fields(given: Named) -> Json:
    """Arguments as the fields of a request; what is not given is left to the program."""
    out = {}
    for argument, value in given.items():
        name = argument.rstrip("_")
        if value is None:
            continue
        if name in TABLES:
            items = value if isinstance(value, (list, tuple)) else [value]
            with blamed(name):
                held = [table(item, name) for item in items]
            # The program takes one for a list of one.
            out[name] = held[0] if len(held) == 1 else held
        elif name in CHOICES and isinstance(value, tuple) and len(value) == 2:
            out[name] = dict(zip(("low", "high"), plain(name, value)))
        else:
            out[name] = plain(name, value)
    return out


def modelled(given: Named, command: str = "force") -> Json:
    """Arguments, those of the model as the one object that the request of a command has, and the branch under its field."""
    out = dict(given)
    model = {"name": out.pop("model", None)}
    model |= {n: out.pop(n, None) for n in ("mesh", "match", "terminal")}
    branch = out.pop("branch", None)
    by = "branches" if command == "identify" else "direction"
    if (command, branch) == ("curve", "both"):
        by, branch = branch, True
    return {**out, by: branch, "model": model}


def known(given: Named, kind: Any) -> Named:
    """Keywords, of which each is one of a class of keywords."""
    there = kind.__annotations__
    for name in given.keys() - there:
        said = f"unexpected keyword argument {name!r}; there is {', '.join(there)}"
        raise TypeError(said)
    return given


def is_nan(errors: str) -> bool:
    """Whether a point without an answer is NaN; else it raises."""
    if errors not in ("raise", "nan"):
        raise InputError(f'"raise" or "nan", not {errors!r}', field="errors")
    return errors == "nan"


def heard(progress: Progress, what: str) -> Callable[[int, int], object] | None:
    """The function that hears of progress: the caller's own, or one that writes a line on standard error."""
    if progress is not True:
        return progress or None
    return lambda done, total: print(
        f"\r{what}: {done} of {total}",
        end="\n" if done == total else "",
        file=sys.stderr,
        flush=True,
    )


def listed(values: Named) -> str:
    """Values by name, as in a call."""
    return ", ".join(f"{name}={value!r}" for name, value in values.items())


def screen(text: str) -> str:
    """Not more than a screen of a text."""
    return text if len(text) <= 1000 else text[:999] + "…"


def place(name: str, path: Any) -> Any:
    """A path as text."""
    return os.fspath(checked(name, path, str, os.PathLike))


def put(files: Mapping[Any, str | bytes], overwrite: bool = False) -> None:
    """Puts files at their places, each whole or not at all, and none where another file would be lost: one that is neither empty nor the same."""
    contents = {
        place("path", path): content.encode() if isinstance(content, str) else content
        for path, content in files.items()
    }
    for path, content in contents.items():
        is_other = not overwrite and os.path.isfile(path)
        if is_other and Path(path).read_bytes() not in (b"", content):
            said = f"{path} is another file and would be overwritten"
            hint = "or overwrite=True"
            raise ExistingFileError(said, kind="output", field="path", hint=hint)
    for path, content in contents.items():
        with blamed("path"):
            _native.write_file(path, content)


def table(value: Any, name: str = "data") -> dict[str, str]:
    """A table: a path, its text, a data frame, an answer, or columns by name."""
    if isinstance(value, Mapping) and set(value) == {"name", "text"}:
        return dict(value)
    if isinstance(value, (str, os.PathLike)):
        return _native.read(value, "table")
    return {"name": name, "text": to_csv(value, name)}


def column(values: Sequence[Any]) -> Any:
    """A column: an array of float64, int64 or bool, or a list of texts. Missing numbers are NaN."""
    given = np.array([v for v in values if v is not None])
    kind, is_whole = given.dtype.kind, len(given) == len(values)
    if kind in "if" or (kind == "b" and is_whole):
        return given if is_whole else np.array(values, dtype=np.float64)
    return [None if v is None else str(v) for v in values]


def to_csv(data: Any, field: str) -> str:
    """A data frame, records, an answer, or columns of which a single value applies to all rows, as CSV with as many digits as it takes to read back the same."""
    import csv
    import io

    if hasattr(data, "to_columns"):
        data = data.to_columns()
    if hasattr(data, "write_csv"):
        return str(data.write_csv())
    if hasattr(data, "to_csv"):
        # An index with a name is a column.
        return str(data.to_csv(index=set(data.index.names) != {None}))
    if names := getattr(getattr(data, "dtype", None), "names", None):
        data = {name: data[name] for name in names}
    elif hasattr(data, "__arrow_c_stream__"):
        import pyarrow as pa

        data = pa.table(data).to_pydict()
    if not isinstance(data, Mapping):
        raise wrong_type(field, "a path, a data frame or columns by name", data)
    given = {str(name): plain(str(name), values) for name, values in data.items()}
    several = {n: len(held) for n, held in given.items() if isinstance(held, list)}
    if len(set(several.values())) > 1:
        raise InputError(f"columns of different length: {several}", field=field)
    rows = max(several.values(), default=1)
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(given)
    columns = (v if name in several else [v] * rows for name, v in given.items())
    writer.writerows([None if v != v else v for v in row] for row in zip(*columns))
    return out.getvalue()
