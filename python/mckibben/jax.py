"""A muscle in a loss of JAX: pulls, pressures and contractions as functions that ``jax.grad``, ``jax.jvp``, ``jax.vmap`` and ``jax.jit`` take."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import jax
import jax.numpy as jnp
import numpy as np

from ._errors import MckibbenError
from ._muscle import MEASURES
from ._request import is_nan

if TYPE_CHECKING:
    from typing import TypeAlias

    from numpy.typing import NDArray
    from typing_extensions import Unpack

    from ._api import Options
    from ._muscle import Muscle

    Array: TypeAlias = NDArray[np.float64]

_NO_SECOND = "finite elements have first derivatives only: take the model universal for second ones, or the outer product of residuals' gradients (Gauss-Newton)"
# Places and weights of differences of fourth order about a point, and from a point on.
_ABOUT = (
    np.array([-2.0, -1.0, 0.0, 1.0, 2.0]),
    np.array([1.0, -8.0, 0.0, 8.0, -1.0]) / 12,
)
_FROM = (
    np.array([0.0, 1.0, 2.0, 3.0, 4.0]),
    np.array([-25.0, 48.0, -36.0, 16.0, -3.0]) / 12,
)
# Steps of differences are this share of a value, or of what is usual where that is less.
_STEP = 1e-3
_USUAL = {"force": (0.1, 0.2), "pressure": (100.0, 0.2), "contraction": (100.0, 0.1)}


class _Asked:
    """One of ``force``, ``pressure``, ``contraction`` of a muscle by a model, as a function of two arrays and of θ."""

    def __init__(
        self,
        muscle: Muscle,
        wanted: str,
        names: Sequence[str],
        errors: str,
        options: dict[str, Any],
    ) -> None:
        self.muscle, self.wanted, self.names, self.nan, self.options = (
            muscle,
            wanted,
            tuple(names),
            is_nan(errors),
            options,
        )
        if unknown := [
            name
            for name in names
            if name not in MEASURES and name not in muscle.parameters
        ]:
            raise ValueError(
                f"{unknown[0]}: there is {', '.join([*MEASURES, *muscle.parameters])}"
            )
        # Which model it is, and whether there is one.
        self.has_second = not muscle._bound(options).native.is_elements
        # The axis that the derivatives of an order need: none, values and slopes, or second derivatives row by row.
        self.widths = (), (3 + len(names),), ((2 + len(names)) ** 2,)

    def at(self, theta: Array) -> tuple[Muscle, list[str], Array]:
        """The muscle with these values, and how its parameters change with each, of which one that is a value itself follows no measure."""
        values = dict(zip(self.names, theta.tolist()))
        measures = {name: value for name, value in values.items() if name in MEASURES}
        own = {name: value for name, value in values.items() if name not in MEASURES}
        muscle = self.muscle._changed(measures) if measures else self.muscle
        return muscle.with_parameters(own) if own else muscle, *muscle._chain(
            self.names, own
        )

    def second(self, a: Array, b: Array, theta: Array) -> Array:
        """Second derivatives at one θ: differences of slopes, which closed forms have to their last digits. Slack muscles have none."""
        smooth = _Asked(
            self.muscle,
            self.wanted,
            self.names,
            "nan" if self.nan else "raise",
            {**self.options, "extrapolate": True, "two_sided": True},
        )
        values: list[Any] = [*np.broadcast_arrays(a, b), *theta]
        rows: list[Array] = []
        for i, (value, usual) in enumerate(
            zip(values, (*_USUAL[self.wanted], *abs(theta)))
        ):
            h = _STEP * (np.maximum(abs(value), usual) if usual else 1.0)
            # Not below zero: no gauge pressure is, and no pull.
            about = (
                (value >= 2 * h) | (i > 1) | (i == 1 and self.wanted != "contraction")
            )
            row: Any = 0.0
            for at, by in zip(
                np.transpose([_ABOUT[0], _FROM[0]]), np.transpose([_ABOUT[1], _FROM[1]])
            ):
                moved = [
                    *values[:i],
                    value + np.where(about, *at) * h,
                    *values[i + 1 :],
                ]
                row = (
                    row
                    + (np.where(about, *by) / h)[..., None]
                    * smooth.one(moved[0], moved[1], np.array(moved[2:]), 1)[..., 1:]
                )
            rows.append(row)
        out = np.stack(rows, axis=-1)
        # What is equal differs by rounding alone.
        out = 0.5 * (out + out.swapaxes(-1, -2))
        if self.wanted == "force" and not self.options.get("two_sided"):
            out = np.where((self.one(a, b, theta, 0) == 0)[..., None, None], 0.0, out)
        return out.reshape(*values[0].shape, -1)

    def one(self, a: Array, b: Array, theta: Array, order: int) -> Array:
        """The values, or with an axis more at the end derivatives of an order, at one θ."""
        try:
            if order == 2:
                return self.second(a, b, theta)
            muscle, own, by = self.at(theta)
            found = getattr(muscle, self.wanted)(
                a,
                b,
                jac=(own or True) if order else False,
                errors="nan" if self.nan else "raise",
                **self.options,
            )
        except MckibbenError:
            # A muscle that cannot be.
            if not self.nan:
                raise
            return np.full(
                (*np.broadcast_shapes(a.shape, b.shape), *self.widths[order]), np.nan
            )
        if not order:
            return np.asarray(found)
        return np.concatenate(
            [
                np.asarray(found[0])[..., None],
                found[1][..., :2],
                found[1][..., 2:] @ by,
            ],
            axis=-1,
        )

    def many(self, a: Any, b: Any, theta: Any, order: int) -> Array:
        """The same where all three may have axes of a batch in front, as many as θ has more than one."""
        a, b, theta = (np.asarray(v, dtype=np.float64) for v in (a, b, theta))
        if theta.size == theta.shape[-1]:
            return self.one(a, b, theta.reshape(-1), order)
        deep = theta.ndim - 1
        axes = np.broadcast_shapes(*(v.shape[:deep] for v in (a, b, theta)))
        a, b, theta = (np.broadcast_to(v, axes + v.shape[deep:]) for v in (a, b, theta))
        parts = [self.one(a[i], b[i], theta[i], order) for i in np.ndindex(axes)]
        return np.stack(parts).reshape(axes + parts[0].shape)


def force(
    muscle: Muscle,
    wrt: Sequence[str] = (),
    *,
    errors: str = "raise",
    **options: Unpack[Options],
) -> Callable[..., jax.Array]:
    """F(P, ε; θ) of a muscle as a function of JAX with its first and second derivatives (``jax.custom_jvp``): ``f(pressure_mpa, contraction)``, or
    ``f(pressure_mpa, contraction, theta)`` with the values of the names in their order, of the broadcast shape of pressures and contractions.

    Parameters
    ----------
    muscle
        The muscle.
    wrt
        Names of constants and measures of the muscle (see :attr:`Muscle.parameters`, in MPa, N/mm, mm, degrees) that the function takes as well, all others
        held; or measures as :meth:`Muscle.replace` has them: ``outer_diameter_mm``, ``wall_mm``, …; k of a named braid follows the diameter.
    errors
        ``raise``, or ``nan``: NaN at points without an answer and for muscles that cannot be, so that a sampler goes on.
    options
        Which model, and how it is asked, as in :meth:`Muscle.force`.

    Raises
    ------
    ValueError
        A muscle has no constant or measure of that name.
    """
    return _function(_Asked(muscle, "force", wrt, errors, dict(options)))


def pressure(
    muscle: Muscle,
    wrt: Sequence[str] = (),
    *,
    errors: str = "raise",
    **options: Unpack[Options],
) -> Callable[..., jax.Array]:
    """P(F, ε; θ) of a muscle: ``f(force_n, contraction)`` or ``f(force_n, contraction, theta)`` in MPa; arguments as in :func:`force`."""
    return _function(_Asked(muscle, "pressure", wrt, errors, dict(options)))


def contraction(
    muscle: Muscle,
    wrt: Sequence[str] = (),
    *,
    errors: str = "raise",
    **options: Unpack[Options],
) -> Callable[..., jax.Array]:
    """ε(F, P; θ) of a muscle: ``f(force_n, pressure_mpa)`` or ``f(force_n, pressure_mpa, theta)``; arguments as in :func:`force`."""
    return _function(_Asked(muscle, "contraction", wrt, errors, dict(options)))


def _function(asked: _Asked) -> Callable[..., jax.Array]:
    count = len(asked.names)

    def of_order(order: int) -> jax.custom_jvp[Any]:
        def call(a: Any, b: Any, theta: Any) -> Any:
            shape, kind = (
                jnp.broadcast_shapes(jnp.shape(a), jnp.shape(b)),
                jnp.result_type(float),
            )
            # As many axes each, so that those of a batch come in front of all.
            a, b = (
                jnp.reshape(v, (1,) * (len(shape) - jnp.ndim(v)) + jnp.shape(v))
                for v in (a, b)
            )
            struct: Any = jax.ShapeDtypeStruct
            ask = lambda a, b, theta: np.asarray(
                asked.many(a, b, theta, order), dtype=kind
            )
            return jax.pure_callback(
                ask,
                struct((*shape, *asked.widths[order]), kind),
                a,
                b,
                theta,
                vmap_method="expand_dims",
            )

        return jax.custom_jvp(call)

    value, slopes, curvatures = map(of_order, range(3))

    def along(rates: Any, by: Any) -> Any:
        """How what has these rates changes along a direction."""
        return (
            rates[..., 0] * by[0]
            + rates[..., 1] * by[1]
            + (rates[..., 2:] @ by[2] if count else 0.0)
        )

    @value.defjvp
    def first(at: Any, by: Any) -> Any:
        found = slopes(*at)
        return found[..., 0], along(found[..., 1:], by)

    @slopes.defjvp
    def second(at: Any, by: Any) -> Any:
        if not asked.has_second:
            raise NotImplementedError(_NO_SECOND)
        found, rates = slopes(*at), curvatures(*at)
        rows = [
            along(found[..., 1:], by),
            *(
                along(rates[..., i * (2 + count) : (i + 1) * (2 + count)], by)
                for i in range(2 + count)
            ),
        ]
        return found, jnp.stack(rows, axis=-1)

    @curvatures.defjvp
    def third(at: Any, by: Any) -> Any:
        raise NotImplementedError("a model has first and second derivatives only")

    def outer(first: Any, second: Any = 0.0, theta: Any = ()) -> jax.Array:
        numbers = [
            jnp.asarray(v, dtype=jnp.result_type(float)) for v in (first, second, theta)
        ]
        if numbers[2].shape != (count,):
            raise ValueError(
                f"theta holds the values of {list(asked.names)}, not {numbers[2].shape}"
            )
        found: jax.Array = value(*numbers)
        return found

    return outer
