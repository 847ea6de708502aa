"""Writes what is made of the schema of the program and of the docstrings of the package.

    python python/write.py api [--check]        python/mckibben/_api.py: commands and answers as plain functions and classes
    python python/write.py reference FILE       the reference page, from the docstrings

The schema is that of the program (``MCKIBBEN``, or ``target/debug/mckibben``); docstrings are those of the package that Python finds. ``api`` formats what it writes by ruff.
"""

from __future__ import annotations

import inspect
import json
import keyword
import os
import re
import subprocess
import sys
import textwrap
from collections.abc import Iterable
from functools import cache
from itertools import chain
from pathlib import Path
from types import FunctionType
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
API = ROOT / "python/mckibben/_api.py"
Schema = Any
Fields = dict[str, Schema]

# Commands as functions, and as methods of a muscle, a joint and a drive, with what may be given without its keyword: with `!` what must be, with `=` what
# it is else.
COMMANDS = {
    "MuscleCommands": {
        "curve": "test=isobaric",
        "simulate": "test=isobaric",
        "shape": "pressure_mpa contraction",
        "fill": "volume_mm3!",
        "check": "",
        "compare": "",
        "study": "",
        "build": "pressure_mpa",
        "export": "target",
    },
    "JointCommands": {"joint": "", "export-joint": "target"},
    "DriveCommands": {"motion": ""},
    "CampaignCommands": {"campaign": "", "campaign-show": ""},
    "": {
        "design": "",
        "identify": "muscle! data!",
        "rubber": "data!",
        "fit": "table",
        "parts-list": "kind!",
        "parts-show": "name!",
        "measures": "",
        "check-formula": "file!",
    },
}
# Those with another name.
CALLED = {
    "joint": "solve",
    "export-joint": "export",
    "campaign": "_run",
    "campaign-show": "summary",
    "rubber": "fit_rubber",
    "parts-list": "parts",
    "parts-show": "part",
    "check-formula": "check_formula",
}
# Arguments that such an object has itself.
OWN = {
    "MuscleCommands": "muscle",
    "JointCommands": "joint muscles",
    "DriveCommands": "drive step muscle joint muscles tables",
    "CampaignCommands": "plan output campaign",
}
# Answers with a name of their own; others lose their last word where the package has a class of that name.
NAMES = {
    "IdentifyAnswer": "Identification",
    "ExportJointAnswer": "JointExport",
    "CheckFormulaAnswer": "FormulaCheck",
    "JointAnswer": "JointSolution",
    "MotionAnswer": "Motion",
    "Summary": "CampaignSummary",
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
}
# Types of columns, by those of a row's field, or of a list by its name.
COLUMNS = {
    **dict.fromkeys(
        ("float", "float | None", "list[float]", "list[float] | None"), "Array"
    ),
    "str": "list[str]",
}
# Types of what may be given, by the names of fields and of definitions.
GIVEN = {
    "TextFile": "FileLike",
    "NameOrFile": "FormulaLike",
    "Choice": "Choice",
    "Choice2": "Choice",
    "muscle": "MuscleLike",
    "rubber": "RubberLike",
    "models": "FormulaLike | Sequence[FormulaLike]",
    "file": "FormulaLike",
    "log": "TableLike",
    "table": "TableLike",
    "campaign": "FileLike",
    "progress": "Progress",
    **dict.fromkeys(("data", "load_tables"), "TableLike | Sequence[TableLike]"),
    "stiffness": "Number",
}
# What a muscle is asked for: the name of the answer, and those of both numbers of the question.
ASKED = {
    "force": ("force_n", "pressure_mpa", "contraction"),
    "pressure": ("pressure_mpa", "force_n", "contraction"),
    "contraction": ("contraction", "force_n", "pressure_mpa"),
}
# By function and method, and others.
TEXTS = dict(
    part.strip().split("\n\n", 1)
    for part in (ROOT / "python/docstrings.md").read_text("utf-8").split("\n## ")[1:]
)
# Classes that say what an answer can do besides.
RECORDS = re.findall(
    r"\nclass (\w+)", (ROOT / "python/mckibben/_record.py").read_text("utf-8")
)
HEAD = '''"""Commands and answers of the program. Written by python/write.py from the schema; do not edit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, TypedDict, overload

from . import _record
from ._record import Record
from ._request import answered

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._muscle import Muscle
    from ._request import *
'''


