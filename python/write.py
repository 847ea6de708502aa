"""Writes what is made of the schema of the program and of the docstrings of the package.

    python python/write.py api [--check]        python/mckibben/_api.py: commands and answers as plain functions and classes
    python python/write.py reference FILE       the reference page, from the docstrings

The schema is that of the program (``MCKIBBEN``, or ``target/debug/mckibben``); docstrings are those of the package that Python finds. ``api`` formats what it writes by ruff.
"""

from __future__ import annotations

import difflib
import inspect
import json
import keyword
import os
import re
import subprocess
import sys
import textwrap
from collections.abc import Iterable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "python" / "mckibben"
Schema = Any

# Commands as functions and as methods of a muscle, a joint and a drive, with what may be given without its keyword.
FUNCTIONS: dict[str, tuple[str, list[str]]] = {
    "design": ("design", []),
    "identify": ("identify", ["muscle", "data"]),
    "rubber": ("fit_rubber", ["data"]),
    "fit": ("fit", ["table"]),
    "parts-list": ("parts", ["kind"]),
    "parts-show": ("part", ["name"]),
    "measures": ("measures", []),
    "plan": ("plan", ["plan"]),
    "check-formula": ("check_formula", ["file"]),
}
METHODS: dict[str, dict[str, tuple[str, list[str]]]] = {
    "MuscleCommands": {
        "curve": ("curve", ["test"]),
        "simulate": ("simulate", ["test"]),
        "shape": ("shape", ["pressure_mpa", "contraction"]),
        "fill": ("fill", ["volume_mm3"]),
        "check": ("check", []),
        "compare": ("compare", []),
        "study": ("study", []),
        "build": ("build", ["pressure_mpa"]),
        "export": ("export", ["target"]),
    },
    "JointCommands": {"joint": ("solve", []), "export-joint": ("export", ["target"])},
    "DriveCommands": {"motion": ("motion", [])},
    "CampaignCommands": {
        "campaign": ("run", []),
        "campaign-status": ("status", []),
        "campaign-show": ("summary", []),
    },
}
# Arguments that such an object has itself.
OWN = {
    "MuscleCommands": {"muscle"},
    "JointCommands": {"joint", "muscles"},
    "DriveCommands": {"drive", "step", "muscle", "joint", "muscles", "tables"},
    "CampaignCommands": {"plan", "output", "campaign"},
}
DEFAULTS = {("curve", "test"): "isobaric", ("simulate", "test"): "isobaric"}
# What must be given.
NEEDED = {
    ("identify", "muscle"),
    ("identify", "data"),
    ("rubber", "data"),
    ("parts-show", "name"),
    ("parts-list", "kind"),
    ("plan", "plan"),
    ("check-formula", "file"),
    ("fill", "volume_mm3"),
}
# Answers with a name of their own, and what they inherit from.
NAMES = {
    "CurveAnswer": "Curve",
    "PlanAnswer": "Plan",
    "FitAnswer": "Fit",
    "IdentifyAnswer": "Identification",
    "RubberFitAnswer": "RubberFit",
    "DesignAnswer": "Design",
    "BuildAnswer": "Build",
    "ExportAnswer": "Export",
    "ExportJointAnswer": "JointExport",
    "ShapeAnswer": "Shape",
    "CheckFormulaAnswer": "FormulaCheck",
    "JointAnswer": "JointSolution",
    "MotionAnswer": "Motion",
    "Summary": "CampaignSummary",
}
BASES = {
    "Curve": "Curves",
    "Fit": "Fitting",
    "Identification": "Identified",
    "RubberFit": "FittedLaws",
    "Design": "Designed",
    "Build": "Files",
    "Export": "Files",
    "JointExport": "Files",
    "Shape": "Shaped",
}
# The list of an answer that is its table, by command.
ROWS = {
    "build": "parts",
    "export": "files",
    "export-joint": "files",
    "simulate": "points",
    "design": "candidates",
    "joint": "points",
    "study": "points",
    "compare": "models",
    "identify": "parameters",
    "rubber": "laws",
    "measures": "measures",
    "motion": "series",
    "parts-list": "tubes sleeves rubbers muscles models",
    "curve": "points",
    "plan": "table",
}
# Types of what may be given, by the names of fields.
GIVEN = {
    "muscle": "MuscleLike",
    "rubber": "RubberLike",
    "models": "FormulaLike | Sequence[FormulaLike]",
    "file": "FormulaLike",
    "terminal": "Mapping[str, Plain]",
    "log": "TableLike",
    "table": "TableLike",
    "campaign": "FileLike",
    **dict.fromkeys(
        ("data", "tables", "load_tables"), "TableLike | Sequence[TableLike]"
    ),
    "stiffness": "Number",
}
MEASURES = "What differs from the muscle, as in :class:`Muscle`."
PROGRESS = "True for a line on standard error, or a function that is called with (done, total)."
RAISES = [
    ("InputError", "", "An argument is wrong: `field` names it."),
    ("NoAnswerError", "", "There is none."),
    ("NotConvergedError", "", "It was not found, or cancelled."),
]
# By function and method.
EXAMPLES = dict(
    part.split("\n\n", 1)
    for part in (PACKAGE.parent / "docstrings.md").read_text("utf-8").split("\n## ")[1:]
)
HEAD = '''"""Commands and answers of the program. Written by python/write.py from the schema; do not edit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Literal, TypedDict

from . import _record
from ._record import Record
from ._request import answered, known, modelled

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from typing_extensions import Unpack

    from ._muscle import Muscle
    from ._request import Choice, FileLike, FormulaLike, MuscleLike, Number, Numbers, Plain, Progress, RubberLike, TableLike
'''


