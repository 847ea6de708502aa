#!/usr/bin/env python3
"""Integrates one motion on its own (SciPy, the bare equations in SI units) and compares it with what the program says, to 1e-6.

Usage: target/debug/examples/exported > FILE; motion.py FILE
The numbers of the drive stand here again; nothing is read but the answer.
"""

import json
import sys

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

R, GAMMA, P_ATM, T0, RHO0 = 287.05, 1.4, 101325.0, 293.15, 1.185
CP = GAMMA * R / (GAMMA - 1)

D0, L0, ANGLE = 20e-3, 220e-3, np.radians(24)
MASS, SPRING, PRELOAD, DAMPER = 5.0, 2000.0, 10.0, 150.0
SUPPLY, HA, DEAD = 0.6e6 + P_ATM, 0.2, 10e-6
HOSE_D, HOSE_L = 4e-3, 0.5
LAG, GAIN = 0.005, 20e-6
LEVEL, BETA, PRESLIDING = 15.0, 0.7, 0.5e-3

AREA = np.pi * D0**2 / (4 * np.sin(ANGLE) ** 2)
COS2 = np.cos(ANGLE) ** 2
HOSE_C = 0.029 * HOSE_D**2 / np.sqrt(HOSE_L / HOSE_D**1.25 + 510)
HOSE_B = 474 * HOSE_C / HOSE_D**2
OUTSIDE = DEAD + np.pi / 4 * HOSE_D**2 * HOSE_L


def force(gauge, e):
    return AREA * gauge * (3 * (1 - e) ** 2 * COS2 - 1)


def volume(e):
    return AREA * L0 * (1 - e) * (1 - (1 - e) ** 2 * COS2) + OUTSIDE


def volume_e(e):
    return AREA * L0 * (3 * (1 - e) ** 2 * COS2 - 1)


def shape(r, b):
    def root(x):
        return np.sqrt(1 - ((x - b) / (1 - b)) ** 2)

    if r <= b:
        return 1.0
    if r <= 0.99:
        return root(r)
    value = root(0.99)
    slope = 0.01 * (0.99 - b) / ((1 - b) ** 2 * value)  # of s = (1 − r)/0.01
    s = (1 - r) / 0.01
    return (2 * value - slope) * s + (slope - value) * s * s


def flow(c, b, p1, t1, p2, t2):
    """From 1 to 2, with the temperature of where it comes from."""
    if p1 < p2:
        g, t = flow(c, b, p2, t2, p1, t1)
        return -g, t
    return c * p1 * RHO0 * np.sqrt(T0 / t1) * shape(p2 / p1, b), t1


def with_hose(c, b):
    whole = (c**-3 + HOSE_C**-3) ** (-1 / 3)
    return whole, 1 - whole**2 * ((1 - b) / c**2 + (1 - HOSE_B) / HOSE_C**2)


def share(x, turns):
    """z of Masing's rule after the beginning and the reversals (position, z); what a closed loop leaves is cut off."""
    while len(turns) > 1 and abs(x - turns[-1][0]) >= abs(
        turns[-1][0] - turns[-2][0]
    ) * (2 if len(turns) == 2 else 1):
        del turns[-1 if len(turns) == 2 else -2 :]
    (begin, z), width = turns[-1], min(len(turns), 2)
    return z + np.sign(x - begin) * width * (
        1 - max(0, 1 - abs(x - begin) / (width * PRESLIDING)) ** 2
    )


def rates(_, y, command, turns):
    x, v, p, m, u = y
    e, gauge = x / L0, p - P_ATM
    vol, t = volume(e), p * volume(e) / (m * R)
    g_in, t_in = (
        (0.0, T0) if u <= 0 else flow(*with_hose(0.5e-8 * u, 0.3), SUPPLY, T0, p, t)
    )
    g_ex, t_ex = (
        (0.0, T0) if u >= 0 else flow(*with_hose(-0.6e-8 * u, 0.25), P_ATM, T0, p, t)
    )
    heat = HA * (T0 - t)
    dp = (
        (GAMMA - 1) * (CP * (g_in * t_in + g_ex * t_ex) + heat)
        - GAMMA * p * volume_e(e) * v / L0
    ) / vol
    pull = force(gauge, e) - LEVEL * (gauge * 1e-6) ** BETA * share(x, turns[:])
    dv = (pull - MASS * 9.80665 - PRELOAD - SPRING * x - DAMPER * v) / MASS
    du = (np.clip(GAIN * (command + P_ATM - p), -1, 1) - u) / LAG
    return [v, dv, dp, g_in + g_ex, du]


answer = json.load(open(sys.argv[1]))["series"]
gauge = 0.1e6
x = brentq(
    lambda x: force(gauge, x / L0) - MASS * 9.80665 - PRELOAD - SPRING * x,
    0,
    0.06,
    xtol=1e-16,
)
y = np.array([x, 0, gauge + P_ATM, (gauge + P_ATM) * volume(x / L0) / (R * T0), 0])
turns, sign = [(x, 0.0)], 1.0

times, states = np.array(answer["time_s"]), []
done = 0
for begin, end, command in [(0, 0.1, 0.1e6), (0.1, 0.6, 0.3e6), (0.6, 1.0, 0.15e6)]:
    t = begin
    while t < end - 1e-15:
        # The sign of the speed is fixed between its zeros.
        def zero(_, y, *args):
            return y[1]

        zero.terminal, zero.direction = True, -sign
        found = solve_ivp(
            rates,
            (t, end),
            y,
            "Radau",
            rtol=1e-11,
            atol=[1e-13, 1e-12, 1e-4, 1e-15, 1e-12],
            events=zero,
            args=(command, turns),
            dense_output=True,
            max_step=2e-3,
        )
        assert found.success, found.message
        while done < len(times) and times[done] <= found.t[-1] + (
            1e-12 if end == 1.0 else -1e-12
        ):
            states.append(found.sol(min(times[done], found.t[-1])))
            done += 1
        t, y = found.t[-1], found.y[:, -1]
        if found.status == 1:
            turns.append((y[0], share(y[0], turns)))
            sign, y[1] = -sign, -sign * 2e-9

states = np.array(states)
assert len(states) == len(times), (len(states), len(times))
wrong = False
for name, ours, theirs, scale in [
    (
        "shortening",
        np.array(answer["contraction"]) * L0 * 1e3,
        states[:, 0] * 1e3,
        40.0,
    ),
    ("pressure", answer["pressure_mpa"], (states[:, 2] - P_ATM) * 1e-6, 0.3),
    ("air mass", answer["air_mass_g"], states[:, 3] * 1e3, 0.3),
    ("opening", answer["opening"], states[:, 4], 1.0),
    ("velocity", answer["velocity_mm_per_s"], states[:, 1] * 1e3, 1000.0),
]:
    error = np.max(np.abs(np.array(ours) - theirs)) / scale
    wrong |= not error < 1e-6
    print(f"{name:12} {error:.1e}")
sys.exit("motion: the independent integration disagrees" if wrong else 0)
