"""Arrays in, arrays out: shapes, strides, derivatives, what is wrong with them."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest

import mckibben as mk

MODELS = ["universal", "thick-wall", "paper", "ideal", "fe"]


@pytest.mark.parametrize("name", [*MODELS, "force-balance"])
def test_a_number_is_that_of_its_list_and_of_all_results(
    thin: mk.Muscle, name: str
) -> None:
    """To the last bit, alone and among others, slack points too."""
    rng = np.random.default_rng(1)
    count = 20 if name == "fe" else 200
    p, e = rng.uniform(0.02, 0.25, count), rng.uniform(0, 0.2, count)
    pulls = thin.force(p, e, model=name)
    alone = [thin.force(float(a), float(b), model=name) for a, b in zip(p, e)]
    assert (
        pulls.tolist()
        == alone
        == thin.solve(p, e, model=name).force_n.tolist()
        == thin.force(p, e, model=name, jac=True)[0].tolist()
    )
    assert thin.force(p[::-1], e[::-1], model=name).tolist() == alone[::-1]


def spreads(count: int) -> dict[str, tuple[Any, Any]]:
    """Pairs of arrays in every way in which they may lie."""
    rng = np.random.default_rng(3)
    side = int(count**0.5)
    p, e = rng.uniform(0.01, 0.25, side * side), rng.uniform(0, 0.15, side * side)
    grid_p, grid_e = p.reshape(side, side), e.reshape(side, side)
    record = np.zeros(side * side, dtype=[("p", "f8"), ("n", "i4"), ("e", "f8")])
    record["p"], record["e"] = p, e
    return {
        "a number": (0.2, e),
        "no dimension": (np.array(0.2), e),
        "column and row": (grid_p[:, :1], grid_e[0]),
        "three axes": (grid_p[:, None, :10], grid_e[:10, :1][None]),
        "every second": (np.repeat(p, 2)[::2], e),
        "reversed": (grid_p[::-1, ::-1], grid_e[::-1, ::-1]),
        "Fortran": (np.asfortranarray(grid_p), grid_e),
        "transposed": (grid_p.T, grid_e),
        "of a record": (record["p"], record["e"]),
        "read only": (np.broadcast_to(p, (1, p.size)), e),
        "single precision": (p.astype(np.float32), e),
        "nothing": (np.zeros((0, 3)), 0.1),
    }


@pytest.mark.parametrize("name", list(spreads(9)))
@pytest.mark.parametrize("model", ["paper", "universal"])
def test_where_the_numbers_lie_does_not_matter(
    thin: mk.Muscle, model: str, name: str
) -> None:
    p, e = spreads(2500)[name]
    straight = tuple(
        np.ascontiguousarray(v, dtype=np.float64) for v in np.broadcast_arrays(p, e)
    )
    assert np.array_equal(
        thin.force(p, e, model=model), thin.force(*straight, model=model)
    )
    for own, other in zip(
        thin.force(p, e, model=model, jac=True),
        thin.force(*straight, model=model, jac=True),
    ):
        assert np.array_equal(own, other)


def test_shapes_at_the_edge(thin: mk.Muscle) -> None:
    def force(p: Any, e: Any = 0.0) -> Any:
        return thin.force(p, e, model="ideal")

    for number in (0.2, np.float32(0.2), np.float64(0.2), np.array(0.2), "2 bar"):
        assert isinstance(force(number), float)
    assert (
        force([]).shape == (0,)
        and force(np.array([0, 0])).shape == (2,)
        and force("0..2.5:0.5bar").shape == (6,)
        and force(["1 bar", "36 psi"], "10%").shape == (2,)
    )


@pytest.mark.parametrize("name", [*MODELS, "chou-hannaford"])
@pytest.mark.parametrize("wanted", ["force", "pressure", "contraction"])
def test_derivatives_are_those_of_differences(
    thin: mk.Muscle, name: str, wanted: str
) -> None:
    """Central differences of second order with h: their error is O(h²), far below 1e-5 of the derivative."""
    ask: Any = getattr(thin, wanted)
    a, b = {"force": (0.2, 0.1), "pressure": (700.0, 0.1), "contraction": (700.0, 0.2)}[
        wanted
    ]
    value, jac = ask(a, b, jac=True, model=name)
    assert jac.shape == (2,) and value == ask(a, b, model=name)
    for i, (h_a, h_b) in enumerate([(1e-4 * a, 0.0), (0.0, 1e-4 * b)]):
        difference = (
            ask(a + h_a, b + h_b, model=name) - ask(a - h_a, b - h_b, model=name)
        ) / (2 * (h_a + h_b))
        assert jac[i] == pytest.approx(difference, rel=1e-5)


@pytest.mark.parametrize("name", ["fe", "universal", "thick-wall"])
def test_derivatives_by_constants_are_those_of_differences(name: str) -> None:
    """By constants with all others held, and by measures as replace() has them: with k held the one by the diameter is another number."""
    muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=2, length_mm=285)
    held = [
        "tube.material.c10",
        "braid.stiffness",
        "tube.wall_thickness",
        "tube.outer_diameter",
        "braid.angle",
        "tube.length",
    ]
    measures = ["outer_diameter_mm", "wall_mm", "length_mm", "angle_deg"]
    _, jac = muscle.force(0.2, [0.05, 0.1], jac=[*held, *measures], model=name)
    assert jac.shape == (2, 2 + len(held) + len(measures))
    for i, parameter in enumerate([*held, *measures]):
        value = (
            muscle.parameters[parameter]
            if parameter in held
            else getattr(muscle, parameter)
        )
        h = 1e-4 * value
        given: list[dict[str, Any]] = [{parameter: value + s * h} for s in (1, -1)]
        changed = [
            muscle.with_parameters(change)
            if parameter in held
            else muscle.replace(**change)
            for change in given
        ]
        high, low = (other.force(0.2, [0.05, 0.1], model=name) for other in changed)
        # A change by a share is of the size of the pull at most: 2000 N.
        assert np.allclose(
            jac[:, 2 + i], (high - low) / (2 * h), rtol=1e-4, atol=1e-6 * 2000 / value
        ), parameter
    assert (
        jac[:, 2 + len(held)] > 1.01 * jac[:, 2 + held.index("tube.outer_diameter")]
    ).all()


def test_a_slack_muscle_pulls_nothing_and_pushes_where_it_is_asked_to(
    thin: mk.Muscle,
) -> None:
    for name in ["fe", "thick-wall", "ideal"]:
        force, jac = thin.force(0.1, [0.0, 0.4], jac=True, model=name)
        assert (
            force[0] > 0
            and force[1] == 0
            and not jac[1].any()
            and thin.solve(0.1, 0.4, model=name).slack
        )
    assert thin.force(0.1, 0.4, model="ideal", two_sided=True) < 0


@pytest.mark.parametrize("ask", ["force", "solve"])
def test_a_point_without_an_answer_raises_or_is_nan(thin: mk.Muscle, ask: str) -> None:
    def pulls(p: Any, **options: Any) -> Any:
        found = getattr(thin, ask)(p, 0.1, model="paper", **options)
        return found if ask == "force" else found.force_n

    p = np.full(5000 if ask == "force" else 50, 0.1)
    p[[43, 12]] = 0.5
    with pytest.raises(mk.OutOfRangeError, match=r"pressure 0.5\sMPa") as caught:
        pulls(p)
    assert caught.value.index == 12
    assert (
        np.flatnonzero(np.isnan(pulls(p, errors="nan"))).tolist() == [12, 43]
        and np.isfinite(pulls(p, extrapolate=True)).all()
    )
    with pytest.raises(ValueError):
        pulls(0.1, errors="ignore")


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("name", ["paper", "universal", "ideal", "fe"])
def test_what_is_no_number_is_refused(thin: mk.Muscle, name: str, bad: float) -> None:
    for p, e in [(bad, 0.1), (0.2, bad)]:
        with pytest.raises(mk.InputError):
            thin.force([0.1, p], [0.0, e], model=name)
        assert np.isnan(
            thin.force([0.1, p], [0.0, e], errors="nan", model=name)[1]
        ) and np.isnan(thin.force(p, e, errors="nan", model=name))


@pytest.mark.parametrize(
    "bad",
    [
        object(),
        [object()],
        np.array(["a"]),
        np.array([1j]),
        np.array([None]),
        {},
        b"1",
        np.array([True]),
        True,
        [[1, 2], [3]],
        "",
        "1e999 bar",
        "２ bar",
        "nan",
        "3 mm",
    ],
)
def test_wrong_types_are_refused(thin: mk.Muscle, bad: Any) -> None:
    with pytest.raises((TypeError, ValueError)):
        thin.force(bad, 0.1, model="ideal")


def test_wrong_shapes_sizes_and_names_are_refused(thin: mk.Muscle) -> None:
    for wrong in (
        lambda: thin.force(np.zeros(3), np.zeros(4)),
        lambda: thin.force(0.1, 0.1, jac=["tube.material.c99"]),
        lambda: thin.force(0.1, 15),
    ):
        with pytest.raises(ValueError):
            wrong()
    with pytest.raises(MemoryError):
        thin.force(np.zeros((1 << 24, 1)), np.zeros(1 << 24), model="ideal")


def test_what_is_missing_is_answered_as_missing(thin: mk.Muscle) -> None:
    """NaN, None and what is masked, of pulls and of whole points, unless it is to raise."""
    gaps: list[Any] = [
        [0.1, np.nan],
        [0.1, None],
        ["1 bar", None],
        np.ma.masked_array([0.1, 0.1], mask=[False, True]),
    ]
    for p in gaps:
        pull = thin.force(p, 0.1, model="ideal", errors="nan")
        points = thin.solve(p, 0.1, model="ideal", errors="nan")
        for found in (pull, points.force_n):
            assert np.isnan(np.ma.filled(found, np.nan)).tolist() == [False, True]
        assert points.status[0] == "ok" != points.status[1]
        with pytest.raises(mk.InputError) as caught:
            thin.solve(p, 0.1, model="ideal")
        assert caught.value.field == "pressure_mpa" and caught.value.index == 1


def test_masks_are_honoured(thin: mk.Muscle) -> None:
    """What is masked is not asked for, even where its number is none; all others are what they are without a mask."""
    p = np.ma.masked_array([0.1, np.nan, 0.2, 9.9], mask=[False, True, False, True])
    e = np.ma.masked_array([[0.0], [0.1], [-5.0]], mask=[[False], [False], [True]])
    grid, slopes = thin.force(p, e, jac=True, model="paper")
    mask = np.array([[False, True, False, True]] * 2 + [[True] * 4])
    assert (np.ma.getmaskarray(grid) == mask).all() and (
        np.ma.getmaskarray(slopes) == mask[..., None]
    ).all()
    assert (
        np.asarray(grid)[~mask].tolist()
        == thin.force([0.1, 0.2], [[0.0], [0.1]], model="paper").ravel().tolist()
    )
    # The place of a point without an answer is that among all.
    with pytest.raises(mk.OutOfRangeError) as caught:
        thin.force(
            np.ma.masked_array([9.9, 0.1, 9.9], mask=[True, False, False]),
            0.1,
            model="paper",
        )
    assert caught.value.index == 2


def test_inverses_come_back(thin: mk.Muscle) -> None:
    pulls = np.array([300.0, 500.0])
    assert np.allclose(
        thin.force(thin.pressure(pulls, 0.1), 0.1), pulls, rtol=1e-8
    ) and np.allclose(thin.force(0.25, thin.contraction(pulls, 0.25)), pulls, rtol=1e-6)
    with pytest.raises(mk.NoAnswerError) as caught:
        thin.pressure(1e6, 0.1, model="ideal")
    assert (
        caught.value.nearest is not None and caught.value.nearest["pressure_mpa"] == 20
    )


def test_a_solution_is_saved_compared_and_given_to_others(
    thin: mk.Muscle, tmp_path: Any
) -> None:
    pytest.importorskip("xarray")
    p, e = np.linspace(0.05, 0.25, 3), np.linspace(0, 0.2, 5)
    points = thin.solve(p[:, None], e, model="universal")
    points.save(tmp_path / "s.json")
    # Longer than a file that a person writes may be.
    many = thin.solve(
        np.linspace(0.05, 0.25, 100)[:, None], np.linspace(0, 0.2, 60), model="ideal"
    )
    many.save(tmp_path / "many.json")
    assert (tmp_path / "many.json").stat().st_size > 1 << 20 and mk.load(
        tmp_path / "many.json"
    ) == many
    assert (
        mk.load(tmp_path / "s.json") == points
        and points.shape == (3, 5)
        and (points.uncertainty_n > 0).all()
        and points.status[0, 0] == "ok"
    )
    data = points.to_xarray()
    assert (
        dict(data.sizes) == {"pressure_mpa": 3, "contraction": 5}
        and data.force_n.attrs["units"] == "N"
        and len(points.to_pandas()) == 15
    )
    assert dict(
        thin.solve([0.1, 0.2], [0.0, 0.1], model="universal").to_xarray().sizes
    ) == {"dim_0": 2}
    fixed: Any = points
    with pytest.raises(AttributeError):
        fixed.force_n = 1


def test_threads_ask_at_once(thin: mk.Muscle) -> None:
    """One muscle, shared by threads that begin together, each with another question."""
    e, p = np.linspace(0, 0.2, 12), np.linspace(0.01, 0.25, 1000)
    asked: list[Callable[[], object]] = [
        lambda: thin.force(0.2, e).tolist(),
        lambda: thin.force(p[:, None], e, model="paper").tolist(),
        lambda: thin.force(0.2, 0.1, model="paper"),
        lambda: thin.pressure(300.0, e[:5], jac=True, model="universal")[1].tolist(),
        lambda: thin.curve(
            "isometric", pressures_mpa=[0.1, 0.2], contractions=[0.0, 0.1]
        )["force_n"].tolist(),
        lambda: (
            mk.design(
                force_n=700, contraction=0.15, max_pressure_mpa=0.25, model="universal"
            ).candidates
        ),
    ]
    alone = [ask() for ask in asked]
    begin = threading.Barrier(len(asked))

    def answers(first: int) -> list[int]:
        begin.wait()
        return [
            i
            for i in ((first + i) % len(asked) for i in range(len(asked)))
            if asked[i]() != alone[i]
        ]

    with ThreadPoolExecutor(len(asked)) as pool:
        assert list(pool.map(answers, range(len(asked)))) == [[]] * len(asked)


def test_quantities_of_pint_go_in_and_come_back(thin: mk.Muscle) -> None:
    pint = pytest.importorskip("pint")
    from mckibben import units

    unit = pint.UnitRegistry()
    assert thin.force(2.5 * unit.bar, 0.1, model="ideal") == pytest.approx(
        thin.force(0.25, 0.1, model="ideal"), rel=1e-12
    )
    assert np.allclose(
        thin.force(np.array([1.0, 2.0]) * unit.bar, 0.1, model="ideal"),
        thin.force([0.1, 0.2], 0.1, model="ideal"),
    )
    assert (
        thin.replace(wall_mm=0.1 * unit.inch).wall_mm == pytest.approx(2.54)
        and len(
            thin.curve(
                pressures_mpa=np.array([1.0, 2.0]) * unit.bar, model="ideal"
            ).fixed
        )
        == 2
    )
    for wrong in (
        lambda: thin.force(2.5 * unit.mm, 0.1),
        lambda: thin.replace(wall_mm=1 * unit.N),
        lambda: thin.curve(pressures_mpa=1 * unit.mm),
    ):
        with pytest.raises(mk.InputError):
            wrong()
    answer = units.quantities(thin.solve(0.2, [0.0, 0.1], model="universal"), unit)
    assert (answer["force_n"] / unit.N).check("[]") and answer["volume_mm3"].to(
        "ml"
    ).magnitude[0] > 0
    assert units.quantity("force_per_pressure_n_per_mpa", 1.0, unit).check(
        "[area]"
    ) and units.quantity("slip_mm_per_n", 1.0, unit).to(
        "m/N"
    ).magnitude == pytest.approx(1e-3)
