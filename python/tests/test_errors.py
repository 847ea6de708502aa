"""Hostile input: an exception each time, in the words of the command line, and never an end of the process."""

from __future__ import annotations

import pickle
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import mckibben as mk
from mckibben import _errors, _schema


@pytest.mark.parametrize(
    "call, kind",
    [
        (lambda: mk.force(), mk.InputError),
        (lambda: mk.force(pressure_mpa="2.5 furlongs"), mk.InputError),
        (lambda: mk.force(pressure_mpa="10%"), mk.InputError),
        (lambda: mk.force(pressure_mpa=0.2, contraction=15), mk.InputError),
        (lambda: mk.force(pressure_mpa=float("nan")), mk.InputError),
        (lambda: mk.force(pressure_mpa=10**400), OverflowError),
        (lambda: mk.force(pressure_mpa=0.3, model="paper"), mk.OutOfRangeError),
        (lambda: mk.force(pressure_mpa=0.3, model="papr"), mk.InputError),
        (lambda: mk.force(pressure_mpa=0.3, rubber="nothing-like-it"), mk.InputError),
        (lambda: mk.force(pressure_mpa=0.3, braid="nothing-like-it"), mk.InputError),
        (lambda: mk.force(pressure_mpa=0.3, mesh="a"), mk.InputError),
        (lambda: mk.force(pressure_mpa=0.3, model="tondu-lopez"), mk.InputError),
        (lambda: mk.force("no/such/file.toml", 0.3), mk.FileError),
        (lambda: mk.Muscle.from_toml("[tube]\nwall_thickness = '3 bar'"), mk.FileError),
        (lambda: mk.Muscle.from_toml("\0"), mk.FileError),
        (lambda: mk.Muscle.prototype(outer_diameter_mm=-1), mk.InputError),
        (lambda: mk.pressure(force_n=1e6), mk.NoAnswerError),
        (lambda: mk.pressure(force_n=-5), mk.InputError),
        (lambda: mk.contraction(force_n=1e6, pressure_mpa=0.2), mk.NoAnswerError),
        (lambda: mk.curve(model="paper", pressures_mpa=[0.3]), mk.OutOfRangeError),
        (lambda: mk.curve(pressures_mpa=[]), mk.InputError),
        (lambda: mk.curve(pressures_mpa="0..1:1e-9 MPa"), mk.InputError),
        (lambda: mk.curve(pressures_mpa=np.linspace(0, 1, 3000), contractions=np.linspace(0, 0.2, 3000)), mk.InputError),
        (lambda: mk.design(force_n=1e9, contraction=0.1, max_pressure_mpa=0.2).best, mk.NoAnswerError),
        (lambda: mk.design(), mk.MckibbenError),
        (lambda: mk.identify(data={"pressure_mpa": [0.1], "contraction": [0.1], "force_n": [1.0]}), mk.MckibbenError),
        (lambda: mk.rubber({"strain": [0.1], "stress_mpa": [1.0]}), mk.MckibbenError),
        (lambda: mk.fit({"a": [1.0]}), mk.MckibbenError),
        (lambda: mk.Formula("{}"), mk.InputError),
        (lambda: mk.Rubber("wood", e=1), mk.FileError),
        (lambda: mk.ask("nothing", {}), mk.InputError),
        (lambda: mk.ask("force", {"presure_mpa": 1}), mk.InputError),
        (lambda: mk.ask("force", {"pressure_mpa": "1"}), mk.InputError),
        (lambda: mk.Campaign("no/such/place.parquet", {"name": "plan", "text": ""}).run(), mk.MckibbenError),
        (lambda: mk.Campaign("no/such.parquet").summary(), mk.FileError),
    ],
)
def test_each_family_has_its_exception(call: Any, kind: type[Exception]) -> None:
    with pytest.raises(kind) as caught:
        call()
    error = caught.value
    if isinstance(error, mk.MckibbenError):
        assert error.message and isinstance(error, _errors.KINDS.get(error.kind, mk.InputError))
        assert isinstance(error, (ValueError, ArithmeticError, RuntimeError))
        assert str(pickle.loads(pickle.dumps(error))) == str(error)


def test_the_nearest_answer_is_told() -> None:
    with pytest.raises(mk.NoAnswerError) as caught:
        mk.pressure(force_n=1e6, contraction=0.1, model="ideal")
    nearest = caught.value.nearest
    assert nearest is not None and nearest["pressure_mpa"] == 20


