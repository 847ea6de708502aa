"""Arrays in, arrays out: shapes, strides, derivatives, what is wrong with them."""

from __future__ import annotations

import subprocess
import sys
import sysconfig
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest

import mckibben as mk

MODELS = ["universal", "thick-wall", "paper", "ideal", "fe"]


@pytest.mark.parametrize("name", MODELS)
def test_an_array_is_its_points(thin: mk.Muscle, name: str) -> None:
    """An identity: what the array path answers is what the command answers for each point."""
    model = thin.model(name)
    p, e = np.linspace(0.0, 0.25, 4)[:, None], np.linspace(0.0, 0.2, 3)
    force = model.force(p, e)
    assert force.shape == (4, 3) and force.dtype == np.float64
    for i, j in np.ndindex(4, 3):
        alone = thin.state(float(p[i, 0]), float(e[j]), model=name).force_n
        assert force[i, j] == pytest.approx(alone, abs=1e-8 * 2700)


@pytest.mark.parametrize("name", ["universal", "paper", "ideal"])
def test_arrays_lie_as_they_please(thin: mk.Muscle, name: str) -> None:
    """Transposed, reversed, every second, spread over a grid of more than one block: the same numbers as in one piece."""
    model = thin.model(name)
    rng = np.random.default_rng(1)
    p, e = rng.uniform(0.01, 0.25, (61, 47)), rng.uniform(0, 0.15, (61, 47))
    straight = model.force(p.ravel().copy(), e.ravel().copy()).reshape(p.shape)
    for a, b, expected in [
        (p.T, e.T, straight.T),
        (p[::-1, ::2], e[::-1, ::2], straight[::-1, ::2]),
        (np.asfortranarray(p), e, straight),
        (p[:, ::-1], e[:, ::-1], straight[:, ::-1]),
    ]:
        assert np.allclose(model.force(a, b), expected, rtol=1e-9, atol=1e-6)
    grid = model.force(p[:, 0][:, None, None], e[0][None, :, None] * np.ones(3))
    assert grid.shape == (61, 47, 3)
    assert np.allclose(grid, model.force(np.repeat(p[:, 0], 47 * 3), np.tile(np.repeat(e[0], 3), 61)).reshape(grid.shape), rtol=1e-9, atol=1e-6)


def test_shapes_at_the_edge(thin: mk.Muscle) -> None:
    model = thin.model("ideal")
    assert isinstance(model.force(0.2, 0.1), float)
    assert isinstance(model.force(np.float32(0.2), 0), float)
    assert model.force([], 0.1).shape == (0,)
    assert model.force(np.zeros((0, 3)), 0.1).shape == (0, 3)
    assert model.force(np.array([1, 2]), 0).shape == (2,)
    assert model.force("0..2.5:0.5bar", 0).shape == (6,)
    assert model.force(["1 bar", "36 psi"], "10%").shape == (2,)


def test_numbers_that_are_there_are_not_copied(thin: mk.Muscle) -> None:
    p = np.linspace(0, 0.25, 1000)
    from mckibben._quantity import array

    assert array("pressure_mpa", p) is p


@pytest.mark.parametrize("name", [*MODELS, "chou-hannaford"])
@pytest.mark.parametrize("wanted", ["force", "pressure", "contraction"])
def test_derivatives_are_those_of_differences(thin: mk.Muscle, name: str, wanted: str) -> None:
    """Central differences of second order with h: their error is O(h²), far below 1e-5 of the derivative."""
    model = thin.model(name)
    ask = getattr(model, wanted)
    a, b = {"force": (0.2, 0.1), "pressure": (700.0, 0.1), "contraction": (700.0, 0.2)}[wanted]
    value, jac = ask(a, b, jac=True)
    assert jac.shape == (2,) and value == pytest.approx(ask(a, b), rel=1e-12)
    for i, (h_a, h_b) in enumerate([(1e-4 * a, 0.0), (0.0, 1e-4 * b)]):
        difference = (ask(a + h_a, b + h_b) - ask(a - h_a, b - h_b)) / (2 * (h_a + h_b))
        assert jac[i] == pytest.approx(difference, rel=1e-5)


