"""Every kind of result: pickled, copied, compared, hashed; and the columns of those that hold a table."""

from __future__ import annotations

import copy
import csv
import io
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import polars as pl
import pyarrow as pa
import pytest

import mckibben as mk
from mckibben import _commands

MUSCLE: dict[str, Any] = {"outer_diameter_mm": 50, "wall_mm": 1}
PLAN = """
name = "small"
[tube]
length = "285 mm"
rubber = "paper"
[braid]
angle = "28 deg"
stiffness = "paper"
[sampling]
method = "factorial"
[vary]
tube.outer_diameter = "40,50 mm"
tube.wall_thickness = "1 mm"
[test]
contractions = "0..0.1:0.1"
pressures = "0.1..0.2:0.1 MPa"
"""


def bench(root: Path) -> dict[str, str]:
    """The files of a measured muscle."""
    folder = root / "examples/measured/bench"
    files = {"case": "case.toml", "muscle": "muscle.toml", "points": "points.csv"}
    return {"name": "bench", **{name: (folder / file).read_text("utf-8") for name, file in files.items()}}


# A call for every command of the package; `root` is the repository.
CALLS: dict[str, Callable[[Path], Any]] = {
    "parts_list": lambda root: mk.parts_list(),
    "parts_show": lambda root: mk.parts_show("latex-1/4x3/8in"),
    "measures": lambda root: mk.measures(),
    "build": lambda root: mk.build(**MUSCLE),
    "export": lambda root: mk.export(**MUSCLE, target="c", model="thick-wall"),
    "export_list": lambda root: mk.export_list(),
    "compare": lambda root: mk.compare(root / "examples/tondu2012.toml", models=["ideal"], data=root / "data/tondu2012/static_force_20deg.csv"),
    "contraction": lambda root: mk.contraction(**MUSCLE, force_n=700, pressure_mpa=0.2, model="universal"),
    "curve": lambda root: mk.curve(**MUSCLE, model="universal"),
    "design": lambda root: mk.design(force_n=700, contraction=0.15, max_pressure_mpa=0.25, model="universal"),
    "fit": lambda root: mk.fit(root / "data/campaign/paper.csv", tables=True),
    "fit_report": lambda root: mk.fit_report(),
    "force": lambda root: mk.force(**MUSCLE, pressure_mpa=0.2, contraction=0.1, model="thick-wall"),
    "check_formula": lambda root: mk.check_formula(mk.fit(root / "data/campaign/paper.csv").formula),
    "identify": lambda root: mk.identify(root / "examples/bench.toml", root / "examples/bench.csv", model="thick-wall"),
    "joint": lambda root: mk.joint(root / "examples/elbow.toml", pressures_mpa=[[0.2, 0.1]], angles_deg=[0.0, 10.0], model="universal"),
    "measured": lambda root: mk.measured(cases=[bench(root)]),
    "motion": lambda root: mk.motion(root / "examples/drive.toml", model="universal"),
    "check": lambda root: mk.check(**MUSCLE, model="ideal", pressure_mpa=0.2),
    "plan": lambda root: mk.plan({"name": "small.toml", "text": PLAN}),
    "pressure": lambda root: mk.pressure(**MUSCLE, force_n=700, contraction=0.1, model="universal"),
    "rubber": lambda root: mk.rubber(root / "data/treloar/tension.csv"),
    "fill": lambda root: mk.fill(**MUSCLE, volume_mm3=20_000, load="mass:5kg", model="thick-wall"),
    "shape": lambda root: mk.shape(**MUSCLE, pressure_mpa=0.2, contraction=0.1),
    "simulate": lambda root: mk.simulate(**MUSCLE, pressures_mpa=[0.2], contractions=[0.1]),
    "study": lambda root: mk.study(model="universal"),
    "sweep": lambda root: mk.sweep(3),
    "units": lambda root: mk.units(),
    "validate": lambda root: mk.validate(),
}


@pytest.fixture(scope="module")
def results(root: Path) -> dict[str, Any]:
    # In the order of the calls.
    return {name: call(root) for name, call in CALLS.items()}


