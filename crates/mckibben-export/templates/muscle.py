"""The muscle @{name}: pull and volume in closed form, for NumPy, JAX (jit, vmap, grad) and PyTorch.

@{facts}

Units: Pa (gauge), m, N, m3. Arguments are numbers or arrays of one library; in double precision where the arrays are. Outside of the box each answer
is that of its nearest point; what is not a number counts as the lower end.
"""
import math
import sys

LENGTH = @{length}  # m, at rest
CORD = @{cord}  # m: a rope or rod between the muscle and what it pulls; the `length` of each function is that of both
SUPPLY = @{supply}  # Pa, upper end of the box
ALLOWED, LEAST_BURST = @{allowed}, @{burst}  # Pa: no pressure in use is above the first; the second 0 where it is not known
NODES = @{nodes}  # contractions 1 - L/LENGTH
LOW, HIGH = NODES[0], NODES[-1]  # ends of the box
KNOTS = (0.0, 0.15, 0.45, 1.0)  # where the functions of P/SUPPLY of second degree begin
A = @{a}  # N; functions of the contraction, at the nodes
B = @{b}  # N; their slopes
V = @{v}  # m3
FRICTION = @{friction}  # half the hysteresis is (f0 + f1 e + f2 e^2) sqrt(q) + (f3 + f4 e + f5 e^2) q in N, e the contraction; it builds up over f6 in m
# What a status says: a sum of these.
SLACK, PRESSURE_OUTSIDE, CONTRACTION_OUTSIDE, NO_ANSWER = 1, 2, 4, 8


class _Numbers:
    """What a library of arrays does, of one number."""

    where = staticmethod(lambda condition, yes, no: yes if condition else no)
    asarray = staticmethod(lambda values: values)
    ones_like = staticmethod(lambda value: 1.0)
    sqrt, sin, cos, abs = math.sqrt, math.sin, math.cos, abs


def _arrays(*values):
    """The library of the arguments, and the arguments as its arrays."""
    if all(isinstance(value, (int, float)) for value in values):
        return _Numbers, [float(value) for value in values]
    for value in values:
        kind = type(value).__module__.split(".")[0]
        if hasattr(value, "is_symbolic"):
            raise TypeError("symbols of CasADi are not supported; the file of target c can be called as an external function")
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


def _contraction_at(length):
    return 1 - (length - CORD) / LENGTH


def _within(xp, value, low, high):
    """The nearest number from `low` to `high`; `low` of what is not a number."""
    one = xp.ones_like(value)
    return xp.where(value > high, high * one, xp.where(value >= low, value, low * one))


def _integrals(a, b):
    """The integral from the first node to each node."""
    sums = [0.0]
    for k in range(len(NODES) - 1):
        g = NODES[k + 1] - NODES[k]
        sums.append(sums[-1] + 0.5 * g * (a[k] + a[k + 1] + g / 6 * (b[k] - b[k + 1])))
    return sums


_TABLES = [(a, b, _integrals(a, b)) for a, b in zip(A, B)]


def _coefficients(xp, e):
    """c, dc/de and the integral of c at a contraction, for each function of the pressure; outside of the box those of its end."""
    inside = _within(xp, e, LOW, HIGH)
    n = sum((inside >= node) * 1 for node in NODES[1:-1])
    like = {key: getattr(e, key) for key in ("dtype", "device")[: 0 if xp is _Numbers else 1 + (xp.__name__ == "torch")]}

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
        out.append((c, slope, pick(sums)[0] + integral))
    return list(zip(*out))


def _functions(xp, q):
    """The functions of the pressure, and their slopes; outside of the box those of its end."""
    q = _within(xp, q, 0.0, 1.0)
    t = [xp.where(q > knot, q - knot, 0 * q) for knot in KNOTS[:-1]]
    return [1 + 0 * q, q, *(one * one for one in t)], [0 * q, 1 + 0 * q, *(2 * one for one in t)]


def _sum(c, functions):
    return sum(one * function for one, function in zip(c, functions))


def _above_zero(xp, value):
    return xp.where(value > 0, value, 0 * value)


def _outside(value, low, high):
    """Also what is not a number."""
    return ((value >= low) & (value <= high)) == 0


def _moved(xp, at, answered, miss, slope, low, high):
    """A root that was found without derivatives, with them, by the theorem of implicit functions: `miss` is zero there and has them."""
    at = xp.where(answered, at - miss / _stopped(xp, xp.where(slope != 0, slope, xp.ones_like(at))), at)
    return xp.where(at < low, low * xp.ones_like(at), xp.where(at > high, high * xp.ones_like(at), at))


