"""Writes the Python types and functions of every command from docs/schema, and the reference page from their docstrings.

    python python/generate.py            writes them
    python python/generate.py --check    fails where a file is not what would be written

What a request and an answer are is declared once, in crates/mckibben-app; docs/schema holds it as JSON Schema.
"""

from __future__ import annotations

import json
import keyword
import re
import sys
import textwrap
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "python" / "mckibben"
HEAD = '"""{}\n\nWritten by python/generate.py from docs/schema; do not edit.\n"""\n'

# Commands that are no function of the package: they serve pages and the command line.
LEFT_OUT = {"quantities", "report", "campaign-show", "campaign-merge", "campaign"}
# What may be given without its keyword, in this order.
POSITIONAL: dict[str, list[str]] = {
    "force": ["muscle", "pressure_mpa", "contraction"],
    "pressure": ["muscle", "force_n", "contraction"],
    "contraction": ["muscle", "force_n", "pressure_mpa"],
    "curve": ["muscle", "test"],
    "simulate": ["muscle", "test"],
    "shape": ["muscle", "pressure_mpa", "contraction"],
    "joint": ["joint"],
    "motion": ["drive"],
    "fit": ["table"],
    "plan": ["plan"],
    "rubber-fit": ["data"],
    "rubber-show": ["name"],
    "braid-show": ["name"],
    "models": ["model"],
    "formula-show": ["file"],
    "identify": ["muscle", "data"],
    "sweep": ["muscles"],
}
DEFAULTS = {("curve", "test"): '"isobaric"', ("simulate", "test"): '"isobaric"', ("sweep", "muscles"): "100"}
# The answers that have a class of their own around what is generated, by command.
OWN_CLASS = {"curve": "Curve", "plan": "Plan", "design": "Design", "fit": "Fitted", "shape": "Shape", "identify": "Identification", "rubber-fit": "RubberFit"}
# The list of an answer that is its table.
ROWS = {
    "simulate": "points", "design": "candidates", "joint": "points", "study": "points", "validate": "cases", "measured": "results", "compare": "models",
    "identify": "parameters", "rubber-fit": "laws", "rubber-list": "rubbers", "braid-list": "braids", "models": "models",
    "motion": "series", "fit-report": "findings", "units": "kinds", "braid-show": "points", "rubber-show": "fits",
}
# What every answer can do; no field may be called so.
METHODS = {"keys", "plot", "to_arrow", "to_dict", "to_pandas", "to_polars", "to_table"}
NO_METHOD = {"design", "fit", "motion", "rubber-fit"}


def schemas() -> dict[str, Any]:
    return {path.stem: json.loads(path.read_text("utf-8")) for path in sorted((ROOT / "docs" / "schema").glob("*.json"))}


def doc(schema: dict[str, Any]) -> str:
    """The description: rustdoc's brackets around references and its examples are left out."""
    text = re.sub(r"```.*?```", "", schema.get("description", ""), flags=re.DOTALL).strip()
    text = re.sub(r"\\\[([a-z0-9]+)\\\]", r"[\1]", text)
    return re.sub(r"\[(`[^`]*`)\](\([^)]*\))?", r"\1", text)


