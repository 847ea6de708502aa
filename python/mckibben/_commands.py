"""Every command as a function, and those of a muscle as its methods: made from the schema when they are used first."""

from __future__ import annotations

import keyword
import re
from collections.abc import Callable, Iterable
from inspect import Parameter, Signature
from typing import Any

from . import _quantity, _schema
from ._ask import answered
from ._errors import InputError
from ._files import FORMULAS, TABLES
from ._plain import muscle_text
from ._schema import entry, section, wrapped

# Commands that are no function of the package: they serve pages and the command line.
LEFT_OUT = {"quantities", "campaign-show", "campaign-merge", "campaign-status", "campaign", "units"}
# What may be given without its keyword, in this order.
POSITIONAL = {
    "build": ["muscle", "pressure_mpa"],
    "export": ["muscle", "target"],
    "force": ["muscle", "pressure_mpa", "contraction"],
    "pressure": ["muscle", "force_n", "contraction"],
    "contraction": ["muscle", "force_n", "pressure_mpa"],
    "fill": ["muscle", "volume_mm3"],
    "curve": ["muscle", "test"],
    "simulate": ["muscle", "test"],
    "shape": ["muscle", "pressure_mpa", "contraction"],
    "joint": ["joint"],
    "motion": ["drive"],
    "fit": ["table"],
    "plan": ["plan"],
    "rubber": ["data"],
    "parts-list": ["kind"],
    "parts-show": ["name"],
    "check-formula": ["file"],
    "identify": ["muscle", "data"],
    "sweep": ["muscles"],
}
DEFAULTS = {("curve", "test"): "isobaric", ("simulate", "test"): "isobaric", ("sweep", "muscles"): 100}
# The answers that have a class of their own around that of the schema, by command.
OWN_CLASS = {"build": "Build", "export": "Export", "curve": "Curve", "plan": "Plan", "design": "Design", "fit": "Fitted", "shape": "Shape", "identify": "Identification", "rubber": "RubberFit"}
# Commands that take a muscle and are none of its methods.
NO_METHOD = {"design", "fit", "motion", "rubber"}
# Methods of a muscle with names of their own: the whole point is its state.
METHODS = {"force": "state"}
# What a muscle must be given.
GEOMETRY = ("outer_diameter_mm", "wall_mm", "length_mm")
# Commands that fit measured tables, with the argument of these; tests of a rubber have columns of their own.
PROGRESS = "True for a line on standard error, or a function that is called with (done, total)."
# Types of what may be given for fields, by their names.
GIVEN = {
    "muscle": "MuscleLike | None",
    "muscles": "Mapping[str, MuscleLike] | Sequence[FileLike] | None",
    "cases": "FileLike | Sequence[FileLike] | None",
    "rubber": "str | Rubber | Mapping[str, Plain] | None",
    "model": "str | Formula | None",
    "models": "Sequence[str | Formula] | None",
    "figure": "str | None",
    "joint": "FileLike | Joint | None",
    "drive": "FileLike | Drive | None",
}
# Files that are tables or formulas, by the names of their fields.
LIKE = {name: "TableLike" for name in TABLES} | {name: "FormulaLike" for name in FORMULAS}


def _argument(name: str) -> str:
    """The name of a field as an argument."""
    return name + "_" if keyword.iskeyword(name) else name


def _given(name: str, schema: _schema.Schema) -> str:
    """The type of what may be given for a field."""
    kind = _schema.request_type(schema)
    if name in GIVEN and kind not in ("bool", "int"):
        return GIVEN[name]
    if kind.startswith("list[list["):
        return "Sequence[Numbers] | None"
    if kind.startswith("list[float]"):
        return "Numbers | None"
    like = LIKE.get(name, "FileLike")
    if kind == "list[FileLike]" and like == "TableLike":
        return "TableLike | Sequence[TableLike] | None"
    kind = kind.replace("FileLike", like).replace("float", "Number").replace("list[", "Sequence[")
    return kind if kind.endswith("None") or kind == "bool" else f"{kind} | None"


def _is_long(command: str) -> bool:
    """Whether a command hears of progress."""
    return bool(_schema.bundle()[command]["long"]) or command == "curve"


def _parameter(command: str, name: str, schema: _schema.Schema, is_keyword: bool) -> Parameter:
    kind, default = _given(name, schema), DEFAULTS.get((command, name))
    if default is not None:
        kind = kind.removesuffix(" | None")
    elif kind == "bool":
        default = schema.get("default") is True
    return Parameter(_argument(name), Parameter.KEYWORD_ONLY if is_keyword else Parameter.POSITIONAL_OR_KEYWORD, default=default, annotation=kind)


