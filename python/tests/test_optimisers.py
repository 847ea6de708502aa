"""A muscle in the losses of SciPy, JAX and PyTorch: the examples find the constants that made the forces."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import mckibben as mk


@pytest.mark.parametrize("name, needs, rel", [("identify_scipy", "scipy", 1e-6), ("identify_jax", "jax", 1e-4), ("identify_torch", "torch", 1e-4)])
def test_an_example_identifies_a_muscle(name: str, needs: str, rel: float, root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip(needs)
    monkeypatch.syspath_prepend(str(root / "python" / "examples"))
    assert importlib.import_module(name).main() == pytest.approx([0.15, 700.0], rel=rel)


def test_jax_derivatives() -> None:
    """∂F/∂θ by jax.grad against differences, along a direction, and over several points at once."""
    jax = pytest.importorskip("jax")
    jax.config.update("jax_enable_x64", True)
    muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=3)
    names = ["tube.material.c10", "braid.stiffness"]
    pull, theta = mk.jax.force(muscle.model(), names), np.array([0.112, 590.0])
    contractions = np.array([0.0, 0.05, 0.1])

    def loss(t: Any) -> Any:
        return (pull(0.2, contractions, t) ** 2).sum()

    slope = jax.jit(jax.grad(loss))(theta)
    for i in range(2):
        h = np.eye(2)[i] * 1e-5 * theta
        assert slope[i] == pytest.approx(float((loss(theta + h) - loss(theta - h)) / (2 * h[i])), rel=1e-5)
    model = mk.jax.force(muscle.model())
    value, change = jax.jvp(lambda p: model(p, 0.1), (0.2,), (1.0,))
    expected, by = muscle.model().force(0.2, 0.1, jac=True)
    assert float(value) == pytest.approx(expected) and float(change) == pytest.approx(by[0])
    assert jax.vmap(lambda e: model(0.2, e))(contractions).shape == (3,)
    with pytest.raises(ValueError):
        pull(0.2, 0.1)


def test_torch_derivatives() -> None:
    torch = pytest.importorskip("torch")
    muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=3)
    pressures = torch.tensor([[0.1], [0.2]], dtype=torch.float64, requires_grad=True)
    contractions = torch.tensor([0.0, 0.1, 0.15], dtype=torch.float64, requires_grad=True)
    pull = mk.torch.force(muscle.model())
    assert torch.autograd.gradcheck(pull, (pressures, contractions), eps=1e-5, atol=1e-2, rtol=1e-5)
