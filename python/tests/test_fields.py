"""Each argument of each public function and class, with values that are none: an error that blames an argument names one."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import mckibben as mk
from mckibben import _api

BAD = [float("nan"), -1.0, "nonsense", None, object(), [object()], b"1", {}]
MEASURES: dict[str, Any] = {"outer_diameter_mm": 20, "wall_mm": 1.5, "length_mm": 220}
TABLES: dict[str, Any] = {
    "joint": {"radius_mm": 25, "range_deg": (-60, 60), "inertia_kg_m2": 0.03},
    "contraction_at_neutral": 0.12,
}
MOVED: dict[str, Any] = {
    "valve": "festo-mh2",
    "load": {"mass_kg": 10, "damping": "200 N s/m"},
    "command": {"pressure_mpa": 0.2, "until_s": 0.05},
}
BENCH = {"pressure_mpa": 0.2, "contraction": [0.0, 0.1], "force_n": [200, 150]}
PULLED = {"stretch": [1.0, 1.2, 1.5, 2.0], "stress_mpa": [0.0, 0.10, 0.21, 0.35]}
# Of these the program does not tell which argument it is: of a limit, a time, or of several together.
UNTOLD = {
    "design": "force_n contraction load max_pressure_mpa certainty max_bulged_diameter_mm max_envelope_mm max_mass_kg max_liquid_volume_mm3 min_burst_margin "
    "min_tube_margin max_stretch max_strand_strain outer_diameter_mm wall_mm",
    "identify": "data",
    "export": "contraction_low contraction_high",
    "fit_rubber": "up_to_stretch hoop_stretch",
    "motion": "rise_time_s",
    "solve": "angles_deg pressures_mpa",
}


def calls(root: Path) -> Iterator[tuple[Callable[..., Any], dict[str, Any]]]:
    muscle = mk.Muscle(**MEASURES, angle_deg=24, stiffness=900)
    joint = mk.Joint(muscle, muscle, **TABLES)
    drive = mk.Drive(muscle, **MOVED)
    rubber = mk.Rubber("neo-hookean", mu=0.3)
    formula = mk.fit(root / "data/campaign/paper.csv").formula
    simulation = mk.Simulation(drive, 0.01, model="ideal")
    quick = {"model": "ideal"}
    point = {"pressure_mpa": 0.1, "contraction": 0.1}
    turned: dict[str, Any] = {"pressures_mpa": [0.1, 0.1], "angle_deg": 0, **quick}
    yield mk.Muscle, MEASURES
    yield muscle.replace, {}
    yield mk.Muscle.from_toml, {"text": muscle.to_toml()}
    yield muscle.force, {**point, **quick}
    yield muscle.force, {"pressure_mpa": [0.1, 0.2], "contraction": 0.1, **quick}
    yield muscle.pressure, {"force_n": 100, "contraction": 0.1, **quick}
    yield muscle.contraction, {"force_n": 100, "pressure_mpa": 0.1, **quick}
    yield muscle.solve, {**point, **quick}
    yield muscle.bounds, quick
    yield muscle.with_parameters, {"values": {"tube.outer_diameter": 21.0}}
    yield muscle.cite, quick
    yield muscle.curve, quick
    yield muscle.shape, point
    yield muscle.fill, {"volume_mm3": "5 mL", "load": "mass:5kg", **quick}
    yield muscle.check, quick
    yield muscle.compare, {"data": BENCH, "models": ["ideal"]}
    yield muscle.export, {"target": "python", **quick}
    yield mk.Rubber, {"law": "neo-hookean", "mu": 0.3}
    yield mk.Rubber.from_toml, {"text": rubber.to_toml()}
    yield rubber.replace, {"mu": 0.2}
    yield rubber.stress, {"mode": "uniaxial", "stretch": [1.0]}
    yield mk.Formula, {"text": formula.to_json()}
    yield formula, {**point, "wall_mm": 3, "outer_diameter_mm": 30}
    yield formula.check, {}
    yield mk.Joint, {"muscle_1": muscle, "muscle_2": muscle, **TABLES}
    yield joint.replace, {"muscle_1": muscle}
    yield joint.torque, turned
    yield joint.stiffness, turned
    yield joint.linearise, turned
    yield joint.solve, {"pressures_mpa": [[0.1, 0.1]], "angles_deg": 0, **quick}
    yield mk.Drive, {"of": muscle, **MOVED}
    yield drive.replace, {"of": muscle}
    yield drive.linearise, quick
    yield drive.motion, quick
    yield mk.Simulation, {"drive": drive, "dt_s": 0.01, **quick}
    yield simulation.step, {"command": 0.2}
    yield simulation.set_state, {"state": simulation.get_state()}
    yield mk.rollout, {"simulation": simulation, "commands": [[0.1] * 2]}
    limits = {"force_n": 100, "contraction": 0.1, "max_pressure_mpa": 0.25}
    yield mk.design, {**limits, **quick, "outer_diameter_mm": 20, "wall_mm": 1.5}
    free = {"free": ["tube.material.modulus"], "model": "thick-wall"}
    yield mk.identify, {"muscle": muscle, "data": BENCH, **free}
    yield mk.fit_rubber, {"data": PULLED, "laws": ["neo-hookean"]}
    yield mk.parts, {"kind": "rubbers"}
    yield mk.part, {"name": "paper"}
    yield mk.ask, {"command": "check", "request": {"model": "ideal"}}
    yield mk.load, {"path": "lib:dmsp-20-300"}
    yield mk.Campaign, {"output": "campaign.parquet"}


def arguments(call: Callable[..., Any]) -> Iterator[str]:
    """Names of what it takes, those of its keywords among them, and one that it does not take."""
    keywords = {
        "Unpack[_api.Options]": _api.Options,
        "Unpack[Measures]": _api.Measures,
        "Unpack[_api.Measures]": _api.Measures,
        "Any": _api.Asking,
    }
    for name, of in inspect.signature(call).parameters.items():
        if of.kind is of.VAR_KEYWORD:
            kind = keywords.get(str(of.annotation))
            yield from getattr(kind, "__annotations__", ())
        else:
            yield name
    yield "nonsense"


@pytest.mark.filterwarnings("ignore")
def test_an_error_names_the_argument_to_blame(
    root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Python's own errors are of names that there are not, and of what is no text, number or object at all."""
    monkeypatch.chdir(tmp_path)
    wrong: list[Any] = []
    refused = 0
    for call, given in calls(root):
        call(**given)
        title = getattr(call, "__name__", type(call).__name__)
        for name in set(arguments(call)) - {"progress"}:
            for bad in BAD:
                try:
                    call(**{**given, name: bad})
                except mk.InputError as error:
                    refused += 1
                    if not error.field and name not in UNTOLD.get(title, ""):
                        wrong.append((title, name, bad, error))
                except (mk.NoAnswerError, mk.NotConvergedError):
                    pass
                except TypeError as error:
                    if "unexpected keyword" not in str(error):
                        wrong.append((title, name, bad, error))
    assert not wrong, wrong
    assert refused > 2500
