//! A campaign of finite-element tests in memory, and one formula for all its muscles.
//!
//! `cargo run --release -p mckibben --example campaign --features campaign`

use mckibben::{
    campaign::{
        campaign::{PlanBuilder, compute},
        fit::{FormulaRequest, MakeOfRows, Method, data, make},
    },
    formula::Provenance,
    prelude::*,
    progress::Silent,
};
use std::{error::Error, sync::Arc};

const MUSCLE: &str = r#"
[tube]
outer_diameter = "24 mm"
wall_thickness = "2 mm"
length = "200 mm"

[braid]
angle = "25 deg"
stiffness = "600 N/mm"
"#;

pub fn main() -> Result<(), Box<dyn Error>> {
    let muscle: Muscle = MUSCLE.parse()?;
    let pressures_mpa = [0.05, 0.10, 0.15, 0.20, 0.25];
    let plan = PlanBuilder::new(&muscle, &[0.0, 0.05, 0.10, 0.15, 0.20], &pressures_mpa)
        .vary("tube.outer_diameter", "20,24,28,32 mm")
        .vary("tube.wall_thickness", "1..3:1 mm")
        .build()?;
    let rows = compute(&plan, &Silent)?;
    let mut made = MakeOfRows::new(&rows[0]);
    rows.iter().try_for_each(|row| made.add(row))?;
    let fitted = make(FormulaRequest {
        points: data::points(&rows),
        made_for: made.made_for(),
        method: Method::Global,
        terms: None,
        hold_out: &[],
        hold_out_share: 0.0,
        name: "own".into(),
        from: Provenance::default(),
    })?;
    println!("{} points: {}", rows.len(), fitted.formula.equation());

    // On a muscle between those of the campaign it is a model like any other.
    let muscle = plan.base().ok_or("no muscle")?.with_section(26.0, 1.75)?;
    let formula = Model::Formula(Arc::new(fitted.formula));
    let ours = formula.of(&muscle)?.force_n(0.18, 0.12)?;
    let mut fe = Model::FE.of(&muscle)?;
    let error = (ours - fe.force_n(0.18, 0.12)?).abs() / fe.force_n(0.25, 0.0)?;
    println!("error {:.2} % of the blocked force", 100.0 * error);
    assert!(error < 0.015, "{error}");
    Ok(())
}
