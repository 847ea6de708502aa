"""The widget of a muscle: sliders that are linked with Python both ways, and the view of the workbench (anywidget)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import anywidget
import numpy as np
import traitlets

from . import _native, _schema
from ._muscle import Muscle
from ._problem import InputError, MckibbenError
from ._quantity import number

if TYPE_CHECKING:
    from ._inputs import MuscleLike, Number
    from ._results import Shape

# What the view needs of a shape.
_ARRAYS = ("r_mm", "z_mm", "max_stretch", "strand_turn_rad", "strand_angle_deg")
_STYLE = """
.mckibben { max-width: 760px; }
.mckibben .stage { position: relative; height: 320px; border: 1px solid #8884; border-radius: 4px; }
.mckibben .stage canvas, .mckibben .stage svg { position: absolute; inset: 0; width: 100%; height: 100%; cursor: grab; }
.mckibben .say { position: absolute; left: 12px; top: 8px; margin: 0; z-index: 1; font-weight: 600; pointer-events: none; }
.mckibben .hint { position: absolute; left: 12px; bottom: 8px; margin: 0; z-index: 1; font-size: .8em; opacity: .7; pointer-events: none; }
.mckibben label { display: grid; grid-template-columns: 13em 1fr 7em; gap: 12px; align-items: center; }
"""


class MuscleWidget(anywidget.AnyWidget):
    """A muscle in a notebook. ``pressure_mpa``, ``contraction`` and the measures that have a slider are traits: what is moved in the notebook has its value
    here, and what is set here is shown there; ``widget.observe(function, "force_n")`` hears of every new pull. Python computes, by ``fe``.
    """

    _esm = _native.widget_script()
    _css = _STYLE
    pressure_mpa = traitlets.Float().tag(sync=True)
    contraction = traitlets.Float().tag(sync=True)
    force_n = traitlets.Float(read_only=True, help="The pull, in N.")
    problem = traitlets.Unicode(read_only=True, help="Why there is no muscle or no answer with these values; empty where there is one.")
    _sliders: Any = traitlets.List().tag(sync=True)
    _shown: Any = traitlets.Dict().tag(sync=True)
    _base: Muscle
    _shape: Shape

    @classmethod
    def _of(cls, muscle: MuscleLike, pressure_mpa: Number, contraction: Number, measures: Sequence[str] | Mapping[str, tuple[float, float] | None]) -> MuscleWidget:
        base = muscle if isinstance(muscle, Muscle) else Muscle(muscle)
        rows = {row["field"]: row for row in _native.ask("measures", {})["measures"]}
        p, e = number("pressure_mpa", pressure_mpa), number("contraction", contraction)
        sliders = [_slider("pressure_mpa", "Pressure P", "MPa", 0.0, max(0.6, 2 * p)), _slider("contraction", "Contraction ε", "", 0.0, max(0.35, 2 * e))]
        values = {}
        for name in measures:
            value, row = getattr(base, name, None), rows.get(name)
            if row is None or not isinstance(value, float):
                raise InputError(f"{name} is no number of this muscle", kind="usage", field="measures", hint="muscle.to_dict() has those that it states")
            low, high = (isinstance(measures, Mapping) and measures[name]) or (0.5 * value, 2 * value)
            values[name] = value
            sliders.append(_slider(name, f"{row['label'].capitalize()} {row.get('symbol') or ''}", _schema.unit(_schema.muscle()[name]) or "", low, high))
        traits = {name: traitlets.Float(value).tag(sync=True) for name, value in values.items()}
        made: MuscleWidget = type(cls.__name__, (cls,), traits)(pressure_mpa=p, contraction=e, _sliders=sliders)
        made._base, made._shape = base, base.shape(p, e)
        made._compute()
        made.observe(made._compute, ["pressure_mpa", "contraction", *values])
        return made

    @property
    def muscle(self) -> Muscle:
        """The muscle with the measures of its sliders."""
        measures: Any = {slider["name"]: getattr(self, slider["name"]) for slider in self._sliders[2:]}
        return self._base.replace(**measures)

    @property
    def shape(self) -> Shape:
        """The deformed muscle, with all that is known of the point: that which is shown."""
        return self._shape

    def _compute(self, _: object = None) -> None:
        try:
            self._shape = shape = self.muscle.shape(self.pressure_mpa, self.contraction)
        except MckibbenError as error:
            self.set_trait("problem", str(error))
            self._shown = {**self._shown, "words": str(error)}
            return
        within = f" ± {float(f'{shape.uncertainty_n:.2g}'):g}" if shape.uncertainty_n else ""
        arrays = {name: np.round(shape.arrays[name], 4).tolist() for name in _ARRAYS}
        sizes = {"rest_length_mm": shape.muscle.length_mm, "rest_radius_mm": shape.muscle.outer_diameter_mm / 2}
        self._shown = {
            "words": f"slack: no pull beyond a contraction of {shape.shape_contraction:.4g}" if shape.slack else f"{shape.force_n:.4g}{within} N",
            "contraction": shape.shape_contraction,
            "shape": {"stations": shape.stations, "across": shape.across, "length_mm": shape.length_mm, "strands": shape.strands, "arrays": arrays, **sizes},
        }
        self.set_trait("problem", "")
        self.set_trait("force_n", shape.force_n)

    def _repr_mimebundle_(self, **options: Any) -> Any:
        """With a picture for where no widget is shown."""
        bundle = super()._repr_mimebundle_(**options)
        data = bundle[0] if isinstance(bundle, tuple) else bundle
        return bundle if data is None else ({**data, "image/svg+xml": self._shape.to_svg()}, {})


def _slider(name: str, label: str, unit: str, low: float, high: float) -> dict[str, Any]:
    return {"name": name, "label": label, "unit": unit, "low": low, "high": high}