class Bundle:
    """The schemas of all commands."""

    def __init__(self, held: dict[str, Any]) -> None:
        self.held, self.defs = held, held["$defs"]

    def defined(self, schema: Schema) -> Schema:
        """A schema, or the definition to which it refers."""
        name = reference(schema)
        return schema if name is None else self.defs[name]

    def properties(self, schema: Schema) -> dict[str, Schema]:
        """All fields of an object, those of its variants among them."""
        schema = self.defined(schema)
        out = dict(schema.get("properties", {}))
        for option in [*options(schema), *schema.get("allOf", [])]:
            for name, field in self.properties(option).items():
                out.setdefault(name, field)
        return out

    def required(self, schema: Schema) -> set[str]:
        """The fields that an object always has."""
        schema = self.defined(schema)
        of_options = [self.required(option) for option in options(schema)]
        return set(schema.get("required", [])).union(
            set.intersection(*of_options) if of_options else ()
        )

    def request(self, command: str) -> dict[str, Schema]:
        """The arguments of a command: the fields of its request, those of its model one by one."""
        fields = self.properties(self.held[command]["request"])
        if reference(fields.get("model")) == "ModelFields":
            made = self.properties(fields["model"])
            fields |= {"model": made.pop("name"), **made}
        return fields

    def is_record(self, schema: Schema) -> bool:
        return bool(self.properties(schema)) and not words(self.defined(schema))

    def type_of(self, schema: Schema, is_answer: bool) -> str:
        """The type of a schema in the words of Python."""
        if not isinstance(schema, dict) or not schema:
            return "Any"
        if name := reference(schema):
            known = {
                "TextFile": "FileLike",
                "NameOrFile": "FormulaLike",
                "Choice": "Choice",
                "Choice2": "Choice",
                "Stiffness": "Number | str",
            }.get(name)
            if not is_answer and known:
                return known
            target = self.defined(schema)
            if self.is_record(schema):
                return NAMES.get(name, name) if is_answer else "Mapping[str, Plain]"
            return self.type_of(target, is_answer)
        if choice := words(schema):
            return f"Literal[{', '.join(map(json.dumps, choice))}]"
        if alternatives := options(schema):
            return union([self.type_of(option, is_answer) for option in alternatives])
        kind = schema.get("type")
        if isinstance(kind, list):
            return union(
                [self.type_of({**schema, "type": one}, is_answer) for one in kind]
            )
        if kind == "array" and "prefixItems" in schema:
            return f"tuple[{', '.join(self.type_of(item, is_answer) for item in schema['prefixItems'])}]"
        if kind == "array":
            return f"list[{self.type_of(schema.get('items'), is_answer)}]"
        if kind == "object":
            return f"dict[str, {self.type_of(schema.get('additionalProperties') or None, is_answer)}]"
        return {
            "string": "str",
            "number": "float",
            "integer": "int",
            "boolean": "bool",
            "null": "None",
        }.get(str(kind), "Any")

    def muscle(self) -> dict[str, Schema]:
        """The fields of a muscle by which it is made and changed."""
        fields = self.properties({"$ref": "#/$defs/MuscleFields"})
        return {n: f for n, f in fields.items() if n not in ("file", "tube", "with")}


