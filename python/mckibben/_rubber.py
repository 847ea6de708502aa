"""Rubbers by their law and constants."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal

from . import _native
from ._errors import InputError
from ._request import Saved
from ._values import Number, Plain, bare

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


class Rubber(Saved):
    """A rubber by its law and constants. A rubber of the library is named by its name alone, as in ``Muscle(rubber="dragon-skin-30")``.

    Parameters
    ----------
    law
        ``neo-hookean`` (mu), ``mooney-rivlin`` (c10, c01), ``yeoh`` (c10, c20, c30), ``gent`` (mu, jm), ``ogden`` (mu = […], alpha = […]), …
    bulk_modulus_mpa : MPa
        The bulk modulus; ``incompressible`` where it is left out. Only the finite elements use it.
    constants
        Those of the law: moduli in MPa or with their unit (``"120 kPa"``), the others plain numbers.

    Raises
    ------
    InputError
        No law has this name, or these constants are not those of a rubber.

    Examples
    --------
    >>> import mckibben as mk
    >>> mk.Rubber("mooney-rivlin", c10="120 kPa", c01=0)
    Rubber('mooney-rivlin', c10=0.12, c01=0.0)
    """

    __slots__ = ("_held", "_text", "constants", "law")
    law: str
    constants: dict[str, Any]
    _held: _native.Muscle
    _text: str

    def __init__(self, law: str, *, bulk_modulus_mpa: Number | Literal["incompressible"] | None = None, **constants: Plain) -> None:
        bulk = _constant("bulk_modulus_mpa", bulk_modulus_mpa)
        self._hold({"law": law, **{n: _constant(n, v) for n, v in constants.items() if v is not None}, "bulk_modulus": bulk})

    def _hold(self, values: dict[str, Any]) -> Rubber:
        values = {name: value for name, value in values.items() if value not in (None, "incompressible")}
        held = {**values, **({"bulk_modulus": f"{values['bulk_modulus']!r} MPa"} if isinstance(values.get("bulk_modulus"), float) else {})}
        text = _native.toml_text({"tube": {"material": held}})
        # A muscle of nothing else says what is wrong with it.
        made = {"_held": _native.Muscle({}, text), "_text": text, "law": values["law"], "constants": {n: v for n, v in values.items() if n != "law"}}
        for name, value in made.items():
            object.__setattr__(self, name, value)
        return self

    @classmethod
    def _of(cls, table: Mapping[str, Any]) -> Rubber:
        return object.__new__(cls)._hold({name: value if name == "law" else _constant(name, value) for name, value in table.items()})

    @classmethod
    def from_toml(cls, text: str) -> Rubber:
        """The rubber of its table, or of a muscle file."""
        held = _native.toml("rubber", text).get("tube", {})
        if "material" not in held:
            raise InputError(f"the rubber is {held.get('rubber', 'paper')!r} of the library", kind="rubber", field="text")
        return cls._of(held["material"])

    def to_toml(self) -> str:
        """The table as in a muscle file."""
        return self._text

    def to_dict(self) -> dict[str, Any]:
        """Its law and constants, as the arguments of ``Rubber(…)``."""
        return {"law": self.law, **{"bulk_modulus_mpa" if n == "bulk_modulus" else n: v for n, v in self.constants.items()}}

    def replace(self, **constants: Plain) -> Rubber:
        """The same with other constants."""
        given: dict[str, Any] = {**self.to_dict(), **constants}
        return Rubber(**given)

    def stress(self, mode: Literal["uniaxial", "planar", "equibiaxial"], stretch: ArrayLike) -> NDArray[np.float64]:
        """Nominal stress (force over the area at rest) of the incompressible rubber in MPa, at stretches (length over that at rest)."""
        import numpy as np

        if mode not in ("uniaxial", "planar", "equibiaxial"):
            raise ValueError(f'mode: "uniaxial", "planar" or "equibiaxial", not {mode!r}')
        stretches = np.asarray(stretch, dtype=np.float64)
        return np.array(self._held.stress(mode, stretches.ravel().tolist())).reshape(stretches.shape)

    _key = to_toml

    def __reduce__(self) -> tuple[Any, ...]:
        return Rubber.from_toml, (self._text,)

    def __repr__(self) -> str:
        return f"Rubber({self.law!r}, {', '.join(f'{n}={v!r}' for n, v in self.to_dict().items() if n != 'law')})"


def _constant(name: str, value: Any) -> Any:
    """A constant of a law: a modulus in MPa, a plain number, a word, several of these, or a table of them."""
    if hasattr(value, "magnitude"):
        value = value.to("dimensionless" if value.dimensionless else "MPa").magnitude
    if isinstance(value, str):
        try:
            return _native.quantity("pressure_mpa", value)
        except InputError:
            # A word, or the text of another quantity: a time, a share.
            return value
    if value is None or isinstance(value, bool):
        return value
    if isinstance(value, Mapping):
        return {key: _constant(key, item) for key, item in value.items()}
    if hasattr(value, "__iter__") and getattr(value, "shape", None) != ():
        return [_constant(name, item) for item in value]
    return float(bare(name, value))
