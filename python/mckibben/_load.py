"""Files that were saved as the objects that they hold."""

from __future__ import annotations

import json
import os
from typing import Any

from . import _api, _native
from ._drives import Drive, Joint, _muscle
from ._formula import Formula
from ._record import Record
from ._request import file
from ._rubber import Rubber


def load(path: str | os.PathLike[str]) -> Any:
    """What ``save()`` wrote or a person did: a muscle, a rubber, a joint or a drive (TOML), a formula or an answer (JSON); a muscle of the library by ``lib:NAME``.

    Raises
    ------
    FileError
        It is none of these.

    Examples
    --------
    >>> import mckibben as mk
    >>> mk.load("lib:dmsp-20-300").length_mm
    300.0
    """
    held = file(path, "table")
    text = held["text"]
    if not text.lstrip().startswith("{"):
        tables = _native.toml(held["name"], text)
        if "command" in tables or "joint" in tables:
            return (Drive if "command" in tables else Joint).load(path)
        # A rubber that was saved begins with its table, a muscle with a comment.
        return Rubber.from_toml(text) if text.startswith("[tube.material]") else _muscle(os.fspath(path))
    answer = json.loads(text)
    if "mckibben" not in answer:
        return Formula(text)
    kind = getattr(_api, answer["mckibben"])
    if not issubclass(kind, Record):
        return kind._load(answer)
    return kind._read(answer["data"], tuple(answer["asked"]) if answer["asked"] else None)
