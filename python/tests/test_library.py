"""Muscles of the library, by name wherever a muscle file may stand."""

from __future__ import annotations

from pathlib import Path

import pytest

import mckibben as mk

NAME = "lib:dmsp-20-300"


def test_a_name_is_its_muscle_in_functions_and_objects() -> None:
    shown = mk.parts_show("dmsp-20-300").muscle
    assert shown is not None and shown.name == NAME
    assert shown.agreement.held is not None and shown.agreement.held >= 0.9
    muscle = mk.Muscle.from_toml(shown.muscle_file.text)
    force = mk.force(muscle, 0.5, 0.1, model="thick-wall").force_n
    assert mk.force(NAME, 0.5, 0.1, model="thick-wall").force_n == force
    assert mk.Muscle(NAME) == muscle
    with pytest.raises(mk.MckibbenError, match="did you mean dmsp-20-300"):
        mk.force("lib:dmsp-20-30", 0.5, 0.1)


def test_a_joint_file_may_name_it(tmp_path: Path) -> None:
    joint = tmp_path / "joint.toml"
    muscles = "".join(f'[muscle_{i}]\nfile = "{NAME}"\ncontraction_at_neutral = "8%"\n' for i in (1, 2))
    joint.write_text(f'[joint]\nradius = "20 mm"\nrange = "-45..45 deg"\n{muscles}', "utf-8")
    point = mk.joint(joint, pressures_mpa=[[0.3, 0.2]], angles_deg=[0.0], model="thick-wall").points[0]
    assert point.torque_nm > 0
