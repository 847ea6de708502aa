"""Arrays as users write them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _quantity

if TYPE_CHECKING:
    from numpy.typing import NDArray


# One object; to compare it with another type takes longer than all else of a call.
FLOAT = np.dtype(np.float64)


def array(name: str, value: Any) -> NDArray[np.float64]:
    """Numbers in the unit of a name, without a copy where they are such already."""
    if type(value) is np.ndarray and value.dtype is FLOAT:
        return value
    if isinstance(value, str):
        several = ".." in value or "," in value
        return np.asarray(_quantity.numbers(name, value) if several else _quantity.number(name, value))
    value = _quantity.unpinted(name, value)
    if isinstance(value, (list, tuple)) and any(isinstance(v, str) or hasattr(v, "magnitude") for v in value):
        value = _quantity.numbers(name, value)
    array = np.asarray(value)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name}: numbers, a text with its unit or quantities of pint, not {array.dtype}")
    return np.asarray(array, dtype=np.float64)
