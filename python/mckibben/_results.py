"""What answers can do besides holding their fields; the generated classes inherit from these."""

from __future__ import annotations

import base64
import csv
import io
import json
import os
from collections.abc import Mapping
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _native
from ._errors import NoAnswerError, of as problem
from ._record import Asked, Record, html_of, of_rows
from ._request import put
from ._values import Fixed

if TYPE_CHECKING:
    import numpy as np
    import pandas
    import xarray
    from numpy.typing import NDArray
    from typing_extensions import Self

    from ._formula import Formula
    from ._muscle import Muscle
    from ._rubber import Rubber


class Points(Fixed):
    """Points of a muscle as arrays of one shape, each an attribute; ``model`` is the model's name.

    ``warned`` has at each point a bit for each of ``warnings``; where ``status`` is not ``ok``, ``cause`` says why.
    """

    model: str
    warnings: list[str]
    if TYPE_CHECKING:
        force_n: NDArray[np.float64]
        pressure_mpa: NDArray[np.float64]
        contraction: NDArray[np.float64]
        status: NDArray[Any]

    @classmethod
    def _of(cls, columns: Mapping[str, Any], model: str, warnings: list[str]) -> Self:
        import numpy as np

        made = object.__new__(cls)
        shape = columns["pressure_mpa"].shape
        # Numbers come first, in the order of the class.
        names = [*dict.fromkeys([*(n for n in cls.__annotations__ if n in columns or n not in ("slack", "status", "cause", "warned")), *columns])]
        for name in names:
            values = columns.get(name)
            made.__dict__[name] = values = np.full(shape, np.nan) if values is None else values
            values.flags.writeable = False
        made.__dict__.update(model=model, warnings=warnings, _names=tuple(names))
        return made

    @property
    def shape(self) -> tuple[int, ...]:
        """That of each array."""
        return self.pressure_mpa.shape

    def __getitem__(self, name: str) -> NDArray[Any]:
        values: NDArray[Any] = self._arrays()[name]
        return values

    def _arrays(self) -> dict[str, Any]:
        """The arrays that hold something."""
        return {name: self.__dict__[name] for name in self.__dict__["_names"] if self.__dict__[name].dtype.kind != "f" or self.__dict__[name].size == 0 or (self.__dict__[name] == self.__dict__[name]).any()}

    def to_columns(self) -> dict[str, Any]:
        """A row for each point, in the order of the last index."""
        return {name: values.ravel() if values.dtype.kind in "fib" else values.ravel().tolist() for name, values in self._arrays().items()}

    def to_dict(self) -> dict[str, Any]:
        """Plain lists by name."""
        return {name: values.tolist() for name, values in self._arrays().items()}

    def to_pandas(self) -> pandas.DataFrame:
        """A row for each point as a ``pandas.DataFrame``."""
        import pandas as pd

        return pd.DataFrame({name: list(v) if isinstance(v, list) else v for name, v in self.to_columns().items()})

    def to_xarray(self) -> xarray.Dataset:
        """A Dataset with the units as attributes. Where pressures and contractions span a grid, these are its dimensions."""
        import xarray as xr

        p, e = self.pressure_mpa, self.contraction
        dims: list[str] = [f"dim_{axis}" for axis in range(p.ndim)]
        coords: dict[str, Any] = {}
        for name, own, other in (("pressure_mpa", p, e), ("contraction", e, p)):
            axes = [axis for axis in range(p.ndim) if p.shape[axis] > 1 and not (own == own.take([0], axis)).all()]
            if len(axes) == 1 and (other == other.take([0], axes[0])).all():
                dims[axes[0]] = name
                coords[name] = own[tuple(slice(None) if axis == axes[0] else 0 for axis in range(p.ndim))]
        out = xr.Dataset({name: (dims, values) for name, values in self._arrays().items() if name not in coords}, coords, {"model": self.model})
        for column in out.variables:
            if unit := _native.unit_of(str(column)):
                out[column].attrs["units"] = unit
        return out

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Writes it as JSON, from which :func:`load` reads the same again. Another file that is there is replaced only with ``overwrite``."""
        held = {"arrays": {n: [None if v != v else v for v in self.__dict__[n].ravel().tolist()] for n in self.__dict__["_names"]}, "shape": list(self.shape)}
        put({path: json.dumps({"mckibben": "Solution", **held, "model": self.model, "warnings": self.warnings}, ensure_ascii=False)}, overwrite)

    @classmethod
    def _load(cls, held: Mapping[str, Any]) -> Self:
        import numpy as np

        kinds = {"slack": np.bool_, "warned": np.int64, "status": np.str_, "cause": object}
        arrays = {n: np.array([np.nan if v is None else v for v in values], dtype=kinds.get(n, np.float64)).reshape(held["shape"]) for n, values in held["arrays"].items()}
        return cls._of(arrays, held["model"], held["warnings"])

    def _key(self) -> Any:
        # Zeros without a sign.
        held = {n: self.__dict__[n] for n in self.__dict__["_names"]}
        return self.model, tuple(self.warnings), self.shape, tuple((n, (v + 0).tobytes() if v.dtype.kind in "fi" else tuple(v.ravel().tolist())) for n, v in held.items())

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self)._of, ({n: self.__dict__[n].copy() for n in self.__dict__["_names"]}, self.model, self.warnings)

    def __repr__(self) -> str:
        some = self.force_n[self.force_n == self.force_n]
        between = f", pull {some.min():.4g} to {some.max():.4g} N" if some.size else ""
        return f"<Solution: {self.model}, {' x '.join(map(str, self.shape)) or 1} points{between}, {int((self.status != 'ok').sum())} without an answer>"

    def _repr_html_(self) -> str:
        return f"<p>{escape(repr(self))}</p>{html_of(self.to_columns())}"


class Curves(Record):
    """A family of curves, its points as columns."""

    fixed: list[float]
    warnings: list[str]

    @classmethod
    def _read(cls, data: Mapping[str, Any], asked: Asked | None = None) -> Self:
        rows = data["points"]
        if rows and all(row["status"] != "ok" for row in rows):
            raise problem({"kind": rows[0]["status"], "message": rows[0]["cause"], "hint": ""})
        return super()._read(data, asked)

    def to_columns(self) -> dict[str, Any]:
        """The points, curve after curve, with what is ``fixed`` on each; a point without an answer is NaN, and its ``status`` and ``cause`` say why."""
        rows, fixed = self.to_dict()["points"], self.fixed
        return of_rows([{"fixed": fixed[i * len(fixed) // len(rows)], **{n: v for n, v in row.items() if n != "model"}, "slack": row.get("slack", False)} for i, row in enumerate(rows)])

    def grid(self, column: str) -> NDArray[np.float64]:
        """A column with one row for each curve."""
        import numpy as np

        return np.asarray(self.to_columns()[column], dtype=np.float64).reshape(len(self.fixed), -1)


class Planned(Record):
    """A plan that was computed."""

    if TYPE_CHECKING:
        table: Any

    def to_columns(self) -> dict[str, Any]:
        """The points."""
        rows = list(csv.DictReader(io.StringIO(self.table.text)))
        return of_rows([{n: v if n in ("status", "cause") else float(v or "nan") for n, v in row.items()} for row in rows])


class Fitting(Record):
    """A fitted formula with all that is known of it."""

    name: str

    @property
    def formula(self) -> Formula:
        """The formula, which is a model and a file."""
        from ._formula import Formula

        held = {n: v for n, v in self.to_dict().items() if n not in ("tables", "figures")}
        return Formula(json.dumps(held, ensure_ascii=False, indent=2) + "\n", self.name)

    def table(self, name: str) -> dict[str, Any]:
        """The columns of one of the intermediate tables that ``fit(…, tables=True)`` asks for, by its name."""
        held = {table["name"]: table for table in self.to_dict().get("tables") or []}
        if name not in held:
            raise KeyError(f"{name}: there is {', '.join(held) or 'no table'}")
        return of_rows([dict(zip(held[name]["header"], row)) for row in held[name]["rows"]])


class Found(Record):
    """Values found by least squares, as other packages name them."""

    if TYPE_CHECKING:
        parameters: list[Any]

    @property
    def names(self) -> list[str]:
        """The names of the values."""
        return [str(p.name) for p in self.parameters]

    @property
    def x(self) -> NDArray[np.float64]:
        """The values found."""
        return self._numbers("value")

    @property
    def stderr(self) -> NDArray[np.float64]:
        """Their standard errors; NaN where the data does not determine one."""
        return self._numbers("standard_error")

    def _numbers(self, name: str) -> NDArray[np.float64]:
        import numpy as np

        return np.array([np.nan if (v := getattr(p, name)) is None else v for p in self.parameters], dtype=np.float64)


class Identified(Found):
    """Constants found in measured points, with their errors."""

    if TYPE_CHECKING:
        correlation: list[list[float]]
        points: list[Any]
        muscle_file: str
        model: str
        rms_n: float
        rms_before_n: float
        max_n: float
        errors_stated: bool
        degrees_of_freedom: int
        warnings: list[str]

    @property
    def cov(self) -> NDArray[np.float64]:
        """Their covariance, in the units of the values."""
        import numpy as np

        return np.array(self.correlation, dtype=np.float64).reshape(len(self.x), len(self.x)) * np.outer(self.stderr, self.stderr)

    @property
    def residuals(self) -> NDArray[np.float64]:
        """Model less measurement of each point, in N."""
        import numpy as np

        return np.array([p.residual_n for p in self.points], dtype=np.float64)

    @property
    def identified(self) -> Muscle:
        """The muscle with the values found."""
        from ._muscle import Muscle

        return Muscle.from_toml(self.muscle_file)

    def summary(self) -> str:
        """What was found, in lines for reading."""
        words = [f"  {p.name} {p.value:.5g}" + ("" if p.half_width_95 is None else f" ± {p.half_width_95:.3g}") + (f" {p.unit}" if p.unit else "") for p in self.parameters]
        head = f"{self.model}: {len(self.points)} points, rms {self.rms_n:.3g} N (before {self.rms_before_n:.3g} N), largest {self.max_n:.3g} N"
        errors = "± half width of 95 %, " + ("by the stated errors" if self.errors_stated else f"by the residuals, {self.degrees_of_freedom} degrees of freedom")
        return "\n".join([head, *words, errors, *(f"note: {text}" for text in self.warnings)])


class FittedLaws(Found):
    """Laws fitted to tests of a rubber; ``x``, ``names`` and ``stderr`` are those of the recommended one."""

    if TYPE_CHECKING:
        laws: list[Any]
        recommended: str | None

    def rubber(self, law: str | None = None) -> Rubber:
        """A law with its constants; the recommended one where none is named."""
        from ._rubber import Rubber

        name = law or self.recommended
        if name is None:
            raise NoAnswerError("no law is stable in a muscle", kind="no_answer", hint="name one")
        for found in self.laws:
            if name in (found.name, found.law):
                constants: dict[str, Any] = {}
                for p in found.parameters:
                    constant = p.name.rsplit(".", 1)[-1]
                    # The terms of Ogden's law are in lists: mu1, mu2 are mu = […].
                    if found.law == "ogden":
                        constants.setdefault(constant.rstrip("0123456789"), []).append(p.value)
                    else:
                        constants[constant] = p.value
                return Rubber(found.law, **constants)
        raise KeyError(name)


class Designed(Record):
    """Ranked muscles, and why others fail."""

    if TYPE_CHECKING:
        muscle_files: list[Any] | None
        decision: list[str] | None

    @property
    def muscles(self) -> list[Muscle]:
        """The candidates as muscles, best first."""
        from ._muscle import Muscle

        return [Muscle.from_toml(file.text) for file in self.muscle_files or []]

    @property
    def best(self) -> Muscle:
        """The first of them."""
        if not self.muscle_files:
            raise NoAnswerError("no muscle fits", kind="no_answer", hint="`closest` and `rejected` say why")
        return self.muscles[0]

    def __str__(self) -> str:
        return "\n".join(self.decision or []) or super().__str__()


class Files(Record):
    """An answer of files."""

    if TYPE_CHECKING:
        files: list[Any]

    def write(self, folder: str | os.PathLike[str], *, overwrite: bool = False) -> Path:
        """Writes the files into a folder, and gives the one to begin with. Another file that is there is replaced only with ``overwrite``."""
        place = Path(folder)
        contents: dict[str | os.PathLike[str], str | bytes] = {place / f.name: base64.b64decode(f.base64) if f.base64 is not None else str(f.text) for f in self.files}
        place.mkdir(parents=True, exist_ok=True)
        put(contents, overwrite)
        return Path(next(iter(contents)))


class Shaped(Record):
    """The deformed muscle. In a notebook it is shown in space."""

    if TYPE_CHECKING:
        arrays: dict[str, list[float]]
        stations: int
        across: int

    def array(self, name: str) -> NDArray[np.float64]:
        """What there is at the nodes, as an array of stations and nodes through the wall; of the strands, one number for each station."""
        import numpy as np

        values = np.asarray(self.arrays[name], dtype=np.float64)
        return values.reshape(self.stations, -1) if values.size == self.stations * self.across else values

    def to_html(self) -> str:
        """A page with the muscle in space, to rotate with the mouse, for use offline."""
        return _native.body_html(self.__dict__["_asked"][1])

    def _frame(self) -> str:
        page = escape(self.to_html(), quote=True)
        return f'<iframe srcdoc="{page}" style="width:100%;max-width:760px;height:430px;border:0" sandbox="allow-scripts" title="muscle"></iframe>'

    def _repr_html_(self) -> str:
        return self._frame() + super()._repr_html_()
