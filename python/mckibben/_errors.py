"""An exception class for every kind of problem.

Written by python/generate.py from docs/schema; do not edit.
"""

from __future__ import annotations

from typing import Any

from ._problem import InternalError, MckibbenError, NoAnswerError, NotConvergedError, WrongInputError


class UsageError(WrongInputError):
    """Fields that are missing or exclude each other."""


class QuantityError(WrongInputError):
    """A value that is no quantity of the wanted kind."""


class RangeError(WrongInputError):
    """A range or list that cannot be used."""


class MuscleError(WrongInputError):
    """A muscle that cannot be built."""


class FileError(WrongInputError):
    """A file that cannot be read or understood."""


class RubberError(WrongInputError):
    """A rubber that is not known."""


class BraidError(WrongInputError):
    """A sleeve that is not known, does not fit, or does not say enough."""


class ModelError(WrongInputError):
    """A model that is not known."""


class MeshError(WrongInputError):
    """A mesh that cannot be made."""


class TerminalError(WrongInputError):
    """A terminal that cannot be made."""


class MissingInputError(WrongInputError):
    """Something that the model needs and the muscle does not state."""


class OutOfRangeError(WrongInputError):
    """Outside of what the model was made for."""


class CancelledError(NotConvergedError):
    """The caller wanted the work to end."""


class BudgetError(WrongInputError):
    """It would take, or has taken, more than its budget allows."""


class SpecificationError(WrongInputError):
    """A specification that cannot be searched for."""


class ToleranceError(WrongInputError):
    """Tolerances that no muscle can have."""


class FitError(WrongInputError):
    """A fit that cannot be made."""


class ParameterError(WrongInputError):
    """A constant that cannot be identified in this way."""


class DataError(WrongInputError):
    """Measured points that cannot be used."""


class FormulaError(WrongInputError):
    """The file of a formula that cannot be used."""


class OutputError(WrongInputError):
    """A result that cannot be written."""


class DeckError(WrongInputError):
    """An input deck that cannot be written."""


class ShowError(WrongInputError):
    """A quantity that cannot be shown."""


class PlotError(WrongInputError):
    """A figure that cannot be drawn."""


class OtherPlanError(WrongInputError):
    """A campaign of another plan or version."""


class LockedError(WrongInputError):
    """A campaign that another process works on."""


class DamagedError(WrongInputError):
    """A campaign's file that is damaged."""


class IncompleteError(WrongInputError):
    """A campaign that is not finished."""


KINDS: dict[str, type[MckibbenError]] = {
    "usage": UsageError,
    "quantity": QuantityError,
    "range": RangeError,
    "muscle": MuscleError,
    "file": FileError,
    "rubber": RubberError,
    "braid": BraidError,
    "model": ModelError,
    "mesh": MeshError,
    "terminal": TerminalError,
    "missing_input": MissingInputError,
    "out_of_range": OutOfRangeError,
    "no_answer": NoAnswerError,
    "not_converged": NotConvergedError,
    "cancelled": CancelledError,
    "budget": BudgetError,
    "specification": SpecificationError,
    "tolerance": ToleranceError,
    "fit": FitError,
    "parameter": ParameterError,
    "data": DataError,
    "formula": FormulaError,
    "output": OutputError,
    "deck": DeckError,
    "show": ShowError,
    "plot": PlotError,
    "other_plan": OtherPlanError,
    "locked": LockedError,
    "damaged": DamagedError,
    "incomplete": IncompleteError,
    "internal": InternalError,
}


def of(values: dict[str, Any]) -> MckibbenError:
    """The exception of a problem, as the compiled half hands it over."""
    return KINDS.get(str(values["kind"]), MckibbenError)(**values)


__all__ = ["BraidError", "BudgetError", "CancelledError", "DamagedError", "DataError", "DeckError", "FileError", "FitError", "FormulaError", "IncompleteError", "InternalError", "LockedError", "MckibbenError", "MeshError", "MissingInputError", "ModelError", "MuscleError", "NoAnswerError", "NotConvergedError", "OtherPlanError", "OutOfRangeError", "OutputError", "ParameterError", "PlotError", "QuantityError", "RangeError", "RubberError", "ShowError", "SpecificationError", "TerminalError", "ToleranceError", "UsageError", "WrongInputError"]
