//! Tables of F(P, ε) and P(F, ε) on grids without holes.

use crate::form::{NO_ANSWER, Point};
use crate::muscle::ExportedMuscle;

/// Grid points along pressures and pulls.
const ACROSS: usize = 41;
/// Grid points along contractions.
const ALONG: usize = 61;

pub(super) struct Tables {
    pub pressures: Vec<f64>,
    pub contractions: Vec<f64>,
    /// Points, pressure by pressure.
    pub points: Vec<Vec<Point>>,
    /// Pulls, N: from 0 to the blocked force at the supply.
    pub pulls: Vec<f64>,
    /// Pressures in Pa and status, pull by pull. A pull that no pressure in the box gives has the supply pressure, and a status.
    pub inverse: Vec<Vec<(f64, u32)>>,
}

pub(super) fn tables(muscle: &ExportedMuscle) -> Tables {
    let f = &muscle.form;
    let even =
        |n: usize, a: f64, b: f64| (0..n).map(move |i| a + (b - a) * i as f64 / (n - 1) as f64).collect();
    let pressures: Vec<f64> = even(ACROSS, 0.0, f.supply_pa);
    let contractions: Vec<f64> = even(ALONG, f.contraction_low, f.contraction_high);
    let pulls: Vec<f64> = even(ACROSS, 0.0, muscle.blocked_force_n);
    let points = pressures.iter().map(|p| contractions.iter().map(|e| f.at(*p, *e)).collect()).collect();
    let pressure = |pull: f64, e: f64| {
        let (p, status) = f.pressure(pull, e);
        if p > f.supply_pa { (f.supply_pa, status | NO_ANSWER) } else { (p, status) }
    };
    let inverse =
        pulls.iter().map(|pull| contractions.iter().map(|e| pressure(*pull, *e)).collect()).collect();
    Tables { pressures, contractions, points, pulls, inverse }
}
