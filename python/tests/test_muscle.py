"""Muscles, rubbers and what they answer: each rule once."""

from __future__ import annotations

import re
import copy
import inspect
import json
import pickle
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import ROOT

import mckibben as mk
from mckibben import _api

GEOMETRY: dict[str, Any] = {"outer_diameter_mm": 50, "wall_mm": 1, "length_mm": 285}
# Fields with a text in another unit, their number, and what must stand beside them.
FIELDS: dict[str, tuple[str, float, dict[str, Any]]] = {
    "outer_diameter_mm": ("3.1 cm", 31.0, {}),
    "wall_mm": ("2500 um", 2.5, {}),
    "length_mm": ("0.3 m", 300.0, {}),
    "density_kg_per_m3": ("0.93 g/cm3", 930.0, {}),
    "temperature_degc": ("60 degC", 60.0, {}),
    "angle_deg": ("25 deg", 25.0, {}),
    "stiffness": ("0.5 kN/mm", 500.0, {}),
    "seating_mm": ("1600 um", 1.6, {}),
    "slip_mm_per_n": ("4 mm/kN", 0.004, {}),
    "grip_mm": ("0.5 cm", 5.0, {}),
    "plug_diameter_mm": ("2.5 cm", 25.0, {}),
    "strand_area_mm2": ("0.003 cm2", 0.3, {"strands": 48, "strand_modulus_mpa": 2500}),
    "strand_strength_n": ("0.04 kN", 40.0, {"strands": 48}),
    "braid_diameter_mm": ("5.1 cm", 51.0, {}),
    "strand_length_mm": ("33 cm", 330.0, {"turns": 1.6}),
}


@pytest.mark.parametrize("name", FIELDS)
def test_a_field_of_a_muscle_is_given_replaced_and_read_back(
    thin: mk.Muscle, name: str
) -> None:
    text, value, beside = FIELDS[name]
    muscle = mk.Muscle(**{**GEOMETRY, **beside, name: value})
    assert getattr(muscle, name) == value and thin.replace(
        **{**beside, name: text}
    ) == muscle == mk.Muscle(**{**GEOMETRY, **beside, name: text})
    with pytest.raises(mk.InputError) as wrong:
        thin.replace(**{**beside, name: "1 candela"})
    assert wrong.value.field == name


def test_every_field_is_an_argument_and_an_attribute() -> None:
    names = set(inspect.signature(mk.Muscle).parameters)
    # Those of `replace`, which are one type of keywords.
    assert names == set(_api.Measures.__annotations__) and len(names) > 35
    assert all(isinstance(getattr(mk.Muscle, name), property) for name in names)


def test_what_is_given_without_its_geometry_or_misspelt_is_a_type_error(
    thin: mk.Muscle,
) -> None:
    make: Any = mk.Muscle
    for given in (
        {"outer_diameter_mm": 20},
        {**GEOMETRY, "grip_nm": 1},
        {**GEOMETRY, "outer_diameter": "2 in"},
    ):
        with pytest.raises(TypeError):
            make(**given)
    ask: Any = thin
    wrong: list[Any] = [
        lambda: ask.force(0.2, 0.1, modle="fe"),
        lambda: ask.contraction([700, 800]),
        lambda: ask.force(),
        lambda: ask.curve(presures_mpa=1),
    ]
    for call in wrong:
        with pytest.raises(TypeError):
            call()


@pytest.mark.parametrize(
    "name, value",
    {
        "outer_diameter_mm": -1,
        "wall_mm": 30,
        "length_mm": 0,
        "angle_deg": 80,
        "strands": 1,
        "density_kg_per_m3": -1,
        "prestretch": 9,
        "crimp": -1,
        "grip_mm": -1,
        "plug_diameter_mm": -2,
        "temperature_degc": 900,
        "stiffness": -3,
        "stiffness_factor": 0.1,
        "rubber": "wood",
        "braid": "nope",
        "end_factor": "1 mm",
    }.items(),
)
def test_a_bad_value_is_an_input_error_of_its_field(name: str, value: Any) -> None:
    with pytest.raises(mk.InputError) as caught:
        mk.Muscle(**{**GEOMETRY, name: value})
    assert caught.value.field == name and not isinstance(caught.value, OSError)


def test_a_bad_rubber_is_an_input_error_of_the_rubber() -> None:
    """Of its argument, and of no place in a file that nobody wrote."""
    bads: list[tuple[str, dict[str, Any]]] = [
        ("law", {"law": "wood", "mu": 1}),
        ("law", {"law": "neo-hookean"}),
        ("mu", {"law": "neo-hookean", "mu": -1}),
        ("mu", {"law": "neo-hookean", "mu": object()}),
        ("m", {"law": "neo-hookean", "m": 1}),
        ("mu", {"law": "gent", "mu": "2 mm", "jm": 3}),
        ("bulk_modulus_mpa", {"law": "gent", "mu": 2, "jm": 3, "bulk_modulus_mpa": -1}),
    ]
    for field, bad in bads:
        with pytest.raises(mk.InputError) as caught:
            mk.Rubber(**bad)
        assert caught.value.field == field and not isinstance(caught.value, OSError)
        assert not re.search(r"\d:\d", str(caught.value))


