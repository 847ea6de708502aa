"""What requests and answers hold, by their JSON Schema. The compiled half is asked for it once, when something of it is used first."""

from __future__ import annotations

import json
import re
import textwrap
from collections.abc import Callable
from functools import cache
from typing import Any

from . import _native

Schema = Any


@cache
def bundle() -> dict[str, Any]:
    """Request, answer and error of each command, and in ``$defs`` what they refer to."""
    return _native.schema()


def commands() -> list[str]:
    """The commands, by their names on the command line."""
    return [name for name in bundle() if not name.startswith("$")]


def reference(schema: Schema) -> str | None:
    """The name of the definition to which a schema refers."""
    return schema["$ref"].rsplit("/", 1)[-1] if isinstance(schema, dict) and "$ref" in schema else None


def defined(schema: Schema) -> Schema:
    """A schema, or the definition to which it refers."""
    name = reference(schema)
    return schema if name is None else bundle()["$defs"][name]


def options(schema: Schema) -> list[Schema]:
    """The alternatives of a schema."""
    return [*schema.get("anyOf", []), *schema.get("oneOf", [])] if isinstance(schema, dict) else []


def words(schema: Schema) -> list[str]:
    """The words of a schema that is a choice of words, else none."""
    if all(isinstance(word, str) for word in schema.get("enum", [None])):
        return list(schema["enum"])
    out: list[str] = []
    for option in options(schema):
        found = [option["const"]] if "const" in option else option.get("enum") if option.get("type") == "string" else None
        if found is None:
            return []
        out += found
    return out


def properties(schema: Schema) -> dict[str, Schema]:
    """All fields of an object, those of its variants among them."""
    schema = defined(schema)
    out = dict(schema.get("properties", {}))
    for option in [*options(schema), *schema.get("allOf", [])]:
        for name, field in properties(option).items():
            out.setdefault(name, field)
    return out


def required(schema: Schema) -> set[str]:
    """The fields that an object always has."""
    schema = defined(schema)
    of_options = [required(option) for option in options(schema)]
    return set(schema.get("required", [])).union(set.intersection(*of_options) if of_options else ())


@cache
def request(command: str) -> dict[str, Schema]:
    """The fields of a request."""
    return properties(bundle()[command]["request"])


def figure_in(command: str, units: str) -> str | bool | None:
    """What asks for a figure in these units, or for one in its own; None where a command has no figure."""
    figure = request(command).get("figure")
    return None if figure is None else True if figure.get("type") == "boolean" else units


@cache
def muscle() -> dict[str, Schema]:
    """The fields of a muscle besides its file."""
    return {name: field for name, field in request("check").items() if field.get("x-group") == "muscle" and name != "muscle"}


def is_record(schema: Schema) -> bool:
    """Whether a schema is that of an object with fields."""
    return bool(properties(schema)) and not words(schema)


def record_of(schema: Schema) -> str | None:
    """The name of the record that a field holds, or holds several of."""
    name = reference(schema)
    if name is not None:
        return name if is_record(schema) else record_of(defined(schema))
    parts = [*options(schema), schema.get("items"), schema.get("additionalProperties")] if isinstance(schema, dict) else []
    return next((found for part in parts if (found := record_of(part))), None)


def is_list(schema: Schema) -> bool:
    """Whether a field holds several values."""
    kind = schema.get("type", [])
    return "array" in ([kind] if isinstance(kind, str) else kind) or any(map(is_list, options(schema)))


def items(schema: Schema) -> Schema:
    """What a list holds."""
    return schema.get("items") or next((found for option in options(schema) if (found := items(option))), {})


def object_of(schema: Schema) -> dict[str, Schema]:
    """The fields of the object that a field holds, which may be left out."""
    found = [properties(part) for part in [schema, *options(schema)] if isinstance(part, dict) and is_record(part)]
    return found[0] if found else {}


def quantity(schema: Schema) -> tuple[str, str] | None:
    """The kind of quantity of a field and the unit of its numbers; none of a plain number, or no number."""
    return (schema["x-quantity"], schema.get("x-unit", "")) if isinstance(schema, dict) and "x-quantity" in schema else None


def unit(schema: Schema) -> str:
    """The unit of a field's numbers in words for people."""
    kind = schema if isinstance(schema, dict) else {}
    return str(kind.get("x-unit") or ("ratio" if kind.get("x-quantity") == "ratio" else ""))


def doc(schema: Schema) -> str:
    """The description: rustdoc's brackets around references and its examples are left out."""
    text = schema.get("description", "") if isinstance(schema, dict) else ""
    text = re.sub(r"```.*?```", "", text, flags=re.DOTALL).strip()
    text = re.sub(r"\\\[([a-z0-9]+)\\\]", r"[\1]", text)
    return re.sub(r"\[(`[^`]*`)\](\([^)]*\))?", r"\1", text)


def union(kinds: list[str]) -> str:
    """One of several types; None is the last."""
    kinds = list(dict.fromkeys(kinds))
    if "Any" in kinds:
        return "Any"
    return " | ".join([kind for kind in kinds if kind != "None"] + [kind for kind in kinds if kind == "None"])


def type_of(schema: Schema, named: Callable[[str, Schema], str]) -> str:
    """The type of a schema in the words of Python; `named` has those of definitions."""
    if not isinstance(schema, dict) or not schema:
        return "Any"
    if name := reference(schema):
        return named(name, defined(schema))
    if choice := words(schema):
        return f"Literal[{', '.join(map(json.dumps, choice))}]"
    if alternatives := options(schema):
        return union([type_of(option, named) for option in alternatives])
    kind = schema.get("type")
    if isinstance(kind, list):
        return union([type_of({**schema, "type": one}, named) for one in kind])
    if kind == "array" and "prefixItems" in schema:
        return f"tuple[{', '.join(type_of(item, named) for item in schema['prefixItems'])}]"
    if kind == "array":
        return f"list[{type_of(schema.get('items'), named)}]"
    if kind == "object":
        return f"dict[str, {type_of(schema.get('additionalProperties') or None, named)}]"
    return {"string": "str", "number": "float", "integer": "int", "boolean": "bool", "null": "None"}.get(str(kind), "Any")


def answer_type(schema: Schema) -> str:
    """The type of a field of an answer."""
    return type_of(schema, lambda name, target: name if is_record(target) else answer_type(target))


def request_type(schema: Schema) -> str:
    """The type of a field of a request."""

    def named(name: str, target: Schema) -> str:
        known = {"TextFile": "FileLike", "Choice": "Choice", "Stiffness": "Number | str"}.get(name)
        return known or ("Mapping[str, Plain]" if target.get("type") == "object" and not words(target) else request_type(target))

    return type_of(schema, named)


@cache
def wrapped(text: str, indent: str = "", width: int = 114) -> str:
    """Paragraphs in lines of a width."""
    return "\n\n".join(textwrap.fill(" ".join(p.split()), width, initial_indent=indent, subsequent_indent=indent) for p in text.split("\n\n"))


def entry(name: str, text: str, unit: str = "") -> str:
    """A name with its unit, and what it is below."""
    return name + (f" : {unit}" if unit else "") + "\n" + wrapped(text or "See the documentation.", "    ")


def section(title: str, lines: list[str]) -> list[str]:
    """A part with its heading, where it has lines."""
    return ["\n".join([title, "-" * len(title), *lines])] if lines else []


def entries(title: str, fields: dict[str, Schema]) -> list[str]:
    """A part that lists fields with their units."""
    return section(title, [entry(name, doc(schema), unit(schema)) for name, schema in fields.items()])
