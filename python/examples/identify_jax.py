"""A muscle in the loss of JAX: modulus and strands from forces; `jax.grad` goes through the finite elements.

python identify_jax.py
"""

from __future__ import annotations

from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from identify_scipy import CONTRACTIONS, NAMES, PRESSURES, measured
from scipy.optimize import minimize

import mckibben as mk
from mckibben.jax import force

config: Any = jax.config
config.update("jax_enable_x64", True)
SCALE = np.array([0.1, 500.0])


def main() -> Any:
    """C10 in MPa and k in N/mm."""
    muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=3, length_mm=285)
    pull, forces = force(muscle, NAMES), measured(muscle)

    @jax.jit
    def loss(scaled: Any) -> Any:
        return (
            ((pull(PRESSURES, CONTRACTIONS, scaled * SCALE) - forces) / 100) ** 2
        ).sum()

    start = np.array([muscle.parameters[name] for name in NAMES]) / SCALE
    found = minimize(
        loss,
        jnp.asarray(start),
        jac=jax.grad(loss),
        method="BFGS",
        options={"gtol": 1e-7},
    )
    constants = found.x * SCALE
    print(f"C10 {constants[0]:.4f} MPa, k {constants[1]:.1f} N/mm")
    return constants


if __name__ == "__main__":
    main()
