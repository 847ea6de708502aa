//! The paper's validation on the diameter it held out (D0 35), as rows of `validate`: largest error
//! of a formula against the finite elements, as a share of the muscle's blocked force at .25 MPa,
//! over points where they pull.

use super::{
    data::{FitPoint, Grid},
    errors::{compared, errors},
    make::{Method, fitted},
    paper_method::Rules,
};
use mckibben_core::muscle::Muscle;
use mckibben_fem::verification::VerificationRow;

/// The formulas by both methods, fitted without D0 35, and the published one.
pub fn cases() -> Vec<VerificationRow> {
    let base = Muscle::prototype();
    let campaign = Grid::PAPER.points(&base);
    let held = Grid::HELD_OUT.points(&base);
    let row = |name: &str, tolerance: f64, largest: Option<f64>| {
        let name = format!("{name} on D0 35, held out: largest error / blocked force");
        VerificationRow::new(name, "fe", 0.0, largest, tolerance)
    };
    let largest = |difference_n: &dyn Fn(&FitPoint) -> f64| {
        compared(&held, difference_n)
            .ok()
            .and_then(|list| errors(&list, |_| true))
            .map(|e| e.summary.max)
    };
    let by = |method| {
        let formula = fitted(&campaign, method, &[]).ok()?;
        largest(&|p| p.difference_n(&formula))
    };
    vec![
        row("global formula", 0.004, by(Method::Global)),
        row(
            "formula by the paper's method",
            0.06,
            by(Method::Paper(Rules::default())),
        ),
        row(
            "published formula",
            0.08,
            largest(&|p| p.published_n() - p.force_n),
        ),
    ]
}
