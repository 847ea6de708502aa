"""The muscle @{name}: pull and volume in closed form, for NumPy, JAX (jit, vmap, grad) and PyTorch.

@{facts}

Units: Pa (gauge), m, N, m3. Arguments are numbers or arrays of one library; in double precision where the arrays are.
Licence: MIT OR Apache-2.0.
"""
import sys

LENGTH = @{length}  # m, at rest
SUPPLY = @{supply}  # Pa, upper end of the box
LOW, HIGH = @{low}, @{high}  # ends of the box in the contraction 1 - L/LENGTH
A = @{py_a}  # N; powers of P/SUPPLY, powers of the contraction
B = @{py_b}  # N; of the stretched muscle
V = @{py_v}  # m3
FRICTION = @{py_friction}  # N; zeros where the muscle does not state its friction
# What a status says: a sum of these.
SLACK, PRESSURE_OUTSIDE, CONTRACTION_OUTSIDE, NO_ANSWER = 1, 2, 4, 8


def _arrays(*values):
    """The library of the arguments, and the arguments as its arrays."""
    for value in values:
        kind = type(value).__module__.split(".")[0]
        if kind == "torch":
            import torch

            like = {"dtype": value.dtype, "device": value.device} if value.is_floating_point() else {"dtype": torch.float64}
            return torch, torch.broadcast_tensors(*(torch.as_tensor(v, **like) for v in values))
        if kind in ("jax", "jaxlib"):
            import jax.numpy

            return jax.numpy, jax.numpy.broadcast_arrays(*(jax.numpy.asarray(v, dtype=float) for v in values))
    import numpy

    return numpy, numpy.broadcast_arrays(*(numpy.asarray(v, dtype=float) for v in values))


def _stopped(xp, value):
    """The value without its derivative."""
    if xp.__name__ == "torch":
        return value.detach()
    if xp.__name__ == "jax.numpy":
        return sys.modules["jax"].lax.stop_gradient(value)
    return value


def _repeated(xp, times, step, state):
    """A loop that JAX compiles once."""
    if xp.__name__ == "jax.numpy":
        return sys.modules["jax"].lax.fori_loop(0, times, lambda _, s: step(*s), state)
    for _ in range(times):
        state = step(*state)
    return state


def _coefficients(xp, e):
    """c, dc/de and the integral of c at a contraction, for each power of the pressure."""
    inside = xp.where(e < LOW, LOW + 0 * e, xp.where(e > HIGH, HIGH + 0 * e, e))
    beyond, s = e - inside, xp.where(inside < 0, -inside, 0 * e)
    out = []
    for a, (b0, b1) in zip(A, B):
        c = slope = integral = 0 * e
        for j in reversed(range(len(a))):
            slope = slope * inside + c
            c = c * inside + a[j]
            integral = integral * inside + a[j] / (j + 1)
        c = c + s * s * (b0 + b1 * s)
        slope = slope - s * (2 * b0 + 3 * b1 * s)
        integral = integral * inside - s * s * s * (b0 / 3 + b1 * s / 4)
        out.append((c + slope * beyond, slope, integral + beyond * (c + 0.5 * slope * beyond)))
    return list(zip(*out))


def _square(xp, q):
    """phi and dphi/dq: q^2, and its tangents outside of the box."""
    phi = xp.where(q <= 0, 0 * q, xp.where(q <= 1, q * q, 2 * q - 1))
    return phi, xp.where(q <= 0, 0 * q, xp.where(q <= 1, 2 * q, 2 + 0 * q))


def _two_sided(c, q, phi):
    return c[0] + c[1] * q + c[2] * phi


def force(pressure, length):
    """Pull F in N; 0 where the muscle would have to push."""
    xp, (pressure, length) = _arrays(pressure, length)
    q = pressure / SUPPLY
    pull = _two_sided(_coefficients(xp, 1 - length / LENGTH)[0], q, _square(xp, q)[0])
    return xp.where(pull > 0, pull, 0 * pull)


def status(pressure, length):
    """0 inside of the box where the muscle pulls, or a sum of SLACK, PRESSURE_OUTSIDE, CONTRACTION_OUTSIDE."""
    xp, (pressure, length) = _arrays(pressure, length)
    q, e = pressure / SUPPLY, 1 - length / LENGTH
    slack = _two_sided(_coefficients(xp, e)[0], q, _square(xp, q)[0]) <= 0
    return SLACK * slack + PRESSURE_OUTSIDE * ((pressure < 0) | (pressure > SUPPLY)) + CONTRACTION_OUTSIDE * ((e < LOW) | (e > HIGH))


