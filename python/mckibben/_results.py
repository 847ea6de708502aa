"""Answers that can do more than hold their fields."""

from __future__ import annotations

import base64
import os
from collections.abc import Callable
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _answers, _native
from ._base import named
from ._columns import Curve as Curve
from ._columns import Plan as Plan
from ._files import put
from ._problem import NoAnswerError
from ._record import Record
from ._table import Table

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._formula import Formula
    from ._inputs import Floats
    from ._muscle import Muscle
    from ._parts import Rubber
    from ._points import Outside

Heard = Callable[[int, int], object] | None


class Design(_answers.DesignAnswer):
    """Ranked muscles, and why others fail. Its table has one row for each candidate, best first."""

    __slots__ = ("_muscles",)
    _muscles: list[str]

    @classmethod
    def _asked_for(cls, command: str, request: dict[str, Any], heard: Heard) -> Design:
        data, muscles = _native.design(request, heard)
        return _design(data, (command, request), muscles)

    @property
    def muscles(self) -> list[Muscle]:
        """The candidates as muscles, best first."""
        return [named("Muscle").from_toml(text) for text in self._muscles]

    @property
    def best(self) -> Muscle:
        """The first of them."""
        if not self._muscles:
            raise NoAnswerError("no muscle fits", kind="no_answer", hint="`closest` and `rejected` say why", exit_code=1)
        return self.muscles[0]

    def __reduce__(self) -> tuple[Any, ...]:
        return _design, (self._data, self._asked, self._muscles)

    def _state(self) -> dict[str, Any]:
        return {**super()._state(), "muscles": self._muscles}

    def __repr__(self) -> str:
        if not self.candidates:
            return f"Design({self.model}: none of {self.looked_at} muscles fits)"
        best = self._data["candidates"][0]
        said = f"D0 {best['outer_diameter_mm']:.4g} mm, s {best['wall_mm']:.3g} mm, {best['rubber']}, {best['braid']}"
        point = (best.get("points") or [{}])[0]
        pull = f"; {point['force_n']:.4g} N" + (f" ± {point['uncertainty_n']:.3g} N" if point.get("uncertainty_n") else "") if point.get("force_n") else ""
        limits = f"; limited by {str(best['binds']).replace('_', ' ')}" if best.get("binds") else ""
        return f"Design({self.model}: {self.fitting} of {self.looked_at} fit; best {said}, {best['pressure_mpa']:.3g} MPa{pull}{limits})"


def _design(data: dict[str, Any], asked: Any, muscles: list[str]) -> Design:
    design = Design(data, asked)
    object.__setattr__(design, "_muscles", muscles)
    return design


class _Plain(Record):
    """How an answer comes about that has nothing to itself but methods."""

    __slots__ = ()

    @classmethod
    def _asked_for(cls, command: str, request: dict[str, Any], heard: Heard) -> Any:
        return cls(_native.ask(command, request, heard), (command, request))


class Fitted(_Plain, _answers.FitAnswer):
    """A fitted formula with all that is known of it."""

    __slots__ = ()

    def __repr__(self) -> str:
        errors = (self._data.get("errors") or {}).get("fit") or {}
        share = f", rms {100 * errors['rms_of_blocked']:.2g} % of the blocked force" if errors.get("rms_of_blocked") is not None else ""
        return f"Fitted({self._data['name']}: {self._data['kind']}, {(self._data.get('provenance') or {}).get('points', 0)} points{share})"

    @property
    def formula(self) -> Formula:
        """The formula, which is a model and a file."""
        import json

        text = json.dumps({n: v for n, v in self._data.items() if n not in ("tables", "figures")}, ensure_ascii=False, indent=2)
        formula: Formula = named("Formula")(text + "\n", str(self._data["name"]))
        return formula

    def __call__(self, pressure_mpa: Floats, contraction: Floats, wall_mm: Floats, outer_diameter_mm: Floats, *, two_sided: bool = False, extrapolate: bool = False, errors: Outside | None = None) -> NDArray[np.float64]:
        """The pull of many muscles at once, in N: :meth:`Formula.__call__` of the formula."""
        return self.formula(pressure_mpa, contraction, wall_mm, outer_diameter_mm, two_sided=two_sided, extrapolate=extrapolate, errors=errors)

    def table(self, name: str) -> Table:
        """One of the intermediate tables that ``fit(…, tables=True)`` asks for, by its name."""
        held = {table["name"]: table for table in self._data.get("tables") or []}
        if name not in held:
            raise KeyError(f"{name}: there is {', '.join(held) or 'no table'}")
        return Table(dict(zip(held[name]["header"], zip(*held[name]["rows"]))))


