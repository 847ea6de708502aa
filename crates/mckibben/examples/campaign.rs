//! A campaign of finite-element tests in memory, and one formula for all its muscles.
//!
//! `cargo run --release -p mckibben --example campaign --features campaign`

use mckibben::{
    campaign::{
        campaign::{Plan, compute},
        fit::{MakeOfRows, Method, Request, data, make},
    },
    formula::Provenance,
    prelude::*,
    progress::Silent,
};
use std::{error::Error, sync::Arc};

const PLAN: &str = r#"
[tube]
length = "200 mm"

[braid]
angle = "25 deg"
stiffness = "600 N/mm"

[sampling]
method = "factorial"

[vary]
tube.outer_diameter = "20,24,28,32 mm"
tube.wall_thickness = "1..3:1 mm"

[test]
contractions = "0..0.20:0.05"
pressures = "0.05..0.25:0.05 MPa"
"#;

pub fn main() -> Result<(), Box<dyn Error>> {
    let plan = Plan::parse(PLAN)?;
    let rows = compute(&plan, &Silent)?;
    let mut made = MakeOfRows::new(&rows[0]);
    rows.iter().try_for_each(|row| made.add(row))?;
    let fitted = make(Request {
        points: data::points(&rows),
        made_for: made.made_for(),
        method: Method::Global,
        hold_out: &[],
        name: "own".into(),
        from: Provenance::default(),
    })?;
    println!("{} points: {}", rows.len(), fitted.formula.equation());

    // On a muscle between those of the campaign it is a model like any other.
    let muscle = plan.base.with_section(26.0, 1.75)?;
    let formula = Model::Formula(Arc::new(fitted.formula));
    let ours = formula.of(&muscle)?.force_n(0.18, 0.12)?;
    let mut fe = Model::FE.of(&muscle)?;
    let error = (ours - fe.force_n(0.18, 0.12)?).abs() / fe.force_n(0.25, 0.0)?;
    println!("error {:.2} % of the blocked force", 100.0 * error);
    assert!(error < 0.015, "{error}");
    Ok(())
}
