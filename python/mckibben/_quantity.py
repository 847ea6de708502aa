"""Quantities as users write them: numbers in the unit of their name, texts with a unit, quantities of pint."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

from . import _native

# What a name's end says of its quantity, and the unit inside as pint writes it.
KINDS = [
    ("_n_per_mm", "stiffness", "N/mm"),
    ("_nm_per_rad", "angular-stiffness", "N*m/rad"),
    ("_n_s_per_m", "damping", "N*s/m"),
    ("_mpa", "pressure", "MPa"),
    ("_mm2", "area", "mm**2"),
    ("_mm", "length", "mm"),
    ("_deg", "angle", "deg"),
    ("_nm", "torque", "N*m"),
    ("_n", "force", "N"),
    ("_s", "time", "s"),
]
RATIOS = {"contraction", "contractions", "max_strand_strain", "modulus"}


def kind_of(name: str) -> tuple[str, str] | None:
    """The kind of quantity of a field, and its unit inside."""
    if name in RATIOS:
        return "ratio", "dimensionless"
    if name == "stiffness":
        return "stiffness", "N/mm"
    return next(((kind, unit) for end, kind, unit in KINDS if name.endswith(end)), None)


def wrong(field: str, message: str, hint: str = "") -> Exception:
    """A quantity that is none."""
    from ._errors import QuantityError

    return QuantityError(message, kind="quantity", hint=hint, field=field)


def number(name: str, value: Any) -> float:
    """A number in the unit of its name."""
    kind = kind_of(name)
    if isinstance(value, str):
        if kind is None:
            raise wrong(name, f'"{value}" is a text, and this is a plain number')
        return _native.quantity(value, kind[0], name)
    value = unpinted(name, value)
    if isinstance(value, bool) or not hasattr(value, "__float__"):
        raise TypeError(f"{name}: a number, a text with its unit or a quantity of pint, not {type(value).__name__}")
    if getattr(value, "shape", ()) != ():
        raise TypeError(f"{name}: one number, not an array; for arrays ask a model: muscle.model(…).force(pressures, contractions)")
    out = float(value)
    if not math.isfinite(out):
        raise wrong(name, f"{out} is not a finite number")
    return out


def unpinted(name: str, value: Any) -> Any:
    """The magnitude of a quantity of pint in the unit inside; anything else as it is."""
    if not (hasattr(value, "magnitude") and hasattr(value, "to")):
        return value
    kind = kind_of(name)
    try:
        return value.to(kind[1] if kind else "dimensionless").magnitude
    except Exception as error:
        raise wrong(name, f"{value} is not in a unit of {kind[1] if kind else 'a plain number'}: {error}") from None


def numbers(name: str, value: Any) -> list[Any]:
    """Several numbers; lists of lists stay such."""
    if isinstance(value, str):
        kind = kind_of(name)
        return _native.values(value, kind[0] if kind else "ratio", name)
    value = unpinted(name, value)
    if hasattr(value, "tolist"):
        value = value.tolist()
    if not isinstance(value, Iterable) or isinstance(value, (bytes, Mapping)):
        return [number(name, value)]
    return [numbers(name, item) if isinstance(item, (list, tuple)) else number(name, item) for item in value]
