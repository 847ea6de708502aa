"""A predictive controller of the elbow of examples/elbow.toml: at each step SciPy searches the pressures of the next ones, on a rollout of the simulation itself.

python elbow_mpc.py
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

import mckibben as mk

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
Array = NDArray[np.float64]
# Steps of 50 ms: twelve are looked ahead, over which the pressures change three times.
DT_S, AHEAD, MOVES = 0.05, 12, 3
MEAN_MPA, MOST_MPA = 0.15, 0.1
# Difference for slopes, in MPa.
STEP_MPA = 1e-3


def commands(differences: Array) -> Array:
    """Both pressures of each step, of half their difference in each move; one plan a row."""
    each = np.repeat(differences, AHEAD // MOVES, axis=-1)
    return np.stack([MEAN_MPA + each, MEAN_MPA - each], axis=-1)


def plan(elbow: mk.Simulation, target_deg: float, start: Array) -> Array:
    """The moves that bring the elbow to its target and hold it there. A plan and its slopes are one rollout: the plans run side by side."""
    misses: dict[bytes, tuple[Array, Array]] = {}

    def rolled(moves: Array) -> tuple[Array, Array]:
        key = moves.tobytes()
        if key not in misses:
            plans = moves + STEP_MPA * np.vstack([np.zeros(MOVES), np.eye(MOVES)])
            ends = mk.rollout(elbow, commands(plans))
            miss = np.hstack(
                [
                    ends["angle_deg"][:, 1:] - target_deg,
                    0.05 * ends["velocity_deg_per_s"][:, 1:],
                ]
            )
            misses[key] = miss[0], (miss[1:] - miss[0]).T / STEP_MPA
        return misses[key]

    found: Any = least_squares(
        lambda moves: rolled(moves)[0],
        start,
        jac=lambda moves: rolled(moves)[1],
        bounds=(-MOST_MPA, MOST_MPA),
        max_nfev=8,
    )
    moves: Array = found.x
    return moves


def main(target_deg: float = 20.0) -> float:
    """The angle that it misses after a second and a half, degrees."""
    elbow = mk.Simulation(
        EXAMPLES / "elbow-drive.toml", DT_S, record=False, model="universal"
    )
    moves = np.zeros(MOVES)
    for _ in range(30):
        moves = plan(
            elbow, target_deg, np.clip(moves, -0.99 * MOST_MPA, 0.99 * MOST_MPA)
        )
        state = elbow.step(commands(moves)[0])
    return abs(state.angle_deg - target_deg)


if __name__ == "__main__":
    print(f"{main():.2f} degrees beside the target")
