"""Points of a muscle as arrays, with all that is known of them."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _quantity
from ._errors import InputError
from ._files import put
from ._quantity import array
from ._table import Table, Tabled

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

    from ._muscle import Muscle

class Solution(Tabled):
    """Points of a muscle as arrays of the shape that pressures and contractions have together: ``force_n``, ``uncertainty_n`` (its ±),
    ``volume_mm3``, ``stiffness_n_per_mm``, ``braid_tension_n``, ``slack``, ``status``, … are attributes.
    """

    __slots__ = ("_columns", "_model")
    _columns: dict[str, NDArray[Any]]
    _model: str

    def __init__(self, columns: dict[str, NDArray[Any]], model: str) -> None:
        for values in columns.values():
            values.flags.writeable = False
        self._columns, self._model = columns, model

    @property
    def model(self) -> str:
        """The model's name."""
        return self._model

    @property
    def shape(self) -> tuple[int, ...]:
        """That of each array."""
        return self._columns["pressure_mpa"].shape

    def __getattr__(self, name: str) -> NDArray[Any]:
        if name.startswith("_") or name not in self._columns:
            raise AttributeError(f"a solution has {', '.join(self._columns)}, not {name}" if not name.startswith("_") else name)
        values: NDArray[Any] = _quantity.dressed(name, self._columns[name])
        return values

    def __getitem__(self, name: str) -> NDArray[Any]:
        return self._columns[name]

    def keys(self) -> list[str]:
        """The names of the arrays."""
        return list(self._columns)

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._columns})

    def to_dict(self) -> dict[str, Any]:
        """Plain lists by name."""
        return {name: values.tolist() for name, values in self._columns.items()}

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Writes its points as CSV. Another file that is there is replaced only with ``overwrite``."""
        put({path: self.to_table().to_csv()}, overwrite)

    def to_table(self) -> Table:
        """A row for each point, in the order of the last index."""
        return Table({name: values.ravel() if values.dtype != object else values.ravel().tolist() for name, values in self._columns.items()})

    def to_xarray(self) -> xarray.Dataset:
        """A Dataset with the units as attributes. Where pressures and contractions span a grid, these are its dimensions."""
        import xarray as xr

        p, e = self._columns["pressure_mpa"], self._columns["contraction"]
        dims: list[str] = [f"dim_{axis}" for axis in range(p.ndim)]
        coords: dict[str, Any] = {}
        for name, own, other in (("pressure_mpa", p, e), ("contraction", e, p)):
            axes = [axis for axis in range(p.ndim) if p.shape[axis] > 1 and not (own == own.take([0], axis)).all()]
            if len(axes) == 1 and (other == other.take([0], axes[0])).all():
                dims[axes[0]] = name
                coords[name] = own[tuple(slice(None) if axis == axes[0] else 0 for axis in range(p.ndim))]
        out = xr.Dataset({name: (dims, values) for name, values in self._columns.items() if name not in coords}, coords, {"model": self._model})
        for column in out.variables:
            if unit := (_quantity.kind_of(str(column)) or ("", ""))[1]:
                out[column].attrs["units"] = unit
        return out

    def __repr__(self) -> str:
        force = self._columns["force_n"]
        some = force[np.isfinite(force)]
        between = f", pull {some.min():.4g} to {some.max():.4g} N" if some.size else ""
        return f"Solution({self._model}, {' x '.join(map(str, self.shape)) or 1} points{between}, {int((self._columns['status'] != 'ok').sum())} without an answer)"

    def _repr_html_(self) -> str:
        return f"<p>{self!r}</p>{self.to_table()._repr_html_()}"


def solved(muscle: Muscle, pressure_mpa: Any, contraction: Any, options: dict[str, Any]) -> Solution:
    """All that is known of points. Points of a grid are asked for at once, others pressure by pressure."""
    p, e = np.broadcast_arrays(array("pressure_mpa", pressure_mpa), array("contraction", contraction))
    if not (np.isfinite(p).all() and np.isfinite(e).all()):
        raise InputError("pressures and contractions are finite numbers", kind="quantity", field="pressure_mpa")
    shape, (p, e) = p.shape, (p.ravel(), e.ravel())
    if not p.size:
        raise InputError("no point", kind="range", field="pressure_mpa")
    pressures, of_p = np.unique(p, return_inverse=True)
    contractions, of_e = np.unique(e, return_inverse=True)
    ask: Callable[..., Any] = muscle.curve

    def curve(at: NDArray[np.float64], along: NDArray[np.float64]) -> Any:
        return ask("isobaric", pressures_mpa=at, contractions=along, **options)

    if len(pressures) * len(contractions) <= 4 * p.size:
        found = curve(pressures, contractions)
        model, columns, place = found.model, dict(_of(found)), of_p * len(contractions) + of_e
    else:
        parts, place, start, model = [], np.empty(p.size, dtype=np.intp), 0, ""
        for i, pressure in enumerate(pressures):
            own = np.flatnonzero(of_p == i)
            along, of_own = np.unique(e[own], return_inverse=True)
            found = curve(np.array([pressure]), along)
            model = found.model
            parts.append(dict(_of(found)))
            place[own] = start + of_own
            start += len(along)
        columns = {name: np.concatenate([part.get(name, np.full(len(part["force_n"]), np.nan)) for part in parts]) for name in {n: 0 for part in parts for n in part}}
    out = {name: values[place].reshape(shape) for name, values in columns.items()}
    out.update(pressure_mpa=np.array(p.reshape(shape)), contraction=np.array(e.reshape(shape)))
    return Solution(out, model)


def _of(curve: Any) -> Iterator[tuple[str, NDArray[Any]]]:
    table = curve.to_table()
    for name in table.columns:
        if name not in ("fixed", "cause"):
            values = table[name]
            yield name, values if isinstance(values, np.ndarray) else np.array(values, dtype=object)