@pytest.mark.parametrize("name", ["fe", "universal", "thick-wall"])
def test_derivatives_by_constants_are_those_of_differences(name: str) -> None:
    muscle = mk.Muscle.prototype(outer_diameter_mm=50, wall_mm=2)
    names = ["tube.material.c10", "braid.stiffness", "tube.wall_thickness", "tube.outer_diameter", "braid.angle", "tube.length"]
    model = muscle.model(name)
    _, jac = model.force(0.2, [0.05, 0.1], jac=names)
    assert jac.shape == (2, 2 + len(names))
    for i, parameter in enumerate(names):
        value = muscle.parameters[parameter]
        h = 1e-4 * value
        high, low = (model.of(muscle.with_parameters({parameter: value + s * h})).force(0.2, [0.05, 0.1]) for s in (1, -1))
        # A change by a share is of the size of the pull at most: 2000 N.
        assert np.allclose(jac[:, 2 + i], (high - low) / (2 * h), rtol=1e-4, atol=1e-6 * 2000 / value), parameter


def test_a_slack_muscle_pulls_nothing_and_pushes_where_it_is_asked_to(thin: mk.Muscle) -> None:
    for name in ["fe", "thick-wall", "ideal"]:
        force, jac = thin.model(name).force(0.1, [0.0, 0.4], jac=True)
        assert force[0] > 0 and force[1] == 0 and not jac[1].any()
    assert thin.model("ideal", two_sided=True).force(0.1, 0.4) < 0


def test_the_first_point_without_an_answer_is_named(thin: mk.Muscle) -> None:
    model = thin.model("paper")
    p = np.full(5000, 0.1)
    p[[4321, 1234]] = 0.5
    with pytest.raises(mk.OutOfRangeError) as caught:
        model.force(p, 0.1)
    assert caught.value.index == 1234 and "pressure 0.5 MPa" in caught.value.message
    force = model.force(p, 0.1, errors="nan")
    assert np.isnan(force).sum() == 2 and np.isnan(force[1234])
    value, jac = model.force(p[1230:1240], 0.1, errors="nan", jac=True)
    assert np.isnan(jac[4]).all() and np.isfinite(np.delete(jac, 4, axis=0)).all()
    assert np.isfinite(thin.model("paper", extrapolate=True).force(p, 0.1)).all()


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("name", ["paper", "universal", "ideal", "fe"])
def test_what_is_no_number_is_refused(thin: mk.Muscle, name: str, bad: float) -> None:
    model = thin.model(name)
    for p, e in [(bad, 0.1), (0.2, bad)]:
        with pytest.raises(mk.InputError):
            model.force([0.1, p], [0.0, e])
        assert np.isnan(model.force([0.1, p], [0.0, e], errors="nan")[1])


def test_wrong_shapes_and_types(thin: mk.Muscle) -> None:
    model = thin.model("ideal")
    with pytest.raises(ValueError):
        model.force(np.zeros(3), np.zeros(4))
    bads: list[Any] = [object(), [object()], np.array(["a", "b"]), np.array([1j]), np.array([None]), {}, b"1", np.array([True]), [[1, 2], [3]]]
    for bad in bads:
        with pytest.raises((TypeError, ValueError)):
            model.force(bad, 0.1)
    with pytest.raises(mk.InputError):
        model.force("3 mm", 0.1)
    with pytest.raises(ValueError):
        model.force(0.1, 0.1, errors="ignore")
    with pytest.raises(mk.InputError):
        model.force(0.1, 0.1, jac=["tube.material.c99"])
    with pytest.raises(mk.InputError, match="contraction ratio"):
        model.force(0.1, 15)


def test_huge_arrays_end_in_an_exception(thin: mk.Muscle) -> None:
    model = thin.model("ideal")
    tall, wide = np.zeros((1 << 24, 1)), np.zeros(1 << 24)
    with pytest.raises(MemoryError):
        model.force(tall, wide)


