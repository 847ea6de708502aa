#!/usr/bin/env python3
"""Runs the exported OpenSim model in OpenSim, and prints its row of the table of exports. Usage: exports_opensim.py PROGRAM"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import opensim

program, MUSCLE = pathlib.Path(sys.argv[1]).resolve(), "examples/prototype.toml"
ROOT = pathlib.Path(__file__).resolve().parent.parent
opensim.Logger.setLevelString("error")


def run(*words):
    done = subprocess.run(
        [str(w) for w in words], cwd=ROOT, capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, (words, done.stderr[-2000:])
    return json.loads(done.stdout)


with tempfile.TemporaryDirectory() as folder:
    begun = time.monotonic()
    answer = run(
        program,
        "export",
        MUSCLE,
        "--as",
        "opensim",
        "--cord",
        "60mm",
        "-o",
        folder,
        "--format",
        "json",
    )
    path = pathlib.Path(folder) / "muscle_prototype.osim"
    text, form, blocked = path.read_text(), answer["form"], answer["blocked_force_n"]
    rest, supply = form["length_m"], form["supply_pa"]

    def model_at(pressure):
        """The model with this constant pressure."""
        path.write_text(
            re.sub(r"(<Constant>\s*<value>)[^<]*", rf"\g<1>{pressure!r}", text)
        )
        return opensim.Model(str(path))

    # The pull at points against finite elements, where the muscle pulls.
    contractions = [form["contraction_high"] * k / 13 for k in range(14)]
    pressures = [supply * q for q in (0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 1.0)]
    points = run(
        program,
        "curve",
        "isobaric",
        MUSCLE,
        "-p",
        ",".join(f"{p / 1e6:.9g}" for p in pressures),
        "-e",
        ",".join(f"{e:.9g}" for e in contractions),
        "--format",
        "json",
    )["points"]
    errors = []
    for pressure in pressures:
        model = model_at(pressure)
        state = model.initSystem()
        length = model.getCoordinateSet().get(0)
        actuator = opensim.McKibbenActuator.safeDownCast(model.getForceSet().get(0))
        for point in points:
            if (
                abs(1e6 * point["pressure_mpa"] - pressure) > 1
                or point.get("force_n", 0) <= 0
            ):
                continue
            length.setValue(state, 0.06 + rest * (1 - point["contraction"]))
            model.realizeDynamics(state)
            pull = actuator.getActuation(state) + model.getForceSet().get(
                1
            ).getRecordValues(state).get(0)
            errors.append((pull - point["force_n"]) / blocked)
    rms, worst = (
        (sum(e * e for e in errors) / len(errors)) ** 0.5,
        max(map(abs, errors)),
    )
    assert len(errors) > 40 and rms <= 0.015 and worst <= 0.03, (
        len(errors),
        rms,
        worst,
    )
    # A hung mass at four pressures: where it settles.
    settled, mass = [], 0.4 * blocked / 9.81
    for q in (0.55, 0.7, 0.85, 1.0):
        model = model_at(q * supply)
        start = model.initSystem()
        manager = opensim.Manager(model)
        manager.setIntegratorAccuracy(1e-8)
        manager.initialize(start)
        state = manager.integrate(8.0)
        length = model.getCoordinateSet().get(0)
        assert abs(length.getSpeedValue(state)) < 1e-6, length.getSpeedValue(state)
        exact = run(
            program,
            "contraction",
            MUSCLE,
            "-F",
            9.81 * mass,
            "-p",
            q * supply / 1e6,
            "--format",
            "json",
        )["contraction"]
        settled.append(abs(1 - (length.getValue(state) - 0.06) / rest - exact))
    # At equilibrium the error of the pull over the slope of the pull, which is at least the mean one over the stroke.
    assert max(settled) <= 2 * worst * form["contraction_high"], (settled, worst)
    print(
        f"| opensim | OpenSim {opensim.GetVersion()} | {100 * rms:.2f} % rms, {100 * worst:.2f} % worst against fe; a hung mass within {100 * max(settled):.2f} % contraction | {len(text)} B | {time.monotonic() - begun:.1f} s |"
    )
