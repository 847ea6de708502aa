"""Numbers of answers as quantities of pint.

>>> import mckibben as mk
>>> from mckibben import units
>>> str(units.quantity("pressure_mpa", 0.25).to("bar"))
'2.5 bar'

Quantities of pint are arguments everywhere in the package; this is the way back.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._native import unit_of as unit_of
from ._request import unit_for_pint

if TYPE_CHECKING:
    from ._record import Record

__all__ = ["quantities", "quantity", "unit_of"]


def quantity(name: str, value: Any, registry: Any = None) -> Any:
    """A number or an array in the unit that a name carries, as a quantity of a registry (that of the application where it is left out)."""
    import pint

    pints: Any = pint
    return (registry or pints.get_application_registry()).Quantity(
        value, unit_for_pint(name)
    )


def quantities(answer: Record, registry: Any = None) -> dict[str, Any]:
    """The numbers and arrays of an answer that have a unit, by name, as quantities."""
    return {
        name: quantity(name, value, registry)
        for name, value in answer._fields().items()
        if unit_of(name) and (isinstance(value, float) or hasattr(value, "dtype"))
    }
