#!/usr/bin/env python3
"""Runs the exported units of FMI in FMPy, and their libraries for Windows and macOS, and prints their rows of the table of exports.

Usage: exports_fmu.py PROGRAM [PART ...]
"""

import ctypes
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time
import urllib.parse
import zipfile

import fmpy
import fmpy.fmi2
import fmpy.fmi3
import mach_o
import numpy as np
from exports import (
    JOINTS,
    L0,
    MUSCLE,
    ROOT,
    SUPPLY,
    L,
    P,
    V,
    blocked,
    export,
    exported,
    inside,
    noted,
    program,
    run,
    run_parts,
    work,
)
from fmpy.validation import validate_fmu
from scipy.integrate import solve_ivp


def fmu():
    path = os.environ.pop("PATH")  # no compiler is found while the unit is made
    try:
        folder, _, seconds = export("fmu")
    finally:
        os.environ["PATH"] = path
    begun = time.monotonic()
    path = str(folder / "muscle_prototype.fmu")
    problems = validate_fmu(path)
    assert not problems, problems
    n = 60
    signals = np.zeros(
        n, dtype=[("time", float), ("pressure", float), ("length", float)]
    )
    signals["time"] = np.arange(n) * 0.01
    signals["pressure"], signals["length"] = (
        SUPPLY * np.linspace(0, 1, n),
        L0 * (0.89 - 0.09 * np.sin(np.arange(n))),
    )
    errors = []
    # In Co-Simulation an input holds from its instant on; Model Exchange gives outputs of the same instant.
    for kind in ("ModelExchange", "CoSimulation"):
        result = fmpy.simulate_fmu(
            path,
            fmi_type=kind,
            start_values={"friction_factor": 0.0},
            input=signals,
            output=["pressure", "length", "force", "volume", "stiffness"],
            stop_time=0.59,
            output_interval=0.01,
            step_size=0.01,
        )
        f, v = (
            exported.force(result["pressure"], result["length"]),
            exported.volume(result["pressure"], result["length"]),
        )
        errors += [
            np.abs(result["force"] - f).max() / blocked,
            np.abs(result["volume"] - v).max() / V.max(),
        ]
        assert result["force"].max() > 0.5 * blocked
    result = fmpy.simulate_fmu(
        path,
        start_values={"pressure": SUPPLY, "force_factor": 1.1},
        output=["force"],
        stop_time=0.1,
    )
    assert abs(result["force"][0] / float(exported.force(SUPPLY, L0)) - 1.1) < 1e-12
    # It has shortened: friction takes from its pull what it takes on that branch.
    restored(
        path,
        {"pressure": 1.5e5, "length": 0.9 * L0},
        float(
            exported.force(1.5e5, 0.9 * L0)
            + exported.friction(1.5e5, 0.9 * L0, -1.0, 0.0)
        ),
    )
    assert max(errors) < 1e-12, errors
    third = str(folder / "muscle_prototype_fmi3.fmu")
    problems = validate_fmu(third)
    assert not problems, problems
    thirds = []
    for kind in ("ModelExchange", "CoSimulation"):
        result = fmpy.simulate_fmu(
            third,
            fmi_type=kind,
            start_values={"friction_factor": 0.0},
            input=signals,
            output=["pressure", "length", "force", "volume", "status"],
            stop_time=0.59,
            output_interval=0.01,
            step_size=0.01,
        )
        f, v = (
            exported.force(result["pressure"], result["length"]),
            exported.volume(result["pressure"], result["length"]),
        )
        thirds += [
            np.abs(result["force"] - f).max() / blocked,
            np.abs(result["volume"] - v).max() / V.max(),
        ]
        assert (
            result["force"].max() > 0.5 * blocked
            and (
                result["status"]
                == exported.status(result["pressure"], result["length"])
            ).all()
        )
    assert max(thirds) < 1e-12, thirds
    noted(
        "fmu",
        f"FMPy {fmpy.__version__}: FMI 3.0, Model Exchange and Co-Simulation",
        f"{max(thirds):.1e}",
        f"{pathlib.Path(third).stat().st_size} B",
        seconds + time.monotonic() - begun,
    )
    size = (folder / "muscle_prototype.fmu").stat().st_size
    noted(
        "fmu",
        f"FMPy {fmpy.__version__}: FMI 2.0, Model Exchange and Co-Simulation",
        f"{max(errors):.1e}",
        f"{size} B",
        seconds + time.monotonic() - begun,
    )
    names = ("pressure", "length", "force", "volume")
    points = np.column_stack([P, L])[inside]
    other_systems(
        "fmu",
        path,
        names,
        points,
        after_steps(path, names, points),
    )


