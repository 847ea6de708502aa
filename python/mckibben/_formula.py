"""Fitted formulas as files of JSON."""

from __future__ import annotations

import json
import os
from functools import lru_cache
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from . import _commands, _native
from ._errors import OutOfRangeError
from ._files import put
from ._quantity import array, dressed
from ._table import Fixed

if TYPE_CHECKING:
    from os import PathLike

    from numpy.typing import NDArray

    from ._inputs import Floats
    from ._model import Errors

# What it is a function of.
POINT = ("pressure_mpa", "contraction", "wall_mm", "outer_diameter_mm")
compiled = lru_cache(64)(_native.Formula)


class Formula(Fixed):
    """A fitted formula, as :func:`fit` makes it and its file (JSON) holds it. It is a model: ``muscle.force(0.2, 0.1, model=formula)``; and a function of pressures,
    contractions, walls and diameters: ``formula(pressure_mpa, contraction, wall_mm, outer_diameter_mm)``.

    Parameters
    ----------
    text
        The content of its file.
    name
        How it is named as a model; the name in the file where it is left out.
    """

    __slots__ = ("_name", "_text")
    _name: str
    _text: str

    def __init__(self, text: str, name: str | None = None) -> None:
        shown = _native.ask("check-formula", {"file": {"name": name or "the formula", "text": text}})
        object.__setattr__(self, "_text", text)
        object.__setattr__(self, "_name", name or str(shown["name"]))

    @classmethod
    def load(cls, path: str | PathLike[str]) -> Formula:
        """The formula of a file, such as :meth:`save` wrote."""
        return cls(_native.read_formula(os.fspath(path)))

    @overload
    def __call__(self, pressure_mpa: float, contraction: float, wall_mm: float, outer_diameter_mm: float, *, two_sided: bool = ..., extrapolate: bool = ..., errors: Errors = ...) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def __call__(self, pressure_mpa: Floats, contraction: Floats, wall_mm: Floats, outer_diameter_mm: Floats, *, two_sided: bool = ..., extrapolate: bool = ..., errors: Errors = ...) -> NDArray[np.float64]: ...

    def __call__(self, pressure_mpa: Any, contraction: Any, wall_mm: Any, outer_diameter_mm: Any, *, two_sided: bool = False, extrapolate: bool = False, errors: Errors = "raise") -> Any:
        """The pull of many muscles at once, in N; 0 where a muscle is slack. The rubber, the braid and the length are those for which it was made.

        Parameters
        ----------
        pressure_mpa : MPa
            Gauge pressures: numbers, a text with its unit, or quantities of pint; broadcast as NumPy does it.
        contraction : ratio
            Contraction ratios.
        wall_mm, outer_diameter_mm : mm
            Of the tubes.
        two_sided
            Negative pulls instead of slack.
        extrapolate
            Answer outside of its range.
        errors
            Outside of its range: ``raise``, or ``nan`` for NaN.

        Returns
        -------
        float or numpy.ndarray
            The pull, of the broadcast shape.
        """
        given = np.broadcast_arrays(*(array(name, value) for name, value in zip(POINT, (pressure_mpa, contraction, wall_mm, outer_diameter_mm))))
        points, formula = np.stack([values.ravel() for values in given]), compiled(self._name, self._text)
        out = np.empty(points.shape[1])
        first = formula.fill(points, out, extrapolate, two_sided)
        if first is not None and errors != "nan":
            where = [(name, value, ends) for name, value, ends in zip(POINT, points[:, first].tolist(), formula.range) if not ends[0] <= value <= ends[1]]
            name, value, (low, high) = where[0]
            text = f"{value:g} is outside of the formula's range, {low:g} to {high:g}"
            raise OutOfRangeError(text, kind="out_of_range", field=name, index=first, hint="extrapolate=True computes it all the same")
        return dressed("force_n", out.reshape(given[0].shape) if given[0].shape else float(out[0]))

    @property
    def name(self) -> str:
        """Its name."""
        return self._name

    def to_json(self) -> str:
        """The content of its file."""
        return self._text

    def to_dict(self) -> dict[str, Any]:
        """The same as plain dicts and lists."""
        return dict(json.loads(self._text))

    def save(self, path: str | PathLike[str], *, overwrite: bool = False) -> None:
        """Writes its file. Another one that is there is replaced only with ``overwrite``."""
        put({path: self._text}, overwrite)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Formula) and self._name == other._name and self.to_dict() == other.to_dict()

    def __hash__(self) -> int:
        return hash(("Formula", self._name, json.dumps(self.to_dict(), sort_keys=True)))

    def __reduce__(self) -> tuple[Any, ...]:
        return Formula, (self._text, self._name)

    def __repr__(self) -> str:
        return f"Formula({self._name!r})"

    def _repr_latex_(self) -> str | None:
        latex = _commands.check_formula(self, latex=True).latex
        return f"$${latex}$$" if latex and "\\begin{document}" not in latex else None
