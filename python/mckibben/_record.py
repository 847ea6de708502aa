"""Answers as objects: what JSON holds by attribute, and what the generated classes can do besides."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Sequence
from contextlib import suppress
from functools import cache
from typing import TYPE_CHECKING, Any, ClassVar

from . import _native
from ._errors import NoAnswerError, of as problem
from ._request import Fixed, column, listed, numpy as np, put, screen

if TYPE_CHECKING:
    import pandas
    import xarray
    from pathlib import Path

    from matplotlib.axes import Axes
    from numpy.typing import NDArray
    from typing_extensions import Self, dataclass_transform

    from ._muscle import Muscle
    from ._parts import Formula, Rubber
    from ._request import Array, Json, Named, PathLike
else:

    def dataclass_transform(**_: Any) -> Any:
        return lambda kind: kind


# Okabe and Ito without the yellow; dashes go with the number, so that lines stay apart in print.
_COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000"]
_DASHES = ["solid", "dashed", "dashdot", "dotted"]
# Styles that matplotlib calls otherwise.
_STYLES = {"line": "solid", "dash-dot": "dashdot", "points": "none"}
# From dark violet over blue and green to ochre.
_RAMP = ["#440154", "#3b528b", "#21918c", "#5ea146", "#be8c14"]


@dataclass_transform(kw_only_default=True, frozen_default=True)
class Record(Fixed):
    """An answer: a dataclass that does not change; what an answer does not have is None. Two are equal where their fields are.

    ``to_dict()`` is the JSON of the command line. Where an answer holds a table, ``to_columns()`` and ``to_pandas()`` give it, and ``answer["force_n"]`` a column.
    """

    _rows: ClassVar[str | None] = None
    # Which question it answers.
    _asked: ClassVar[Any] = None
    if not TYPE_CHECKING:

        def __init__(self, **fields: Any) -> None:
            self.__dict__.update(fields)

    @classmethod
    def _read(cls, data: Named, asked: Any = None) -> Self:
        """The answer of JSON, and of which question it is."""
        kinds = cls._nested()
        held = {name: _wrapped(kinds.get(name), value) for name, value in data.items()}
        return object.__new__(cls)._hold(_asked=asked, **held)

    @classmethod
    @cache
    def _nested(cls) -> dict[str, type[Record]]:
        """The records that its fields hold, by the names in their annotations."""
        there = vars(sys.modules[cls.__module__])
        return {
            name: there[word]
            for name, kind in cls.__annotations__.items()
            for word in re.findall(r"\b[A-Z]\w+", kind)
            if word in there["__all__"]
        }

    def _fields(self) -> Json:
        # The figure is the same facts once more.
        return {
            name: value
            for name, value in self.__dict__.items()
            if name[0] != "_" and name != "figure"
        }

    def to_dict(self) -> dict[str, Any]:
        """Plain dicts and lists, as the JSON of the command line."""
        text = json.dumps(self._fields(), default=Record._fields)
        return dict(json.loads(text))

    def to_columns(self) -> dict[str, Any]:
        """The columns of its table: NumPy arrays of numbers, lists of texts. ``polars.DataFrame`` and ``pyarrow.table`` take them."""
        if self._rows is None:
            raise TypeError(f"{type(self).__name__} holds no table")
        held: Any = next(filter(None, map(self.to_dict().get, self._rows.split())), [])
        if isinstance(held, list):
            return of_rows(held)
        return {n: column(line) for n, line in held.items() if isinstance(line, list)}

    def __getitem__(self, name: str, /) -> Any:
        return self.to_columns()[name]

    def to_pandas(self: Any) -> pandas.DataFrame:
        """Its table as a ``pandas.DataFrame``."""
        import pandas as pd

        return pd.DataFrame(self.to_columns())

    def _saved(self, path: Any) -> Any:
        data, asked = self._state()
        held = {"mckibben": type(self).__name__, "data": data, "asked": asked}
        return {path: json.dumps(held, ensure_ascii=False)}

    def _state(self) -> tuple[Json, Any]:
        data = self.to_dict()
        if figure := getattr(self, "figure", None):
            data["figure"] = figure.to_dict()
        return data, self._asked

    def __reduce__(self) -> Any:
        return type(self)._read, self._state()

    def _key(self) -> Any:
        return json.dumps(self.to_dict(), sort_keys=True)

    def __repr__(self) -> str:
        return screen(f"{type(self).__name__}({listed(self._fields())})")

    def _repr_html_(self) -> str:
        from html import escape

        table = ""
        # Where it has one, and pandas is there.
        with suppress(ImportError, TypeError):
            table = self.to_pandas().to_html(max_rows=20)
        return f"<pre>{escape(str(self))}</pre>{table}"

    def plot(
        self, *, units: str | None = None, ax: Axes | Sequence[Axes] | None = None
    ) -> Any:
        """Draws its figure with matplotlib, the same as ``--plot`` of the command line, and gives its axes.

        Parameters
        ----------
        units
            Units to draw in: ``bar``, or ``psi,lbf,in``; MPa, N and mm where they are left out.
        ax
            Axes to draw on, or a list of them, one for each panel; new ones where they are left out.
        """
        answer: Any = self
        if not hasattr(self, "figure") or not (answer.figure or self._asked):
            raise TypeError(f"{type(self).__name__} has no figure")
        if units or not answer.figure:
            command, request = self._asked
            asked = {**request, "figure": units or "MPa"}
            answer = self._read(_native.ask(command, asked))
        return drawn(answer.figure, ax)


def _wrapped(kind: type[Record] | None, value: Any) -> Any:
    if kind is None or not isinstance(value, (list, dict)):
        return value
    if isinstance(value, list):
        return [_wrapped(kind, item) for item in value]
    # A map of names to records is no record itself.
    if value and not kind.__annotations__.keys() & value:
        return {name: _wrapped(kind, item) for name, item in value.items()}
    return kind._read(value)


def of_rows(rows: Sequence[Named]) -> Json:
    """The columns of rows; values that are lists or maps themselves are left out."""
    names = dict.fromkeys(
        name
        for row in rows
        for name, value in row.items()
        if not isinstance(value, (list, dict))
    )
    return {name: column([row.get(name) for row in rows]) for name in names}


def _series(axis: Any, series: Any, colour: Any, dash: str) -> None:
    """One line, row of points, or band; a dash is for lines whose style is left to choose."""
    if series.neutral:
        colour = "gray"
    # A text that the program writes at the end of a line is in the legend here.
    label = series.label or series.end_label
    x, y = np.array(series.points, np.float64).reshape(-1, 2).T
    if series.style == "band":
        axis.fill(x, y, color=colour, alpha=0.2, linewidth=0, label=label)
        return
    style = dash if series.style == "auto" else series.style
    line, dot = _STYLES.get(style, style), "o" if style == "points" else None
    axis.plot(x, y, color=colour, ls=line, marker=dot, markersize=4, label=label)


def drawn(figure: Any, ax: Any) -> Any:
    """The axes with the figure on them."""
    import matplotlib.pyplot as plt
    from matplotlib.colors import LinearSegmentedColormap, ListedColormap

    panels = figure.panels
    is_one = len(panels) == 1
    axes = list(np.ravel(ax))
    if ax is None:
        columns = min(figure.columns or 1, len(panels))
        rows = -(-len(panels) // columns)
        size = 6.4 * columns, 4.4 * rows
        made = plt.figure(figsize=size, layout="constrained")
        axes = [made.add_subplot(rows, columns, i + 1) for i in range(len(panels))]
        made.suptitle("" if is_one else figure.title)
    if len(axes) < len(panels):
        raise ValueError(f"{len(panels)} panels need as many axes")
    for panel, axis in zip(panels, axes):
        numbers = [
            i if s.colour is None else s.colour for i, s in enumerate(panel.series)
        ]
        colours: Any = ListedColormap(_COLOURS)
        dashes = _DASHES
        if figure.palette == "sequential":
            colours = LinearSegmentedColormap.from_list("", _RAMP, max(numbers) + 1)
            dashes = _DASHES[:1]
        for series, number in zip(panel.series, numbers):
            dash = dashes[number % len(dashes)]
            _series(axis, series, colours(number % colours.N), dash)
        for mark in panel.marks:
            at = mark.x, mark.y
            axis.plot(*at, "ko", markerfacecolor="white", zorder=5)
            axis.annotate(mark.label, at, (6, 6), textcoords="offset points")
        axis.set_title(panel.title or (figure.title if is_one else ""))
        axis.set(xlabel=panel.x.label, ylabel=panel.y.label)
        for of, limits, limit in (
            (panel.x, axis.get_xlim, axis.set_xlim),
            (panel.y, axis.get_ylim, axis.set_ylim),
        ):
            ends = of.range or ([*limits(), 0.0] if of.from_zero else None)
            if ends:
                limit(min(ends), max(ends))
        axis.grid(visible=True, alpha=0.3)
        if axis.get_legend_handles_labels()[1]:
            axis.legend(fontsize="small")
    return axes[0] if is_one else axes[: len(panels)]


class Solution(Record):
    """Points of a muscle as arrays of one shape, each an attribute; ``model`` is the model's name.

    ``slack`` where the muscle hangs; ``warned`` has at each point a bit for each of ``warnings``; where ``status`` is not ``ok``, ``cause`` says why.
    """

    _rows: ClassVar[str | None] = "force_n"
    # Its pressures with the labels of the question, where that had some.
    _labelled: ClassVar[Any] = None
    model: str
    warnings: list[str]
    slack: NDArray[np.bool_]
    status: NDArray[np.str_]
    cause: NDArray[np.object_]
    warned: NDArray[np.int64]

    @classmethod
    def _read(cls, data: Named, asked: Any = None) -> Self:
        kinds: Any = {"slack": bool, "warned": np.int64, "status": str, "cause": object}
        shape = np.shape(data["pressure_mpa"])
        held = {name: data[name] for name in ("model", "warnings")}
        for name in dict.fromkeys([*cls.__annotations__, *data, *kinds]):
            if name not in held:
                values = data.get(name, [] if name in kinds else np.nan)
                own = np.resize(np.array(values, kinds.get(name, np.float64)), shape)
                own.flags.writeable = False
                held[name] = own
        return object.__new__(cls)._hold(**held)

    def _arrays(self) -> dict[str, NDArray[Any]]:
        """The arrays that hold something; those of no points do."""
        return {
            name: values
            for name, values in self._fields().items()
            if hasattr(values, "dtype")
            and not (values.size and (values != values).all())
        }

    @property
    def shape(self) -> tuple[int, ...]:
        """That of each array."""
        return self.slack.shape

    def __getitem__(self, name: str, /) -> NDArray[Any]:
        return self._arrays()[name]

    def to_dict(self) -> dict[str, Any]:
        """Plain lists by name; None where a point does not have a number."""
        none: Any = None
        out = {"model": self.model, "warnings": self.warnings}
        for name, values in self._arrays().items():
            if values.dtype.kind == "f":
                # Zeros without a sign.
                values = np.where(values == values, values + 0.0, none)
            out[name] = values.tolist()
        return out

    def to_columns(self) -> dict[str, Any]:
        """A row for each point, in the order of the last index."""
        arrays = self._arrays().items()
        return {name: column(values.ravel().tolist()) for name, values in arrays}

    def to_pandas(self) -> pandas.DataFrame:
        """The same as a ``pandas.DataFrame``, with the index of the Series that was asked."""
        import pandas as pd

        index = getattr(self._labelled, "index", None)
        return pd.DataFrame(self.to_columns(), index)

    def to_xarray(self) -> xarray.Dataset:
        """A Dataset with the units as attributes. Where pressures and contractions span a grid, these are its dimensions."""
        import xarray as xr

        arrays = self._arrays()
        p, e = arrays["pressure_mpa"], arrays["contraction"]
        is_plain = self._labelled is None
        whole = xr.DataArray(p if is_plain else self._labelled)
        dims, coords = list(whole.dims), dict(whole.coords)
        pairs = ("pressure_mpa", p, e), ("contraction", e, p)
        for name, own, other in pairs if is_plain else ():
            axes = [axis for axis in range(p.ndim) if np.diff(own, axis=axis).any()]
            if len(axes) == 1 and not np.diff(other, axis=axes[0]).any():
                dims[axes[0]] = name
                coords[name] = np.moveaxis(own, axes[0], -1)[(0,) * (p.ndim - 1)]
        held = {n: (dims, v) for n, v in arrays.items() if n not in coords}
        return _with_units(xr.Dataset(held, coords, {"model": self.model}))

    def __str__(self) -> str:
        arrays = self._arrays()
        some = arrays["force_n"][arrays["status"] == "ok"]
        between = f", pull {some.min():.4g} to {some.max():.4g} N" if some.size else ""
        return f"<Solution: {self.model}, {' x '.join(map(str, self.shape)) or 1} points{between}, {arrays['status'].size - some.size} without an answer>"

    __repr__ = __str__


def _with_units(found: xarray.Dataset) -> xarray.Dataset:
    """The same with the units of its variables as attributes."""
    for key in found.variables:
        if unit := _native.unit_of(str(key)):
            found[key].attrs["units"] = unit
    return found


class JointSolution(Record):
    """Points of a joint, angle after angle for each set of pressures."""

    def grid(self: Any, column: str) -> Array:
        """A column with one row for each set of pressures."""
        held = np.array(self[column], np.float64)
        return held.reshape(-1, len(set(self["angle_deg"])))

    def to_xarray(self) -> xarray.Dataset:
        """A Dataset over sets of pressures (``case``) and angles, with the units as attributes; not of rests, each of which has an angle of its own."""
        import xarray as xr

        held = {n: (("case", "angle_deg"), self.grid(n)) for n in self.to_columns()}
        angles = held.pop("angle_deg")[1][0]
        return _with_units(xr.Dataset(held, {"angle_deg": angles}))


class Curve(Record):
    """A family of curves, its points as columns."""

    @classmethod
    def _read(cls, data: Named, asked: Any = None) -> Self:
        rows = data["points"]
        if rows and all(row["status"] != "ok" for row in rows):
            raise problem(
                {"kind": rows[0]["status"], "message": rows[0]["cause"], "hint": ""}
            )
        return super()._read(data, asked)

    def to_columns(self) -> dict[str, Any]:
        """The points, curve after curve, with what is ``fixed`` on each; a point without an answer is NaN, and its ``status`` and ``cause`` say why."""
        held = self.to_dict()
        rows, fixed = held["points"], held["fixed"]
        of_curve = len(rows) // max(len(fixed), 1)
        columns = of_rows(
            [
                {"fixed": fixed[i // of_curve], **row, "slack": row.get("slack", False)}
                for i, row in enumerate(rows)
            ]
        )
        columns.pop("model", None)
        return columns

    def grid(self: Any, column: str) -> Array:
        """A column with one row for each curve."""
        return np.array(self[column], np.float64).reshape(len(self.fixed), -1)


class Fit(Record):
    """A fitted formula with all that is known of it."""

    @property
    def formula(self) -> Formula:
        """The formula, which is a model and a file."""
        from ._parts import Formula

        held = self.to_dict()
        for name in ("tables", "figures"):
            held.pop(name, None)
        text = json.dumps(held, ensure_ascii=False, indent=2) + "\n"
        return Formula(text, held["name"])


class Identification(Record):
    """Constants found in measured points, with their errors: ``found["name"]``, ``found["value"]``, ``found["standard_error"]`` are arrays of them."""

    @property
    def cov(self: Any) -> Array:
        """Their covariance, in the units of the values."""
        by = np.outer(self["standard_error"], self["standard_error"])
        return np.array(self.correlation, np.float64).reshape(by.shape) * by

    @property
    def residuals(self: Any) -> Array:
        """Model less measurement of each point, in N."""
        return np.array([point.residual_n for point in self.points], np.float64)

    @property
    def identified(self: Any) -> Muscle:
        """The muscle with the values found."""
        from ._muscle import Muscle

        return Muscle.from_toml(self.muscle_file)

    def summary(self: Any) -> str:
        """What was found, in lines for reading."""
        words = [
            f"{self.model}: {len(self.points)} points, rms {self.rms_n:.3g} N (before {self.rms_before_n:.3g} N), largest {self.max_n:.3g} N"
        ]
        for p in self.parameters:
            half = "" if p.half_width_95 is None else f" ± {p.half_width_95:.3g}"
            words.append(f"  {p.name} {p.value:.5g}{half} {p.unit}".rstrip())
        words.append("± half width of 95 %")
        return "\n".join([*words, *(f"note: {w.message}" for w in self.warnings)])


class RubberFit(Record):
    """Laws fitted to tests of a rubber; ``parameters`` are those of the recommended one."""

    def rubber(self: Any, law: str | None = None) -> Rubber:
        """A law with its constants; the recommended one where none is named."""
        from ._parts import Rubber

        name = law or self.recommended
        if name is None:
            raise NoAnswerError("no law is stable in a muscle", hint="name one")
        # The first of a law's name, which may be fitted in several ways.
        found = {key: of for of in self.laws[::-1] for key in (of.law, of.name)}[name]
        constants = {p.name: p.value for p in found.parameters}
        if found.law == "ogden":
            # Its terms are in lists: mu1, mu2 are mu = […].
            constants = {
                kind: [v for name, v in constants.items() if name.startswith(kind)]
                for kind in ("mu", "alpha")
            }
        return Rubber(found.law, **constants)


class Design(Record):
    """Ranked muscles, and why others fail."""

    @property
    def muscles(self: Any) -> list[Muscle]:
        """The candidates as muscles, best first."""
        from ._muscle import Muscle

        return [Muscle.from_toml(file.text) for file in self.muscle_files or []]

    @property
    def best(self: Any) -> Muscle:
        """The first of them."""
        muscles: list[Muscle] = self.muscles
        if self.bundle and not self._asked[1].get("count"):
            raise NoAnswerError(
                f"one muscle is not enough: {self.bundle.muscles} side by side are",
                hint="count=… allows a bundle",
            )
        if not muscles:
            raise NoAnswerError(
                "no muscle fits",
                hint="`closest` and `rejected` say why",
            )
        return muscles[0]

    def __str__(self: Any) -> str:
        return "\n".join(self.decision or []) or repr(self)


class Files(Record):
    """An answer of files."""

    def write(self: Any, folder: PathLike, *, overwrite: bool = False) -> Path:
        """Writes the files into a folder, and gives the one to begin with. Another file that is there is replaced only with ``overwrite``."""
        from base64 import b64decode
        from pathlib import Path

        place = Path(folder)
        contents: dict[Path, str | bytes] = {
            place / f.name: b64decode(f.base64) if f.base64 is not None else str(f.text)
            for f in self.files
        }
        for path in contents:
            path.parent.mkdir(parents=True, exist_ok=True)
        put(contents, overwrite)
        return next(iter(contents))


class Build(Files):
    """All that is needed to build a muscle."""


class Export(Files):
    """A muscle for other programs."""


class JointExport(Files):
    """A joint for other programs."""


class Shape(Record):
    """The deformed muscle. In a notebook it is shown in space."""

    def array(self: Any, name: str) -> Array:
        """What there is at the nodes, as an array of stations and nodes through the wall; of the strands, one number for each station."""
        values = np.array(self.arrays[name], np.float64)
        at_nodes = values.size == self.stations * self.across
        return values.reshape(self.stations, -1) if at_nodes else values

    def to_html(self) -> str:
        """A page with the muscle in space, to rotate with the mouse, for use offline."""
        return _native.page_html("shape", self._asked[1])

    def _frame(self) -> str:
        from html import escape

        page = escape(self.to_html(), quote=True)
        return f'<iframe srcdoc="{page}" style="width:100%;max-width:760px;height:430px;border:0" sandbox="allow-scripts" title="muscle"></iframe>'

    def _repr_html_(self) -> str:
        return self._frame() + super()._repr_html_()
