"""Muscles, and the numbers that they answer."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Collection, Mapping, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any, Literal

from . import _api, _native
from ._errors import InputError, MckibbenError, MuscleWarning, warned, wrong_type
from ._record import of_rows
from ._request import (
    Saved,
    array,
    fields,
    heard,
    is_nan,
    known,
    labels,
    modelled,
    number,
    put,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from typing_extensions import Unpack

    from ._parts import Rubber
    from ._request import Floats, Number, Progress

    Array = NDArray[np.float64]
    Errors = Literal["raise", "nan"]

# Measures of a muscle, as :meth:`Muscle.replace` has them, by which there are derivatives.
MEASURES = ("outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "stiffness")
# The name of what is wanted, and those of both numbers of the question.
PAIRS = {
    "force": ("force_n", "pressure_mpa", "contraction"),
    "pressure": ("pressure_mpa", "force_n", "contraction"),
    "contraction": ("contraction", "force_n", "pressure_mpa"),
}
# A pressure in MPa above which a bare number was likely meant in bar, and one up to which nothing is said of a burst pressure that is not known.
_LIKELY_MPA, _QUIET_MPA = 1.0, 0.6
# Contractions at which a muscle is looked at for what is to be said of it, and of how many points of an array, those of the highest pressures.
_PROBED, _MOST = (0.0, 0.1, 0.2, 0.25, 0.3, 0.35), 64


class Bound:
    """A model that is bound to a muscle, and up to which pressure nothing is to be said of its points."""

    __slots__ = ("muscle", "native", "quiet")

    def __init__(self, muscle: Muscle, given: Mapping[str, Any]) -> None:
        made = muscle._held.model
        self.muscle = muscle
        self.native = made(fields(modelled(known(given, _api.Options))))
        (_, allowed), _ = self.native.bounds()
        highest = min(_LIKELY_MPA, _QUIET_MPA if allowed == float("inf") else allowed)
        # Elements would take long, and warn of what a long muscle does.
        probe = (
            made({"model": "thick-wall"}) if self.native.is_elements else self.native
        )
        # Up to which pressure and contraction a muscle says nothing.
        self.quiet = 0.0, 0.0
        for pressure in (highest, highest / 2, highest / 4):
            rows = probe.solve([pressure] * len(_PROBED), list(_PROBED), True)
            loud = [bool(row.get("warnings")) for row in rows]
            quiet = (*loud, True).index(True)
            if quiet > 2:
                self.quiet = pressure, _PROBED[quiet - 1]
                break

    def is_quiet(self, pressure: Any, contraction: Any) -> Any:
        """Whether nothing is to be said of a point, or of each of several."""
        most, last = self.quiet
        return (pressure <= most) & (contraction >= 0.0) & (contraction <= last)

    def say(self, rows: Sequence[Mapping[str, Any]]) -> list[str]:
        """Warns of points that were solved, once of each text; which these are."""
        said = dict.fromkeys(text for row in rows for text in row.get("warnings", ()))
        if said:
            warned("; ".join(said), MuscleWarning)
        return list(said)

    def look(self, p: list[float], e: list[float], nan: bool = True) -> list[float]:
        """Pulls at points, with what is to be said of these."""
        self.say(rows := self.native.solve(p, e, nan))
        return [row.get("force_n", math.nan) for row in rows]


def _plain(value: Any) -> Any:
    """A number of NumPy, or an array of no dimension, as one of Python."""
    is_one = type(value).__module__ == "numpy" and getattr(value, "shape", 0) == ()
    return value.item() if is_one else value


class Muscle(_api.MuscleFields, _api.MuscleNumbers, _api.MuscleCommands, Saved):
    """A McKibben muscle: a rubber tube in a braid between two terminals. Diameter, wall and length are to be given; :meth:`prototype` is that
    of the paper. Angle 28°, rubber and braid ``paper`` where they are left out.

    A muscle does not change; :meth:`replace` gives another one. Two are equal where their muscle files are.

    Examples
    --------
    >>> import mckibben as mk
    >>> mk.Muscle(outer_diameter_mm="50 mm", wall_mm=1, length_mm=285)
    Muscle(outer_diameter_mm=50.0, wall_mm=1.0, length_mm=285.0, angle_deg=28.0, stiffness='paper', rubber='paper')
    """

    __slots__ = ("_held", "_models", "_own")
    _kind = "muscle"
    _held: _native.Muscle
    _models: dict[Any, Bound]
    _own: dict[str, Any] | None

    def _of(self, native: _native.Muscle) -> Muscle:
        return self._hold(_held=native, _models={}, _own=None)

    def _make(self, given: dict[str, Any], base: Muscle | None = None) -> Muscle:
        missing = [n for n in MEASURES[:3] if not base and given.get(n, 0) is None]
        if missing:
            raise wrong_type(missing[0], 'a length such as 30 or "30 mm"', None)
        return self._of(_native.Muscle({"muscle": fields({**given, "file": base})}))

    def _changed(self, given: dict[str, Any]) -> Muscle:
        return object.__new__(Muscle)._make(given, self)

    def replace(self, **measures: Unpack[_api.Measures]) -> Muscle:
        """The same with other values, named as in :class:`Muscle`.

        Raises
        ------
        InputError
            There is no such muscle; `field` is the argument to blame.

        Examples
        --------
        >>> import mckibben as mk
        >>> mk.Muscle.prototype().replace(wall_mm="2 mm").wall_mm
        2.0
        """
        return self._changed(dict(known(measures, _api.Measures)))

    def _files(self, command: str) -> dict[str, Any]:
        return {"muscle": {"file": {"name": "muscle", "text": self.to_toml()}}}

    def _field(self, name: str) -> Any:
        if self._own is None:
            self._hold(_own=self._held.fields())
        return (self._own or {}).get(name)

    @classmethod
    def prototype(cls) -> Muscle:
        """The paper's prototype: D0 30 mm, s 3 mm, L0 285 mm, θ0 28°, rubber and braid ``paper``."""
        return object.__new__(cls)._make({})

    @classmethod
    def from_toml(cls, text: str) -> Muscle:
        """The muscle of a muscle file's text."""
        return object.__new__(cls)._of(
            _native.Muscle({"muscle": {"file": {"name": "muscle", "text": text}}})
        )

    def to_toml(self) -> str:
        """The text of its muscle file; reading it gives the same muscle to the last bit."""
        return self._held.text

    def to_dict(self) -> dict[str, Any]:
        """What is stated of it, as the arguments of ``Muscle(…)``; where these do not state all of it (a muscle with an identification, an end factor that
        depends on the pressure, strands that carry compression), the text of its muscle file as ``{"toml": …}``.
        """
        held = _native.toml("muscle", self.to_toml())
        stated = {
            f"{'terminals' if table == 'model' else table}.{key}"
            for table, keys in held.items()
            if isinstance(keys, dict)
            for key in keys
        }
        out = {
            name: self._field(name) for name, key in _api.KEYS.items() if key in stated
        }
        if stated & {"tube.material", "tube.rubber"}:
            out["rubber"] = self.rubber
        if "braid.name" in stated:
            out["braid"] = self._field("braid")
        try:
            whole = Muscle(**out) == self
        except (InputError, TypeError):
            whole = False
        return (
            {
                name: value.to_dict() if hasattr(value, "to_dict") else value
                for name, value in out.items()
            }
            if whole
            else {"toml": self.to_toml()}
        )

    def _bound(self, given: Mapping[str, Any]) -> Bound:
        """The model that is asked, kept for the next question."""
        key = tuple(given.items())
        try:
            return self._models[key]
        except KeyError:
            self._models[key] = bound = Bound(self, given)
            return bound
        except TypeError:
            # Options that are maps or lists.
            return Bound(self, given)

    def _asked(
        self,
        wanted: str,
        a: Any,
        b: Any,
        jac: bool | Sequence[str],
        options: dict[str, Any],
    ) -> Any:
        nan = is_nan(options.pop("errors", "raise"))
        progress = options.pop("progress", None)
        bound = self._bound(options)
        numbers = (float, int)
        a = a if type(a) in numbers else _plain(a)
        b = b if type(b) in numbers else _plain(b)
        if (
            jac is False
            and progress is None
            and type(a) in numbers
            and type(b) in numbers
        ):
            stated = {"force": a, "contraction": b}.get(wanted, 0.0)
            if stated > _LIKELY_MPA:
                number("pressure_mpa", stated)
            try:
                # One solve gives both.
                if wanted == "force" and not bound.is_quiet(a, b):
                    return bound.look([a], [b], nan)[0]
                found = bound.native.answer_pair(wanted, a, b, nan)
            except MckibbenError as error:
                # It is not one of several.
                error.index = None
                raise
            p, e = {"force": (a, b), "pressure": (found, b)}.get(wanted, (b, found))
            if found == found and not bound.is_quiet(p, e):
                bound.look([p], [e])
            return found
        return _arrays(bound, wanted, a, b, jac, nan, progress)

    def solve(
        self,
        pressure_mpa: Floats,
        contraction: Floats = 0.0,
        *,
        errors: Errors = "raise",
        progress: Progress = None,
        **options: Unpack[_api.Options],
    ) -> _api.Solution:
        """All that is known of points: pulls with their ±, volumes, stiffness, strand tension, … as arrays of one shape. Arguments and exceptions are those of
        :meth:`force`.

        Returns
        -------
        Solution
            Its arrays are attributes: `force_n`, `uncertainty_n`, `volume_mm3`, …; `warned` has a bit for each of `warnings`.

        Examples
        --------
        >>> import mckibben as mk
        >>> points = mk.Muscle.prototype().solve([0.1, 0.2], 0.1, model="universal")
        >>> points.force_n.shape, bool((points.uncertainty_n > 0).all())
        ((2,), True)
        """
        import numpy as np

        bound = self._bound(options)
        (p, e), labelled = labels(
            {"pressure_mpa": pressure_mpa, "contraction": contraction}
        )
        p, e = np.broadcast_arrays(array("pressure_mpa", p), array("contraction", e))
        rows = bound.native.solve(
            p.ravel().tolist(),
            e.ravel().tolist(),
            is_nan(errors),
            heard(progress, "solve"),
        )
        texts = bound.say(rows)
        usual = {"slack": False, "status": "ok", "cause": ""}
        for row in rows:
            # They add as squares.
            parts = row.pop("uncertainty_parts_n", {}).items()
            row |= {f"uncertainty_{name}_n": part for name, part in parts}
            said = set(row.pop("warnings", ()))
            row["warned"] = sum(1 << texts.index(text) for text in said)
        columns = of_rows([{**usual, **row} for row in rows])
        held = {n: v for n, v in columns.items() if n in usual or hasattr(v, "dtype")}
        at = {"pressure_mpa": p, "contraction": e}
        about = {"model": bound.native.name, "warnings": texts}
        made = _api.Solution._read({**dict.fromkeys(usual, ()), **held, **at, **about})
        if p.ndim and not isinstance(labelled("", p), np.ndarray):
            made.__dict__["_labels"] = labelled
        return made

    def bounds(self, **options: Unpack[_api.Options]) -> list[tuple[float, float]]:
        """Lowest and highest pressure in MPa and contraction of a model, as an optimiser takes them; the pressure is at most the allowed one.

        Examples
        --------
        >>> import mckibben as mk
        >>> mk.Muscle.prototype().bounds(model="paper")
        [(0.0, 0.25), (0.0, 0.2)]
        """
        return self._bound(options).native.bounds()

    @property
    def parameters(self) -> dict[str, float]:
        """Constants and measures by which models have derivatives, named as in the muscle file: moduli in MPa, k in N/mm, mm, degrees."""
        return dict(self._held.parameters())

    def _follows(self, measure: str) -> dict[str, float]:
        """How the parameters change with a measure of :meth:`replace`: by central differences of smooth formulas."""
        value = self._field(measure)
        if not isinstance(value, float):
            raise ValueError(
                f"{measure}: no derivative by {value!r}; use jac=['braid.stiffness']"
            )
        step = 1e-4 * abs(value)
        high, low = (
            self._changed({measure: value + sign * step}).parameters for sign in (1, -1)
        )
        rates = {name: (high[name] - low[name]) / (2 * step) for name in high}
        return {
            name: rate
            for name, rate in rates.items()
            if abs(rate) * abs(value) > 1e-10 * abs(high[name])
        }

    def _chain(
        self, names: Sequence[str], held: Collection[str] = ()
    ) -> tuple[list[str], Array]:
        """The parameters that change with constants and measures, but for those that are held, and by how much: a column for each name."""
        import numpy as np

        rows = [
            {n: v for n, v in self._follows(name).items() if n not in held}
            if name in MEASURES
            else {name: 1.0}
            for name in names
        ]
        own = list(dict.fromkeys(parameter for row in rows for parameter in row))
        return own, np.array(
            [[row.get(parameter, 0.0) for row in rows] for parameter in own]
        ).reshape(len(own), len(rows))

    def with_parameters(self, values: Mapping[str, float]) -> Muscle:
        """The same with other constants and measures, named as in :attr:`parameters`; all others are held, k of the strands in N/mm
        among them, also where the braid's k follows the diameter.
        """
        return object.__new__(Muscle)._of(
            self._held.changed([(n, float(v)) for n, v in values.items()])
        )

    @property
    def rubber(self) -> str | Rubber:
        """The rubber: its name in the library, or its law and constants."""
        from ._parts import Rubber

        tube = _native.toml("muscle", self.to_toml()).get("tube", {})
        return (
            Rubber.from_toml(self.to_toml())
            if "material" in tube
            else str(tube.get("rubber", "paper"))
        )

    @property
    def braid(self) -> str:
        """The braid: its name, its stiffness or its strands."""
        return str(
            _native.ask("check", {**self._files("check"), "only_data": True})["braid"]
        )

    def report(
        self,
        path: str | os.PathLike[str] | None = None,
        *,
        pressure_mpa: Number | None = None,
        contraction: Number | None = None,
        units: str = "MPa",
        overwrite: bool = False,
        progress: Progress = None,
    ) -> str:
        """A report of the muscle as one HTML page for reading offline; written to ``path`` if one is given. Another file that is there is replaced only
        with ``overwrite``.
        """
        request = fields(
            {
                **self._files("build"),
                "report": True,
                "pressure_mpa": pressure_mpa,
                "contraction": contraction,
                "units": units,
            }
        )
        page = _native.page_html("build", request, heard(progress, "build"))
        if path is not None:
            put({path: page}, overwrite)
        return page

    def cite(self, model: str | None = None) -> str:
        """BibTeX of the package, and of what the model and the data of rubber and braid come from: authors, title, year and DOI; where the source is no publication,
        a note.

        Examples
        --------
        >>> import mckibben as mk
        >>> print(mk.Muscle.prototype().cite("ideal").splitlines()[0])
        @software{mckibben,
        """
        asked = {**self._files("force"), "pressure_mpa": 0.0, "model": model or "fe"}
        sources = {"model": _native.ask("force", asked)["about"]["source"]}
        for part in ("rubber", "braid"):
            name = str(self._field(part) or "").split(":")[0]
            with suppress(InputError):
                held: Any = _api.part(name)
                sources[name] = (held.rubber or held.sleeve).source
        found = re.findall(r"^(@\w+\{(\w+),.*?^\})", _native.LITERATURE, re.M | re.S)
        entries = {key: text for text, key in found}
        out = [
            f"@software{{mckibben,\n  title = {{mckibben: design of McKibben pneumatic muscles}},\n  version = {{{_native.VERSION}}}\n}}"
        ]
        for name, source in sources.items():
            keys = re.findall(r"\[(\w+)\]", source)
            note = f"@misc{{mckibben_{name},\n  note = {{{source}}}\n}}"
            out += [entries[key] for key in keys] or [note]
        return "\n\n".join(dict.fromkeys(out))

    _key = to_toml

    def __repr__(self) -> str:
        given = self.to_dict()
        if "toml" in given:
            return f"Muscle.from_toml({given['toml']!r})"
        if isinstance(given.get("rubber"), dict):
            given["rubber"] = self.rubber
        return (
            f"Muscle({', '.join(f'{name}={value!r}' for name, value in given.items())})"
        )

    def _repr_html_(self) -> str:
        from html import escape

        return f"<p>{escape(repr(self))}</p>{self.shape(0.0, 0.0)._frame()}"


