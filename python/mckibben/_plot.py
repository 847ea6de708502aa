"""Figures of answers on the axes of matplotlib."""

from __future__ import annotations

from typing import Any

# Okabe and Ito without the yellow; dashes go with the number, so that lines stay apart in print.
_COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000"]
_DASHES = ["-", "--", "-.", ":"]
_STYLES = {"line": "-", "dashed": "--", "dotted": ":", "dash-dot": "-."}


def _looks(panel: dict[str, Any], palette: str) -> list[tuple[str, str, str | None]]:
    """Colour, line and marker of every series."""
    ramp = palette == "sequential"
    series = panel["series"]
    numbers = [s.get("colour") if s.get("colour") is not None else i for i, s in enumerate(series)]
    most = max(numbers, default=0)
    out = []
    for s, n in zip(series, numbers):
        colour = "#808080" if s.get("neutral") else _ramp(n / most if most else 0.0) if ramp else _COLOURS[n % len(_COLOURS)]
        style = s.get("style", "auto")
        line = "" if style == "points" else _STYLES.get(style, "-" if ramp else _DASHES[n % len(_DASHES)])
        out.append((colour, line, "o" if style == "points" else None))
    return out


def _ramp(share: float) -> str:
    """From dark violet over blue and green to ochre."""
    stops = [(68, 1, 84), (59, 82, 139), (33, 145, 140), (94, 161, 70), (190, 140, 20)]
    place = share * (len(stops) - 1)
    i = min(int(place), len(stops) - 2)
    low, high = stops[i], stops[i + 1]
    return "#" + "".join(f"{round(a + (b - a) * (place - i)):02x}" for a, b in zip(low, high))


def _label(series: dict[str, Any]) -> str:
    """What the legend calls it: a text that the program writes at the end of a line is in the legend here."""
    return str(series.get("label") or series.get("end_label") or "")


def _points(series: dict[str, Any]) -> tuple[list[float], list[float]]:
    nan = float("nan")
    points = series["points"]
    return [nan if x is None else x for x, _ in points], [nan if y is None else y for _, y in points]


def drawn(figure: dict[str, Any], ax: Any) -> Any:
    """The axes with the figure on them."""
    panels = figure["panels"]
    if ax is None:
        import matplotlib.pyplot as plt

        columns = max(1, min(figure.get("columns") or 1, len(panels)))
        rows = -(-len(panels) // columns)
        made, grid = plt.subplots(rows, columns, squeeze=False, figsize=(6.4 * columns, 4.4 * rows), layout="constrained")
        axes = list(grid.flat)
        for spare in axes[len(panels):]:
            spare.remove()
        if len(panels) > 1:
            made.suptitle(figure["title"])
    else:
        axes = list(ax) if isinstance(ax, (list, tuple)) or hasattr(ax, "flat") else [ax]
        if len(axes) < len(panels):
            raise ValueError(f"{len(panels)} panels need as many axes, not {len(axes)}")
    for panel, axis in zip(panels, axes):
        for series, (colour, line, marker) in zip(panel["series"], _looks(panel, figure.get("palette", "categorical"))):
            x, y = _points(series)
            axis.plot(x, y, color=colour, linestyle=line or "none", marker=marker, markersize=4, label=_label(series) or None)
        for mark in panel.get("marks", []):
            axis.plot([mark["x"]], [mark["y"]], "o", color="black", markerfacecolor="white", zorder=5)
            axis.annotate(mark["label"], (mark["x"], mark["y"]), textcoords="offset points", xytext=(6, 6))
        axis.set_xlabel(panel["x"]["label"])
        axis.set_ylabel(panel["y"]["label"])
        axis.set_title(panel["title"] or (figure["title"] if len(panels) == 1 else ""))
        for name, fit in (("x", axis.set_xlim), ("y", axis.set_ylim)):
            if panel[name].get("range"):
                fit(*panel[name]["range"])
            elif panel[name].get("from_zero"):
                low, high = getattr(axis, f"get_{name}lim")()
                fit(min(0.0, low), max(0.0, high))
        axis.grid(visible=True, alpha=0.3)
        if any(_label(series) for series in panel["series"]):
            axis.legend(fontsize="small")
    return axes[0] if len(panels) == 1 else axes[: len(panels)]
