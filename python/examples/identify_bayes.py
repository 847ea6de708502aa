"""The posterior of two constants of a muscle on its bench (examples/bench.csv) with a flat prior, by NUTS (NumPyro) and by emcee, against the error
bars of least squares (SciPy).

python identify_bayes.py
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import mckibben as mk

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
Array = NDArray[np.float64]


class Fit(NamedTuple):
    """Constants by least squares, with their standard errors and that of a point."""

    muscle: Any
    names: list[str]
    value: Array
    standard_error: Array
    deviation: float


def bench() -> tuple[Fit, Array, Array, Array]:
    """What least squares find from where identify ends, and the points."""
    from scipy.optimize import least_squares

    found = mk.identify(
        EXAMPLES / "bench.toml",
        EXAMPLES / "bench.csv",
        free=["tube.material.mu", "braid.stiffness"],
        model="universal",
    )
    rows = found.points
    columns = (
        [row.pressure_mpa for row in rows],
        [row.contraction for row in rows],
        [row.force_n for row in rows],
    )
    p, e, f = (np.array(column, dtype=np.float64) for column in columns)
    muscle, names = found.identified, found["name"]

    def at(theta: Array) -> Any:
        return muscle.with_parameters(dict(zip(names, theta))).force(
            p, e, jac=names, model="universal"
        )

    best = least_squares(
        lambda theta: at(theta)[0] - f,
        found["value"],
        jac=lambda theta: at(theta)[1][:, 2:],
        x_scale=found["value"],
        xtol=1e-12,
        ftol=1e-12,
    )
    deviation = float(np.sqrt(2 * best.cost / (len(f) - len(names))))
    error = deviation * np.sqrt(np.diag(np.linalg.inv(best.jac.T @ best.jac)))
    return Fit(muscle, names, best.x, error, deviation), p, e, f


def by_emcee(found: Fit, p: Array, e: Array, f: Array, steps: int = 300) -> Array:
    """Samples of θ: flat prior, errors of the size that least squares found."""
    import emcee

    muscle, names = found.muscle, found.names

    def log_probability(theta: Array) -> float:
        if not (theta > 0).all():
            return -np.inf
        pulls = muscle.with_parameters(dict(zip(names, theta))).force(
            p, e, errors="nan", model="universal"
        )
        chi = float((((pulls - f) / found.deviation) ** 2).sum())
        return -0.5 * chi if np.isfinite(chi) else -np.inf

    rng = np.random.default_rng(1)
    start = found.value + 0.5 * found.standard_error * rng.standard_normal(
        (16, len(names))
    )
    sampler = emcee.EnsembleSampler(16, len(names), log_probability)
    sampler.random_state = np.random.RandomState(1).get_state()
    sampler.run_mcmc(start, steps)
    samples: Array = sampler.get_chain(discard=steps // 4, flat=True)
    return samples


def by_nuts(found: Fit, p: Array, e: Array, f: Array, samples: int = 400) -> Array:
    """The same by NUTS, with the gradients of the model."""
    import jax
    import jax.numpy as jnp
    import numpyro
    from numpyro.infer import MCMC, NUTS

    from mckibben.jax import force

    config: Any = jax.config
    config.update("jax_enable_x64", True)
    pull = force(found.muscle, found.names, errors="nan", model="universal")

    def model() -> None:
        z = numpyro.sample(
            "z",
            numpyro.distributions.Normal(jnp.zeros(len(found.value)), 30.0).to_event(1),
        )
        # In standard errors about what least squares found: then the sampler needs little tuning.
        theta = jnp.asarray(found.value) + jnp.asarray(found.standard_error) * z
        numpyro.sample(
            "force",
            numpyro.distributions.Normal(pull(p, e, theta), found.deviation),
            obs=f,
        )

    mcmc = MCMC(NUTS(model), num_warmup=100, num_samples=samples, progress_bar=False)
    mcmc.run(jax.random.PRNGKey(0))
    z: Array = np.asarray(mcmc.get_samples()["z"])
    return np.asarray(found.value + found.standard_error * z)


def main() -> dict[str, tuple[Array, Array]]:
    """Mean and standard deviation of each, by its name."""
    found, p, e, f = bench()
    out = {"squares": (found.value, found.standard_error)}
    for name, ask in (("emcee", by_emcee), ("nuts", by_nuts)):
        try:
            samples = ask(found, p, e, f)
        except ImportError:
            continue
        out[name] = samples.mean(axis=0), samples.std(axis=0)
    return out


if __name__ == "__main__":
    for name, (mean, error) in main().items():
        print(f"{name:9}", ", ".join(f"{m:.5g} ± {s:.2g}" for m, s in zip(mean, error)))
