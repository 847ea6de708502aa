"""A muscle in the losses of SciPy and JAX: the examples find the constants that made the forces."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import mckibben as mk

pytest.importorskip("jax")
from mckibben.jax import contraction, force, pressure


@pytest.mark.parametrize(
    "name, needs, rel",
    [("identify_scipy", "scipy", 1e-6), ("identify_jax", "jax", 1e-4)],
)
def test_an_example_identifies_a_muscle(
    name: str, needs: str, rel: float, root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip(needs)
    monkeypatch.syspath_prepend(str(root / "python" / "examples"))
    assert importlib.import_module(name).main() == pytest.approx([0.15, 700.0], rel=rel)


def test_jax_derivatives(jax: Any) -> None:
    """∂F/∂θ by jax.grad against differences, along a direction, and over several points at once."""
    muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=3, length_mm=285)
    names = ["tube.material.c10", "braid.stiffness"]
    pull, theta = force(muscle, names), np.array([0.112, 590.0])
    contractions = np.array([0.0, 0.05, 0.1])

    def loss(t: Any) -> Any:
        return (pull(0.2, contractions, t) ** 2).sum()

    slope = jax.jit(jax.grad(loss))(theta)
    for i in range(2):
        h = np.eye(2)[i] * 1e-5 * theta
        assert slope[i] == pytest.approx(
            float((loss(theta + h) - loss(theta - h)) / (2 * h[i])), rel=1e-5
        )
    plain = force(muscle)
    value, change = jax.jvp(lambda p: plain(p, 0.1), (0.2,), (1.0,))
    expected, by = muscle.force(0.2, 0.1, jac=True)
    assert float(value) == pytest.approx(expected) and float(change) == pytest.approx(
        by[0]
    )
    assert jax.vmap(lambda e: plain(0.2, e))(contractions).shape == (3,)
    with pytest.raises(ValueError):
        pull(0.2, 0.1)


@pytest.fixture
def jax() -> Any:
    """JAX with 64 bits."""
    found = pytest.importorskip("jax")
    found.config.update("jax_enable_x64", True)
    return found


def test_jax_asks_once_for_a_batch(jax: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """vmap of a function of points asks the model once, a value asks for no derivatives; over θ it is a loop with the same numbers."""
    asked: list[bool] = []
    usual, kind = mk.Muscle.force, importlib.import_module("mckibben.jax")._OfMuscle
    numbers = kind.numbers

    def counting(self: Any, given: Any, theta: Any, slopes: bool, how: Any) -> Any:
        asked.append(slopes)
        return numbers(self, given, theta, slopes, how)

    monkeypatch.setattr(kind, "numbers", counting)
    muscle = mk.Muscle.prototype()
    pull, p, e = (
        force(muscle, model="universal"),
        np.linspace(0.05, 0.2, 40),
        np.linspace(0.0, 0.15, 40),
    )
    assert np.array_equal(
        jax.vmap(pull)(p, e), usual(muscle, p, e, model="universal")
    ) and asked == [False]
    asked.clear()
    assert np.allclose(
        jax.vmap(jax.grad(pull))(p, e),
        usual(muscle, p, e, jac=True, model="universal")[1][:, 0],
        rtol=1e-12,
    ) and asked == [True]
    asked.clear()
    # A batch of batches, and one that is spread over points.
    grid = jax.vmap(lambda a: jax.vmap(lambda b: pull(a, b))(e))(p)
    assert (
        np.array_equal(grid, usual(muscle, p[:, None], e, model="universal"))
        and len(asked) == 1
    )
    by = force(muscle, ["tube.material.c10"], model="universal")
    thetas = np.array([[0.1], [0.112], [0.13]])
    for row, theta in zip(jax.vmap(lambda t: by(0.2, e, t))(thetas), thetas):
        assert np.array_equal(
            row,
            usual(
                muscle.with_parameters({"tube.material.c10": theta[0]}),
                0.2,
                e,
                model="universal",
            ),
        )


def test_inverses_measures_and_samplers(jax: Any) -> None:
    """Identities: P(F(P, ε), ε) = P, and the slope of an inverse is one over that of the function; measures by differences of replace()."""
    muscle, model = (
        mk.Muscle(outer_diameter_mm=50, wall_mm=2, length_mm=285),
        "universal",
    )
    pull, back, along = (
        force(muscle, model=model),
        pressure(muscle, model=model),
        contraction(muscle, model=model),
    )
    f = float(pull(0.2, 0.1))
    assert float(back(f, 0.1)) == pytest.approx(0.2, rel=1e-9) and float(
        along(f, 0.2)
    ) == pytest.approx(0.1, rel=1e-7)
    assert jax.grad(back)(f, 0.1) * jax.grad(pull)(0.2, 0.1) == pytest.approx(
        1, rel=1e-6
    )
    of_d, theta = (
        force(muscle, ["outer_diameter_mm", "tube.material.c10"], model=model),
        np.array([50.0, 0.112]),
    )
    slope = jax.grad(lambda t: of_d(0.2, 0.1, t))(theta)
    for i in range(2):
        h = np.eye(2)[i] * 1e-4 * theta
        assert slope[i] == pytest.approx(
            float((of_d(0.2, 0.1, theta + h) - of_d(0.2, 0.1, theta - h)) / (2 * h[i])),
            rel=1e-5,
        )
    with pytest.raises(ValueError, match="wall_mm"):
        force(muscle, ["wal_mm"])
    with pytest.raises(ValueError, match="theta"):
        of_d(0.2, 0.1)
    safe = force(muscle, ["wall_mm"], errors="nan", model=model)
    assert np.isnan(
        jax.grad(lambda t: safe(0.2, 0.1, t))(np.array([30.0]))
    ).all() and np.isnan(float(force(muscle, errors="nan", model=model)(90.0, 0.1)))
    with pytest.raises(Exception, match="wall"):
        float(force(muscle, ["wall_mm"], model=model)(0.2, 0.1, np.array([30.0])))


def ideal_second(muscle: mk.Muscle, p: float, e: float) -> Any:
    """The ideal muscle by hand (Tondu & Lopez 2000): F = π r² P (a (1 − ε)² − b), so that F_PP = 0, F_Pε = −2 π r² a (1 − ε), F_εε = 2 π r² P a."""
    scale = 2 * np.pi * 25.0**2 * 3 / np.tan(np.radians(muscle.angle_deg)) ** 2
    return scale * np.array([[0.0, e - 1], [e - 1, p]])


def test_second_derivatives_of_the_ideal_muscle(jax: Any) -> None:
    muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=1, length_mm=285)
    ideal = force(muscle, model="ideal")
    for p, e in ((0.2, 0.1), (1e-3, 0.0), (1e-4, 0.05)):
        assert np.allclose(
            jax.hessian(lambda x: ideal(x[0], x[1]))(np.array([p, e])),
            ideal_second(muscle, p, e),
            rtol=1e-6,
            atol=0.02,
        ), (p, e)
    assert not np.any(jax.hessian(lambda x: ideal(x[0], x[1]))(np.array([0.2, 0.9]))), (
        "a slack muscle"
    )


def test_jax_second_derivatives_of_a_batch(jax: Any) -> None:
    muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=1, length_mm=285)
    ideal = force(muscle, model="ideal")
    points = np.array([[0.1, 0.0], [0.2, 0.1], [0.3, 0.2]])
    both = jax.jit(jax.vmap(jax.hessian(lambda x: ideal(x[0], x[1]))))
    assert np.allclose(
        both(points), [ideal_second(muscle, *x) for x in points], rtol=1e-6, atol=0.02
    )


def test_second_derivatives_of_models_measures_and_inverses(jax: Any) -> None:
    """Against differences of first derivatives, and an identity: P(F(P, ε), ε) = P twice differentiated, p' = 1/f', p'' = −f''/f'³."""
    muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=2, length_mm=285)
    pull = force(muscle, ["outer_diameter_mm", "tube.material.c10"], model="universal")

    def at_once(x: Any) -> Any:
        return pull(x[0], x[1], x[2:])

    at = np.array([0.2, 0.1, 50.0, 0.112])
    found, slope = jax.hessian(at_once)(at), jax.grad(at_once)
    assert np.array_equal(found, found.T)
    for i in range(4):
        h = np.eye(4)[i] * 1e-3 * at
        assert np.allclose(
            found[i],
            (slope(at + h) - slope(at - h)) / (2 * h[i]),
            rtol=1e-3,
            atol=1e-3 * abs(found[i]).max(),
        ), i
    f, p = force(muscle, model="universal"), pressure(muscle, model="universal")
    first, curvature = (
        found(lambda x: f(x[0], 0.1))(np.array([0.2])).item()
        for found in (jax.grad, jax.hessian)
    )
    assert jax.hessian(lambda x: p(x[0], 0.1))(
        np.array([float(f(0.2, 0.1))])
    ).item() == pytest.approx(-curvature / first**3, rel=1e-4)
    elements = force(muscle)
    with pytest.raises(
        NotImplementedError, match="finite elements have first derivatives only"
    ):
        jax.hessian(lambda x: elements(x[0], 0.1))(np.array([0.2]))