@pytest.mark.parametrize(
    "given, said",
    [({"angle_deg": 0.49}, "0.49 rad"), ({"outer_diameter_mm": 0.05}, "0.05 m")],
)
def test_a_field_that_was_likely_meant_in_another_unit_is_warned_of(
    given: dict[str, Any], said: str
) -> None:
    with pytest.warns(mk.UnitWarning, match=said) as caught:
        try:
            mk.Muscle(**{**GEOMETRY, **given})
        except mk.InputError:
            pass
    assert caught[0].filename == __file__


@pytest.mark.parametrize(
    "ask",
    [
        lambda m: m.force(2.5, 0.1),
        lambda m: m.force([0.1, 2.5], 0.1),
        lambda m: m.contraction(100, 2.5),
        lambda m: m.curve(pressures_mpa=[2.5], contractions=[0.1]),
    ],
)
def test_a_pressure_in_bar_without_its_unit_is_warned_of(
    thin: mk.Muscle, ask: Any
) -> None:
    with pytest.warns(mk.UnitWarning, match="2.5 bar") as caught:
        ask(thin)
    assert {w.filename for w in caught} == {__file__}


def test_a_text_without_a_unit_is_refused(thin: mk.Muscle) -> None:
    for ask in (
        lambda: thin.force("2.5", 0.1),
        lambda: thin.replace(wall_mm="2"),
        lambda: thin.curve(pressures_mpa="0..2"),
        lambda: mk.ask("force", {"pressure_mpa": "1"}),
    ):
        with pytest.raises(mk.InputError, match="has no unit"):
            ask()
    assert (
        thin.force("2.5 bar", "0.1", model="ideal")
        == thin.force(0.25, 0.1, model="ideal")
        == thin.force("250 kPa", "10%", model="ideal")
    )


def test_numbers_and_arrays_have_the_warnings_of_the_command(
    thin: mk.Muscle, root: Path
) -> None:
    """Those of 2.5 MPa, which nobody meant: once a call, and flags at each point in solve()."""
    answer = mk.ask(
        "force",
        {
            "muscle": {"file": {"name": "m", "text": thin.to_toml()}},
            "pressure_mpa": 2.5,
            "contraction": 0.1,
        },
    )
    said = [warning["message"] for warning in answer["warnings"]]
    kinds = [warning["kind"] for warning in answer["warnings"]]
    of_point = ["strand_strain", "falls_with_pressure"]
    assert set(kinds) == {
        "above_allowed",
        "burst_not_checked",
        "not_measured",
        *of_point,
    }
    assert len(said) == 5
    for ask in (
        lambda: thin.force("2.5 MPa", 0.1),
        lambda: thin.force(2.5, 0.1),
        lambda: thin.force([2.5], 0.1),
        lambda: thin.force([0.1, 2.5], 0.1),
        lambda: thin.solve([0.1, 2.5], 0.1),
    ):
        with pytest.warns(mk.MuscleWarning) as caught:
            ask()
        texts = "; ".join(
            str(w.message) for w in caught if w.category is mk.MuscleWarning
        )
        assert all(text in texts for text in said), texts
    with pytest.warns(mk.MuscleWarning):
        points = thin.solve([0.1, 2.5], 0.1)
    of_last = [
        text for i, text in enumerate(points.warnings) if points.warned[1] >> i & 1
    ]
    assert sorted(of_last) == sorted(said)
    quiet = mk.load(root / "examples/biceps.toml", mk.Muscle)
    quiet = quiet.replace(strands=96, strand_strength_n=100)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        quiet.force([0.1, 0.2], [0.0, 0.1]), quiet.force(0.2, 0.1)
        quiet.solve(0.2, 0.1)


def test_a_muscle_and_a_rubber_are_what_they_print(thin: mk.Muscle) -> None:
    rubber = mk.Rubber("neo-hookean", mu="0.2 MPa")
    own = thin.replace(
        rubber=rubber, strands=48, strand_area_mm2=0.3, strand_modulus_mpa=2500
    )
    for thing in (
        thin,
        rubber,
        own,
        mk.Rubber("ogden", mu=[0.4, 0.01], alpha=[2, 5], bulk_modulus_mpa="1 GPa"),
        mk.load("lib:dmsp-20-300"),
    ):
        assert eval(repr(thing), {"Muscle": mk.Muscle, "Rubber": mk.Rubber}) == thing
    assert (
        own.rubber == rubber
        and isinstance(own.rubber, mk.Rubber)
        and own.rubber.constants == {"mu": 0.2}
        and thin.rubber == "antonelli2018"
    )


