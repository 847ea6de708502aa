//! The paper's validation on the diameter it held out (D0 35), as rows of `validate`: largest error
//! of a formula against the finite elements, as a share of the muscle's blocked force at .25 MPa,
//! over points where they pull.

use super::{
    make::{Method, refitted},
    paper_method::Rules,
};
use mckibben_core::formula::Formula;
use mckibben_core::verification::VerificationRow;

/// The formulas by both methods, fitted without D0 35, and the published one.
pub fn cases() -> Vec<VerificationRow> {
    let row = |name: &str, tolerance: f64, formula: Option<Formula>| {
        let name = format!("{name} on D0 35, held out: largest error / blocked force");
        let held_out = formula.and_then(|f| f.errors.held_out);
        VerificationRow::new(name, "fe", 0.0, held_out.map(|h| h.errors.max), tolerance)
    };
    let global = refitted(Method::Global).ok();
    let paper = refitted(Method::Paper(Rules::default())).ok();
    let published = paper.as_ref().map(|f| f.published());
    vec![
        row("global formula", 0.004, global.map(|f| f.formula)),
        row(
            "formula by the paper's method",
            0.06,
            paper.map(|f| f.formula),
        ),
        row("published formula", 0.08, published),
    ]
}