def _arrays(
    bound: Bound,
    wanted: str,
    a: Any,
    b: Any,
    jac: bool | Sequence[str],
    nan: bool,
    progress: Progress,
) -> Any:
    """A number or an array of the broadcast shape; with `jac` also the derivatives along one axis more."""
    import numpy as np

    name, *pair = PAIRS[wanted]
    given, labelled = labels(dict(zip(pair, (a, b))))
    a, b = map(array, pair, given)
    mask: Any = (
        np.ma.getmaskarray(a) | np.ma.getmaskarray(b)
        if isinstance(a, np.ma.MaskedArray) or isinstance(b, np.ma.MaskedArray)
        else None
    )
    shape = np.broadcast_shapes(a.shape, b.shape)
    # What is masked is asked as the muscle at rest, which every model answers, and its answer is masked.
    first, second = (
        np.broadcast_to(
            v if mask is None else np.where(mask, 0.0, np.ma.getdata(v)), shape
        ).ravel()
        for v in (a, b)
    )
    names = (
        []
        if isinstance(jac, (bool, np.bool_))
        else [jac]
        if isinstance(jac, str)
        else list(jac)
    )
    # All parameters that follow a measure change with it.
    own, by = (
        bound.muscle._chain(names)
        if any(name in MEASURES for name in names)
        else (names, None)
    )
    slopes = bool(names) or bool(jac)
    out = np.empty((*shape, 3 + len(own)) if slopes else shape)
    value, rates = (out[..., 0], out[..., 1:]) if slopes else (out, None)
    how = slopes, own, nan, heard(progress, wanted)
    bound.native.fill(wanted, first, second, out.reshape(-1), *how)
    found = value.ravel()
    pairs = {"force": (first, second), "pressure": (found, second)}
    p, e = pairs.get(wanted, (second, found))
    loud = np.flatnonzero(~bound.is_quiet(p, e) & np.isfinite(p) & np.isfinite(e))
    if loud.size:
        loud = loud[np.argsort(p[loud], kind="stable")[-_MOST:]]
        bound.look(p[loud].tolist(), e[loud].tolist())
    if by is not None:
        rates = np.concatenate([out[..., 1:3], out[..., 3:] @ by], axis=-1)
    if mask is not None:
        value = np.ma.array(value, mask=mask)
        rates = (
            rates
            if rates is None
            else np.ma.array(rates, mask=np.broadcast_to(mask[..., None], rates.shape))
        )
    found = labelled(name, value)
    return found if rates is None else (found, labelled(name, rates))