def test_every_command_is_asked() -> None:
    assert set(CALLS) == {*_commands.__all__, "units"}


@pytest.mark.parametrize("name", CALLS)
def test_a_result_is_pickled_copied_compared_and_hashed(results: dict[str, Any], name: str) -> None:
    thing = results[name]
    for other in (*(pickle.loads(pickle.dumps(thing, protocol)) for protocol in (2, pickle.HIGHEST_PROTOCOL)), copy.deepcopy(thing), copy.copy(thing)):
        assert type(other) is type(thing) and other == thing and hash(other) == hash(thing) and repr(other) == repr(thing)
        assert other.to_dict() == thing.to_dict()
        assert {thing: 1}[other] == 1
    assert len(repr(thing)) < 900 and thing._repr_html_().startswith("<")
    assert thing != thing.to_dict() and thing != next(r for n, r in results.items() if n != name)


@pytest.mark.parametrize("name", CALLS)
def test_every_field_of_a_result_is_one_too(results: dict[str, Any], name: str) -> None:
    seen = 0
    for field in results[name]:
        value = results[name][field]
        for part in value if isinstance(value, list) else [value]:
            if isinstance(part, mk.Record):
                assert pickle.loads(pickle.dumps(part)) == copy.deepcopy(part) == part and hash(copy.copy(part)) == hash(part)
                seen += 1
    assert seen or name in {"plan", "fit_report", "sweep", "units", "validate"} or not results[name]._nested_


@pytest.mark.parametrize("name", CALLS)
def test_a_result_with_a_table_gives_it_to_data_frames(results: dict[str, Any], name: str) -> None:
    thing = results[name]
    if thing._rows_ is None and not hasattr(thing, "_points"):
        with pytest.raises(AttributeError):
            thing.to_table()
        return
    table = thing.to_table()
    arrow, polars = pa.table(dict(table)), pl.DataFrame(dict(table))
    assert arrow.num_rows == len(table) == len(thing.to_pandas()) == len(polars) > 0
    assert arrow.column_names == table.columns == list(thing.to_pandas().columns)
    # An identity: what a frame gives back is the table again.
    assert mk.Table.of(arrow) == mk.Table.of(polars) == mk.Table.of(table) == mk.Table.of(thing)


def test_what_differs_is_not_equal(root: Path, results: dict[str, Any]) -> None:
    assert results["curve"] != mk.curve(**MUSCLE, model="universal", pressures_mpa=[0.1])
    assert results["identify"] != mk.identify(root / "examples/bench.toml", root / "examples/bench.csv", model="thick-wall", two_sided=True, loss="huber")
    assert results["rubber"].laws[0] != results["rubber"].laws[1]
    assert results["fit"].formula == mk.fit(root / "data/campaign/paper.csv").formula


def test_campaigns_give_results_that_are_pickled(tmp_path: Path) -> None:
    campaign = mk.Campaign(tmp_path / "small.parquet", {"name": "small.toml", "text": PLAN})
    for thing in (campaign.run(), campaign.summary(), campaign):
        assert pickle.loads(pickle.dumps(thing)) == copy.deepcopy(thing) == thing and hash(copy.copy(thing)) == hash(thing)
    # The plan in memory is the same table.
    plan = mk.plan({"name": "small.toml", "text": PLAN})
    assert np.array_equal(campaign.to_pandas()["force_n"], plan.force_n)


def test_a_plan_is_columns(root: Path) -> None:
    plan = mk.plan({"name": "small.toml", "text": PLAN})
    assert plan._data["points"] == len(plan.to_table()) == 8 and plan.failed == 0 and plan.muscles == 2
    own = mk.Muscle.prototype(outer_diameter_mm=40, wall_mm=1).model().force([0.1, 0.2], [[0.0], [0.1]])
    assert np.allclose(plan.force_n[:4], own.ravel(), rtol=1e-9)
    # What the command line writes is the same table, to the last bit.
    text = mk.ask("plan", {"plan": {"name": "small.toml", "text": PLAN}})["table"]
    assert text["name"] == plan.table.name and [float(row["force_n"]) for row in csv.DictReader(io.StringIO(text["text"]))] == plan.force_n.tolist()
