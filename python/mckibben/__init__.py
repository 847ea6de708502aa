"""McKibben pneumatic muscles: finite elements, formulas, design.

Lengths are in mm, pressures in MPa (gauge), forces in N, angles in degrees; every name carries its unit. A text with its unit (``"2.5 bar"``) or a quantity of pint may stand
in the place of a number.

>>> import mckibben as mk
>>> muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=1, length_mm=285)
>>> round(muscle.force("2.5 bar", 0.1), 1)
1545.3

- a muscle: ``Muscle``, its ``Rubber``; ``muscle.force(p, e)``, ``.pressure``, ``.contraction`` answer numbers and arrays, ``.solve`` all that is known of points,
  ``.curve``, ``.shape``, ``.simulate``, ``.fill``, ``.check``, ``.compare``, ``.study``, ``.build``, ``.export``, ``.report``, ``.cite`` the rest
- find one: ``design``; from measurements: ``identify``, ``fit_rubber``, ``measured``
- move it: ``Joint``, ``Drive``, ``Simulation``, ``rollout``
- a formula: ``campaign``, ``plan``, ``fit``, ``Formula``
- what is known: ``parts``, ``part``, ``measures``, ``validate``, ``fit_report``, ``export_targets``
- files: ``load`` reads what ``.save`` of each object wrote; ``ask`` is JSON in and out
- ``mckibben.units`` for pint, ``mckibben.jax`` for JAX, ``mckibben.answers`` for the types of answers
"""

from ._errors import FileError, InputError, InternalError, MckibbenError, MuscleWarning, NoAnswerError, NotConvergedError, OutOfRangeError, UnitWarning
from ._api import design, export_targets, fit, fit_report, fit_rubber, identify, measured, measures, part, parts, plan, validate
from ._campaign import Campaign, campaign
from ._motion import Drive, Joint, Simulation, rollout
from ._muscle import Muscle
from ._native import VERSION as __version__
from ._request import ask
from ._parts import Formula, Rubber, load

__all__ = [
    "__version__", "Campaign", "Drive", "FileError", "Formula", "InputError", "InternalError", "Joint", "MckibbenError", "Muscle", "MuscleWarning", "NoAnswerError", "NotConvergedError",
    "OutOfRangeError", "Rubber", "Simulation", "UnitWarning", "ask", "campaign", "design", "export_targets", "fit", "fit_report", "fit_rubber", "identify", "load", "measured",
    "measures", "part", "parts", "plan", "rollout", "validate",
]
