"""Documentation of what the schema describes, as NumPy has it."""

from __future__ import annotations

import textwrap
from functools import cache

from . import _schema


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


def entries(title: str, fields: dict[str, _schema.Schema]) -> list[str]:
    """A part that lists fields with their units."""
    return section(title, [entry(name, _schema.doc(schema), _schema.unit(schema)) for name, schema in fields.items()])
