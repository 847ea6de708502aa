"""An exception class for every kind of problem that the schema lists."""

from __future__ import annotations

from typing import Any

from . import _schema
from ._problem import InternalError, MckibbenError, NoAnswerError, NotConvergedError, WrongInputError

_SPECIAL: dict[str, type[MckibbenError]] = {"no_answer": NoAnswerError, "not_converged": NotConvergedError, "internal": InternalError}


def _class(word: str, about: str) -> type[MckibbenError]:
    if word in _SPECIAL:
        return _SPECIAL[word]
    name, base = "".join(part.capitalize() for part in word.split("_")), NotConvergedError if word == "cancelled" else WrongInputError
    return type(f"{name}Error", (base,), {"__module__": __name__, "__doc__": about})


KINDS = {kind["const"]: _class(kind["const"], kind["description"]) for kind in _schema.bundle()["$defs"]["ProblemKind"]["oneOf"]}
_CLASSES = {kind.__name__: kind for kind in (MckibbenError, WrongInputError, *KINDS.values())}
globals().update(_CLASSES)
__all__ = sorted(_CLASSES)


def of(values: dict[str, Any]) -> MckibbenError:
    """The exception of a problem, as the compiled half hands it over."""
    return KINDS.get(str(values["kind"]), MckibbenError)(**values)
