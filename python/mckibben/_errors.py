"""The exceptions, and the names that they had: one for each kind of problem."""

from __future__ import annotations

from ._problem import FileError, InputError, InternalError, MckibbenError, NoAnswerError, NotConvergedError, OutOfRangeError, OutsideWarning, UnitWarning, of, warned

__all__ = ["FileError", "InputError", "InternalError", "MckibbenError", "NoAnswerError", "NotConvergedError", "OutOfRangeError", "OutsideWarning", "UnitWarning"]


def __getattr__(name: str) -> type[MckibbenError]:
    import re

    from . import _schema
    from ._problem import KINDS

    word = re.sub(r"(?<!^)(?=[A-Z])", "_", name.removesuffix("Error")).lower()
    kinds = {kind["const"] for kind in _schema.bundle()["$defs"]["ProblemKind"]["oneOf"]} if name.endswith("Error") else set()
    if word not in kinds | {"wrong_input"}:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    kind = KINDS.get(word, InputError)
    warned(f"{name} is {kind.__name__} now" + ("" if word == "wrong_input" else f'; its kind is "{word}"'), DeprecationWarning)
    return kind