def test_threads_ask_at_once(thin: mk.Muscle) -> None:
    """Models, and a muscle with its commands, shared by threads that begin together, each with another question."""
    fe, paper, e = thin.model(), thin.model("paper"), np.linspace(0, 0.2, 12)
    p = np.linspace(0.01, 0.25, 1000)
    asked: list[Callable[[], object]] = [
        lambda: fe.force(0.2, e).tolist(),
        lambda: paper.force(p[:, None], e).tolist(),
        lambda: paper.force(0.2, 0.1),
        lambda: thin.model("universal").pressure(300.0, e[:5], jac=True)[1].tolist(),
        lambda: thin.curve("isometric", pressures_mpa=[0.1, 0.2], contractions=[0.0, 0.1]).force_n.tolist(),
        lambda: mk.design(force_n=700, contraction=0.15, max_pressure_mpa=0.25, model="universal").candidates,
    ]
    alone = [ask() for ask in asked]
    begin = threading.Barrier(len(asked))

    def answers(first: int) -> list[object]:
        begin.wait()
        order = [(first + i) % len(asked) for i in range(len(asked))]
        found = [(i, asked[i]()) for i in order]
        return [i for i, answer in found if answer != alone[i]]

    with ThreadPoolExecutor(len(asked)) as pool:
        assert list(pool.map(answers, range(len(asked)))) == [[]] * len(asked)


@pytest.mark.skipif(not sysconfig.get_config_var("Py_GIL_DISABLED"), reason="a Python with a global lock")
def test_the_global_lock_stays_off() -> None:
    code = "import sys, mckibben as mk; mk.Muscle.prototype().model('paper').force(0.2, [0.0, 0.1]); print(sys._is_gil_enabled())"
    done = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True)
    assert done.stdout.strip() == "False", done.stderr


def test_pint(thin: mk.Muscle) -> None:
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    model = thin.model("ideal")
    assert model.force(2.5 * unit.bar, 0.1) == pytest.approx(model.force(0.25, 0.1), rel=1e-12)
    assert np.allclose(model.force(np.array([1.0, 2.0]) * unit.bar, 0.1), model.force([0.1, 0.2], 0.1))
    assert mk.Muscle.prototype(outer_diameter_mm=2 * unit.inch).outer_diameter_mm == pytest.approx(50.8)
    with pytest.raises(mk.InputError):
        model.force(2.5 * unit.mm, 0.1)
    with pytest.raises(mk.InputError):
        mk.force(pressure_mpa=2.5 * unit.mm)


