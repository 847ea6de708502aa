"""Commands, their answers and files, tables of users, and what is wrong: each rule once."""

from __future__ import annotations

import copy
import csv
import inspect
import json
import pickle
import pydoc
import sys
from collections.abc import Callable
from decimal import Decimal
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
from numpy.typing import NDArray

import mckibben as mk
from mckibben import _errors, answers

if TYPE_CHECKING:
    from typing_extensions import assert_type
else:

    def assert_type(value: Any, kind: Any) -> Any:
        return value


THIN = mk.Muscle(outer_diameter_mm=50, wall_mm=1, length_mm=285)
THIN_OF = {"muscle": {"file": {"name": "m", "text": THIN.to_toml()}}}
PLAN = {
    "name": "small.toml",
    "text": """
name = "small"
[tube]
length = "285 mm"
[sampling]
method = "factorial"
[vary]
tube.outer_diameter = "40,50 mm"
tube.wall_thickness = "1 mm"
[test]
contractions = "0..0.1:0.1"
pressures = "0.1..0.2:0.1 MPa"
""",
}
SPEC: dict[str, Any] = {
    "force_n": 700,
    "contraction": 0.15,
    "max_pressure_mpa": 0.25,
    "model": "universal",
}
# A call for every command of the package; `root` is the repository.
CALLS: dict[str, Callable[[Path], Any]] = {
    "parts": lambda root: mk.parts("tubes"),
    "part": lambda root: mk.part("latex-1/4x3/8in"),
    "measures": lambda root: mk.measures(),
    "build": lambda root: THIN.build(),
    "export": lambda root: THIN.export("c", model="thick-wall"),
    "check": lambda root: THIN.check(model="ideal", pressure_mpa=0.2),
    "study": lambda root: THIN.study(model="universal"),
    "compare": lambda root: mk.load(root / "examples/tondu2012.toml").compare(
        models=["ideal"], data=root / "data/tondu2012/static_force_20deg.csv"
    ),
    "curve": lambda root: THIN.curve(model="universal"),
    "shape": lambda root: THIN.shape(0.2, 0.1),
    "fill": lambda root: THIN.fill(20_000, load="mass:5kg", model="thick-wall"),
    "simulate": lambda root: THIN.simulate(pressures_mpa=[0.2], contractions=[0.1]),
    "design": lambda root: mk.design(**SPEC),
    "fit": lambda root: mk.fit(
        root / "data/campaign/paper.csv", method="paper", figures=True
    ),
    "formula": lambda root: mk.fit(root / "data/campaign/paper.csv").formula.check(),
    "identify": lambda root: mk.identify(
        root / "examples/bench.toml", root / "examples/bench.csv", model="thick-wall"
    ),
    "fit_rubber": lambda root: mk.fit_rubber(root / "data/treloar/tension.csv"),
    "joint": lambda root: mk.load(root / "examples/elbow.toml").solve(
        pressures_mpa=[[0.2, 0.1]], angles_deg=[0.0, 10.0], model="universal"
    ),
    "export of a joint": lambda root: mk.load(root / "examples/elbow.toml").export(
        "c", model="thick-wall"
    ),
    "motion": lambda root: mk.load(root / "examples/drive.toml").motion(
        model="universal"
    ),
}


@pytest.fixture(scope="module")
def results(root: Path) -> dict[str, Any]:
    return {name: call(root) for name, call in CALLS.items()}


@pytest.mark.parametrize("name", CALLS)
def test_an_answer_is_saved_pickled_copied_compared_and_hashed(
    results: dict[str, Any], name: str, tmp_path: Path
) -> None:
    thing = results[name]
    thing.save(tmp_path / "answer")
    for other in (
        mk.load(tmp_path / "answer"),
        pickle.loads(pickle.dumps(thing)),
        copy.deepcopy(thing),
        copy.copy(thing),
    ):
        assert (
            type(other) is type(thing)
            and other == thing
            and hash(other) == hash(thing)
            and repr(other) == repr(thing)
            and other.to_dict() == thing.to_dict()
        )
    assert (
        thing != thing.to_dict()
        and thing != next(r for n, r in results.items() if n != name)
        and len(str(thing)) < 1500
        and thing._repr_html_().startswith("<")
    )
    assert type(thing).__name__ in answers.__all__ and isinstance(
        thing, getattr(answers, type(thing).__name__)
    )
    assert len(repr(thing)) <= 2000
    if "…" not in repr(thing) and "nan" not in repr(thing):
        assert eval(repr(thing), vars(answers)) == thing
    with pytest.raises(AttributeError):
        thing.model = 1