def reference(schema: Schema) -> str | None:
    return (
        schema["$ref"].rsplit("/", 1)[-1]
        if isinstance(schema, dict) and "$ref" in schema
        else None
    )


def options(schema: Schema) -> list[Schema]:
    return (
        [*schema.get("anyOf", []), *schema.get("oneOf", [])]
        if isinstance(schema, dict)
        else []
    )


def words(schema: Schema) -> list[str]:
    """The words of a schema that is a choice of words, else none."""
    if all(isinstance(word, str) for word in schema.get("enum", [None])):
        return list(schema["enum"])
    out: list[str] = []
    for option in options(schema):
        found = (
            [option["const"]]
            if "const" in option
            else option.get("enum")
            if option.get("type") == "string"
            else None
        )
        if found is None:
            return []
        out += found
    return out


def union(kinds: list[str]) -> str:
    """One of several types; None is the last."""
    parts = dict.fromkeys(kinds)
    return "Any" if "Any" in parts else " | ".join(sorted(parts, key="None".__eq__))


def doc(schema: Schema) -> str:
    """The description, as Python has it: Rustdoc's brackets around references and its examples are left out."""
    text = schema.get("description", "") if isinstance(schema, dict) else ""
    text = re.sub(r"```.*?```", "", text, flags=re.DOTALL).strip()
    text = re.sub(r"\\\[([a-z0-9]+)\\\]", r"[\1]", text)
    text = re.sub(r"\[(`[^`]*`)\](\([^)]*\))?", r"\1", text).replace("\\", "\\\\")
    # A short help text has no full stop.
    text = re.sub(r"(?<![.:;,…])(?<!\.\))(\n\n|$)", r".\1", text) if text else ""
    return " ".join(text.split())


def named(name: str) -> str:
    return name + "_" if keyword.iskeyword(name) else name


def documented(parts: list[str], indent: str) -> str:
    """A docstring of paragraphs."""
    text = "\n\n".join(part for part in parts if part)
    return textwrap.indent(
        f'"""{text}\n"""' if "\n" in text else f'"""{text}"""', indent
    )


def wrapped(text: str, indent: str = "") -> str:
    return textwrap.fill(
        text,
        150,
        initial_indent=indent,
        subsequent_indent=indent,
        break_long_words=False,
    )


def section(title: str, entries: list[tuple[str, str, str]]) -> str:
    """A part of a docstring: names with their units, and what they are."""
    lines = [
        name
        + (f" : {unit}" if unit else "")
        + "\n"
        + wrapped(text or "See the documentation.", "    ")
        for name, unit, text in entries
    ]
    return "\n".join([title, "-" * len(title), *lines]) if lines else ""


def described(
    about: str,
    parameters: list[tuple[str, str, str]],
    returns: tuple[str, str, str],
    example: str,
) -> list[str]:
    """The docstring of a function."""
    return [
        about,
        section("Parameters", parameters),
        section("Returns", [returns]),
        section("Raises", RAISES),
        f"Examples\n--------\n>>> import mckibben as mk\n{example.strip()}",
    ]


