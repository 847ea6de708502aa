"""Muscles, and the numbers that they answer."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from contextlib import suppress
from difflib import get_close_matches
from functools import cached_property
from typing import TYPE_CHECKING, Any

from . import _api, _native
from ._errors import (
    InputError,
    MckibbenError,
    MuscleWarning,
    WrongTypeError,
    blamed,
    checked,
    warned,
    wrong_type,
)
from ._record import of_rows
from ._request import (
    Saved,
    arrays,
    fields,
    heard,
    is_nan,
    known,
    listed,
    modelled,
    number,
    plain,
    numpy as np,
    put,
)

if TYPE_CHECKING:
    from typing_extensions import Self, Unpack

    from ._parts import Formula, Rubber
    from ._request import (
        Array,
        Errors,
        Floats,
        Json,
        Named,
        Number,
        PathLike,
        Progress,
    )


# Measures of a muscle, as :meth:`Muscle.replace` has them, by which there are derivatives.
MEASURES = ("outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "stiffness")
# Types of a single number.
_ONE = (float, int)


def _say(texts: Iterable[str]) -> None:
    """Warns of what is to be said of points, once of each text."""
    if said := "; ".join(dict.fromkeys(texts)):
        warned(said, MuscleWarning)


def _plain(value: Any) -> Any:
    """A number of NumPy, or an array of no dimension, as one of Python."""
    is_one = type(value).__module__ == "numpy" and getattr(value, "shape", 0) == ()
    return value.item() if is_one else value


class Muscle(_api.MuscleFields, _api.MuscleNumbers, _api.MuscleCommands, Saved):
    """A McKibben muscle: a rubber tube in a braid between two terminals. Diameter, wall and length are to be given; :meth:`prototype` is that
    of the paper. Angle 28°, rubber and braid ``antonelli2018`` where they are left out.

    A muscle does not change; :meth:`replace` gives another one. Two are equal where their muscle files are.

    Examples
    --------
    >>> import mckibben as mk
    >>> mk.Muscle(outer_diameter_mm="50 mm", wall_mm=1, length_mm=285)
    Muscle(outer_diameter_mm=50.0, wall_mm=1.0, length_mm=285.0, angle_deg=28.0, stiffness='antonelli2018', rubber='antonelli2018')
    """

    _kind = "muscle"
    _held: _native.Muscle
    _models: dict[Any, _native.Model]

    def _make(self, given: Json) -> Self:
        given.pop("self", None)
        for name in () if "file" in given else MEASURES[:3]:
            if given[name] is None:
                raise wrong_type(name, 'a length such as 30 or "30 mm"', None)
        return self._hold(_held=_native.Muscle({"muscle": fields(given)}), _models={})

    @classmethod
    def _of(cls, file: Any = None, **given: Any) -> Self:
        """The muscle of a file, or another muscle, with what is given besides."""
        return object.__new__(cls)._make({"file": file, **given})

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
        return self._of(self, **known(measures, _api.Measures))

    def _files(self, command: str) -> Json:
        return {"muscle": {"file": plain("muscle", self)}}

    def __dir__(self) -> list[str]:
        # What it does, and its main measures; all others are in `measures`.
        return [n for n in super().__dir__() if n in MEASURES or n not in _api.KEYS]

    @cached_property
    def _own(self) -> Json:
        return self._held.fields()

    def _field(self, name: str) -> Any:
        return self._own.get(name)

    @classmethod
    def prototype(cls) -> Muscle:
        """The paper's prototype: D0 30 mm, s 3 mm, L0 285 mm, θ0 28°, rubber and braid ``antonelli2018``."""
        return cls._of()

    @classmethod
    def from_toml(cls, text: str) -> Muscle:
        """The muscle of a muscle file's text."""
        return cls._of({"name": "muscle", "text": text})

    def to_toml(self) -> str:
        """The text of its muscle file; reading it gives the same muscle to the last bit."""
        return self._held.text

    def to_dict(self) -> dict[str, Any]:
        """What is stated of it, as the arguments of ``Muscle(…)``; where these do not state all of it (a muscle with an identification, an end factor that
        depends on the pressure, strands that carry compression), the text of its muscle file as ``{"toml": …}``.
        """
        held = _native.toml("muscle", self.to_toml())
        stated = {
            f"{table}.{key}"
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
        with suppress(InputError, TypeError):
            if Muscle(**out) == self:
                rubber: Any = out.get("rubber")
                if hasattr(rubber, "law"):
                    out["rubber"] = rubber.to_dict()
                return out
        return {"toml": self.to_toml()}

    def _bound(self, given: Named) -> _native.Model:
        """The model that is asked, kept for the next question."""
        key = tuple(given.items())
        with suppress(KeyError, TypeError):
            return self._models[key]
        made = self._held.model(fields(modelled(known(given, _api.Options))))
        # Options that are maps or lists are no key.
        with suppress(TypeError):
            self._models[key] = made
        return made

    def _asked(
        self,
        wanted: str,
        a: Any,
        b: Any,
        jac: bool | Sequence[str],
        options: Json,
    ) -> Any:
        """A number or an array of the broadcast shape; with `jac` also the derivatives along one axis more."""
        nan = is_nan(options.pop("errors", "raise"))
        progress = options.pop("progress", None)
        bound = self._bound(options)
        a, b = (v if type(v) in _ONE else _plain(v) for v in (a, b))
        if jac is False and progress is None and type(a) in _ONE and type(b) in _ONE:
            pressure = {"force": a, "contraction": b}.get(wanted, 0.0)
            # Likely meant in bar.
            if pressure > 1.0:
                number("pressure_mpa", pressure)
            # A context takes a third of the time of all this.
            try:
                found, said = bound.answer_pair(wanted, a, b, nan)
            except MckibbenError as error:
                error.index = None
                raise
            if said:
                _say(said)
            return found
        name, *pair = _api.NUMBERS[wanted]
        (a, b), labelled = arrays(*zip(pair, (a, b)))
        flag = isinstance(jac, (bool, np.bool_))
        names = [] if flag else [jac] if isinstance(jac, str) else jac
        if not isinstance(names, Collection) or not all(
            isinstance(n, str) for n in names
        ):
            raise WrongTypeError(
                f"True, or names of constants and measures, not {jac!r}", field="jac"
            )
        first, second = np.broadcast_arrays(a, b)
        hear = heard(progress, wanted)
        self._refuse(names, "jac")
        chain = self._chain(list(names)) if (jac if flag else names) else None
        out: Any
        with blamed(is_one=first.ndim == 0):
            out, said = filled(bound, wanted, chain, first, second, nan, True, hear)
        _say(said)
        if chain is None:
            return labelled(name, out)
        return labelled(name, out[..., 0]), labelled(name, out[..., 1:])

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
        bound = self._bound(options)
        given = ("pressure_mpa", pressure_mpa), ("contraction", contraction)
        held, labelled = arrays(*given, missing=np.nan)
        p, e = np.broadcast_arrays(*held)
        points = p.ravel().tolist(), e.ravel().tolist()
        with blamed(is_one=p.ndim == 0):
            rows = bound.solve(*points, is_nan(errors), heard(progress, "solve"))
        usual = {"slack": False, "status": "ok", "cause": ""}
        places: dict[str, int] = {}
        for row in rows:
            said = (w["message"] for w in row.pop("warnings", ()))
            bits = {1 << places.setdefault(text, len(places)) for text in said}
            row["warned"] = sum(bits)
            # They add as squares.
            parts = row.pop("uncertainty_parts_n", {}).items()
            row |= {f"uncertainty_{name}_n": part for name, part in parts}
            for name in ("direction", "predicted_direction"):
                row.pop(name, None)
        _say(places)
        made = _api.Solution._read(
            {
                **of_rows([{**usual, **row} for row in rows]),
                "pressure_mpa": p,
                "contraction": e,
                "model": bound.name,
                "warnings": list(places),
            }
        )
        own = labelled("pressure_mpa", p)
        if not isinstance(own, (float, np.ndarray)):
            made.__dict__["_labelled"] = own
        return made

    def bounds(self, **options: Unpack[_api.Options]) -> list[tuple[float, float]]:
        """Lowest and highest pressure in MPa and contraction of a model, as an optimiser takes them; the pressure is at most the allowed one.

        Examples
        --------
        >>> import mckibben as mk
        >>> mk.Muscle.prototype().bounds(model="paper")
        [(0.0, 0.25), (0.0, 0.2)]
        """
        return self._bound(options).bounds()

    @property
    def parameters(self) -> dict[str, float]:
        """Constants and measures by which models have derivatives, named as in the muscle file: moduli in MPa, k in N/mm, mm, degrees."""
        return dict(self._held.parameters())

    def _follows(self, measure: str) -> dict[str, float]:
        """How the parameters change with a measure of :meth:`replace`: by central differences of smooth formulas."""
        value = self._field(measure)
        step = 1e-4 * abs(value)
        high, low = (
            self._of(self, **{measure: value + sign * step}).parameters
            for sign in (1, -1)
        )
        return {
            name: (high[name] - low[name]) / (2 * step)
            for name in high
            if high[name] != low[name]
        }

    def _refuse(self, names: Collection[str], field: str) -> None:
        """Refuses names by which there are no derivatives."""
        there = [*MEASURES, *self.parameters] if names else []
        for name in names:
            if name not in there:
                said = f"no derivative by {name!r}; there is {', '.join(there)}"
                near = get_close_matches(name, there, 1)
                hint = f"did you mean {near[0]}?" if near else ""
                raise InputError(said, field=field, hint=hint)
            if name in MEASURES and isinstance(value := self._field(name), str):
                said = f"{name}: no derivative by {value!r}; use ['braid.stiffness']"
                raise InputError(said, field=field, kind="parameter")

    def _chain(
        self, names: Sequence[str], held: Collection[str] = ()
    ) -> tuple[list[str], Array]:
        """The parameters that change with constants and measures, but for those that are held, and by how much: a column for each name."""
        rows = [
            {n: v for n, v in self._follows(name).items() if n not in held}
            if name in MEASURES
            else {name: 1.0}
            for name in names
        ]
        own = list(dict.fromkeys(parameter for row in rows for parameter in row))
        by = [row.get(parameter, 0.0) for parameter in own for row in rows]
        return own, np.reshape(by, (len(own), len(rows)))

    def with_parameters(self, values: Mapping[str, float]) -> Muscle:
        """The same with other constants and measures, named as in :attr:`parameters`; all others are held, k of the strands in N/mm
        among them, also where the braid's k follows the diameter.

        Examples
        --------
        >>> import mckibben as mk
        >>> mk.Muscle.prototype().with_parameters({"tube.outer_diameter": 32.0}).outer_diameter_mm
        32.0
        """
        given = checked("values", values, Mapping)
        changes = [(n, number(n, v)) for n, v in given.items()]
        with blamed("values"):
            changed = self._held.changed(changes)
        return object.__new__(Muscle)._hold(_held=changed, _models={})

    @property
    def rubber(self) -> str | Rubber:
        """The rubber: its name in the library, or its law and constants."""
        from ._parts import Rubber

        return self._field("rubber") or Rubber.from_toml(self.to_toml())

    @property
    def braid(self) -> str:
        """The braid: its name, its stiffness or its strands."""
        return self.check(only_data=True).braid

    def report(
        self,
        path: PathLike | None = None,
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
        asked = fields(
            {
                **self._files("build"),
                "pressure_mpa": pressure_mpa,
                "contraction": contraction,
                "units": units,
                "report": True,
            }
        )
        page = _native.page_html("build", asked, heard(progress, "build"))
        if path is not None:
            put({path: page}, overwrite)
        return page

    def cite(self, model: str | Formula | None = None) -> str:
        """BibTeX of the package, and of what the model and the data of rubber and braid come from: authors, title, year and DOI; where the source is no publication,
        a note.

        Examples
        --------
        >>> import mckibben as mk
        >>> print(mk.Muscle.prototype().cite("ideal").splitlines()[0])
        @software{mckibben,
        """
        by = plain("model", model or "fe")
        asked = {**self._files("force"), "pressure_mpa": 0.0, "model": by}
        sources = {"model": _native.ask("force", asked)["about"]["source"]}
        for part in ("rubber", "braid"):
            name = str(self._field(part) or "").split(":")[0]
            with suppress(InputError):
                held: Any = _api.part(name)
                sources[name] = (held.rubber or held.sleeve).source
        found = re.finditer(r"^@\w+\{(\w+),.*?^\}", _native.LITERATURE, re.M | re.S)
        entries = {entry[1]: entry[0] for entry in found}
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
        if "rubber" in given:
            given["rubber"] = self.rubber
        return f"Muscle({listed(given)})"

    def _repr_html_(self) -> str:
        from html import escape

        return f"<p>{escape(repr(self))}</p>{self.shape(0.0, 0.0)._frame()}"


def filled(
    model: _native.Model,
    wanted: str,
    chain: tuple[list[str], Array] | None,
    first: Array,
    second: Array,
    nan: bool,
    warnings: bool = False,
    progress: Any = None,
) -> tuple[Array, list[str]]:
    """Answers to a pair of arrays of one shape, and if wanted what is to be said of them; with a chain of parameters, which may be of none, an axis more at the end:
    answer, slopes by the pair, and those by what is named.
    """
    names, by = chain or ([], np.empty(0))
    out = np.empty(first.shape if chain is None else (*first.shape, 3 + len(names)))
    pair, flat, slopes = (first.ravel(), second.ravel()), out.ravel(), chain is not None
    said = model.fill(wanted, *pair, flat, slopes, names, nan, warnings, progress)
    if slopes:
        out = np.concatenate([out[..., :3], out[..., 3:] @ by], -1)
    return out, said
