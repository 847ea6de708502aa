"""Files: those of a request, read where they are paths, else as they are given; and those that are saved."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from . import _native
from ._errors import ExistingFileError, InputError
from ._table import Table

# Fields of requests whose files are tables, and those whose files are formulas.
TABLES = ("data", "log", "table", "tables", "load_tables")
FORMULAS = ("formulas", "file")


def put(files: Mapping[str | os.PathLike[str], str | bytes], overwrite: bool = False) -> None:
    """Puts files at their places, each whole or not at all, and none where another file would be lost: one that is neither empty nor the same."""
    contents = {os.fspath(path): content.encode() if isinstance(content, str) else content for path, content in files.items()}
    for path, content in contents.items():
        if not (overwrite or not os.path.isfile(path) or os.path.getsize(path) == 0 or _is(path, content)):
            raise ExistingFileError(f"{path} is another file and would be overwritten", kind="output", field="path", hint="name another place, or replace it with overwrite=True")
    for path, content in contents.items():
        _native.write_file(path, content)


def _is(path: str, content: bytes) -> bool:
    """Whether a file has this content."""
    with open(path, "rb") as file:
        return os.path.getsize(path) == len(content) and file.read() == content


def text(value: Any) -> dict[str, str]:
    """A file that was written by hand, or a muscle of the library by its name (``lib:NAME``)."""
    if hasattr(value, "to_toml"):
        return {"name": type(value).__name__.lower(), "text": value.to_toml()}
    if isinstance(value, Mapping):
        return {"name": str(value["name"]), "text": str(value["text"])}
    path = os.fspath(value)
    return {"name": path, "text": "" if _is_of_library(path) else _native.read_text(path)}


def _is_of_library(name: str) -> bool:
    """Whether a muscle of the library is named in the place of a file."""
    return name.strip().lower().startswith("lib:") and not os.path.exists(name)


def _place(folder: str | None, name: str) -> str:
    """The place of a file that another file names, which lies in a folder."""
    return name if _is_of_library(name) else os.path.join(folder or "", name)


def formula(value: Any) -> dict[str, str]:
    """The file of a formula."""
    if hasattr(value, "to_json"):
        return {"name": value.name, "text": value.to_json()}
    if isinstance(value, Mapping):
        return {"name": str(value["name"]), "text": str(value["text"])}
    path = os.fspath(value)
    return {"name": path, "text": _native.read_formula(path)}


def table(value: Any) -> dict[str, str]:
    """A table: a path, a text, a data frame, an answer, or columns by name."""
    if isinstance(value, (str, os.PathLike)):
        name, text = _native.read_table(os.fspath(value))
        return {"name": name, "text": text}
    if isinstance(value, Mapping) and set(value) == {"name", "text"}:
        return {"name": str(value["name"]), "text": str(value["text"])}
    # Numbers with as many digits as it takes to read back the same.
    return {"name": "data", "text": Table.of(value).to_csv()}


def measured(value: Any) -> dict[str, str]:
    """A measured muscle or rubber: the path of its folder, or its files as texts. A rubber has no ``muscle.toml``, and a folder of no library no
    ``identified.toml``.
    """
    if isinstance(value, Mapping):
        return {str(name): str(text) for name, text in value.items()}
    path = os.fspath(value)
    files = {name: os.path.join(path, f"{name}.toml") for name in ("case", "muscle", "identified")}
    texts = {name: _native.read_text(file) for name, file in files.items() if name == "case" or os.path.exists(file)}
    _, points = _native.read_table(os.path.join(path, "points.csv"))
    return {"name": os.path.basename(os.path.abspath(path)), "muscle": "", **texts, "points": points}


def beside(values: dict[str, Any]) -> None:
    """The files that a joint or drive file names: those that are given by name, the others from beside it."""
    drive = values.get("drive")
    if drive is not None and hasattr(drive, "_files"):
        # An object has its own; others take their place.
        values.update({**drive._files(), **{name: value for name, value in values.items() if value is not None}})
    if drive is not None:
        file, folder = text(drive), _folder(drive)
        subject, name, tables = _native.drive_files(file["name"], file["text"])
        values["drive"] = file
        if subject == "joint" and values.get("joint") is None and folder is not None:
            values["joint"] = os.path.join(folder, name)
        elif subject == "muscle" and (values.get("muscle") is not None or folder is not None):
            values["muscle"] = {**text(values.get("muscle") or _place(folder, name)), "name": name}
        if values.get("tables") is None and tables and folder is not None:
            values["tables"] = [{**table(os.path.join(folder, t)), "name": t} for t in tables]
        elif isinstance(values.get("tables"), Mapping):
            values["tables"] = [{**table(of), "name": str(t)} for t, of in values["tables"].items()]
    joint, muscles = values.get("joint"), values.get("muscles")
    if joint is not None and hasattr(joint, "muscles"):
        muscles = {**joint.muscles, **(muscles or {})}
    if joint is not None and (muscles is None or isinstance(muscles, Mapping)):
        file, folder, given = text(joint), _folder(joint), muscles or {}
        values["joint"] = file
        names = dict.fromkeys(_native.joint_files(file["name"], file["text"]))
        if unknown := [name for name in given if name not in names]:
            raise InputError(f"{file['name']} names {', '.join(names)}, not {unknown[0]}", kind="usage", field="muscles")
        there = [name for name in names if name in given or folder is not None]
        values["muscles"] = [{**text(given[name] if name in given else _place(folder, name)), "name": name} for name in there]


def _folder(value: Any) -> str | None:
    """Where a file lies; None where it is given as its text."""
    return os.path.dirname(os.fspath(value)) if isinstance(value, (str, os.PathLike)) else None