def test_constants_are_numbers_of_any_kind() -> None:
    """Equal rubbers have one hash, however their constants were written."""
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    ones: list[Any] = [
        1,
        1.0,
        np.float32(1),
        np.int64(1),
        np.array(1.0),
        "1 MPa",
        1000 * unit.kPa,
    ]
    assert len({mk.Rubber("mooney-rivlin", c10=value, c01=0) for value in ones}) == 1
    aged = mk.Rubber("neo-hookean", mu=0.3, prony=[[0.1, "10 s"]], held="1 h")
    assert (
        mk.Rubber(**aged.to_dict()) == aged == mk.Rubber.from_toml(aged.to_toml())
        and aged.replace(mu=0.4) != aged
    )


def test_stress_of_a_rubber_is_that_of_treloar() -> None:
    """Neo-Hookean, nominal (Treloar 1975): µ(λ − λ⁻²), µ(λ − λ⁻³), µ(λ − λ⁻⁵)."""
    stretch, rubber = (
        np.array([[0.8, 1.0], [1.5, 3.0]]),
        mk.Rubber("neo-hookean", mu="400 kPa"),
    )
    modes: list[tuple[Any, int]] = [("uniaxial", 2), ("planar", 3), ("equibiaxial", 5)]
    for mode, power in modes:
        assert np.allclose(
            rubber.stress(mode, stretch), 0.4 * (stretch - stretch**-power), rtol=1e-12
        )
    with pytest.raises(mk.InputError):
        rubber.stress("uniaxial", [-1.0])


@pytest.mark.parametrize(
    "path",
    [
        path
        for path in sorted((ROOT / "examples").glob("*.toml"))
        if "[tube]" in path.read_text("utf-8")
    ],
    ids=lambda path: path.stem,
)
def test_a_muscle_is_made_of_its_file_its_dict_and_its_pickle(
    path: Path, tmp_path: Path
) -> None:
    muscle = mk.load(path)
    muscle.save(tmp_path / "m.toml")
    given = json.loads(json.dumps(muscle.to_dict()))
    given |= (
        {"rubber": mk.Rubber(**given["rubber"])}
        if isinstance(given.get("rubber"), dict)
        else {}
    )
    made = mk.Muscle.from_toml(given["toml"]) if "toml" in given else mk.Muscle(**given)
    for other in (
        made,
        mk.load(tmp_path / "m.toml"),
        pickle.loads(pickle.dumps(muscle)),
        copy.deepcopy(muscle),
    ):
        assert (
            other == muscle
            and hash(other) == hash(muscle)
            and other.to_toml() == muscle.to_toml()
        )
    with pytest.raises(AttributeError):
        muscle.wall_mm = 1


def test_a_citation_names_package_model_and_data(thin: mk.Muscle) -> None:
    text = thin.replace(rubber="dragon-skin-30").cite("universal")
    sleeve = mk.Muscle(
        outer_diameter_mm=25,
        wall_mm=1,
        length_mm=285,
        braid="nfl-19",
        strands=96,
        strand_diameter_mm=0.25,
        strand_modulus_mpa=3000,
        rubber="shore:40A",
    )
    assert "tandukion" in sleeve.cite("ideal") and "mckibben_rubber" not in sleeve.cite(
        "ideal"
    )
    assert (
        text.count("@") >= 3
        and "@article{marechal2021," in text
        and mk.__version__ in text
        and mk.part("dragon-skin-30").rubber is not None
    )


def test_a_notebook_shows_a_muscle(thin: mk.Muscle, tmp_path: Path) -> None:
    assert (
        "<iframe srcdoc=" in thin._repr_html_()
        and "<iframe" in thin.shape("2 bar", "10%")._repr_html_()
    )
    assert (
        thin.report(tmp_path / "r.html", pressure_mpa="2 bar").startswith(
            "<!DOCTYPE html>"
        )
        and (tmp_path / "r.html").exists()
    )
    assert thin.shape(0.2, 0.1).array("r_mm").ndim == 2


def test_the_generated_api_has_plain_functions() -> None:
    for owner in (_api.MuscleCommands, _api.JointCommands, _api.DriveCommands):
        for name, made in vars(owner).items():
            assert (
                name.startswith("_")
                or inspect.isfunction(made)
                and "Any" not in str(inspect.signature(made))
                and "Raises" in (made.__doc__ or "")
            ), name


def test_lengths_that_are_none_are_type_errors() -> None:
    for name in ("outer_diameter_mm", "wall_mm", "length_mm"):
        given: Any = {"outer_diameter_mm": 30, "wall_mm": 2, "length_mm": 285}
        with pytest.raises(TypeError, match=name):
            mk.Muscle(**{**given, name: None})