@cache
def schemas() -> Schema:
    """The schemas of all commands."""
    tool = os.environ.get("MCKIBBEN") or str(ROOT / "target/debug/mckibben")
    return json.loads(said(tool, "schema"))


def defined(schema: Schema) -> Schema:
    """A schema, or the definition to which it refers."""
    name = reference(schema)
    return schemas()["$defs"][name] if name else schema


def properties(schema: Schema) -> Fields:
    """All fields of an object, those of its variants among them."""
    schema = defined(schema)
    out = dict(schema.get("properties", {}))
    for option in options(schema):
        for name, field in properties(option).items():
            out.setdefault(name, field)
    return out


def required(schema: Schema) -> set[str]:
    """The fields that an object always has."""
    schema = defined(schema)
    of_options = [required(option) for option in options(schema)]
    return set(schema.get("required", [])).union(
        set.intersection(*of_options) if of_options else ()
    )


def request(command: str) -> Fields:
    """The arguments of a command: the fields of its request, those of its model one by one."""
    fields = properties(schemas()[command]["request"])
    # One word for the branch of the hysteresis.
    fields.pop("both", None)
    named = {"direction": "branch", "branches": "branch"}
    fields = {named.get(n, n): field for n, field in fields.items()}
    if command == "curve":
        fields["branch"]["anyOf"].append({"enum": ["both"]})
    if reference(fields.get("model")) == "ModelFields":
        made = properties(fields["model"])
        fields |= {"model": made.pop("name"), **made}
    return fields


def type_of(schema: Schema, is_answer: bool) -> str:
    """The type of a schema in the words of Python."""
    if not isinstance(schema, dict) or not schema:
        return "Any"
    if name := reference(schema):
        if not is_answer and name in GIVEN:
            return GIVEN[name]
        if properties(schema):
            return titled(name) if is_answer else "Mapping[str, Plain]"
        return type_of(defined(schema), is_answer)
    if words := schema.get("enum", [schema["const"]] if "const" in schema else []):
        return f"Literal[{', '.join(map(json.dumps, words))}]"
    if alternatives := options(schema):
        kinds = dict.fromkeys(type_of(option, is_answer) for option in alternatives)
        union = " | ".join(sorted(kinds, key="None".__eq__))
        return union.replace("] | Literal[", ", ")
    many, table, number = (
        ("list", "dict", "float") if is_answer else ("Sequence", "Mapping", "Number")
    )
    kind = schema.get("type")
    if kind == "array" and "prefixItems" in schema:
        return f"tuple[{', '.join(type_of(item, is_answer) for item in schema['prefixItems'])}]"
    if kind == "array":
        return f"{many}[{type_of(schema.get('items'), is_answer)}]"
    if kind == "object":
        return f"{table}[str, {type_of(schema.get('additionalProperties'), is_answer)}]"
    return {
        "string": "str",
        "number": number,
        "integer": "int",
        "boolean": "bool",
        "null": "None",
    }.get(str(kind), "Any")


def muscle() -> Fields:
    """The fields of a muscle by which it is made and changed."""
    fields = properties(schemas()["$defs"]["MuscleFields"])
    return {n: f for n, f in fields.items() if n not in ("file", "tube", "with")}


def reference(schema: Schema) -> str:
    """The name of the definition to which a schema refers, if to one."""
    return str((schema or {}).get("$ref", "")).rsplit("/", 1)[-1]


