//! The points of the first test.

use crate::{
    Operating, Plan,
    text::{mm, trimmed},
};
use mckibben_core::muscle::Direction;

/// A point of the test.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, schemars::JsonSchema)]
pub struct TestPoint {
    /// Pressure in MPa.
    pub pressure_mpa: f64,
    /// Contraction.
    pub contraction: f64,
    /// Whether the pressure rises to it or falls to it.
    pub branch: Direction,
}

/// Contractions of the test, as shares of the free contraction at the working pressure.
const SHARES: [f64; 4] = [0.0, 0.25, 0.5, 0.75];
/// Points are kept up to this share of the free contraction at their pressure: beyond it the pull
/// is small.
const PULLS: f64 = 0.85;

/// The points in the order of the test: at each length the pressure rises, then falls.
pub fn points(operating: &Operating) -> Vec<TestPoint> {
    let mut out = vec![];
    for share in SHARES {
        // To half a percent, which one can set.
        let contraction = (200.0 * share * operating.free_contraction).round() / 200.0;
        let pulls = |at: &&(f64, f64)| contraction <= PULLS * at.1;
        let all: Vec<f64> = operating
            .free_contractions
            .iter()
            .filter(pulls)
            .map(|at| at.0)
            .collect();
        // The lowest, the middle and the highest pressure.
        let mut up = match all[..] {
            [first, .., last] => vec![first, all[all.len() / 2], last],
            _ => all,
        };
        up.dedup();
        let point = |branch| {
            move |pressure_mpa| TestPoint {
                pressure_mpa,
                contraction,
                branch,
            }
        };
        out.extend(up.iter().copied().map(point(Direction::Contraction)));
        // Where it turns there is one point.
        out.extend(
            up.iter()
                .rev()
                .skip(1)
                .copied()
                .map(point(Direction::Elongation)),
        );
    }
    out
}

pub fn csv(plan: &Plan) -> String {
    let length_mm = plan.muscle.length_mm();
    let mut out = format!(
        "# {}: first test of a muscle with L0 {} mm. Fill in force_n (N); leave out rows that \
         you do not measure.\n",
        crate::MARK,
        mm(length_mm)
    );
    out += &format!(
        "# Set the distance between the clamps, then the pressure, row by row, without going back: \
         contraction is while the pressure rises,\n# elongation while it falls. The pressure stays \
         at or below {}.\n",
        plan.operating.pressure(plan.operating.pressure_mpa)
    );
    out += "# Then: mckibben identify muscle.toml --data test.csv -o found.toml\n\
        pressure_mpa,contraction,force_n,branch,distance between the clamps (mm)\n";
    for point in &plan.test {
        let p = trimmed(point.pressure_mpa, 5);
        let e = trimmed(point.contraction, 4);
        let distance = trimmed(length_mm * (1.0 - point.contraction), 1);
        out += &format!("{p},{e},,{},{distance}\n", point.branch);
    }
    out
}