def test_a_warning_belongs_to_a_point_whichever_way_it_is_asked() -> None:
    """An identity: a number, a list of one and solve() say the same; in any order, as nothing that was said before counts."""
    soft = mk.Muscle(
        outer_diameter_mm=30, wall_mm=2, length_mm=285, rubber="ecoflex-00-10"
    )

    def said(ask: Any) -> list[str]:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            ask()
        return [str(w.message) for w in caught]

    told = 0
    for pressure in (0.9, 0.05, 0.5, 0.2, 0.02, 0.7):
        for contraction in (0.3, 0.0, 0.12):
            for model in ("thick-wall", "universal"):
                point = said(
                    lambda: soft.solve(pressure, contraction, model=model, errors="nan")
                )
                told += bool(point)
                for ask in (
                    lambda: soft.force(
                        pressure, contraction, model=model, errors="nan"
                    ),
                    lambda: soft.force(
                        [pressure], contraction, model=model, errors="nan"
                    ),
                ):
                    assert said(ask) == point, (pressure, contraction, model)
    assert 0 < told < 36
    # Nobody knows when it bursts: at every pressure.
    rated = mk.Muscle.prototype().replace(
        rated_pressure_mpa=0.9, stiffness="inextensible"
    )
    for pressure in (0.05, 0.55, 0.7):
        of: Any
        for of in (rated.solve, rated.force):
            (text,) = said(lambda: of(pressure, 0.1, model="thick-wall"))
            assert text.startswith("BURST NOT CHECKED")


@pytest.mark.parametrize("own", ["", "[friction]\ncoefficient = 40\nexponent = 0.7\n"])
def test_a_muscle_with_other_parameters_keeps_its_branch(own: str) -> None:
    """What a search knew of the muscle goes with it: the same parameters are the same pull, on the branch of its job, and slopes are differences, also of friction
    that is estimated from the pull."""
    job = '[job]\npressure = "2 bar"\nbranch = "contraction"\n'
    muscle = mk.Muscle.from_toml(
        '[tube]\nouter_diameter = "30 mm"\nwall_thickness = "3 mm"\n' + own + job
    )
    name, model = "tube.wall_thickness", "universal"
    pull, jac = muscle.force(0.2, 0.1, jac=[name], model=model)
    assert pull < muscle.force(0.2, 0.1, branch="mean", model=model)

    def at(wall: float) -> float:
        return muscle.with_parameters({name: wall}).force(0.2, 0.1, model=model)

    assert at(3.0) == pytest.approx(pull, rel=1e-12)
    assert (at(3.001) - at(2.999)) / 0.002 == pytest.approx(jac[2], rel=1e-5)


def test_one_word_for_the_branch_and_the_old_ones_are_none(root: Path) -> None:
    """Of points, curves, comparisons and identifications; friction opposes the motion on both sides of the mean."""
    muscle = mk.load(root / "examples/tondu2012.toml", mk.Muscle)
    low, mean, high = (
        muscle.force(0.2, 0.1, model="thick-wall", branch=branch)
        for branch in ("contraction", "mean", "elongation")
    )
    assert low < mean < high and mean - low == pytest.approx(high - mean, rel=1e-9)
    curve = muscle.curve(
        pressures_mpa=[0.2], contractions=[0.1], model="thick-wall", branch="both"
    )
    assert curve["force_n"].tolist() == [low, high]
    assert muscle.check(branch="elongation", model="ideal", pressure_mpa=0.2)
    old: Any = muscle
    identify: Any = mk.identify
    asks: list[Any] = [
        lambda: old.force(0.2, 0.1, direction="mean"),
        lambda: old.check(direction="mean"),
        lambda: old.curve(both=True),
        lambda: identify(old, {}, branches="mean"),
    ]
    for ask in asks:
        with pytest.raises(TypeError, match="unexpected keyword argument"):
            ask()


def test_load_refuses_another_class(root: Path) -> None:
    assert mk.load(root / "examples/elbow.toml", mk.Joint).muscles
    with pytest.raises(mk.FileError, match="a Joint, not a Muscle"):
        mk.load(root / "examples/elbow.toml", mk.Muscle)


def test_symbols_are_refused() -> None:
    """CasADi makes NaN of a symbol that an array of numbers is made of."""

    class Symbol:
        def is_symbolic(self) -> bool:
            return True

        def __array__(self, *_: Any, **__: Any) -> Any:
            return np.array(np.nan)

    muscle: Any = mk.Muscle.prototype()
    for given in ((Symbol(), 0.1), (0.2, Symbol())):
        with pytest.raises(TypeError):
            muscle.force(*given)
