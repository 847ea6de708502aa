"""What commands answer: a class for each record of the schema, made when it is used first."""

from __future__ import annotations

from functools import partial
from typing import Any

from . import _schema
from ._record import Record

# Classes around those of the schema, by their names.
OWN: dict[str, type[Record]] = {}
# The list of an answer that is its table, by command.
ROWS = {
    "build": "parts", "export": "files", "export-list": "targets",
    "simulate": "points", "design": "candidates", "joint": "points", "study": "points", "validate": "cases", "measured": "results", "compare": "models",
    "identify": "parameters", "rubber": "laws", "measures": "measures",
    "motion": "series", "fit-report": "findings", "units": "kinds", "parts-list": "tubes",
}


def _answers() -> dict[str, tuple[str, _schema.Schema]]:
    """Commands and their answers, by the name of the answer."""
    bundle = _schema.bundle()
    return {bundle[command]["answer"]["title"]: (command, bundle[command]["answer"]) for command in _schema.commands()}


def _record(name: str, schema: _schema.Schema, rows: str | None) -> type[Record]:
    fields, always = _schema.properties(schema), _schema.required(schema)
    if taken := {"keys", "plot", "to_dict", "to_pandas", "to_table"} & set(fields):
        raise TypeError(f"{name}: {taken} are methods of every answer")
    kinds = {field: _schema.answer_type(value) for field, value in fields.items()}
    for field, kind in kinds.items():
        if field not in always and "None" not in kind and kind != "Any":
            kinds[field] = f"{kind} | None"
    return type(name, (Record,), {
        "__slots__": (),
        "__module__": __name__,
        "__doc__": "\n\n".join([_schema.wrapped(_schema.doc(schema) or name), *_schema.entries("Attributes", fields)]),
        "__annotations__": kinds,
        "_fields_": tuple(fields),
        "_nested_": {field: partial(_kind, found) for field, value in fields.items() if (found := _schema.record_of(value))},
        "_rows_": rows,
    })


def _kind(name: str) -> type[Record]:
    """A record of the schema by its name."""
    made: type[Record] = globals().get(name) or __getattr__(name)
    return made


def kind(name: str) -> type[Record]:
    """The class of an answer by its name."""
    return OWN.get(name) or _kind(name)


def _all() -> list[str]:
    """All records, those first to which others refer."""
    seen: dict[str, None] = {}

    def reach(schema: Any) -> None:
        if isinstance(schema, dict):
            name = _schema.reference(schema)
            if name is not None and name not in seen:
                seen[name] = None
                reach(_schema.defined(schema))
            for part in schema.values():
                reach(part)
        elif isinstance(schema, list):
            for part in schema:
                reach(part)

    answers = _answers()
    for _, schema in answers.values():
        reach(schema)
    return [*sorted(name for name in seen if name not in answers and _schema.is_record(_schema.bundle()["$defs"][name])), *sorted(answers)]


def __getattr__(name: str) -> Any:
    if name == "__all__":
        return _all()
    if name.startswith("_"):
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    command, schema = _answers().get(name, ("", _schema.bundle()["$defs"].get(name, {})))
    if not _schema.is_record(schema):
        raise AttributeError(f"no answer holds a {name}")
    # One class, also where several threads want it first.
    return globals().setdefault(name, _record(name, schema, ROWS.get(command)))
