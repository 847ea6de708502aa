//! The points of the first test.

use crate::{
    Operating, Plan,
    text::{mm, percent, significant, trimmed},
};
use mckibben_core::{built::Measurement, muscle::Direction, units::rounded};

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
        // Where it turns there is one point.
        let down = up.iter().rev().skip(1);
        let up = up.iter().map(|p| (p, Direction::Contraction));
        let both = up.chain(down.map(|p| (p, Direction::Elongation)));
        out.extend(both.map(|(pressure_mpa, branch)| TestPoint {
            pressure_mpa: *pressure_mpa,
            contraction,
            branch,
        }));
    }
    out
}

/// The first columns of the sheet.
const COLUMNS: &str = "pressure_mpa,contraction,force_n,branch,measured,";

/// Whether a sheet has no readings: each of its rows blank where it names what was read.
pub fn is_blank_sheet(sheet: &str) -> bool {
    let mut rows = sheet.lines().filter(|line| !line.starts_with('#'));
    rows.all(|row| {
        let cells: Vec<&str> = row.split(',').map(str::trim).collect();
        let mut read = ["pressure", "contraction", "force"].iter().zip(&cells);
        let read = read.find(|(name, _)| cells.get(4) == Some(name));
        row.starts_with(COLUMNS) || read.is_some_and(|(_, cell)| cell.is_empty())
    })
}

/// Rows for readings of the builder's own choice.
const BLANK_ROWS: usize = 4;

/// What is worth measuring, a comment each, and the rows for its reading beside those of the test.
fn to_measure(plan: &Plan) -> (String, String) {
    let (operating, shown) = (&plan.operating, &plan.shown);
    let half = |n| shown.force(rounded(n, 2, f64::round));
    let (mut text, mut rows) = Default::default();
    let Some(to_measure) = &operating.to_measure else {
        return (text, rows);
    };
    text += &format!(
        "# At {} and {} the pull has a ± of {} (95 %). What leaves less of it, the best first:\n",
        shown.pressure(operating.pressure_mpa),
        percent(to_measure.contraction),
        half(to_measure.uncertainty_n)
    );
    let p = trimmed(operating.pressure_mpa, 5);
    for left in &to_measure.left {
        let (what, minutes) = left.measurement.words();
        let half = half(left.uncertainty_n);
        let mut place = "";
        match left.measurement {
            Measurement::HungLoad => rows += ",,,contraction,pressure,\n",
            Measurement::OnePull => {
                let distance = trimmed(plan.faces_mm(0.05), 1);
                rows += &format!("{p},0.05,,contraction,force,{distance}\n");
            }
            Measurement::FreeContraction => rows += &format!("{p},,0,contraction,contraction,\n"),
            Measurement::StartPressure => place = "; take_up of [braid] in muscle.toml",
            Measurement::Turns => place = "; strand_length and turns of [braid] in muscle.toml",
            // The rows of the test.
            Measurement::TenPulls => {}
        }
        text += &format!("# - {what}: ± {half} ({minutes} min){place}\n");
    }
    (text, rows)
}

/// The sheet for the readings, which `identify` reads.
pub fn csv(plan: &Plan) -> String {
    let length_mm = plan.muscle.length_mm();
    let (text, rows) = to_measure(plan);
    let mut out = format!(
        "# {}: first test of a muscle with L0 {} mm. Fill in pressure_mpa, contraction (shortening \
         over L0) and force_n (N).\n# `measured` names what was read; the other two were set. Rows \
         in which it is blank are left out.\n{text}",
        crate::MARK,
        mm(length_mm)
    );
    out += &format!(
        "# Rows with a distance: set it between the inner faces of both heads ({} mm at rest), then \
         the pressure, row by row,\n# without going back: contraction is while the pressure rises, \
         elongation while it falls. The pressure stays at or below {}.\n",
        mm(plan.faces_mm(0.0)),
        plan.shown.pressure(plan.operating.pressure_mpa)
    );
    out += COLUMNS;
    out += "distance between the heads (mm),expected (N), from, to\n";
    out += &rows;
    for (i, point) in plan.test.iter().enumerate() {
        let p = trimmed(point.pressure_mpa, 5);
        let e = trimmed(point.contraction, 4);
        let distance = trimmed(plan.faces_mm(point.contraction), 1);
        let expected = plan.expected.get(i).map_or_else(String::new, |at| {
            let [low, median, high] = at.range_n().map(|n| significant(n, 3));
            format!(",{median},{low},{high}")
        });
        out += &format!("{p},{e},,{},force,{distance}{expected}\n", point.branch);
    }
    out + &",,,,force,\n".repeat(BLANK_ROWS)
}