@pytest.mark.parametrize("name", CALLS)
def test_a_table_of_an_answer_goes_to_data_frames(
    results: dict[str, Any], name: str
) -> None:
    thing = results[name]
    if thing._rows is None:
        with pytest.raises(TypeError):
            thing.to_columns()
        return
    columns = thing.to_columns()
    arrow, polars, pandas = pa.table(columns), pl.DataFrame(columns), thing.to_pandas()
    assert arrow.num_rows == len(pandas) == len(
        polars
    ) > 0 and arrow.column_names == list(pandas.columns) == list(columns)
    assert all(
        list(thing[n]) == list(columns[n]) or columns[n].dtype.kind == "f"
        for n in columns
    )


def test_an_answer_has_the_words_of_json(results: dict[str, Any]) -> None:
    text = {**THIN_OF, "test": "isobaric", "model": "universal"}
    assert (
        results["curve"].to_dict() == json.loads(json.dumps(mk.ask("curve", text)))
        and results["curve"].muscle.wall_mm == 1
        and results["fit"].formula.name
    )
    with pytest.raises(AttributeError):
        results["curve"].pull


def test_a_fit_is_what_its_muscle_pulls(root: Path) -> None:
    """Identities: rms² = Σr²/n, the diagonal of the covariance are the squares of the errors, and r is the pull of the muscle less that of a point."""
    found = mk.identify(
        root / "examples/bench.toml",
        root / "examples/bench.csv",
        free=["tube.material.mu", "braid.stiffness"],
        model="universal",
    )
    r = found.residuals
    assert np.sqrt((r**2).mean()) == pytest.approx(found.rms_n) and np.allclose(
        np.sqrt(np.diag(found.cov)), found["standard_error"]
    )
    pulls = found.identified.force(
        [q.pressure_mpa for q in found.points],
        [q.contraction for q in found.points],
        model="universal",
    )
    assert np.allclose(pulls - [q.force_n for q in found.points], r, atol=1e-6)
    assert f"tube.material.mu {found['value'][0]:.5g} ±" in found.summary()


def test_a_design_goes_through_values_or_between_bounds(
    results: dict[str, Any],
) -> None:
    between = mk.design(**SPEC, outer_diameter_mm=(30, 50))
    assert (
        between
        == mk.design(**SPEC, outer_diameter_mm={"low": 30, "high": 50})
        == mk.design(**SPEC, outer_diameter_mm="30..50 mm")
        == mk.design(**SPEC, outer_diameter_mm=("30 mm", "5 cm"))
    )
    assert {
        c.outer_diameter_mm
        for c in mk.design(**SPEC, outer_diameter_mm=[30, 50]).candidates
    } <= {30.0, 50.0} and 30 < between.best.outer_diameter_mm < 50
    assert str(results["design"]).startswith("Take tube ")
    with pytest.raises(mk.NoAnswerError):
        mk.design(force_n=1e9, contraction=0.1, max_pressure_mpa=0.2).best


def test_bands_are_drawn_as_bands(results: dict[str, Any]) -> None:
    import matplotlib.pyplot as plt

    from mckibben._record import drawn

    axes = results["curve"].plot()
    assert len(axes.lines) >= 5 and "ε" in axes.get_xlabel()
    _, own = plt.subplots()
    assert (
        results["curve"].plot(ax=own, units="bar") is own
        and any("bar" in text.get_text() for text in own.get_legend().get_texts())
        and results["design"].plot() is not None
    )
    # A figure as the program writes it, with two series of its own.
    figure = results["curve"].figure or results["design"].figure
    made = figure.to_dict()
    panel = made["panels"][0]
    line = {**panel["series"][0], "points": [[0, 1], [1, 2]], "style": "line"}
    corners = [[0, 0], [1, 1], [1, 3], [0, 2]]
    band = {**line, "points": corners, "style": "band", "colour": None}
    made["panels"] = [{**panel, "series": [line, band], "marks": []}]
    axes = drawn(type(figure)._read(made), None)
    assert (len(axes.lines), len(axes.patches)) == (1, 1)
    with pytest.raises(TypeError):
        results["shape"].plot()
    plt.close("all")


def test_another_file_is_not_replaced(root: Path, tmp_path: Path) -> None:
    """What is there stays, unless it is empty, the same, or to be overwritten; and no temporary file is left."""
    joint = mk.Joint(
        THIN,
        joint={"radius_mm": 25, "range_deg": (-30, 30)},
        contraction_at_neutral=0.1,
    )
    drive = mk.Drive(
        joint, valve="festo-mh2", command={"pressure_1_mpa": 0.2, "until_s": 1}
    )
    things: list[Any] = [
        THIN,
        mk.Rubber("gent", mu=0.2, jm=30),
        joint,
        drive,
        mk.fit(root / "data/campaign/paper.csv").formula,
        THIN.solve(0.1, 0.1, model="universal"),
        mk.measures(),
    ]
    place = tmp_path / "notes"
    for thing in things:
        place.write_text("what I measured")
        with pytest.raises(FileExistsError, match="overwrite=True"):
            thing.save(place)
        assert place.read_text() == "what I measured"
        thing.save(place, overwrite=True)
        thing.save(place)
        assert mk.load(place) == thing
    assert {path.name for path in tmp_path.iterdir()} == {
        "notes",
        "joint.toml",
        "muscle_1.toml",
    }
    first = THIN.export("python", model="thick-wall").write(tmp_path / "files")
    first.write_text("mine")
    with pytest.raises(FileExistsError):
        THIN.export("python", model="thick-wall").write(tmp_path / "files")
    with pytest.raises(FileNotFoundError):
        THIN.save(tmp_path / "no" / "m.toml")


