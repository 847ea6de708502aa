"""The joint @{name}: torque, stiffness and pressures, for NumPy, JAX (jit, vmap, grad) and PyTorch.

@{facts}

Units: rad, N m, Pa (gauge), m. Angles are counterclockwise from the neutral angle. The torque is what muscles, spring and weight exert on the
surroundings together. `pressures` has one of each muscle; arguments are numbers or arrays of one library.
"""
@{imports}

MUSCLES = (@{modules},)
# Of the muscles and of a spring on a rope: the radius of a pulley, or, where it is 0, x and y of a point of the fixed link and of one of the moving one.
PATHS = @{paths}
ROPE = @{rope}  # a spring on a rope pulls with ROPE[0] + ROPE[1] length, N and N/m, never below 0
TORSION = @{torsion}  # a torsion spring turns with -(TORSION[0] + TORSION[1] angle), N m and N m/rad
WEIGHT = @{weight}  # the weight turns with -WEIGHT[0] cos(angle + WEIGHT[1]), N m and rad
RANGE = @{range}  # of the angle
ANGLE_OUTSIDE = 16  # what a status adds to those of the muscles
_PULLS = 24  # pulls among which a stiffness is looked for
_arrays, _stopped, _repeated, _within = MUSCLES[0]._arrays, MUSCLES[0]._stopped, MUSCLES[0]._repeated, MUSCLES[0]._within


def _path(xp, path, angle):
    """Length (of a pulley from that at the neutral angle), arm -d length/d angle, and the slope of the arm."""
    radius, *a, bx, by = path
    angle = _within(xp, angle, *RANGE)
    if radius:
        return -radius * angle, radius + 0 * angle, 0 * angle
    s, c = xp.sin(angle), xp.cos(angle)
    x, y = c * bx - s * by, s * bx + c * by
    length = xp.sqrt((a[0] - x) * (a[0] - x) + (a[1] - y) * (a[1] - y))
    arm = (a[1] * x - a[0] * y) / length
    return length, arm, (arm * arm - a[0] * x - a[1] * y) / length


def _passive(xp, angle):
    """Torque of spring and weight, and its -d/d angle."""
    angle = _within(xp, angle, *RANGE)
    torque = -WEIGHT[0] * xp.cos(angle + WEIGHT[1]) - TORSION[0] - TORSION[1] * angle
    stiffness = TORSION[1] - WEIGHT[0] * xp.sin(angle + WEIGHT[1])
    if not ROPE[1]:
        return torque, stiffness
    length, arm, slope = _path(xp, PATHS[2], angle)
    force = ROPE[0] + ROPE[1] * length
    more = ROPE[1] * arm * arm - force * slope
    return torque + xp.where(force > 0, force * arm, 0 * force), stiffness + xp.where(force > 0, more, 0 * force)


def _at(xp, pressures, angle):
    torque, stiffness = _passive(xp, angle)
    for muscle, path, pressure in zip(MUSCLES, PATHS, pressures):
        length, arm, slope = _path(xp, path, angle)
        force = muscle.force(pressure, length)
        torque, stiffness = torque + force * arm, stiffness + muscle.stiffness(pressure, length) * arm * arm - force * slope
    return torque, stiffness


def torque(pressures, angle):
    """Torque in N m."""
    xp, (angle, *pressures) = _arrays(angle, *pressures)
    return _at(xp, pressures, angle)[0]


def stiffness(pressures, angle):
    """-d torque/d angle at constant pressures, N m/rad."""
    xp, (angle, *pressures) = _arrays(angle, *pressures)
    return _at(xp, pressures, angle)[1]


def torque_per_pressure(pressures, angle):
    """The slope of the torque in the pressure of each muscle, N m/Pa."""
    xp, (angle, *pressures) = _arrays(angle, *pressures)
    places = [_path(xp, path, angle) for path in PATHS]
    return tuple(arm * muscle.force_per_pressure(p, length) for muscle, p, (length, arm, _) in zip(MUSCLES, pressures, places))


