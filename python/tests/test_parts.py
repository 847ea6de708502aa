"""The parts of a muscle: tube, braid, terminals and friction, made of the table of measures."""

from __future__ import annotations

import copy
import inspect
import json
import pickle
from pathlib import Path
from typing import Any

import pytest

import mckibben as mk
from mckibben import _schema

GEOMETRY: dict[str, Any] = {"outer_diameter_mm": 50, "wall_mm": 1, "length_mm": 285}
KINDS: dict[str, Any] = {"tube": mk.Tube, "braid": mk.Braid, "terminals": mk.Terminals, "friction": mk.Friction}
STRANDS: dict[str, Any] = {"strands": 48, "strand_area_mm2": 0.3, "strand_modulus_mpa": 2500, "strand_strength_n": 40}


def test_the_arguments_of_the_parts_are_the_measures_of_the_table() -> None:
    """Every measure of a muscle belongs to one part, the one that the table of measures names."""
    seen = []
    for row in mk.measures().measures:
        names = {field: name for name, field in _schema.part(row.group).items()}
        name = names[str(row.field)]
        assert name in inspect.signature(KINDS[row.group]).parameters and isinstance(getattr(KINDS[row.group], name), property)
        seen.append(row.field)
    assert {*seen, "rubber", "rubber_file", "braid", "strand_diameter_mm"} == set(_schema.muscle())


@pytest.mark.parametrize("measure", [row.field for row in mk.measures().measures])
def test_a_part_says_the_same_as_the_fields_of_a_muscle(measure: str) -> None:
    """An identity: a measure given by its part is that of the muscle with the field."""
    from test_fields import FIELDS

    row = next(row for row in mk.measures().measures if row.field == measure)
    table, names = row.group, {field: name for name, field in _schema.part(row.group).items()}
    schema = _schema.muscle()[measure]
    low, high, usual = (schema.get(key, other) for key, other in (("x-minimum", 0.0), ("x-maximum", 2.0), ("default", 1.0)))
    text, value, beside = FIELDS.get(measure, ("", min(max(1.05 * usual, low + 0.05), high), {}))
    sizes: dict[str, Any] = {"outer_diameter_mm": 30, "wall_mm": 3, "length_mm": 285}
    fields = {**(sizes if table == "tube" else {}), **beside, measure: value}
    part = KINDS[table](**{names[field]: of for field, of in fields.items()})
    muscle = mk.Muscle(**{**sizes, **fields})
    given = {"tube": part} if table == "tube" else {**sizes, table: part}
    assert mk.Muscle(**given) == muscle and muscle.replace(**{table: part}) == muscle
    assert getattr(part, names[measure]) == value == getattr(getattr(muscle, table), names[measure])
    # What a muscle has is what it was given, in every form.
    own = getattr(muscle, table)
    assert mk.Muscle(**{**given, table: own}) == muscle
    for same in (KINDS[table](**part.to_dict()), KINDS[table].from_toml(part.to_toml()), KINDS[table].from_toml(muscle.to_toml()), pickle.loads(pickle.dumps(part)), copy.deepcopy(part), part.replace()):
        assert same == part and hash(same) == hash(part) and repr(same) == repr(part)


def test_what_no_argument_states_is_kept_as_the_text_of_the_file() -> None:
    pressure = mk.Muscle.from_toml("[tube]\nouter_diameter = 14\nwall_thickness = 2\nlength = 200\n[model.tondu-lopez]\nend_factor = { a = 1, b = 1.2 }\n")
    for muscle in (mk.Muscle("lib:dmsp-20-300"), pressure):
        assert list(muscle.to_dict()) == ["base"] and mk.Muscle(**json.loads(json.dumps(muscle.to_dict()))) == muscle
    assert mk.Terminals.from_toml(pressure.to_toml()) == pressure.terminals
    with pytest.raises(mk.InputError, match="depends on the pressure"):
        pressure.terminals.replace(seating_mm=1)


