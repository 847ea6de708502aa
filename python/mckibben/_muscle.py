"""Muscles."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, overload

from . import _native, _plain, _schema
from ._ask import Progress, answered, listening
from ._base import _any, named
from ._commands import MuscleCommands, MuscleFields, spelled
from ._files import head, holds, put
from ._problem import InputError

if TYPE_CHECKING:
    from os import PathLike

    import numpy as np
    from numpy.typing import NDArray

    from ._formula import Formula
    from ._inputs import Floats, MuscleLike, Number, Option
    from ._model import Model
    from ._parts import Friction, Terminals, Tube
    from ._points import Found, Outside, Solution


def _title(command: str) -> str:
    """The class of a command's answer."""
    return str(_schema.bundle()[command]["answer"]["title"])


class Muscle(MuscleFields, MuscleCommands):
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
    def prototype(cls, **changes: Option | Tube | Terminals | Friction) -> Muscle:
        """The paper's prototype (D0 30 mm, s 3 mm, L0 285 mm, θ0 28°, rubber and braid ``paper``), with changes by the names of :meth:`replace`."""
        return cls({"name": "prototype", "text": _native.muscle_text({})}, **_any(changes))

    @classmethod
    def from_file(cls, path: str | PathLike[str]) -> Muscle:
        """The muscle of a muscle file (TOML)."""
        return cls(path)

    @classmethod
    def from_toml(cls, text: str) -> Muscle:
        """The muscle of a muscle file's text."""
        return cls({"name": "muscle", "text": text})

    def to_toml(self) -> str:
        """The text of its muscle file; reading it gives the same muscle to the last bit."""
        return self._text

    @classmethod
    def load(cls, path: str | PathLike[str]) -> Muscle:
        """The muscle that :meth:`save` wrote."""
        return cls(path)

    def to_dict(self) -> dict[str, Any]:
        """What is stated of it by the names of fields: ``Muscle(**muscle.to_dict())`` is the same muscle. A rubber that is none of the library is a dict of
        its law and constants, and a braid whose strands carry compression one of its fields. Where fields do not state all of it (a muscle with an
        identification, an end factor that depends on the pressure), it is the text of its muscle file.
        """
        out: dict[str, Any] = {}
        try:
            for table in ("tube", "braid", "terminals", "friction"):
                own, names = self._part(table).to_dict(), _schema.part(table)
                out.update({table: own} if "compression" in own else {names[name]: value for name, value in own.items()})
            whole = Muscle(**_any(out)) == self
        except InputError:
            whole = False
        return out if whole else {"base": {"name": "muscle", "text": self._text}}

    def save(self, path: str | PathLike[str], *, overwrite: bool = False) -> None:
        """Writes its muscle file. One that is there is replaced where it is a muscle file, any other only with ``overwrite``."""
        put({path: self._text}, holds(Muscle), overwrite)

    def model(self, model: str | Formula | PathLike[str] | None = None, **options: Option) -> Model:
        """A model of this muscle, to be asked for arrays; the arguments are those of :class:`Model`."""
        made: Model = named("Model")(self, model, **_any(options))
        return made

    @overload
    def force(self, pressure_mpa: Number | None = ..., contraction: Number = ..., *, errors: Outside | None = ..., **options: Option) -> Found: ...  # type: ignore[overload-overlap]
    @overload
    def force(self, pressure_mpa: Floats, contraction: Floats = ..., *, jac: Literal[False] = ..., errors: Outside | None = ..., **options: Option) -> NDArray[np.float64]: ...  # type: ignore[overload-overlap]
    @overload
    def force(self, pressure_mpa: Floats, contraction: Floats = ..., *, jac: bool | Sequence[str], errors: Outside | None = ..., **options: Option) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...

    def force(self, pressure_mpa: Any = None, contraction: Any = None, *, jac: Any = False, errors: Outside | None = None, **options: Any) -> Any:
        """F(P, ε): the pull, in N; 0 where the muscle is slack.

        Parameters
        ----------
        pressure_mpa : MPa
            Gauge pressure P: a number, a text such as ``"2.5 bar"``, a quantity of pint, or an array of numbers.
        contraction : ratio
            Contraction ratio ε = ΔL/L0, or an array that is broadcast against the pressures.
        jac
            As in :meth:`Model.force`: True for a pair with the derivatives.
        errors
            At points of arrays without an answer: ``warn`` (where it is left out: NaN and one warning), ``nan`` or ``raise``.
        options
            Those of :class:`Model` for arrays, of :meth:`state` for one point: ``model``, ``mesh``, ``extrapolate``, ``direction``, …

        Returns
        -------
        float or numpy.ndarray
            The pull. That of one point has the whole point with it: ``.state``, ``.uncertainty_n``, ``.stiffness_n_per_mm``, …
        """
        return self._asked("force", ("pressure_mpa", pressure_mpa), ("contraction", contraction), jac, errors, options)

    @overload
    def pressure(self, force_n: Number | None = ..., contraction: Number = ..., *, errors: Outside | None = ..., **options: Option) -> Found: ...  # type: ignore[overload-overlap]
    @overload
    def pressure(self, force_n: Floats, contraction: Floats = ..., *, jac: Literal[False] = ..., errors: Outside | None = ..., **options: Option) -> NDArray[np.float64]: ...  # type: ignore[overload-overlap]
    @overload
    def pressure(self, force_n: Floats, contraction: Floats = ..., *, jac: bool | Sequence[str], errors: Outside | None = ..., **options: Option) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...

    def pressure(self, force_n: Any = None, contraction: Any = None, *, jac: Any = False, errors: Outside | None = None, **options: Any) -> Any:
        """P(F, ε): the gauge pressure that gives a pull, in MPa. Arguments as in :meth:`force`, the pull in N first."""
        return self._asked("pressure", ("force_n", force_n), ("contraction", contraction), jac, errors, options)

    @overload
    def contraction(self, force_n: Number | None = ..., pressure_mpa: Number | None = ..., *, errors: Outside | None = ..., **options: Option) -> Found: ...  # type: ignore[overload-overlap]
    @overload
    def contraction(self, force_n: Floats, pressure_mpa: Floats, *, jac: Literal[False] = ..., errors: Outside | None = ..., **options: Option) -> NDArray[np.float64]: ...  # type: ignore[overload-overlap]
    @overload
    def contraction(self, force_n: Floats, pressure_mpa: Floats, *, jac: bool | Sequence[str], errors: Outside | None = ..., **options: Option) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...

    def contraction(self, force_n: Any = None, pressure_mpa: Any = None, *, jac: Any = False, errors: Outside | None = None, **options: Any) -> Any:
        """ε(F, P): the contraction ratio at which a pressure gives a pull. Arguments as in :meth:`force`, the pull in N first."""
        return self._asked("contraction", ("force_n", force_n), ("pressure_mpa", pressure_mpa), jac, errors, options)

    def _asked(self, wanted: str, first: tuple[str, Any], second: tuple[str, Any], jac: Any, errors: str | None, options: dict[str, Any]) -> Any:
        from ._points import Found, model_of, outside, several

        (a_name, _), (b_name, _) = first, second
        known = [name for name in _schema.request(wanted) if name != "muscle" and name not in _schema.muscle()]
        given = spelled(wanted, {name: value for name, value in (first, second, *options.items()) if value is not None}, known)
        if unknown := [name for name in given if name not in known]:
            raise TypeError(f"Muscle.{wanted}() got an unexpected keyword argument {unknown[0]!r}")
        a, b = given.pop(a_name, None), given.pop(b_name, None)
        options = given
        if several(a, b) or jac is not False:
            return getattr(model_of(self, options), wanted)(a, 0.0 if b is None else b, jac=jac, errors=outside(errors, "warn"))
        state = answered(wanted, {"muscle": self, a_name: a, b_name: b, **options}, _title(wanted))
        value = state._data.get({"force": "force_n", "pressure": "pressure_mpa", "contraction": "contraction"}[wanted])
        # Against a load the answer is more than a number.
        return state if value is None else Found(value, state)

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
        from ._points import solved

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
        """A report of the muscle as one HTML page for reading offline; written to ``path`` if one is given. A file that is there is replaced where it
        is such a page, any other only with ``overwrite``.
        """
        request = _plain.request("build", {"muscle": self, "report": True, "pressure_mpa": pressure_mpa, "contraction": contraction, "units": units})
        with listening(progress, "build") as heard:
            page = _native.report_html(request, heard)
        if path is not None:
            put({path: page}, lambda there: _native.is_page(head(there)), overwrite)
        return page

    def _measures(self) -> dict[str, Any]:
        if self._summary is None:
            object.__setattr__(self, "_summary", _native.ask("check", {"muscle": {"name": "muscle", "text": self._text}, "only_data": True}))
        return self._summary or {}

    @property
    def rubber(self) -> str:
        """The rubber, by name or law."""
        return str(self._measures()["rubber"])

    def _part(self, table: str) -> Any:
        from ._parts import PARTS

        return PARTS[table]._of(self._text)

    def _with(self, changes: dict[str, Any]) -> Muscle:
        return Muscle(self, **_any(changes))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a muscle does not change: {name}; replace({name}=…) gives another one")

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
        from html import escape

        m = self._measures()
        names = ("outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "rubber", "braid")
        rows = "".join(f"<tr><th style='text-align:left'>{n}</th><td>{escape(f'{m[n]:.6g}' if isinstance(m[n], float) else str(m[n]))}</td></tr>" for n in names)
        return f"<table><caption>Muscle</caption>{rows}</table>" + self.shape(0.0, 0.0)._frame()
