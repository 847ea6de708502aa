"""Arguments as the plain maps, lists and numbers of a request."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from . import _native
from ._fields import CHOICES, LISTS, MUSCLE
from ._files import beside, formula, measured, table, text
from ._quantity import kind_of, number, numbers

TEXTS = {"muscle", "muscles", "joint", "drive", "plan"}
TABLES = {"data", "table", "tables", "load_tables"}
FORMULAS = {"formulas", "file"}


def field(name: str, value: Any, *, within: str = "") -> Any:
    """A field of a request."""
    kind = kind_of(name, within)
    if isinstance(value, bool) and kind is None or isinstance(value, int) and name == "muscles":
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
    if kind is None or kind[0] is None or isinstance(value, bool):
        return rest(value, within=name)
    if kind[0] == "stiffness" and isinstance(value, str) and value.strip().lower() in ("paper", "inextensible"):
        return value.strip().lower()
    if name in LISTS:
        return numbers(name, value, within)
    if name in CHOICES.get(within, ()):
        if isinstance(value, str):
            return _native.choice(value, kind[0], name)
        several = isinstance(value, (list, tuple, range)) or getattr(value, "ndim", 0) == 1
        return numbers(name, value, within) if several else number(name, value, within)
    return number(name, value, within)


def rest(value: Any, *, within: str = "") -> Any:
    """What is neither a quantity nor a file."""
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, (list, tuple)):
        return [field(within, v) if isinstance(v, Mapping) else rest(v, within=within) for v in value]
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
        muscle = {name: values.pop(name) for name in ("muscle", *MUSCLE) if name in values}
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
