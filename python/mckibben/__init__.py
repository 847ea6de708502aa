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

    from . import jax as jax, plot as plot, torch as torch
    from ._ask import ask as ask, units as units
    from ._campaign import Campaign as Campaign, campaign as campaign
    from ._commands import *
    from ._drives import Drive as Drive, Joint as Joint, Valve as Valve
    from ._errors import *
    from ._formula import Formula as Formula
    from ._load import load as load
    from ._model import Model as Model
    from ._muscle import Muscle as Muscle
    from ._notebook import widget as widget
    from ._parts import Braid as Braid, Friction as Friction, Rubber as Rubber, Terminals as Terminals, Tube as Tube
    from ._points import Solution as Solution, errstate as errstate
    from ._record import Record as Record
    from ._results import Design as Design, Fit as Fit
    from ._simulation import Simulation as Simulation
    from ._table import Table as Table

    __all__: list[str]
    __version__: str

# Nothing is loaded before it is asked for: the import takes some milliseconds.
_PLACES = {
    name: place
    for place, names in {
        "_ask": "ask units",
        "_campaign": "Campaign campaign",
        "_drives": "Drive Joint Valve",
        "_formula": "Formula",
        "_load": "load",
        "_model": "Model",
        "_muscle": "Muscle",
        "_notebook": "widget",
        "_parts": "Braid Friction Rubber Terminals Tube",
        "_points": "Solution errstate",
        "_record": "Record",
        "_results": "Design Fit",
        "_simulation": "Simulation",
        "_table": "Table",
    }.items()
    for name in names.split()
}
# Modules for other libraries, listed where these are installed.
_BRIDGES = ("jax", "torch")


def __getattr__(name: str) -> Any:
    if name == "__version__":
        return import_module("._native", __name__).VERSION
    if name == "__all__":
        # Without the modules for others: their names are those of the libraries themselves.
        return [name for name in __dir__() if name not in _BRIDGES and not name.startswith("_")]
    if name.startswith("_"):
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    if name == "plot":
        return import_module(".plot", __name__)
    if name in _BRIDGES:
        try:
            return import_module(f".{name}", __name__)
        except ImportError as error:
            # No attribute, so that help() and inspect go on to the next one.
            raise AttributeError(f"{__name__}.{name} needs {name}, which cannot be imported: {error}; pip install {name}") from error
    places = [_PLACES[name]] if name in _PLACES else ["_commands", "_errors"]
    for place in places:
        module = import_module(f".{place}", __name__)
        if place in _PLACES.values() or name in module.__all__:
            value = getattr(module, name)
            globals()[name] = value
            return value
    if name.endswith("Error"):
        try:
            return getattr(import_module("._errors", __name__), name)
        except AttributeError:
            pass
    from difflib import get_close_matches

    near = get_close_matches(name, __dir__(), 1)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}" + (f"; did you mean {near[0]!r}?" if near else ""))


def __dir__() -> list[str]:
    from importlib.util import find_spec

    from . import _commands, _errors

    there = [name for name in _BRIDGES if find_spec(name) is not None]
    return sorted({*_PLACES, "plot", *_commands.__all__, *_errors.__all__, "__version__", *there})
