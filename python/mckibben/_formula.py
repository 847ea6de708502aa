"""Fitted formulas as files of JSON."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Literal, overload

from . import _api, _native
from ._errors import OutOfRangeError
from ._request import Saved
from ._values import array

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ._values import Floats

    Errors = Literal["raise", "nan"]

# What it is a function of.
_POINT = ("pressure_mpa", "contraction", "wall_mm", "outer_diameter_mm")


class Formula(Saved):
    """A fitted formula, as :func:`fit` makes it and its file (JSON) holds it. It is a model: ``muscle.force(0.2, 0.1, model=formula)``; and a function of pressures,
    contractions, walls and diameters: ``formula(pressure_mpa, contraction, wall_mm, outer_diameter_mm)``.

    Parameters
    ----------
    text
        The content of its file.
    name
        How it is named as a model; the name in the file where it is left out.

    Raises
    ------
    InputError
        The text is not that of a formula.
    """

    __slots__ = ("_compiled", "_name", "_text")
    _name: str
    _text: str
    _compiled: _native.Formula | None

    def __init__(self, text: str, name: str | None = None) -> None:
        shown = _native.ask("check-formula", {"file": {"name": name or "the formula", "text": text}})
        for slot, value in (("_text", text), ("_name", name or str(shown["name"])), ("_compiled", None)):
            object.__setattr__(self, slot, value)

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

        Raises
        ------
        OutOfRangeError
            A point lies outside of its range.
        """
        import numpy as np

        given = np.broadcast_arrays(*(array(name, value) for name, value in zip(_POINT, (pressure_mpa, contraction, wall_mm, outer_diameter_mm))))
        points, out = np.stack([values.ravel() for values in given]), np.empty(given[0].size)
        if self._compiled is None:
            object.__setattr__(self, "_compiled", _native.Formula(self._name, self._text))
        assert self._compiled is not None
        first = self._compiled.fill(points, out, extrapolate, two_sided)
        if first is not None and errors != "nan":
            name, value, (low, high) = next((n, v, ends) for n, v, ends in zip(_POINT, points[:, first].tolist(), self._compiled.range) if not ends[0] <= v <= ends[1])
            text = f"{value:g} is outside of the formula's range, {low:g} to {high:g}"
            raise OutOfRangeError(text, kind="out_of_range", field=name, index=first, hint="extrapolate=True computes it all the same")
        return out.reshape(given[0].shape) if given[0].shape else float(out[0])

    @property
    def name(self) -> str:
        """Its name."""
        return self._name

    def check(self, *, latex: bool = False) -> _api.FormulaCheck:
        """What it was made for, its range and its errors; with `latex` the equation as well."""
        return _api.check_formula(self, latex=latex)

    def to_json(self) -> str:
        """The content of its file."""
        return self._text

    def to_dict(self) -> dict[str, Any]:
        """The same as plain dicts and lists."""
        return dict(json.loads(self._text))

    _key = to_json

    def __reduce__(self) -> tuple[Any, ...]:
        return Formula, (self._text, self._name)

    def __repr__(self) -> str:
        return f"<Formula {self._name!r}>"

    def _repr_latex_(self) -> str | None:
        latex = self.check(latex=True).latex
        return f"$${latex}$$" if latex and "\\begin{document}" not in latex else None