class Types:
    """Schemas as types of Python."""

    def __init__(self, all_schemas: dict[str, Any], side: str) -> None:
        self.defs: dict[str, Any] = {}
        self.side = side
        for schema in all_schemas.values():
            part = schema[side]
            self.defs.update(part.get("$defs", {}))

    def words(self, schema: dict[str, Any]) -> list[str] | None:
        """The words of a schema that is a list of words."""
        if "enum" in schema and all(isinstance(v, str) for v in schema["enum"]):
            return list(schema["enum"])
        options = schema.get("oneOf") or schema.get("anyOf") or []
        out: list[str] = []
        for option in options:
            if "const" in option:
                out.append(option["const"])
            elif option.get("type") == "string" and "enum" in option:
                out.extend(option["enum"])
            else:
                return None
        return out or None

    def properties(self, schema: dict[str, Any]) -> dict[str, Any]:
        """All properties of an object, those of its variants among them."""
        out: dict[str, Any] = {}
        if "$ref" in schema:
            out.update(self.properties(self.defs[schema["$ref"].split("/")[-1]]))
        out.update(schema.get("properties", {}))
        for option in schema.get("anyOf", []) + schema.get("oneOf", []) + schema.get("allOf", []):
            for name, value in self.properties(option).items():
                out.setdefault(name, value)
        return out

    def required(self, schema: dict[str, Any]) -> set[str]:
        if "$ref" in schema:
            return self.required(self.defs[schema["$ref"].split("/")[-1]])
        options = [self.required(o) for o in schema.get("anyOf", []) + schema.get("oneOf", [])]
        own = set(schema.get("required", []))
        return own | set.intersection(*options) if options else own

    def is_record(self, schema: dict[str, Any]) -> bool:
        return bool(self.properties(schema)) and self.words(schema) is None

    def of(self, schema: Any) -> str:
        if schema is True or not schema:
            return "Any"
        if "$ref" in schema:
            name = schema["$ref"].split("/")[-1]
            target = self.defs[name]
            if self.side == "request":
                return self.request(name, target)
            if self.is_record(target):
                return str(name)
            return self.of(target)
        words = self.words(schema)
        if words:
            return f"Literal[{', '.join(json.dumps(w) for w in words)}]"
        for key in ("anyOf", "oneOf"):
            if key in schema:
                kinds = list(dict.fromkeys(self.of(option) for option in schema[key]))
                return union(kinds)
        kind = schema.get("type")
        if isinstance(kind, list):
            return union([self.of({**schema, "type": one}) for one in kind])
        if kind == "array":
            if "prefixItems" in schema:
                return f"tuple[{', '.join(self.of(item) for item in schema['prefixItems'])}]"
            return f"list[{self.of(schema.get('items'))}]"
        if kind == "object":
            extra = schema.get("additionalProperties")
            return f"dict[str, {self.of(extra)}]" if extra not in (None, False) else "dict[str, Any]"
        return {"string": "str", "number": "float", "integer": "int", "boolean": "bool", "null": "None"}.get(kind or "", "Any")

    def request(self, name: str, schema: dict[str, Any]) -> str:
        """What a user may give for a group of fields."""
        if name == "TextFile":
            return "FileLike"
        if name == "Choice":
            return "Choice"
        if name == "Stiffness":
            return "Number | str"
        if self.words(schema):
            return self.of(schema)
        if schema.get("type") == "object":
            return "dict[str, Any]"
        return self.of(schema)


def union(kinds: list[str]) -> str:
    kinds = list(dict.fromkeys(kinds))
    if "Any" in kinds:
        return "Any"
    if "None" in kinds:
        kinds = [k for k in kinds if k != "None"] + ["None"]
    return " | ".join(kinds)


def field_type(types: Types, name: str, schema: dict[str, Any]) -> str:
    """What a user may give for a field of a request."""
    kind = types.of(schema)
    if name == "muscle":
        return "MuscleLike | None"
    if name in ("data", "table", "tables", "load_tables"):
        kind = kind.replace("FileLike", "TableLike")
        if kind == "list[TableLike]":
            return "TableLike | Sequence[TableLike] | None"
    if name == "cases":
        return "FileLike | Sequence[FileLike] | None"
    if name == "muscles" and kind == "list[FileLike]":
        return "Mapping[str, MuscleLike] | Sequence[FileLike] | None"
    if name == "formulas" or name == "file":
        kind = kind.replace("FileLike", "FormulaLike")
    if name == "rubber":
        return "str | Rubber | None"
    if name == "braid":
        return "str | Braid | None"
    if name == "model":
        return "str | Formula | None"
    if name == "models" and kind.startswith("list[str]"):
        return "Sequence[str | Formula] | None"
    if name == "figure" and kind != "bool":
        return "str | None"
    if kind.startswith("list[list["):
        return "Sequence[Numbers] | None"
    if kind.startswith("list[float]"):
        return "Numbers | None"
    kind = re.sub(r"\bfloat\b", "Number", kind)
    kind = re.sub(r"\blist\[", "Sequence[", kind)
    return kind if kind.endswith("None") or kind == "bool" else f"{kind} | None"


