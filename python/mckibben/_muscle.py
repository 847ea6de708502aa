"""Muscles, and the answers that hold some."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import lru_cache
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _answers, _native, _plain, _schema
from ._ask import Progress, listening
from ._commands import MuscleCommands, MuscleFields
from ._errors import InputError, NoAnswerError
from ._files import put
from ._model import Asked, Model
from ._points import Solution, solved
from ._results import Fit
from ._table import Fixed

if TYPE_CHECKING:
    from os import PathLike

    from numpy.typing import NDArray

    from ._formula import Formula
    from ._inputs import Floats, Number, Option
    from ._results import Heard


class Muscle(MuscleFields, MuscleCommands, Asked, Fixed):
    """A McKibben muscle: a rubber tube in a braid between two terminals. Diameter, wall and length are to be given; :meth:`prototype` is that
    of the paper. Angle 28°, rubber and braid ``paper`` where they are left out.

    A muscle does not change; :meth:`replace` gives another one. Two are equal where their muscle files are.

    Examples
    --------
    >>> Muscle(outer_diameter_mm="50 mm", wall_mm=1, length_mm=285).outer_diameter_mm
    50.0
    """

    __slots__ = ("_own", "_summary", "_text")
    _text: str
    _summary: dict[str, Any] | None
    _own: dict[str, Any] | None

    def _hold(self, text: str) -> None:
        object.__setattr__(self, "_text", text)
        object.__setattr__(self, "_summary", None)
        object.__setattr__(self, "_own", None)

    def _field(self, name: str) -> Any:
        if self._own is None:
            object.__setattr__(self, "_own", _native.muscle_fields(self._text))
        return (self._own or {}).get(name)

    @classmethod
    def prototype(cls, **changes: Option) -> Muscle:
        """The paper's prototype (D0 30 mm, s 3 mm, L0 285 mm, θ0 28°, rubber and braid ``paper``), with changes by the names of :meth:`replace`."""
        return cls({"name": "prototype", "text": _native.muscle_text({})}, **dict[str, Any](changes))

    @classmethod
    def from_toml(cls, text: str) -> Muscle:
        """The muscle of a muscle file's text."""
        return cls({"name": "muscle", "text": text})

    def to_toml(self) -> str:
        """The text of its muscle file; reading it gives the same muscle to the last bit."""
        return self._text

    def to_dict(self) -> dict[str, Any]:
        """What is stated of it by the names of fields: ``Muscle(**muscle.to_dict())`` is the same muscle. A rubber that is none of the library is a dict of
        its law and constants. Where fields do not state all of it (a muscle with an identification, an end factor that depends on the pressure, strands
        that carry compression), it is the text of its muscle file.
        """
        held = _native.toml("muscle", self._text)
        stated = {("terminals" if table == "model" else table, key) for table, value in held.items() for key in _keys(value)}
        out = {name: self._field(name) for name, field in _schema.muscle().items() if tuple(field.get("x-key", "").split(".")) in stated}
        own = held.get("tube", {}).get("material")
        words = {"rubber": own or (("tube", "rubber") in stated and self._field("rubber")), "braid": ("braid", "name") in stated and self._field("braid")}
        out.update({name: value for name, value in words.items() if value})
        try:
            whole = Muscle(**out) == self
        except InputError:
            whole = False
        return out if whole else {"base": {"name": "muscle", "text": self._text}}

    def save(self, path: str | PathLike[str], *, overwrite: bool = False) -> None:
        """Writes its muscle file. Another file that is there is replaced only with ``overwrite``."""
        put({path: self._text}, overwrite)

    def model(self, model: str | Formula | PathLike[str] | None = None, **options: Option) -> Model:
        """A model of this muscle, to be asked for arrays; the arguments are those of :class:`Model`."""
        return Model(self, model, **dict[str, Any](options))

    def _bound(self, options: dict[str, Any]) -> Model:
        try:
            return _model(self, tuple(sorted(options.items())))
        except TypeError:
            # Options that cannot be hashed, or are none: this says which.
            return self.model(**options)

    def solve(self, pressure_mpa: Floats, contraction: Floats = 0.0, **options: Option) -> Solution:
        """All that is known of many points: pulls, their ±, volumes, stiffness, strand tension, … as arrays.

        Parameters
        ----------
        pressure_mpa : MPa
            Gauge pressures P, as in :meth:`force`.
        contraction : ratio
            Contraction ratios ε, broadcast against them.
        options
            Those of :meth:`curve`: ``model``, ``extrapolate``, …
        """
        return solved(self, pressure_mpa, contraction, options)

    @property
    def parameters(self) -> dict[str, float]:
        """Constants and measures by which models have derivatives, named as in the muscle file: moduli in MPa, k in N/mm, mm, degrees."""
        return {name: value for name, value, _ in _native.parameters(self._text)}

    def _follows(self, measure: str) -> dict[str, float]:
        """How the parameters change with a measure of :meth:`replace`: by central differences of smooth formulas."""
        value = getattr(self, measure)
        if not isinstance(value, float):
            raise ValueError(f"{measure}: a muscle whose {measure} is {value!r} has no derivative by it; use jac=['braid.stiffness']")
        step = 1e-4 * abs(value)
        changed: list[dict[str, Any]] = [{measure: value + sign * step} for sign in (1, -1)]
        high, low = (self.replace(**change).parameters for change in changed)
        rates = {name: (high[name] - low[name]) / (2 * step) for name in high}
        return {name: rate for name, rate in rates.items() if abs(rate) * abs(value) > 1e-10 * abs(high[name])}

    def with_parameters(self, values: Mapping[str, float]) -> Muscle:
        """The same with other constants and measures, named as in :attr:`parameters`; all others are held, k of the strands in N/mm
        among them, also where the braid's k follows the diameter.
        """
        muscle = object.__new__(Muscle)
        muscle._hold(_native.muscle_with(self._text, {str(n): float(v) for n, v in values.items()}))
        return muscle

    def report(self, path: str | PathLike[str] | None = None, *, pressure_mpa: Number | None = None, contraction: Number | None = None, units: str = "MPa", overwrite: bool = False, progress: Progress = None) -> str:
        """A report of the muscle as one HTML page for reading offline; written to ``path`` if one is given. Another file that is there is replaced only
        with ``overwrite``.
        """
        request = _plain.request("build", {"muscle": self, "report": True, "pressure_mpa": pressure_mpa, "contraction": contraction, "units": units})
        with listening(progress, "build") as heard:
            page = _native.report_html(request, heard)
        if path is not None:
            put({path: page}, overwrite)
        return page

    def _measures(self) -> dict[str, Any]:
        if self._summary is None:
            object.__setattr__(self, "_summary", _native.ask("check", {"muscle": {"name": "muscle", "text": self._text}, "only_data": True}))
        return self._summary or {}

    @property
    def rubber(self) -> str:
        """The rubber, by name or law."""
        return str(self._measures()["rubber"])

    @property
    def braid(self) -> str:
        """The braid: its name, its stiffness or its strands."""
        return str(self._measures()["braid"])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Muscle) and self._text == other._text

    def __hash__(self) -> int:
        return hash(("Muscle", self._text))

    def __reduce__(self) -> tuple[Any, ...]:
        return Muscle.from_toml, (self._text,)

    def __repr__(self) -> str:
        m = self._measures()
        measures = ", ".join(f"{name}={m[name]:.6g}" for name in ("outer_diameter_mm", "wall_mm", "length_mm", "angle_deg"))
        return f"Muscle({measures}, rubber={m['rubber']!r}, braid={m['braid']!r})"

    def _repr_html_(self) -> str:
        m = self._measures()
        names = ("outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "rubber", "braid")
        rows = "".join(f"<tr><th style='text-align:left'>{n}</th><td>{escape(f'{m[n]:.6g}' if isinstance(m[n], float) else str(m[n]))}</td></tr>" for n in names)
        return f"<table><caption>Muscle</caption>{rows}</table>" + self.shape(0.0, 0.0)._frame()


@lru_cache(64)
def _model(muscle: Muscle, options: tuple[tuple[str, Any], ...]) -> Model:
    """Kept for the next question."""
    return muscle.model(**dict(options))


def _keys(table: Mapping[str, Any]) -> Iterator[str]:
    """The keys in a table of a muscle file, and in those below it."""
    for name, value in table.items():
        if isinstance(value, dict):
            yield from _keys(value)
        else:
            yield name


class Design(_answers.DesignAnswer):
    """Ranked muscles, and why others fail. Its table has one row for each candidate, best first."""

    __slots__ = ()

    @property
    def muscles(self) -> list[Muscle]:
        """The candidates as muscles, best first."""
        return [Muscle.from_toml(file["text"]) for file in self._data.get("muscle_files", [])]

    @property
    def best(self) -> Muscle:
        """The first of them."""
        if not self.candidates:
            raise NoAnswerError("no muscle fits", kind="no_answer", hint="`closest` and `rejected` say why")
        return self.muscles[0]

    def __repr__(self) -> str:
        if not self.candidates:
            return f"Design({self.model}: none of {self.looked_at} muscles fits)"
        return "\n".join(self._data["decision"])


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
        return Muscle.from_toml(str(self.muscle_file))


_answers.OWN.update({kind.__name__: kind for kind in (Design, Identification)})
