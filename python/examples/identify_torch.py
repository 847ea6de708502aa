"""A muscle in the loss of PyTorch: modulus and strands from forces; `backward()` goes through the finite elements.

python identify_torch.py
"""

from __future__ import annotations

from typing import Any

import torch
from identify_scipy import CONTRACTIONS, NAMES, PRESSURES, measured

import mckibben as mk
from mckibben.torch import force


def main() -> Any:
    """C10 in MPa and k in N/mm."""
    muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=3, length_mm=285)
    pull, forces = force(muscle.model(), NAMES), torch.as_tensor(measured(muscle))
    scale = torch.tensor([0.1, 500.0], dtype=torch.float64)
    start = torch.tensor([muscle.parameters[name] for name in NAMES], dtype=torch.float64) / scale
    scaled = start.clone().requires_grad_()
    optimiser = torch.optim.LBFGS([scaled], max_iter=60, line_search_fn="strong_wolfe", tolerance_grad=1e-9, tolerance_change=1e-14)
    pressures, contractions = torch.as_tensor(PRESSURES), torch.as_tensor(CONTRACTIONS)

    def closure() -> Any:
        optimiser.zero_grad()
        loss = (((pull(pressures, contractions, scaled * scale) - forces) / 100) ** 2).sum()
        loss.backward()
        return loss

    optimiser.step(closure)
    constants = (scaled * scale).detach().numpy()
    print(f"C10 {constants[0]:.4f} MPa, k {constants[1]:.1f} N/mm")
    return constants


if __name__ == "__main__":
    main()
