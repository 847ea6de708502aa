"""Objects: equality, hash, pickle, copies, words for people."""

from __future__ import annotations

import copy
import csv
import io
import json
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import polars as pl
import pyarrow as pa
import pytest

import mckibben as mk


@pytest.fixture(scope="module")
def things(root: Path) -> dict[str, Any]:
    muscle = mk.Muscle.prototype(outer_diameter_mm=50, wall_mm=1)
    fitted = mk.fit(root / "data/campaign/paper.csv")
    return {
        "muscle": muscle,
        "rubber": mk.Rubber("mooney-rivlin", c10="120 kPa", c01=0.0),
        "model": muscle.model("universal", extrapolate=True),
        "fe": muscle.model(mesh="2x8"),
        "formula": fitted.formula,
        "answer": muscle.state(0.2, 0.1, model="ideal"),
        "curve": muscle.curve("isobaric", model="universal"),
        "design": mk.design(force_n=700, contraction=0.15, max_pressure_mpa=0.25, model="universal"),
        "fitted": fitted,
        "shape": muscle.shape(0.2, 0.1),
        "table": mk.Table({"a": [1.0, None], "b": ["x", None]}),
        "campaign": mk.Campaign("some.parquet", {"name": "plan", "text": "x"}),
        "error": mk.OutOfRangeError("outside", kind="out_of_range", hint="inside", field="pressure_mpa", index=3),
    }


def test_pickle_and_copies(things: dict[str, Any]) -> None:
    for name, thing in things.items():
        for other in (pickle.loads(pickle.dumps(thing)), copy.deepcopy(thing), copy.copy(thing)):
            assert type(other) is type(thing), name
            if name == "error":
                assert (str(other), other.index, other.field) == (str(thing), 3, "pressure_mpa")
                continue
            assert other == thing and hash(other) == hash(thing), name
            assert repr(other) == repr(thing), name
    model = pickle.loads(pickle.dumps(things["fe"]))
    assert model.force(0.2, 0.1) == things["fe"].force(0.2, 0.1)


def test_what_differs_is_not_equal(things: dict[str, Any]) -> None:
    muscle = things["muscle"]
    assert muscle != muscle.replace(wall_mm=1.5) and muscle == muscle.replace(wall_mm=1) and muscle != "muscle"
    assert things["model"] != muscle.model("universal") and things["model"] != things["fe"]
    assert things["rubber"] != mk.Rubber("mooney-rivlin", c10=0.11, c01=0.0)
    assert things["answer"] != muscle.state(0.2, 0.11, model="ideal")
    assert len({muscle, muscle.replace(), mk.Muscle.prototype(wall_mm=1)}) == 2


def test_nothing_changes(things: dict[str, Any]) -> None:
    for name, attribute in [("muscle", "wall_mm"), ("rubber", "c10"), ("model", "name"), ("formula", "name"), ("answer", "force_n"), ("table", "a"), ("campaign", "output")]:
        with pytest.raises(AttributeError):
            setattr(things[name], attribute, 1)
    with pytest.raises(ValueError):
        things["curve"].force_n[0] = 1.0


def test_a_muscle_is_its_file(things: dict[str, Any], tmp_path: Path) -> None:
    muscle = mk.Muscle.prototype(outer_diameter_mm=31.4159265358979, wall_mm=2, rubber=things["rubber"], strands=48, strand_area_mm2=0.3, strand_modulus_mpa=2500, strand_strength_n="40 N")
    assert mk.Muscle.from_toml(muscle.to_toml()) == muscle
    muscle.save(tmp_path / "m.toml")
    assert mk.Muscle(tmp_path / "m.toml") == mk.load(str(tmp_path / "m.toml")) == muscle
    assert muscle.parameters["tube.material.c10"] == 0.12
    assert (muscle.state(0.2, 0.1).strand_tension_n or 0) > 0 and "48" in muscle.braid
    assert mk.Muscle(muscle, rubber="dragon-skin-30").rubber == "dragon-skin-30"


