"""Figures of answers on the axes of matplotlib."""

from __future__ import annotations

from typing import Any

# Okabe and Ito without the yellow; dashes go with the number, so that lines stay apart in print.
_COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000"]
_DASHES = ["-", "--", "-.", ":"]
_STYLES = {"line": "-", "dashed": "--", "dotted": ":", "dash-dot": "-.", "points": "none"}
# From dark violet over blue and green to ochre.
_RAMP = ["#440154", "#3b528b", "#21918c", "#5ea146", "#be8c14"]


def _series(axis: Any, series: dict[str, Any], number: int, ramp: Any) -> None:
    """One line, row of points, or band."""
    colour = "#808080" if series.get("neutral") else ramp(number) if ramp else _COLOURS[number % len(_COLOURS)]
    # A text that the program writes at the end of a line is in the legend here.
    label = str(series.get("label") or series.get("end_label") or "") or None
    x, y = ([float("nan") if point[i] is None else point[i] for point in series["points"]] for i in (0, 1))
    style = series.get("style", "auto")
    if style == "band":
        axis.fill(x, y, color=colour, alpha=0.2, linewidth=0, label=label)
    else:
        line = _STYLES.get(style, "-" if ramp else _DASHES[number % len(_DASHES)])
        axis.plot(x, y, color=colour, linestyle=line, marker="o" if style == "points" else None, markersize=4, label=label)


def drawn(figure: dict[str, Any], ax: Any) -> Any:
    """The axes with the figure on them."""
    import matplotlib.pyplot as plt
    from matplotlib.colors import LinearSegmentedColormap

    panels = figure["panels"]
    axes = list(ax) if isinstance(ax, (list, tuple)) or hasattr(ax, "flat") else [ax]
    if ax is None:
        columns = max(1, min(figure.get("columns") or 1, len(panels)))
        rows = -(-len(panels) // columns)
        made, grid = plt.subplots(rows, columns, squeeze=False, figsize=(6.4 * columns, 4.4 * rows), layout="constrained")
        axes = list(grid.flat)
        for spare in axes[len(panels):]:
            spare.remove()
        made.suptitle(figure["title"] if len(panels) > 1 else "")
    if len(axes) < len(panels):
        raise ValueError(f"{len(panels)} panels need as many axes, not {len(axes)}")
    for panel, axis in zip(panels, axes):
        numbers = [s.get("colour") if s.get("colour") is not None else i for i, s in enumerate(panel["series"])]
        ramp = LinearSegmentedColormap.from_list("ramp", _RAMP, max(numbers) + 1) if figure.get("palette") == "sequential" else None
        for series, number in zip(panel["series"], numbers):
            _series(axis, series, number, ramp)
        for mark in panel.get("marks", []):
            axis.plot([mark["x"]], [mark["y"]], "o", color="black", markerfacecolor="white", zorder=5)
            axis.annotate(mark["label"], (mark["x"], mark["y"]), textcoords="offset points", xytext=(6, 6))
        axis.set(xlabel=panel["x"]["label"], ylabel=panel["y"]["label"], title=panel["title"] or (figure["title"] if len(panels) == 1 else ""))
        for name, fit in (("x", axis.set_xlim), ("y", axis.set_ylim)):
            if panel[name].get("range"):
                fit(*panel[name]["range"])
            elif panel[name].get("from_zero"):
                low, high = getattr(axis, f"get_{name}lim")()
                fit(min(0.0, low), max(0.0, high))
        axis.grid(visible=True, alpha=0.3)
        if axis.get_legend_handles_labels()[1]:
            axis.legend(fontsize="small")
    return axes[0] if len(panels) == 1 else axes[: len(panels)]