def test_jax_names_what_is_no_parameter(jax: Any) -> None:
    with pytest.raises(
        mk.InputError, match=r"did you mean tube\.material\.c10"
    ) as caught:
        force(mk.Muscle.prototype(), ["tube.materiel.c10"])
    assert caught.value.field == "wrt"


def test_jax_second_derivatives_by_more_parameters_than_numbers(jax: Any) -> None:
    """An identity: those of each parameter alone; the mixed ones are differences of the slopes."""
    muscle = mk.Muscle.prototype()
    names = ["outer_diameter_mm", "wall_mm", "angle_deg", "tube.material.c10"]
    measures = muscle.outer_diameter_mm, muscle.wall_mm, muscle.angle_deg
    values = np.array([*measures, muscle.parameters[names[-1]]])
    pull = force(muscle, names, model="thick-wall")
    found = np.array(jax.hessian(lambda t: pull(0.2, 0.1, t))(values))
    assert found == pytest.approx(found.T, rel=1e-9)
    slopes = jax.grad(lambda t: pull(0.2, 0.1, t))
    for i, value in enumerate(values):
        h = 1e-4 * value
        step = h * np.eye(len(values))[i]
        row = (np.array(slopes(values + step)) - np.array(slopes(values - step))) / (
            2 * h
        )
        assert found[i] == pytest.approx(row, rel=1e-3, abs=1e-4 * abs(found[i]).max())