def test_a_muscle_of_the_library_is_named_where_a_file_may_stand(
    tmp_path: Path,
) -> None:
    muscle = mk.load("lib:dmsp-20-300")
    shown = mk.part("dmsp-20-300").muscle
    assert shown is not None and muscle == mk.Muscle.from_toml(shown.muscle_file.text)
    sides = "".join(
        f'[muscle_{i}]\nfile = "lib:dmsp-20-300"\ncontraction_at_neutral = "8%"\n'
        for i in (1, 2)
    )
    (tmp_path / "joint.toml").write_text(
        f'[joint]\nradius = "20 mm"\nrange = "-45..45 deg"\n{sides}', "utf-8"
    )
    assert (
        mk.load(tmp_path / "joint.toml")
        .solve(pressures_mpa=[[0.3, 0.2]], angles_deg=[0.0], model="thick-wall")
        .points[0]
        .torque_nm
        > 0
    )
    with pytest.raises(mk.MckibbenError, match="did you mean dmsp-20-300"):
        mk.load("lib:dmsp-20-30")


def test_a_formula_is_a_model_and_a_function(root: Path, tmp_path: Path) -> None:
    """By the model of each muscle, one after the other, to the last bits; 0 where a muscle is slack."""
    for method in ("paper", "global"):
        mk.fit(root / "data/campaign/paper.csv", method=method).formula.save(
            tmp_path / method
        )
        formula = mk.load(tmp_path / method)
        rng = np.random.default_rng(3)
        p, e, s, d = (
            rng.uniform(0.05, 0.25, 60),
            rng.uniform(0, 0.2, 60),
            rng.uniform(1, 3, 60),
            rng.uniform(30, 50, 60),
        )
        found = formula(p, e, s, d)
        own = [
            mk.Muscle(outer_diameter_mm=d[i], wall_mm=s[i], length_mm=285).force(
                p[i], e[i], model=formula
            )
            for i in range(60)
        ]
        assert (
            np.allclose(found, own, rtol=1e-12, atol=0)
            and formula("2 bar", "10%", "1 mm", "5 cm") == formula(0.2, 0.1, 1.0, 50.0)
            and formula(p[:5, None, None], e[:4, None], 1.5, d[:3]).shape == (5, 4, 3)
        )
        assert (
            np.isnan(formula(0.2, 0.1, [2.0, 9.0], 40, errors="nan"))[1]
            and np.isfinite(formula(0.2, 0.1, 9.0, 40, extrapolate=True))
            and formula.check().range.wall_mm[0] > 0
        )
        with pytest.raises(mk.OutOfRangeError) as caught:
            formula([0.2, 3.0], 0.1, 2.0, 40)
        assert caught.value.index == 1 and caught.value.field == "pressure_mpa"


def read(path: Path) -> dict[str, Any]:
    """Columns of a file as numbers."""
    rows = list(
        csv.DictReader(
            line
            for line in path.read_text("utf-8").splitlines()
            if not line.startswith("#")
        )
    )

    def several(name: str) -> Any:
        try:
            return np.array([float(row[name]) for row in rows])
        except ValueError:
            return [row[name] for row in rows]

    return {name: several(name) for name in rows[0]}


class Stream:
    """A data frame of a library that nobody knows."""

    def __init__(self, table: Any) -> None:
        self.table = table

    def __arrow_c_stream__(self, requested_schema: object = None) -> Any:
        return self.table.__arrow_c_stream__(requested_schema)


FORMS: dict[str, Any] = {
    "columns": dict,
    "pandas": pd.DataFrame,
    "pandas with arrow": lambda c: pd.DataFrame(c).convert_dtypes(
        dtype_backend="pyarrow"
    ),
    "polars": pl.DataFrame,
    "arrow": pa.table,
    "stream": lambda c: Stream(pa.table(c)),
    "records": lambda c: pd.DataFrame(c).to_records(index=False),
    "index": lambda c: pd.DataFrame(c).set_index(next(iter(c))),
    "series": lambda c: {n: pd.Series(v) for n, v in c.items()},
}