def muscle_fields(all_schemas: dict[str, Any]) -> list[str]:
    """The fields of a muscle besides its file."""
    names = list(all_schemas["muscle-show"]["request"]["properties"])
    return names[1 : names.index("model")]


def python_name(command: str) -> str:
    return command.replace("-", "_")


def parameter(name: str) -> str:
    return name + "_" if keyword.iskeyword(name) else name


def signature(types: Types, command: str, request: dict[str, Any], method: bool) -> tuple[list[str], list[str]]:
    """Parameters as text, and the names of the fields."""
    fields = dict(types.properties(request))
    first = [name for name in POSITIONAL.get(command, ["muscle"]) if name in fields]
    if method:
        for name in ["muscle", *MUSCLE_FIELDS]:
            fields.pop(name, None)
        first = [name for name in first if name in fields]
    long = command in LONG
    out, names = [], []
    for name in first + ["*"] + [n for n in fields if n not in first]:
        if name == "*":
            if len(first) < len(fields) or long:
                out.append("*")
            continue
        kind, default = field_type(types, name, fields[name]), "None"
        if (command, name) in DEFAULTS:
            default, kind = DEFAULTS[command, name], kind.removesuffix(" | None")
        elif kind == "bool":
            default = "True" if fields[name].get("default") is True else "False"
        out.append(f"{parameter(name)}: {kind} = {default}")
        names.append(name)
    if long:
        out.append("progress: Progress = None")
    return out, names


LONG = {
    "design", "joint", "motion", "study", "simulate", "validate", "measured", "sweep", "compare", "identify", "fit", "fit-report", "plan", "rubber-fit",
    "curve",
}
MUSCLE_FIELDS: list[str] = []


def wrapped(text: str, indent: str, width: int = 118) -> str:
    paragraphs = [" ".join(p.split()) for p in text.split("\n\n")]
    lines = [textwrap.wrap(p, width - len(indent)) or [""] for p in paragraphs]
    return f"\n\n".join("\n".join(indent + line for line in p) for p in lines)


def docstring(types: Types, command: str, schema: dict[str, Any], names: list[str], answer: str, indent: str) -> str:
    request = schema["request"]
    fields = types.properties(request)
    out = [wrapped(doc(request) or f"`{command}`.", indent).strip(), ""]
    if names or command in LONG:
        out += [f"{indent}Parameters", f"{indent}----------"]
    for name in names:
        kind = unit_of(fields[name])
        out.append(f"{indent}{parameter(name)}" + (f" : {kind}" if kind else ""))
        out.append(wrapped(doc(fields[name]) or "See the documentation.", indent + "    "))
    if command in LONG:
        out.append(f"{indent}progress")
        out.append(wrapped("True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).", indent + "    "))
    out += ["", f"{indent}Returns", f"{indent}-------", f"{indent}{answer}", wrapped(doc(schema["answer"]) or "The answer.", indent + "    ")]
    out += ["", f"{indent}Raises", f"{indent}------", f"{indent}MckibbenError", wrapped("One of its classes says why there is no answer.", indent + "    ")]
    return indent + '"""' + "\n".join(out).lstrip() + f'\n{indent}"""'


def unit_of(schema: Any) -> str:
    """The unit of a field's numbers, as the schema has it."""
    if not isinstance(schema, dict):
        return ""
    return str(schema.get("x-unit") or ("ratio" if schema.get("x-quantity") == "ratio" else ""))


