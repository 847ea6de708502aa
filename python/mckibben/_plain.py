"""Arguments as the plain maps, lists and numbers of a request."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from . import _native
from ._files import beside, formula, measured, table, text
from ._quantity import kind_of, number, numbers

LISTS = {"pressures_mpa", "contractions", "forces_n", "angles_deg", "outer_diameters_mm", "walls_mm", "hold_out_mm", "strand_length_per_turn_mm"}
TEXTS = {"muscle", "muscles", "joint", "drive", "plan"}
TABLES = {"data", "table", "tables", "load_tables"}
FORMULAS = {"formulas", "file"}
MUSCLE_FIELDS = [
    "muscle", "outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "rubber", "braid", "strand_diameter_mm", "strand_modulus_mpa",
    "stiffness", "seating_mm", "end_factor", "cone_factor", "strand_length_mm", "turns",
]
# Fields of `design` that may be an interval.
CHOICES = {"outer_diameter_mm", "wall_mm", "angle_deg", "length_mm", "radius_mm"}


def field(name: str, value: Any, *, within: str = "") -> Any:
    """A field of a request."""
    if isinstance(value, bool) and kind_of(name) is None or isinstance(value, int) and name == "muscles":
        return value
    if name in TEXTS:
        return [text(v) for v in value] if name == "muscles" else text(value)
    if name in TABLES:
        many = name in ("tables", "load_tables") or within == "identify"
        return [table(v) for v in (value if isinstance(value, (list, tuple)) else [value])] if many else table(value)
    if name in FORMULAS:
        return [formula(v) for v in value] if name == "formulas" else formula(value)
    if name == "cases":
        return [measured(v) for v in (value if isinstance(value, (list, tuple)) else [value])]
    if isinstance(value, Mapping):
        return {str(k): field(str(k), v, within=name) for k, v in value.items() if v is not None}
    if within == "tolerance" and name in ("modulus", "stiffness"):
        return _native.quantity(value, "ratio", name) if isinstance(value, str) else number(name, value)
    if name == "stiffness" and isinstance(value, str) and value.strip().lower() in ("paper", "inextensible"):
        return value.strip().lower()
    kind = kind_of(name)
    if kind is None or isinstance(value, bool):
        return rest(value)
    if name in LISTS:
        return numbers(name, value)
    if within == "design" and name in CHOICES:
        if isinstance(value, str):
            return _native.choice(value, kind[0], name)
        several = isinstance(value, (list, tuple, range)) or getattr(value, "ndim", 0) == 1
        return numbers(name, value) if several else number(name, value)
    return number(name, value)


def rest(value: Any) -> Any:
    """What is neither a quantity nor a file."""
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, (list, tuple)):
        return [field("", v) if isinstance(v, Mapping) else rest(v) for v in value]
    if hasattr(value, "tolist") and not isinstance(value, (str, bytes)):
        return value.tolist()
    return value


def models(values: dict[str, Any]) -> None:
    """Formulas among the names of models are handed over as files."""
    given = values.get("model")
    names = [given] if given is not None else values.get("models")
    if names is None:
        return
    if isinstance(names, str):
        names = [names]
    files = list(values.get("formulas") or [])
    words = []
    for name in names:
        if hasattr(name, "to_json"):
            files.append(name)
            words.append(name.name)
            continue
        word = os.fspath(name) if isinstance(name, os.PathLike) else name
        if isinstance(word, str) and word.strip().lower().endswith(".json"):
            files.append(word)
        words.append(word)
    if given is not None:
        values["model"] = words[0]
    else:
        values["models"] = words
    if files:
        values["formulas"] = files


def request(command: str, values: dict[str, Any]) -> dict[str, Any]:
    """The request of a command."""
    values = {name: value for name, value in values.items() if value is not None}
    models(values)
    beside(values)
    if not isinstance(values.get("rubber", ""), str) or not isinstance(values.get("braid", ""), str):
        muscle = {name: values.pop(name) for name in MUSCLE_FIELDS if name in values}
        values["muscle"] = {"name": "muscle", "text": muscle_text(muscle)}
    return {name: field(name, value, within=command) for name, value in values.items()}


def muscle_text(values: dict[str, Any]) -> str:
    """The text of the muscle file that says all of this."""
    values = {name: value for name, value in values.items() if value is not None}
    parts = {}
    for name in ("rubber", "braid"):
        if not isinstance(values.get(name, ""), str):
            part = values.pop(name)
            if not hasattr(part, "to_toml"):
                raise TypeError(f"{name}: a name or a {name.capitalize()}, not {type(part).__name__}")
            parts[name] = part.to_toml()
    return _native.muscle_text({name: field(name, value) for name, value in values.items()}, parts.get("rubber"), parts.get("braid"))