def status(pressures, angle):
    """0, or a sum of ANGLE_OUTSIDE and the statuses of the muscles: some muscle is slack, or outside of its box."""
    xp, (angle, *pressures) = _arrays(angle, *pressures)
    each = [muscle.status(p, _path(xp, path, angle)[0]) for muscle, path, p in zip(MUSCLES, PATHS, pressures)]
    both = sum(bit * (sum((one & bit > 0) * 1 for one in each) > 0) for bit in (1, 2, 4))
    return both + ANGLE_OUTSIDE * (((angle >= RANGE[0]) & (angle <= RANGE[1])) == 0)


def friction(pressures, angle, rate, smoothing=1e-3):
    """What friction of the muscles adds to the torque while the joint turns with a rate in rad/s; smooth at rest."""
    xp, (angle, rate, *pressures) = _arrays(angle, rate, *pressures)
    places = [_path(xp, path, angle) for path in PATHS]
    return sum(arm * muscle.friction(p, length, -arm * rate, arm * smoothing) for muscle, p, (length, arm, _) in zip(MUSCLES, pressures, places))


def _ends(xp, angle):
    """Length, arm, and pull without pressure and at the supply, of each muscle."""
    places = [_path(xp, path, angle)[:2] for path in PATHS]
    return [(length, arm, muscle.force(0 * length, length), muscle.force(muscle.SUPPLY + 0 * length, length)) for muscle, (length, arm) in zip(MUSCLES, places)]


def limits(angle):
    """Least and largest torque at an angle, with pressures from 0 to the supply."""
    xp, (angle,) = _arrays(angle)
    least = most = _passive(xp, angle)[0]
    for _, arm, without, full in _ends(xp, angle):
        least = least + arm * xp.where(arm > 0, without, full)
        most = most + arm * xp.where(arm > 0, full, without)
    return least, most


def _pulled(xp, needed, ends, first):
    """The pressures at which the muscles pull with `first` and with what else is needed; 0 of a muscle that need not pull (a millionth of its pull at the supply is rounding)."""
    pulls = [first, *((needed - first * ends[0][1]) / arm for _, arm, *_ in ends[1:])]
    return tuple(xp.where(pull > 1e-6 * full, muscle.pressure(xp.where(pull > 0, pull, 1 + 0 * pull), length), 0 * pull) for muscle, pull, (length, _, _, full) in zip(MUSCLES, pulls, ends))


def _pressures(xp, angle, torque, stiffness):
    # Of an angle that is not finite nothing is known.
    needed, ends = torque - _passive(xp, angle)[0] + (angle - angle), _ends(xp, angle)
    _, arm, without, full = ends[0]
    # The pulls of the first muscle at which the second can do the rest.
    both = [(needed - end * other[1]) / arm for other in ends[1:] for end in other[2:]] or [needed / arm]
    low = xp.where(both[0] < both[-1], both[0], both[-1])
    high = xp.where(both[0] < both[-1], both[-1], both[0])
    answered = (low <= full + 1e-6 * full) & (high >= without - 1e-6 * full)
    low = xp.where(low > without, xp.where(low < full, low, full), without)
    high = xp.where(high < full, xp.where(high > low, high, low), full)
    sought = stiffness is not None and len(MUSCLES) > 1
    wanted = needed + stiffness if sought else needed
    finite = wanted - wanted == 0
    answered = answered & finite
    first = low
    if sought:
        first, met = _first(xp, angle, needed, stiffness, ends, low, high)
        # 0 asks for none.
        first, answered = xp.where(answered & (stiffness != 0), first, low), answered & (met | (stiffness == 0))
    nothing = 0 * xp.ones_like(needed)
    return tuple(xp.where(finite, p, nothing) for p in _pulled(xp, needed, ends, first)), answered


