//! The points that formulas are fitted to: of a campaign's table, or computed here.

use crate::columns::PointRow;
use mckibben_core::{
    formula::{Coefficients, Formula},
    model::Workspace,
    muscle::Muscle,
    threads,
};
use mckibben_fem::{
    axisymmetric::Axisymmetric,
    simulation::{Detail, ElementModel},
};
pub use mckibben_fit::measured::{distinct, same};
use serde::Serialize;

/// The diameters of the paper's campaign in mm.
pub const DIAMETERS: [f64; 4] = [30.0, 40.0, 45.0, 50.0];
/// Its walls in mm.
pub const WALLS: [f64; 5] = [1.0, 2.0, 3.0, 4.0, 5.0];
/// Its contractions.
pub const CONTRACTIONS: [f64; 5] = [0.0, 0.05, 0.10, 0.15, 0.20];
/// The pressures of its isobaric curves in MPa.
pub const PRESSURES: [f64; 5] = [0.05, 0.10, 0.15, 0.20, 0.25];
/// The diameter it holds out, in mm.
pub const HELD_OUT: f64 = 35.0;
/// The highest pressure in MPa: errors are shares of its blocked force.
pub const FULL_PRESSURE: f64 = 0.25;

/// The pull of one muscle at a pressure and contraction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct FitPoint {
    /// D0 in mm.
    pub outer_diameter_mm: f64,
    /// s in mm.
    pub wall_mm: f64,
    /// L0 in mm.
    pub length_mm: f64,
    /// θ0 in degrees.
    pub angle_deg: f64,
    /// P in MPa.
    pub pressure_mpa: f64,
    /// ε
    pub contraction: f64,
    /// F in N, two-sided.
    pub force_n: f64,
}

impl FitPoint {
    /// F of a formula there, in N.
    pub fn formula_n(&self, formula: &Formula) -> f64 {
        formula.force_n(
            self.outer_diameter_mm,
            self.wall_mm,
            self.pressure_mpa,
            self.contraction,
        )
    }

    /// The same less that of the point.
    pub fn difference_n(&self, formula: &Formula) -> f64 {
        self.formula_n(formula) - self.force_n
    }

    /// F of the published formula there, in N.
    pub fn published_n(&self) -> f64 {
        Coefficients::published()
            .section(self.outer_diameter_mm, self.wall_mm)
            .force_n(self.pressure_mpa, self.contraction)
    }
}

/// The point of a row, where it has an answer.
pub fn point(row: &PointRow) -> Option<FitPoint> {
    Some(FitPoint {
        outer_diameter_mm: row.outer_diameter_mm,
        wall_mm: row.wall_mm,
        length_mm: row.length_mm,
        angle_deg: row.angle_deg,
        pressure_mpa: row.pressure_mpa,
        contraction: row.contraction,
        force_n: row
            .force_n
            .filter(|f| f.is_finite() && row.status.is_ok())?,
    })
}

/// A grid of points: muscles of every diameter and wall, at every contraction and pressure.
#[derive(Debug, Clone, Copy)]
pub struct Grid<'a> {
    /// D0 in mm.
    pub diameters: &'a [f64],
    /// s in mm.
    pub walls: &'a [f64],
    /// ε
    pub contractions: &'a [f64],
    /// P in MPa.
    pub pressures: &'a [f64],
}

impl Grid<'static> {
    /// The paper's campaign at the pressures of its isobaric curves: 500 points.
    pub const PAPER: Self = Grid {
        diameters: &DIAMETERS,
        walls: &WALLS,
        contractions: &CONTRACTIONS,
        pressures: &PRESSURES,
    };
    /// The same of the diameter it holds out.
    pub const HELD_OUT: Self = Grid {
        diameters: &[HELD_OUT],
        ..Self::PAPER
    };
}

impl Grid<'_> {
    /// Isometric tests by finite elements; `base` gives the rest of the muscle.
    pub fn points(&self, base: &Muscle) -> Vec<FitPoint> {
        self.compute(|d, s| base.with_section(d, s).ok())
    }

    /// The same with a muscle for each diameter and wall. Sections without a muscle and points
    /// without an answer are left out. The order is that of the lists, whatever the number of
    /// threads.
    pub fn compute(&self, muscle: impl Fn(f64, f64) -> Option<Muscle> + Sync) -> Vec<FitPoint> {
        let sections: Vec<(f64, f64)> = self
            .diameters
            .iter()
            .flat_map(|&d| self.walls.iter().map(move |&s| (d, s)))
            .collect();
        let one =
            |&(d, s): &(f64, f64)| muscle(d, s).map_or_else(Vec::new, |m| self.muscle_points(&m));
        threads::map(&sections, one).concat()
    }

    fn muscle_points(&self, muscle: &Muscle) -> Vec<FitPoint> {
        let Ok(model) = Axisymmetric::between_ends(muscle) else {
            return vec![];
        };
        let mut out = vec![];
        for &contraction in self.contractions {
            let curve = model.isometric(
                &mut Workspace::new(),
                contraction,
                self.pressures,
                Detail::Point,
            );
            for (&pressure_mpa, point) in self.pressures.iter().zip(curve) {
                out.extend(point.ok().map(|p| FitPoint {
                    outer_diameter_mm: muscle.outer_diameter_mm(),
                    wall_mm: muscle.wall_mm(),
                    length_mm: muscle.length_mm(),
                    angle_deg: muscle.braid().angle_deg,
                    pressure_mpa,
                    contraction,
                    force_n: p.force_n,
                }));
            }
        }
        out
    }
}
