# Written by python/stubs.sh (maturin generate-stubs); do not edit.
import numpy
import numpy.typing
import typing
Array: typing.TypeAlias = numpy.typing.NDArray[numpy.float64]
"""
The compiled half of mckibben; what users call is in the package `mckibben`.
"""

from _typeshed import SupportsGetItem
from os import PathLike
from typing import Any, Final, SupportsFloat, SupportsIndex, final

__all__ = ["LITERATURE", "VERSION", "Formula", "Joint", "Model", "Muscle", "Simulation", "ask", "given", "page_html", "quantities", "quantity", "read", "rollout", "toml", "toml_text", "unit_of", "unlikely", "write_file"]

LITERATURE: Final[str]
"""
The sources that code and data name, BibTeX.
"""

VERSION: Final[str]
"""
The version of the crates, and of the package.
"""

@final
class Formula:
    def __new__(cls, /, name: str, text: str) -> Formula:
        """
        The formula of a file's text.
        """
    def fill(self, /, points: "Array", out: "Array", extrapolate: bool, two_sided: bool, nan: bool) -> None:
        """
        Pulls in N at points: in each row pressure, contraction, wall and diameter. The first one
        outside of the range raises, unless this is not looked at; or it is NaN.
        """

@final
class Joint:
    """
    A joint.
    """
    def __new__(cls, /, request: "dict[str, typing.Any]") -> Joint:
        """
        The joint of its file and those of its muscles.
        """
    def levers(self, /, angle_deg: SupportsFloat | SupportsIndex, nan: bool) -> list[float]:
        """
        At an angle in degrees: torque of spring and weight in N m and its slope in N m/rad, then of
        each muscle its contraction, its moment arm in mm and the slope of that in mm. Beyond the
        range an error, or NaN.
        """
    @property
    def link(self, /) -> tuple[float, float]:
        """
        Moment of inertia in kg m², and damping in N m s/rad.
        """

@final
class Model:
    """
    A model bound to its muscle.
    """
    def answer_pair(self, /, wanted: str, first: SupportsFloat | SupportsIndex, second: SupportsFloat | SupportsIndex, nan: bool) -> tuple[float, list[str]]:
        """
        The answer to one pair of numbers, NaN where it has none and `nan` is true, and what is to
        be said of it.
        """
    def bounds(self, /) -> list[tuple[float, float]]:
        """
        Lowest and highest pressure in MPa of the model, at most the allowed one, and contraction.
        """
    def fill(self, /, wanted: str, first: "Array", second: "Array", out: "Array", slopes: bool, parameters: SupportsGetItem[int, str], nan: bool, warnings: bool = False, progress: Any | None = None) -> list[str]:
        """
        Answers every pair of two lists into `out`, with slopes all numbers of a point one after the
        other. Points without an answer are NaN where `nan` is true, else the first one raises.
        Returns what is to be said of the points, where `warnings` is true.
        """
    @property
    def is_elements(self, /) -> bool:
        """
        Whether a point takes finite elements.
        """
    @property
    def name(self, /) -> str:
        """
        The model's name.
        """
    def solve(self, /, pressures: SupportsGetItem[int, SupportsFloat | SupportsIndex], contractions: SupportsGetItem[int, SupportsFloat | SupportsIndex], nan: bool, progress: Any | None = None) -> "list[dict[str, typing.Any]]":
        """
        All that is known of each point, or why it has no answer.
        """

@final
class Muscle:
    """
    A muscle.
    """
    def __new__(cls, /, request: "dict[str, typing.Any]") -> Muscle:
        """
        The muscle of a request.
        """
    def changed(self, /, values: SupportsGetItem[int, tuple[str, SupportsFloat | SupportsIndex]]) -> Muscle:
        """
        The same with other values of constants and measures, all others held.
        """
    def fields(self, /) -> "dict[str, typing.Any]":
        """
        The fields by which a muscle is given, of this one; those that it does not have are left
        out.
        """
    def model(self, /, request: "dict[str, typing.Any]") -> Model:
        """
        The model that a request names, of this muscle.
        """
    def parameters(self, /) -> list[tuple[str, float]]:
        """
        Constants and measures by which a model has derivatives, with their values.
        """
    def stress(self, /, mode: str, stretches: SupportsGetItem[int, SupportsFloat | SupportsIndex]) -> list[float]:
        """
        Nominal stress in MPa of the rubber at stretches: `uniaxial`, `planar` or `equibiaxial`,
        with plane stress and constant volume.
        """
    @property
    def text(self, /) -> str:
        """
        The text of its file.
        """