def class_of(head: str, about: list[str], parts: Iterable[str]) -> str:
    return "\n".join([f"class {head}:", documented(about, "    "), *parts])


def entries_of(fields: dict[str, Schema]) -> list[tuple[str, str, str]]:
    return [
        (
            named(name),
            field.get("x-unit", "") if isinstance(field, dict) else "",
            doc(field),
        )
        for name, field in fields.items()
    ]


def parameter(
    bundle: Bundle, command: str, name: str, schema: Schema
) -> tuple[str, str | None]:
    """The annotated parameter of a field, and its default; None where it must be given."""
    kind = bundle.type_of(schema, False)
    if name in GIVEN and kind not in ("bool", "int"):
        kind = GIVEN[name]
    kind = re.sub(r"^list\[list\[.*?\]\]", "Sequence[Numbers]", kind)
    kind = (
        re.sub(r"^list\[float\]", "Numbers", kind)
        .replace("list[", "Sequence[")
        .replace("dict[", "Mapping[")
    )
    kind = re.sub(r"\bfloat\b", "Number", kind).removesuffix(" | None")
    default = DEFAULTS.get((command, name))
    if default is not None:
        return f"{named(name)}: {kind}", json.dumps(default)
    if (command, name) in NEEDED:
        return f"{named(name)}: {kind}", None
    if kind == "bool":
        return f"{named(name)}: bool", repr(schema.get("default") is True)
    return f"{named(name)}: {kind} | None", "None"


def signature(
    me: list[str],
    parameters: list[tuple[str, str | None]],
    keywords: list[tuple[str, str | None]],
) -> str:
    def one(p: tuple[str, str | None]) -> str:
        return p[0] if p[1] is None else f"{p[0]} = {p[1]}"

    return ", ".join(
        [
            *me,
            *map(one, parameters),
            *(["*", *map(one, keywords)] if keywords else []),
        ]
    )


def function(
    bundle: Bundle, command: str, name: str, first: list[str], owner: str | None
) -> str:
    held = bundle.held[command]
    title = held["answer"]["title"]
    answer = NAMES.get(title, title)
    fields = bundle.request(command)
    left_out = {"figure"} | (OWN[owner] if owner else set())
    fields = {
        n: fields[n]
        for n in [*first, *(n for n in fields if n not in first)]
        if n not in left_out
    }
    made = {n: parameter(bundle, command, n, field) for n, field in fields.items()}
    keywords = [made[n] for n in fields if n not in first]
    listed = entries_of(fields)
    if held["long"] or command == "curve":
        keywords.append(("progress: Progress", "None"))
        listed.append(("progress", "", PROGRESS))
    given = "locals()"
    if reference(fields.get("muscle")) == "MuscleFields":
        keywords.append(("**measures: Unpack[Measures]", None))
        listed.append(("measures", "", MEASURES))
        given = '{**locals(), "muscle": {"file": muscle, **known(measures, Measures)}, "measures": None}'
    if reference(bundle.properties(held["request"]).get("model")) == "ModelFields":
        given = f"modelled({given})"
    indent = "    " if owner else ""
    figure = bundle.request(command).get("figure")
    # A curve is drawn when it is wanted.
    drawn = (
        ""
        if figure is None or command == "curve"
        else ", True"
        if figure.get("type") == "boolean"
        else ', "MPa"'
    )
    about = described(
        wrapped(doc(held["request"]) or f"The command `{command}`."),
        listed,
        (answer, "", doc(held["answer"]) or "The answer."),
        EXAMPLES[".".join(filter(None, [owner, name]))],
    )
    me = ["self"] if owner else []
    return f'{indent}def {name}({signature(me, [made[n] for n in first], keywords)}) -> {answer}:\n{documented(about, indent + "    ")}\n{indent}    return answered({answer}, "{command}", {given}{drawn})'


