"""Quantities as users write them: numbers in the unit of their name, texts with a unit, quantities of pint."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _native
from ._errors import InputError, UnitWarning, warned

if TYPE_CHECKING:
    from numpy.typing import NDArray

# Kind of quantity and unit of a field.
Kind = tuple["str | None", str]


@lru_cache(1000)
def kind_of(name: str) -> Kind | None:
    """The kind of quantity and the unit that a name carries; none of a plain number. For what has no schema, such as columns of a table."""
    return _native.unit_of(name)


@lru_cache(1000)
def bare(name: str) -> str:
    """A name without the unit that it carries: ``outer_diameter`` of ``outer_diameter_mm``."""
    kind, words = kind_of(name), name.split("_")
    ends = range(len(words) - 1, 0, -1) if kind and kind[1] else ()
    return next(("_".join(words[:i]) for i in ends if kind_of("_".join(["x", *words[i:]])) == kind), name)


def typed(name: str, text: str, kind: Kind | None) -> str:
    """The kind of quantity of a field that accepts a text with a unit."""
    kind = kind or kind_of(name)
    if kind is None or kind[0] is None:
        raise wrong(name, f'"{text}" is a text, and this is a plain number')
    return kind[0]


def unit_for_pint(name: str, kind: Kind | None = None) -> str:
    """The unit of a field as pint writes it."""
    kind = kind or kind_of(name)
    return re.sub(r"(?<=[a-z])(?=[23]\b)", "**", kind[1]) if kind and kind[1] else "dimensionless"


def wrong(field: str, message: str, hint: str = "") -> Exception:
    """A quantity that is none."""
    return InputError(message, kind="quantity", hint=hint, field=field)


# The registry of pint whose quantities are returned; None: plain numbers.
REGISTRY: Any = None


def dressed(name: str, value: Any) -> Any:
    """A number or array as a quantity, where these are wanted."""
    if REGISTRY is None or not (isinstance(value, float) or getattr(value, "dtype", None) == float):
        return value
    kind = kind_of(name)
    return value if kind is None else REGISTRY.Quantity(value, unit_for_pint(name, kind))


def number(name: str, value: Any, kind: Kind | None = None) -> float:
    """A number in the unit of its field."""
    if isinstance(value, str):
        return _native.quantity(value, typed(name, value, kind), name)
    given, value = value, unpinted(name, value, kind)
    if isinstance(value, bool) or not hasattr(value, "__float__"):
        raise TypeError(f"{name}: a number, a text with its unit or a quantity of pint, not {type(value).__name__}")
    if getattr(value, "shape", ()) != ():
        raise TypeError(f"{name}: one number, not an array; muscle.force(pressures, contractions) takes arrays")
    out = float(value)
    if not math.isfinite(out):
        raise wrong(name, f"{out} is not a finite number")
    if given is value:
        likely(name, out)
    return out


# Bare numbers beyond what muscles have, and the units in which they were likely meant.
_UNLIKELY = {
    "outer_diameter_mm": (1.0, 1000.0), "wall_mm": (0.02, 100.0), "length_mm": (3.0, 30_000.0),
    "pressure_mpa": (0.0, 5.0), "pressures_mpa": (0.0, 5.0), "max_pressure_mpa": (0.0, 5.0),
}


def likely(name: str, value: float) -> None:
    """Warns of a bare number that was likely meant in another unit."""
    if not math.isfinite(value):
        return
    bounds = _UNLIKELY.get(name)
    if bounds is None or value <= 0 or bounds[0] <= value <= bounds[1]:
        return
    if name.endswith("mpa"):
        unit, factor = ("Pa", 1e-6) if value >= 1e4 else ("kPa", 1e-3) if value >= 50 else ("bar", 0.1)
        said, meant = "MPa", f"{value * factor:g} MPa"
    else:
        unit, factor = ("m", 1e3) if value < bounds[0] else ("um", 1e-3)
        said, meant = "mm", f"{value * factor:g} mm"
    bare = name.rsplit("_", 1)[0]
    text = f'{name}={value:g} is {value:g} {said}; if {value:g} {unit} is meant, give {meant}, or {bare}="{value:g} {unit}"'
    warned(text, UnitWarning)


def unpinted(name: str, value: Any, kind: Kind | None = None) -> Any:
    """The magnitude of a quantity of pint in the unit inside; anything else as it is."""
    if not (hasattr(value, "magnitude") and hasattr(value, "to")):
        return value
    unit = unit_for_pint(name, kind)
    try:
        return value.to(unit).magnitude
    except Exception as error:
        raise wrong(name, f"{value} is not in a unit of {'a plain number' if unit == 'dimensionless' else unit}: {error}") from None


def numbers(name: str, value: Any, kind: Kind | None = None) -> list[Any]:
    """Several numbers; lists of lists stay such."""
    if isinstance(value, str):
        return _native.values(value, typed(name, value, kind), name)
    value = unpinted(name, value, kind)
    if hasattr(value, "mask") and hasattr(value, "compressed") and value.mask.any():
        raise wrong(name, "some values are masked", "leave them out: values.compressed()")
    if hasattr(value, "tolist"):
        value = value.tolist()
    if not isinstance(value, Iterable) or isinstance(value, (bytes, Mapping)):
        return [number(name, value, kind)]
    return [numbers(name, item, kind) if isinstance(item, (list, tuple)) else number(name, item, kind) for item in value]


# One object; to compare it with another type takes longer than all else of a call.
FLOAT = np.dtype(np.float64)


def array(name: str, value: Any) -> NDArray[np.float64]:
    """Numbers in the unit of a name, without a copy where they are such already; masked ones stay masked."""
    if type(value) is np.ndarray and value.dtype is FLOAT:
        if name == "pressure_mpa" and value.size:
            likely(name, max(value.item(0), value.item(-1)))
        # Numbers between others in a record may lie anywhere.
        return value if value.flags.aligned else value.copy()
    if isinstance(value, str):
        several = ".." in value or "," in value
        return np.asarray(numbers(name, value) if several else number(name, value))
    value = unpinted(name, value)
    if isinstance(value, (list, tuple)) and any(isinstance(v, str) or hasattr(v, "magnitude") for v in value):
        value = numbers(name, value)
    masked = isinstance(value, np.ma.MaskedArray)
    array: NDArray[Any] = value if masked else np.asarray(value)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name}: numbers, a text with its unit or quantities of pint, not {array.dtype}")
    if masked:
        return array.astype(np.float64)
    array = np.asarray(array, dtype=np.float64)
    if name == "pressure_mpa" and array.size:
        # In another unit they are all too large: the ends are enough.
        likely(name, max(array.item(0), array.item(-1)))
    return array if array.flags.aligned else array.copy()