def options(schema: Schema) -> list[Schema]:
    """What a schema leaves to choose from."""
    kinds = schema.get("type")
    of_kinds = (
        [{**schema, "type": one} for one in kinds] if isinstance(kinds, list) else []
    )
    return [*schema.get("anyOf", []), *schema.get("oneOf", []), *of_kinds]


def doc(schema: Schema) -> str:
    """The description, as Python has it: Rustdoc's brackets around references and its examples are left out."""
    text = schema.get("description", "")
    text = re.sub(r"```.*?```", "", text, flags=re.DOTALL).strip()
    text = re.sub(r"\\\[([a-z0-9]+)\\\]", r"[\1]", text)
    text = re.sub(r"\[(`[^`]*`)\](\([^)]*\))?", r"\1", text)
    # A short help text has no full stop.
    text = re.sub(r"(?<![.:;,…])(?<!\.\))(\n\n|$)", r".\1", text) if text else ""
    return textwrap.fill(" ".join(text.split()), 150)


def titled(name: str) -> str:
    """The class of a definition."""
    short = name.removesuffix("Answer")
    return NAMES.get(name, short if short in RECORDS else name)


def named(name: str) -> str:
    return name + "_" if keyword.iskeyword(name) else name


def block(head: str, about: list[str], *lines: str) -> str:
    """A function or class with a docstring of paragraphs."""
    text = "\n\n".join(filter(None, about))
    end = "\n" if "\n" in text else ""
    held = "\n".join([f'"""{text}{end}"""', *lines])
    return f"{head}:\n{textwrap.indent(held, '    ')}"


def section(title: str, fields: Fields) -> str:
    """A part of a docstring: names with their units, and what they are."""
    lines = [title, "-" * len(title)]
    for name, field in fields.items():
        unit = f" : {field['x-unit']}" if field.get("x-unit") else ""
        text = textwrap.fill(doc(field) or "See the documentation.", 146)
        lines += [named(name) + unit, textwrap.indent(text, "    ")]
    return "\n".join(lines) if fields else ""


def class_of(head: str, about: str, parts: Iterable[str], fields: Fields = {}) -> str:
    """A class with what its fields are."""
    return block(f"class {head}", [about, section("Attributes", fields)], *parts)


def parameter(name: str, schema: Schema, how: str = "") -> str:
    """The annotated parameter of a field with its default, but where it must be given."""
    kind = GIVEN.get(name, type_of(schema, False))
    kind = kind.replace("Sequence[Number]", "Numbers").removesuffix(" | None")
    if how:
        default = "" if how == "!" else f" = {json.dumps(how[1:])}"
    elif kind == "bool":
        default = " = False"
    else:
        default = " | None = None"
    return f"{named(name)}: {kind}{default}"


def function(command: str, owner: str) -> str:
    held, name = schemas()[command], CALLED.get(command, command)
    first = dict(re.findall(r"(\w+)(\S*)", COMMANDS[owner][command]))
    answer = titled(held["answer"]["title"])
    fields = request(command)
    if held["long"] or command == "curve":
        fields["progress"] = {"description": TEXTS["Progress"]}
    own = {"figure", *OWN.get(owner, "").split()}
    fields = {n: fields[n] for n in {**first, **fields} if n not in own}
    made = [parameter(n, field, first.get(n, "")) for n, field in fields.items()]
    if len(made) > len(first):
        made.insert(len(first), "*")
    if reference(fields.get("muscle")) == "MuscleFields":
        made.append("**measures: Unpack[Measures]")
        fields["measures"] = {"description": TEXTS["Measures"]}
    example = TEXTS[f"{owner}.{name}".strip(".")]
    about = [
        doc(held["request"]),
        section("Parameters", fields),
        section("Returns", {answer: held["answer"]}),
        TEXTS["Raises"],
        f"Examples\n--------\n>>> import mckibben as mk\n{example}",
    ]
    if owner:
        made.insert(0, "self")
    return block(
        f"def {name}({', '.join(made)}) -> {answer}",
        about,
        f'return answered({answer}, "{command}", locals())',
    )