def fields_class(bundle: Bundle) -> str:
    """What makes a muscle of its fields, and the fields as attributes."""
    fields = bundle.muscle()
    always = ("outer_diameter_mm", "wall_mm", "length_mm")
    made = {n: parameter(bundle, "check", n, field) for n, field in fields.items()}
    needed = {n: (made[n][0].removesuffix(" | None"), None) for n in always}
    entries = [
        (n, unit, text + (" Or a :class:`Rubber`." if n == "rubber" else ""))
        for n, unit, text in entries_of(fields)
    ]
    raises = section(
        "Raises",
        [
            (
                "InputError",
                "",
                "There is no such muscle; `field` is the argument to blame.",
            )
        ],
    )
    me, out = ["self: Any"], []
    out.append(
        f'    def __init__({signature(me, [], list((made | needed).values()))}) -> None:\n{documented([section("Parameters", entries), raises], "        ")}\n        self._make({{name: value for name, value in locals().items() if name != "self"}})\n'
    )
    for name, field in fields.items():
        if name not in ("rubber", "braid"):
            kind = "float | str" if name == "stiffness" else "float"
            kind = kind if name in (*always, "angle_deg") else f"{kind} | None"
            out.append(
                f'    @property\n    def {name}(self: Any) -> {kind}:\n{documented([wrapped(doc(field))], "        ")}\n        found: {kind} = self._field("{name}")\n        return found\n'
            )
    about = "What makes a muscle, and its measures; None where it does not have one."
    return class_of("MuscleFields", [about], out)


def record(bundle: Bundle, name: str, schema: Schema, rows: str | None) -> str:
    fields, always = bundle.properties(schema), bundle.required(schema)
    base = f"_record.{BASES[name]}" if name in BASES else "Record"
    about = [wrapped(doc(schema) or name), section("Attributes", entries_of(fields))]
    lines = [f"    _rows: ClassVar[str | None] = {json.dumps(rows)}"] if rows else []
    # Those that are always there first, as in any dataclass.
    for field, value in sorted(fields.items(), key=lambda f: f[0] not in always):
        kind = bundle.type_of(value, True)
        optional = field not in always
        kind = (
            f"{kind} | None"
            if optional and not kind.endswith("None") and kind != "Any"
            else kind
        )
        lines.append(f"    {named(field)}: {kind}" + (" = None" if optional else ""))
    return class_of(f"{name}({base})", about, lines)


def solution(bundle: Bundle) -> str:
    """What is known of points, each as an array."""
    fields = {
        n: f
        for n, f in bundle.properties({"$ref": "#/$defs/Answer"}).items()
        if bundle.type_of(f, True) in ("float", "float | None")
    }
    what = (
        "Points of a muscle as arrays of one shape; NaN where a point does not have it."
    )
    lines = (f"    {n}: NDArray[np.float64]" for n in fields)
    about = [what, section("Attributes", entries_of(fields))]
    return class_of("Solution(_record.Points)", about, lines)


def state(bundle: Bundle) -> str:
    """Where a simulation is."""
    fields = bundle.properties({"$ref": "#/$defs/MotionSeries"})
    about = [
        "Where a simulation is; None what it is not.",
        section("Attributes", entries_of(fields)),
    ]
    # Of a muscle or of a joint: whoever asks knows which it is, and needs no look at None.
    return class_of("State(Record)", about, (f"    {n}: float" for n in fields))


def keywords(
    bundle: Bundle, name: str, about: list[str], fields: dict[str, Schema]
) -> str:
    """Fields as keywords of one type."""
    lines = (f"    {parameter(bundle, 'force', n, f)[0]}" for n, f in fields.items())
    return class_of(f"{name}(TypedDict, total=False)", about, lines)


