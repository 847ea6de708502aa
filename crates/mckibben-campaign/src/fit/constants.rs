//! The constants of the paper's finite elements, from what they left behind: its Table 1 and its formula (11).
//!
//! Unknown are C10 (C01 cannot be told from these data: it is 0) and the stiffness k = k₄₀ (D0/40 mm)ⁿ of a strand
//! family. Table 1 is finite elements itself, (11) misses its own by some per cent; so C10 and k at D0 50 come from Table 1
//! alone, and n from (11) on the campaign's points. What is stated of Table 1 is the largest error, so that the sixth power
//! of the errors is minimised there; for (11) the square.

use super::data::{CONTRACTIONS, DIAMETERS, FULL_PRESSURE, FitPoint, PRESSURES, WALLS, compute_with, same};
use super::error::FitError;
use mckibben::least_squares::{Settings, minimise};
use mckibben::model::Coefficients;
use mckibben::muscle::{Braid, BraidStiffness, Muscle, Rubber};
use mckibben::rubber::{Law, MooneyRivlin};

/// Table 1 of the paper: P in MPa, and a, b, c in N of F = a ε² + b ε + c at D0 50, s 1.
pub const TABLE_1: [[f64; 4]; 5] = [
    [0.05, 4121.9, -2997.4, 546.21],
    [0.10, 7158.6, -5587.3, 1091.8],
    [0.15, 10195.0, -8177.2, 1637.4],
    [0.20, 13232.0, -10767.0, 2183.0],
    [0.25, 16269.0, -13357.0, 2728.6],
];

/// D0 and s of the muscle of Table 1, as Table 2 tells.
const TABLE_1_SECTION: (f64, f64) = (50.0, 1.0);

/// F of Table 1 in N at one of its pressures.
pub fn table_1(pressure_mpa: f64, contraction: f64) -> Option<f64> {
    let row = TABLE_1.iter().find(|r| same(r[0], pressure_mpa))?;
    Some((row[1] * contraction + row[2]) * contraction + row[3])
}

/// C10 and k = k₄₀ (D0/40)ⁿ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants {
    /// C10 in MPa.
    pub c10_mpa: f64,
    /// k at D0 40 mm in N/mm.
    pub stiffness_at_40_n_per_mm: f64,
    /// n
    pub exponent: f64,
}

impl Constants {
    /// Those of the rubber and braid `paper`.
    pub const PROVISIONAL: Constants =
        Constants { c10_mpa: 0.12, stiffness_at_40_n_per_mm: 467.0, exponent: 1.3 };

    /// The paper's muscle with these constants; `None` where they make none.
    pub fn muscle(&self, outer_diameter_mm: f64, wall_mm: f64) -> Option<Muscle> {
        let base = Muscle::prototype().with_section(outer_diameter_mm, wall_mm).ok()?;
        let k = self.stiffness_at_40_n_per_mm * (outer_diameter_mm / 40.0).powf(self.exponent);
        let braid = Braid { stiffness: BraidStiffness::NewtonPerMm(k), ..base.braid().clone() };
        let mut tube = base.tube().clone();
        tube.rubber = Rubber::of(Law::MooneyRivlin(MooneyRivlin { c10_mpa: self.c10_mpa, c01_mpa: 0.0 }));
        base.with_braid(braid).ok()?.with_tube(tube).ok()
    }

    /// The campaign's points with these constants.
    pub fn campaign(&self) -> Vec<FitPoint> {
        self.points(&DIAMETERS)
    }

    /// The same for other diameters.
    pub fn points(&self, diameters: &[f64]) -> Vec<FitPoint> {
        compute_with(|d, s| self.muscle(d, s), diameters, &WALLS, &CONTRACTIONS, &PRESSURES)
    }
}

/// (F_FE − F)/F_blocked over Table 1.
fn table_residuals(constants: &Constants) -> Option<Vec<f64>> {
    let (d, s) = TABLE_1_SECTION;
    let points = compute_with(|d, s| constants.muscle(d, s), &[d], &[s], &CONTRACTIONS, &PRESSURES);
    let blocked = table_1(FULL_PRESSURE, 0.0)?;
    let one = |p: &FitPoint| Some((p.force_n - table_1(p.pressure_mpa, p.contraction)?) / blocked);
    points.iter().map(one).collect::<Option<Vec<f64>>>().filter(|r| r.len() == 25)
}

/// (F_FE − F)/F_blocked over the points of the campaign where (11) pulls, which do not depend on the constants.
fn formula_residuals(constants: &Constants) -> Option<Vec<f64>> {
    let points = constants.campaign();
    let one = |p: &FitPoint| {
        let section = Coefficients::published().section(p.outer_diameter_mm, p.wall_mm);
        let formula = section.force_n(p.pressure_mpa, p.contraction);
        if formula > 0.0 { (p.force_n - formula) / section.force_n(FULL_PRESSURE, 0.0) } else { 0.0 }
    };
    (points.len() == 500).then(|| points.iter().map(one).collect())
}

/// The unknowns of a least-squares fit that starts from zero.
fn solved(unknowns: usize, residuals: impl Fn(&[f64]) -> Option<Vec<f64>>) -> Result<Vec<f64>, FitError> {
    let settings = Settings { step: 1e-4, tolerances: Some((1e-9, 1e-7)) };
    let found = minimise(unknowns, settings, residuals);
    found.map(|m| m.x).map_err(|e| FitError::Singular(format!("the constants of the paper ({e})")))
}

/// The constants with which our finite elements come nearest to Table 1, and then to (11).
///
/// # Errors
/// [`FitError::Singular`] where the iteration ends without an answer.
pub fn fit_constants() -> Result<Constants, FitError> {
    let start = Constants::PROVISIONAL;
    let first = |x: &[f64]| Constants {
        c10_mpa: start.c10_mpa * x[0].exp(),
        stiffness_at_40_n_per_mm: start.stiffness_at_40_n_per_mm * x[1].exp(),
        ..start
    };
    // Cubes of the residuals in per cent: least squares of them is the sum of sixth powers.
    let cubes = |r: Vec<f64>| r.into_iter().map(|r| (100.0 * r).powi(3)).collect();
    let near = first(&solved(2, |x| table_residuals(&first(x)).map(cubes))?);
    // The exponent turns about D0 50, where Table 1 has settled k.
    let ratio: f64 = TABLE_1_SECTION.0 / 40.0;
    let turned = |x: &[f64]| Constants {
        exponent: near.exponent + x[0],
        stiffness_at_40_n_per_mm: near.stiffness_at_40_n_per_mm * ratio.powf(-x[0]),
        ..near
    };
    Ok(turned(&solved(1, |x| formula_residuals(&turned(x)))?))
}
