#!/usr/bin/env python3
"""The exported module in PyTorch against NumPy, with the module on the path: values to 1e-12, slopes by automatic differentiation to 1e-10."""

import time

import numpy as np
import torch

import muscle_prototype as exported

# Beyond the box on all sides.
p, e = np.meshgrid(
    np.linspace(-0.1, 1.2, 14) * exported.SUPPLY,
    np.linspace(exported.LOW - 0.03, exported.HIGH + 0.05, 23),
)
P, L = p.ravel(), (1 - e.ravel()) * exported.LENGTH
F = exported.force(P, L)
inside = exported.status(P, L) & ~exported.SLACK == 0
pulls = (F > 1e-3 * F.max()) & inside
begun = time.monotonic()


def of(name, first, second):
    """The largest difference, as a share of the largest value."""
    expected, found = (
        getattr(exported, name)(first, second),
        getattr(exported, name)(torch.tensor(first), torch.tensor(second)),
    )
    assert found.dtype == torch.float64 and np.array_equal(
        np.isnan(expected), np.isnan(found.numpy())
    )
    return np.nanmax(np.abs(found.numpy() - expected)) / np.nanmax(np.abs(expected))


errors = {
    name: of(name, P, L)
    for name in ("force", "volume", "stiffness", "force_per_pressure")
}
errors |= {
    "pressure": of("pressure", F[pulls], L[pulls]),
    "contraction": of("contraction", F[pulls], P[pulls]),
}
assert np.array_equal(
    exported.status(torch.tensor(P), torch.tensor(L)), exported.status(P, L)
)
assert all(error < 1e-12 for error in errors.values()), errors
tensors = torch.tensor(P, requires_grad=True), torch.tensor(L, requires_grad=True)
by_pressure, by_length = torch.autograd.grad(exported.force(*tensors).sum(), tensors)
_, volume_by_length = torch.autograd.grad(exported.volume(*tensors).sum(), tensors)
K, A = exported.stiffness(P, L), exported.force_per_pressure(P, L)
near = [
    np.abs(found.numpy() - wanted)[inside].max() / np.abs(wanted).max()
    for found, wanted in ((by_length, K), (by_pressure, A), (volume_by_length, -A))
]
assert all(error < 1e-10 for error in near), near
print(
    f"PyTorch {torch.__version__}: {len(P)} points, values {max(errors.values()):.1e}, slopes {max(near):.1e}, {time.monotonic() - begun:.1f} s"
)
