"""What the functions for JAX and PyTorch have in common: a model asked at values of its muscle's constants and measures."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ._model import MEASURES
from ._problem import MckibbenError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._model import Model

    from typing import TypeAlias

    Array: TypeAlias = NDArray[np.float64]

NO_SECOND = "finite elements have first derivatives only: take the model universal for second ones, or the outer product of residuals' gradients (Gauss-Newton)"
NO_THIRD = "a model has first and second derivatives only"
# Places and weights of differences of fourth order about a point, and from a point on.
_ABOUT = np.array([-2.0, -1.0, 0.0, 1.0, 2.0]), np.array([1.0, -8.0, 0.0, 8.0, -1.0]) / 12
_FROM = np.array([0.0, 1.0, 2.0, 3.0, 4.0]), np.array([-25.0, 48.0, -36.0, 16.0, -3.0]) / 12
# Steps of differences are this share of a value, or of what is usual where that is less.
_STEP = 1e-3
_USUAL = {"force": (0.1, 0.2), "pressure": (100.0, 0.2), "contraction": (100.0, 0.1)}


class Asked:
    """One of ``force``, ``pressure``, ``contraction`` of a model, as a function of two arrays and of θ."""

    def __init__(self, model: Model, wanted: str, names: Sequence[str], errors: str) -> None:
        if errors not in ("raise", "nan"):
            raise ValueError(f'errors: "raise" or "nan", not {errors!r}')
        self.model, self.wanted, self.names, self.errors = model, wanted, tuple(names), errors
        if unknown := [name for name in names if name not in MEASURES and name not in model.muscle.parameters]:
            raise ValueError(f"{unknown[0]}: there is {', '.join([*MEASURES, *model.muscle.parameters])}")

    def at(self, theta: Array) -> tuple[Model, list[dict[str, float]]]:
        """The model of the muscle with these values, and how its parameters change with each."""
        if not self.names:
            return self.model, []
        values = dict(zip(self.names, map(float, theta)))
        measures: dict[str, Any] = {name: value for name, value in values.items() if name in MEASURES}
        muscle = self.model.muscle.replace(**measures) if measures else self.model.muscle
        own = {name: value for name, value in values.items() if name not in MEASURES}
        # A parameter that is a value itself follows no measure.
        rows = [{n: v for n, v in muscle._follows(name).items() if n not in own} if name in measures else {name: 1.0} for name in self.names]
        return self.model.of(muscle.with_parameters(own) if own else muscle), rows

    @property
    def has_second(self) -> bool:
        """Whether there are second derivatives."""
        return not self.model._native.is_elements

    def widths(self, order: int) -> tuple[int, ...]:
        """The axis that the derivatives of an order need: none, values and slopes, or second derivatives row by row."""
        count = len(self.names)
        return ((), (3 + count,), ((2 + count) ** 2,))[order]

    def second(self, a: Array, b: Array, theta: Array) -> Array:
        """Second derivatives at one θ: differences of slopes, which closed forms have to their last digits. Slack muscles have none."""
        a, b = np.broadcast_arrays(a, b)
        smooth = Asked(self.model._with({"extrapolate": True, "two_sided": True}), self.wanted, self.names, self.errors)
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
        if self.wanted == "force" and not self.model._request.get("two_sided"):
            value = self.one(a, b, theta, 0)
            out = np.where((value == 0)[..., None, None], 0.0, out)
        return out.reshape(*a.shape, -1)

    def one(self, a: Array, b: Array, theta: Array, order: int) -> Array:
        """The values, or with an axis more at the end derivatives of an order, at one θ."""
        shape, slopes = np.broadcast_shapes(a.shape, b.shape), order == 1
        try:
            if order == 2:
                return self.second(a, b, theta)
            model, rows = self.at(theta)
            own = list(dict.fromkeys(parameter for row in rows for parameter in row))
            found = getattr(model, self.wanted)(a, b, jac=(own or True) if slopes else False, errors=self.errors)
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
