"""The elbow of examples/elbow.toml in MuJoCo: each muscle is a force on its side of the pulley, by its contraction at the angle.

python elbow_mujoco.py
"""

from __future__ import annotations

from pathlib import Path

import mujoco

import mckibben as mk

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
RADIUS_MM, AT_NEUTRAL = 25.0, 0.12
ARM = """
<mujoco>
  <option timestep="0.002" gravity="0 0 -9.80665"/>
  <worldbody>
    <body>
      <joint name="elbow" type="hinge" axis="0 -1 0" damping="0.3" limited="true" range="-60 60"/>
      <inertial pos="0 0 -0.15" mass="1.2" diaginertia="0.003 0.003 0.003"/>
    </body>
  </worldbody>
</mujoco>
"""


def torque_nm(
    muscle: mk.Muscle, pressures_mpa: tuple[float, float], angle_rad: float
) -> float:
    """The muscles pull on a pulley, each on its side: F1 r − F2 r."""
    pulls = [
        muscle.force(
            p,
            AT_NEUTRAL + sign * RADIUS_MM * angle_rad / muscle.length_mm,
            model="universal",
        )
        for p, sign in zip(pressures_mpa, (1, -1))
    ]
    return float(1e-3 * RADIUS_MM * (pulls[0] - pulls[1]))


def main(pressures_mpa: tuple[float, float] = (0.2, 0.1)) -> float:
    """The angle at which the arm comes to rest in MuJoCo, degrees."""
    muscle = mk.load(EXAMPLES / "biceps.toml")
    arm = mujoco.MjModel.from_xml_string(ARM)
    data = mujoco.MjData(arm)
    for _ in range(3000):
        data.qfrc_applied[0] = torque_nm(muscle, pressures_mpa, float(data.qpos[0]))
        mujoco.mj_step(arm, data)
    return float(data.qpos[0]) * 57.29577951308232


if __name__ == "__main__":
    print(
        f"MuJoCo {main():.3f} degrees, mckibben {mk.load(EXAMPLES / 'elbow-drive.toml').motion(model='universal').equilibrium_angle_deg:.3f} degrees"
    )
