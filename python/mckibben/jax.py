"""A muscle in a loss of JAX: pulls, pressures and contractions as functions that ``jax.grad``, ``jax.jvp``, ``jax.vmap`` and ``jax.jit`` take."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import jax
import jax.numpy as jnp
import numpy as np

from ._arrays import MEASURES
from ._errors import MckibbenError

if TYPE_CHECKING:
    from typing import TypeAlias

    from numpy.typing import NDArray
    from typing_extensions import Unpack

    from ._muscle import Muscle
    from ._values import Options

    Array: TypeAlias = NDArray[np.float64]

_NO_SECOND = "finite elements have first derivatives only: take the model universal for second ones, or the outer product of residuals' gradients (Gauss-Newton)"
_NO_THIRD = "a model has first and second derivatives only"
# Places and weights of differences of fourth order about a point, and from a point on.
_ABOUT = np.array([-2.0, -1.0, 0.0, 1.0, 2.0]), np.array([1.0, -8.0, 0.0, 8.0, -1.0]) / 12
_FROM = np.array([0.0, 1.0, 2.0, 3.0, 4.0]), np.array([-25.0, 48.0, -36.0, 16.0, -3.0]) / 12
# Steps of differences are this share of a value, or of what is usual where that is less.
_STEP = 1e-3
_USUAL = {"force": (0.1, 0.2), "pressure": (100.0, 0.2), "contraction": (100.0, 0.1)}


class _Asked:
    """One of ``force``, ``pressure``, ``contraction`` of a muscle by a model, as a function of two arrays and of θ."""

    def __init__(self, muscle: Muscle, wanted: str, names: Sequence[str], errors: str, options: dict[str, Any]) -> None:
        if errors not in ("raise", "nan"):
            raise ValueError(f'errors: "raise" or "nan", not {errors!r}')
        self.muscle, self.wanted, self.names, self.errors, self.options = muscle, wanted, tuple(names), errors, options
        if unknown := [name for name in names if name not in MEASURES and name not in muscle.parameters]:
            raise ValueError(f"{unknown[0]}: there is {', '.join([*MEASURES, *muscle.parameters])}")
        # Which model it is, and whether there is one.
        self.has_second = not muscle._bound(options).native.is_elements

    def at(self, theta: Array) -> tuple[Muscle, list[dict[str, float]]]:
        """The muscle with these values, and how its parameters change with each."""
        if not self.names:
            return self.muscle, []
        values = dict(zip(self.names, map(float, theta)))
        measures = {name: value for name, value in values.items() if name in MEASURES}
        muscle = self.muscle._changed(dict(measures)) if measures else self.muscle
        own = {name: value for name, value in values.items() if name not in MEASURES}
        # A parameter that is a value itself follows no measure.
        rows = [{n: v for n, v in muscle._follows(name).items() if n not in own} if name in measures else {name: 1.0} for name in self.names]
        return muscle.with_parameters(own) if own else muscle, rows

    def widths(self, order: int) -> tuple[int, ...]:
        """The axis that the derivatives of an order need: none, values and slopes, or second derivatives row by row."""
        count = len(self.names)
        return ((), (3 + count,), ((2 + count) ** 2,))[order]

    def second(self, a: Array, b: Array, theta: Array) -> Array:
        """Second derivatives at one θ: differences of slopes, which closed forms have to their last digits. Slack muscles have none."""
        a, b = np.broadcast_arrays(a, b)
        smooth = _Asked(self.muscle, self.wanted, self.names, self.errors, {**self.options, "extrapolate": True, "two_sided": True})
        rows: list[Array] = []
        for i, (value, usual) in enumerate(zip((a, b), _USUAL[self.wanted])):
            h = _STEP * np.maximum(abs(value), usual)
            # Not below zero: no gauge pressure is, and no pull.
            at, by = (np.where((value >= 2 * h) | (i == 1 and self.wanted != "contraction"), *(v.reshape(5, *[1] * value.ndim) for v in pair)) for pair in zip(_ABOUT, _FROM))
            moved = value + at * h
            found = smooth.one(*((moved, b[None]) if i == 0 else (a[None], moved)), theta, 1)
            rows.append((by[..., None] * found).sum(axis=0)[..., 1:] / h[..., None])
        for i, number in enumerate(theta.tolist()):
            step = _STEP * (abs(number) or 1.0)
            beside = [by * smooth.one(a, b, theta + at * step * np.eye(len(theta))[i], 1) for at, by in zip(*_ABOUT) if by]
            rows.append(np.sum(beside, axis=0)[..., 1:] / step)
        out = np.stack(rows, axis=-1)
        # What is equal differs by rounding alone.
        out = 0.5 * (out + out.swapaxes(-1, -2))
        if self.wanted == "force" and not self.options.get("two_sided"):
            value = self.one(a, b, theta, 0)
            out = np.where((value == 0)[..., None, None], 0.0, out)
        return out.reshape(*a.shape, -1)

    def one(self, a: Array, b: Array, theta: Array, order: int) -> Array:
        """The values, or with an axis more at the end derivatives of an order, at one θ."""
        shape, slopes = np.broadcast_shapes(a.shape, b.shape), order == 1
        try:
            if order == 2:
                return self.second(a, b, theta)
            muscle, rows = self.at(theta)
            own = list(dict.fromkeys(parameter for row in rows for parameter in row))
            found = getattr(muscle, self.wanted)(a, b, jac=(own or True) if slopes else False, errors=self.errors, **self.options)
        except MckibbenError:
            # A muscle that cannot be.
            if self.errors == "raise":
                raise
            return np.full((*shape, *self.widths(order)), np.nan)
        if not slopes:
            return np.asarray(found)
        by = np.array([[row.get(parameter, 0.0) for parameter in own] for row in rows]).reshape(len(rows), len(own))
        return np.concatenate([np.asarray(found[0])[..., None], found[1][..., :2], found[1][..., 2:] @ by.T], axis=-1)

    def many(self, a: Any, b: Any, theta: Any, order: int) -> Array:
        """The same where all three may have axes of a batch in front, as many as θ has more than one."""
        a, b, theta = (np.asarray(v, dtype=np.float64) for v in (a, b, theta))
        batch = theta.shape[:-1]
        if not theta.size or theta.size == theta.shape[-1]:
            return self.one(a, b, theta.reshape(-1), order)
        axes = np.broadcast_shapes(batch, a.shape[: len(batch)], b.shape[: len(batch)])
        a, b = (np.broadcast_to(v, axes + v.shape[len(batch):]) for v in (a, b))
        theta = np.broadcast_to(theta, axes + theta.shape[-1:])
        parts = [self.one(a[i], b[i], theta[i], order) for i in np.ndindex(axes)]
        return np.stack(parts).reshape(axes + parts[0].shape)


def force(muscle: Muscle, wrt: Sequence[str] = (), *, errors: str = "raise", **options: Unpack[Options]) -> Callable[..., jax.Array]:
    """F(P, ε; θ) of a muscle as a function of JAX with its first and second derivatives (``jax.custom_jvp``). Finite elements have first ones only,
    and say so.

    ``jax.vmap`` of it asks the model once for all points, unless θ differs from point to point. A value alone costs no derivatives. JAX computes
    with 32 bits unless ``jax.config.update("jax_enable_x64", True)`` says otherwise.

    Parameters
    ----------
    muscle
        The muscle.
    wrt
        Names of constants and measures of the muscle (see :attr:`Muscle.parameters`) that the function takes as well, all others held;
        or measures as :meth:`Muscle.replace` has them: ``outer_diameter_mm``, ``wall_mm``, ``length_mm``, ``angle_deg``,
        ``stiffness``; k of a named braid follows the diameter.
    errors
        ``raise``, or ``nan``: NaN at points without an answer and for muscles that cannot be, so that a sampler goes on.
    options
        Which model, and how it is asked, as in :meth:`Muscle.force`.

    Returns
    -------
    function
        ``f(pressure_mpa, contraction)``, or ``f(pressure_mpa, contraction, theta)`` with the values of the names in their order, in
        MPa, N/mm, mm, degrees. The result has the broadcast shape of pressures and contractions.

    Raises
    ------
    ValueError
        A muscle has no constant or measure of that name.
    """
    return _function(_Asked(muscle, "force", wrt, errors, dict(options)))


def pressure(muscle: Muscle, wrt: Sequence[str] = (), *, errors: str = "raise", **options: Unpack[Options]) -> Callable[..., jax.Array]:
    """P(F, ε; θ) of a muscle: ``f(force_n, contraction)`` or ``f(force_n, contraction, theta)`` in MPa; arguments as in :func:`force`."""
    return _function(_Asked(muscle, "pressure", wrt, errors, dict(options)))


def contraction(muscle: Muscle, wrt: Sequence[str] = (), *, errors: str = "raise", **options: Unpack[Options]) -> Callable[..., jax.Array]:
    """ε(F, P; θ) of a muscle: ``f(force_n, pressure_mpa)`` or ``f(force_n, pressure_mpa, theta)``; arguments as in :func:`force`."""
    return _function(_Asked(muscle, "contraction", wrt, errors, dict(options)))


def _function(asked: _Asked) -> Callable[..., jax.Array]:
    count = len(asked.names)

    def call(a: Any, b: Any, theta: Any, order: int) -> Any:
        shape = jnp.broadcast_shapes(jnp.shape(a), jnp.shape(b))
        # As many axes each, so that those of a batch come in front of all.
        a, b = (jnp.reshape(v, (1,) * (len(shape) - jnp.ndim(v)) + jnp.shape(v)) for v in (a, b))
        kind = jnp.result_type(float)

        def ask(a: Any, b: Any, theta: Any) -> Any:
            return np.asarray(asked.many(a, b, theta, order), dtype=kind)

        struct: Any = jax.ShapeDtypeStruct
        return jax.pure_callback(ask, struct((*shape, *asked.widths(order)), kind), a, b, theta, vmap_method="expand_dims")

    @jax.custom_jvp
    def value(a: Any, b: Any, theta: Any) -> Any:
        return call(a, b, theta, 0)

    @jax.custom_jvp
    def slopes(a: Any, b: Any, theta: Any) -> Any:
        return call(a, b, theta, 1)

    @jax.custom_jvp
    def curvatures(a: Any, b: Any, theta: Any) -> Any:
        return call(a, b, theta, 2)

    def along(rates: Any, by: Any) -> Any:
        """How what has these rates changes along a direction."""
        a, b, theta = by
        change = rates[..., 0] * a + rates[..., 1] * b
        return change + rates[..., 2:] @ theta if count else change

    @curvatures.defjvp
    def third(at: Any, by: Any) -> Any:
        raise NotImplementedError(_NO_THIRD)

    @slopes.defjvp
    def second(at: Any, by: Any) -> Any:
        if not asked.has_second:
            raise NotImplementedError(_NO_SECOND)
        found, rates = slopes(*at), curvatures(*at)
        rows = [along(found[..., 1:], by), *(along(rates[..., i * (2 + count) : (i + 1) * (2 + count)], by) for i in range(2 + count))]
        return found, jnp.stack(rows, axis=-1)

    @value.defjvp
    def moved(at: Any, by: Any) -> Any:
        found = slopes(*at)
        return found[..., 0], along(found[..., 1:], by)

    def outer(first: Any, second: Any = 0.0, theta: Any = ()) -> jax.Array:
        kind = jnp.result_type(float)
        values = jnp.asarray(theta, dtype=kind)
        if values.shape != (count,):
            raise ValueError(f"theta holds the values of {list(asked.names)}, not {values.shape}")
        found: jax.Array = value(jnp.asarray(first, dtype=kind), jnp.asarray(second, dtype=kind), values)
        return found

    return outer
