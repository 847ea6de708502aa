#!/usr/bin/env python3
"""Integrates one motion on its own (SciPy, the bare equations in SI units) and compares it with what the program says, to 1e-6.

Usage: target/debug/examples/exported > FILE; motion.py FILE
The numbers of the drive stand here again; nothing is read but the answer.
"""

import json
import sys

import numpy as np
from scipy.integrate import Radau
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


# Elements that stick and slip: their limits follow the pressure, their stiffness the largest of them so far.
ELEMENTS = (np.arange(3000) + 0.5) / 3000


def moved(x, gauge, memory):
    """The forces of the elements, and the largest limit."""
    forces, at, largest = memory
    limit = LEVEL * (gauge * 1e-6) ** BETA
    largest = max(largest, limit)
    most = 2 * ELEMENTS * limit
    return np.clip(forces + 2 * largest / PRESLIDING * (x - at), -most, most), largest


def rates(y, command, memory):
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
    pull = force(gauge, e) - moved(x, gauge, memory)[0].mean()
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
memory, sign = (0 * ELEMENTS, x, 0.0), 1.0

times, states = np.array(answer["time_s"]), []
done = 0
for begin, end, command in [(0, 0.1, 0.1e6), (0.1, 0.6, 0.3e6), (0.6, 1.0, 0.15e6)]:
    t = begin
    while t < end - 1e-15:
        solver = Radau(
            lambda _, y: rates(y, command, memory),
            t,
            y,
            end,
            rtol=1e-11,
            atol=[1e-13, 1e-12, 1e-4, 1e-15, 1e-12],
            max_step=1e-4,
        )
        reversal = False
        while solver.status == "running" and not reversal:
            solver.step()
            assert solver.status != "failed"
            within = solver.dense_output()
            t, y = solver.t, solver.y
            # The sign of the speed is fixed between its zeros.
            reversal = sign * y[1] < -1e-9 and sign * within(solver.t_old)[1] > 0
            if reversal:
                t = brentq(lambda t: within(t)[1], solver.t_old, t, xtol=1e-16)
                y, sign = within(t), -sign
            last = t + (1e-12 if end == 1.0 else -1e-12)
            while done < len(times) and times[done] <= last:
                states.append(within(min(times[done], t)))
                done += 1
            forces, largest = moved(y[0], y[2] - P_ATM, memory)
            memory = forces, y[0], largest

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