def stiffness(pressure, length):
    """dF/dL at constant pressure, N/m."""
    xp, (pressure, length) = _arrays(pressure, length)
    q, (c, slope, _) = pressure / SUPPLY, _coefficients(xp, 1 - length / LENGTH)
    phi = _square(xp, q)[0]
    by_length = -_two_sided(slope, q, phi) / LENGTH
    return xp.where(_two_sided(c, q, phi) > 0, by_length, 0 * by_length)


def force_per_pressure(pressure, length):
    """dF/dP at constant length, m2."""
    xp, (pressure, length) = _arrays(pressure, length)
    q, (c, _, _) = pressure / SUPPLY, _coefficients(xp, 1 - length / LENGTH)
    phi, slope = _square(xp, q)
    by_pressure = (c[1] + c[2] * slope) / SUPPLY
    return xp.where(_two_sided(c, q, phi) > 0, by_pressure, 0 * by_pressure)


def pressure(force, length):
    """Pressure in Pa at which the muscle pulls with a force; 0 where it pulls more without pressure, NaN where no pressure does it."""
    xp, (force, length) = _arrays(force, length)
    c0, c1, c2 = _coefficients(xp, 1 - length / LENGTH)[0]
    missing, one = force - c0, 1 + 0 * c0
    root = c1 * c1 + 4 * c2 * missing
    below = xp.where(root > 0, c1 + xp.sqrt(xp.where(root > 0, root, one)), 0 * c1)
    closed = 2 * missing / xp.where(below > 0, below, one)
    slope = c1 + 2 * c2
    above = xp.where((slope > 0) & (missing + c2 >= slope), (missing + c2) / xp.where(slope > 0, slope, one), float("nan") * one)
    q = xp.where((below > 0) & (2 * missing <= below), closed, above)
    return SUPPLY * xp.where(missing <= 0, 0 * q, q)


def contraction(force, pressure):
    """Contraction 1 - L/LENGTH at which the muscle pulls with a force at a pressure."""
    xp, (force, pressure) = _arrays(force, pressure)
    q = pressure / SUPPLY
    phi = _square(xp, q)[0]

    def pull(e):
        c, slope, _ = _coefficients(xp, e)
        return _two_sided(c, q, phi), _two_sided(slope, q, phi)

    low, high = LOW + 0 * q + 0 * force, HIGH + 0 * q + 0 * force
    (pull_low, slope_low), (pull_high, slope_high) = pull(low), pull(high)
    beyond_low, beyond_high = force >= pull_low, force <= pull_high
    a, b = _stopped(xp, low), _stopped(xp, high)
    wanted, fixed_q, fixed_phi = _stopped(xp, force), _stopped(xp, q), _stopped(xp, phi)

    def halved(a, b):
        middle = 0.5 * (a + b)
        over = _two_sided(_coefficients(xp, middle)[0], fixed_q, fixed_phi) > wanted
        return xp.where(over, middle, a), xp.where(over, b, middle)

    a, b = _repeated(xp, 50, halved, (a, b))
    at = _stopped(xp, 0.5 * (a + b))
    for _ in range(2):
        value, slope = pull(at)
        at = _stopped(xp, at) - (value - force) / _stopped(xp, xp.where(slope < 0, slope, -1 + 0 * slope))

    def tangent(end, value, slope):
        return xp.where(slope < 0, end + (force - value) / xp.where(slope < 0, slope, -1 + 0 * slope), end)

    return xp.where(beyond_low, tangent(low, pull_low, slope_low), xp.where(beyond_high, tangent(high, pull_high, slope_high), at))


def volume(pressure, length):
    """Volume of the cavity, m3; dF/dP = -dV/dL. A slack muscle hangs at its free contraction."""
    xp, (pressure, length) = _arrays(pressure, length)
    q, e = pressure / SUPPLY, 1 - length / LENGTH
    phi, slope = _square(xp, q)
    slack = _two_sided(_coefficients(xp, e)[0], q, phi) <= 0
    integral = _coefficients(xp, xp.where(slack, contraction(0 * q, pressure), e))[2]
    return V[0] + V[1] * q + V[2] * phi + LENGTH / SUPPLY * (integral[1] + integral[2] * slope)


def friction(pressure, velocity, smoothing=1e-3):
    """What friction adds to the pull while the length changes by a velocity in m/s (positive: longer); smooth at rest."""
    xp, (pressure, velocity) = _arrays(pressure, velocity)
    q = xp.where(pressure > 0, pressure / SUPPLY, 0 * pressure)
    half = FRICTION[0] * xp.sqrt(xp.where(q > 0, q, 1 + 0 * q)) * (q > 0) + FRICTION[1] * q
    return half * velocity / xp.sqrt(velocity * velocity + smoothing * smoothing)
