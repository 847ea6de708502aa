"""A muscle in a loss of JAX: pulls, pressures and contractions as functions that ``jax.grad``, ``jax.jvp``, ``jax.vmap`` and ``jax.jit`` take."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import jax
import jax.numpy as jnp
import numpy as np

from ._bridge import NO_SECOND, NO_THIRD, Asked

if TYPE_CHECKING:
    from ._model import Model


def force(model: Model, parameters: Sequence[str] = (), *, wrt: Sequence[str] = (), errors: str = "raise") -> Callable[..., jax.Array]:
    """F(P, ε; θ) of a model as a function of JAX with its first and second derivatives (``jax.custom_jvp``). Finite elements have first ones only,
    and say so.

    ``jax.vmap`` of it asks the model once for all points, unless θ differs from point to point. A value alone costs no derivatives. JAX computes
    with 32 bits unless ``jax.config.update("jax_enable_x64", True)`` says otherwise.

    Parameters
    ----------
    model
        The model.
    parameters
        Names of constants and measures of the muscle (see :attr:`Muscle.parameters`) that the function takes as well, all others held.
    wrt
        More of them, or measures as :meth:`Muscle.replace` has them: ``outer_diameter_mm``, ``wall_mm``, ``length_mm``, ``angle_deg``,
        ``stiffness``; k of a named braid follows the diameter.
    errors
        ``raise``, or ``nan``: NaN at points without an answer and for muscles that cannot be, so that a sampler goes on.

    Returns
    -------
    function
        ``f(pressure_mpa, contraction)``, or ``f(pressure_mpa, contraction, theta)`` with the values of the names in their order, in
        MPa, N/mm, mm, degrees. The result has the broadcast shape of pressures and contractions.
    """
    return _function(Asked(model, "force", [*parameters, *wrt], errors))


def pressure(model: Model, parameters: Sequence[str] = (), *, wrt: Sequence[str] = (), errors: str = "raise") -> Callable[..., jax.Array]:
    """P(F, ε; θ) of a model: ``f(force_n, contraction)`` or ``f(force_n, contraction, theta)`` in MPa; arguments as in :func:`force`."""
    return _function(Asked(model, "pressure", [*parameters, *wrt], errors))


def contraction(model: Model, parameters: Sequence[str] = (), *, wrt: Sequence[str] = (), errors: str = "raise") -> Callable[..., jax.Array]:
    """ε(F, P; θ) of a model: ``f(force_n, pressure_mpa)`` or ``f(force_n, pressure_mpa, theta)``; arguments as in :func:`force`."""
    return _function(Asked(model, "contraction", [*parameters, *wrt], errors))


def _function(asked: Asked) -> Callable[..., jax.Array]:
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
        raise NotImplementedError(NO_THIRD)

    @slopes.defjvp
    def second(at: Any, by: Any) -> Any:
        if not asked.has_second:
            raise NotImplementedError(NO_SECOND)
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
