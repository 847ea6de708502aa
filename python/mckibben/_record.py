"""Answers as objects: what JSON holds, by attribute."""

from __future__ import annotations

import copy
import json
import os
from collections.abc import Callable, Iterator, Sequence
from difflib import get_close_matches
from html import escape
from typing import TYPE_CHECKING, Any, ClassVar

from . import _native, _quantity, _schema
from ._files import put
from ._plot import drawn
from ._table import Fixed, Table, Tabled

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def restored(kind: type[Record], data: dict[str, Any], asked: tuple[str, dict[str, Any]] | None) -> Record:
    """The record that was pickled."""
    return kind(data, asked)


class Record(Fixed, Tabled):
    """An answer: its fields are attributes; what an answer does not have is None.

    Two records are equal where their fields are. ``to_dict()`` gives plain dicts and lists, the same as the JSON of the command line.
    Where an answer holds a table, ``to_table()`` and ``to_pandas()`` give it.
    """

    __slots__ = ("_asked", "_data")
    _fields_: ClassVar[tuple[str, ...]] = ()
    _nested_: ClassVar[dict[str, Callable[[], type[Record]]]] = {}
    _rows_: ClassVar[str | None] = None
    _data: dict[str, Any]
    _asked: tuple[str, dict[str, Any]] | None

    def __init__(self, data: dict[str, Any], asked: tuple[str, dict[str, Any]] | None = None) -> None:
        object.__setattr__(self, "_data", data)
        object.__setattr__(self, "_asked", asked)

    @classmethod
    def _asked_for(cls, command: str, request: dict[str, Any], heard: Callable[[int, int], object] | None) -> Any:
        return cls(_native.ask(command, request, heard), (command, request))

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        if name in self._data:
            return self._shown(name)
        if name in self._fields_:
            return None
        near = get_close_matches(name, {*self._fields_, *self._data}, 1)
        raise AttributeError(f"{type(self).__name__} has no field {name!r}" + (f"; did you mean {near[0]!r}?" if near else ""))

    def _shown(self, name: str) -> Any:
        value, kind = self._data[name], self._nested_.get(name)
        if kind is None or value is None:
            return _quantity.dressed(name, value) if type(value) is float and _quantity.REGISTRY is not None else value
        return _wrapped(kind(), value)

    def __getitem__(self, name: str) -> Any:
        if name not in self._data and name not in self._fields_:
            raise KeyError(name)
        return getattr(self, name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._data)

    def __contains__(self, name: object) -> bool:
        return name in self._data

    def keys(self) -> list[str]:
        """The fields that this answer has."""
        return list(self._data)

    def to_dict(self) -> dict[str, Any]:
        """Plain dicts and lists."""
        return copy.deepcopy(self._data)

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Writes it as JSON, from which :func:`load` reads the same again. Another file that is there is replaced only with ``overwrite``."""
        put({path: json.dumps({"mckibben": type(self).__name__, **self._state()}, ensure_ascii=False)}, overwrite)

    def _state(self) -> dict[str, Any]:
        return {"data": self._data, "asked": self._asked}

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._fields_})

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and isinstance(other, Record) and self._key() == other._key()

    def __hash__(self) -> int:
        return hash((type(self).__name__, self._key()))

    def _key(self) -> Any:
        # The figure is the same facts once more.
        return json.dumps({k: v for k, v in self._data.items() if k != "figure"}, sort_keys=True)

    def __reduce__(self) -> tuple[Any, ...]:
        return restored, (type(self), self._data, self._asked)

    def __repr__(self) -> str:
        parts, length = [], 0
        for name in self._data:
            part = f"{name}={_short(self._data[name])}"
            length += len(part)
            if length > 400:
                parts.append("…")
                break
            parts.append(part)
        return f"{type(self).__name__}({', '.join(parts)})"

    def _repr_html_(self) -> str:
        rows = [(name, _short(value)) for name, value in self._data.items() if not isinstance(value, (list, dict)) or name == "warnings"]
        out = "".join(f"<tr><th style='text-align:left'>{escape(name)}</th><td>{escape(text)}</td></tr>" for name, text in rows)
        own = f"<table><caption>{type(self).__name__}</caption>{out}</table>"
        return own + (self.to_table()._repr_html_() if self._rows_ and self._data.get(self._rows_) else "")

    def to_table(self) -> Table:
        """The answer's table, its columns named as the fields of its rows."""
        if self._rows_ is None:
            raise AttributeError(f"{type(self).__name__} holds no table")
        held = self._data.get(self._rows_)
        # Of lists by name; what is no list is left out.
        return Table({name: values for name, values in held.items() if isinstance(values, list)}) if isinstance(held, dict) else Table.from_rows(held or [])

    def plot(self, *, units: str | None = None, ax: Axes | Sequence[Axes] | None = None) -> Any:
        """Draws the figure of this answer with matplotlib, the same as ``--plot`` of the command line.

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
        return drawn(self._figure(units), ax)

    def _figure(self, units: str | None) -> dict[str, Any]:
        figure = self._data.get("figure")
        if figure is not None and units is None:
            return dict(figure)
        command, request = self._asked or ("", {})
        wanted = _schema.figure_in(command, units or "MPa") if command else None
        if wanted is None:
            raise AttributeError(f"{type(self).__name__} has no figure")
        figure = _native.ask(command, {**request, "figure": wanted}).get("figure")
        if figure is None:
            raise AttributeError(f"there is no figure of this {type(self).__name__}")
        return dict(figure)


def _wrapped(kind: type[Record], value: Any) -> Any:
    if isinstance(value, dict):
        # A map of names to records is no record itself.
        if kind._fields_ and not set(value) & set(kind._fields_):
            return {name: _wrapped(kind, item) for name, item in value.items()}
        return kind(value)
    if isinstance(value, list):
        return [_wrapped(kind, item) for item in value]
    return value


def _short(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list):
        return f"[{len(value)} items]" if len(value) > 3 or any(isinstance(v, (dict, list)) for v in value) else "[" + ", ".join(map(_short, value)) + "]"
    if isinstance(value, dict):
        return f"{{{len(value)} fields}}"
    text = repr(value)
    return text if len(text) <= 80 else text[:79] + "…"