def record(types: Types, name: str, schema: dict[str, Any], rows: str | None) -> list[str]:
    fields = types.properties(schema)
    if taken := METHODS & set(fields):
        raise SystemExit(f"{name}: {taken} are methods of every answer")
    required = types.required(schema)
    out = [f"class {name}(Record):", '    """' + wrapped(doc(schema) or name, "    ").strip()]
    if fields:
        out += ["", "    Attributes", "    ----------"]
        for field, value in fields.items():
            unit = unit_of(value)
            out.append(f"    {field}" + (f" : {unit}" if unit else ""))
            out.append(wrapped(doc(value) or "See the documentation.", "        "))
    out += ['    """', "", "    __slots__ = ()"]
    nested = {f: n for f, v in fields.items() if (n := nested_of(types, v))}
    out.append(f"    _fields_ = {tuple(fields)!r}")
    if nested:
        out.append(f"    _nested_ = {nested!r}")
    if rows:
        out.append(f"    _rows_ = {rows!r}")
    for field, value in fields.items():
        kind = types.of(value)
        if field not in required and "None" not in kind and kind != "Any":
            kind += " | None"
        if not keyword.iskeyword(field):
            out.append(f"    {field}: {kind}")
    return [*out, "", ""]


def nested_of(types: Types, schema: Any) -> str | None:
    """The class of a field that holds records, or lists of them."""
    if not isinstance(schema, dict):
        return None
    if "$ref" in schema:
        name = schema["$ref"].split("/")[-1]
        return name if types.is_record(types.defs[name]) else nested_of(types, types.defs[name])
    for option in schema.get("anyOf", []) + schema.get("oneOf", []):
        if found := nested_of(types, option):
            return found
    for key in ("items", "additionalProperties"):
        if found := nested_of(types, schema.get(key)):
            return found
    return None


