"""The elbow of examples/elbow.toml as an environment of Gymnasium: two pressures move it to an angle.

python elbow_gymnasium.py
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from numpy.typing import NDArray

import mckibben as mk

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
Array = NDArray[np.float32]


class Elbow(gymnasium.Env[Array, Array]):
    """Observed: angle, its speed, both pressures and the target, each by its scale. Action: both pressures, -1 for 0 and 1 for 3 bar."""

    def __init__(
        self, model: str = "universal", dt_s: float = 0.01, steps: int = 200
    ) -> None:
        self.observation_space = gymnasium.spaces.Box(-10.0, 10.0, (5,), np.float32)
        self.action_space = gymnasium.spaces.Box(-1.0, 1.0, (2,), np.float32)
        self.simulation = mk.Simulation(
            EXAMPLES / "elbow-drive.toml", dt_s, record=False, model=model
        )
        self.steps, self.done, self.target_deg = steps, 0, 0.0

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Array, dict[str, Any]]:
        super().reset(seed=seed)
        self.target_deg = float(self.np_random.uniform(-30, 30))
        self.done = 0
        return self.observed(self.simulation.reset()), {}

    def step(self, action: Array) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        pressures = 0.15 * (
            1.0 + np.clip(np.asarray(action, dtype=np.float64), -1.0, 1.0)
        )
        state = self.simulation.step(pressures)
        self.done += 1
        miss = (state.angle_deg - self.target_deg) / 60.0
        return (
            self.observed(state),
            -miss * miss,
            False,
            self.done >= self.steps,
            {"angle_deg": state.angle_deg, "target_deg": self.target_deg},
        )

    def observed(self, state: Any) -> Array:
        numbers = [
            state.angle_deg / 60,
            state.velocity_deg_per_s / 600,
            state.pressure_1_mpa / 0.3,
            state.pressure_2_mpa / 0.3,
            self.target_deg / 60,
        ]
        return np.clip(np.array(numbers, dtype=np.float32), -10, 10)


def proportional(observed: Array) -> Array:
    """The pressures against each other in proportion to the way to go (feed-forward by the stiffness of the joint), and to the speed."""
    angle, speed, *_, target = observed
    difference = 1.6 * target + 2.0 * (target - angle) - 0.5 * speed
    return np.clip(np.array([difference, -difference], dtype=np.float32), -1, 1)


def main() -> float:
    """The angle that it misses after two seconds, degrees."""
    environment = Elbow()
    observed, _ = environment.reset(seed=1)
    for _ in range(200):
        observed, _, _, _, info = environment.step(proportional(observed))
    return abs(float(info["angle_deg"] - info["target_deg"]))


if __name__ == "__main__":
    print(f"{main():.2f} degrees beside the target")
