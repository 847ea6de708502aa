"""What a muscle is made of: tube, rubber, braid, terminals and friction, each the tables of a muscle file that describe it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar, Literal

from . import _native, _quantity, _schema
from ._base import Fixed, _any
from ._commands import BraidFields, FrictionFields, TerminalsFields, TubeFields
from ._files import holds, put, text as file_text
from ._plain import tube_for
from ._problem import InputError, warned

if TYPE_CHECKING:
    import os

    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import Self

    from ._inputs import Number, Option, Plain, TableLike


def keys(tables: Mapping[str, Any]) -> Iterator[str]:
    """The keys in tables of a muscle file; that of a whole rubber is ``rubber``."""
    for name, value in tables.items():
        if name == "material":
            yield "rubber"
        elif isinstance(value, dict):
            yield from keys(value)
        else:
            yield name


class _Part(Fixed):
    """Tables of a muscle file, with their values by the names of arguments."""

    __slots__ = ("_text", "_values")
    _table: ClassVar[str] = ""
    _text: str
    _values: dict[str, Any]

    def _hold(self, text: str, values: dict[str, Any]) -> Self:
        object.__setattr__(self, "_text", text)
        object.__setattr__(self, "_values", values)
        return self

    def to_toml(self) -> str:
        """The table as in a muscle file."""
        return self._text

    @classmethod
    def from_toml(cls, text: str) -> Self:
        """The part of its table, or of a muscle file."""
        raise NotImplementedError

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Writes its table (TOML). A file that is there is replaced where it holds such a part alone, any other only with ``overwrite``."""
        put({path: self._text}, holds(type(self)), overwrite)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """The part that :meth:`save` wrote, or that a muscle file has."""
        return cls.from_toml(file_text(path)["text"])

    def to_dict(self) -> dict[str, Any]:
        """Its values by name, of which the same part can be made."""
        return dict(self._values)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{n}={v!r}' for n, v in self._plain().items())})"

    def _plain(self) -> dict[str, Any]:
        return self._values

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and isinstance(other, _Part) and self._text == other._text

    def __hash__(self) -> int:
        return hash((type(self).__name__, self._text))

    def __reduce__(self) -> tuple[Any, ...]:
        return _part, (type(self), self._text, self._values)


def _part(kind: type[_Part], text: str, values: dict[str, Any]) -> _Part:
    return object.__new__(kind)._hold(text, values)


class _Measured(_Part):
    """A part whose values are measures of the muscle."""

    __slots__ = ()
    # The first words of its tables' names.
    _own: ClassVar[tuple[str, ...]] = ()

    @classmethod
    def from_toml(cls, text: str) -> Self:
        held = _native.toml(cls.__name__, text)
        if alone := "tube" not in held:
            text = _native.toml_text({**held, **tube_for(held.get("braid", {}))})
        return cls._of(_native.muscle_text({"muscle": {"name": cls.__name__, "text": text}}), alone)

    @classmethod
    def _of(cls, text: str, alone: bool = False) -> Self:
        """That of a muscle, by its text; alone it has what is stated."""
        return object.__new__(cls)._read(text, alone)

    def _field(self, name: str) -> Any:
        return self._values.get(name)

    def _with(self, changes: dict[str, Any]) -> Self:
        return type(self)(**{**self.to_dict(), **changes})

    def _read(self, text: str, alone: bool = False) -> Self:
        held, found = _native.toml(self._table, text), _native.muscle_fields(text)
        own = {name: table for name, table in held.items() if name in self._own} or {self._table: {}}
        if "material" in own.get("tube", {}):
            found["rubber"] = Rubber.from_toml(text)
        names = _schema.part(self._table)
        values = {name: found[field] for name, field in names.items() if field in found}
        if own.get("braid", {}).get("compression"):
            values["compression"] = True
        if self._table == "braid":
            # Its words are those of it on this tube.
            values["outer_diameter_mm"] = found["outer_diameter_mm"]
        self._hold(_native.toml_text(own), values)
        return self._hold(self._text, self._plain()) if alone else self

    def _plain(self) -> dict[str, Any]:
        """What its tables state; the others follow from it."""
        stated, key = set(keys(_native.toml(self._table, self._text))), _schema.keys(self._table)
        return {name: value for name, value in self._values.items() if key.get(name, name) in stated}

    def to_dict(self) -> dict[str, Any]:
        """What is stated of it by name: the same part can be made of it. An end factor that depends on the pressure has no argument, and is an error."""
        if isinstance(_native.toml(self._table, self._text).get("model", {}).get("tondu-lopez", {}).get("end_factor"), dict):
            raise InputError("this end factor depends on the pressure, which no argument states", kind="usage", field="end_factor", hint="use to_toml() and from_toml(), or give end_factor a number")
        return {name: value.to_dict() if isinstance(value, Rubber) else value for name, value in self._plain().items()}


class Tube(TubeFields, _Measured):
    """The rubber tube: its diameter, wall, length and rubber. What is not stated has its default value.

    Examples
    --------
    >>> tube = Tube(outer_diameter_mm=50, wall="1 mm", length_mm=285, rubber="dragon-skin-30")
    >>> tube.replace(wall_mm=2).wall_mm
    2.0
    """

    __slots__ = ()
    _table = "tube"
    _own = ("tube",)