# What a muscle has under names of its own: measures that are always there, and rubber and braid in words.
OWN_OF_MUSCLE = {"muscle", "outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "rubber", "braid"}


def is_list(types: Types, schema: dict[str, Any]) -> bool:
    """Whether a field holds several numbers."""
    return types.of(schema).startswith("list[")


def is_choice(schema: dict[str, Any]) -> bool:
    """Whether a field may be an interval as well."""
    return any(option.get("$ref", "").endswith("/Choice") for option in [schema, *schema.get("anyOf", [])])


def groups(types: Types, schema: dict[str, Any], found: dict[str, dict[str, tuple[str, str]]]) -> None:
    """What the quantities are in fields that are groups of fields themselves, by the name of the group."""
    for name, field in types.properties(schema).items():
        for option in [field, field.get("items"), *field.get("anyOf", [])]:
            target = types.defs.get(option["$ref"].split("/")[-1]) if isinstance(option, dict) and "$ref" in option else None
            if target is None or name in found or not types.is_record(target):
                continue
            own = {n: (f["x-quantity"], f.get("x-unit", "")) for n, f in types.properties(target).items() if isinstance(f, dict) and "x-quantity" in f}
            if own:
                found[name] = own
            groups(types, target, found)


def fields(all_schemas: dict[str, Any]) -> str:
    """What is known of the fields of requests, and a muscle's own."""
    types = Types(all_schemas, "request")
    lists: set[str] = set()
    choices: dict[str, list[str]] = {}
    nested: dict[str, dict[str, tuple[str, str]]] = {}
    for command, schema in all_schemas.items():
        for name, field in types.properties(schema["request"]).items():
            if "x-quantity" in field and is_list(types, field):
                lists.add(name)
            if is_choice(field):
                choices.setdefault(command, []).append(name)
        groups(types, schema["request"], nested)
    request = all_schemas["muscle-show"]["request"]
    own = {name: types.properties(request)[name] for name in MUSCLE_FIELDS}
    out = [
        HEAD.format("What the fields of requests are, and a muscle by its fields."),
        "from __future__ import annotations\n",
        "from typing import TYPE_CHECKING, Any\n",
        "if TYPE_CHECKING:",
        "    from ._inputs import MuscleLike, Number",
        "    from ._parts import Braid, Rubber\n",
        "# Fields of a muscle, after `muscle`, its file.",
        "MUSCLE = " + literal(MUSCLE_FIELDS, "()"),
        "# Fields that hold several quantities.",
        "LISTS = " + literal(sorted(lists), "{}"),
        "# Fields that may be an interval, by command.",
        f"CHOICES: dict[str, set[str]] = {{{', '.join(f'{json.dumps(c)}: ' + literal(sorted(n), '{}') for c, n in sorted(choices.items()))}}}",
        "# Kind of quantity and unit of the fields of groups of fields, by the name of the group.",
        "GROUPS: dict[str, dict[str, tuple[str, str]]] = {",
        *(f"    {json.dumps(n)}: {{{', '.join(f'{json.dumps(f)}: ({json.dumps(k)}, {json.dumps(u)})' for f, (k, u) in of.items())}}}," for n, of in sorted(nested.items())),
        "}\n\n",
        "class MuscleFields:",
        '    """A muscle by its fields."""\n',
        "    __slots__ = ()\n",
        "    def __init__(",
        "        self,",
        "        base: MuscleLike | None = None,",
        "        *,",
        *(f"        {parameter(name)}: {field_type(types, name, field)} = None," for name, field in own.items()),
        "    ) -> None:",
        '        """',
        "        Parameters",
        "        ----------",
        "        base",
        "            A muscle, or the path of a muscle file (TOML), whose values the other arguments replace.",
    ]
    for name, field in own.items():
        unit = unit_of(field)
        out.append(f"        {parameter(name)}" + (f" : {unit}" if unit else ""))
        part = {"rubber": " Or a :class:`Rubber`.", "braid": " Or a :class:`Braid`."}.get(name, "")
        out.append(wrapped(doc(field) + part, "            "))
    values = ", ".join(['"muscle": base', *(f'"{name}": {parameter(name)}' for name in own)])
    out += [
        '        """',
        "        from ._plain import muscle_text\n",
        f"        self._hold(muscle_text({{{values}}}))\n",
        "    def _hold(self, text: str) -> None:",
        "        raise NotImplementedError\n",
        "    def _field(self, name: str) -> Any:",
        "        raise NotImplementedError",
    ]
    for name, field in own.items():
        if name in OWN_OF_MUSCLE:
            continue
        kind = "float | str | None" if "$ref" in json.dumps(field) else "float | None"
        out += ["", "    @property", f"    def {parameter(name)}(self) -> {kind}:", f'        """{" ".join(doc(field).split())}"""', f'        return self._field("{name}")  # type: ignore[no-any-return]']
    return "\n".join(out).rstrip() + "\n"


def literal(names: list[str], brackets: str) -> str:
    return brackets[0] + ", ".join(json.dumps(name) for name in names) + brackets[1]


def answers(all_schemas: dict[str, Any]) -> str:
    types = Types(all_schemas, "answer")
    out = [HEAD.format("What commands answer."), "from __future__ import annotations\n", "from typing import Any, Literal\n", "from ._record import Record\n\n"]
    titles = {s["answer"]["title"]: (c, s["answer"]) for c, s in all_schemas.items()}
    for name, schema in sorted(types.defs.items()):
        if types.is_record(schema) and name not in titles:
            out += record(types, name, schema, None)
    done = set()
    for name, (command, schema) in sorted(titles.items()):
        if name not in done:
            done.add(name)
            out += record(types, name, schema, ROWS.get(command))
    return "\n".join(out).rstrip() + "\n"


def commands(all_schemas: dict[str, Any]) -> str:
    types = Types(all_schemas, "request")
    out = [
        HEAD.format("Every command as a function, and those of a muscle as its methods."),
        "from __future__ import annotations\n",
        "from collections.abc import Mapping, Sequence",
        "from typing import TYPE_CHECKING, Any, Literal\n",
        "from ._ask import Progress, answered\n",
        "if TYPE_CHECKING:",
        "    from . import _answers, _results",
        "    from ._formula import Formula",
        "    from ._inputs import Choice, FileLike, FormulaLike, MuscleLike, Number, Numbers, TableLike",
        "    from ._parts import Braid, Rubber\n\n",
    ]
    names_of_all = []
    methods = ["class MuscleCommands:", '    """What a muscle is asked: every command that takes one."""', "", "    __slots__ = ()", ""]
    for command, schema in all_schemas.items():
        if command in LEFT_OUT:
            continue
        answer = f"_results.{OWN_CLASS[command]}" if command in OWN_CLASS else f"_answers.{schema['answer']['title']}"
        plain = answer.split(".")[-1]
        parameters, names = signature(types, command, schema["request"], method=False)
        name = python_name(command)
        names_of_all.append(name)
        values = "{" + ", ".join(f'"{n}": {parameter(n)}' for n in names) + "}"
        progress = ", progress" if command in LONG else ""
        out += [f"def {name}(", *(f"    {p}," for p in parameters), f") -> {answer}:" if parameters else f") -> {answer}:"]
        out += [docstring(types, command, schema, names, plain, "    "), f'    return answered("{command}", {values}, "{plain}"{progress})  # type: ignore[no-any-return]', "", ""]
        if "muscle" in names and command not in NO_METHOD and "angle_deg" in types.properties(schema["request"]):
            parameters, names = signature(types, command, schema["request"], method=True)
            values = "{" + ", ".join(['"muscle": self', *(f'"{n}": {parameter(n)}' for n in names)]) + "}"
            methods += [f"    def {'show' if command == 'muscle-show' else name}(", "        self,", *(f"        {p}," for p in parameters), f"    ) -> {answer}:"]
            methods += [docstring(types, command, schema, names, plain, "        ")]
            methods += [f'        return answered("{command}", {values}, "{plain}"{progress})  # type: ignore[no-any-return]', ""]
    out += methods
    listed = ", ".join(f'"{n}"' for n in names_of_all)
    return "\n".join([*out, "", f"__all__ = [{listed}]"]).rstrip() + "\n"


SPECIAL = {"no_answer": "NoAnswerError", "not_converged": "NotConvergedError", "cancelled": "CancelledError", "internal": "InternalError"}


def errors(all_schemas: dict[str, Any]) -> str:
    kinds = next(iter(all_schemas.values()))["error"]["$defs"]["ProblemKind"]["oneOf"]
    out = [HEAD.format("An exception class for every kind of problem."), "from __future__ import annotations\n"]
    out += ["from typing import Any\n", "from ._problem import InternalError, MckibbenError, NoAnswerError, NotConvergedError, WrongInputError\n\n"]
    table, names = [], []
    for kind in kinds:
        word, about = kind["const"], kind["description"]
        name = SPECIAL.get(word) or "".join(part.capitalize() for part in word.split("_")) + "Error"
        base = "NotConvergedError" if word == "cancelled" else "WrongInputError"
        table.append(f'    "{word}": {name},')
        names.append(name)
        if word not in SPECIAL or word == "cancelled":
            out += [f"class {name}({base}):", f'    """{about}"""', "", ""]
    out += ["KINDS: dict[str, type[MckibbenError]] = {", *table, "}", "", ""]
    listed = ", ".join(f'"{n}"' for n in sorted({*names, "MckibbenError", "WrongInputError"}))
    out += ["def of(values: dict[str, Any]) -> MckibbenError:", '    """The exception of a problem, as the compiled half hands it over."""',
            '    return KINDS.get(str(values["kind"]), MckibbenError)(**values)', "", "", f"__all__ = [{listed}]"]
    return "\n".join(out) + "\n"


def reference(all_schemas: dict[str, Any]) -> str:
    """The reference page, from the docstrings of the package."""
    sys.path.insert(0, str(ROOT / "python"))
    import ast

    out = ["# Python reference\n", "Written by `python/generate.py` from the docstrings of the package. [The Python package](python.md) tells how they go together.\n"]
    of_muscle = next(n for n in ast.parse((PACKAGE / "_fields.py").read_text("utf-8")).body if isinstance(n, ast.ClassDef))
    init = next(n for n in of_muscle.body if isinstance(n, ast.FunctionDef) and n.name == "__init__")
    parts = [("Objects", ["_muscle.py", "_parts.py", "_model.py", "_formula.py", "_campaign.py", "_table.py"]), ("Commands", ["_commands.py"]), ("Answers", ["_columns.py", "_results.py", "_record.py"]),
             ("Exceptions", ["_problem.py", "_errors.py"]), ("For JAX and PyTorch", ["jax.py", "torch.py"])]
    for title, files in parts:
        out.append(f"## {title}\n")
        for file in files:
            path = PACKAGE / file
            if not path.exists():
                continue
            for node in ast.parse(path.read_text("utf-8")).body:
                if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("_") and (text := ast.get_docstring(node)):
                    module = f"{path.stem}." if path.stem in ("jax", "torch") else ""
                    items = list(node.body)
                    if node.name == "Muscle":
                        # What it is made of is written from the schemas.
                        text = text.replace("Examples\n", (ast.get_docstring(init) or "") + "\n\nExamples\n")
                        items += of_muscle.body
                    out += entry(node, text, "###", module)
                    if isinstance(node, ast.ClassDef) and node.name != "MuscleCommands":
                        for item in items:
                            if isinstance(item, ast.FunctionDef) and not item.name.startswith("_") and (own := ast.get_docstring(item)):
                                out += entry(item, own, "####", node.name + ".")
    return "\n".join(out).rstrip() + "\n"


def entry(node: Any, text: str, level: str, of: str = "") -> list[str]:
    import ast

    heading = f"{of}{node.name}"
    if isinstance(node, ast.FunctionDef) and not any(isinstance(d, ast.Name) and d.id == "property" for d in node.decorator_list):
        names = [a.arg for a in node.args.args + node.args.kwonlyargs if a.arg not in ("self", "cls")]
        heading += "(" + ", ".join(names[:4] + (["…"] if len(names) > 4 else [])) + ")"
    lines, body = re.sub(r":\w+:`([^`]+)`", r"`\1`", text).splitlines(), []
    i = 0
    while i < len(lines):
        # An example, up to the next empty line.
        if lines[i].startswith(">>>"):
            body.append("```python")
            while i < len(lines) and lines[i]:
                body.append(lines[i])
                i += 1
            body.append("```")
            continue
        if i + 1 < len(lines) and set(lines[i + 1].strip()) == {"-"}:
            body += [f"**{lines[i].strip()}**", ""]
            i += 2
            continue
        # A name with its text below it becomes a point of a list.
        if i + 1 < len(lines) and lines[i] and not lines[i].startswith(" ") and lines[i + 1].startswith("    "):
            about = []
            j = i + 1
            while j < len(lines) and (lines[j].startswith("    ") or not lines[j]):
                about.append(lines[j].strip())
                j += 1
            name, _, kind = lines[i].partition(" : ")
            body.append(f"- `{name}`" + (f" ({kind})" if kind else "") + ": " + " ".join(a for a in about if a))
            if j < len(lines) and not about[-1]:
                body.append("")
            i = j
            continue
        body.append(lines[i])
        i += 1
    return [f"{level} `{heading}`\n", "\n".join(body).strip().replace("<module", "&lt;module"), ""]


def main() -> None:
    all_schemas = schemas()
    MUSCLE_FIELDS[:] = muscle_fields(all_schemas)
    made = {
        PACKAGE / "_fields.py": fields(all_schemas),
        PACKAGE / "_answers.py": answers(all_schemas),
        PACKAGE / "_commands.py": commands(all_schemas),
        PACKAGE / "_errors.py": errors(all_schemas),
    }
    if "--check" not in sys.argv:
        for path, text in made.items():
            path.write_text(text, "utf-8")
    made[ROOT / "docs" / "python-reference.md"] = reference(all_schemas)
    if "--check" not in sys.argv:
        for path, text in made.items():
            path.write_text(text, "utf-8")
        return
    stale = [str(path.relative_to(ROOT)) for path, text in made.items() if not path.exists() or path.read_text("utf-8") != text]
    if stale:
        raise SystemExit(f"not what python/generate.py writes: {', '.join(stale)}")


if __name__ == "__main__":
    main()
