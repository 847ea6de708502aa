"""The muscle @{name}: pull and volume in closed form, for NumPy, JAX (jit, vmap, grad) and PyTorch.

@{facts}

Units: Pa (gauge), m, N, m3. Arguments are numbers or arrays of one library; in double precision where the arrays are.
Licence: MIT OR Apache-2.0.
"""
import sys

LENGTH = @{length}  # m, at rest
SUPPLY = @{supply}  # Pa, upper end of the box
NODES = @{py_nodes}  # contractions 1 - L/LENGTH
LOW, HIGH = NODES[0], NODES[-1]  # ends of the box
KNOTS = (0.0, 0.15, 0.45, 1.0)  # where the functions of P/SUPPLY of second degree begin
A = @{py_a}  # N; functions of the contraction, at the nodes
B = @{py_b}  # N; their slopes
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


def _integrals(a, b):
    """The integral from the first node to each node."""
    sums = [0.0]
    for k in range(len(NODES) - 1):
        g = NODES[k + 1] - NODES[k]
        sums.append(sums[-1] + 0.5 * g * (a[k] + a[k + 1] + g / 6 * (b[k] - b[k + 1])))
    return sums


_TABLES = [(a, b, _integrals(a, b)) for a, b in zip(A, B)]


def _coefficients(xp, e):
    """c, dc/de and the integral of c at a contraction, for each function of the pressure."""
    inside = xp.where(e < LOW, LOW + 0 * e, xp.where(e > HIGH, HIGH + 0 * e, e))
    beyond, n = e - inside, sum((inside >= node) * 1 for node in NODES[1:-1])
    like = {"dtype": e.dtype, "device": e.device} if xp.__name__ == "torch" else {"dtype": e.dtype}

    def pick(values):
        values = xp.asarray(values, **like)
        return values[n], values[n + 1]

    left, right = pick(NODES)
    h = right - left
    t = (inside - left) / h
    s, t3, t4 = 1 - t, t * t * t, t * t * t * t
    value = (1 + 2 * t) * s * s, h * t * s * s, t * t * (3 - 2 * t), -h * t * t * s
    by_e = -6 * t * s / h, s * (1 - 3 * t), 6 * t * s / h, t * (3 * t - 2)
    area = h * (t - t3 + t4 / 2), h * h * (t * t / 2 - 2 / 3 * t3 + t4 / 4), h * (t3 - t4 / 2), h * h * (t4 / 4 - t3 / 3)
    out = []
    for a, b, sums in _TABLES:
        (a0, a1), (b0, b1) = pick(a), pick(b)
        c, slope, integral = (w[0] * a0 + w[1] * b0 + w[2] * a1 + w[3] * b1 for w in (value, by_e, area))
        out.append((c + slope * beyond, slope, pick(sums)[0] + integral + beyond * (c + 0.5 * slope * beyond)))
    return list(zip(*out))


def _functions(xp, q):
    """The functions of the pressure, and their slopes; tangents outside of the box."""
    value, slope = [1 + 0 * q, q], [0 * q, 1 + 0 * q]
    over = xp.where(q > 1, q - 1, 0 * q)
    for knot in KNOTS[:-1]:
        t = xp.where(q <= knot, 0 * q, xp.where(q <= 1, q - knot, 1 - knot + 0 * q))
        value.append(t * (t + 2 * over))
        slope.append(2 * t)
    return value, slope


def _sum(c, functions):
    return sum(one * function for one, function in zip(c, functions))


def force(pressure, length):
    """Pull F in N; 0 where the muscle would have to push."""
    xp, (pressure, length) = _arrays(pressure, length)
    pull = _sum(_coefficients(xp, 1 - length / LENGTH)[0], _functions(xp, pressure / SUPPLY)[0])
    return xp.where(pull > 0, pull, 0 * pull)


def status(pressure, length):
    """0 inside of the box where the muscle pulls, or a sum of SLACK, PRESSURE_OUTSIDE, CONTRACTION_OUTSIDE."""
    xp, (pressure, length) = _arrays(pressure, length)
    q, e = pressure / SUPPLY, 1 - length / LENGTH
    slack = _sum(_coefficients(xp, e)[0], _functions(xp, q)[0]) <= 0
    return SLACK * slack + PRESSURE_OUTSIDE * ((pressure < 0) | (pressure > SUPPLY)) + CONTRACTION_OUTSIDE * ((e < LOW) | (e > HIGH))


def stiffness(pressure, length):
    """dF/dL at constant pressure, N/m."""
    xp, (pressure, length) = _arrays(pressure, length)
    phi, (c, slope, _) = _functions(xp, pressure / SUPPLY)[0], _coefficients(xp, 1 - length / LENGTH)
    by_length = -_sum(slope, phi) / LENGTH
    return xp.where(_sum(c, phi) > 0, by_length, 0 * by_length)