def test_a_part_is_whole_and_a_field_is_given_once() -> None:
    base = mk.Muscle(**GEOMETRY, seating_mm=1.6, slip_mm_per_n=0.004, density_kg_per_m3=1000, rubber="dragon-skin-30", angle_deg=25)
    other = base.replace(terminals=mk.Terminals(grip_mm=5))
    assert (other.seating_mm, other.grip_mm, other.angle_deg) == (None, 5.0, 25.0)
    assert base.replace(tube=base.tube.replace(wall_mm=2)) == base.replace(wall_mm=2) and base.tube.rubber == "dragon-skin-30"
    assert base.replace(tube=mk.Tube(**GEOMETRY)).rubber == "paper"
    made = mk.Muscle(tube=base.tube, braid=base.braid, terminals=base.terminals)
    assert made == base and made.friction == mk.Friction() and made.terminals.slip_mm_per_n == 0.004
    twice: list[tuple[str, Any]] = [("wall_mm", lambda: mk.Muscle(tube=base.tube, wall_mm=2)), ("angle_deg", lambda: base.replace(braid=base.braid, angle_deg=25)), ("grip_mm", lambda: base.replace(terminals=base.terminals, grip="5 mm")), ("rubber", lambda: base.replace(tube=base.tube, rubber="paper")), ("strands", lambda: base.replace(braid=base.braid, strands=48))]
    for field, call in twice:
        with pytest.raises(mk.InputError) as caught:
            call()
        assert caught.value.field == field and field in str(caught.value)
    any_of: Any = mk
    wrong: list[Any] = [lambda: any_of.Tube(outer_diameter_mm=50, wall_mm=1), lambda: any_of.Muscle(tube="paper"), lambda: any_of.Muscle(**GEOMETRY, terminals=base.tube), lambda: any_of.Tube(**GEOMETRY, wal_mm=1)]
    for call in wrong:
        with pytest.raises(TypeError):
            call()
    with pytest.raises(mk.MckibbenError):
        mk.Tube(outer_diameter_mm=50, wall_mm=30, length_mm=285)
    with pytest.raises(AttributeError):
        base.tube.wall_mm = 2  # type: ignore[misc]


def test_own_rubbers_strands_and_sleeves_are_kept() -> None:
    gent = mk.Rubber("gent", mu="200 kPa", jm=30)
    tube = mk.Tube(**GEOMETRY, rubber=gent)
    muscle = mk.Muscle(tube=tube, braid=mk.Braid("25 deg", **STRANDS, compression=True))
    assert muscle.tube == mk.Tube(**tube.to_dict()) == tube and isinstance(muscle.tube.rubber, mk.Rubber) and muscle.tube.rubber.jm == 30
    assert mk.Rubber.from_toml(muscle.to_toml()).stress("uniaxial", 2.0) == gent.stress("uniaxial", 2.0)
    assert muscle.braid.compression and muscle.braid.strands == 48 and muscle.braid.to_dict() == {"angle_deg": 25.0, **STRANDS, "compression": True}
    # A sleeve has its angle on the tube that it is on; its file has the name alone.
    sleeve = "flexo-overexpanded-0.75in"
    values: dict[str, Any] = {"strand_diameter_mm": 0.25, "strand_modulus_mpa": 8530}
    braid = mk.Braid(name=sleeve, **values)
    for diameter in (20, 22):
        plain = mk.Muscle(outer_diameter_mm=diameter, wall_mm=1, length_mm=200, braid=sleeve, **values)
        own = mk.Muscle(outer_diameter_mm=diameter, wall_mm=1, length_mm=200, braid=braid)
        assert own.angle_deg == plain.angle_deg == own.braid.angle_deg and own.force(0.2, 0.05, model="thick-wall") == pytest.approx(plain.force(0.2, 0.05, model="thick-wall"), rel=1e-12)
        assert own.braid.name == sleeve and mk.Muscle(tube=own.tube, braid=own.braid) == own


def test_parts_are_saved_and_loaded(tmp_path: Path) -> None:
    muscle = mk.Muscle(**GEOMETRY, seating_mm=1.6, end_factor=1.1, friction_coefficient=30, friction_exponent=0.7, rubber=mk.Rubber("gent", mu=0.2, jm=30))
    for name, kind in KINDS.items():
        part = getattr(muscle, name)
        part.save(tmp_path / name)
        assert mk.load(tmp_path / name) == kind.load(tmp_path / name) == part, name
    muscle.save(tmp_path / "muscle.toml")
    assert mk.load(tmp_path / "muscle.toml") == muscle and mk.Terminals.load(tmp_path / "muscle.toml") == muscle.terminals
    assert muscle.terminals.to_dict() == {"seating_mm": 1.6, "end_factor": 1.1}


def test_a_braid_is_still_a_text() -> None:
    muscle = mk.Muscle.prototype()
    strands = muscle.replace(outer_diameter_mm=50, braid=mk.Braid(25, **STRANDS))
    # By the words of the answers, for the stiffness on this very tube.
    assert str(strands.braid) == strands.check(only_data=True).braid != str(strands.replace(outer_diameter_mm=30).braid)
    assert str(muscle.braid) == "paper" and str(mk.Braid(stiffness="inextensible")) == "inextensible"
    with pytest.warns(DeprecationWarning, match="str"):
        assert muscle.braid == "paper"