class Fit(_Plain):
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


class Identification(Fit, _answers.IdentifyAnswer):
    """Constants found in measured points, with their errors. Its table has one row for each constant.

    Examples
    --------
    ``found.x``, ``found.names``, ``found.stderr``, ``found.cov`` and ``found.residuals`` are arrays; ``print(found.summary())`` is for reading.
    """

    __slots__ = ()

    @property
    def cov(self) -> NDArray[np.float64]:
        """Their covariance, in the units of the values."""
        correlation = np.array(self._data["correlation"], dtype=np.float64).reshape(len(self.x), len(self.x))
        return correlation * np.outer(self.stderr, self.stderr)

    @property
    def residuals(self) -> NDArray[np.float64]:
        """Model less measurement of each point, in N."""
        return np.array([p["residual_n"] for p in self._data["points"]], dtype=np.float64)

    def summary(self) -> str:
        """What was found, in lines for reading."""
        head = f"{self.model}: {len(self.residuals)} points, rms {self.rms_n:.3g} N (before {self.rms_before_n:.3g} N), largest {self.max_n:.3g} N"
        errors = "± half width of 95 %, " + ("by the stated errors" if self.errors_stated else f"by the residuals, {self.degrees_of_freedom} degrees of freedom")
        return "\n".join([head, *(f"  {word}" for word in self._words()), errors, *(f"note: {text}" for text in self.warnings)])

    def __repr__(self) -> str:
        return f"Identification({self.model}: {', '.join(self._words())}; rms {self.rms_n:.3g} N of {len(self.residuals)} points)"

    @property
    def identified(self) -> Muscle:
        """The muscle with the values found."""
        muscle: Muscle = named("Muscle").from_toml(str(self.muscle_file))
        return muscle


class _Files(_Plain):
    """An answer of files."""

    __slots__ = ()

    def save(self, folder: str | os.PathLike[str], *, overwrite: bool = False) -> Path:  # type: ignore[override]
        """Writes the files into a folder, and gives the one to begin with. A file that is there is replaced where it is the same, any other only with
        ``overwrite``.
        """
        place = Path(folder)
        contents: dict[str | os.PathLike[str], str | bytes] = {place / file.name: base64.b64decode(file.base64) if file.base64 is not None else str(file.text) for file in self.files}
        place.mkdir(parents=True, exist_ok=True)
        put(contents, lambda there: False, overwrite)
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
            raise NoAnswerError("no law is stable in a muscle", kind="no_answer", hint="name one", exit_code=1)
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
                rubber: Rubber = named("Rubber")(found.law, **constants)
                return rubber
        raise KeyError(name)


class Shape(_Plain, _answers.ShapeAnswer):
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

    def to_svg(self) -> str:
        """The section through the axis as a picture (SVG)."""
        r, z = (self.array(name) for name in ("r_mm", "z_mm"))
        at = np.concatenate([-z[:0:-1], z]), np.concatenate([r[:0:-1], r])
        wall = [*zip(at[0][:, -1], at[1][:, -1]), *zip(at[0][::-1, 0], at[1][::-1, 0])]
        drawn = "".join(f'<polygon points="{" ".join(f"{x:.2f},{sign * y:.2f}" for x, y in wall)}"/>' for sign in (1, -1))
        x, y = 1.05 * abs(z).max(), 1.3 * r.max()
        return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{-x:.2f} {-y:.2f} {2 * x:.2f} {2 * y:.2f}" width="720" role="img" aria-label="Section of the deformed muscle"><g fill="#9a8f86" stroke="#333" stroke-width="0.3">{drawn}</g></svg>'

    def _frame(self) -> str:
        page = escape(self.to_html(), quote=True)
        return f'<iframe srcdoc="{page}" style="width:100%;max-width:760px;height:430px;border:0" sandbox="allow-scripts" title="muscle"></iframe>'

    def _repr_html_(self) -> str:
        return self._frame() + super()._repr_html_()
