"""What tests share: the repository's own data, found from here."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

import mckibben as mk

os.environ.setdefault("MPLBACKEND", "Agg")
# Tests of a wheel lie elsewhere, so that the sources are not what they import.
ROOT = Path(os.environ.get("MCKIBBEN_ROOT") or Path(__file__).resolve().parents[2])


@pytest.fixture(scope="session")
def root() -> Path:
    """The repository."""
    return ROOT


@pytest.fixture(scope="session")
def thin() -> mk.Muscle:
    """The muscle of the paper's Table 1: D0 50, s 1."""
    return mk.Muscle(outer_diameter_mm=50, wall_mm=1, length_mm=285)
