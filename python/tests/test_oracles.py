"""Numbers that others derived, and identities. The sources are those of the tests in Rust."""

from __future__ import annotations

import csv
import math
from pathlib import Path

import numpy as np
import pytest

import mckibben as mk


def columns(path: Path) -> dict[str, np.ndarray]:
    """The columns of a table with comments."""
    lines = [line for line in path.read_text("utf-8").splitlines() if line and not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def test_paper_formula_gives_table_1_within_1_8_percent(root: Path, thin: mk.Muscle) -> None:
    """Antonelli et al. (2018), Table 1: a, b, c of F = a ε² + b ε + c at D0 50, s 1."""
    model = thin.model("paper", two_sided=True)
    for row in csv.DictReader((root / "crates/mckibben/data/table1.csv").read_text("utf-8").splitlines()):
        p, table = float(row["pressure_mpa"]), [float(row[n]) for n in ("a_n", "b_n", "c_n")]
        found = np.polyfit([0.0, 0.1, 0.2], model.force(p, np.array([0.0, 0.1, 0.2])), 2)
        assert np.abs(found / table - 1).max() < 0.018


def test_finite_elements_give_table_1_within_1_5_percent(root: Path, thin: mk.Muscle) -> None:
    """The same points as finite elements see them: 1.50 % of the blocked force at 0.25 MPa, as docs/identify/paper.md states it."""
    points = columns(root / "data/paper/table1.csv")
    ours = thin.model().force(points["pressure_mpa"], points["contraction"])
    assert len(ours) == 25
    assert np.abs(ours - points["force_n"]).max() / points["force_n"].max() < 0.01505


def test_formula_11_point_by_point(root: Path) -> None:
    """The 500 points of formula (11), Antonelli et al. (2018)."""
    points = columns(root / "data/paper/formula11.csv")
    for d, s in {(d, s) for d, s in zip(points["outer_diameter_mm"], points["wall_mm"])}:
        here = (points["outer_diameter_mm"] == d) & (points["wall_mm"] == s)
        model = mk.Muscle(outer_diameter_mm=float(d), wall_mm=float(s)).model("paper", two_sided=True)
        ours = model.force(points["pressure_mpa"][here], points["contraction"][here])
        assert np.abs(ours - points["force_n"][here]).max() < 1e-3


@pytest.mark.parametrize("stretch, force", [(1.00, 697.295254), (0.95, 535.363511), (0.90, 415.638252), (0.80, 214.347501), (0.75, 124.603748)])
def test_the_long_muscle_with_a_rigid_braid(stretch: float, force: float) -> None:
    """Case G of docs/verification.md: A 8, B 9.5, α 25°, p 0.3, C1 0.10, C2 0.02 (kinematics of Liu & Rahn 2003)."""
    rubber = mk.Rubber("mooney-rivlin", c10=0.10, c01=0.02)
    muscle = mk.Muscle(outer_diameter_mm=19, wall_mm=1.5, angle_deg=25, rubber=rubber, stiffness="inextensible")
    assert muscle.model("thick-wall").force(0.3, 1 - stretch) == pytest.approx(force, abs=1e-5)


def test_the_ideal_muscle() -> None:
    """Schulte (1961): F = π D0² P/(4 sin²θ0) (3 cos²θ0 (1 − ε)² − 1)."""
    p, e = np.linspace(0, 0.3, 7)[:, None], np.linspace(0, 0.2, 5)
    angle = math.radians(28)
    exact = math.pi * 30**2 * p / (4 * math.sin(angle) ** 2) * (3 * math.cos(angle) ** 2 * (1 - e) ** 2 - 1)
    assert np.allclose(mk.Muscle().model("ideal").force(p, e), exact, rtol=1e-12)


@pytest.mark.parametrize("wall", [1.0, 3.0, 5.0])
def test_rigid_strands_make_the_blocked_force_that_of_the_outer_diameter(wall: float) -> None:
    """The limit k → ∞ of finite elements, whatever the wall; within 0.02 % at k = 1e6 N/mm."""
    muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=wall, stiffness=1e6)
    angle = math.radians(28)
    limit = math.pi * 50**2 * 0.25 / (4 * math.sin(angle) ** 2) * (3 * math.cos(angle) ** 2 - 1)
    assert muscle.model().force(0.25, 0.0) == pytest.approx(limit, rel=2e-4)


def test_maxwell_relation(thin: mk.Muscle) -> None:
    """∂F/∂P at fixed L = −∂V/∂L at fixed P: both from the same potential, seen in the same answer."""
    answer = thin.force(0.2, 0.1)
    _, jac = thin.model().force(0.2, 0.1, jac=True)
    assert answer.volume_per_contraction_mm3 is not None
    assert jac[0] == pytest.approx(answer.volume_per_contraction_mm3 / thin.length_mm, rel=1e-8)


def test_identification_finds_the_friction_of_tondus_loops(root: Path) -> None:
    """Tondu (2012), Fig. 3: the half-widths of its loops alone give C 71.46 N/MPa^β and β 0.560."""
    found = mk.identify(root / "examples/tondu2012.toml", root / "data/tondu2012/static_force_20deg.csv", model="thick-wall")
    values = {p.name: p for p in found.parameters}
    for name, alone in [("friction.coefficient", 71.46), ("friction.exponent", 0.56)]:
        half = values[name].half_width_95
        assert half is not None and abs(values[name].value - alone) <= half


def test_units_have_the_values_of_their_definitions() -> None:
    """NIST SP 811: 1 psi is 6.894757293168361e-3 MPa; 1 lbf is 4.4482216152605 N; 1 in is 25.4 mm."""
    model = mk.Muscle(outer_diameter_mm="1 in").model("ideal")
    assert model.muscle.outer_diameter_mm == 25.4
    assert model.force("36 psi") == pytest.approx(model.force(36 * 6.894757293168361e-3), rel=1e-14)
    assert mk.pressure(model.muscle, "100 lbf", model="ideal").force_n == pytest.approx(444.82216152605, rel=1e-9)
