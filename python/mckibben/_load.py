"""Files that were saved as the objects that they hold."""

from __future__ import annotations

import json
import math
import os
from typing import Any

from . import _answers, _native
from ._drives import Drive, Joint
from ._formula import Formula
from ._muscle import Muscle
from ._results import _columned
from ._rubber import Rubber
from ._table import Table


def load(path: str | os.PathLike[str]) -> Any:
    """What ``save()`` wrote: an answer (JSON), a muscle, a rubber, a joint or a drive (TOML), a formula (JSON)."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    if not text.lstrip().startswith("{"):
        held = _native.toml(os.fspath(path), text)
        if "command" in held or "joint" in held:
            return (Drive if "command" in held else Joint).load(path)
        # A rubber that was saved begins with its table, a muscle with a comment.
        return (Rubber if text.startswith("[tube.material]") else Muscle).from_toml(text)
    held = json.loads(text)
    if "mckibben" not in held:
        return Formula(text)
    kind: Any = _answers.kind(held["mckibben"])
    asked = tuple(held["asked"]) if held["asked"] else None
    if "points" in held:
        return _columned(kind, held["data"], asked, Table({name: [math.nan if v is None else v for v in values] if any(isinstance(v, float) for v in values) else values for name, values in held["points"].items()}))
    return kind(held["data"], asked)