def restored(path, inputs, force=None):
    """The state of a unit after a step as bytes, restored in another process: both do the next step alike to the last bit."""
    script = """
import json, sys, fmpy
from fmpy.fmi2 import FMU2Slave
path, inputs, saved = sys.argv[1], json.loads(sys.argv[2]), bytes.fromhex(sys.argv[3])
d = fmpy.read_model_description(path)
at = {v.name: v.valueReference for v in d.modelVariables}
u = FMU2Slave(guid=d.guid, unzipDirectory=fmpy.extract(path), modelIdentifier=d.coSimulation.modelIdentifier, instanceName='i')
u.instantiate(); u.setupExperiment(); u.enterInitializationMode(); u.exitInitializationMode()
if saved:
    u.setFMUState(u.deSerializeFMUstate(saved))
else:
    u.setReal([at[name] for name in inputs], list(inputs.values()))
    u.doStep(0.0, 0.1)
print(u.serializeFMUState(u.getFMUState()).hex())
u.doStep(0.1, 0.1)
print(repr(u.getReal([at['force']])[0]))
"""
    first = run(
        sys.executable, "-c", script, path, json.dumps(inputs), ""
    ).stdout.split()
    second = run(sys.executable, "-c", script, path, "{}", first[0]).stdout.split()
    assert first == second and (force is None or abs(float(first[1]) - force) < 1e-9), (
        first,
        second,
    )
    return len(first[0]) // 2


DRIVE = """muscle = "muscle.toml"
[supply]
pressure = "3 bar"
[valve]
sonic_conductance = "0.5 L/(s bar)"
critical_ratio = 0.3
exhaust_conductance = "0.8 L/(s bar)"
exhaust_critical_ratio = 0.2
[air]
dead_volume = "10 cm3"
HEAT
[load]
LOAD
[command]
valve = [["0 s", 0], ["0.05 s", 1], ["0.3 s", 0.5], ["0.6 s", 0], ["0.7 s", -0.6], ["1 s", -1]]
until = "1.5 s"
output_step = "1 ms"
"""


OUTPUTS = ("pressure", "force")