def asked(name: str) -> str:
    """A number of a muscle, as a method for numbers and arrays, with and without derivatives."""
    _, first, second = ASKED[name]
    about, slopes, example = TEXTS[f"MuscleNumbers.{name}"].split("\n\n", 2)
    text = TEXTS["MuscleNumbers"].format(**locals())

    def head(kind: str, jac: str, options: str, answer: str) -> str:
        rest = " = 0.0" if second == "contraction" else ""
        return f"def {name}(self: Any, {first}: {kind}, {second}: {kind}{rest}, *, jac: {jac}, **options: {options}) -> {answer}"

    overloads = [
        head(kind, jac, "Unpack[Asking]", answer.format(pull))
        for jac, answer in (
            ("Literal[False] = False", "{}"),
            ("Literal[True] | Sequence[str]", "tuple[{}, Array]"),
        )
        for kind, pull in (("Number", "float"), ("Floats", "Array"))
    ]
    return "\n".join(
        [
            *(f"@overload\n{overload}: ..." for overload in overloads),
            block(
                head("Any", "bool | Sequence[str] = False", "Any", "Any"),
                [text],
                f'return self._asked("{name}", {first}, {second}, jac, options)',
            ),
        ]
    )


def columns(table: Schema) -> str:
    """The columns of a table, for those who check types."""
    by_type: dict[str, list[str]] = {}
    rows = defined(table)
    for name, field in properties(rows.get("items", rows)).items():
        kind = re.sub(r"Literal\[.*?\]", "str", type_of(field, True))
        if kind in COLUMNS:
            by_type.setdefault(COLUMNS[kind], []).append(name)
    heads = [
        f"def __getitem__(self, name: Literal{json.dumps(names)}, /) -> {kind}: ..."
        for kind, names in by_type.items()
    ]
    rest = "def __getitem__(self, name: str, /) -> Any: ..."
    lines = "\n@overload\n".join(["", *heads, rest])
    return "if TYPE_CHECKING:" + textwrap.indent(f"{lines}\n{rest}", "    ")


def fields_class() -> str:
    """What makes a muscle of its fields, and the fields as attributes."""
    fields = muscle()
    always = ("outer_diameter_mm", "wall_mm", "length_mm")
    made = [parameter(n, f, "!" if n in always else "") for n, f in fields.items()]
    out = [
        block(
            f"def __init__({', '.join(['self: Any', '*', *made])}) -> None",
            [section("Parameters", fields), TEXTS["MuscleFields"]],
            "self._make(locals())",
        )
    ]
    for name, field in fields.items():
        if name not in ("rubber", "braid"):
            kind = "float | str" if name == "stiffness" else "float"
            kind = kind if name in (*always, "angle_deg") else f"{kind} | None"
            out.append(
                block(
                    f"@property\ndef {name}(self: Any) -> {kind}",
                    [doc(field)],
                    f'found: {kind} = self._field("{name}")\nreturn found',
                )
            )
    return class_of("MuscleFields", TEXTS["Fields"], out)


def record(name: str, schema: Schema, rows: str | None) -> str:
    fields, always = properties(schema), required(schema)
    base = f"_record.{name}" if name in RECORDS else "Record"
    lines = [f"_rows = {json.dumps(rows)}"] if rows else []
    # Those that are always there first, as in any dataclass.
    for field in sorted(fields, key=lambda name: name not in always):
        kind = type_of(fields[field], True)
        if field not in always:
            kind = kind.removesuffix(" | None") + " | None = None"
        lines.append(f"{field}: {kind}")
    if rows:
        lines.append(columns(fields[rows.split()[0]]))
    return class_of(f"{name}({base})", doc(schema) or name, lines, fields)


