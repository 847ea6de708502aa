"""Rubbers by their law and constants."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from . import _native, _plain, _quantity
from ._files import put, text as file_text
from ._table import Fixed

if TYPE_CHECKING:
    import os

    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import Self

    from ._inputs import Number, Plain


class Rubber(Fixed):
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

    __slots__ = ("_text", "_values")
    _table = "tube.material"
    _text: str
    _values: dict[str, Any]

    def __init__(self, law: str, *, bulk_modulus_mpa: Number | None = None, **constants: Plain) -> None:
        bulk = bulk_modulus_mpa
        if bulk is not None and not (isinstance(bulk, str) and bulk.strip().lower() == "incompressible"):
            bulk = f"{_quantity.number('bulk_modulus_mpa', bulk)!r} MPa"
        values = {"law": law, **{name: _plain.constant(value) for name, value in constants.items()}}
        self._set({**values, **({} if bulk is None else {"bulk_modulus": bulk})})

    def _set(self, values: dict[str, Any]) -> Self:
        values = {n: v for n, v in values.items() if v is not None}
        object.__setattr__(self, "_values", values)
        object.__setattr__(self, "_text", _plain.material(values))
        # A muscle of nothing else says what is wrong with it.
        _native.muscle_text({}, self._text)
        return self

    def to_toml(self) -> str:
        """The table as in a muscle file."""
        return self._text

    def to_dict(self) -> dict[str, Any]:
        """Its law and constants, of which the same rubber can be made."""
        return dict(self._values)

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Writes its table (TOML). Another file that is there is replaced only with ``overwrite``."""
        put({path: self._text}, overwrite)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """The rubber that :meth:`save` wrote, or that a muscle file has."""
        return cls.from_toml(file_text(path)["text"])

    @classmethod
    def from_toml(cls, text: str) -> Self:
        """The rubber of its table, or of a muscle file."""
        held = _native.toml("rubber", text).get("tube", {})
        if "material" not in held:
            # A muscle file names it, or leaves it to the default.
            held = _native.toml("rubber", _native.muscle_text({"muscle": {"name": "rubber", "text": text}}))["tube"]
            if "material" not in held:
                raise KeyError(f"the rubber is {held['rubber']!r} of the library")
        return object.__new__(cls)._set({name: _plain.constant(value) for name, value in held["material"].items()})

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self._values:
            raise AttributeError(f"Rubber has no {name!r}")
        return self._values[name]

    def replace(self, **constants: Plain) -> Rubber:
        """The same with other constants."""
        return Rubber(**{**self._values, **constants})

    def stress(self, mode: Literal["uniaxial", "planar", "equibiaxial"], stretch: ArrayLike) -> NDArray[Any]:
        """Nominal stress (force over the area at rest) of the incompressible rubber in MPa, at stretches (length over that at rest)."""
        if mode not in ("uniaxial", "planar", "equibiaxial"):
            raise ValueError(f'mode: "uniaxial", "planar" or "equibiaxial", not {mode!r}')
        stretches = np.asarray(stretch, dtype=np.float64)
        text = _native.muscle_text({}, self._text)
        return np.array(_native.rubber_stress(text, mode, stretches.ravel().tolist())).reshape(stretches.shape)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Rubber) and self._text == other._text

    def __hash__(self) -> int:
        return hash(("Rubber", self._text))

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._values,)

    def __repr__(self) -> str:
        return f"Rubber({', '.join(f'{n}={v!r}' for n, v in self._values.items())})"


def _restored(values: dict[str, Any]) -> Rubber:
    return object.__new__(Rubber)._set(values)
