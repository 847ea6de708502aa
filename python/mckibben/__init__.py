"""McKibben pneumatic muscles: finite elements, formulas, design.

Lengths in mm, pressures in MPa (gauge), forces in N, angles in degrees, as every name says; or texts with their unit (``"2.5 bar"``), or quantities of pint.

>>> import mckibben as mk
>>> muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=1, length_mm=285)
>>> round(muscle.force("2.5 bar", 0.1), 1)
1545.3

- a muscle: ``Muscle``, its ``Rubber``; ``muscle.force(p, e)``, ``.pressure``, ``.contraction`` answer numbers and arrays, ``.solve`` all that is known of points,
  ``.curve``, ``.shape``, ``.simulate``, ``.fill``, ``.check``, ``.compare``, ``.study``, ``.build``, ``.export``, ``.report``, ``.cite`` the rest
- find one: ``design``; from measurements: ``identify``, ``fit_rubber``; move it: ``Joint``, ``Drive``, ``Simulation``, ``rollout``
- a formula: ``campaign``, ``Campaign``, ``fit``, ``Formula``
- what is known: ``parts``, ``part``, ``measures``
- files: ``load`` reads what ``.save`` of each object wrote; ``ask`` is JSON in and out, of every command
- what is wrong: below ``MckibbenError`` are ``InputError``, ``OutOfRangeError``, ``FileError``, ``NoAnswerError``, ``NotConvergedError``, ``InternalError``
- ``mckibben.units`` for pint, ``mckibben.jax`` for JAX, ``mckibben.answers`` for the types of answers
"""

# Each name once more: it is public, and help() does not print all of it.
from . import _native, answers as answers, jax as jax, units as units
from ._errors import (
    FileError as FileError,
    InputError as InputError,
    InternalError as InternalError,
    MckibbenError as MckibbenError,
    MuscleWarning as MuscleWarning,
    NoAnswerError as NoAnswerError,
    NotConvergedError as NotConvergedError,
    OutOfRangeError as OutOfRangeError,
    UnitWarning as UnitWarning,
)
from ._api import (
    design as design,
    fit as fit,
    fit_rubber as fit_rubber,
    identify as identify,
    measures as measures,
    part as part,
    parts as parts,
)
from ._campaign import Campaign as Campaign, campaign as campaign
from ._motion import (
    Drive as Drive,
    Joint as Joint,
    Simulation as Simulation,
    rollout as rollout,
)
from ._muscle import Muscle as Muscle
from ._parts import Formula as Formula, Rubber as Rubber, load as load
from ._request import ask as ask

__version__: str = _native.VERSION
