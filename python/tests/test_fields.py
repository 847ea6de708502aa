"""Units and fields come from the schemas: every field of every request and answer, of a muscle, and of the documentation."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

import mckibben as mk
from mckibben import _answers, _commands, _fields, _quantity

# A value of each field of a muscle with its unit, the number that it is, a text in a unit of another kind, and what must stand beside it.
FIELDS: dict[str, tuple[str, float, str, dict[str, Any]]] = {
    "outer_diameter_mm": ("3.1 cm", 31.0, "1 N", {}),
    "wall_mm": ("2500 um", 2.5, "1 mm/N", {}),
    "length_mm": ("0.3 m", 300.0, "1 mm2", {}),
    "density_kg_per_m3": ("0.93 g/cm3", 930.0, "1 N", {}),
    "prestretch": ("", 1.1, "1 mm", {}),
    "angle_deg": ("25 deg", 25.0, "25 mm", {}),
    "strand_diameter_mm": ("0.25 mm", 0.25, "1 N", {"braid": "flexo-overexpanded-0.75in", "strand_modulus_mpa": 8530}),
    "strand_modulus_mpa": ("8.5 GPa", 8500.0, "1 N", {"braid": "flexo-overexpanded-0.75in", "strand_diameter_mm": 0.25}),
    "stiffness": ("0.5 kN/mm", 500.0, "1 mm/N", {}),
    "seating_mm": ("1600 um", 1.6, "1 N", {}),
    "slip_mm_per_n": ("4 mm/kN", 0.004, "1 N", {}),
    "grip_mm": ("0.5 cm", 5.0, "1 mm/N", {}),
    "end_factor": ("", 1.1, "1 mm", {}),
    "cone_factor": ("", 0.4, "1 mm", {}),
    "strand_length_mm": ("33 cm", 330.0, "1 N", {"turns": 1.6}),
    "turns": ("", 1.6, "1 mm", {"strand_length_mm": 330}),
}


def schemas(root: Path) -> dict[str, Any]:
    return {path.stem: json.loads(path.read_text("utf-8")) for path in sorted((root / "docs/schema").glob("*.json"))}


def each(schema: Any, name: str = "") -> Any:
    """Every field below a schema, with its name."""
    if isinstance(schema, dict):
        for field, value in schema.get("properties", {}).items():
            yield field, value
        for value in schema.values():
            yield from each(value)
    elif isinstance(schema, list):
        for value in schema:
            yield from each(value)


def test_every_field_of_a_muscle_is_here() -> None:
    assert set(FIELDS) | {"rubber", "braid"} == set(_fields.MUSCLE)


@pytest.mark.parametrize("name", FIELDS)
def test_a_field_of_a_muscle_is_given_replaced_and_read_back(name: str) -> None:
    text, value, other, beside = FIELDS[name]

    def given(of: Any) -> dict[str, Any]:
        return {**beside, name: of}

    muscle = mk.Muscle(**given(value))
    # The area of a round strand is what a muscle file holds.
    assert getattr(muscle, name) == (pytest.approx(value, rel=1e-15) if name == "strand_diameter_mm" else value)
    assert mk.Muscle().replace(**given(value)) == muscle == mk.Muscle.from_toml(muscle.to_toml())
    assert mk.muscle_show(**given(value)).to_dict() == muscle.show().to_dict()
    if text:
        assert mk.Muscle(**given(text)) == muscle == mk.Muscle().replace(**given(text))
    for call in (lambda: mk.Muscle(**given(other)), lambda: mk.Muscle().replace(**given(other)), lambda: mk.muscle_show(**given(other))):
        with pytest.raises(mk.MckibbenError):
            call()


def test_what_a_muscle_does_not_have_is_none_and_what_no_muscle_has_is_an_error() -> None:
    muscle = mk.Muscle()
    assert (muscle.seating_mm, muscle.slip_mm_per_n, muscle.grip_mm, muscle.turns) == (None, None, None, None)
    assert muscle.stiffness == "paper" and mk.Muscle(stiffness="inextensible").stiffness == "inextensible"
    with pytest.raises(TypeError, match="grip_nm"):
        muscle.replace(grip_nm=1)  # type: ignore[call-arg,unused-ignore]
    with pytest.raises(AttributeError):
        muscle.grip_nm  # type: ignore[attr-defined]


def test_texts_have_the_unit_of_the_field() -> None:
    assert mk.force(pressure_mpa=0.2, slip_mm_per_n="0.001 mm/N", model="ideal") == mk.force(pressure_mpa=0.2, slip_mm_per_n=0.001, model="ideal")
    with pytest.raises(mk.QuantityError, match="a force; expected a compliance"):
        mk.force(pressure_mpa=0.2, slip_mm_per_n="1 N")
    given: dict[str, Any] = {"force_n": 700, "contraction": 0.15, "max_pressure_mpa": 0.25, "model": "universal"}
    design = mk.design(**given, tolerance={"stiffness": "10%", "modulus": "5 %", "wall_mm": "0.1 mm"})
    assert design == mk.design(**given, tolerance={"stiffness": 0.1, "modulus": 0.05, "wall_mm": 0.1})
    with pytest.raises(mk.QuantityError):
        mk.design(**given, tolerance={"stiffness": "10 N/mm"})


def test_what_a_field_holds_is_said_where_something_else_is_given() -> None:
    """In plain words, with what was given: of a muscle, of a model, of a command, of every plain number of each of them."""
    said = '`end_factor` is a number without a unit, not the text "1 mm"'
    calls: list[Any] = [
        lambda: mk.Muscle(end_factor="1 mm"),
        lambda: mk.Muscle().replace(end_factor="1 mm"),
        lambda: mk.force(pressure_mpa=0.2, end_factor="1 mm"),
        lambda: mk.ask("force", {"pressure_mpa": 0.2, "end_factor": "1 mm"}),
        lambda: mk.curve(test="isobaric", pressures_mpa=[0.2], end_factor="1 mm"),
    ]
    for call in calls:
        with pytest.raises(mk.UsageError) as caught:
            call()
        assert said in str(caught.value) and caught.value.field == "end_factor"
    for name in ("cone_factor", "turns"):
        with pytest.raises(mk.UsageError, match=f"`{name}` is a number without a unit"):
            mk.Muscle(**{name: "1 mm"})
    with pytest.raises(mk.UsageError, match="`model` is a text, not 5"):
        mk.Muscle().model(5)


def test_kinds_by_name_are_those_of_the_schemas(root: Path) -> None:
    """Every field of every schema: by its name, or by its group, it is what the schema says."""
    seen = set()
    for command, schema in schemas(root).items():
        for name, field in each(schema["request"]):
            if not isinstance(field, dict) or "x-quantity" not in field:
                continue
            said = (field["x-quantity"], field.get("x-unit", ""))
            groups = [g for g, of in _fields.GROUPS.items() if of.get(name) == said]
            assert _quantity.kind_of(name) == said or groups, (command, name, said)
            seen.add(name)
        for name, field in each(schema["answer"]):
            if isinstance(field, dict) and "x-unit" in field:
                known = _quantity.kind_of(name)
                assert known is not None and known[1] == field["x-unit"], (command, name)
    assert {"slip_mm_per_n", "contraction", "damping_n_s_per_m", "stiffness_nm_per_rad"} <= seen


def test_every_unit_is_one_of_pint(root: Path) -> None:
    """What is 1 in the unit of a field is 1 from pint; 1 of another dimension is refused."""
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    names = {name for schema in schemas(root).values() for name, field in each(schema["request"]) if isinstance(field, dict) and "x-unit" in field}
    assert len(names) > 30
    for name in sorted(names):
        spelled = _quantity.unit_for_pint(name)
        assert _quantity.number(name, unit.Quantity(1.0, spelled)) == 1.0, name
        with pytest.raises(mk.QuantityError):
            _quantity.number(name, unit.Quantity(1.0, "kelvin"))
    assert _quantity.number("slip_mm_per_n", 1 * unit.meter / unit.newton) == pytest.approx(1000)


def test_documentation_has_the_units_of_the_schemas(root: Path) -> None:
    page = (root / "docs/python-reference.md").read_text("utf-8")
    sources = "\n".join(Path(str(module.__file__)).read_text("utf-8") for module in (_answers, _commands, _fields))
    said: dict[str, set[str]] = {}
    for name, unit in re.findall(r"^- `(\w+)` \(([^)]*(?:\([^)]*\))?)\): ", page, flags=re.MULTILINE) + re.findall(r"^ +(\w+) : ([^|\n\[]*)$", sources, flags=re.MULTILINE):
        said.setdefault(name, set()).add(unit)
    for name, units in {"slip_mm_per_n": "mm/N", "force_per_pressure_n_per_mpa": "N/MPa", "stiffness_n_per_mm": "N/mm", "volume_mm3": "mm3"}.items():
        assert said[name] == {units}, (name, said[name])
    for name, field in (pair for schema in schemas(root).values() for pair in each(schema)):
        if isinstance(field, dict) and "x-unit" in field and name in said:
            # Hand-written pages name degrees, and several names with their units in one line.
            assert said[name] <= {field["x-unit"], "degrees"} or name == "stiffness", (name, said[name])


def test_signatures_are_those_of_the_schemas(root: Path) -> None:
    import inspect

    own = set(inspect.signature(mk.Muscle).parameters)
    assert own == {"base", *_fields.MUSCLE}
    for command in ("force", "pressure", "contraction", "curve", "muscle-show", "design"):
        fields = set(schemas(root)[command]["request"]["properties"])
        given = set(inspect.signature(getattr(_commands, command.replace("-", "_"))).parameters)
        assert fields <= given, (command, fields - given)