def by_model_exchange(path, start, times, command, length):
    """The unit integrated by Radau's method of SciPy from step to step of the command, with the length linear between its points. (FMPy's solver does
    not apply the input within a step, and goes beyond a step of the input.)"""
    d = fmpy.read_model_description(path)
    at = {v.name: v.valueReference for v in d.modelVariables}
    known = {
        "guid": d.guid,
        "unzipDirectory": fmpy.extract(path),
        "modelIdentifier": d.modelExchange.modelIdentifier,
        "instanceName": "unit",
    }
    if d.fmiVersion == "2.0":
        u = fmpy.fmi2.FMU2Model(**known)
        u.instantiate(), u.setupExperiment()
        set_values, values, slopes, new = (
            u.setReal,
            u.getReal,
            u.getDerivatives,
            u.newDiscreteStates,
        )
    else:
        u = fmpy.fmi3.FMU3Model(**known)
        u.instantiate()
        set_values, values, slopes, new = (
            u.setFloat64,
            u.getFloat64,
            u.getContinuousStateDerivatives,
            u.updateDiscreteStates,
        )
    u.enterInitializationMode()
    set_values([at[name] for name in start], list(start.values()))
    u.exitInitializationMode()
    new(), u.enterContinuousTimeMode()
    x, rates = (ctypes.c_double * 2)(), (ctypes.c_double * 2)()
    u.getContinuousStates(x, 2)

    def put(t, y, held):
        u.setTime(t)
        set_values(
            [at["command"], at["length"]], [held, float(np.interp(t, times, length))]
        )
        x[:] = y
        u.setContinuousStates(x, 2)

    def rhs(t, y, held):
        put(t, y, held)
        slopes(rates, 2)
        return rates[:]

    rows, state = [], np.array(x[:])
    ends = np.unique(
        np.concatenate([[0, len(times) - 1], 1 + np.flatnonzero(np.diff(times) < 1e-9)])
    )
    for first, last in zip(ends[:-1], ends[1:]):
        grid, held = (
            times[first : last if last < len(times) - 1 else last + 1],
            float(command[first]),
        )
        done = solve_ivp(
            rhs,
            (grid[0], grid[-1]),
            state,
            "Radau",
            t_eval=grid,
            args=(held,),
            rtol=1e-8,
            atol=1e-8 * state,
            max_step=0.01,
        )
        assert done.success, done.message
        for t, y in zip(grid, done.y.T):
            put(t, y, held)
            rows.append([t, *values([at[name] for name in OUTPUTS])])
        state = done.y[:, -1]
        u.enterEventMode(), new(), u.enterContinuousTimeMode()
    return dict(zip(("time", *OUTPUTS), np.array(rows).T))


