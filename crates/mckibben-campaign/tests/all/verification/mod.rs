//! The paper's validation on the diameter it held out (D0 35): largest error of a formula against
//! the finite elements, as a share of the muscle's blocked force at .25 MPa, over points where they
//! pull.

#[path = "../../../../mckibben-core/tests/all/verification/rows.rs"]
mod rows;

use mckibben_campaign::fit::{Method, refitted};
use rows::Rows;

rows::cases! {
    papers_held_out_diameter: "fe" => held_out;
}

/// The formulas by both methods, fitted without D0 35, and the published one.
fn held_out(rows: &mut Rows) {
    let global = refitted(Method::Global).unwrap().formula;
    let paper = refitted(Method::Paper).unwrap();
    let published = paper.published();
    for (name, tolerance, formula) in [
        ("global formula", 0.004, global),
        ("formula by the paper's method", 0.06, paper.formula),
        ("published formula", 0.08, published),
    ] {
        let name = format!("{name} on D0 35, held out: largest error / blocked force");
        let largest = formula.errors.held_out.map(|h| h.errors.max);
        rows.add(name, 0.0, largest, tolerance);
    }
}