def answers(bundle: Bundle) -> dict[str, tuple[Schema, str | None]]:
    """All records, by name: those of commands, and those to which they refer."""
    asked = dict.fromkeys(
        [*(c for names in METHODS.values() for c in names), *FUNCTIONS]
    )
    out: dict[str, tuple[Schema, str | None]] = {}

    def reach(schema: Any) -> None:
        parts: Any = (
            schema.values()
            if isinstance(schema, dict)
            else schema
            if isinstance(schema, list)
            else ()
        )
        for part in parts:
            reach(part)
        name = reference(schema)
        if (
            name is not None
            and NAMES.get(name, name) not in out
            and bundle.is_record(schema)
        ):
            out[NAMES.get(name, name)] = bundle.defs[name], None
            reach(bundle.defs[name])

    for command in asked:
        schema = bundle.held[command]["answer"]
        reach(schema)
        out[NAMES.get(schema["title"], schema["title"])] = schema, ROWS.get(command)
    return dict(sorted(out.items()))


def api(bundle: Bundle) -> str:
    made = answers(bundle)
    keys = {n: f["x-key"] for n, f in bundle.muscle().items() if "x-key" in f}
    parts = [
        HEAD,
        f"__all__ = {json.dumps([*made, 'Solution', 'State'])}\n# Keys of the muscle file, by field.\nKEYS = {json.dumps(keys)}",
    ]
    parts += [record(bundle, name, *held) for name, held in made.items()]
    own = ("pressure_mpa", "contraction", "both", "muscle")
    how = {n: f for n, f in bundle.request("force").items() if n not in own}
    about = "Which model of a muscle answers, and how."
    listed = section("Attributes", entries_of(how))
    parts += [
        keywords(bundle, "Options", [about, listed], how),
        'class Asking(Options, total=False):\n    """How a muscle is asked for numbers."""\n    errors: Literal["raise", "nan"]\n    progress: Progress',
        keywords(bundle, "Measures", [MEASURES], bundle.muscle()),
    ]
    parts += [solution(bundle), state(bundle), fields_class(bundle).rstrip()]
    for owner, methods in METHODS.items():
        what = ["What the program answers of it, by command."]
        made_of = (function(bundle, c, *of, owner) for c, of in methods.items())
        parts.append(class_of(owner, what, made_of))
    parts += [function(bundle, c, *of, None) for c, of in FUNCTIONS.items()]
    return formatted("\n\n\n".join(parts) + "\n")


def formatted(code: str) -> str:
    """Code as ruff formats all of Python."""
    command = [sys.executable, "-m", "ruff", "format", "--isolated", "-"]
    return subprocess.run(
        command, input=code, capture_output=True, text=True, check=True
    ).stdout


def program(*words: str) -> Schema:
    """A schema of the program."""
    tool = os.environ.get("MCKIBBEN") or str(ROOT / "target/debug/mckibben")
    return json.loads(
        subprocess.run(
            [tool, "schema", *words], capture_output=True, text=True, check=True
        ).stdout
    )


def reference_page() -> str:
    """All that is public, each with its docstring as Python shows it."""
    import mckibben
    from mckibben import _api

    public = vars(mckibben) | {name: getattr(_api, name) for name in _api.__all__}
    out = ["# Python reference"]
    for name, made in sorted(public.items()):
        is_part = lambda value: inspect.isfunction(value) or isinstance(value, property)
        parts = [("", made), *inspect.getmembers(made, is_part)]
        for part, value in parts if name[0] != "_" and callable(made) else []:
            if part[:1] != "_":
                title = f"## `{name}`" if value is made else f"### `{name}.{part}`"
                out += [title, f"```text\n{inspect.getdoc(value)}\n```"]
    return "\n\n".join(out) + "\n"


def main(what: str, place: str = str(PACKAGE / "_api.py")) -> None:
    if what == "reference":
        Path(place).write_text(reference_page(), "utf-8")
        return
    text, held = api(Bundle(program())), (PACKAGE / "_api.py").read_text("utf-8")
    if place != "--check":
        Path(place).write_text(text, "utf-8")
    elif text != held:
        lines = difflib.unified_diff(
            held.splitlines(True), text.splitlines(True), "kept", "made"
        )
        sys.exit("".join([*lines][:40]) + "python python/write.py api writes it anew")


if __name__ == "__main__":
    main(*sys.argv[1:])
