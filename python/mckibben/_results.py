"""Answers that can do more than hold their fields."""

from __future__ import annotations

import base64
import csv
import io
import json
import os
from collections.abc import Callable
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _answers, _native
from ._errors import NoAnswerError, of as problem
from ._files import put
from ._formula import Formula
from ._record import Record
from ._rubber import Rubber
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
        data = _native.ask(command, request, heard)
        return _columned(cls, data, (command, request), cls._read(data))

    @staticmethod
    def _read(data: dict[str, Any]) -> Table:
        """The points, taken out of an answer."""
        raise NotImplementedError

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

    Every column of its points is an attribute, a NumPy array over all points, curve after curve: ``curve.pressure_mpa``, ``curve.force_n``, … A point without
    an answer is NaN, and ``curve.status`` and ``curve.cause`` say why.
    """

    __slots__ = ()

    @staticmethod
    def _read(data: dict[str, Any]) -> Table:
        rows, fixed = data.pop("points"), data["fixed"]
        if all(row["status"] != "ok" for row in rows):
            raise problem({"kind": rows[0]["status"], "message": rows[0]["cause"], "hint": ""})
        rows = [{"fixed": fixed[i * len(fixed) // len(rows)], **row} for i, row in enumerate(rows)]
        for row in rows:
            row.pop("model", None)
            row.setdefault("slack", False)
        return Table.from_rows(rows)

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

    @staticmethod
    def _read(data: dict[str, Any]) -> Table:
        rows = list(csv.DictReader(io.StringIO(data["table"]["text"])))
        return Table({name: [row[name] if name == "status" else float(row[name] or "nan") for row in rows] for name in (rows or [{}])[0]})

    def __repr__(self) -> str:
        return f"Plan({self.muscles} muscles, {self._data['points']} points, {self.failed} failed)"


class Fitted(_answers.FitAnswer):
    """A fitted formula with all that is known of it."""

    __slots__ = ()

    def __repr__(self) -> str:
        errors = (self._data.get("errors") or {}).get("fit") or {}
        share = f", rms {100 * errors['rms_of_blocked']:.2g} % of the blocked force" if errors.get("rms_of_blocked") is not None else ""
        return f"Fitted({self._data['name']}: {self._data['kind']}, {(self._data.get('provenance') or {}).get('points', 0)} points{share})"

    @property
    def formula(self) -> Formula:
        """The formula, which is a model and a file."""
        text = json.dumps({n: v for n, v in self._data.items() if n not in ("tables", "figures")}, ensure_ascii=False, indent=2)
        return Formula(text + "\n", str(self._data["name"]))

    def table(self, name: str) -> Table:
        """One of the intermediate tables that ``fit(…, tables=True)`` asks for, by its name."""
        held = {table["name"]: table for table in self._data.get("tables") or []}
        if name not in held:
            raise KeyError(f"{name}: there is {', '.join(held) or 'no table'}")
        return Table(dict(zip(held[name]["header"], zip(*held[name]["rows"]))))


class Fit(Record):
    """Values found by least squares, as other packages name them."""

    __slots__ = ()

    def _found(self) -> list[dict[str, Any]]:
        found: list[dict[str, Any]] = self._data["parameters"]
        return found

    @property
    def names(self) -> list[str]:
        """The names of the values."""
        return [str(p["name"]) for p in self._found()]

    @property
    def x(self) -> NDArray[np.float64]:
        """The values found."""
        return np.array([p["value"] for p in self._found()], dtype=np.float64)

    @property
    def stderr(self) -> NDArray[np.float64]:
        """Their standard errors; NaN where the data does not determine one."""
        return np.array([np.nan if p.get("standard_error") is None else p["standard_error"] for p in self._found()], dtype=np.float64)

    def _words(self) -> list[str]:
        def word(p: dict[str, Any], error: float) -> str:
            unit = f" {p['unit']}" if p.get("unit") else ""
            return f"{p['name']} {p['value']:.5g}{unit}" if np.isnan(error) else f"{p['name']} {p['value']:.5g} ± {error:.3g}{unit}"

        half = [p.get("half_width_95") for p in self._found()]
        return [word(p, np.nan if h is None else h) for p, h in zip(self._found(), half)]


class _Files(Record):
    """An answer of files."""

    __slots__ = ()

    def save(self, folder: str | os.PathLike[str], *, overwrite: bool = False) -> Path:  # type: ignore[override]
        """Writes the files into a folder, and gives the one to begin with. Another file that is there is replaced only with ``overwrite``."""
        place = Path(folder)
        contents: dict[str | os.PathLike[str], str | bytes] = {place / file.name: base64.b64decode(file.base64) if file.base64 is not None else str(file.text) for file in self.files}
        place.mkdir(parents=True, exist_ok=True)
        put(contents, overwrite)
        return Path(next(iter(contents)))


class Build(_Files, _answers.BuildAnswer):
    """What is needed to build a muscle. Its table has one row for each part."""

    __slots__ = ()


class Export(_Files, _answers.ExportAnswer):
    """A muscle for a controller or a simulator. Its table has one row for each file."""

    __slots__ = ()


class RubberFit(Fit, _answers.RubberFitAnswer):
    """Laws fitted to tests of a rubber. Its table has one row for each law; ``x``, ``names`` and ``stderr`` are those of the recommended one."""

    __slots__ = ()

    def _found(self) -> list[dict[str, Any]]:
        return self._data.get("parameters") or []

    def summary(self) -> str:
        """What was found, in lines for reading."""
        head = f"{self.points} points to a stretch of {self.fitted_to_stretch:.3g}; recommended: {self.recommended or 'none'}"
        errors = [f"  {w}" + ("" if np.isnan(e) else f" (standard error {e:.2g})") for w, e in zip(self._words(), self.stderr)]
        laws = [f"  {law.name}: rms {law.rms_mpa:.3g} MPa, {'stable' if law.stable else 'not stable'}" for law in self.laws]
        return "\n".join([head, *errors, "laws:", *laws])

    def __repr__(self) -> str:
        return f"RubberFit({self.recommended or 'no stable law'}: {', '.join(self._words())}; {self.points} points)"

    def rubber(self, law: str | None = None) -> Rubber:
        """A law with its constants; the recommended one where none is named."""
        name = law or self.recommended
        if name is None:
            raise NoAnswerError("no law is stable in a muscle", kind="no_answer", hint="name one")
        for found in self.laws:
            if name in (found.name, found.law):
                constants: dict[str, Any] = {}
                for p in found.parameters:
                    constant = p.name.rsplit(".", 1)[-1]
                    # The terms of Ogden's law are in lists: mu1, mu2 are mu = […].
                    if found.law == "ogden":
                        constants.setdefault(constant.rstrip("0123456789"), []).append(p.value)
                    else:
                        constants[constant] = p.value
                return Rubber(found.law, **constants)
        raise KeyError(name)


class Shape(_answers.ShapeAnswer):
    """The deformed muscle. In a notebook it is shown in space."""

    __slots__ = ()

    def array(self, name: str) -> NDArray[np.float64]:
        """What there is at the nodes, as an array of stations and nodes through the wall; of the strands, one number for each station."""
        values = np.asarray(self._data["arrays"][name], dtype=np.float64)
        return values.reshape(self.stations, -1) if values.size == self.stations * self.across else values

    def to_html(self) -> str:
        """A page with the muscle in space, to rotate with the mouse, for use offline."""
        if self._asked is None:
            raise AttributeError("a shape that was not asked for has no page")
        return _native.body_html(self._asked[1])

    def _frame(self) -> str:
        page = escape(self.to_html(), quote=True)
        return f'<iframe srcdoc="{page}" style="width:100%;max-width:760px;height:430px;border:0" sandbox="allow-scripts" title="muscle"></iframe>'

    def _repr_html_(self) -> str:
        return self._frame() + super()._repr_html_()


_answers.OWN.update({kind.__name__: kind for kind in (Curve, Plan, Fitted, Build, Export, RubberFit, Shape)})