def numbers(head: str, about: str, kind: str, of: str) -> str:
    """The numbers of a definition, all of one type."""
    fields = properties(schemas()["$defs"][of])
    held = {n: f for n, f in fields.items() if "float" in type_of(f, True)}
    return class_of(head, about, (f"{n}: {kind}" for n in held), held)


def keywords(name: str, about: str, fields: Fields) -> str:
    """Fields as keywords of one type."""
    made = (parameter(n, f).split(" = ")[0] for n, f in fields.items())
    return class_of(f"{name}(TypedDict, total=False)", about, made, fields)


def answers() -> Fields:
    """All records, by name, each as its schema and its table: those of commands, and those to which they refer."""
    out: Fields = {}

    def reach(schema: Schema) -> None:
        for name in re.findall(r"#/\$defs/(\w+)", json.dumps(schema)):
            held, called = schemas()["$defs"][name], titled(name)
            if called not in out and properties(held):
                out[called] = held, None
                reach(held)

    for command in chain(*COMMANDS.values()):
        schema = schemas()[command]["answer"]
        reach(schema)
        out[titled(schema["title"])] = schema, ROWS.get(command)
    return dict(sorted(out.items()))


def api() -> str:
    made = answers()
    keys = {n: f["x-key"] for n, f in muscle().items() if "x-key" in f}
    own = ("pressure_mpa", "contraction", "muscle")
    how = {n: f for n, f in request("force").items() if n not in own}
    parts = [
        HEAD,
        f"__all__ = {json.dumps([*made, 'Solution', 'State'])}\n# Keys of the muscle file, by field.\nKEYS = {json.dumps(keys)}\n# Numbers of a muscle, and of which pair.\nNUMBERS = {ASKED!r}",
        *(record(name, *held) for name, held in made.items()),
        keywords("Options", TEXTS["Options"], how),
        'class Asking(Options, total=False):\n    """How a muscle is asked for numbers."""\n    errors: Literal["raise", "nan"]\n    progress: Progress',
        keywords("Measures", TEXTS["Measures"], muscle()),
        numbers("Solution(_record.Solution)", TEXTS["Solution"], "Array", "Answer"),
        # Of a muscle or of a joint: whoever asks knows which it is, and needs no look at None.
        numbers("State(Record)", TEXTS["State"], "float", "MotionSeries"),
        fields_class(),
        class_of("MuscleNumbers", TEXTS["Numbers"], map(asked, ASKED)),
    ]
    for owner, commands in COMMANDS.items():
        made_of = [function(command, owner) for command in commands]
        parts += [class_of(owner, TEXTS["Commands"], made_of)] if owner else made_of
    formatter = sys.executable, "-m", "ruff", "format", "--isolated", "-"
    return said(*formatter, given="\n\n\n".join(parts) + "\n")


def said(*command: str, given: str = "") -> str:
    """What a program says."""
    return subprocess.run(
        command, input=given, capture_output=True, text=True, check=True
    ).stdout


def reference_page() -> str:
    """All that is public, each with its docstring as Python shows it."""
    import mckibben

    out = ["# Python reference"]

    def put(title: str, value: Any) -> None:
        out.extend([title, f"```text\n{inspect.getdoc(value)}\n```"])

    for name, made in sorted((vars(mckibben) | vars(mckibben.answers)).items()):
        if callable(made):
            put(f"## `{name}`", made)
            for part, value in inspect.getmembers(made):
                if part[0] != "_" and isinstance(value, (FunctionType, property)):
                    put(f"### `{name}.{part}`", value)
    return "\n\n".join(out) + "\n"


def main(what: str, place: str = str(API)) -> None:
    text = reference_page() if what == "reference" else api()
    if place != "--check":
        Path(place).write_text(text, "utf-8")
    elif text != API.read_text("utf-8"):
        sys.exit("python python/write.py api writes it anew")


if __name__ == "__main__":
    main(*sys.argv[1:])
