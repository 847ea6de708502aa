"""A muscle in a loss of JAX: the pull and its derivatives as a function that ``jax.grad``, ``jax.jvp`` and ``jax.jit`` take."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import jax
import jax.numpy as jnp
import numpy as np

if TYPE_CHECKING:
    from ._model import Model


def force(model: Model, parameters: Sequence[str] = ()) -> Callable[..., Any]:
    """F(P, ε; θ) of a model as a function of JAX with its first derivatives (``jax.custom_jvp``).

    JAX computes with 32 bits unless ``jax.config.update("jax_enable_x64", True)`` says otherwise.

    Parameters
    ----------
    model
        The model.
    parameters
        Names of constants and measures of the muscle (see :attr:`Muscle.parameters`) that the function takes as well.

    Returns
    -------
    function
        ``f(pressure_mpa, contraction)``, or ``f(pressure_mpa, contraction, theta)`` with the values of the parameters in their order, in
        MPa, N/mm, mm, degrees. The result has the broadcast shape of pressures and contractions.
    """
    names = tuple(parameters)

    def asked(p: Any, e: Any, theta: Any) -> Any:
        values = np.asarray(theta, dtype=np.float64)
        bound = model.of(model.muscle.with_parameters(dict(zip(names, values)))) if names else model
        value, slopes = bound.force(np.asarray(p, dtype=np.float64), np.asarray(e, dtype=np.float64), jac=names or True)
        return np.concatenate([np.asarray(value)[..., None], slopes], axis=-1).astype(dtype())

    def dtype() -> Any:
        return jnp.result_type(float)

    def all_of(p: Any, e: Any, theta: Any) -> Any:
        shape = (*jnp.broadcast_shapes(jnp.shape(p), jnp.shape(e)), 3 + len(names))
        struct: Any = jax.ShapeDtypeStruct
        return jax.pure_callback(asked, struct(shape, dtype()), p, e, theta, vmap_method="sequential")

    @jax.custom_jvp
    def pull(p: Any, e: Any, theta: Any) -> Any:
        return all_of(p, e, theta)[..., 0]

    @pull.defjvp
    def moved(at: Any, by: Any) -> Any:
        found = all_of(*at)
        p, e, theta = by
        change = found[..., 1] * p + found[..., 2] * e
        return found[..., 0], change + found[..., 3:] @ theta if names else change

    def outer(pressure_mpa: Any, contraction: Any = 0.0, theta: Any = ()) -> Any:
        values = jnp.asarray(theta, dtype=dtype())
        if values.shape != (len(names),):
            raise ValueError(f"theta holds the values of {list(names)}, not {values.shape}")
        return pull(jnp.asarray(pressure_mpa, dtype=dtype()), jnp.asarray(contraction, dtype=dtype()), values)

    return outer
