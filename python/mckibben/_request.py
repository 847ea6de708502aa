"""Requests in the words of JSON: files are read where they are named, what is not given is left to the program."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, TypeVar

from . import _native
from ._errors import ExistingFileError, InputError
from ._values import Fixed, Options, Progress, columns_of, plain, to_csv

if TYPE_CHECKING:
    from ._record import Record

    Answer = TypeVar("Answer", bound=Record)

# Fields that are files, tables and formulas, and those that a design searches through.
FILES = ("muscle", "rubber_file", "parts", "plan", "drive", "joint")
TABLES = ("data", "log", "table", "tables", "load_tables")
FORMULAS = ("formulas", "file")
LISTS = ("data", "tables", "load_tables", "cases", "formulas", "muscles")
CHOICES = ("outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "radius_mm")


def ask(command: str, request: Mapping[str, Any] | None = None, *, progress: Progress = None) -> dict[str, Any]:
    """The answer to a request in the words of JSON: dicts in, dicts out.

    Parameters
    ----------
    command
        Its name: the words of the command line, joined by a hyphen, such as ``force`` or ``parts-list``.
    request
        What ``mckibben schema`` says: numbers in mm, MPa, N and degrees, or texts with their unit.
    progress
        True for a line on standard error, or a function that is called with (done, total).

    Returns
    -------
    dict
        The answer, as JSON has it.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.

    Examples
    --------
    >>> import mckibben as mk
    >>> round(mk.ask("force", {"pressure_mpa": "2 bar", "contraction": 0.1, "model": "ideal"})["force_n"], 1)
    573.7
    """
    with listening(progress, command) as heard:
        return _native.ask(command, {} if request is None else request, heard)


def answered(kind: type[Answer], command: str, given: dict[str, Any], figure: str | bool | None = None) -> Answer:
    """The answer to a command with these arguments; with its figure, as to draw it takes less than to ask again."""
    progress = given.pop("progress", None)
    if "self" in given:
        given = {**given.pop("self")._files(command), **{name: value for name, value in given.items() if value is not None}}
    request = fields(given)
    with listening(progress, command) as heard:
        return kind._read(_native.ask(command, request if figure is None else {**request, "figure": figure}, heard), (command, request))


def fields(given: Mapping[str, Any]) -> dict[str, Any]:
    """Arguments as the fields of a request."""
    given = {name.rstrip("_"): value for name, value in given.items() if value is not None}
    if "drive" in given or "joint" in given:
        _beside(given)
    out: dict[str, Any] = {}
    for name, value in given.items():
        read = file if name in FILES or name == "muscles" else table if name in TABLES else formula if name in FORMULAS else measured if name == "cases" else None
        if name in ("model", "models"):
            models = [value] if name == "model" or isinstance(value, str) else value
            words = [model.name if hasattr(model, "to_json") else os.fspath(model) if isinstance(model, os.PathLike) else model for model in models]
            files = [formula(model) for model, word in zip(models, words) if isinstance(word, str) and (hasattr(model, "to_json") or word.strip().lower().endswith(".json"))]
            out[name] = words[0] if name == "model" else words
            if files:
                out["formulas"] = [*out.get("formulas", []), *files]
        elif read is not None and not isinstance(value, (bool, int)):
            several = isinstance(value, (list, tuple))
            out[name] = [*out.get(name, []), *map(read, value if several else [value])] if several or name in LISTS else read(value)
        elif name in CHOICES and isinstance(value, tuple) and len(value) == 2:
            out[name] = dict(zip(("low", "high"), plain(name, value)))
        else:
            out[name] = plain(name, value)
    return out


def options(given: Mapping[str, Any]) -> dict[str, Any]:
    """The options of a model as fields of a request."""
    if unknown := [name for name in given if name not in Options.__annotations__]:
        from difflib import get_close_matches

        near = get_close_matches(unknown[0], Options.__annotations__, 1)
        raise TypeError(f"unexpected keyword argument {unknown[0]!r}" + (f"; did you mean {near[0]!r}?" if near else f"; a model has {', '.join(Options.__annotations__)}"))
    return fields(given)


@contextmanager
def listening(progress: Progress, what: str) -> Iterator[Callable[[int, int], object] | None]:
    """The function that hears of progress: the caller's own, or one that writes a line on standard error."""
    if progress is True:
        try:
            yield lambda done, total: print(f"\r{what}: {done} of {total}", end="", file=sys.stderr, flush=True)
        finally:
            print(file=sys.stderr)
    else:
        yield progress or None