def force(pressure, length):
    """Pull F in N; 0 where the muscle would have to push."""
    xp, (pressure, length) = _arrays(pressure, length)
    pull = _sum(_coefficients(xp, _contraction_at(length))[0], _functions(xp, pressure / SUPPLY)[0])
    return xp.where(pull <= 0, 0 * pull, pull)


def status(pressure, length):
    """Of force, stiffness, force_per_pressure, volume and friction: 0 inside of the box where the muscle pulls, or a sum of SLACK, PRESSURE_OUTSIDE, CONTRACTION_OUTSIDE."""
    xp, (pressure, length) = _arrays(pressure, length)
    e = _contraction_at(length)
    slack = _sum(_coefficients(xp, e)[0], _functions(xp, pressure / SUPPLY)[0]) <= 0
    return SLACK * slack + PRESSURE_OUTSIDE * _outside(pressure, 0, SUPPLY) + CONTRACTION_OUTSIDE * _outside(e, LOW, HIGH)


def stiffness(pressure, length):
    """dF/dL at constant pressure, N/m."""
    xp, (pressure, length) = _arrays(pressure, length)
    phi, (c, slope, _) = _functions(xp, pressure / SUPPLY)[0], _coefficients(xp, _contraction_at(length))
    by_length = -_sum(slope, phi) / LENGTH
    return xp.where(_sum(c, phi) <= 0, 0 * by_length, by_length)


def force_per_pressure(pressure, length):
    """dF/dP at constant length, m2."""
    xp, (pressure, length) = _arrays(pressure, length)
    (phi, slope), c = _functions(xp, pressure / SUPPLY), _coefficients(xp, _contraction_at(length))[0]
    by_pressure = _sum(c, slope) / SUPPLY
    return xp.where(_sum(c, phi) <= 0, 0 * by_pressure, by_pressure)


def _friction_factors(xp, length):
    """Of half the hysteresis: of sqrt(q) and of q."""
    e = _within(xp, _contraction_at(length), LOW, HIGH)
    return (FRICTION[i] + e * (FRICTION[i + 1] + e * FRICTION[i + 2]) for i in (0, 3))


def _pressure(xp, force, length, branch):
    """The pressure of a pull, and where the box has one."""
    moving_c, wanted, sign = _coefficients(xp, _contraction_at(length))[0], _stopped(xp, force), (branch > 0) - (branch < 0)
    c = [_stopped(xp, one) for one in moving_c]
    pull, slope, curve, one = c[0], c[1], 0 * c[0], xp.ones_like(wanted)
    more, q = wanted > c[0], float("nan") * one
    # Without pressure there is no friction: what pulls too much there, or would have to push, has no answer on any branch.
    answered = (wanted >= 0) & (wanted >= c[0])
    by_root, by_pressure = _friction_factors(xp, length)

    def moving(c, q):
        """The pull on the branch, and its slope."""
        (phi, by_q), root = _functions(xp, q), xp.sqrt(xp.where(q > 0, q, one))
        half, slope = by_root * root * (q > 0) + by_pressure * q, 0.5 * by_root / root + by_pressure
        return _sum(c, phi) + sign * _above_zero(xp, half), _sum(c, by_q) + sign * (half > 0) * slope

    def halved(low, high):
        middle = 0.5 * (low + high)
        under = _above_zero(xp, moving(c, middle)[0]) < wanted
        return xp.where(under, middle, low), xp.where(under, high, middle)

    if sign:
        q = _repeated(xp, 50, halved, (0 * one, one))[1]
        q = xp.where(q < 1, q, float("nan") * one)
    for begin, end, c_begin in () if sign else zip(KNOTS, KNOTS[1:], c[2:]):  # the pull is of second degree in the pressure there
        width, curve = end - begin, curve + c_begin
        missing = xp.where(wanted > pull, wanted - pull, 0 * one)
        root = slope * slope + 4 * curve * missing
        below = xp.where(root > 0, slope + xp.sqrt(xp.where(root > 0, root, one)), 0 * one)
        here = (q != q) & (below > 0) & (2 * missing < below * width)
        q = xp.where(here, begin + 2 * missing / xp.where(below > 0, below, one), q)
        pull, slope = pull + width * (slope + curve * width), slope + 2 * curve * width
    # Within a millionth the supply gives its own pull.
    answered = answered & ((q == q) | (more == 0) | (wanted <= (1 + 1e-6) * _above_zero(xp, moving(c, one)[0])))
    q = xp.where(more & (wanted >= 0), xp.where(q == q, q, one), 0 * one)
    value, slope = moving(moving_c, q)
    return SUPPLY * _moved(xp, q, answered & more, value - force, slope, 0, 1), answered


