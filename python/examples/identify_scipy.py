"""A muscle in the loss of SciPy: modulus and strands from forces, with the derivatives of the finite elements.

python identify_scipy.py
"""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.optimize import least_squares

import mckibben as mk

NAMES = ["tube.material.c10", "braid.stiffness"]
PRESSURES, CONTRACTIONS = (
    np.array([0.1, 0.15, 0.2, 0.25])[:, None],
    np.array([0.0, 0.05, 0.1, 0.15]),
)


def measured(muscle: mk.Muscle) -> Any:
    """In place of a bench: forces in N of the muscle with C10 0.15 MPa, k 700 N/mm."""
    return muscle.with_parameters(dict(zip(NAMES, [0.15, 700.0]))).force(
        PRESSURES, CONTRACTIONS
    )


def main() -> Any:
    """C10 in MPa and k in N/mm."""
    muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=3, length_mm=285)
    forces = measured(muscle)

    def at(theta: Any) -> Any:
        return muscle.with_parameters(dict(zip(NAMES, theta))).force(
            PRESSURES, CONTRACTIONS, jac=NAMES
        )

    found = least_squares(
        lambda theta: (at(theta)[0] - forces).ravel(),
        [muscle.parameters[name] for name in NAMES],
        jac=lambda theta: at(theta)[1][..., 2:].reshape(-1, len(NAMES)),
        x_scale=[0.1, 500.0],
    )
    print(
        f"C10 {found.x[0]:.4f} MPa, k {found.x[1]:.1f} N/mm after {found.nfev} evaluations"
    )
    return found.x


if __name__ == "__main__":
    main()
