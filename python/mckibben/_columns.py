"""Answers whose points are columns of numbers."""

from __future__ import annotations

from collections.abc import Callable
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _answers, _native
from ._record import Record
from ._table import Table

if TYPE_CHECKING:
    from numpy.typing import NDArray

Heard = Callable[[int, int], object] | None


class _Columned(Record):
    """An answer whose points are columns of numbers; each is an attribute."""

    __slots__ = ("_points",)
    _points: Table

    @classmethod
    def _asked_for(cls, command: str, request: dict[str, Any], heard: Heard) -> Any:
        head, columns = getattr(_native, command)(request, heard)
        return _columned(cls, head, (command, request), Table._of(columns))

    def to_table(self) -> Table:
        """The points as a table."""
        return self._points

    def __getattr__(self, name: str) -> Any:
        if not name.startswith("_") and name not in self._data and name in self._points:
            return self._points[name]
        return super().__getattr__(name)

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._points.columns})

    def _key(self) -> Any:
        return super()._key(), self._points._key()

    def _state(self) -> dict[str, Any]:
        def plain(values: Any) -> list[Any]:
            return [None if v != v else v for v in (values.tolist() if isinstance(values, np.ndarray) else values)]

        return {**super()._state(), "points": {name: plain(self._points[name]) for name in self._points}}

    def __reduce__(self) -> tuple[Any, ...]:
        return _columned, (type(self), self._data, self._asked, self._points)

    def _repr_html_(self) -> str:
        return f"<p>{escape(repr(self))}</p>{self._points._repr_html_()}"


def _columned(kind: type[_Columned], data: dict[str, Any], asked: Any, points: Table) -> _Columned:
    answer = kind(data, asked)
    object.__setattr__(answer, "_points", points)
    return answer


class Curve(_Columned, _answers.CurveAnswer):
    """A family of curves, its points as columns of numbers.

    Every column of its points is an attribute: ``curve.pressure_mpa``, ``curve.contraction``, ``curve.force_n``, ``curve.volume_mm3``, …
    are NumPy arrays over all points, curve after curve; a point without an answer is NaN, and ``curve.status`` and ``curve.cause``
    say why. ``curve.grid("force_n")`` has one row for each curve.
    """

    __slots__ = ()

    @property
    def points(self) -> list[_answers.PointRow]:  # type: ignore[override]
        """The points as records, which are made anew each time; the columns are faster."""
        return [_answers.PointRow(row) for row in self._points.rows()]

    def grid(self, column: str) -> NDArray[np.float64]:
        """A column with one row for each curve."""
        values: NDArray[np.float64] = np.asarray(self._points[column])
        return values.reshape(-1, len(self._points) // max(1, len(np.unique(self._points["fixed"])) if not self.fixed else len(self.fixed)))

    def to_dict(self) -> dict[str, Any]:
        """Plain dicts and lists, the points as rows."""
        return {**super().to_dict(), "points": self._points.rows()}

    def __repr__(self) -> str:
        return f"Curve({self.test}, model={self.model!r}, {len(self.fixed or [])} curves, {len(self._points)} points)"


class Plan(_Columned, _answers.PlanAnswer):
    """A plan that was computed, its points as columns: ``plan.pressure_mpa``, ``plan.force_n``, ``plan.status``, … ``fit(plan)`` makes a
    formula of them.
    """

    __slots__ = ()

    @property
    def table(self) -> _answers.TextFile:  # type: ignore[override]
        """The points as the text of a file (CSV)."""
        return _answers.TextFile({**self._data["table"], "text": self._points.to_csv()})

    def to_dict(self) -> dict[str, Any]:
        """Plain dicts and lists, the points as the text of a file."""
        return {**super().to_dict(), "table": self.table.to_dict()}

    def __repr__(self) -> str:
        return f"Plan({self.muscles} muscles, {self._data['points']} points, {self.failed} failed)"
