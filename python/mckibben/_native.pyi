# Written by python/stubs.sh (maturin generate-stubs); do not edit.
import collections.abc
import numpy
import numpy.typing
import typing
"""
The compiled half of mckibben; what users call is in the package `mckibben`.
"""

from _typeshed import SupportsGetItem
from os import PathLike
from typing import Final, SupportsFloat, SupportsIndex, final

__all__ = ["VERSION", "Formula", "Model", "Simulation", "ask", "body_html", "choice", "drive_files", "joint_files", "muscle_fields", "muscle_text", "muscle_with", "parameters", "quantity", "read_formula", "read_table", "read_text", "report_html", "rubber_stress", "schema", "toml", "toml_text", "unit_of", "values", "write_file"]

VERSION: Final[str]
"""
The version of the crates, and of the package.
"""

@final
class Formula:
    """
    A fitted formula.
    """
    def __new__(cls, /, name: str, text: str) -> Formula:
        """
        The formula of a file's text.
        """
    def fill(self, /, points: "numpy.typing.NDArray[numpy.float64]", out: "numpy.typing.NDArray[numpy.float64]", extrapolate: bool, two_sided: bool) -> int | None:
        """
        Pulls in N at points: rows of pressures, contractions, walls and diameters. NaN outside of the range, unless this is not looked at;
        returns the place of the first such point.
        """
    @property
    def range(self, /) -> list[tuple[float, float]]:
        """
        Where it was fitted: pressures in MPa, contractions, walls and diameters in mm, both ends in.
        """

@final
class Model:
    """
    A model bound to its muscle.
    """
    def __new__(cls, /, muscle: "str", request: "dict[str, typing.Any]") -> Model:
        """
        The model that `request` names, of a muscle as the text of its file.
        """
    def fill(self, /, wanted: str, first: "numpy.typing.NDArray[numpy.float64]", second: "numpy.typing.NDArray[numpy.float64]", out: "numpy.typing.NDArray[numpy.float64]", slopes: bool, parameters: SupportsGetItem[int, str], nan: bool, progress: "collections.abc.Callable[[int, int], object] | None" = None) -> int:
        """
        Answers every pair of two lists into `out`, with slopes all numbers of a point one after the other. Returns how many points have no answer (theirs are NaN where `nan` is true, else the first one raises).
        """
    @property
    def is_elements(self, /) -> bool:
        """
        Whether a point takes finite elements: neighbours in a list share their equilibria.
        """
    @property
    def name(self, /) -> str:
        """
        The model's name.
        """
    def one(self, /, wanted: str, first: SupportsFloat | SupportsIndex, second: SupportsFloat | SupportsIndex, nan: bool) -> float:
        """
        The answer to one pair of numbers; NaN where it has none and `nan` is true.
        """

@final
class Simulation:
    """
    A drive that is stepped.
    """
    def __new__(cls, /, request: "dict[str, typing.Any]", step_s: SupportsFloat | SupportsIndex) -> Simulation:
        """
        The drive of a request of `motion`, with steps of a length in s.
        """
    @property
    def commands(self, /) -> tuple[str, int, bool]:
        """
        What is commanded (`pressure`, `opening` or `position`), how many commands there are, and whether a joint is moved.
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
    @property
    def names(self, /) -> list[str]:
        """
        The names of the numbers that are recorded.
        """
    def reset(self, /) -> list[float]:
        """
        Back to the start.
        """
    def rows(self, /) -> "numpy.typing.NDArray[numpy.float64]":
        """
        All that was recorded: a row for the start and for each step.
        """
    def step(self, /, commands: SupportsGetItem[int, SupportsFloat | SupportsIndex], outside: SupportsFloat | SupportsIndex) -> list[float]:
        """
        One step on, with a command for each of the drive's and a force in N or torque in N m from outside; what was recorded at its end.
        """

def ask(command: "str", request: "dict[str, typing.Any]", progress: "collections.abc.Callable[[int, int], object] | None" = None) -> "dict[str, typing.Any]":
    """
    The answer to a request.

    `progress(done, total)` is called now and then.
    """

def body_html(request: "dict[str, typing.Any]") -> str:
    """
    A page with the deformed muscle, which turns under the mouse.
    """

def choice(text: "str", kind: "str", field: "str | None" = None) -> "typing.Any":
    """
    A text such as `30..50 mm` as the values that a design searches through: one, several, or all between two.
    """

def drive_files(name: str, text: str) -> tuple[str, str, list[str]]:
    """
    What a drive file names: `muscle` or `joint`, the name of its file, and its tables.
    """

def joint_files(name: str, text: str) -> list[str]:
    """
    The muscle files that a joint file names.
    """

def muscle_fields(text: "str") -> "dict[str, typing.Any]":
    """
    The fields by which a muscle is given, of this one; those that it does not have are left out.
    """

def muscle_text(request: "dict[str, typing.Any]", rubber: str | None = None) -> str:
    """
    The muscle that a muscle file and fields describe, as the text of a muscle file; with a rubber, the table `tube.material` of one.
    """

def muscle_with(text: "str", values: "dict[str, float]") -> str:
    """
    The muscle with other values of constants and measures, all others held.
    """

def parameters(text: str) -> list[tuple[str, float, str]]:
    """
    Constants and measures of a muscle by which a model has derivatives, with their values and units.
    """

def quantity(text: str, kind: str, field: str | None = None) -> float:
    """
    A text such as `2.5 bar` as a number in mm, MPa, N, degrees, or the unit inside of its kind.
    """

def read_formula(path: str | PathLike[str]) -> str:
    """
    The file of a formula.
    """

def read_table(path: str | PathLike[str]) -> tuple[str, str]:
    """
    A table, whatever program wrote it. Such files may be long.
    """

def read_text(path: str | PathLike[str]) -> str:
    """
    A file written by hand: a muscle, a plan, a joint.
    """

def report_html(request: "dict[str, typing.Any]", progress: "collections.abc.Callable[[int, int], object] | None" = None) -> str:
    """
    A page with all that is known of a muscle.
    """

def rubber_stress(text: "str", mode: "str", stretches: "list[float]") -> list[float]:
    """
    Nominal stress in MPa of the rubber of a muscle at stretches: `uniaxial`, `planar` or `equibiaxial`, with plane stress and constant volume.
    """

def schema() -> "dict[str, typing.Any]":
    """
    Request, answer and error of every command as JSON Schema, and in `$defs` what they refer to.
    """

def toml(name: str, text: str) -> "dict[str, typing.Any]":
    """
    A text in TOML as maps and lists.
    """

def toml_text(tables: "dict[str, typing.Any]") -> str:
    """
    Maps and lists as a text in TOML. Tables, and those in them, have a heading each; maps in these are inline.
    """

def unit_of(name: "str") -> "tuple[str | None, str] | None":
    """
    What a field of a name measures, where a text with a unit may stand in its place, and the unit of its numbers; none for plain numbers.
    """

def values(text: str, kind: str, field: str | None = None) -> list[float]:
    """
    A text such as `0..2.5:0.5bar` or `1,2,3 bar` as numbers; an interval without a step is cut into 20 parts.
    """

def write_file(path: str | PathLike[str], content: "bytes") -> None:
    """
    Puts a file at its place, whole or not at all.
    """
