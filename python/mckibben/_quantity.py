"""Quantities as users write them: numbers in the unit of their name, texts with a unit, quantities of pint."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from typing import Any

from . import _native
from ._fields import GROUPS

# What fields of these names measure and their unit, once asked for: a question takes a part of a microsecond.
_KNOWN: dict[str, tuple[str | None, str] | None] = {}


def kind_of(name: str, within: str = "") -> tuple[str | None, str] | None:
    """The kind of quantity of a field and its unit, as the field's group or its name has it; None of a plain number."""
    group = GROUPS.get(within)
    if group is not None and name in group:
        return group[name]
    if name not in _KNOWN:
        if len(_KNOWN) > 1000:
            _KNOWN.clear()
        _KNOWN[name] = _native.unit_of(name)
    return _KNOWN[name]


def typed(name: str, text: str, within: str) -> str:
    """The kind of quantity of a field in which a text with a unit may stand."""
    kind = kind_of(name, within)
    if kind is None or kind[0] is None:
        raise wrong(name, f'"{text}" is a text, and this is a plain number')
    return kind[0]


def unit_for_pint(name: str, within: str = "") -> str:
    """The unit of a field as pint writes it."""
    kind = kind_of(name, within)
    return re.sub(r"(?<=[a-z])(?=[23]\b)", "**", kind[1]) if kind and kind[1] else "dimensionless"


def wrong(field: str, message: str, hint: str = "") -> Exception:
    """A quantity that is none."""
    from ._errors import QuantityError

    return QuantityError(message, kind="quantity", hint=hint, field=field)


def number(name: str, value: Any, within: str = "") -> float:
    """A number in the unit of its field."""
    if isinstance(value, str):
        return _native.quantity(value, typed(name, value, within), name)
    value = unpinted(name, value, within)
    if isinstance(value, bool) or not hasattr(value, "__float__"):
        raise TypeError(f"{name}: a number, a text with its unit or a quantity of pint, not {type(value).__name__}")
    if getattr(value, "shape", ()) != ():
        raise TypeError(f"{name}: one number, not an array; for arrays ask a model: muscle.model(…).force(pressures, contractions)")
    out = float(value)
    if not math.isfinite(out):
        raise wrong(name, f"{out} is not a finite number")
    return out


def unpinted(name: str, value: Any, within: str = "") -> Any:
    """The magnitude of a quantity of pint in the unit inside; anything else as it is."""
    if not (hasattr(value, "magnitude") and hasattr(value, "to")):
        return value
    unit = unit_for_pint(name, within)
    try:
        return value.to(unit).magnitude
    except Exception as error:
        raise wrong(name, f"{value} is not in a unit of {'a plain number' if unit == 'dimensionless' else unit}: {error}") from None


def numbers(name: str, value: Any, within: str = "") -> list[Any]:
    """Several numbers; lists of lists stay such."""
    if isinstance(value, str):
        return _native.values(value, typed(name, value, within), name)
    value = unpinted(name, value, within)
    if hasattr(value, "mask") and hasattr(value, "compressed") and value.mask.any():
        raise wrong(name, "some values are masked", "leave them out: values.compressed()")
    if hasattr(value, "tolist"):
        value = value.tolist()
    if not isinstance(value, Iterable) or isinstance(value, (bytes, Mapping)):
        return [number(name, value, within)]
    return [numbers(name, item, within) if isinstance(item, (list, tuple)) else number(name, item, within) for item in value]
