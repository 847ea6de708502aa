"""A muscle in a loss of PyTorch: the pull and its derivatives as a function that ``backward()`` goes through."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import torch

if TYPE_CHECKING:
    from ._model import Model


def force(model: Model, parameters: Sequence[str] = ()) -> Callable[..., Any]:
    """F(P, ε; θ) of a model as a function of PyTorch with its first derivatives.

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
        MPa, N/mm, mm, degrees; of tensors on the processor. The result has the broadcast shape of pressures and contractions.
    """
    names = tuple(parameters)

    class Pull(torch.autograd.Function):
        @staticmethod
        def forward(ctx: Any, p: Any, e: Any, theta: Any) -> Any:
            values = theta.detach().cpu().numpy().astype(np.float64)
            bound = model.of(model.muscle.with_parameters(dict(zip(names, values)))) if names else model
            a, b = (t.detach().cpu().numpy().astype(np.float64) for t in (p, e))
            value, slopes = bound.force(a, b, jac=names or True)
            ctx.save_for_backward(torch.as_tensor(np.ascontiguousarray(slopes), dtype=p.dtype))
            ctx.shapes = p.shape, e.shape
            return torch.as_tensor(np.array(value), dtype=p.dtype)

        @staticmethod
        def backward(ctx: Any, change: Any) -> Any:
            (slopes,) = ctx.saved_tensors
            by_p, by_e = (_summed(change * slopes[..., i], shape) for i, shape in enumerate(ctx.shapes))
            by_theta = (change[..., None] * slopes[..., 2:]).reshape(-1, len(names)).sum(0) if names else None
            return by_p, by_e, by_theta

    def outer(pressure_mpa: Any, contraction: Any = 0.0, theta: Any = ()) -> Any:
        p = torch.as_tensor(pressure_mpa, dtype=None if torch.is_tensor(pressure_mpa) else torch.float64)
        e = torch.as_tensor(contraction, dtype=None if torch.is_tensor(contraction) else p.dtype)
        values = torch.as_tensor(theta, dtype=None if torch.is_tensor(theta) else p.dtype)
        if tuple(values.shape) != (len(names),):
            raise ValueError(f"theta holds the values of {list(names)}, not {tuple(values.shape)}")
        return Pull.apply(p, e, values)

    return outer


def _summed(change: Any, shape: Any) -> Any:
    """Over the axes that were broadcast."""
    while change.dim() > len(shape):
        change = change.sum(0)
    for axis, length in enumerate(shape):
        if length == 1 and change.shape[axis] != 1:
            change = change.sum(axis, keepdim=True)
    return change
