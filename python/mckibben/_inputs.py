"""Accepted values of each argument type."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from typing import TYPE_CHECKING, Any, Protocol, Union

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike as ArrayLike
    from numpy.typing import NDArray

    from ._formula import Formula
    from ._muscle import Muscle
    from ._rubber import Rubber


class Measured(Protocol):
    """A quantity of pint."""

    @property
    def magnitude(self) -> Any: ...

    def to(self, unit: Any, /) -> Any: ...


# A number in the unit of its name, a text with its unit, or a quantity of pint.
Number = Union[float, int, str, Measured]
# Several; a text may be a range with both ends in, such as "0..2.5:0.5 bar".
Numbers = Union[Sequence[Number], "NDArray[np.floating[Any]]", str, Measured]
# Values to search through: one, several, or all between two as {"low": …, "high": …} or "30..50 mm".
Choice = Union[Number, Numbers, Mapping[str, Number]]
# What a table of a request, and an option, may hold.
Plain = Union[None, bool, Number, "NDArray[np.floating[Any]]", Sequence["Plain"], Mapping[str, "Plain"]]
# An option of a command: besides these a formula, a path, a muscle or a rubber, and a function that is called with the progress.
Option = Union[Plain, "Formula", "PathLike[str]", "Muscle", "Rubber", Sequence[Union["Formula", "PathLike[str]", str]], Callable[[int, int], object]]
# What a model is asked for: anything that NumPy reads as numbers, texts with a unit, quantities of pint.
Floats = Union["ArrayLike", Number, Numbers]
# A path, or the content of the file as {"name": …, "text": …}.
FileLike = Union[str, "PathLike[str]", Mapping[str, str]]
# The same, or a data frame, or columns by name.
TableLike = Union[str, "PathLike[str]", Mapping[str, Any], Any]
FormulaLike = Union[str, "PathLike[str]", Mapping[str, str], "Formula"]
MuscleLike = Union[str, "PathLike[str]", Mapping[str, str], "Muscle"]
