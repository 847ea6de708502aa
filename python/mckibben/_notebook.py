"""Muscles in notebooks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._inputs import MuscleLike, Number
    from ._widget import MuscleWidget


def widget(
    muscle: MuscleLike,
    pressure_mpa: Number = 0.2,
    contraction: Number = 0.0,
    *,
    measures: Sequence[str] | Mapping[str, tuple[float, float] | None] = ("outer_diameter_mm", "wall_mm", "length_mm", "angle_deg"),
) -> MuscleWidget:
    """A muscle in a notebook, in space, with sliders; needs anywidget. What is moved there has its value here, and what is set here is shown there. Python
    computes, by ``fe``.

    Parameters
    ----------
    muscle
        The muscle.
    pressure_mpa : MPa
        Gauge pressure P to begin with.
    contraction : ratio
        Contraction ratio ε to begin with.
    measures
        Measures that have a slider, by the names of :meth:`Muscle.replace`; as a dict with the two ends of each, None for half and twice its value.

    Returns
    -------
    MuscleWidget
        With ``pressure_mpa``, ``contraction`` and the measures to read and set, ``force_n``, ``muscle`` and ``shape`` as they are now, and ``problem``: why there is
        none with these values. ``observe(function, "force_n")`` hears of every new pull.

    Examples
    --------
    ``shown = mk.widget(muscle)``; then ``shown.pressure_mpa = 0.3`` moves the slider.
    """
    try:
        from ._widget import MuscleWidget
    except ImportError as error:
        raise ImportError(f"mckibben.widget needs anywidget, which cannot be imported: {error}; pip install anywidget") from error
    return MuscleWidget._of(muscle, pressure_mpa, contraction, measures)