def valve():
    """The unit of a muscle on a valve against `mckibben motion` by fe: both ends held, and with a mass whose motion is its length."""
    folder, answer, _ = export("fmu", "-p", "3bar")
    blocked, supply = answer["blocked_force_n"], 3e5
    shutil.copy(ROOT / MUSCLE, folder / "muscle.toml")
    set_values = {
        "supply_pressure": supply,
        "sonic_conductance": 5e-9,
        "critical_ratio": 0.3,
        "exhaust_conductance": 8e-9,
        "exhaust_critical_ratio": 0.2,
        "dead_volume": 1e-5,
    }
    held, mass = (
        'held = "10 %"',
        'mass = "10 kg"\ndamping = "200 N s/m"\nstops = "0..100 mm"',
    )
    cases = [
        ("isothermal", 'heat = "isothermal"', {}, held),
        ("polytropic", "polytropic_index = 1.2", {"polytropic_exponent": 1.2}, held),
        ("adiabatic", 'heat = "adiabatic"', {"polytropic_exponent": 1.4}, held),
        (
            "heat",
            'heat = "0.3 W/K"',
            {"polytropic_exponent": 1.4, "heat_conductance": 0.3},
            held,
        ),
        (
            "moving",
            'heat = "0.3 W/K"',
            {"polytropic_exponent": 1.4, "heat_conductance": 0.3},
            mass,
        ),
    ]
    units, found = (
        [
            str(folder / name)
            for name in (
                "muscle_prototype_valve.fmu",
                "muscle_prototype_valve_fmi3.fmu",
            )
        ],
        {},
    )
    for path in units:
        problems = validate_fmu(path)
        assert not problems, problems
    for name, heat, own, load in cases:
        begun = time.monotonic()
        (folder / "drive.toml").write_text(
            DRIVE.replace("HEAT", heat).replace("LOAD", load)
        )
        series = json.loads(
            run(program, "motion", folder / "drive.toml", "--format", "json").stdout
        )["series"]
        t, pressure, contraction, force = (
            np.array(series[k])
            for k in ("time_s", "pressure_mpa", "contraction", "force_n")
        )
        # At a step of the command there are two values of the same time.
        command = np.array(
            [
                (0.0, 0.0),
                (0.05, 0.0),
                (0.05, 1.0),
                (0.3, 1.0),
                (0.3, 0.5),
                (0.6, 0.5),
                (0.6, 0.0),
                (0.7, 0.0),
                (0.7, -0.6),
                (1.0, -0.6),
                (1.0, -1.0),
                (1.5, -1.0),
            ]
        )
        times = np.sort(np.concatenate([t, [0.05, 0.3, 0.6, 0.7, 1.0]]))
        signals = np.zeros(
            len(times), dtype=[("time", float), ("command", float), ("length", float)]
        )
        signals["time"], signals["length"] = (
            times,
            L0 * (1 - np.interp(times, t, contraction)),
        )
        signals["command"] = np.array(
            [command[command[:, 0] <= at][-1, 1] for at in times]
        )
        signals["command"][:-1][np.diff(times) < 1e-9] = [0.0, 1.0, 0.5, 0.0, -0.6]
        off = lambda result: [
            float(np.abs(np.interp(t, result["time"], result[k]) - exact).max() / scale)
            for k, exact, scale in (
                ("pressure", 1e6 * pressure, supply),
                ("force", force, blocked),
            )
        ]
        for path in units:
            for kind in ("ModelExchange", "CoSimulation"):
                start = {**set_values, **own, "length": L0 * (1 - contraction[0])}
                if kind == "ModelExchange":
                    result = by_model_exchange(
                        path, start, times, signals["command"], signals["length"]
                    )
                else:
                    result = fmpy.simulate_fmu(
                        path,
                        fmi_type=kind,
                        input=signals,
                        start_values=start,
                        output=list(OUTPUTS),
                        stop_time=1.5,
                        output_interval=1e-3,
                        step_size=1e-3,
                    )
                found[name, path, kind] = off(result)
        # At the same mass of air the pressure errs by n times the share of the volume; a length that is held over a step is late by one.
        n, volume = (
            own.get("polytropic_exponent", 1.0),
            1e-9 * np.array(series["volume_mm3"]),
        )
        bound = (
            n
            * answer["volume_worst_ratio"]
            * (volume.max() / volume.min())
            * (1e6 * pressure.max() + 101325)
            / supply
        )
        late = (
            n
            * np.abs(np.diff(np.log(volume))).max()
            * (1e6 * pressure.max() + 101325)
            / supply
        )
        for path in units:
            exact, stepped = (
                found[name, path, "ModelExchange"],
                found[name, path, "CoSimulation"],
            )
            assert exact[0] < bound and stepped[0] < bound + (
                0 if load == held else late
            ), (name, exact, stepped, bound, late)
            assert load != held or abs(exact[0] - stepped[0]) < 1e-6, (
                name,
                exact,
                stepped,
            )
        kinds = ("ModelExchange", "CoSimulation") if load == mass else ("CoSimulation",)
        said = "; ".join(
            f"{kind} pressure {100 * found[name, units[0], kind][0]:.2f} % of the supply, pull {100 * found[name, units[0], kind][1]:.2f} % of the blocked force"
            for kind in kinds
        )
        noted(
            "fmu",
            f"a valve against motion by fe, {name}",
            said,
            f"{pathlib.Path(units[0]).stat().st_size} B",
            time.monotonic() - begun,
        )
    print(restored(units[0], {"command": 0.5}), "bytes of a saved state")
    # A step with each of several commands and lengths.
    names = ("command", "length", "force", "volume")
    points = np.array(
        [
            *[(1.0, L0)] * 8,
            (0.5, 0.95 * L0),
            (0.0, 0.9 * L0),
            (-0.3, 0.85 * L0),
            (1.0, 0.8 * L0),
        ]
    )
    other_systems(
        "fmu on a valve",
        units[0],
        names,
        points,
        after_steps(units[0], names, points),
    )


