"""Units and fields come from the schemas: every field of every request and answer, of a muscle, and of the documentation."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import mckibben as mk
from mckibben import _answers, _commands, _quantity, _schema

# Of fields of a muscle: a value with its unit, the number that it is, and what must stand beside it. Another measure needs no line here.
FIELDS: dict[str, tuple[str, float, dict[str, Any]]] = {
    "outer_diameter_mm": ("3.1 cm", 31.0, {}),
    "wall_mm": ("2500 um", 2.5, {}),
    "length_mm": ("0.3 m", 300.0, {}),
    "density_kg_per_m3": ("0.93 g/cm3", 930.0, {}),
    "prestretch": ("", 1.1, {}),
    "temperature_degc": ("60 degC", 60.0, {}),
    "angle_deg": ("25 deg", 25.0, {}),
    "strand_diameter_mm": ("0.25 mm", 0.25, {"braid": "flexo-overexpanded-0.75in", "strand_modulus_mpa": 8530}),
    "strand_modulus_mpa": ("8.5 GPa", 8500.0, {"braid": "flexo-overexpanded-0.75in", "strand_diameter_mm": 0.25}),
    "stiffness": ("0.5 kN/mm", 500.0, {}),
    "seating_mm": ("1600 um", 1.6, {}),
    "slip_mm_per_n": ("4 mm/kN", 0.004, {}),
    "grip_mm": ("0.5 cm", 5.0, {}),
    "plug_diameter_mm": ("2.5 cm", 25.0, {}),
    "end_factor": ("", 1.1, {}),
    "cone_factor": ("", 0.4, {}),
    "strand_length_mm": ("33 cm", 330.0, {"turns": 1.6}),
    "turns": ("", 1.6, {"strand_length_mm": 330}),
    "strands": ("", 48.0, {}),
    "strand_area_mm2": ("0.003 cm2", 0.3, {"strands": 48, "strand_modulus_mpa": 2500}),
    "strand_strength_n": ("0.04 kN", 40.0, {"strands": 48}),
    "braid_diameter_mm": ("3.1 cm", 31.0, {}),
    "crimp": ("", 0.01, {}),
    "crimp_stiffness": ("", 0.2, {"crimp": 0.01}),
    "friction_coefficient": ("", 30.0, {"friction_exponent": 0.7}),
    "friction_exponent": ("", 0.7, {"friction_coefficient": 30}),
    "friction_presliding_mm": ("0.1 cm", 1.0, {"friction_lever_mm": 1}),
}


def each(schema: Any, path: str = "") -> Iterator[tuple[str, str, Any]]:
    """Every field below a schema: where it is, its name and its schema."""
    if isinstance(schema, dict):
        for field, value in schema.get("properties", {}).items():
            yield path, field, value
        for key, value in schema.items():
            yield from each(value, f"{path}.{key}")
    elif isinstance(schema, list):
        for value in schema:
            yield from each(value, path)


def test_every_field_of_a_muscle_is_an_argument_of_it() -> None:
    names = {"rubber", "braid", *FIELDS}
    assert names <= set(_schema.muscle()) and set(inspect.signature(mk.Muscle).parameters) == {"base", *_schema.muscle()}


@pytest.mark.parametrize("name", [name for name in _schema.muscle() if name not in ("rubber", "rubber_file", "braid")])
def test_a_field_of_a_muscle_is_given_replaced_and_read_back(name: str) -> None:
    schema = _schema.muscle()[name]
    # Between the bounds, beside the value where nothing is stated.
    low, high, usual = (schema.get(key, other) for key, other in (("x-minimum", 0.0), ("x-maximum", 2.0), ("default", 1.0)))
    text, value, beside = FIELDS.get(name, ("", min(max(1.05 * usual, low + 0.05), high), {}))
    unit = _schema.unit(schema)

    def given(of: Any) -> dict[str, Any]:
        return {**beside, name: of}

    muscle = mk.Muscle.prototype(**given(value))
    # The area of a round strand is what a muscle file holds.
    assert getattr(muscle, name) == (pytest.approx(value, rel=1e-15) if name == "strand_diameter_mm" else value)
    assert mk.Muscle.prototype().replace(**given(value)) == muscle == mk.Muscle.from_toml(muscle.to_toml())
    assert mk.check(**given(value), only_data=True).to_dict() == muscle.check(only_data=True).to_dict()
    for same in (text, f"{value!r} {unit}" if unit else ""):
        if same:
            assert mk.Muscle.prototype(**given(same)) == muscle == mk.Muscle.prototype().replace(**given(same))
    # A text in a unit of another kind of quantity.
    other = "1 mm2" if unit != "mm2" else "1 N"
    for call in (lambda: mk.Muscle.prototype(**given(other)), lambda: mk.Muscle.prototype().replace(**given(other)), lambda: mk.check(**given(other))):
        with pytest.raises(mk.MckibbenError):
            call()
    # Documented with its unit, as an argument and as an attribute.
    about = inspect.getdoc(mk.Muscle.__init__) or ""
    assert re.search(rf"^{name}{f' : {re.escape(unit)}' if unit else ''}$", about, flags=re.MULTILINE) and getattr(mk.Muscle, name).__doc__


def test_what_a_muscle_does_not_have_is_none_and_what_no_muscle_has_is_an_error() -> None:
    muscle = mk.Muscle.prototype()
    assert (muscle.seating_mm, muscle.slip_mm_per_n, muscle.grip_mm, muscle.turns) == (None, None, None, None)
    assert muscle.stiffness == "paper" and mk.Muscle.prototype(stiffness="inextensible").stiffness == "inextensible"
    with pytest.raises(TypeError, match="grip_nm"):
        muscle.replace(grip_nm=1)  # type: ignore[call-arg,unused-ignore]
    with pytest.raises(AttributeError):
        muscle.grip_nm


def test_texts_have_the_unit_of_the_field() -> None:
    assert mk.force(pressure_mpa=0.2, slip_mm_per_n="0.001 mm/N", model="ideal") == mk.force(pressure_mpa=0.2, slip_mm_per_n=0.001, model="ideal")
    with pytest.raises(mk.InputError, match="a force; expected a compliance"):
        mk.force(pressure_mpa=0.2, slip_mm_per_n="1 N")
    given: dict[str, Any] = {"force_n": 700, "contraction": 0.15, "max_pressure_mpa": 0.25, "model": "universal"}
    design = mk.design(**given, tolerance={"stiffness": "10%", "modulus": "5 %", "wall_mm": "0.1 mm"})
    assert design == mk.design(**given, tolerance={"stiffness": 0.1, "modulus": 0.05, "wall_mm": 0.1})
    with pytest.raises(mk.InputError):
        mk.design(**given, tolerance={"stiffness": "10 N/mm"})


def test_what_a_field_holds_is_said_where_something_else_is_given() -> None:
    """In plain words, with what was given: of a muscle, of a model, of a command, of every plain number of each of them."""
    said = '`end_factor` is a number without a unit, not the text "1 mm"'
    calls: list[Any] = [
        lambda: mk.Muscle.prototype(end_factor="1 mm"),
        lambda: mk.Muscle.prototype().replace(end_factor="1 mm"),
        lambda: mk.force(pressure_mpa=0.2, end_factor="1 mm"),
        lambda: mk.ask("force", {"pressure_mpa": 0.2, "end_factor": "1 mm"}),
        lambda: mk.curve(test="isobaric", pressures_mpa=[0.2], end_factor="1 mm"),
    ]
    for call in calls:
        with pytest.raises(mk.InputError) as caught:
            call()
        assert said in str(caught.value) and caught.value.field == "end_factor"
    for name in ("cone_factor", "turns"):
        with pytest.raises(mk.InputError, match=f"`{name}` is a number without a unit"):
            mk.Muscle.prototype(**{name: "1 mm"})
    with pytest.raises(mk.InputError, match="`model` is a text, not 5"):
        mk.Muscle.prototype().model(5)


def test_kinds_by_name_are_those_of_the_schemas() -> None:
    """A column of a table has its unit by its name: it is that of the field of the same name. Tolerances of moduli are ratios, and an export is in SI."""
    seen = set()
    for path, name, field in each(_schema.bundle()):
        if isinstance(field, dict) and {"x-unit", "x-quantity"} & field.keys() and "ToleranceFields" not in path and "ExportForm" not in path:
            known = _quantity.kind_of(name)
            assert known is not None and known[1] == field.get("x-unit", "") and known[0] in (field.get("x-quantity"), None), (path, name)
            seen.add(name)
    assert {"slip_mm_per_n", "contraction", "damping_n_s_per_m", "stiffness_nm_per_rad", "force_per_pressure_n_per_mpa"} <= seen


def test_every_unit_is_one_of_pint() -> None:
    """What is 1 in the unit of a field is 1 from pint; 1 of another dimension is refused."""
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    fields = {(name, kind) for _, name, field in each(_schema.bundle()) if (kind := _schema.quantity(field)) is not None and kind[1]}
    assert len(fields) > 30
    for name, kind in sorted(fields):
        spelled = _quantity.unit_for_pint(name, kind)
        assert _quantity.number(name, unit.Quantity(1.0, spelled), kind) == 1.0, name
        with pytest.raises(mk.InputError):
            _quantity.number(name, unit.Quantity(1.0, "candela"), kind)
    assert _quantity.number("slip_mm_per_n", 1 * unit.meter / unit.newton) == pytest.approx(1000)


def test_documentation_has_the_units_of_the_schemas(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(root / "python"))
    page = __import__("write").reference()
    made = [getattr(module, name) for module in (_answers, _commands) for name in module.__all__]
    sources = "\n".join(inspect.getdoc(thing) or "" for thing in [*made, mk.Muscle.__init__])
    said: dict[str, set[str]] = {}
    for name, unit in re.findall(r"^- `(\w+)` \(([^)]*(?:\([^)]*\))?)\): ", page, flags=re.MULTILINE) + re.findall(r"^(\w+) : ([^|\n\[]*)$", sources, flags=re.MULTILINE):
        said.setdefault(name, set()).add(unit)
    for name, units in {"slip_mm_per_n": "mm/N", "force_per_pressure_n_per_mpa": "N/MPa", "stiffness_n_per_mm": "N/mm", "volume_mm3": "mm3"}.items():
        assert said[name] == {units}, (name, said[name])
    assert len(said) > 150
    for _, name, field in each(_schema.bundle()):
        if isinstance(field, dict) and "x-unit" in field and name in said:
            # Hand-written pages name degrees, and several names with their units in one line.
            assert said[name] <= {field["x-unit"], "degrees"} or name == "stiffness", (name, said[name])


def test_signatures_are_those_of_the_schemas() -> None:
    for command in ("force", "pressure", "contraction", "curve", "check", "design"):
        given = set(inspect.signature(getattr(mk, command.replace("-", "_"))).parameters)
        assert set(_schema.request(command)) <= given, command
    assert str(inspect.signature(mk.parts_show)).startswith("(name: 'str | None' = None)")
    curve = inspect.signature(mk.Muscle.curve)
    assert list(curve.parameters)[:2] == ["self", "test"] and curve.parameters["test"].default == "isobaric" and not set(_schema.muscle()) & set(curve.parameters)
    assert inspect.signature(mk.sweep).parameters["muscles"].default == 100 and inspect.signature(mk.force).parameters["two_sided"].default is False


def test_stubs_are_python_and_have_every_name(root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import ast

    monkeypatch.syspath_prepend(str(root / "python"))
    __import__("write").stubs(tmp_path)
    there = {node.name for file in tmp_path.glob("*.pyi") for node in ast.parse(file.read_text("utf-8")).body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    assert there >= {*_answers.__all__, *_commands.__all__, *_commands.CLASSES}
    assert "slip_mm_per_n: 'Number | None' = None" in (tmp_path / "_commands.pyi").read_text("utf-8")
