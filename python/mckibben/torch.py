"""A muscle in a loss of PyTorch: pulls, pressures and contractions as functions that ``backward()`` goes through."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import torch

from ._bridge import Asked

if TYPE_CHECKING:
    from ._model import Model


def force(model: Model, parameters: Sequence[str] = (), *, wrt: Sequence[str] = (), errors: str = "raise") -> Callable[..., torch.Tensor]:
    """F(P, ε; θ) of a model as a function of PyTorch with its first derivatives. A value alone costs no derivatives.

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
        ``raise``, or ``nan``: NaN at points without an answer and for muscles that cannot be.

    Returns
    -------
    function
        ``f(pressure_mpa, contraction)``, or ``f(pressure_mpa, contraction, theta)`` with the values of the names in their order, in
        MPa, N/mm, mm, degrees; of tensors on the processor. The result has the broadcast shape of pressures and contractions.
    """
    return _function(Asked(model, "force", [*parameters, *wrt], errors))


def pressure(model: Model, parameters: Sequence[str] = (), *, wrt: Sequence[str] = (), errors: str = "raise") -> Callable[..., torch.Tensor]:
    """P(F, ε; θ) of a model: ``f(force_n, contraction)`` or ``f(force_n, contraction, theta)`` in MPa; arguments as in :func:`force`."""
    return _function(Asked(model, "pressure", [*parameters, *wrt], errors))


def contraction(model: Model, parameters: Sequence[str] = (), *, wrt: Sequence[str] = (), errors: str = "raise") -> Callable[..., torch.Tensor]:
    """ε(F, P; θ) of a model: ``f(force_n, pressure_mpa)`` or ``f(force_n, pressure_mpa, theta)``; arguments as in :func:`force`."""
    return _function(Asked(model, "contraction", [*parameters, *wrt], errors))


def _function(asked: Asked) -> Callable[..., torch.Tensor]:
    count = len(asked.names)

    class Found(torch.autograd.Function):
        @staticmethod
        def forward(ctx: Any, a: Any, b: Any, theta: Any) -> Any:
            arrays = [t.detach().cpu().numpy().astype(np.float64) for t in (a, b, theta)]
            slopes = any(ctx.needs_input_grad)
            found = asked.many(arrays[0], arrays[1], arrays[2], int(slopes))
            if slopes:
                ctx.save_for_backward(torch.as_tensor(np.ascontiguousarray(found[..., 1:]), dtype=a.dtype))
                ctx.shapes = a.shape, b.shape
                found = found[..., 0]
            return torch.as_tensor(np.array(found), dtype=a.dtype)

        @staticmethod
        @torch.autograd.function.once_differentiable  # type: ignore[untyped-decorator,unused-ignore]
        def backward(ctx: Any, change: Any) -> Any:
            (slopes,) = ctx.saved_tensors
            by_a, by_b = (_summed(change * slopes[..., i], shape) for i, shape in enumerate(ctx.shapes))
            by_theta = (change[..., None] * slopes[..., 2:]).reshape(-1, count).sum(0) if count else None
            return by_a, by_b, by_theta

    def outer(first: Any, second: Any = 0.0, theta: Any = ()) -> torch.Tensor:
        a = torch.as_tensor(first, dtype=None if torch.is_tensor(first) else torch.float64)
        b = torch.as_tensor(second, dtype=None if torch.is_tensor(second) else a.dtype)
        values = torch.as_tensor(theta, dtype=None if torch.is_tensor(theta) else a.dtype)
        if tuple(values.shape) != (count,):
            raise ValueError(f"theta holds the values of {list(asked.names)}, not {tuple(values.shape)}")
        found: torch.Tensor = Found.apply(a, b, values)
        return found

    return outer


def _summed(change: Any, shape: Any) -> Any:
    """Over the axes that were broadcast."""
    while change.dim() > len(shape):
        change = change.sum(0)
    for axis, length in enumerate(shape):
        if length == 1 and change.shape[axis] > 1:
            change = change.sum(axis, keepdim=True)
    return change
