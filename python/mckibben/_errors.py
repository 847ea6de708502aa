"""The exceptions and warnings of the package."""

from __future__ import annotations

import re
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


class MuscleWarning(UserWarning):
    """What should be known of an answer: a pressure above the allowed one, a stretch beyond the data of the rubber, …"""


class UnitWarning(UserWarning):
    """A bare number that was likely meant in another unit."""


class MckibbenError(Exception):
    """Why a call has no answer. Its classes are :class:`InputError`, :class:`OutOfRangeError`, :class:`FileError`, :class:`NoAnswerError`,
    :class:`NotConvergedError` and :class:`InternalError`; each is one of Python's own too.

    ``message`` is a sentence and ``hint`` what to do about it; ``field`` is the argument that is to blame, where it is one; ``kind`` a word for programs,
    finer than the classes; ``nearest`` the nearest answer there is, where it is known: a dict with ``force_n``, ``pressure_mpa``, ``contraction``;
    ``index`` the place in the flattened arrays, where the question was for arrays.
    """

    kind: str = "usage"
    hint: str = ""
    field: str | None = None
    nearest: dict[str, float | None] | None = None
    index: int | None = None

    def __init__(self, message: str = "", **known: Any) -> None:
        super().__init__(message)
        self.message = message
        self.__dict__.update(known)

    def __str__(self) -> str:
        at = None if self.index is None else f"point {self.index}"
        said = ": ".join(filter(None, (at, self.field, self.message)))
        return f"{said} ({self.hint})" if self.hint else said


class InputError(MckibbenError, ValueError):
    """The input is wrong: a quantity, a name, an argument."""


class WrongTypeError(InputError, TypeError):
    """Not what an argument takes."""


class OutOfRangeError(InputError):
    """Outside of the range for which a model was made."""


class FileError(InputError, OSError):
    """A file is not what it should be; one that does not exist is a ``FileNotFoundError`` too."""


class MissingFileError(FileError, FileNotFoundError):
    """A file that does not exist."""


class ExistingFileError(FileError, FileExistsError):
    """A file that would be lost."""


class NoAnswerError(MckibbenError, ValueError):
    """No answer exists; ``nearest`` is the nearest one there is."""

    kind = "no_answer"


class NotConvergedError(MckibbenError, ArithmeticError):
    """The computation did not converge, or was cancelled."""


class InternalError(MckibbenError, RuntimeError):
    """The program itself is at fault."""


def wrong_type(field: str, wanted: str, value: object) -> WrongTypeError:
    """That an argument takes something else."""
    said = f"{wanted}, not {type(value).__name__}"
    return WrongTypeError(said, field=ARGUMENTS.get(field, field))


def checked(field: str, value: Any, *kinds: type) -> Any:
    """A value that is of one of these types."""
    if not isinstance(value, kinds):
        raise wrong_type(field, " or ".join(kind.__name__ for kind in kinds), value)
    return value


# Words of JSON whose class is not InputError.
KINDS = {
    "out_of_range": OutOfRangeError,
    "no_answer": NoAnswerError,
    "not_converged": NotConvergedError,
    "cancelled": NotConvergedError,
    "internal": InternalError,
    **dict.fromkeys(
        ("file", "damaged", "locked", "output", "incomplete", "other_plan"), FileError
    ),
}

# Arguments that have another name in JSON.
ARGUMENTS = {
    **dict.fromkeys(("direction", "branches", "both"), "branch"),
    "figure": "units",
    "with": "with_",
    "bulk_modulus": "bulk_modulus_mpa",
    "braid.strand_diameter": "strand_diameter_mm",
    "pressure": "pressure_mpa",
    "part": "name",
}

# What keywords make is no file, and is named by what it is; so are tables.
_TEXTS = ("muscle", "rubber", "joint", "drive")
TABLES = ("data", "log", "table", "tables", "load_tables")


def of(values: dict[str, Any]) -> MckibbenError:
    """The exception of a problem, as the compiled half hands it over."""
    # Commands in the words of Python, and the argument that is to blame.
    for name in ("message", "hint"):
        for there, here in (
            (r"`(?:mckibben )?parts list (\w+)`", r'`mk.parts("\1")`'),
            ("`parts list`", "`mk.parts(…)`"),
            ("`direction`", "`branch`"),
        ):
            values[name] = re.sub(there, here, values[name])
    kind, message = KINDS.get(values["kind"], InputError), values["message"]
    said = re.search(
        r"^there is no (command|model|part)\b|^`(\w+)` (?:is missing|is no|has no|needs)"
        r"|: missing field `(\w+)`|^outside .* model: (pressure|contraction) "
        r"|(?:^|: )((?:tube|braid|terminals|friction)\.\w+) is ",
        message,
    )
    field: Any = values.get("field") or (said and next(filter(None, said.groups())))
    values["field"] = ARGUMENTS.get(field, field)
    name, _, rest = message.partition(":")
    if name in TABLES or (kind is FileError and name in _TEXTS):
        kind, rest = InputError, rest.strip().replace("tube.material.", "")
        # Whoever gives a muscle as a text finds the place there.
        at = re.match(r"[\d:]+ (\w+)\.?(.*)", rest)
        if at and name != "muscle":
            name, rest = at[1], at[2].lstrip(" =:")
        values |= {"field": ARGUMENTS.get(name, name), "message": rest}
        if name not in TABLES:
            values["kind"] = "usage"
    elif kind is FileError and re.search(r"\(os error 2\)|does not exist", message):
        kind = MissingFileError
    elif values["kind"] == "file" and not re.match(r"(\w:)?[^:]*\.\w+:", message):
        # Of what keywords make, without a file.
        kind = InputError
    return kind(**values)


@contextmanager
def blamed(field: str | None = None, is_one: bool = False) -> Iterator[None]:
    """Names the argument of a problem where it has no other, and no place of a question that is not one of several."""
    try:
        yield
    except MckibbenError as error:
        error.field = error.field or field
        if is_one:
            error.index = None
        raise


def warned(text: str, kind: type[Warning] = UnitWarning) -> None:
    """Warns at the line outside of the package that called it."""
    level = 2
    frame: Any = sys._getframe(1)
    while frame.f_globals.get("__name__", "").startswith("mckibben"):
        level, frame = level + 1, frame.f_back
    warnings.warn(text, kind, stacklevel=level)
