"""Pulls, pressures and contractions of numbers and arrays, and models that answer them."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np

from . import _native, _plain, _quantity
from ._ask import Progress, listening
from ._commands import spelled
from ._errors import MckibbenError
from ._quantity import array
from ._table import Fixed

if TYPE_CHECKING:
    from os import PathLike

    from numpy.typing import NDArray

    from ._formula import Formula
    from ._inputs import Floats, FormulaLike, Option, Plain
    from ._muscle import Muscle

Errors = Literal["raise", "nan"]

# Measures of a muscle, as :meth:`Muscle.replace` has them, by which there are derivatives.
MEASURES = ("outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "stiffness")
# A list of pairs has so many places at most: what a machine could address.
_MOST = 2**47


class Asked:
    """What answers numbers and arrays: a muscle, or a model of one."""

    __slots__ = ()

    def _bound(self, options: dict[str, Any]) -> Model:
        """The model that is asked."""
        raise NotImplementedError

    def _numbers(self, wanted: str, unit: str, a_name: str, a: Any, b_name: str, b: Any, jac: bool | Sequence[str], errors: str, progress: Progress, options: dict[str, Any]) -> Any:
        if options:
            # By their names without the unit.
            given = spelled(wanted, options, (a_name, b_name))
            a, b, options = given.pop(a_name, a), given.pop(b_name, b), given
        if a is None or b is None:
            raise TypeError(f"{wanted}() needs {a_name if a is None else b_name}")
        if errors not in ("raise", "nan"):
            raise ValueError(f'errors: "raise" or "nan", not {errors!r}')
        found = self._bound(options)._fill(wanted, a_name, a, b_name, b, jac, errors == "nan", progress)
        if _quantity.REGISTRY is None:
            return found
        return (_quantity.dressed(unit, found[0]), found[1]) if isinstance(found, tuple) else _quantity.dressed(unit, found)

    @overload
    def force(self, pressure_mpa: float, contraction: float = ..., *, jac: Literal[False] = ..., errors: Errors = ..., progress: Progress = ..., **options: Option) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def force(self, pressure_mpa: Floats, contraction: Floats = ..., *, jac: Literal[False] = ..., errors: Errors = ..., progress: Progress = ..., **options: Option) -> NDArray[np.float64]: ...
    @overload
    def force(self, pressure_mpa: float, contraction: float = ..., *, jac: Literal[True] | Sequence[str], errors: Errors = ..., progress: Progress = ..., **options: Option) -> tuple[float, NDArray[np.float64]]: ...  # type: ignore[overload-overlap]
    @overload
    def force(self, pressure_mpa: Floats, contraction: Floats = ..., *, jac: Literal[True] | Sequence[str], errors: Errors = ..., progress: Progress = ..., **options: Option) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...

    def force(self, pressure_mpa: Any = None, contraction: Any = 0.0, *, jac: bool | Sequence[str] = False, errors: Errors = "raise", progress: Progress = None, **options: Any) -> Any:
        """F(P, ε): the pull, in N; 0 where the muscle is slack.

        Parameters
        ----------
        pressure_mpa : MPa
            Gauge pressures P: numbers, a text such as ``"2.5 bar"`` or ``"0..2.5:0.5 bar"``, or quantities of pint. What is masked
            (``numpy.ma``) is not asked for.
        contraction : ratio
            Contraction ratios ε = ΔL/L0, broadcast against the pressures.
        jac
            True for the derivatives as well; or names of constants and measures of the muscle (see :attr:`Muscle.parameters`) for the
            derivatives by these too, all others held: k of the strands as well, where the diameter changes. ``outer_diameter_mm``,
            ``wall_mm``, ``length_mm``, ``angle_deg`` and ``stiffness`` are those by :meth:`Muscle.replace`: k of a named braid follows the
            diameter. Those of finite elements come from the factorised tangent of the equilibrium itself.
        errors
            ``raise`` for the first point without an answer, ``nan`` for NaN there.
        progress
            True for a line on standard error, or a function that is called with (done, total).
        options
            Those of :class:`Model`: ``model``, ``mesh``, ``extrapolate``, …

        Returns
        -------
        float or numpy.ndarray
            The pull, of the broadcast shape; a masked array where one of the two is. With ``jac`` a pair: the pull, and an array with one axis more: ∂F/∂P in N/MPa, ∂F/∂ε in
            N, then ∂F/∂θ of each name, in N per its unit, all other constants held.
        """
        return self._numbers("force", "force_n", "pressure_mpa", pressure_mpa, "contraction", contraction, jac, errors, progress, options)

    @overload
    def pressure(self, force_n: float, contraction: float = ..., *, jac: Literal[False] = ..., errors: Errors = ..., progress: Progress = ..., **options: Option) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def pressure(self, force_n: Floats, contraction: Floats = ..., *, jac: Literal[False] = ..., errors: Errors = ..., progress: Progress = ..., **options: Option) -> NDArray[np.float64]: ...
    @overload
    def pressure(self, force_n: float, contraction: float = ..., *, jac: Literal[True] | Sequence[str], errors: Errors = ..., progress: Progress = ..., **options: Option) -> tuple[float, NDArray[np.float64]]: ...  # type: ignore[overload-overlap]
    @overload
    def pressure(self, force_n: Floats, contraction: Floats = ..., *, jac: Literal[True] | Sequence[str], errors: Errors = ..., progress: Progress = ..., **options: Option) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...

    def pressure(self, force_n: Any = None, contraction: Any = 0.0, *, jac: bool | Sequence[str] = False, errors: Errors = "raise", progress: Progress = None, **options: Any) -> Any:
        """P(F, ε): the pressure that gives a pull, in MPa.

        Parameters
        ----------
        force_n : N
            Pulls F.
        contraction : ratio
            Contraction ratios ε, broadcast against them.
        jac
            As in :meth:`force`: ∂P/∂F, ∂P/∂ε, then ∂P/∂θ, by implicit differentiation.
        errors, progress, options
            As in :meth:`force`.

        Returns
        -------
        float or numpy.ndarray
            The pressure; with ``jac`` a pair.
        """
        return self._numbers("pressure", "pressure_mpa", "force_n", force_n, "contraction", contraction, jac, errors, progress, options)

    @overload
    def contraction(self, force_n: float, pressure_mpa: float, *, jac: Literal[False] = ..., errors: Errors = ..., progress: Progress = ..., **options: Option) -> float: ...  # type: ignore[overload-overlap]
    @overload
    def contraction(self, force_n: Floats, pressure_mpa: Floats, *, jac: Literal[False] = ..., errors: Errors = ..., progress: Progress = ..., **options: Option) -> NDArray[np.float64]: ...
    @overload
    def contraction(self, force_n: float, pressure_mpa: float, *, jac: Literal[True] | Sequence[str], errors: Errors = ..., progress: Progress = ..., **options: Option) -> tuple[float, NDArray[np.float64]]: ...  # type: ignore[overload-overlap]
    @overload
    def contraction(self, force_n: Floats, pressure_mpa: Floats, *, jac: Literal[True] | Sequence[str], errors: Errors = ..., progress: Progress = ..., **options: Option) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...

    def contraction(self, force_n: Any = None, pressure_mpa: Any = None, *, jac: bool | Sequence[str] = False, errors: Errors = "raise", progress: Progress = None, **options: Any) -> Any:
        """ε(F, P): the contraction at which a pressure gives a pull.

        Parameters
        ----------
        force_n : N
            Pulls F.
        pressure_mpa : MPa
            Gauge pressures P, broadcast against them.
        jac
            As in :meth:`force`: ∂ε/∂F, ∂ε/∂P, then ∂ε/∂θ, by implicit differentiation.
        errors, progress, options
            As in :meth:`force`.

        Returns
        -------
        float or numpy.ndarray
            The contraction ratio; with ``jac`` a pair.
        """
        return self._numbers("contraction", "contraction", "force_n", force_n, "pressure_mpa", pressure_mpa, jac, errors, progress, options)


class Model(Asked, Fixed):
    """A model of one muscle: F(P, ε) and its inverses over arrays of any shape, with derivatives.

    Parameters
    ----------
    muscle
        A muscle.
    model
        Its name: ``fe`` (where it is left out), ``universal``, ``thick-wall``, ``ideal``, ``paper``, …; the path of a fitted formula, or a
        :class:`Formula`.
    formulas
        More fitted formulas, which are models by their names.
    mesh
        Mesh of the finite elements, as in :func:`force`.
    match, terminal
        Of ``fe3d``, as in :func:`force`.
    extrapolate
        Answer outside of the model's range.
    two_sided
        Negative force instead of slack where the muscle would have to push.
    direction
        Branch of the friction hysteresis: ``mean``, ``contraction``, ``elongation``.

    Examples
    --------
    >>> import numpy as np
    >>> paper = Model(Muscle(outer_diameter_mm=50, wall_mm=1, length_mm=285), "paper")
    >>> paper.force(0.25, np.array([0.0, 0.1])).round(1)
    array([2684.7, 1511.2])
    """

    __slots__ = ("_muscle", "_native", "_request")
    _muscle: Muscle
    _request: dict[str, Any]
    _native: _native.Model

    def __init__(
        self,
        muscle: Muscle,
        model: str | Formula | PathLike[str] | None = None,
        *,
        formulas: Sequence[FormulaLike] | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: Mapping[str, Plain] | None = None,
        extrapolate: bool = False,
        two_sided: bool = False,
        direction: Literal["mean", "contraction", "elongation"] | None = None,
    ) -> None:
        values = {
            "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal,
            "extrapolate": extrapolate, "two_sided": two_sided, "direction": direction,
        }
        self._hold(muscle, _plain.request("force", values))

    def _hold(self, muscle: Muscle, request: dict[str, Any]) -> None:
        object.__setattr__(self, "_muscle", muscle)
        object.__setattr__(self, "_request", request)
        object.__setattr__(self, "_native", _native.Model(muscle.to_toml(), request))

    @property
    def muscle(self) -> Muscle:
        """Its muscle."""
        return self._muscle

    @property
    def name(self) -> str:
        """Its name."""
        return self._native.name

    def of(self, muscle: Muscle) -> Model:
        """The same model of another muscle."""
        return _restored(muscle, self._request)

    def _bound(self, options: dict[str, Any]) -> Model:
        if options:
            raise TypeError(f"a model is asked with its own options; {next(iter(options))!r} is an argument of Model()")
        return self

    def _with(self, options: dict[str, Any]) -> Model:
        """The same asked in another way."""
        return _restored(self._muscle, {**self._request, **options})

    def _fill(self, wanted: str, a_name: str, a: Any, b_name: str, b: Any, jac: bool | Sequence[str], nan: bool, progress: Progress) -> Any:
        # Most calls are of two numbers: they take a microsecond, and every line here a part of one.
        if jac is False and progress is None and type(a) is float and type(b) is float:
            if a > 5.0 and wanted == "force" or b > 5.0 and wanted == "contraction":
                _quantity.likely("pressure_mpa", a if wanted == "force" else b)
            return self._native.one(wanted, a, b, nan)
        a, b = array(a_name, a), array(b_name, b)
        if isinstance(a, np.ma.MaskedArray) or isinstance(b, np.ma.MaskedArray):
            return self._masked(wanted, a_name, a, b_name, b, jac, nan, progress)
        shape = np.broadcast_shapes(a.shape, b.shape)
        names = [] if isinstance(jac, (bool, np.bool_)) else [jac] if isinstance(jac, str) else list(jac)
        if any(name in MEASURES for name in names):
            return self._by_measures(wanted, a_name, a, b_name, b, names, nan, progress)
        slopes = bool(names) or bool(jac)
        width = 3 + len(names) if slopes else 1
        if math.prod(shape) > _MOST // width:
            raise MemoryError(f"{math.prod(shape)} points are more than memory holds")
        out = np.empty((*shape, width) if slopes else shape)
        with listening(progress, wanted) as heard:
            first, second = (np.broadcast_to(values, shape).ravel() for values in (a, b))
            self._native.fill(wanted, first, second, out.reshape(-1), slopes, names, nan, heard)
        if slopes:
            return out[..., 0] if shape else float(out[0]), out[..., 1:]
        return out if shape else float(out)

    def _by_measures(self, wanted: str, a_name: str, a: Any, b_name: str, b: Any, names: list[str], nan: bool, progress: Progress) -> Any:
        """With derivatives by measures of the muscle: all parameters that follow a measure change with it."""
        rows = [self._muscle._follows(name) if name in MEASURES else {name: 1.0} for name in names]
        own = list(dict.fromkeys(parameter for row in rows for parameter in row))
        found, slopes = self._fill(wanted, a_name, a, b_name, b, own, nan, progress)
        by = np.array([[row.get(parameter, 0.0) for parameter in own] for row in rows])
        return found, np.concatenate([slopes[..., :2], slopes[..., 2:] @ by.T], axis=-1)

    def _masked(self, wanted: str, a_name: str, a: Any, b_name: str, b: Any, jac: bool | Sequence[str], nan: bool, progress: Progress) -> Any:
        """What is masked is not asked for, and its answer is masked."""
        a, b = np.ma.asarray(a), np.ma.asarray(b)
        mask = np.logical_or(*np.broadcast_arrays(np.ma.getmaskarray(a), np.ma.getmaskarray(b)))
        first, second = np.broadcast_arrays(a.data, b.data)
        asked = ~mask
        try:
            found = self._fill(wanted, a_name, first[asked], b_name, second[asked], jac, nan, progress)
        except MckibbenError as error:
            if error.index is None:
                raise
            # Its place among all.
            raise error.at(int(np.flatnonzero(asked)[error.index])) from None

        def whole(values: NDArray[np.float64]) -> Any:
            out = np.full(mask.shape + values.shape[1:], np.nan)
            out[asked] = values
            over = np.array(np.broadcast_to(mask.reshape(mask.shape + (1,) * (out.ndim - mask.ndim)), out.shape))
            return np.ma.array(out, mask=over)

        return tuple(map(whole, found)) if isinstance(found, tuple) else whole(found)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Model) and self._muscle == other._muscle and self._request == other._request

    def __hash__(self) -> int:
        return hash(("Model", self._muscle, json.dumps(self._request, sort_keys=True)))

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._muscle, self._request)

    def __repr__(self) -> str:
        return f"Model({self.name!r}, {self._muscle!r})"


def _restored(muscle: Muscle, request: dict[str, Any]) -> Model:
    model = object.__new__(Model)
    model._hold(muscle, request)
    return model
