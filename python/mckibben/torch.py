"""A muscle in a loss of PyTorch: pulls, pressures and contractions as functions that ``backward()``, ``torch.func.grad`` and ``torch.func.vmap`` take."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import torch

from ._bridge import NO_SECOND, NO_THIRD, Asked

if TYPE_CHECKING:
    from ._model import Model


def force(model: Model, parameters: Sequence[str] = (), *, wrt: Sequence[str] = (), errors: str = "raise") -> Callable[..., torch.Tensor]:
    """F(P, ε; θ) of a model as a function of PyTorch with its first and second derivatives. Finite elements have first ones only, and say so.

    A call asks the model once for all points, unless θ differs from point to point; so does ``torch.func.vmap`` of it. A value alone costs no derivatives.

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
        ``f(pressure_mpa, contraction)``, or ``f(pressure_mpa, contraction, theta)`` with the values of the names in their order on the last axis, in
        MPa, N/mm, mm, degrees; of tensors on the processor. The result has the broadcast shape of pressures, contractions and the other axes of θ.
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
    kinds: list[Any] = []

    def found(a: Any, b: Any, theta: Any, order: int) -> Any:
        arrays = [t.detach().cpu().numpy() for t in (a, b, theta)]
        axes = max(a.ndim, b.ndim, theta.ndim - 1)
        first, second = (v.reshape((1,) * (axes - v.ndim) + v.shape) for v in arrays[:2])
        batch = (1,) * (axes + 1 - theta.ndim) + theta.shape[:-1]
        # Of axes of points along which θ is one, the model is asked at once.
        while batch and batch[-1] == 1:
            batch = batch[:-1]
        return torch.as_tensor(np.array(asked.many(first, second, arrays[2].reshape(*batch, count), order)), dtype=a.dtype)

    def made(order: int) -> Any:
        def rates(a: Any, b: Any, theta: Any) -> Any:
            """How what has this order changes with the two and with θ, which are the last axis."""
            if order == 2 or order == 1 and not asked.has_second:
                raise NotImplementedError(NO_THIRD if order == 2 else NO_SECOND)
            out = kinds[order + 1].apply(a, b, theta, False)[0]
            return out.unflatten(-1, (2 + count, 2 + count)) if order == 1 else out

        class Derivatives(_Function):
            """Those of an order; their own are those of the next."""

            @staticmethod
            def forward(a: Any, b: Any, theta: Any, is_followed: bool) -> Any:
                out = found(a, b, theta, 1 if is_followed else order)
                # Slopes, which come with a value, are kept for its backward().
                return (out[..., 0].clone(), out[..., 1:].clone()) if is_followed else (out[..., 1:].clone() if order == 1 else out, out.new_empty(0))

            @staticmethod
            def setup_context(ctx: Any, inputs: Any, output: Any) -> None:
                ctx.mark_non_differentiable(output[1])
                ctx.save_for_backward(*inputs[:3], output[1])
                ctx.save_for_forward(*inputs[:3], output[1])

            @staticmethod
            def backward(ctx: Any, change: Any, _: Any) -> Any:
                a, b, theta, slopes = ctx.saved_tensors
                has = slopes.numel() and not torch.is_grad_enabled()
                by = change[..., None] * (slopes if has else rates(a, b, theta))
                by = by.sum(-2) if order == 1 else by
                return by[..., 0].sum_to_size(a.shape), by[..., 1].sum_to_size(b.shape), by[..., 2:].sum_to_size(theta.shape), None

            @staticmethod
            def jvp(ctx: Any, *moved: Any) -> Any:
                a, b, theta, _ = ctx.saved_tensors
                by = rates(a, b, theta)
                changes = [by[..., i] * (t[..., None] if order == 1 else t) for i, t in enumerate(moved[:2]) if t is not None]
                if moved[2] is not None:
                    changes.append((by[..., 2:] * (moved[2][..., None, :] if order == 1 else moved[2])).sum(-1))
                return sum(changes), None

            @staticmethod
            def vmap(info: Any, places: Any, a: Any, b: Any, theta: Any, is_followed: bool) -> Any:
                tensors = (a, b, theta)
                axes = max(t.ndim - (place is not None) - (t is theta) for t, place in zip(tensors, places))
                moved = [t[None] if place is None else t.movedim(place, 0) for t, place in zip(tensors, places)]
                # As many axes each, so that the batch comes in front of all.
                spread = [t.reshape(t.shape[:1] + (1,) * (axes + 1 + (t is moved[2]) - t.ndim) + t.shape[1:]) for t in moved]
                return kinds[order].apply(*spread, is_followed), (0, 0 if is_followed else None)

        return Derivatives

    kinds.extend(map(made, range(3)))

    def outer(first: Any, second: Any = 0.0, theta: Any = ()) -> torch.Tensor:
        kind = first.dtype if torch.is_tensor(first) and first.is_floating_point() else torch.float64
        a, b, values = (v if torch.is_tensor(v) and v.is_floating_point() else torch.as_tensor(v, dtype=kind) for v in (first, second, theta))
        if values.shape[-1:] != (count,):
            raise ValueError(f"theta holds the values of {list(asked.names)} on its last axis, not {tuple(values.shape)}")
        is_followed = torch.is_grad_enabled() and any(t.requires_grad for t in (a, b, values))
        answer: torch.Tensor = kinds[0].apply(a, b, values, is_followed)[0]
        return answer

    return outer


class _Function(torch.autograd.Function):
    """A function in two steps, also for versions of PyTorch before 2, which have one."""

    if not hasattr(torch.autograd.Function, "setup_context"):

        def __init_subclass__(cls) -> None:
            forward, setup = cls.forward, cls.setup_context

            def both(ctx: Any, *inputs: Any) -> Any:
                output = forward(*inputs)
                setup(ctx, inputs, output)
                return output

            cls.forward = staticmethod(both)