@pytest.mark.parametrize("form", FORMS)
def test_a_data_frame_is_its_file(root: Path, form: str) -> None:
    """The same numbers as from the file, to the last bit."""
    bench, tension = root / "examples/bench.csv", root / "data/treloar/tension.csv"
    muscle = root / "examples/bench.toml"
    assert (
        mk.identify(muscle, FORMS[form](read(bench)), model="thick-wall").parameters
        == mk.identify(muscle, bench, model="thick-wall").parameters
    )
    assert mk.fit_rubber(FORMS[form](read(tension))).laws == mk.fit_rubber(tension).laws


def test_tables_of_people_come_through(root: Path) -> None:
    """Digits, single values, decimal commas, headings by keyword, quantities of pint; a row without its pull is left out and counted."""
    rows: dict[str, Any] = {
        "pressure_mpa": [0.2] * 4,
        "contraction": [0.0, 0.08, 0.15, 0.22],
        "force_n": [483.0, 242.0, 133.00000000000003, 42.0],
    }

    def identified(data: Any, **options: Any) -> Any:
        return mk.identify(
            root / "examples/bench.toml",
            data,
            model="universal",
            free=["mu"],
            **options,
        )

    found = identified(rows)
    assert [p.force_n for p in found.points] == rows["force_n"]
    gaps = {name: [*values[:2], 0.1, *values[2:]] for name, values in rows.items()} | {
        "force_n": [483.0, 242.0, np.nan, 133.00000000000003, 42.0]
    }
    pint = pytest.importorskip("pint")
    same: list[Any] = [
        {**rows, "pressure_mpa": 0.2},
        {n: [repr(v).replace(".", ",") for v in values] for n, values in rows.items()},
        {**rows, "pressure_mpa": np.array([0.2] * 4) * pint.UnitRegistry().MPa},
        gaps,
        pd.DataFrame(gaps),
        {**gaps, "force_n": np.ma.masked_invalid(gaps["force_n"])},
    ]
    for data in same:
        assert np.array_equal(identified(data)["value"], found["value"])
    assert identified(gaps).understood[0].not_filled == 1
    other = pd.DataFrame(
        {
            "P1": [2.0] * 4,
            "x": [100 * e for e in rows["contraction"]],
            "F": rows["force_n"],
        }
    )
    assert (
        np.allclose(
            identified(
                other,
                columns={"pressure": "P1:bar", "contraction": "x:%", "force": "F:N"},
            )["value"],
            found["value"],
            rtol=1e-12,
        )
        and len(identified([rows, rows]).understood) == 2
    )
    bads: list[Any] = [
        3,
        object(),
        [1, 2],
        {"a": [1.0], "b": [1.0, 2.0]},
        pd.DataFrame([[1, 2]], columns=["a", "a"]),
        b"a,b",
    ]
    for bad in bads:
        with pytest.raises((TypeError, ValueError)):
            mk.fit_rubber(bad)


@pytest.mark.parametrize(
    "call, kind",
    [
        (lambda: THIN.force("2.5 furlongs"), mk.InputError),
        (lambda: THIN.force(0.3, model="paper"), mk.OutOfRangeError),
        (lambda: THIN.force(0.3, model="papr"), mk.InputError),
        (lambda: THIN.force(0.3, mesh="a"), mk.InputError),
        (lambda: mk.load("no/such/file.toml"), mk.FileError),
        (lambda: mk.Muscle.from_toml("\0"), mk.InputError),
        (lambda: THIN.pressure(-5), mk.InputError),
        (lambda: THIN.contraction(1e6, 0.2), mk.NoAnswerError),
        (lambda: THIN.curve(model="paper", pressures_mpa=[0.3]), mk.OutOfRangeError),
        (lambda: THIN.curve(pressures_mpa=[]), mk.InputError),
        (lambda: THIN.curve(pressures_mpa="0..1:1e-9 MPa"), mk.InputError),
        (lambda: mk.design(), mk.MckibbenError),
        (lambda: mk.fit({"a": [1.0]}), mk.MckibbenError),
        (lambda: mk.Formula("{}"), mk.InputError),
        (lambda: mk.ask("nothing", {}), mk.InputError),
        (lambda: mk.ask("force", {"presure_mpa": 1}), mk.InputError),
        (lambda: mk.Campaign("no/such.parquet").summary(), mk.FileError),
        (lambda: THIN.replace(end_factor="1 mm"), mk.InputError),
    ],
)
def test_each_family_has_its_exception(call: Any, kind: type[Exception]) -> None:
    with pytest.raises(kind) as caught:
        call()
    error: Any = caught.value
    assert (
        error.message
        and isinstance(error, _errors.KINDS.get(error.kind, mk.InputError))
        and str(pickle.loads(pickle.dumps(error))) == str(error)
    )


@pytest.mark.parametrize(
    "request_",
    [
        {"pressure_mpa": object()},
        {1: 2},
        {"pressure_mpa": {1, 2}},
        {"pressure_mpa": float("inf")},
        {"pressure_mpa": [0.1]},
        {"model": "\ud800"},
        "text",
        [],
        7,
    ],
)
def test_requests_that_are_none(request_: Any) -> None:
    with pytest.raises((TypeError, ValueError)):
        mk.ask("force", request_)