def test_constants_are_numbers_of_any_kind() -> None:
    """Equal rubbers have one hash, however their constants were written."""
    ones: list[Any] = [1, 1.0, np.float32(1), np.int64(1), np.array(1.0)]
    rubbers = [mk.Rubber("mooney-rivlin", c10=value, c01=0) for value in ones]
    assert len(set(rubbers)) == 1 and rubbers[0].c10 == 1.0
    ogden = mk.Rubber("ogden", mu=np.array([0.4, 0.01]), alpha=[2, 5])
    assert ogden.mu == (0.4, 0.01) and hash(ogden) == hash(copy.deepcopy(ogden)) and mk.Muscle.prototype(rubber=ogden).force(0.2, 0.1, model="thick-wall") > 0
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    assert mk.Rubber("gent", mu=200 * unit.kPa, jm=30 * unit.dimensionless) == mk.Rubber("gent", mu=0.2, jm=30)


def test_words_for_people(things: dict[str, Any]) -> None:
    assert repr(things["muscle"]).startswith("Muscle(outer_diameter_mm=50, wall_mm=1, length_mm=285, angle_deg=28")
    assert repr(things["rubber"]) == "Rubber(law='mooney-rivlin', c10='120 kPa', c01=0.0)"
    for name, thing in things.items():
        assert len(repr(thing)) < 900, name
        if hasattr(thing, "_repr_html_"):
            page = thing._repr_html_()
            assert page.startswith("<") and len(page) < 400_000, (name, len(page))
    assert "<iframe srcdoc=" in things["muscle"]._repr_html_() and "<iframe" in things["shape"]._repr_html_()
    assert "$$" in (things["formula"]._repr_latex_() or "$$")


def test_texts_of_others_are_no_markup() -> None:
    evil = "</td><script>alert(1)</script>"
    assert "<script>" not in mk.Table({evil: [evil]})._repr_html_()
    assert "<script>" not in mk.Record({evil: evil, "warnings": [evil]})._repr_html_()


def test_answers_have_the_words_of_json(things: dict[str, Any]) -> None:
    answer = things["answer"]
    assert answer.to_dict() == mk.ask("force", {"outer_diameter_mm": 50, "wall_mm": 1, "pressure_mpa": 0.2, "contraction": 0.1, "model": "ideal"})
    assert json.loads(json.dumps(answer.to_dict())) == answer.to_dict()
    assert answer["force_n"] == answer.force_n and "force_n" in answer and dict(answer)["slack"] is False
    assert answer.max_stretch is None and answer.muscle.wall_mm == 1
    with pytest.raises(AttributeError, match="did you mean 'force_n'"):
        answer.force
    with pytest.raises(KeyError):
        answer["nothing"]


def test_tables_become_those_of_others(things: dict[str, Any]) -> None:
    curve = things["curve"]
    pandas, polars, arrow = curve.to_pandas(), pl.DataFrame(dict(curve.to_table())), pa.table(dict(curve.to_table()))
    assert len(pandas) == len(polars) == len(arrow) == len(curve.to_table())
    assert np.array_equal(pandas["force_n"], curve.force_n) and np.array_equal(polars["force_n"].to_numpy(), curve.force_n)
    assert arrow["slack"].to_pylist() == curve.slack.tolist()
    design = things["design"].to_pandas()
    assert list(design["outer_diameter_mm"]) == [c.outer_diameter_mm for c in things["design"].candidates]
    assert [float(row["force_n"]) for row in csv.DictReader(io.StringIO(curve.to_table().to_csv()))] == curve.force_n.tolist()
    with pytest.raises(ValueError):
        mk.Table({"a": [1], "b": [1, 2]})


def test_figures(things: dict[str, Any]) -> None:
    import matplotlib.pyplot as plt

    curve = things["curve"]
    axes = curve.plot()
    assert len(axes.lines) >= 5 and "ε" in axes.get_xlabel() and "MPa" in axes.get_legend().get_texts()[0].get_text()
    _, own = plt.subplots()
    assert curve.plot(ax=own, units="bar") is own
    assert any("bar" in text.get_text() for text in own.get_legend().get_texts())
    assert things["design"].plot() is not None
    with pytest.raises(AttributeError):
        things["answer"].plot()
    plt.close("all")
