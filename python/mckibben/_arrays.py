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
    """Numbers in the unit of a name, without a copy where they are such already; masked ones stay masked."""
    if type(value) is np.ndarray and value.dtype is FLOAT:
        if name == "pressure_mpa" and value.size:
            _likely(name, value)
        # Numbers between others in a record may lie anywhere.
        return value if value.flags.aligned else value.copy()
    if isinstance(value, str):
        several = ".." in value or "," in value
        return np.asarray(_quantity.numbers(name, value) if several else _quantity.number(name, value))
    value = _quantity.unpinted(name, value)
    if isinstance(value, (list, tuple)) and any(isinstance(v, str) or hasattr(v, "magnitude") for v in value):
        value = _quantity.numbers(name, value)
    masked = isinstance(value, np.ma.MaskedArray)
    array: NDArray[Any] = value if masked else np.asarray(value)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name}: numbers, a text with its unit or quantities of pint, not {array.dtype}")
    if masked:
        return array.astype(np.float64)
    array = np.asarray(array, dtype=np.float64)
    if name == "pressure_mpa" and array.size:
        _likely(name, array)
    return array if array.flags.aligned else array.copy()


def _likely(name: str, values: NDArray[np.float64]) -> None:
    """In another unit they are all too large: the ends are enough."""
    _quantity.likely(name, max(values.item(0), values.item(-1)))


def any_masked(a: NDArray[Any], b: NDArray[Any]) -> bool:
    """Whether one of two is a masked array."""
    return type(a) is not np.ndarray and isinstance(a, np.ma.MaskedArray) or type(b) is not np.ndarray and isinstance(b, np.ma.MaskedArray)