def test_what_python_raises_itself_goes_through(tmp_path: Path) -> None:
    class Raises:
        def __float__(self) -> float:
            raise RuntimeError("no")

    raising: Any = Raises()
    with pytest.raises(RuntimeError):
        mk.Simulation(
            mk.Drive(
                THIN,
                load={"mass_kg": 1},
                valve="festo-mh2",
                command={"pressure_mpa": 0.1, "until_s": 1},
            ),
            0.01,
            model="ideal",
        ).step(raising)
    with pytest.raises(TypeError):
        mk.ask("plan", {"plan": PLAN}, progress=lambda: None)  # type: ignore[arg-type, misc]
    (tmp_path / "a.toml").write_bytes(b"\xff\xfe\x00")
    for path in [
        tmp_path,
        tmp_path / "a.toml",
        "/dev/zero" if sys.platform != "win32" else tmp_path,
    ]:
        with pytest.raises(mk.MckibbenError):
            mk.load(path)


def test_exceptions_are_those_of_python_too() -> None:
    for kind, own in {
        "InputError": ValueError,
        "OutOfRangeError": ValueError,
        "FileError": OSError,
        "NoAnswerError": ValueError,
        "NotConvergedError": ArithmeticError,
        "InternalError": RuntimeError,
    }.items():
        assert issubclass(getattr(mk, kind), mk.MckibbenError) and issubclass(
            getattr(mk, kind), own
        )
    with pytest.raises(FileNotFoundError) as caught:
        mk.identify("no/such.toml", "no.csv")
    assert isinstance(caught.value, mk.FileError)


def test_the_package_lists_its_names() -> None:
    """Help fits on a screen: what is imported is not printed once more. A star takes the same names."""
    names = [
        name
        for name, thing in vars(mk).items()
        if not name.startswith("_") and not inspect.ismodule(thing)
    ]
    assert 26 <= len(names) <= 32 and len(pydoc.render_doc(mk).splitlines()) <= 45
    star: dict[str, Any] = {}
    exec("from mckibben import *", star)
    assert star.keys() >= set(names)
    for name in names:
        thing = getattr(mk, name)
        assert (
            pickle.loads(pickle.dumps(thing)) is thing
            and thing.__doc__
            and (f"``{name}``" in (mk.__doc__ or "") or issubclass(thing, Warning))
        )


def test_formulas_are_models_by_themselves_or_by_their_files(
    root: Path, tmp_path: Path
) -> None:
    """One alone or a list; an object, its file, or its content, with the same numbers."""
    one = mk.fit(root / "data/campaign/paper.csv").formula
    two = mk.Formula(one.to_json(), "two")
    two.save(tmp_path / "two.json")
    content = {"name": "two", "text": one.to_json()}
    forms: list[Any] = [two, str(tmp_path / "two.json"), content]
    pulls = {THIN.force(0.2, 0.1, model=form) for form in [one, *forms]}
    asked = {**THIN_OF, "pressure_mpa": 0.2, "contraction": 0.1, "model": forms[1]}
    assert pulls == {mk.ask("force", asked)["force_n"]}
    for form in forms:
        alone, both = THIN.compare(models=form), THIN.compare(models=["ideal", form])
        assert len(alone["model"]) == 1 and len(both["model"]) == 2
        assert both["model"][1] == alone["model"][0]


def test_a_request_names_files_by_their_paths(root: Path, tmp_path: Path) -> None:
    """A path, and its name and text; of a muscle, its rubber, a model, a table."""
    THIN.save(tmp_path / "m.toml")
    (tmp_path / "r.toml").write_text(mk.Rubber("gent", mu=0.2, jm=30).to_toml())
    point = {"pressure_mpa": "2 bar", "contraction": "28.5 mm", "model": "ideal"}
    whole = mk.ask("force", {**THIN_OF, **point})
    for muscle in (str(tmp_path / "m.toml"), {"file": str(tmp_path / "m.toml")}):
        assert mk.ask("force", {**point, "muscle": muscle}) == whole
    own = THIN.replace(rubber=tmp_path / "r.toml")
    assert own == THIN.replace(rubber=mk.Rubber("gent", mu=0.2, jm=30))
    assert (
        mk.ask(
            "check",
            {
                "muscle": {
                    "file": str(tmp_path / "m.toml"),
                    "rubber": str(tmp_path / "r.toml"),
                }
            },
        )["law"]
        == "gent"
    )
    bench = [root / "examples/bench.toml", root / "examples/bench.csv"]
    thicker = mk.identify(*bench, model="thick-wall", wall_mm="2 mm")
    base = mk.load(bench[0])
    assert (
        thicker.parameters
        == mk.identify(base.replace(wall_mm=2), bench[1], model="thick-wall").parameters
        == mk.identify(base, bench[1], model="thick-wall", wall_mm=2).parameters
        != mk.identify(*bench, model="thick-wall").parameters
    )
    with pytest.raises(TypeError):
        mk.identify(*bench, wal_mm=2)  # type: ignore[call-arg]
    for call, field in (
        (lambda: mk.identify("no.toml", bench[1]), "muscle"),
        (lambda: THIN.force(0.2, model="no.json"), "model"),
        (lambda: THIN.replace(rubber="no.toml"), "rubber"),
    ):
        with pytest.raises(mk.InputError, match="os error 2") as caught:
            call()
        assert caught.value.field == field