def unit_free(names: Iterable[str]) -> dict[str, str]:
    """The fields of quantities by their names without the unit: `outer_diameter` is `outer_diameter_mm`."""
    names = list(names)
    short = {name: _quantity.bare(name) for name in names}
    return {bare: name for name, bare in short.items() if bare != name and bare not in names}


def spelled(function: str, given: dict[str, Any], known: Iterable[str]) -> dict[str, Any]:
    """Arguments by the names of the fields: those without a unit in their name are texts with one, or quantities of pint."""
    bare, out = unit_free(known), {}
    for name, value in given.items():
        if name in bare:
            if bare[name] in given:
                raise TypeError(f"{function}(): both {name} and {bare[name]} are given")
            several = value if isinstance(value, (list, tuple)) else [value]
            if not all(isinstance(v, str) or hasattr(v, "magnitude") or v is None for v in several):
                raise TypeError(f'{function}(): {name} is a text with its unit or a quantity of pint; for a number {bare[name]}={value!r}')
            if any(isinstance(v, str) and re.fullmatch(r"\s*[-+\d.,eE]+\s*", v) for v in several):
                raise TypeError(f'{function}(): {name}={value!r} has no unit; for a number {bare[name]}')
        out[bare.get(name, name)] = value
    return out


def _called(signature: Signature, name: str, about: str, owner: str, ask: Callable[[dict[str, Any]], Any]) -> Callable[..., Any]:
    """A function, or a method of an owner, of a signature, name and documentation; `ask` has its arguments by their names."""

    known, first = signature.parameters.keys(), [p.name for p in signature.parameters.values() if p.kind is p.POSITIONAL_OR_KEYWORD]
    needed = {p.name for p in signature.parameters.values() if p.default is p.empty and p.name != "self"}

    def called(*args: Any, **values: Any) -> Any:
        given = {**dict(zip(first, args)), **values}
        if not given.keys() <= known:
            given = spelled(name, given, known)
            args, values = args[:1] if owner else (), {name: value for name, value in given.items() if name != "self"} if owner else given
        if len(given) != len(args) + len(values) or not needed <= given.keys() <= known or owner and not args:
            # Slower, and it has the words for what is wrong.
            try:
                signature.bind(*args, **values)
            except TypeError as error:
                raise TypeError(f"{name}() {error}") from None
        return ask(given)

    called.__name__, called.__qualname__, called.__module__, called.__doc__ = name, owner + name, __name__ if owner else __package__, about
    called.__signature__ = signature  # type: ignore[attr-defined]
    called.__annotations__ = {p.name: p.annotation for p in signature.parameters.values() if p.annotation is not p.empty} | {"return": signature.return_annotation}
    return called


def _function(command: str, owner: str = "") -> Callable[..., Any]:
    """A command as a function, or as a method of its muscle."""
    schema = _schema.bundle()[command]
    answer = OWN_CLASS.get(command) or schema["answer"]["title"]
    fields = _schema.request(command)
    if owner:
        fields = {name: field for name, field in fields.items() if name != "muscle" and name not in _schema.muscle()}
    first = [name for name in POSITIONAL.get(command, ["muscle"]) if name in fields]
    fields = {name: fields[name] for name in [*first, *fields]}
    names = {_argument(name): name for name in fields}
    parameters = [_parameter(command, name, field, name not in first) for name, field in fields.items()]
    listed = [entry(argument, _schema.doc(fields[name]), _schema.unit(fields[name])) for argument, name in names.items()]
    if _is_long(command):
        parameters.append(Parameter("progress", Parameter.KEYWORD_ONLY, default=None, annotation="Progress"))
        listed.append(entry("progress", PROGRESS))
    about = [
        wrapped(_schema.doc(schema["request"]) or f"`{command}`."),
        *section("Parameters", listed),
        *section("Returns", [entry(answer, _schema.doc(schema["answer"]) or "The answer.")]),
        *section("Raises", [entry("MckibbenError", "One of its classes says why there is no answer.")]),
    ]
    # What is left out is left to the program; these have a default here.
    defaults = {name: default for (of, name), default in DEFAULTS.items() if of == command}

    def ask(given: dict[str, Any]) -> Any:
        values = {**defaults, **given}
        progress = values.pop("progress", None)
        muscle = {"muscle": values.pop("self")} if owner else {}
        return answered(command, {**muscle, **{names[name]: value for name, value in values.items()}}, answer, progress)

    own = [Parameter("self", Parameter.POSITIONAL_OR_KEYWORD)] if owner else []
    signature = Signature([*own, *parameters], return_annotation=f"{'_muscle' if command in ('design', 'identify') else '_results' if command in OWN_CLASS else '_answers'}.{answer}")
    return _called(signature, METHODS.get(command, command.replace("-", "_")) if owner else command.replace("-", "_"), "\n\n".join(about), owner, ask)


