//! In memory: a campaign of finite-element tests without a file, and one formula for all its muscles.
//!
//! `cargo run --release -p mckibben-campaign --example 5_in_memory`

use mckibben_campaign::{
    campaign::{Plan, compute},
    fit::{FormulaRequest, MakeOfRows, Method, data, make},
};
use mckibben_core::{
    formula::Provenance,
    model::{ForceModel, FormulaModel, Workspace},
    progress::Silent,
};
use mckibben_fem::axisymmetric::Axisymmetric;
use std::error::Error;

const PLAN: &str = r#"
[tube]
length = "200 mm"

[braid]
angle = "25 deg"
stiffness = "600 N/mm"

[vary]
tube.outer_diameter = "20,24,28,32 mm"
tube.wall_thickness = "1..3:1 mm"

[test]
contractions = "0..0.20:0.05"
pressures = "0.05..0.25:0.05 MPa"
"#;

fn main() -> Result<(), Box<dyn Error>> {
    error_of_a_muscle_between().map(drop)
}

/// Returns the formula's error on a muscle between those of the campaign, as a share of its
/// blocked force.
fn error_of_a_muscle_between() -> Result<f64, Box<dyn Error>> {
    let plan = Plan::parse(PLAN)?;
    let rows = compute(&plan, &Silent)?;
    let mut made = MakeOfRows::new(&rows[0]);
    rows.iter().try_for_each(|row| made.add(row))?;
    let fitted = make(FormulaRequest {
        points: rows.iter().filter_map(data::point).collect(),
        made_for: made.made_for(),
        method: Method::Global,
        terms: None,
        hold_out: &[],
        hold_out_share: 0.0,
        name: "own".into(),
        from: Provenance::default(),
    })?;
    println!("{} points: {}", rows.len(), fitted.formula.equation());

    // It is a model like any other.
    let muscle = plan.base().ok_or("no muscle")?.with_section(26.0, 1.75)?;
    let formula = FormulaModel::between_ends(&fitted.formula, &muscle);
    let fe = Axisymmetric::between_ends(&muscle)?;
    let workspace = &mut Workspace::new();
    let ours = formula.force_n(workspace, 0.18, 0.12)?;
    let error = (ours - fe.force_n(workspace, 0.18, 0.12)?).abs();
    let error = error / fe.force_n(workspace, 0.25, 0.0)?;
    println!("error {:.2} % of the blocked force", 100.0 * error);
    Ok(error)
}

#[test]
fn between_its_muscles_the_formula_is_within_one_and_a_half_per_cent() {
    let error = error_of_a_muscle_between().unwrap();
    assert!(error < 0.015, "{error}");
}
