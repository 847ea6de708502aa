"""McKibben pneumatic muscles: finite elements, formulas, design.

Lengths are in mm, pressures in MPa (gauge), forces in N, angles in degrees; a quantity may also be a text with its unit
(``"2.5 bar"``) or a quantity of pint. Every name carries its unit, and is the same as on the command line and in JSON.

>>> import mckibben as mk
>>> muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=1, length_mm=285)
>>> round(muscle.force("2.5 bar", 0.1), 1)
1545.3
"""

from __future__ import annotations

from importlib import import_module

# What checkers of types know as true; `typing` itself takes longer to import than all else here.
TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from . import jax as jax
    from ._commands import *
    from ._front import *

    __all__: list[str]
    __version__: str


def __getattr__(name: str) -> Any:
    if name == "__version__":
        return import_module("._native", __name__).VERSION
    if name == "jax":
        try:
            return import_module(".jax", __name__)
        except ImportError as error:
            # No attribute, so that help() and inspect go on to the next one.
            raise AttributeError(f"{__name__}.jax needs jax, which cannot be imported: {error}; pip install jax") from error
    if name.startswith("_") and name != "__all__":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    # NumPy and the schema are loaded when something is used first: the import takes some milliseconds.
    front = import_module("._front", __name__)
    if name == "__all__" or name in front.__all__:
        return globals().setdefault(name, getattr(front, name))
    from difflib import get_close_matches

    near = get_close_matches(name, front.__all__, 1)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}" + (f"; did you mean {near[0]!r}?" if near else ""))


def __dir__() -> list[str]:
    from importlib.util import find_spec

    return sorted({*import_module("._front", __name__).__all__, "__version__", *(["jax"] if find_spec("jax") else [])})
