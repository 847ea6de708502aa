"""Pulls, pressures and contractions of arrays, with derivatives."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import MckibbenError
from ._api import Solution
from ._request import array, heard

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._muscle import Bound
    from ._request import Progress

# Measures of a muscle, as :meth:`Muscle.replace` has them, by which there are derivatives.
MEASURES = ("outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "stiffness")
# The names of both numbers of a pair, by what is wanted.
PAIRS = {"force": ("pressure_mpa", "contraction"), "pressure": ("force_n", "contraction"), "contraction": ("force_n", "pressure_mpa")}


def asked(bound: Bound, wanted: str, a: Any, b: Any, jac: bool | Sequence[str], nan: bool, progress: Progress) -> Any:
    """A number or an array of the broadcast shape; with `jac` also the derivatives along one axis more."""
    texts = isinstance(a, str), isinstance(b, str)
    a, b = (array(name, value) for name, value in zip(PAIRS[wanted], (a, b)))
    if isinstance(a, np.ma.MaskedArray) or isinstance(b, np.ma.MaskedArray):
        return _masked(bound, wanted, a, b, jac, nan, progress)
    shape = np.broadcast_shapes(a.shape, b.shape)
    names = [] if isinstance(jac, (bool, np.bool_)) else [jac] if isinstance(jac, str) else list(jac)
    if any(name in MEASURES for name in names):
        return _by_measures(bound, wanted, a, b, names, nan, progress)
    slopes = bool(names) or bool(jac)
    first, second = (np.broadcast_to(values, shape).ravel() for values in (a, b))
    out = np.empty((*shape, 3 + len(names)) if slopes else shape)
    bound.native.fill(wanted, first, second, out.reshape(-1), slopes, names, nan, heard(progress, wanted))
    value = out[..., 0] if slopes else out
    bound.look({"force": first, "pressure": value.ravel(), "contraction": second}[wanted], value.ravel() if wanted == "contraction" else second, texts[wanted == "contraction"])
    if not slopes:
        return out if shape else float(out)
    return value if shape else float(value), out[..., 1:]


def _by_measures(bound: Bound, wanted: str, a: Any, b: Any, names: list[str], nan: bool, progress: Progress) -> Any:
    """With derivatives by measures of the muscle: all parameters that follow a measure change with it."""
    rows = [bound.muscle._follows(name) if name in MEASURES else {name: 1.0} for name in names]
    own = list(dict.fromkeys(parameter for row in rows for parameter in row))
    found, slopes = asked(bound, wanted, a, b, own, nan, progress)
    by = np.array([[row.get(parameter, 0.0) for parameter in own] for row in rows])
    return found, np.concatenate([slopes[..., :2], slopes[..., 2:] @ by.T], axis=-1)


def _masked(bound: Bound, wanted: str, a: Any, b: Any, jac: bool | Sequence[str], nan: bool, progress: Progress) -> Any:
    """What is masked is not asked for, and its answer is masked."""
    a, b = np.ma.asarray(a), np.ma.asarray(b)
    mask = np.logical_or(*np.broadcast_arrays(np.ma.getmaskarray(a), np.ma.getmaskarray(b)))
    first, second = np.broadcast_arrays(a.data, b.data)
    try:
        found = asked(bound, wanted, first[~mask], second[~mask], jac, nan, progress)
    except MckibbenError as error:
        if error.index is None:
            raise
        # Its place among all.
        error.index = int(np.flatnonzero(~mask)[error.index])
        raise

    def whole(values: NDArray[np.float64]) -> Any:
        out = np.full(mask.shape + values.shape[1:], np.nan)
        out[~mask] = values
        over = np.array(np.broadcast_to(mask.reshape(mask.shape + (1,) * (out.ndim - mask.ndim)), out.shape))
        return np.ma.array(out, mask=over)

    return tuple(map(whole, found)) if isinstance(found, tuple) else whole(found)


def solved(bound: Bound, pressure_mpa: Any, contraction: Any, nan: bool, progress: Progress) -> Solution:
    """All that is known of points as arrays of the broadcast shape, and what is to be known of them."""
    p, e = np.broadcast_arrays(array("pressure_mpa", pressure_mpa), array("contraction", contraction))
    rows = bound.native.solve(p.ravel().tolist(), e.ravel().tolist(), nan, heard(progress, "solve"))
    texts = list(dict.fromkeys(text for row in rows for text in row.get("warnings", ())))
    names = dict.fromkeys(name for row in rows for name, value in row.items() if isinstance(value, (int, float)) and name != "slack")
    columns: dict[str, list[Any]] = {name: [row.get(name) for row in rows] for name in names}
    for name, without in (("slack", False), ("status", "ok"), ("cause", "")):
        columns[name] = [row.get(name, without) for row in rows]
    columns["warned"] = [sum(1 << texts.index(text) for text in set(row.get("warnings", ()))) for row in rows]
    return Solution._read({**columns, "pressure_mpa": p, "contraction": e, "model": bound.native.name, "warnings": texts})