def force_per_pressure(pressure, length):
    """dF/dP at constant length, m2."""
    xp, (pressure, length) = _arrays(pressure, length)
    (phi, slope), c = _functions(xp, pressure / SUPPLY), _coefficients(xp, 1 - length / LENGTH)[0]
    by_pressure = _sum(c, slope) / SUPPLY
    return xp.where(_sum(c, phi) > 0, by_pressure, 0 * by_pressure)


def pressure(force, length):
    """Pressure in Pa at which the muscle pulls with a force; 0 where it pulls more without pressure, NaN where no pressure does it."""
    xp, (force, length) = _arrays(force, length)
    c = _coefficients(xp, 1 - length / LENGTH)[0]
    pull, slope, curve, one = c[0], c[1], 0 * c[0], 1 + 0 * c[0] + 0 * force
    q = float("nan") * one
    # Between two knots the pull is of second degree in the pressure.
    for begin, end, more in zip(KNOTS, KNOTS[1:], c[2:]):
        width, curve = end - begin, curve + more
        missing = xp.where(force > pull, force - pull, 0 * one)
        root = slope * slope + 4 * curve * missing
        below = xp.where(root > 0, slope + xp.sqrt(xp.where(root > 0, root, one)), 0 * one)
        here = (q != q) & (below > 0) & (2 * missing <= below * width)
        q = xp.where(here, begin + 2 * missing / xp.where(below > 0, below, one), q)
        pull, slope = pull + width * (slope + curve * width), slope + 2 * curve * width
    above = (q != q) & (slope > 0) & (force >= pull)
    q = xp.where(above, 1 + (force - pull) / xp.where(slope > 0, slope, one), q)
    return SUPPLY * xp.where(force <= c[0], 0 * one, q)


def pressure_on(force, length, branch):
    """Pressure in Pa for a pull while the muscle shortens (branch -1), lengthens (1), or in the mean of both (0); NaN where the supply is too low. No derivative."""
    xp, (force, length) = _arrays(force, length)
    mean = pressure(force, length)
    if branch == 0:
        return mean
    c = _coefficients(xp, 1 - length / LENGTH)[0]
    sign = 1 if branch > 0 else -1
    top = mean if branch > 0 else SUPPLY + 0 * mean

    def halved(low, high):
        q = 0.5 * (low + high) / SUPPLY
        pull = _sum(c, _functions(xp, q)[0])
        under = xp.where(pull > 0, pull, 0 * pull) + sign * (FRICTION[0] * xp.sqrt(q) + FRICTION[1] * q) < force
        return xp.where(under, SUPPLY * q, low), xp.where(under, high, SUPPLY * q)

    bottom = pressure(0 * force, length) + 0 * mean if branch > 0 else mean
    high = _repeated(xp, 40, halved, (bottom, top))[1]
    if branch < 0:
        high = xp.where(high < top, high, float("nan") + 0 * high)
    return xp.where(bottom < top, high, mean)


def contraction(force, pressure):
    """Contraction 1 - L/LENGTH at which the muscle pulls with a force at a pressure."""
    xp, (force, pressure) = _arrays(force, pressure)
    q = pressure / SUPPLY
    phi = _functions(xp, q)[0]

    def pull(e):
        c, slope, _ = _coefficients(xp, e)
        return _sum(c, phi), _sum(slope, phi)

    low, high = LOW + 0 * q + 0 * force, HIGH + 0 * q + 0 * force
    (pull_low, slope_low), (pull_high, slope_high) = pull(low), pull(high)
    beyond_low, beyond_high = force >= pull_low, force <= pull_high
    a, b = _stopped(xp, low), _stopped(xp, high)
    wanted, fixed = _stopped(xp, force), [_stopped(xp, value) for value in phi]

    def halved(a, b):
        middle = 0.5 * (a + b)
        over = _sum(_coefficients(xp, middle)[0], fixed) > wanted
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
    phi, slope = _functions(xp, q)
    slack = _sum(_coefficients(xp, e)[0], phi) <= 0
    integral = _coefficients(xp, xp.where(slack, contraction(0 * q, pressure), e))[2]
    return _sum(V, phi) + LENGTH / SUPPLY * _sum(integral, slope)


def friction(pressure, velocity, smoothing=1e-3):
    """What friction adds to the pull while the length changes by a velocity in m/s (positive: longer); smooth at rest."""
    xp, (pressure, velocity) = _arrays(pressure, velocity)
    q = xp.where(pressure > 0, pressure / SUPPLY, 0 * pressure)
    half = FRICTION[0] * xp.sqrt(xp.where(q > 0, q, 1 + 0 * q)) * (q > 0) + FRICTION[1] * q
    return half * velocity / xp.sqrt(velocity * velocity + smoothing * smoothing)
