"""What the package has for its users, behind the libraries that it needs: each module imports only those above it in this list."""

from . import _commands
from ._errors import FileError as FileError, InputError as InputError, InternalError as InternalError, MckibbenError as MckibbenError
from ._errors import NoAnswerError as NoAnswerError, NotConvergedError as NotConvergedError, OutOfRangeError as OutOfRangeError, UnitWarning as UnitWarning
from ._ask import ask as ask, units as units
from ._record import Record as Record
from ._table import Table as Table
from ._model import Model as Model
from ._points import Solution as Solution
from ._rubber import Rubber as Rubber
from ._formula import Formula as Formula
from ._results import Fit as Fit
from ._muscle import Design as Design, Muscle as Muscle
from ._drives import Drive as Drive, Joint as Joint
from ._simulation import Simulation as Simulation
from ._campaign import Campaign as Campaign, campaign as campaign
from ._load import load as load

__all__ = sorted({*_commands.__all__, *(name for name in globals() if not name.startswith("_"))})


def __getattr__(name: str) -> object:
    return getattr(_commands, name)
