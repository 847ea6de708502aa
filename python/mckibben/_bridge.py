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

NO_SECOND = "a model has first derivatives only: for second ones take differences of jax.grad, or the outer product of residuals' gradients (Gauss-Newton)"


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

    def one(self, a: Array, b: Array, theta: Array, slopes: bool) -> Array:
        """The values, or with an axis more at the end values and slopes, at one θ."""
        shape = np.broadcast_shapes(a.shape, b.shape)
        try:
            model, rows = self.at(theta)
            own = list(dict.fromkeys(parameter for row in rows for parameter in row))
            found = getattr(model, self.wanted)(a, b, jac=(own or True) if slopes else False, errors=self.errors)
        except MckibbenError:
            # A muscle that cannot be.
            if self.errors == "raise":
                raise
            return np.full((*shape, 3 + len(self.names)) if slopes else shape, np.nan)
        if not slopes:
            return np.asarray(found)
        by = np.array([[row.get(parameter, 0.0) for parameter in own] for row in rows]).reshape(len(rows), len(own))
        return np.concatenate([np.asarray(found[0])[..., None], found[1][..., :2], found[1][..., 2:] @ by.T], axis=-1)

    def many(self, a: Any, b: Any, theta: Any, slopes: bool) -> Array:
        """The same where all three may have axes of a batch in front, as many as θ has more than one."""
        a, b, theta = (np.asarray(v, dtype=np.float64) for v in (a, b, theta))
        batch = theta.shape[:-1]
        if not theta.size or theta.size == theta.shape[-1]:
            return self.one(a, b, theta.reshape(-1), slopes)
        axes = np.broadcast_shapes(batch, a.shape[: len(batch)], b.shape[: len(batch)])
        a, b = (np.broadcast_to(v, axes + v.shape[len(batch):]) for v in (a, b))
        theta = np.broadcast_to(theta, axes + theta.shape[-1:])
        parts = [self.one(a[i], b[i], theta[i], slopes) for i in np.ndindex(axes)]
        return np.stack(parts).reshape(axes + parts[0].shape)