def cyclic() -> dict[str, Any]:
    request: dict[str, Any] = {"formulas": []}
    request["formulas"].append(request["formulas"])
    return request


@pytest.mark.parametrize(
    "request_",
    [
        cyclic(),
        {"pressure_mpa": object()},
        {1: 2},
        {"pressure_mpa": {1, 2}},
        {"pressure_mpa": b"1"},
        {"pressure_mpa": float("inf")},
        {"pressure_mpa": 2**70},
        {"pressure_mpa": [0.1]},
        {"muscle": {"name": "a", "text": "[tube]\n" + "x" * 1_000_000}},
        {"model": "\ud800"},
        {"\ud800": 1},
        "text",
        [],
        7,
    ],
)
def test_requests_that_are_none(request_: Any) -> None:
    with pytest.raises((TypeError, ValueError, mk.MckibbenError)):
        mk.ask("force", request_)


@pytest.mark.parametrize("value", [object(), [1, 2], {}, True, b"2", np.zeros(3), 1j, "", " ", "1e999 bar", "\0", "２ bar", "nan", "inf MPa"])
def test_values_that_are_none(value: Any) -> None:
    array: Any = object() if isinstance(value, (list, np.ndarray, dict)) else value
    for call in (lambda: mk.force(pressure_mpa=value), lambda: mk.Muscle.prototype(outer_diameter_mm=value), lambda: mk.Muscle.prototype().model("ideal").force(array, 0)):
        with pytest.raises((TypeError, ValueError)):
            call()


def test_objects_that_lie() -> None:
    class Liar:
        magnitude = "far"

        def to(self, unit: str) -> Liar:
            return self

    class Raises:
        def __float__(self) -> float:
            raise RuntimeError("no")

    with pytest.raises((TypeError, ValueError)):
        mk.force(pressure_mpa=Liar())
    with pytest.raises(RuntimeError):
        mk.force(pressure_mpa=Raises())  # type: ignore[arg-type]
    with pytest.raises(TypeError):
        mk.Muscle.prototype(rubber=3)
    with pytest.raises(TypeError):
        mk.force(pressure_mpa=0.1, unknown=1)  # type: ignore[call-arg]


def test_a_broken_progress_function_ends_the_work_with_its_exception() -> None:
    with pytest.raises(TypeError):
        mk.sweep(2000, progress=lambda: None)  # type: ignore[arg-type, misc]


def test_files_that_are_none(tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_bytes(b"\xff\xfe\x00")
    for path in [tmp_path, tmp_path / "a.toml", "/dev/zero" if sys.platform != "win32" else tmp_path]:
        with pytest.raises(mk.MckibbenError):
            mk.Muscle(path)
        with pytest.raises(mk.MckibbenError):
            mk.rubber(path)


def test_the_words_are_those_of_json() -> None:
    """The exception says what the command line says, in JSON."""
    try:
        mk.force(pressure_mpa=0.3, model="paper")
    except mk.OutOfRangeError as error:
        assert error.message == "outside the range of the paper model: pressure 0.3 MPa, outside 0 to 0.25 MPa"
    kinds = {kind["const"] for kind in _schema.bundle()["$defs"]["ProblemKind"]["oneOf"]}
    assert set(_errors.KINDS) <= kinds


def test_six_exceptions_are_those_of_python_too() -> None:
    for kind, own in {"InputError": ValueError, "OutOfRangeError": ValueError, "FileError": OSError, "NoAnswerError": ValueError, "NotConvergedError": ArithmeticError, "InternalError": RuntimeError}.items():
        assert issubclass(getattr(mk, kind), (mk.MckibbenError, own)) and issubclass(getattr(mk, kind), own)
    assert [name for name in mk.__all__ if name.endswith("Error")] == ["FileError", "InputError", "InternalError", "MckibbenError", "NoAnswerError", "NotConvergedError", "OutOfRangeError"]
    for call in (lambda: mk.Muscle("no/such/file.toml"), lambda: mk.identify("no/such.toml", "no.csv"), lambda: mk.Campaign("no/such.parquet").summary()):
        with pytest.raises(FileNotFoundError) as caught:
            call()
        assert isinstance(caught.value, mk.FileError) and str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)
    with pytest.raises(mk.InputError) as wrong:
        mk.Muscle.prototype(outer_diameter_mm="3 bar")
    assert (wrong.value.field, wrong.value.kind) == ("outer_diameter_mm", "quantity") and wrong.value.hint is not None