def _first(xp, angle, needed, stiffness, ends, low, high):
    """The pull of the first muscle for a stiffness, or that which comes near it, and whether it is met: where it jumps, no side has it."""
    still = [_stopped(xp, value) for value in (angle, needed, stiffness, low, high)]
    still_ends = [tuple(_stopped(xp, value) for value in end) for end in ends]

    def miss(first):
        return _at(xp, _pulled(xp, still[1], still_ends, first), still[0])[1] - still[2]

    # Both muscles are taut at the ends.
    (_, arm, _, full), (_, other_arm, _, other_full) = still_ends
    taut, half = 1e-5 * (full + other_full * xp.abs(other_arm / arm)), 0.5 * (still[4] - still[3])
    taut = xp.where(taut < half, taut, half)

    def looked(i, a, b, before, both, between, at, near, best):
        last, at = at, still[3] + taut + 2 * (half - taut) * i / _PULLS
        pressures = _pulled(xp, still[1], still_ends, at)
        here = _at(xp, pressures, still[0])[1] - still[2]
        size, one = xp.abs(here), 1 + 0 * at
        for muscle, p, (length, *_) in zip(MUSCLES, pressures, still_ends):
            one = xp.where(muscle.force(p, length) > 0, one, 0 * at)
        new = (between == 0) & (both > 0) & (one > 0) & ((here < 0) != (before < 0))
        a, b, between = xp.where(new, last, a), xp.where(new, at, b), xp.where(new, 1 + 0 * at, between)
        before = xp.where(between > 0, before, here)
        nearer = (one > 0) & (size < near)
        return i + 1, a, b, before, one, between, at, xp.where(nearer, size, near), xp.where(nearer, at, best)

    zero = 0 * still[3]
    slack = xp.abs(miss(still[3]))
    _, a, b, before, _, between, _, near, best = _repeated(xp, _PULLS + 1, looked, (zero, still[3], still[3], zero, zero, zero, still[3], slack, still[3]))
    last = xp.abs(miss(still[4]))
    near, best = xp.where(last < near, last, near), xp.where(last < near, still[4], best)

    def halved(a, b):
        middle = 0.5 * (a + b)
        same = (miss(middle) < 0) == (before < 0)
        return xp.where(same, middle, a), xp.where(same, b, middle)

    enough = 1e-3 * xp.abs(still[2])
    middle = 0.5 * sum(_repeated(xp, 50, halved, (a, b)))
    between = (slack > enough) & (between > 0) & (xp.abs(miss(middle)) <= enough)
    first = xp.where(between, middle, xp.where(slack > enough, best, still[3]))
    # The theorem of implicit functions: zero here, with the derivatives.
    step = 1e-5 * still_ends[0][3]
    slope = (miss(first + step) - miss(first - step)) / (2 * step)
    moving = _at(xp, _pulled(xp, needed, ends, first), angle)[1] - stiffness
    moving = (moving - _stopped(xp, moving)) / xp.where(slope != 0, slope, 1 + zero)
    return xp.where(between, first - moving, first), between | (near <= enough)


def pressures(angle, torque, stiffness=None):
    """Pressures from 0 to the supply, one of each muscle, for a torque and a stiffness (0 or none: whatever it is) at an angle: the lowest ones. Where nothing gives what is wanted, those that come near it; see `pressures_status`."""
    if stiffness is None:
        xp, values = _arrays(angle, torque)
        return _pressures(xp, *values, None)[0]
    xp, values = _arrays(angle, torque, stiffness)
    return _pressures(xp, *values)[0]


def pressures_status(angle, torque, stiffness=None):
    """Of pressures: 0, or a sum of ANGLE_OUTSIDE and NO_ANSWER of the muscles (nothing from 0 to the supply gives torque and stiffness)."""
    xp, values = _arrays(angle, torque, *([] if stiffness is None else [stiffness]))
    answered = _pressures(xp, *values, *([None] if stiffness is None else []))[1]
    return MUSCLES[0].NO_ANSWER * (answered == 0) + ANGLE_OUTSIDE * (((values[0] >= RANGE[0]) & (values[0] <= RANGE[1])) == 0)
