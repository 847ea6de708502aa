"""Answers as objects: what JSON holds, by attribute."""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING, Any, ClassVar

from . import _native
from ._request import put
from ._values import Fixed, column

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes
    from typing_extensions import Self, dataclass_transform
else:
    def dataclass_transform(**_: Any) -> Any:
        return lambda kind: kind

Asked = tuple[str, dict[str, Any]]
# Rows that a notebook shows.
_SHOWN = 20


@dataclass_transform(kw_only_default=True, frozen_default=True)
class Record(Fixed):
    """An answer: a dataclass that does not change; what an answer does not have is None. Two are equal where their fields are.

    ``to_dict()`` is the JSON of the command line. Where an answer holds a table, ``to_columns()`` and ``to_pandas()`` give it, and ``answer["force_n"]`` a column.
    """

    _rows: ClassVar[str | None] = None
    _kinds: ClassVar[dict[str, Any] | None] = None
    if not TYPE_CHECKING:
        def __init__(self, **fields: Any) -> None:
            self.__dict__.update(fields)

    @classmethod
    def _read(cls, data: Mapping[str, Any], asked: Asked | None = None) -> Self:
        """The answer of JSON, and of which question it is."""
        made = object.__new__(cls)
        kinds = cls._nested()
        made.__dict__.update({name + "_" if name in ("from", "import") else name: _wrapped(kinds.get(name), value) for name, value in data.items()})
        made.__dict__["_asked"] = asked
        return made

    @classmethod
    def _nested(cls) -> dict[str, Any]:
        """The records that its fields hold, by the names in their annotations."""
        if "_kinds" not in cls.__dict__:
            known: dict[str, Any] = {}
            for part in reversed(cls.__mro__):
                for name, kind in part.__dict__.get("__annotations__", {}).items():
                    found = re.search(r"\b(?!NDArray|Literal|Any|None|ClassVar)[A-Z]\w+", str(kind))
                    known[name.rstrip("_")] = found and vars(sys.modules[part.__module__]).get(found[0])
            cls._kinds = {name: kind for name, kind in known.items() if isinstance(kind, type) and issubclass(kind, Record)}
        return cls._kinds or {}

    def _fields(self) -> dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if not name.startswith("_")}

    def to_dict(self) -> dict[str, Any]:
        """Plain dicts and lists, as the JSON of the command line."""
        return {name.rstrip("_"): _unwrapped(value) for name, value in self._fields().items() if name != "figure"}

    def to_columns(self) -> dict[str, Any]:
        """The columns of its table: NumPy arrays of numbers, lists of texts. ``polars.DataFrame`` and ``pyarrow.table`` take them."""
        if self._rows is None:
            raise TypeError(f"{type(self).__name__} holds no table")
        held = self.__dict__.get(self._rows) or []
        if isinstance(held, Record):
            return {name: column(values) for name, values in held._fields().items() if isinstance(values, list)}
        return of_rows([row.to_dict() if isinstance(row, Record) else row for row in held])

    def __getitem__(self, name: str) -> Any:
        return self.to_columns()[name]

    def to_pandas(self) -> pandas.DataFrame:
        """Its table as a ``pandas.DataFrame``."""
        import pandas as pd

        return pd.DataFrame(self.to_columns())

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Writes it as JSON, from which :func:`load` reads the same again. Another file that is there is replaced only with ``overwrite``."""
        put({path: json.dumps({"mckibben": type(self).__name__, **self._state()}, ensure_ascii=False)}, overwrite)

    def _state(self) -> dict[str, Any]:
        figure = {"figure": self.__dict__["figure"].to_dict()} if self.__dict__.get("figure") else {}
        return {"data": {**self.to_dict(), **figure}, "asked": self.__dict__.get("_asked")}

    def _key(self) -> Any:
        # The figure is the same facts once more.
        return json.dumps(self.to_dict(), sort_keys=True)

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (type(self), self.__dict__)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in self._fields().items() if name != 'figure')})"

    def __str__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={_short(value)}' for name, value in list(self._fields().items())[:12])})"

    def _repr_html_(self) -> str:
        rows = [(name, _short(value)) for name, value in self._fields().items() if not isinstance(value, (list, dict, Record)) or name == "warnings"]
        body = "".join(f"<tr><th style='text-align:left'>{escape(name)}</th><td>{escape(text)}</td></tr>" for name, text in rows)
        own = f"<table><caption>{type(self).__name__}</caption>{body}</table>"
        return own + (html_of(self.to_columns()) if self._rows and self.__dict__.get(self._rows) else "")

    def plot(self, *, units: str | None = None, ax: Axes | Sequence[Axes] | None = None) -> Any:
        """Draws its figure with matplotlib, the same as ``--plot`` of the command line.

        Parameters
        ----------
        units
            Units to draw in: ``bar``, or ``psi,lbf,in``; MPa, N and mm where they are left out.
        ax
            Axes to draw on, or a list of them, one for each panel; new ones where they are left out.

        Returns
        -------
        matplotlib.axes.Axes or list of them
        """
        from ._plot import drawn

        figure: Any = self.__dict__.get("figure")
        asked: Any = self.__dict__.get("_asked")
        if asked is None and figure is None or not hasattr(type(self), "figure"):
            raise TypeError(f"{type(self).__name__} has no figure")
        return drawn(figure.to_dict() if figure and units is None else _native.ask(asked[0], {**asked[1], "figure": units or "MPa"})["figure"], ax)


def _restored(kind: type[Record], state: dict[str, Any]) -> Record:
    made = object.__new__(kind)
    made.__dict__.update(state)
    return made


def _wrapped(kind: Any, value: Any) -> Any:
    if kind is None or value is None:
        return value
    if isinstance(value, dict):
        # A map of names to records is no record itself.
        names = {name for part in kind.__mro__ for name in part.__dict__.get("__annotations__", ())}
        return kind._read(value) if not value or {name if name in names else name + "_" for name in value} & names else {name: _wrapped(kind, item) for name, item in value.items()}
    return [_wrapped(kind, item) for item in value] if isinstance(value, list) else value


def _unwrapped(value: Any) -> Any:
    if isinstance(value, Record):
        return value.to_dict()
    if isinstance(value, dict):
        return {name: _unwrapped(item) for name, item in value.items()}
    return [_unwrapped(item) for item in value] if isinstance(value, list) else value


def _short(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list):
        return f"[{len(value)} items]" if len(value) > 3 or any(isinstance(v, (dict, list, Record)) for v in value) else "[" + ", ".join(map(_short, value)) + "]"
    if isinstance(value, (dict, Record)):
        return type(value).__name__ if isinstance(value, Record) else f"{{{len(value)} fields}}"
    text = repr(value)
    return text if len(text) <= 80 else text[:79] + "…"


def of_rows(rows: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """The columns of rows; values that are lists or maps themselves are left out."""
    names = dict.fromkeys(name for row in rows for name, value in row.items() if not isinstance(value, (list, dict)))
    return {name: column([row.get(name) for row in rows]) for name in names}


def html_of(columns: Mapping[str, Any]) -> str:
    """The first rows of a table for a notebook."""
    def cell(value: Any) -> str:
        return "" if value is None or value != value else f"{value:.6g}" if isinstance(value, float) else escape(str(value))

    head = "".join(f"<th>{escape(name)}</th>" for name in columns)
    body = "".join("<tr>" + "".join(f"<td>{cell(v)}</td>" for v in row) + "</tr>" for row in zip(*(values[:_SHOWN] for values in columns.values())))
    count = len(next(iter(columns.values()), ()))
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>" + (f"<p>{count - _SHOWN} rows more</p>" if count > _SHOWN else "")