def test_each_kind_of_part_is_a_table() -> None:
    for kind in ("tubes", "sleeves", "rubbers", "muscles", "models"):
        answer = mk.parts(kind)
        assert len(answer.to_pandas()) == len(getattr(answer, kind)) > 0


def test_a_bundle_is_no_muscle_unless_it_is_asked_for() -> None:
    """A bound: what `best` answers meets the requirement, alone or, with `count`, as so many."""
    asked = {"force_n": 600, "contraction": 0.15, "max_pressure_mpa": 0.15}
    found = mk.design(**asked)  # type: ignore[arg-type]
    assert found.bundle is not None and found.bundle.muscles > 1
    with pytest.raises(mk.NoAnswerError, match="side by side") as caught:
        _ = found.best
    assert "count" in caught.value.hint
    count = found.bundle.muscles
    bundle = mk.design(**asked, count=count)  # type: ignore[arg-type]
    assert count * bundle.best.force(0.15, 0.15) >= 600
    alone = mk.design(force_n=300, contraction=0.1, max_pressure_mpa=0.25)
    assert alone.best.force(0.25, 0.1) >= 300


def test_keywords_that_make_no_joint_are_no_file() -> None:
    wrong: Any = ({"radius_mm": -25, "range_deg": (-60, 60)}, {"radios_mm": 25})
    for joint in wrong:
        with pytest.raises(mk.InputError) as caught:
            mk.Joint(THIN, joint=joint)
        assert not isinstance(caught.value, OSError)


def test_pressures_of_a_joint_may_be_one() -> None:
    """An identity: of one muscle a number is a list of one list; of two it is said how many there are."""
    spring: Any = {"spring": {"angular_rate": "5 Nm/rad"}}
    one, two = (
        mk.Joint(
            THIN,
            second,
            joint={"radius_mm": 25, "range_deg": (-30, 30)},
            contraction_at_neutral=0.1,
            **({} if second else spring),
        )
        for second in (None, THIN)
    )
    asked: Any = {"angles_deg": 5, "model": "universal"}
    expected = one.solve(pressures_mpa=[[0.2]], **asked).points
    several: Any = (0.2, [0.2], "2 bar", ["2 bar"])
    for given in several:
        assert one.solve(pressures_mpa=given, **asked).points == expected
    with pytest.raises(mk.InputError, match="2 muscles"):
        two.solve(pressures_mpa=several[0], **asked)


@pytest.mark.parametrize("model", ["universal", "fe"])
def test_a_number_that_was_likely_bar_is_told_before_it_fails(model: str) -> None:
    for ask in (
        lambda: THIN.force(2.5, 0.1, model=model, errors="nan"),
        lambda: THIN.force([2.5], 0.1, model=model, errors="nan"),
        lambda: THIN.contraction(100, 2.5, model=model, errors="nan"),
        lambda: THIN.solve(2.5, 0.1, model=model, errors="nan"),
    ):
        with pytest.warns(mk.UnitWarning, match='"2.5 bar"'):
            ask()


@pytest.mark.parametrize("wrong", [float("nan"), float("inf"), -float("inf")])
def test_a_number_that_is_not_finite_is_named(wrong: float) -> None:
    for request, field in (
        ({"pressure_mpa": wrong, "contraction": 0.1}, "pressure_mpa"),
        ({"pressure_mpa": 0.1, "muscle": {"wall_mm": wrong}}, "wall_mm"),
        ({"pressure_mpa": [0.1, wrong]}, "pressure_mpa"),
    ):
        with pytest.raises(mk.InputError, match="not a finite number") as caught:
            mk.ask("force", request)
        assert caught.value.field == field


@pytest.mark.parametrize(
    "command, table",
    [
        ("export-list", "targets"),
    ],
)
def test_a_command_without_a_function_is_asked(command: str, table: str) -> None:
    answer = mk.ask(command, {})
    assert answer[table] and not hasattr(mk, command.replace("-", "_"))