def joint():
    """Units of joints: the Python module's torque, stiffness and slopes in the pressures, in Model Exchange and Co-Simulation; derivatives by angle and pressure."""
    for name in ("pair", "crane"):
        begun, folder = time.monotonic(), work / f"unit {name}"
        folder.mkdir()
        shutil.copy(ROOT / MUSCLE, folder / "muscle.toml")
        (folder / f"{name}.toml").write_text(JOINTS[name])
        for target in ("fmu", "python"):
            run(
                program,
                "export",
                folder / f"{name}.toml",
                "--as",
                target,
                "-o",
                folder,
                "--overwrite",
            )
        sys.path.insert(0, str(folder))
        module = __import__(f"joint_{name}")
        count = len(module.MUSCLES)
        inputs = [*(f"pressure_{k + 1}" for k in range(count)), "angle"]
        outputs = [
            "torque",
            "torque_stiffness",
            *(f"torque_per_pressure_{k + 1}" for k in range(count)),
        ]
        n, random = 40, np.random.default_rng(3)
        signals = np.zeros(
            n, dtype=[("time", float), *((word, float) for word in inputs)]
        )
        signals["time"] = np.arange(n) * 0.01
        for word in inputs[:-1]:
            signals[word] = SUPPLY * random.uniform(0, 1, n)
        signals["angle"] = random.uniform(*module.RANGE, n)
        errors = []
        for version in ("", "_fmi3"):
            path = str(folder / f"joint_{name}{version}.fmu")
            problems = validate_fmu(path)
            assert not problems, problems
            for kind in ("ModelExchange", "CoSimulation"):
                result = fmpy.simulate_fmu(
                    path,
                    fmi_type=kind,
                    start_values={"friction_factor": 0.0},
                    input=signals,
                    output=[*inputs, *outputs, "status"],
                    stop_time=0.39,
                    output_interval=0.01,
                    step_size=0.01,
                )
                p, angle = [result[word] for word in inputs[:-1]], result["angle"]
                wanted = [
                    module.torque(p, angle),
                    module.stiffness(p, angle),
                    *module.torque_per_pressure(p, angle),
                ]
                errors += [
                    float(np.abs(result[word] - value).max() / np.abs(value).max())
                    for word, value in zip(outputs, wanted)
                ]
                assert (result["status"] == module.status(p, angle)).all()
        assert max(errors) < 1e-12, errors
        noted(
            "fmu",
            f"joint_{name}.fmu in FMPy: FMI 2.0 and 3.0, Model Exchange and Co-Simulation",
            f"{max(errors):.1e}",
            f"{pathlib.Path(path).stat().st_size} B",
            time.monotonic() - begun,
        )
    pairs = np.column_stack(
        [SUPPLY * random.uniform(0.1, 1, 60), random.uniform(*module.RANGE, 60)]
    )
    path = str(folder / "joint_crane.fmu")
    names = ("pressure_1", "angle", "torque", "torque_stiffness")
    other_systems(
        "fmu of a joint",
        path,
        names,
        pairs,
        after_steps(path, names, pairs),
    )


def after_steps(path, names, points):
    """Two outputs after a step of 0.05 s with each pair of inputs, here: the pull has the friction of the way so far."""
    d = fmpy.read_model_description(path)
    at = {v.name: v.valueReference for v in d.modelVariables}
    unit = fmpy.fmi2.FMU2Slave(
        guid=d.guid,
        unzipDirectory=fmpy.extract(path),
        modelIdentifier=d.coSimulation.modelIdentifier,
        instanceName="unit",
    )
    unit.instantiate(), unit.setupExperiment()
    unit.enterInitializationMode(), unit.exitInitializationMode()
    outputs = []
    for pair in points.tolist():
        unit.setReal([at[name] for name in names[:2]], pair)
        unit.doStep(0.0, 0.05)
        outputs.append(unit.getReal([at[name] for name in names[2:]]))
    return np.array(outputs)