@final
class Simulation:
    """
    A drive that is stepped.
    """
    def __new__(cls, /, request: "dict[str, typing.Any]", step_s: SupportsFloat | SupportsIndex, records: bool) -> Simulation:
        """
        The drive of a request of `motion`, with steps of a length in s.
        """
    @property
    def commands(self, /) -> tuple[str, int, bool]:
        """
        What is commanded (`pressure`, `opening` or `position`), how many commands there are, and
        whether a joint is moved.
        """
    def copy(self, /) -> Simulation:
        """
        Another one in the same state.
        """
    def events(self, /) -> "list[dict[str, typing.Any]]":
        """
        What happened: stops, slack, switching and reversals.
        """
    def last(self, /) -> list[float]:
        """
        What was recorded last, in the order of the names.
        """
    def linear(self, /) -> list[float]:
        """
        The linear system about its rest at the first commands: A by its columns, B, and position per
        coordinate.
        """
    @property
    def names(self, /) -> list[str]:
        """
        The names of the numbers that are recorded.
        """
    def numbers(self, /) -> "Array":
        """
        Where it is, as numbers.
        """
    def reset(self, /) -> list[float]:
        """
        Back to the start.
        """
    def restore(self, /, numbers: SupportsGetItem[int, SupportsFloat | SupportsIndex]) -> None:
        """
        Goes to where a simulation of the same drive was, by its numbers.
        """
    def rows(self, /) -> "Array":
        """
        All that was recorded: a row for the start and for each step, one after the other.
        """
    def step(self, /, commands: SupportsGetItem[int, SupportsFloat | SupportsIndex], outside: SupportsFloat | SupportsIndex) -> list[float]:
        """
        One step on, with a command for each of the drive's and a force in N or torque in N m from
        outside; what was recorded at its end.
        """

def ask(command: "str", request: "object", progress: Any | None = None) -> "dict[str, typing.Any]":
    """
    The answer to a request with numbers and the contents of files.

    `progress(done, total)` is called now and then.
    """

def given(command: str, request: "object") -> "dict[str, typing.Any]":
    """
    A request of a command with the files that it names; the caller is warned of numbers that were
    likely meant in another unit.
    """

def page_html(command: str, request: "dict[str, typing.Any]", progress: Any | None = None) -> str:
    """
    A page of a request: of `shape` the deformed muscle, which turns under the mouse, of `build` all
    that is known of a muscle.
    """

def quantities(name: str, text: str) -> list[float]:
    """
    A text such as `0..2.5:0.5 bar` or `1,2,3 bar` as numbers; an interval without a step is cut
    into 20 parts.
    """

def quantity(name: str, text: str) -> float:
    """
    A text such as `2.5 bar` in the unit that a name carries.
    """

def read(path: str | PathLike[str], kind: str) -> "dict[str, typing.Any]":
    """
    A file that users name, as requests hold it: of a person (`text`), a `muscle`, a `table`; or of
    several, with those that it names: a `joint`, a `drive`.
    """

def rollout(simulation: Simulation, steps: SupportsIndex, commands: "Array", out: "Array", nan: bool, progress: Any | None = None) -> None:
    """
    Copies of a simulation, each with its own commands: a row of `commands` for each step of each
    copy in turn, and into `out` what is recorded at the start and the end of each step. Copies run
    side by side. Returns the first step that failed; from there on its copy is NaN.
    """

def toml(name: str, text: str) -> "dict[str, typing.Any]":
    """
    A text in TOML as maps and lists.
    """

def toml_text(tables: "dict[str, typing.Any]") -> str:
    """
    Maps and lists as a text in TOML.
    """

def unit_of(name: str) -> str | None:
    """
    The unit of a name's numbers; none of plain ones.
    """

def unlikely(name: str, number: SupportsFloat | SupportsIndex) -> str | None:
    """
    What is said of a bare number that was likely meant in another unit.
    """

def write_file(path: str | PathLike[str], content: "bytes") -> None:
    """
    Puts a file at its place, whole or not at all.
    """