def test_what_is_no_value_is_an_input_error_with_its_field(
    root: Path, tmp_path: Path
) -> None:
    """Whatever it is, and whichever way it goes in; hints are in the words of Python, and a single number is no point of a list."""
    number: Any = Decimal("0.2")
    none: Any = None
    three: Any = 3
    several: Any = [3]
    muscle = mk.Muscle.prototype()
    of: Any = str(root / "examples/biceps.toml")
    elbow = mk.load(root / "examples/elbow.toml", mk.Joint)
    massless = mk.Joint(muscle, joint={"radius_mm": 25}, contraction_at_neutral=0.1)
    simulation = mk.Simulation(
        root / "examples/elbow-drive.toml", 0.01, model="universal"
    )
    rubber = mk.Rubber("neo-hookean", mu=0.1)
    bench = {"pressure_mpa": 0.2, "contraction": [0.0, 0.1], "force_n": [300, 200]}
    calls: dict[str, list[Callable[[], Any]]] = {
        "pressure_mpa": [
            lambda: muscle.force(number, 0.1),
            lambda: muscle.force(none, 0.1),
            lambda: muscle.force(float("nan"), 0.1),
            lambda: muscle.shape(none),
        ],
        "outer_diameter_mm": [
            lambda: muscle.replace(outer_diameter_mm=number),
            lambda: muscle.replace(outer_diameter_mm=[1, 2]),  # type: ignore[arg-type]
            lambda: muscle.replace(outer_diameter_mm=float("inf")),
            lambda: muscle.replace(outer_diameter_mm=np.ma.masked),  # type: ignore[arg-type]
            lambda: muscle.replace(outer_diameter_mm=np.array(None)),  # type: ignore[arg-type]
        ],
        "contraction": [lambda: muscle.force([0.1, 0.2], [0.1, 0.1, 0.1])],
        "muscle_1": [
            lambda: mk.Joint(of, joint={"radius_mm": 25}),
            lambda: elbow.replace(muscle_1=of),
        ],
        "muscle_2": [lambda: elbow.replace(muscle_2=three)],
        "joint": [
            lambda: mk.Joint(muscle, joint=none),
            lambda: massless.linearise([0.2], 0),
        ],
        "valve": [lambda: mk.Drive(muscle, valve="nope", command={"until_s": 1})],
        "load": [lambda: mk.Drive(muscle, load={"mas_kg": 1}, command={"until_s": 1})],
        "link": [lambda: mk.Joint(muscle, joint={"radius_mm": 25}, link={"mas_kg": 1})],
        "rubbers": [lambda: mk.design(force_n=9, contraction=0.1, rubbers=["nope"])],
        "free": [lambda: mk.identify(muscle, bench, free=["nope"])],
        "of": [lambda: mk.Drive(of, command={"pressure_mpa": 0.1})],
        "start": [lambda: mk.Drive(muscle, start=several, command={"until_s": 1})],
        "command": [
            lambda: mk.ask(""),
            lambda: mk.ask(none),
            lambda: mk.Drive(muscle, command={}),
            lambda: mk.Drive(muscle, command=none),
            lambda: simulation.step([2.0, 0.1]),
            lambda: simulation.step([float("nan"), 0.1]),
        ],
        "commands": [lambda: mk.rollout(simulation, "a")],
        "state": [
            lambda: simulation.set_state(np.full(4, np.nan)),
            lambda: simulation.set_state("a"),
        ],
        "force_n": [lambda: simulation.step([0.2, 0.1], force_n=1)],
        "drive": [lambda: mk.Simulation(three, 0.01)],
        "request": [lambda: mk.ask("force", three)],
        "pressures_mpa": [
            lambda: elbow.torque(0.1, 0),  # type: ignore[arg-type]
            lambda: elbow.torque([[0.1, 0.2], 0.1], [0, 1, 2]),
        ],
        "values": [
            lambda: muscle.with_parameters(none),
            lambda: muscle.with_parameters({"nope": 1}),
        ],
        "tube.length": [lambda: muscle.with_parameters({"tube.length": of})],
        "law": [lambda: mk.Rubber(none, c10=0.1), lambda: mk.Rubber(number, c10=0.1)],
        "mode": [lambda: rubber.stress(of, [1.1])],
        "stretch": [lambda: rubber.stress("uniaxial", "a")],
        "text": [lambda: mk.Formula(none)],
        "path": [lambda: mk.load(none), lambda: muscle.save(three)],
        "output": [lambda: mk.Campaign(three)],
        "units": [
            lambda: muscle.curve(pressures_mpa=[0.1], model="ideal").plot(units="x")
        ],
        "with_": [lambda: mk.design(force_n=9, contraction=0.1, with_=["x=1"])],
        "name": [lambda: mk.part("no such part")],
        "model": [
            lambda: muscle.force(0.2, 0.1, model="no such model"),
            lambda: muscle.force(0.2, 0.1, model=three),
            lambda: muscle.solve(0.2, 0.1, model=several),
            lambda: mk.design(force_n=100, contraction=0.1, model=three),
        ],
        "muscle": [
            lambda: mk.identify(three, {}),
            lambda: mk.identify(several, {}),
        ],
        "data": [
            lambda: mk.identify(muscle, {"pressure": [0.1], "contraction": [0.1]}),
            lambda: mk.identify(muscle, {"pressure_mpa": ["a"], "force_n": [1]}),
            lambda: muscle.compare(data={"pressure_mpa": [0.1]}),
        ],
        "jac": [
            lambda: muscle.force(0.2, 0.1, jac=["typo"]),
            lambda: muscle.force(0.2, 0.1, jac=["stiffness"]),
            lambda: muscle.force([0.2], 0.1, jac=[three]),
            lambda: muscle.pressure(100, 0.1, jac=three),
            lambda: elbow.torque([0.2, 0.1], 0, jac=several),
        ],
        "errors": [lambda: muscle.force(0.2, 0.1, errors=three)],
        "dt_s": [lambda: mk.Simulation(root / "examples/elbow-drive.toml", -1)],
    }
    for field, works in calls.items():
        for work in works:
            with pytest.raises(mk.InputError) as caught:
                work()
            assert caught.value.field == field, caught.value
            assert not isinstance(caught.value, OSError)
            assert not str(caught.value).startswith("point")
    for far in ("9 bar", np.array("9 bar")):
        with pytest.raises(mk.OutOfRangeError) as beyond:
            muscle.force(far, 0.1, model="universal")
        assert beyond.value.index is None
    for text in ("{", '{"mckibben": "Curve"}'):
        (tmp_path / "broken.json").write_text(text)
        with pytest.raises(mk.FileError, match="broken.json"):
            mk.load(tmp_path / "broken.json")
    with pytest.raises(mk.InputError) as caught:
        mk.load("lib:nobody")
    assert 'mk.parts("muscles")' in str(caught.value)
    assert not isinstance(caught.value, OSError)


