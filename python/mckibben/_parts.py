"""Rubbers by their law and constants, fitted formulas, and all that was saved."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, TypeVar, overload

from . import _api, _native
from ._motion import Drive, Joint
from ._muscle import Muscle
from ._errors import FileError, InputError, blamed, checked, wrong_type
from ._request import Saved, array, arrays, bare, is_nan, listed, numpy as np, place

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._request import Array, Errors, Floats, Number, PathLike, Plain

    Kind = TypeVar("Kind")


class Rubber(Saved):
    """A rubber by its law and constants. A rubber of the library is named by its name alone, as in ``Muscle(rubber="dragon-skin-30")``.

    Parameters
    ----------
    law
        ``neo-hookean`` (mu), ``mooney-rivlin`` (c10, c01), ``yeoh`` (c10, c20, c30), ``gent`` (mu, jm), ``ogden`` (mu = […], alpha = […]), …
    bulk_modulus_mpa : MPa
        The bulk modulus; ``incompressible`` where it is left out. Only the finite elements use it.
    constants
        Those of the law: moduli in MPa or with their unit (``"120 kPa"``), the others plain numbers.

    Raises
    ------
    InputError
        No law has this name, or these constants are not those of a rubber.

    Examples
    --------
    >>> import mckibben as mk
    >>> mk.Rubber("mooney-rivlin", c10="120 kPa", c01=0)
    Rubber('mooney-rivlin', c10=0.12, c01=0.0)
    """

    law: str
    constants: dict[str, Any]
    _held: _native.Muscle
    _text: str

    def __init__(
        self,
        law: str,
        *,
        bulk_modulus_mpa: Number | Literal["incompressible"] | None = None,
        **constants: Plain,
    ) -> None:
        given = {n: _constant(n, v) for n, v in constants.items() if v is not None}
        material = {"law": checked("law", law, str), **given}
        if bulk_modulus_mpa not in (None, "incompressible"):
            bulk = _constant("bulk_modulus_mpa", bulk_modulus_mpa)
            given["bulk_modulus_mpa"] = bulk
            material["bulk_modulus"] = f"{bulk} MPa"
        text = _native.toml_text({"tube": {"material": material}})
        # A muscle of nothing else says what is wrong with it.
        native = _native.Muscle({"muscle": {"file": {"name": "rubber", "text": text}}})
        self._hold(_held=native, _text=text, law=law, constants=given)

    @classmethod
    def from_toml(cls, text: str) -> Rubber:
        """The rubber of its table, or of a muscle file."""
        held = _native.toml("rubber", checked("text", text, str)).get("tube", {})
        if "material" not in held:
            raise InputError(
                f"the rubber is {held.get('rubber', 'antonelli2018')!r} of the library",
                kind="rubber",
                field="text",
            )
        material = held["material"]
        return cls(bulk_modulus_mpa=material.pop("bulk_modulus", None), **material)

    def to_toml(self) -> str:
        """The table as in a muscle file."""
        return self._text

    def to_dict(self) -> dict[str, Any]:
        """Its law and constants, as the arguments of ``Rubber(…)``."""
        return {"law": self.law, **self.constants}

    def replace(self, **constants: Plain) -> Rubber:
        """The same with other constants."""
        given = {**self.to_dict(), **constants}
        return Rubber(**given)

    def stress(
        self, mode: Literal["uniaxial", "planar", "equibiaxial"], stretch: ArrayLike
    ) -> Array:
        """Nominal stress (force over the area at rest) of the incompressible rubber in MPa, at stretches (length over that at rest).

        Examples
        --------
        >>> import mckibben as mk
        >>> mk.Rubber("neo-hookean", mu=0.4).stress("uniaxial", [1.0, 2.0]).round(3)
        array([0. , 0.7])
        """
        stretches = array("stretch", stretch)
        mode = checked("mode", mode, str)
        found = self._held.stress(mode, stretches.ravel().tolist())
        return np.reshape(found, stretches.shape)

    _key = to_toml

    def __repr__(self) -> str:
        return f"Rubber({self.law!r}, {listed(self.constants)})"


def _constant(name: str, value: Any) -> Any:
    """A constant of a law: a modulus in MPa, a plain number, a word, several of these, or a table of them."""
    if isinstance(value, str):
        try:
            return _native.quantity("pressure_mpa", value)
        except InputError:
            # A word, or the text of another quantity: a time, a share.
            return value
    if isinstance(value, Mapping):
        return {key: _constant(key, item) for key, item in value.items()}
    value = bare(
        "ratio" if getattr(value, "dimensionless", False) else "pressure_mpa", value
    )
    if hasattr(value, "__iter__") and getattr(value, "shape", None) != ():
        return [_constant(name, item) for item in value]
    if not hasattr(value, "__float__"):
        raise wrong_type(name, "a number or text", value)
    return value if isinstance(value, bool) else float(value)


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

    name: str
    _held: _native.Formula
    _text: str

    def __init__(self, text: str, name: str | None = None) -> None:
        file = checked("name", name or "the formula", str)
        with blamed("text"):
            native = _native.Formula(file, checked("text", text, str))
        self._hold(_held=native, _text=text, name=name or json.loads(text)["name"])

    @overload
    def __call__(  # type: ignore[overload-overlap]
        self,
        pressure_mpa: float,
        contraction: float,
        wall_mm: float,
        outer_diameter_mm: float,
        *,
        two_sided: bool = ...,
        extrapolate: bool = ...,
        errors: Errors = ...,
    ) -> float: ...
    @overload
    def __call__(
        self,
        pressure_mpa: Floats,
        contraction: Floats,
        wall_mm: Floats,
        outer_diameter_mm: Floats,
        *,
        two_sided: bool = ...,
        extrapolate: bool = ...,
        errors: Errors = ...,
    ) -> Array: ...

    def __call__(
        self,
        pressure_mpa: Any,
        contraction: Any,
        wall_mm: Any,
        outer_diameter_mm: Any,
        *,
        two_sided: bool = False,
        extrapolate: bool = False,
        errors: Errors = "raise",
    ) -> Any:
        """The pull of many muscles at once in N, of the broadcast shape; 0 where a muscle is slack. The rubber, the braid and the length are those for which it was made.

        Parameters
        ----------
        pressure_mpa, contraction, wall_mm, outer_diameter_mm : MPa, ratio, mm, mm
            Gauge pressures, contraction ratios and tubes: numbers, a text with its unit, or quantities of pint; broadcast as NumPy does it,
            or by their labels, which the answer has too (xarray, pandas).
        two_sided
            Negative pulls instead of slack.
        extrapolate, errors
            Outside of its range: an answer with ``extrapolate``, else an exception, or NaN with ``errors="nan"``.

        Raises
        ------
        OutOfRangeError
            A point lies outside of its range.
        """
        given, labelled = arrays(
            ("pressure_mpa", pressure_mpa),
            ("contraction", contraction),
            ("wall_mm", wall_mm),
            ("outer_diameter_mm", outer_diameter_mm),
            missing=np.nan,
        )
        points = np.stack(np.broadcast_arrays(*given), axis=-1)
        out = np.empty(points.shape[:-1])
        checked("extrapolate", extrapolate, bool, np.bool_)
        checked("two_sided", two_sided, bool, np.bool_)
        how = extrapolate, two_sided, is_nan(errors)
        with blamed(is_one=out.ndim == 0):
            self._held.fill(points.reshape(-1, 4), out.reshape(-1), *how)
        return labelled("force_n", out)

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

    def __reduce__(self) -> Any:
        return Formula, (self._text, self.name)

    def __repr__(self) -> str:
        return f"<Formula {self.name!r}>"

    def _repr_latex_(self) -> str | None:
        latex = self.check(latex=True).latex
        return f"$${latex}$$" if latex and "\\begin{document}" not in latex else None


@overload
def load(path: PathLike) -> Any: ...
@overload
def load(path: PathLike, kind: type[Kind]) -> Kind: ...
def load(path: PathLike, kind: type[Any] = object) -> Any:
    """What ``save()`` wrote or a person did: a muscle, a rubber, a joint or a drive (TOML), a formula or an answer (JSON); a muscle of the library by ``lib:NAME``.

    Parameters
    ----------
    path
        The file.
    kind
        The class that it is to be, such as ``mk.Joint``: with it the type is known to those who check types.

    Raises
    ------
    FileError
        It is none of these, or of another class.

    Examples
    --------
    >>> import mckibben as mk
    >>> mk.load("lib:dmsp-20-300", mk.Muscle).length_mm
    300.0
    """
    is_named = place("path", path).lower().startswith("lib:")
    with blamed("path"):
        held = _native.read(path, "muscle" if is_named else "table")
        text = held["text"]
        if text.lstrip().startswith("{"):
            try:
                held = json.loads(text)
                if "mckibben" in held:
                    kind_of = getattr(_api, held["mckibben"])
                    found = kind_of._read(held["data"], held["asked"])
                else:
                    found = Formula(text)
            except (AttributeError, KeyError, json.JSONDecodeError) as error:
                raise FileError(f"{path}: not what was saved: {error}") from None
        elif text.startswith("[tube.material]"):
            # A muscle that was saved begins with a comment.
            found = Rubber.from_toml(text)
        else:
            tables = _native.toml(held["name"], text)
            of = Drive if "command" in tables else Joint if "joint" in tables else None
            found = of._of(_native.read(path, of._kind)) if of else Muscle._of(held)
    if not isinstance(found, checked("kind", kind, type)):
        said = f"{path} holds a {type(found).__name__}, not a {kind.__name__}"
        raise FileError(said, field="kind")
    return found
