"""One muscle, one truth: the facts that all commands answer of a dozen muscles, and the hosts of exported files too, are those of the package."""

from __future__ import annotations

import csv
import warnings
from pathlib import Path
from typing import Any

import pytest

import mckibben as mk

OF_MUSCLE = {"burst", "burst_not_checked", "above_allowed", "not_measured"}


def close(value: Any, fact: str) -> bool:
    if fact == "-":
        return value is None
    return bool(value == pytest.approx(float(fact), rel=1e-6, abs=2e-6))


def test_a_muscle_has_the_facts_of_every_other_output(root: Path) -> None:
    folder = root / "crates/mckibben-app/tests/layer/truth"
    with (folder / "facts.tsv").open() as file:
        rows = list(csv.DictReader(file, delimiter="\t"))
    assert len(rows) >= 12
    for row in rows:
        name = row["muscle"]
        muscle = mk.load(name if name.startswith("lib:") else folder / name)
        at = float(row["pressure_mpa"]), float(row["contraction"])
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            answer = muscle.solve(*at)
        check = muscle.check(pressure_mpa=at[0])
        limits = "allowed_pressure_mpa", "burst_pressure_mpa"
        interval = "predicted_n", "predicted_low_n", "predicted_high_n"
        for key in interval:
            assert close(answer[key], row[key]), (name, key, answer[key], row[key])
        for key in limits:
            assert close(getattr(check.characteristics, key), row[key]), (name, key)
        kinds = {warning.kind for warning in check.warnings} & OF_MUSCLE
        assert kinds == set(filter(None, row["warnings"].split(","))), name