class Braid(BraidFields, _Measured):
    """The braid: its angle and its stiffness, or its strands; or a sleeve of the library by its ``name``, which other values complete. As a text it
    is ``paper``, ``inextensible``, its stiffness, or its strands.

    Examples
    --------
    >>> Braid("25 deg", stiffness="900 N/mm")
    Braid(angle_deg=25.0, stiffness=900.0)
    """

    __slots__ = ()
    _table = "braid"
    _own = ("braid",)

    def __str__(self) -> str:
        return str(_native.ask("check", {"muscle": {"name": "braid", "text": self._text + _native.toml_text(tube_for(self._values))}, "only_data": True})["braid"])

    def __eq__(self, other: object) -> bool:
        if isinstance(other, str):
            warned("a muscle's braid is a Braid now; compare str(muscle.braid)", DeprecationWarning)
            return str(self) == other
        return super().__eq__(other)

    def __hash__(self) -> int:
        return super().__hash__()


class Terminals(TerminalsFields, _Measured):
    """The ends of a muscle: how far they reach, seat and slip, what they hold, and the factors of the models with shaped ends.

    Examples
    --------
    >>> Terminals(seating_mm=1.6, slip="4 mm/kN").slip_mm_per_n
    0.004
    """

    __slots__ = ()
    _table = "terminals"
    _own = ("terminals", "model")


class Friction(FrictionFields, _Measured):
    """Friction of the braid: the pull differs by C P^β between contraction and elongation.

    Examples
    --------
    >>> Friction(coefficient=30, exponent=0.7)
    Friction(coefficient=30.0, exponent=0.7)
    """

    __slots__ = ()
    _table = "friction"
    _own = ("friction",)


PARTS: dict[str, type[_Measured]] = {kind._table: kind for kind in (Tube, Braid, Terminals, Friction)}


def _constant(value: Any) -> Any:
    """A constant of a law: a text, a number, or several."""
    if hasattr(value, "magnitude"):
        value = value.to("dimensionless" if value.dimensionless else "MPa").magnitude
    if isinstance(value, (str, bool)) or value is None:
        return value
    if isinstance(value, Mapping):
        return {name: _constant(v) for name, v in value.items()}
    return tuple(map(_constant, value)) if hasattr(value, "__iter__") and getattr(value, "shape", None) != () else float(value)


class Rubber(_Part):
    """A rubber by its law and constants. A rubber of the library is named by its name alone, as in ``Muscle(rubber="dragon-skin-30")``.

    Parameters
    ----------
    law
        ``neo-hookean`` (mu), ``mooney-rivlin`` (c10, c01), ``yeoh`` (c10, c20, c30), ``gent`` (mu, jm), ``ogden`` (mu = […], alpha = […]), …
    bulk_modulus_mpa : MPa
        ``incompressible``, or the bulk modulus; only the finite elements use it.
    constants
        Those of the law: moduli in MPa or with their unit (``"120 kPa"``), the others plain numbers.

    Examples
    --------
    >>> Rubber("mooney-rivlin", c10=0.12, c01=0)
    Rubber(law='mooney-rivlin', c10=0.12, c01=0.0)
    """

    __slots__ = ()
    _table = "tube.material"

    def __init__(self, law: str, *, bulk_modulus_mpa: Number | None = None, **constants: Plain) -> None:
        bulk = bulk_modulus_mpa
        if bulk is not None and not (isinstance(bulk, str) and bulk.strip().lower() == "incompressible"):
            bulk = f"{_quantity.number('bulk_modulus_mpa', bulk)!r} MPa"
        self._set({"law": law, **{name: _constant(value) for name, value in constants.items()}, "bulk_modulus": constants.get("bulk_modulus") if bulk is None else bulk})

    def _set(self, values: dict[str, Any]) -> Self:
        values = {n: v for n, v in values.items() if v is not None}
        self._hold(_native.toml_text({"tube": {"material": values}}), values)
        # A muscle of nothing else says what is wrong with it.
        _native.muscle_text({}, [(self._table, self._text)])
        return self

    @classmethod
    def from_toml(cls, text: str) -> Self:
        held = _native.toml("rubber", text).get("tube", {})
        if "material" not in held:
            # A muscle file names it, or leaves it to the default.
            held = _native.toml("rubber", _native.muscle_text({"muscle": {"name": "rubber", "text": text}}))["tube"]
            if "material" not in held:
                raise KeyError(f"the rubber is {held['rubber']!r} of the library")
        return object.__new__(cls)._set({name: _constant(value) for name, value in held["material"].items()})

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self._values:
            raise AttributeError(f"Rubber has no {name!r}")
        return self._values[name]

    def replace(self, **constants: Plain) -> Rubber:
        """The same with other constants."""
        return Rubber(**{**self._values, **constants})

    def stress(self, mode: Literal["uniaxial", "planar", "equibiaxial"], stretch: ArrayLike) -> NDArray[Any]:
        """Nominal stress (force over the area at rest) of the incompressible rubber in MPa, at stretches (length over that at rest)."""
        import numpy as np

        if mode not in ("uniaxial", "planar", "equibiaxial"):
            raise ValueError(f'mode: "uniaxial", "planar" or "equibiaxial", not {mode!r}')
        stretches = np.asarray(stretch, dtype=np.float64)
        text = _native.muscle_text({}, [(self._table, self._text)])
        return np.array(_native.rubber_stress(text, mode, stretches.ravel().tolist())).reshape(stretches.shape)

    def plot(self, ax: Axes | None = None, *, to_stretch: float = 3.0) -> Axes:
        """Nominal stress over stretch in the three tests, on axes of matplotlib."""
        from .plot import rubber

        return rubber(self, ax=ax, to_stretch=to_stretch)

    @staticmethod
    def fit(data: TableLike, **options: Option) -> Rubber:
        """The law that :func:`rubber` recommends for tests of a rubber, with its constants.

        Parameters
        ----------
        data
            Table of a tension test (and others): a path, a data frame, or columns by name.
        options
            Those of :func:`rubber`.
        """
        from . import _commands

        return _commands.rubber(data, **_any(options)).rubber()
