"""What every exception of the package has."""

from __future__ import annotations

import sys
import warnings
from typing import Any


def warned(text: str, kind: type[Warning]) -> None:
    """Warns at the line outside of the package that called it."""
    level, frame = 2, sys._getframe(1)
    while frame.f_back is not None and frame.f_globals.get("__name__", "").startswith("mckibben"):
        level, frame = level + 1, frame.f_back
    warnings.warn(text, kind, stacklevel=level)


class UnitWarning(UserWarning):
    """A bare number that was likely meant in another unit."""


class MckibbenError(Exception):
    """Why a call has no answer, in the words of the command line.

    Attributes
    ----------
    kind
        A word for programs, such as ``out_of_range``.
    message
        What is wrong, in a sentence.
    hint
        What to do about it; may be empty.
    field
        The argument that is to blame, where it is one.
    nearest
        The nearest answer there is, where it is known: a dict with ``force_n``, ``pressure_mpa``, ``contraction``.
    index
        The place in the flattened arrays, where the question was for arrays.
    exit_code
        That of the command line: 1 no answer exists, 2 the input is wrong, 3 not converged or cancelled, 4 the program is at fault.
    """

    def __init__(
        self,
        message: str = "",
        *,
        kind: str = "internal",
        hint: str = "",
        field: str | None = None,
        nearest: dict[str, float | None] | None = None,
        index: int | None = None,
        exit_code: int = 2,
    ) -> None:
        self.message, self.kind, self.hint, self.field = message, kind, hint, field
        self.nearest, self.index, self.exit_code = nearest, index, exit_code
        place = f"{field}: " if field else ""
        at = f"point {index}: " if index is not None else ""
        super().__init__(f"{at}{place}{message}" + (f" ({hint})" if hint else ""))

    def at(self, index: int) -> MckibbenError:
        """The same of another place in the flattened arrays."""
        kind, message, values = self.__reduce__()[1]
        return _restored(kind, message, {**values, "index": index})

    def __reduce__(self) -> tuple[Any, ...]:
        values = {"kind": self.kind, "hint": self.hint, "field": self.field, "nearest": self.nearest, "index": self.index, "exit_code": self.exit_code}
        return _restored, (type(self), self.message, values)


def _restored(kind: type[MckibbenError], message: str, values: dict[str, Any]) -> MckibbenError:
    return kind(message, **values)


class NoAnswerError(MckibbenError):
    """No answer exists."""


class WrongInputError(MckibbenError, ValueError):
    """The input is wrong."""


class NotConvergedError(MckibbenError, ArithmeticError):
    """The computation did not converge."""


class InternalError(MckibbenError, RuntimeError):
    """The program itself is at fault."""
