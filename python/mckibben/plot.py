"""Figures with matplotlib: axes in, axes out, with the ± of 95 % as bands. ``units`` are those to draw in: ``"bar"``, or ``"psi,lbf,in"``."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from . import _native
from ._base import _any

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from ._answers import JointAnswer, MotionAnswer
    from ._inputs import Numbers, Option
    from ._muscle import Muscle
    from ._parts import Rubber
    from ._results import Curve, Design, Identification
    from ._simulation import Simulation

__all__ = ["curve", "design", "fit", "isobars", "isometric", "isotonic", "joint", "motion", "rubber"]

# Along, up, and its ±, by the kind of test; with the kinds of quantity of the first two.
_AXES = {
    "isobaric": ("contraction", "force_n", "uncertainty_n", "ratio", "force"),
    "isometric": ("pressure_mpa", "force_n", "uncertainty_n", "pressure", "force"),
    "isotonic": ("pressure_mpa", "contraction", "contraction_uncertainty", "pressure", "ratio"),
}


def _axes(ax: Axes | None) -> Axes:
    if ax is None:
        import matplotlib.pyplot as plt

        ax = plt.subplots(layout="constrained")[1]
    return ax


def _size(label: str, kind: str) -> float:
    """How many of our units is one of those of an axis."""
    unit = re.search(r"\[([^\]]+)\]$", label)
    word = unit[1] if unit else "–"
    return 0.01 if word == "%" else 1.0 if kind == "ratio" or word == "–" else _native.quantity(f"1 {word}", kind)


def curve(curve: Curve, ax: Axes | None = None, *, units: str | None = None, band: bool = True) -> Axes:
    """A family of curves, with the ± of each as a band."""
    drawn = 0 if ax is None else len(ax.lines)
    out: Axes = curve.plot(ax=ax, units=units)
    along, up, error, x_kind, y_kind = _AXES[str(curve.test)]
    table = curve.to_table()
    if band and error in table:
        x, y = curve.grid(along) / _size(out.get_xlabel(), x_kind), curve.grid(up) / _size(out.get_ylabel(), y_kind)
        half = curve.grid(error) / _size(out.get_ylabel(), y_kind)
        for line, xs, ys, halves in zip(out.lines[drawn:], x, y, half):
            known = np.isfinite(ys) & np.isfinite(halves) & ~((ys == 0) & (up == "force_n"))
            out.fill_between(xs, np.maximum(ys - halves, 0.0), ys + halves, where=known.tolist(), color=line.get_color(), alpha=0.12, linewidth=0)
    return out


def isobars(muscle: Muscle, pressures_mpa: Numbers | None = None, *, ax: Axes | None = None, units: str | None = None, band: bool = True, **options: Option) -> Axes:
    """Pull over contraction at constant pressures; options as in :meth:`Muscle.curve`."""
    return curve(muscle.curve("isobaric", pressures_mpa=pressures_mpa, **_any(options)), ax, units=units, band=band)


def isometric(muscle: Muscle, contractions: Numbers | None = None, *, ax: Axes | None = None, units: str | None = None, band: bool = True, **options: Option) -> Axes:
    """Pull over pressure at constant contractions; options as in :meth:`Muscle.curve`."""
    return curve(muscle.curve("isometric", contractions=contractions, **_any(options)), ax, units=units, band=band)


def isotonic(muscle: Muscle, forces_n: Numbers | None = None, *, ax: Axes | None = None, units: str | None = None, band: bool = True, **options: Option) -> Axes:
    """Contraction over pressure at constant pulls; options as in :meth:`Muscle.curve`."""
    return curve(muscle.curve("isotonic", forces_n=forces_n, **_any(options)), ax, units=units, band=band)


def design(design: Design, ax: Axes | None = None, *, units: str | None = None) -> Axes:
    """The pulls of the muscles that fit, and what is wanted."""
    out: Axes = design.plot(ax=ax, units=units)
    return out


def fit(found: Identification, ax: Sequence[Axes] | None = None, *, units: str | None = None) -> list[Axes]:
    """Measured points and the fitted model, and what is left over contraction and over pressure."""
    out: list[Axes] = list(found.plot(ax=ax, units=units))
    return out


def joint(answer: JointAnswer, ax: Axes | None = None, *, band: bool = True) -> Axes:
    """Torque over the angle, a line for each pair of pressures."""
    ax, table = _axes(ax), answer.to_table()
    angle, torque = np.asarray(table["angle_deg"]), np.asarray(table["torque_nm"])
    half = np.asarray(table["uncertainty_nm"]) if "uncertainty_nm" in table else np.full(len(angle), np.nan)
    names = [name for name in table if re.fullmatch(r"pressure_\d_mpa", name)]
    pressures = np.stack([np.asarray(table[name]) for name in names], axis=1)
    for pair in dict.fromkeys(map(tuple, pressures.tolist())):
        own = np.flatnonzero((pressures == pair).all(axis=1))
        own = own[np.argsort(angle[own])]
        (line,) = ax.plot(angle[own], torque[own], marker="o" if len(own) == 1 else None, label=", ".join(f"{p:g}" for p in pair) + " MPa")
        if band:
            ax.fill_between(angle[own], torque[own] - half[own], torque[own] + half[own], color=line.get_color(), alpha=0.12, linewidth=0)
    ax.set(xlabel="angle φ [°]", ylabel="torque [N m]")
    ax.grid(visible=True, alpha=0.3)
    ax.legend(fontsize="small")
    return ax


def motion(answer: Union[MotionAnswer, Simulation], ax: Axes | None = None) -> Axes:
    """The angle of a joint, or the contraction of a muscle, over time."""
    ax, table = _axes(ax), answer.to_table()
    is_joint = "angle_deg" in table
    ax.plot(table["time_s"], table["angle_deg" if is_joint else "contraction"])
    ax.set(xlabel="time [s]", ylabel="angle φ [°]" if is_joint else "contraction ratio ε [–]")
    ax.grid(visible=True, alpha=0.3)
    return ax


def rubber(rubber: Rubber, ax: Axes | None = None, *, to_stretch: float = 3.0) -> Axes:
    """Nominal stress over stretch in uniaxial, planar and equibiaxial tension."""
    ax, stretch = _axes(ax), np.linspace(1.0, to_stretch, 200)
    ax.plot(stretch, rubber.stress("uniaxial", stretch), label="uniaxial")
    ax.plot(stretch, rubber.stress("planar", stretch), "--", label="planar")
    ax.plot(stretch, rubber.stress("equibiaxial", stretch), "-.", label="equibiaxial")
    ax.set(xlabel="stretch λ [–]", ylabel="nominal stress [MPa]")
    ax.grid(visible=True, alpha=0.3)
    ax.legend(fontsize="small")
    return ax