def spreads(count: int) -> dict[str, tuple[Any, Any]]:
    """Pairs of arrays in every way in which they may lie, of about so many points."""
    rng = np.random.default_rng(3)
    side = int(count**0.5)
    p, e = rng.uniform(0.01, 0.25, count), rng.uniform(0, 0.15, count)
    grid_p, grid_e = p[: side * side].reshape(side, side), e[: side * side].reshape(side, side)
    record = np.zeros(count, dtype=[("p", "f8"), ("n", "i4"), ("e", "f8")])
    record["p"], record["e"] = p, e
    twice = np.repeat(p, 2), np.repeat(e, 2)
    return {
        "array with a number": (p, 0.1),
        "number with an array": (0.2, e),
        "array of one with an array": (np.array([0.2]), e),
        "array of no dimension": (np.array(0.2), e),
        "column with a row": (grid_p[:, :1], grid_e[0]),
        "row with a column": (grid_p[0], grid_e[:, :1]),
        "long column with a short row": (p[: count // 2, None], e[:2]),
        "short column with a long row": (p[:2, None], e[: count // 2]),
        "number over three axes": (grid_p[:, None, :10], grid_e[:10, :1][None, :, :]),
        "every second": (twice[0][::2], twice[1][::2]),
        "reversed": (p[::-1], e),
        "both reversed": (grid_p[::-1, ::-1], grid_e[::-1, ::-1]),
        "Fortran": (np.asfortranarray(grid_p), np.asfortranarray(grid_e)),
        "Fortran with C": (np.asfortranarray(grid_p), grid_e),
        "transposed": (grid_p.T, grid_e),
        "of a record": (record["p"], record["e"]),
        "read only": (np.broadcast_to(p, (1, count)), e),
    }


def straight(p: Any, e: Any) -> tuple[Any, Any]:
    a, b = np.broadcast_arrays(p, e)
    return np.ascontiguousarray(a), np.ascontiguousarray(b)


@pytest.mark.parametrize("name", list(spreads(100)))
@pytest.mark.parametrize("model", ["paper", "thick-wall"])
def test_a_spread_is_the_full_arrays(thin: mk.Muscle, model: str, name: str) -> None:
    """An identity, to the last bit, over more than one block: where the numbers lie does not matter."""
    ask = thin.model(model).force
    p, e = spreads(5000 if model == "paper" else 2500)[name]
    assert np.array_equal(ask(p, e), ask(*straight(p, e)))
    value, slopes = ask(p, e, jac=True)
    expected = ask(*straight(p, e), jac=True)
    assert np.array_equal(value, expected[0]) and np.array_equal(slopes, expected[1])


@pytest.mark.parametrize("shape", [(0,), (0, 3), (3, 0), (1, 1, 1), (7, 1, 5), (2, 3, 2, 3), (1024,), (1025,), (3, 341), (341, 3)])
def test_spreads_of_every_shape(thin: mk.Muscle, shape: tuple[int, ...]) -> None:
    """An identity: any axis may be spread, reversed or stepped over."""
    ask, rng = thin.model("ideal").force, np.random.default_rng(5)
    for trial in range(30):
        arrays = []
        for low, high in ((0.01, 0.3), (0.0, 0.2)):
            own = [1 if rng.random() < 0.4 and n else n for n in shape]
            steps = [int(rng.choice([-2, -1, 1, 2, 3])) for _ in own]
            values = rng.uniform(low, high, [n * abs(s) for n, s in zip(own, steps)])
            values = np.asfortranarray(values) if rng.random() < 0.3 else values
            arrays.append(values[tuple(slice(None, None, s) for s in steps)])
        p, e = arrays
        assert np.array_equal(ask(p, e), ask(*straight(p, e))), (p.strides, e.strides, p.shape, e.shape)


def test_a_spread_costs_what_it_answers(thin: mk.Muscle) -> None:
    """No layout costs many times what it costs to copy both arrays with NumPy first and to ask for the copies: a read that began again for each
    block took 1700 times as long. Processor time, both in turns, the least of each."""
    import time

    ask = thin.model("paper").force

    def seconds(work: Any) -> float:
        begun = time.process_time()
        work()
        return time.process_time() - begun

    for name, (p, e) in spreads(500_000).items():
        turns = [(seconds(lambda: ask(p, e)), seconds(lambda: ask(*straight(p, e)))) for _ in range(5)]
        own, other = (min(turn[i] for turn in turns) for i in range(2))
        assert own < 10 * other, (name, own, other)


def test_masks_are_honoured(thin: mk.Muscle) -> None:
    """What is masked is not asked for, even where its number is none; all others are what they are without a mask."""
    model = thin.model("paper")
    p = np.ma.masked_array([0.1, np.nan, 0.2, 9.9], mask=[False, True, False, True])
    e = np.ma.masked_array([[0.0], [0.1], [-5.0]], mask=[[False], [False], [True]])
    force: Any = model.force(p, 0.1)
    assert isinstance(force, np.ma.MaskedArray) and np.ma.getmaskarray(force).tolist() == [False, True, False, True]
    assert force.compressed().tolist() == model.force([0.1, 0.2], 0.1).tolist()
    grid: Any
    slopes: Any
    grid, slopes = model.force(p, e, jac=True)
    assert grid.shape == (3, 4) and slopes.shape == (3, 4, 2)
    assert grid.mask.tolist() == [[False, True, False, True]] * 2 + [[True] * 4] and (np.ma.getmaskarray(slopes) == grid.mask[..., None]).all()
    # With slopes the same polynomial is summed in another order: some last bits.
    assert grid.compressed().tolist() == pytest.approx(model.force([0.1, 0.2], [[0.0], [0.1]]).ravel().tolist(), rel=1e-14)
    # A mask of nothing, of everything, and of a single number.
    assert not np.ma.getmaskarray(model.force(np.ma.masked_array([0.1, 0.2]), 0.1)).any()
    for nothing in (np.ma.masked_array([0.1, 0.2], mask=True), np.ma.masked_array(0.1, mask=True)):
        assert np.ma.getmaskarray(model.force(nothing, 0.1)).all()
    # The place of a point without an answer is that among all.
    with pytest.raises(mk.OutOfRangeError) as caught:
        model.force(np.ma.masked_array([9.9, 0.1, 9.9], mask=[True, False, False]), 0.1)
    assert caught.value.index == 2
    with pytest.raises(mk.InputError, match="masked"):
        thin.curve("isobaric", pressures_mpa=np.ma.masked_array([0.1, 0.2], mask=[True, False]), model="paper")
    assert np.isnan(mk.Table({"a": np.ma.masked_array([1.0, 2.0], mask=[True, False])})["a"]).tolist() == [True, False]
    assert np.isnan(mk.Table({"a": np.ma.masked_array([1, 2], mask=[True, False])})["a"]).tolist() == [True, False]