def put(files: Mapping[str | os.PathLike[str], str | bytes], overwrite: bool = False) -> None:
    """Puts files at their places, each whole or not at all, and none where another file would be lost: one that is neither empty nor the same."""
    contents = {os.fspath(path): content.encode() if isinstance(content, str) else content for path, content in files.items()}
    for path, content in contents.items():
        if not overwrite and os.path.isfile(path) and os.path.getsize(path):
            with open(path, "rb") as there:
                if os.path.getsize(path) != len(content) or there.read() != content:
                    raise ExistingFileError(f"{path} is another file and would be overwritten", kind="output", field="path", hint="name another place, or replace it with overwrite=True")
    for path, content in contents.items():
        _native.write_file(path, content)


class Saved(Fixed):
    """An object that is the text of its file."""

    __slots__ = ()

    def _key(self) -> Any:
        """The text of its file."""
        raise NotImplementedError

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Writes its file, from which :func:`load` reads it again. Another file that is there is replaced only with ``overwrite``."""
        put({path: self._key()}, overwrite)


def file(value: Any, kind: str = "text") -> dict[str, str]:
    """A file: an object that is one, its content, its path, or a muscle of the library by its name (``lib:NAME``)."""
    if hasattr(value, "to_toml"):
        return {"name": type(value).__name__.lower(), "text": value.to_toml()}
    if isinstance(value, Mapping):
        return {"name": str(value["name"]), "text": str(value["text"])}
    path = os.fspath(value)
    if path.strip().lower().startswith("lib:") and not os.path.exists(path):
        return {"name": path, "text": ""}
    name, text = _native.read_file(path, kind)
    return {"name": name, "text": text}


def formula(value: Any) -> dict[str, str]:
    """The file of a formula."""
    return {"name": value.name, "text": value.to_json()} if hasattr(value, "to_json") else file(value, "formula")


def table(value: Any) -> dict[str, str]:
    """A table: a path, its text, a data frame, an answer, or columns by name."""
    if isinstance(value, (str, os.PathLike)) or isinstance(value, Mapping) and set(value) == {"name", "text"}:
        return file(value, "table")
    return {"name": "data", "text": to_csv(columns_of(value))}


def measured(value: Any) -> dict[str, str]:
    """A measured muscle or rubber: the path of its folder, or its files as texts. A rubber has no ``muscle.toml``, and a folder of no library no
    ``identified.toml``.
    """
    if isinstance(value, Mapping):
        return {str(name): str(text) for name, text in value.items()}
    path = os.fspath(value)
    files = {name: os.path.join(path, f"{name}.toml") for name in ("case", "muscle", "identified")}
    texts = {name: file(place)["text"] for name, place in files.items() if name == "case" or os.path.exists(place)}
    return {"name": os.path.basename(os.path.abspath(path)), "muscle": "", **texts, "points": table(os.path.join(path, "points.csv"))["text"]}


def beside(path: str, names: Sequence[str]) -> dict[str, str]:
    """The places of files that another file names, by these names."""
    return {name: name if name.startswith("lib:") else os.path.join(os.path.dirname(path), name) for name in names}


def _beside(given: dict[str, Any]) -> None:
    """The files that a joint or drive file names, from beside it where they are not given."""
    from ._drives import Drive, Joint

    for name, kind in (("drive", Drive), ("joint", Joint)):
        value = given.get(name)
        if isinstance(value, (str, os.PathLike)):
            given[name] = value = kind.load(value)
        if isinstance(value, (Drive, Joint)):
            for other, files in value._files("").items():
                given.setdefault(other, files)
    if isinstance(given.get("muscles"), Mapping):
        joint = file(given["joint"])
        names = dict.fromkeys(_native.joint_files(joint["name"], joint["text"]))
        if unknown := [name for name in given["muscles"] if name not in names]:
            raise InputError(f"{joint['name']} names {', '.join(names)}, not {unknown[0]}", kind="usage", field="muscles")
        given["muscles"] = [{**file(of), "name": name} for name, of in given["muscles"].items()]
    if isinstance(given.get("tables"), Mapping):
        given["tables"] = [{**table(of), "name": name} for name, of in given["tables"].items()]
    drive = given.get("drive")
    if isinstance(drive, Drive) and isinstance(given.get("muscle"), Mapping) is False and given.get("muscle") is not None:
        given["muscle"] = {**file(given["muscle"]), "name": drive._subject()}