def _muscle_commands() -> type:
    """The methods of a muscle: every command that takes one."""
    asked = [c for c in _schema.commands() if c not in LEFT_OUT | NO_METHOD and {"muscle", "angle_deg"} <= _schema.request(c).keys()]
    methods = {method.__name__: method for method in (_function(command, "MuscleCommands.") for command in asked if command not in ("pressure", "contraction"))}
    return type("MuscleCommands", (), {"__slots__": (), "__module__": __name__, "__doc__": "What a muscle is asked: every command that takes one.", **methods})


def _attributes(names: Iterable[str]) -> dict[str, property]:
    """Fields of a muscle as attributes by their names."""
    # What every answer says of its muscle is never missing.
    always = _schema.required({"$ref": "#/$defs/MuscleSummary"})

    def attribute(name: str) -> property:
        field = _schema.muscle()[name]

        def get(self: Any) -> Any:
            return self._field(name)

        kind = "str" if _schema.request_type(field).startswith("str") else "float | str" if _schema.reference(field) or _schema.options(field) else "float"
        get.__annotations__ = {"return": kind if name in always else f"{kind} | None"}
        return property(get, doc=" ".join(_schema.doc(field).split()))

    return {name: attribute(name) for name in names}


def _muscle_fields() -> type:
    """What makes a muscle of its fields, and the fields as attributes."""
    fields, me = _schema.muscle(), Parameter("self", Parameter.POSITIONAL_OR_KEYWORD)

    def make(given: dict[str, Any]) -> None:
        muscle, base = given.pop("self"), given.pop("base", None)
        if base is None and (missing := [name for name in GEOMETRY if given.get(name) is None]):
            raise InputError(f"{', '.join(missing)} missing", kind="usage", field=missing[0], hint="Muscle.prototype(…) has the paper's: D0 30 mm, s 3 mm, L0 285 mm")
        muscle._hold(muscle_text({"muscle": base, **given}))

    def other(given: dict[str, Any]) -> Any:
        muscle = given.pop("self")
        return type(muscle)(muscle, **given)

    base = Parameter("base", Parameter.POSITIONAL_OR_KEYWORD, default=None, annotation=GIVEN["muscle"])
    own = [Parameter(name, Parameter.KEYWORD_ONLY, default=None, annotation=_given(name, field)) for name, field in fields.items()]
    listed = [entry(name, _schema.doc(field) + (" Or a :class:`Rubber`." if name == "rubber" else ""), _schema.unit(field)) for name, field in fields.items()]
    of_base = entry("base", "A muscle, or the path of a muscle file (TOML), whose values the other arguments replace.")
    init = _called(Signature([me, base, *own], return_annotation="None"), "__init__", *section("Parameters", [of_base, *listed]), "MuscleFields.", make)
    about = "\n\n".join(["The same with other values.", *section("Parameters", listed)])
    replace = _called(Signature([me, *own], return_annotation="Muscle"), "replace", about, "MuscleFields.", other)
    attributes = _attributes(name for name in fields if name not in ("rubber", "rubber_file", "braid"))
    return type("MuscleFields", (), {"__slots__": (), "__module__": __name__, "__doc__": "By its fields.", "__init__": init, "replace": replace, **attributes})


CLASSES: dict[str, Callable[[], type]] = {"MuscleCommands": _muscle_commands, "MuscleFields": _muscle_fields}


def __getattr__(name: str) -> Any:
    if name in CLASSES:
        value: Any = CLASSES[name]()
    elif name.startswith("_") and name != "__all__":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    else:
        functions = {command.replace("-", "_"): command for command in _schema.commands() if command not in LEFT_OUT}
        if name != "__all__" and name not in functions:
            raise AttributeError(f"there is no command {name!r}")
        value = sorted(functions) if name == "__all__" else _function(functions[name])
    # One, also where several threads want it first.
    return globals().setdefault(name, value)
