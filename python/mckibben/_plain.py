"""Arguments as the plain maps, lists and numbers of a request."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from . import _native, _schema
from ._base import named
from ._files import FORMULAS, TABLES, beside, formula, measured, table, text
from ._problem import InputError
from ._quantity import number, numbers

# What a muscle is made of, in the order in which one part depends on another.
PARTS = ("tube", "rubber", "braid", "terminals", "friction")


def field(name: str, value: Any, schema: _schema.Schema) -> Any:
    """A field of a request, by its schema."""
    kind, holds = _schema.quantity(schema), None if isinstance(schema.get("type"), str) and "items" not in schema else _schema.record_of(schema)
    if holds == "TextFile" or name == "cases":
        read = measured if name == "cases" else table if name in TABLES else formula if name in FORMULAS else text
        return [read(v) for v in (value if isinstance(value, (list, tuple)) else [value])] if _schema.is_list(schema) else read(value)
    if kind is None or isinstance(value, bool):
        return rest(name, value, schema)
    if isinstance(value, Mapping):
        # All between two ends.
        return {str(end): number(name, v, kind) for end, v in value.items() if v is not None}
    if kind[0] == "stiffness" and isinstance(value, str) and value.strip().lower() in ("paper", "inextensible"):
        return value.strip().lower()
    if holds == "Choice" and isinstance(value, tuple) and len(value) == 2:
        # Two bounds; several values are a list.
        return {end: number(name, v, kind) for end, v in zip(("low", "high"), value)}
    several = isinstance(value, (list, tuple, range)) or getattr(value, "ndim", 0) == 1
    if holds == "Choice" and isinstance(value, str):
        return _native.choice(value, kind[0], name)
    return numbers(name, value, kind) if _schema.is_list(schema) or holds == "Choice" and several else number(name, value, kind)


def rest(name: str, value: Any, schema: _schema.Schema) -> Any:
    """What is neither a quantity nor a file."""
    if isinstance(value, Mapping):
        fields = _schema.object_of(schema)
        return {str(n): field(str(n), v, fields.get(str(n), {})) for n, v in value.items() if v is not None}
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, (list, tuple)):
        return [rest(name, v, _schema.items(schema)) for v in value]
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
        muscle = {name: values.pop(name) for name in ("muscle", *_schema.muscle()) if name in values}
        values["muscle"] = {"name": "muscle", "text": muscle_text(muscle)}
    fields = _schema.request(command)
    return {name: field(name, value, fields[name]) for name, value in values.items()}


def muscle_text(values: dict[str, Any]) -> str:
    """The text of the muscle file that says all of this."""
    values = {name: value for name, value in values.items() if value is not None}
    parts = []
    for name in PARTS:
        if name not in values or isinstance(values[name], str) and name in _schema.muscle():
            continue
        part, table = values.pop(name), "tube.material" if name == "rubber" else name
        if isinstance(part, Mapping):
            part = named(name.capitalize())(**part)
        if getattr(part, "_table", "") != table:
            raise TypeError(f"{name}: a {name.capitalize()}{' or a name' if name in _schema.muscle() else ''}, not {type(part).__name__}")
        twice = [field for field in ("rubber_file" if name == "rubber" else "", *_schema.part(name).values()) if field in values]
        if twice:
            raise InputError(f"`{twice[0]}` is given, and so is a whole `{name}`", kind="usage", field=twice[0], hint=f"give it to the {name}, or all of its values by themselves")
        parts.append((table, part.to_toml()))
    fields = _schema.request("check")
    return _native.muscle_text({name: field(name, value, fields[name]) for name, value in values.items()}, parts)


def tube_for(braid: Mapping[str, Any]) -> dict[str, Any]:
    """A tube that a braid fits, as a table: on which it is read by itself."""

    def size(name: str) -> float | None:
        value = braid.get(name, braid.get(f"{name}_mm"))
        return None if value is None else number(f"{name}_mm", value)

    own, diameter, strand = size("outer_diameter"), size("diameter"), size("strand_length")
    if own is not None:
        diameter = own
    elif braid.get("name") is not None and diameter is None:
        points = (_native.ask("parts-show", {"name": braid["name"]}).get("sleeve") or {"points": []})["points"]
        diameter = points[len(points) // 2]["outer_diameter_mm"] if points else None
    elif diameter is not None:
        diameter *= 0.9
    diameter = 30.0 if diameter is None else diameter
    return {"tube": {"outer_diameter": diameter, "wall_thickness": 0.05 * diameter, "length": 285.0 if strand is None else 0.8 * strand}}
