"""Arguments as the plain maps, lists and numbers of a request."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from . import _native, _schema
from ._errors import InputError
from ._files import FORMULAS, TABLES, beside, formula, measured, table, text
from ._quantity import number, numbers


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
    if not isinstance(values.get("rubber", ""), str):
        muscle = {name: values.pop(name) for name in ("muscle", *_schema.muscle()) if name in values}
        values["muscle"] = {"name": "muscle", "text": muscle_text(muscle)}
    fields = _schema.request(command)
    return {name: field(name, value, fields[name]) for name, value in values.items()}


def muscle_text(values: dict[str, Any]) -> str:
    """The text of the muscle file that says all of this."""
    values = {name: value for name, value in values.items() if value is not None}
    rubber = None
    if not isinstance(values.get("rubber", ""), str):
        rubber = values.pop("rubber")
        if "rubber_file" in values:
            raise InputError("`rubber_file` is given, and so is a whole `rubber`", kind="usage", field="rubber_file", hint="give one of them")
        if not isinstance(rubber, Mapping) and getattr(rubber, "_table", "") != "tube.material":
            raise TypeError(f"rubber: a Rubber or a name, not {type(rubber).__name__}")
        rubber = material(rubber) if isinstance(rubber, Mapping) else rubber.to_toml()
    fields = _schema.request("check")
    request = {name: field(name, value, fields[name]) for name, value in values.items()}
    return _native.muscle_text(request, rubber)


def material(values: Mapping[str, Any]) -> str:
    """The table of a rubber of its law and constants."""
    return _native.toml_text({"tube": {"material": {name: constant(value) for name, value in values.items() if value is not None}}})


def constant(value: Any) -> Any:
    """A constant of a law: a text, a number, or several."""
    if hasattr(value, "magnitude"):
        value = value.to("dimensionless" if value.dimensionless else "MPa").magnitude
    if isinstance(value, (str, bool)) or value is None:
        return value
    if isinstance(value, Mapping):
        return {name: constant(v) for name, v in value.items()}
    return tuple(map(constant, value)) if hasattr(value, "__iter__") and getattr(value, "shape", None) != () else float(value)
