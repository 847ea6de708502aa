"""What a muscle is made of: its rubber and its braid, as tables of a muscle file."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Literal

if TYPE_CHECKING:
    import os

    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import Self

    from ._inputs import Number, TableLike


def _toml(value: Any) -> str:
    """A value of a muscle file: texts of TOML are written as those of JSON."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(v) for v in value) + "]"
    return repr(int(value)) if hasattr(value, "__index__") else repr(float(value))


class _Part:
    """A table of a muscle file."""

    __slots__ = ("_values",)
    _table = ""
    _values: dict[str, Any]

    def to_toml(self) -> str:
        """The table as in a muscle file."""
        return "\n".join([f"[{self._table}]", *(f"{name} = {_toml(value)}" for name, value in self._values.items()), ""])

    @classmethod
    def from_toml(cls, text: str) -> Self:
        """The part of its table, or of a muscle file that has it."""
        try:
            import tomllib
        except ImportError:
            # Python 3.10: the lines of our own tables are those of JSON.
            lines = text.split(f"[{cls._table}]\n", 1)[1].split("\n[", 1)[0].splitlines()
            values: Any = {name.strip(): json.loads(value) for name, _, value in (line.partition("=") for line in lines) if value}
        else:
            values = tomllib.loads(text)
            for name in cls._table.split("."):
                values = values[name]
        part = object.__new__(cls)
        part._set({name: tuple(v) if isinstance(v, list) else v for name, v in values.items()})
        return part

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes its table (TOML)."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.to_toml())

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """The part that :meth:`save` wrote, or that a muscle file has."""
        with open(path, encoding="utf-8") as file:
            return cls.from_toml(file.read())

    def to_dict(self) -> dict[str, Any]:
        """Its values by name."""
        return dict(self._values)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a {type(self).__name__} does not change: {name}")

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self._values:
            raise AttributeError(f"{type(self).__name__} has no {name!r}")
        return self._values[name]

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{n}={v!r}' for n, v in self._values.items())})"

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and isinstance(other, _Part) and self._values == other._values

    def __hash__(self) -> int:
        return hash((type(self).__name__, tuple(sorted(self._values.items()))))

    def __reduce__(self) -> tuple[Any, ...]:
        return _part, (type(self), dict(self._values))

    def _set(self, values: dict[str, Any]) -> None:
        # A muscle of nothing else tells what is wrong with it.
        object.__setattr__(self, "_values", {n: v for n, v in values.items() if v is not None})
        from . import _native

        text = self.to_toml()
        _native.muscle_text({}, text if self._table != "braid" else None, text if self._table == "braid" else None)


def _constant(value: Any) -> Any:
    """A constant of a law: a text, a number, or several."""
    if hasattr(value, "magnitude"):
        value = value.to("dimensionless" if value.dimensionless else "MPa").magnitude
    if isinstance(value, (str, bool)) or value is None:
        return value
    return tuple(map(_constant, value)) if hasattr(value, "__iter__") and getattr(value, "shape", None) != () else float(value)


def _part(kind: type[_Part], values: dict[str, Any]) -> _Part:
    part = object.__new__(kind)
    object.__setattr__(part, "_values", values)
    return part


def _number(name: str, value: Any) -> Any:
    from . import _quantity

    return None if value is None else _quantity.number(name, value)


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

    def __init__(self, law: str, *, bulk_modulus_mpa: Number | None = None, **constants: Any) -> None:
        bulk = bulk_modulus_mpa
        if bulk is not None and not (isinstance(bulk, str) and bulk.strip().lower() == "incompressible"):
            bulk = f"{_number('bulk_modulus_mpa', bulk)!r} MPa"
        self._set({"law": law, **{name: _constant(value) for name, value in constants.items()}, "bulk_modulus": bulk})

    def stress(self, mode: Literal["uniaxial", "planar", "equibiaxial"], stretch: ArrayLike) -> NDArray[Any]:
        """Nominal stress (force over the area at rest) of the incompressible rubber in MPa, at stretches (length over that at rest)."""
        import numpy as np

        from . import _native

        if mode not in ("uniaxial", "planar", "equibiaxial"):
            raise ValueError(f'mode: "uniaxial", "planar" or "equibiaxial", not {mode!r}')
        stretches = np.asarray(stretch, dtype=np.float64)
        text = _native.muscle_text({}, self.to_toml(), None)
        return np.array(_native.rubber_stress(text, mode, stretches.ravel().tolist())).reshape(stretches.shape)

    def plot(self, ax: Axes | None = None, *, to_stretch: float = 3.0) -> Axes:
        """Nominal stress over stretch in the three tests, on axes of matplotlib."""
        from .plot import rubber

        return rubber(self, ax=ax, to_stretch=to_stretch)

    @staticmethod
    def fit(data: TableLike, **options: Any) -> Rubber:
        """The law that :func:`rubber_fit` recommends for tests of a rubber, with its constants.

        Parameters
        ----------
        data
            Table of a tension test (and others): a path, a data frame, or columns by name.
        options
            Those of :func:`rubber_fit`.
        """
        from . import _commands

        return _commands.rubber_fit(data, **options).rubber()


class Braid(_Part):
    """A braid by its strands. A sleeve of the library is named by its name alone, as in ``Muscle(braid="…")``.

    Parameters
    ----------
    angle_deg : degrees
        Angle θ0 of the strands to the axis at rest.
    stiffness : N/mm
        k of one strand family: a number, ``inextensible`` or ``paper``; or else the strands below.
    strands
        Their number, of both families together.
    strand_area_mm2, strand_modulus_mpa, strand_strength_n : mm2, MPa, N
        Cross-section, Young's modulus and strength of one strand.
    thickness_mm, diameter_mm, strand_diameter_mm : mm
        Of the braid; of a sleeve wider than the tube; of a strand.
    name
        A sleeve of the library that the other values complete.
    compression
        Whether strands carry compression.
    """

    __slots__ = ()
    _table = "braid"

    def __init__(
        self,
        angle_deg: Number | None = None,
        *,
        stiffness: Number | None = None,
        strands: int | None = None,
        strand_area_mm2: Number | None = None,
        strand_modulus_mpa: Number | None = None,
        strand_strength_n: Number | None = None,
        thickness_mm: Number | None = None,
        diameter_mm: Number | None = None,
        strand_diameter_mm: Number | None = None,
        name: str | None = None,
        compression: bool | None = None,
    ) -> None:
        from . import _plain, _quantity, _schema

        given = {
            "angle_deg": angle_deg, "strand_area_mm2": strand_area_mm2, "strand_modulus_mpa": strand_modulus_mpa, "strand_strength_n": strand_strength_n,
            "thickness_mm": thickness_mm, "diameter_mm": diameter_mm, "strand_diameter_mm": strand_diameter_mm,
        }
        values: dict[str, Any] = {"name": name}
        for key, value in given.items():
            unit = (_quantity.kind_of(key) or ("", ""))[1]
            values[key.rsplit("_", 1)[0]] = None if value is None else f"{_number(key, value)!r} {unit}"
        if stiffness is not None:
            k = _plain.field("stiffness", stiffness, _schema.muscle()["stiffness"])
            values["stiffness"] = k if isinstance(k, str) else f"{k!r} N/mm"
        self._set({**values, "strands": strands, "compression": compression})