def test_jax_has_no_third_derivatives(jax: Any) -> None:
    with pytest.raises(NotImplementedError, match="first and second"):
        jax.grad(jax.grad(jax.grad(force(mk.Muscle.prototype(), model="universal"))))(
            0.2, 0.1
        )


def posterior(made: Any, found: Any, points: list[Any]) -> tuple[Any, Any]:
    """Mean and standard deviation of the posterior with a flat prior, in standard errors about what least squares found: by quadrature on a grid of
    half a standard error, which for a density as smooth as this has converged."""
    p, e, f = points
    names = found.names
    nodes = np.linspace(-5, 5, 21)
    grid = np.array([[a, b] for a in nodes for b in nodes])
    log = np.empty(len(grid))
    for i, z in enumerate(grid):
        theta = dict(zip(names, found.value + found.standard_error * z))
        pulls = found.muscle.with_parameters(theta).force(
            p, e, errors="nan", model="universal"
        )
        log[i] = -0.5 * (((pulls - f) / found.deviation) ** 2).sum()
    weight = np.where(np.isfinite(log), np.exp(log - np.nanmax(log)), 0)
    weight /= weight.sum()
    mean = weight @ grid
    return mean, np.sqrt(weight @ (grid - mean) ** 2)


def independent(sampler: str, z: Any) -> Any:
    """As how many independent samples these count, of each constant."""
    if sampler == "by_emcee":
        from emcee.autocorr import integrated_time

        return len(z) / integrated_time(z.reshape(-1, 16, z.shape[1]), quiet=True)
    from numpyro.diagnostics import effective_sample_size

    return effective_sample_size(z[None])


@pytest.mark.parametrize(
    "sampler, needs", [("by_emcee", "emcee"), ("by_nuts", "numpyro")]
)
def test_a_posterior_is_that_of_quadrature(
    sampler: str, needs: str, root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Mean and standard deviation within four standard errors of the sampling, σ/√n and σ/√(2n) for as many as n independent samples. Regression: the
    posterior itself lies 0.04 and 0.22 standard errors beside what least squares found, and is 1.00 and 1.05 times as wide as its errors."""
    pytest.importorskip(needs)
    monkeypatch.syspath_prepend(str(root / "python" / "examples"))
    pytest.importorskip("scipy")
    made: Any = importlib.import_module("identify_bayes")
    found, *points = made.bench()
    mean, width = posterior(made, found, points)
    assert np.allclose(mean, [0.042, 0.219], atol=0.005) and np.allclose(
        width, [0.999, 1.045], atol=0.005
    )
    z = (getattr(made, sampler)(found, *points) - found.value) / found.standard_error
    n = independent(sampler, z)
    assert (n > 50).all(), f"too few samples: {n}"
    assert (abs(z.mean(axis=0) - mean) < 4 * width / np.sqrt(n)).all(), (
        z.mean(axis=0),
        mean,
        n,
    )
    assert (abs(z.std(axis=0) - width) < 4 * width / np.sqrt(2 * n)).all(), (
        z.std(axis=0),
        width,
        n,
    )