def test_an_error_of_a_name_says_what_there_is() -> None:
    """And the nearest name; of what is no name at all which kind of thing is wanted."""
    muscle, three = mk.Muscle.prototype(), cast(Any, 3)
    asks: list[tuple[Callable[[], Any], str]] = [
        (lambda: muscle.force(0.2, 0.1, jac=["wall_mn"]), "did you mean wall_mm?"),
        (
            lambda: muscle.force([0.2], 0.1, jac="tube.materiel.c10"),
            "did you mean tube.material.c10?",
        ),
        (lambda: muscle.force(0.2, 0.1, jac=["typo"]), "there is outer_diameter_mm, "),
        (lambda: muscle.force(0.2, 0.1, jac=["stiffness"]), "'braid.stiffness'"),
        (lambda: muscle.force(0.2, 0.1, jac=three), "names of constants and measures"),
        (lambda: muscle.force(0.2, 0.1, model=three), "a name, a path or an object"),
        (lambda: mk.identify(three, {}), "a name, a path or an object"),
    ]
    for ask, helps in asks:
        with pytest.raises(mk.InputError) as caught:
            ask()
        assert helps in str(caught.value)


def test_sources_are_whole_references() -> None:
    """Authors, year and DOI are those of the publication, as its publisher states them."""
    muscle = mk.Muscle.prototype().replace(rubber="dragon-skin-30")
    text = muscle.cite("ideal")
    assert text.count("@") == text.count("@software") + text.count("@article")
    assert "@article{chou1996," in text and "{Chou, Ching-Ping and Hannaford" in text
    assert "10.1109/70.481753" in text and "@article{marechal2021," in text
    assert "note = {axisymmetric finite elements" in muscle.cite()


def test_a_plan_in_memory_has_the_points_of_its_campaign(tmp_path: Path) -> None:
    """Whose table is given to a fit as that of any other."""
    held = mk.ask("plan", {"plan": PLAN})["table"]
    table = list(csv.DictReader(held["text"].splitlines()))
    kept = mk.campaign(PLAN, tmp_path / "c.parquet").to_pandas()
    assert [float(row["force_n"]) for row in table] == kept["force_n"].tolist()
    terms = [mk.fit(made).terms for made in (held, tmp_path / "c.parquet")]
    assert terms[0] == terms[1]


def test_columns_and_loaded_objects_have_types(root: Path) -> None:
    """Those who check types see them; the arrays are of these."""
    identified = mk.identify(
        root / "examples/bench.toml", root / "examples/bench.csv", model="thick-wall"
    )
    assert_type(identified["value"], NDArray[np.float64])
    assert_type(identified["name"], "list[str]")
    assert identified["value"].dtype == np.float64
    assert_type(mk.load(root / "examples/elbow.toml", mk.Joint), mk.Joint)
    curve = THIN.curve(model="ideal")
    assert_type(curve["force_n"], NDArray[np.float64])
    assert curve["force_n"].dtype == np.float64