def pressure(force, length):
    """Pressure in Pa at which the muscle pulls with a force. 0 where it pulls more without pressure, where it would have to push, and of what is not a number; SUPPLY where the supply is too low."""
    xp, values = _arrays(force, length)
    return _pressure(xp, *values, 0)[0]


def pressure_on(force, length, branch):
    """The same while the muscle shortens (branch -1), lengthens (1), or in the mean of both (0)."""
    xp, values = _arrays(force, length)
    return _pressure(xp, *values, branch)[0]


def pressure_status(force, length, branch=0):
    """Of pressure and pressure_on: 0, or a sum of CONTRACTION_OUTSIDE and NO_ANSWER (no pressure of the box gives this pull)."""
    xp, (force, length) = _arrays(force, length)
    return NO_ANSWER * (_pressure(xp, force, length, branch)[1] == 0) + CONTRACTION_OUTSIDE * _outside(_contraction_at(length), LOW, HIGH)


def _contraction(xp, force, pressure):
    """The contraction of a pull, and where the box has one."""
    phi = _functions(xp, pressure / SUPPLY)[0]
    still, wanted = [_stopped(xp, one) for one in phi], _stopped(xp, _above_zero(xp, force))

    def halved(a, b):
        middle = 0.5 * (a + b)
        over = _sum(_coefficients(xp, middle)[0], still) > wanted
        return xp.where(over, middle, a), xp.where(over, b, middle)

    at = 0.5 * sum(_repeated(xp, 60, halved, (LOW * xp.ones_like(wanted), HIGH * xp.ones_like(wanted))))
    c, slope, _ = _coefficients(xp, at)
    miss, slope = _sum(c, phi) - force, _sum(slope, phi)
    # Within a thousandth of the contraction an end of the box has its own pull.
    answered = (force >= 0) & (xp.abs(miss) <= -1e-3 * slope)
    return _moved(xp, at, answered, miss, slope, LOW, HIGH), answered


def contraction(force, pressure):
    """Contraction 1 - L/LENGTH at which the muscle pulls with a force at a pressure; an end of the box where the box has none, the lower one of what is not a number."""
    xp, values = _arrays(force, pressure)
    return _contraction(xp, *values)[0]


def contraction_status(force, pressure):
    """Of contraction: 0, or a sum of PRESSURE_OUTSIDE and NO_ANSWER (no contraction of the box has this pull)."""
    xp, (force, pressure) = _arrays(force, pressure)
    return NO_ANSWER * (_contraction(xp, force, pressure)[1] == 0) + PRESSURE_OUTSIDE * _outside(pressure, 0, SUPPLY)


def volume(pressure, length):
    """Volume of the cavity, m3; dF/dP = -dV/dL. A slack muscle hangs at its free contraction."""
    xp, (pressure, length) = _arrays(pressure, length)
    q, e = pressure / SUPPLY, _contraction_at(length)
    phi, slope = _functions(xp, q)
    slack = _sum(_coefficients(xp, e)[0], phi) <= 0
    # The free contraction is looked for where it is needed; JAX does not say before it runs.
    if xp.__name__ == "jax.numpy" or (slack if xp is _Numbers else slack.any()):
        e = xp.where(slack, contraction(0 * xp.ones_like(q), pressure), e)
    integral = _coefficients(xp, e)[2]
    return _sum(V, phi) + LENGTH / SUPPLY * _sum(integral, slope)


def friction(pressure, length, velocity, smoothing=1e-3):
    """What friction adds to the pull while the length changes by a velocity in m/s (positive: longer); smooth at rest. With it the muscle pulls or is slack: it never pushes."""
    xp, (pressure, length, velocity) = _arrays(pressure, length, velocity)
    phi = _functions(xp, pressure / SUPPLY)[0]
    q, pull = phi[1], _sum(_coefficients(xp, _contraction_at(length))[0], phi)
    by_root, by_q = _friction_factors(xp, length)
    half = _above_zero(xp, by_root * xp.sqrt(xp.where(q > 0, q, 1 + 0 * q)) * (q > 0) + by_q * q)
    one = xp.ones_like(velocity)
    size = xp.sqrt(velocity * velocity + smoothing * smoothing)
    share = xp.where((size > 0) & (size - size == 0), velocity / xp.where(size > 0, size, one), 0 * one)
    return _above_zero(xp, pull + half * share) - _above_zero(xp, pull)
