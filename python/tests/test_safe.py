"""What was wrong or dangerous once: bounds and values, measures that are not given, numbers in another unit, what a derivative holds."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import mckibben as mk


def test_two_in_a_tuple_are_bounds_and_a_list_is_its_values() -> None:
    asked: dict[str, Any] = {"force_n": 700, "contraction": 0.15, "max_pressure_mpa": 0.25, "model": "universal"}
    between = mk.design(**asked, outer_diameter_mm=(30, 50))
    assert between == mk.design(**asked, outer_diameter_mm={"low": 30, "high": 50}) == mk.design(**asked, outer_diameter_mm="30..50 mm")
    assert between == mk.design(**asked, outer_diameter_mm=("30 mm", "5 cm"))
    values = mk.design(**asked, outer_diameter_mm=[30, 50])
    assert {c.outer_diameter_mm for c in values.candidates} <= {30.0, 50.0} and 30 < between.best.outer_diameter_mm < 50


def test_a_muscle_is_given_its_geometry() -> None:
    with pytest.raises(mk.InputError, match="wall_mm, length_mm missing"):
        mk.Muscle(outer_diameter_mm=20)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        muscle = mk.Muscle.prototype()
        assert (muscle.outer_diameter_mm, muscle.wall_mm, muscle.length_mm, muscle.angle_deg) == (30, 3, 285, 28)
        assert mk.Muscle.prototype(outer_diameter_mm=50, wall_mm="1 mm") == mk.Muscle(outer_diameter_mm=50, wall_mm=1, length_mm=285)
        assert mk.Muscle(muscle, wall_mm=2) == muscle.replace(wall_mm=2)


@pytest.mark.parametrize(
    "call, unit",
    [
        (lambda: mk.Muscle.prototype(outer_diameter_mm=0.03, wall_mm=0.003, length_mm=0.285), "0.03 m"),
        (lambda: mk.force(mk.Muscle.prototype(), 250, 0.1, model="ideal"), "250 kPa"),
        (lambda: mk.Muscle.prototype().model("ideal").force(250, 0.1), "250 kPa"),
        (lambda: mk.Muscle.prototype().model("ideal").force(250.0, 0.1), "250 kPa"),
        (lambda: mk.Muscle.prototype().model("ideal").contraction(100.0, 6.0), "6 bar"),
        (lambda: mk.Muscle.prototype().model("ideal").force(np.linspace(0, 2.5e5, 3), 0.1), "250000 Pa"),
    ],
)
def test_a_number_that_was_likely_meant_in_another_unit_is_warned_of(call: Any, unit: str) -> None:
    with pytest.warns(mk.UnitWarning, match=unit) as caught:
        call()
    assert caught[0].filename == __file__


def test_what_is_said_with_its_unit_is_not_warned_of() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        mk.Muscle.prototype(outer_diameter_mm="0.9 mm", wall_mm="0.1 mm").model("ideal").force("60 bar", 0.1)


@pytest.mark.parametrize("measure", ["outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "stiffness"])
@pytest.mark.parametrize("name", ["fe", "universal"])
def test_derivatives_by_measures_are_those_of_replace(name: str, measure: str) -> None:
    """Central differences of replace(); their error is O(h²). With k held the one by the diameter is another number."""
    given: dict[str, Any] = {"stiffness": 590.0} if measure == "stiffness" else {}
    muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=2, length_mm=285, **given)
    _, jac = muscle.model(name).force(0.2, [0.05, 0.1], jac=[measure, "tube.outer_diameter"])
    value = getattr(muscle, measure)
    h = 1e-4 * value
    changes: list[dict[str, Any]] = [{measure: value + s * h} for s in (1, -1)]
    high, low = (muscle.replace(**change).model(name).force(0.2, [0.05, 0.1]) for change in changes)
    assert np.allclose(jac[:, 2], (high - low) / (2 * h), rtol=1e-4)
    if measure == "outer_diameter_mm":
        assert (jac[:, 2] > 1.01 * jac[:, 3]).all()


def test_an_interrupted_campaign_is_read(tmp_path: Path, root: Path) -> None:
    """Its points are those of the same muscles in the complete one."""
    pytest.importorskip("pyarrow")

    def stop(done: int, total: int) -> None:
        if done >= 3:
            raise KeyboardInterrupt

    campaign = mk.Campaign(tmp_path / "c.parquet", root / "plans/paper.toml")
    with pytest.raises(KeyboardInterrupt):
        campaign.run(threads=1, progress=stop)
    part = campaign.to_pandas()
    assert 0 < len(part) == campaign.summary().points
    campaign.run(threads=2)
    whole = campaign.to_pandas()
    assert len(whole) > len(part) and set(map(tuple, part[["muscle", "force_n"]].to_numpy())) <= set(map(tuple, whole[["muscle", "force_n"]].to_numpy()))
    assert campaign.run().points_computed == 0
    assert mk.Muscle.prototype().force(0.2, 0.1, model=campaign.fit().formula) > 0


def test_a_quantity_is_given_by_its_name_without_the_unit() -> None:
    """An inch is 25.4 mm by definition. Both names at once, and a number without its unit, are refused."""
    muscle = mk.Muscle(outer_diameter="2 in", wall="1000 um", length="28.5 cm", angle="28 deg")
    assert muscle == mk.Muscle(outer_diameter_mm=50.8, wall_mm=1, length_mm=285, angle_deg=28) == muscle.replace(wall="1 mm")
    assert mk.force(muscle, pressure="2 bar", contraction=0.1, model="ideal") == mk.force(muscle, 0.2, 0.1, model="ideal")
    asked: dict[str, Any] = {"contraction": 0.15, "model": "universal"}
    one = mk.design(force="700 N", max_pressure="2.5 bar", outer_diameter=("30 mm", "5 cm"), **asked)
    assert one == mk.design(force_n=700, max_pressure_mpa=0.25, outer_diameter_mm=(30, 50), **asked)
    wrong: list[tuple[str, dict[str, Any]]] = [("both wall and wall_mm", {"wall": "2 mm", "wall_mm": 2}), ("wall_mm=2", {"wall": 2}), ("has no unit", {"wall": "2"}), ("unexpected keyword", {"wal": "2 mm"})]
    for said, given in wrong:
        with pytest.raises(TypeError, match=said):
            muscle.replace(**given)
    pint = pytest.importorskip("pint")
    assert muscle.replace(wall=0.1 * pint.UnitRegistry().inch).wall_mm == pytest.approx(2.54)