def other_systems(target, path, names, points, expected):
    """The libraries for Windows and macOS: a step of 0.05 s with each pair of inputs, then two outputs (`names` of all four)."""
    description, scale = fmpy.read_model_description(path), np.abs(expected).max(axis=0)
    places = {v.name: v.valueReference for v in description.modelVariables}
    references = [places[name] for name in names]
    for system in ("Windows", "Linux on Arm"):
        elsewhere(
            system,
            target,
            path,
            description.guid,
            references,
            points,
            expected / scale,
            scale,
        )
    begun = time.monotonic()
    found, size = mach_o.outputs(path, description.guid, references, points[:99])
    error = np.abs(found / scale - expected[:99] / scale).max()
    assert error < 1e-12, error
    noted(
        target,
        "macOS libraries, code on emulated x86-64 and arm64 (Unicorn)",
        f"{error:.1e}",
        f"{size} B both",
        time.monotonic() - begun,
    )


def elsewhere(system, target, path, token, references, points, expected, scale):
    """The library for Windows in Wine, or for Linux on Arm in QEMU: its resources in a folder whose name has a space and a letter beyond ASCII."""
    compiler, runs, drive, folder = {
        "Windows": (["x86_64-w64-mingw32-gcc", "-municode"], ["wine"], "Z:", "win64"),
        "Linux on Arm": (
            ["aarch64-linux-gnu-gcc"],
            ["qemu-aarch64", "-L", "/usr/aarch64-linux-gnu"],
            "",
            "aarch64-linux",
        ),
    }[system]
    if not (shutil.which(runs[0]) and shutil.which(compiler[0])):
        print(f"{target} | {system} | not installed")
        return
    begun, unit = time.monotonic(), work / f"the {target} of {system} \u00fc"
    with zipfile.ZipFile(
        path if system == "Windows" else path.replace(".fmu", "_fmi3.fmu")
    ) as archive:
        archive.extractall(unit)
        sizes = {
            i.filename.split("/")[1]: i.file_size
            for i in archive.infolist()
            if i.filename.startswith("binaries/")
        }
    (library,) = (unit / "binaries" / folder).iterdir()
    run(
        *compiler,
        "-O1",
        "-Wall",
        "-Werror",
        ROOT / "checks/fmu_host.c",
        "-o",
        work / "host.exe",
        "-ldl" if not drive else "-s",
    )
    shutil.copy(library, work / "unit.dll")
    resources = drive + str(unit / "resources")
    location = ("file:///" if drive else "file://") + urllib.parse.quote(
        resources, safe="/:"
    )
    words = [
        *runs,
        work / "host.exe",
        drive + str(work / "unit.dll"),
        location,
        resources + "/",
        token,
        *references,
    ]
    text = "".join(f"{a!r} {b!r}\n" for a, b in points.tolist())
    settings = {
        **os.environ,
        "WINEPREFIX": str(work / "wine"),
        "WINEDEBUG": "-all",
        "LC_ALL": "C.UTF-8",
        "DISPLAY": "",
    }
    done = subprocess.run(
        [str(w) for w in words],
        input=text,
        capture_output=True,
        text=True,
        timeout=300,
        env=settings,
    )
    assert done.returncode == 0, (done.returncode, done.stderr[-1000:])
    found = np.array(
        [[float(v) for v in line.split()] for line in done.stdout.splitlines()]
    ).reshape(-1, 2, 2)
    error = np.abs(found / scale - expected[:, None]).max()
    assert len(found) == len(points) and error < 1e-12, error
    noted(
        target,
        f"library for {system} in {run(runs[0], '--version').stdout.split(chr(10))[0].strip()}: FMI 2.0 and FMI 3.0",
        f"{error:.1e}",
        f"libraries {sizes} B",
        time.monotonic() - begun,
    )


if __name__ == "__main__":
    run_parts(fmu, valve, joint)
