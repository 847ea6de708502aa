"""Files that were saved as the objects that they hold."""

from __future__ import annotations

import json
import math
import os
from typing import Any

from . import _answers, _native, _results
from ._columns import _columned
from ._drives import Drive, Joint, Valve
from ._formula import Formula
from ._muscle import Muscle
from ._parts import PARTS, Rubber
from ._table import Table


def load(path: str | os.PathLike[str]) -> Any:
    """What ``save()`` wrote: an answer (JSON), a muscle or a part of one, a joint, a valve or a drive (TOML), a formula (JSON)."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    if not text.lstrip().startswith("{"):
        held = _native.toml(os.fspath(path), text)
        if "command" in held or "joint" in held:
            return (Drive if "command" in held else Joint).load(path)
        if {"name", "sonic_conductance"} & {*held} and not any(isinstance(value, dict) for value in held.values()):
            return Valve(**held)
        # A part that was saved begins with its table, a muscle with a comment.
        if text.startswith("[tube.material]"):
            return Rubber.from_toml(text)
        part = next((kind for name, kind in PARTS.items() if text.startswith("[") and {*held} <= {*kind._own}), None)
        return Muscle.from_toml(text) if part is None else part.from_toml(text)
    held = json.loads(text)
    if "mckibben" not in held:
        return Formula(text)
    kind = getattr(_results, held["mckibben"], None) or getattr(_answers, held["mckibben"])
    asked = tuple(held["asked"]) if held["asked"] else None
    if "muscles" in held:
        return _results._design(held["data"], asked, held["muscles"])
    if "points" in held:
        return _columned(kind, held["data"], asked, Table({name: [math.nan if v is None else v for v in values] if any(isinstance(v, float) for v in values) else values for name, values in held["points"].items()}))
    return kind(held["data"], asked)
