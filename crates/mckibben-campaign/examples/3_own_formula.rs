//! Own formula: a campaign of finite-element tests, a formula fitted to it, and the formula used as
//! a model.
//!
//! `cargo run --release -p mckibben-campaign --example 3_own_formula`

use mckibben_campaign::{
    campaign::{Plan, RunOptions, rows, run},
    fit::{FormulaRequest, MakeOfRows, Method, data, make},
};
use mckibben_core::{
    formula::Provenance,
    model::{ForceModel, FormulaModel, Workspace},
};
use mckibben_fem::axisymmetric::Axisymmetric;
use std::error::Error;

/// Muscles of one length, angle, rubber and braid; diameter and wall vary. `plans/` has larger
/// ones.
const PLAN: &str = r#"
[tube]
length = "200 mm"

# dragon-skin-30 in a muscle of 24 x 2 mm and 25 degrees: one law for all of them
[tube.material]
law = "yeoh"
c10 = "0.08888 MPa"
c20 = "0.01114 MPa"
c30 = "-0.0006977 MPa"

[braid]
angle = "25 deg"
stiffness = "600 N/mm"

[sampling]
method = "factorial"

[vary]
tube.outer_diameter = "20,24,28,32 mm"
tube.wall_thickness = "1..3:0.5 mm"

[test]
contractions = "0..0.20:0.05"
pressures = "0.05..0.25:0.05 MPa"
"#;

fn main() -> Result<(), Box<dyn Error>> {
    error_between_the_points().map(drop)
}

/// Returns the formula's error on a muscle that is not in the campaign, as a share of its blocked
/// force.
fn error_between_the_points() -> Result<f64, Box<dyn Error>> {
    let plan = Plan::parse(PLAN)?;
    let folder = tempfile::tempdir()?;
    let table = folder.path().join("campaign.parquet");
    run(
        &plan,
        &table,
        &RunOptions::default(),
        &mckibben_core::progress::Silent,
    )?;
    let rows = rows(&table)?.collect::<Result<Vec<_>, _>>()?;
    println!("{} points of {} muscles", rows.len(), plan.muscles());

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
        from: Provenance {
            plan_hash: Some(plan.hash()),
            ..Provenance::default()
        },
    })?;
    println!("{}", fitted.formula.equation());

    // The formula is a model like any other. `fitted.formula.to_json()` is a file for `--model`.
    let muscle = plan.inputs(0).muscle()?.with_section(26.0, 1.75)?;
    let formula = FormulaModel::between_ends(&fitted.formula, &muscle);
    let fe = Axisymmetric::between_ends(&muscle)?;
    let workspace = &mut Workspace::new();
    let (ours, theirs) = (
        formula.force_n(workspace, 0.18, 0.12)?,
        fe.force_n(workspace, 0.18, 0.12)?,
    );
    println!(
        "D0 26, s 1.75 at 0.18 MPa and 12 %: formula {ours:.1} N, finite elements {theirs:.1} N"
    );
    Ok((ours - theirs).abs() / fe.force_n(workspace, 0.25, 0.0)?)
}

#[test]
fn between_its_points_the_formula_is_within_one_per_cent() {
    let error = error_between_the_points().unwrap();
    assert!(error < 0.01, "{error}");
}
