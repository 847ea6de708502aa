//! The prototype at ε 0.10 under rising pressure, for ParaView: `cargo run --release -p mckibben-fem --example vtu -- DIR`.
//! Prints the same numbers as JSON; `checks/vtu.py` compares the two.

use mckibben::model::{ForceModel as _, Workspace};
use mckibben::muscle::Muscle;
use mckibben_fem::axisymmetric::Axisymmetric;
use mckibben_fem::output::VtuSeries;
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).ok_or("usage: vtu DIR")?;
    let fe = Axisymmetric::new(&Muscle::prototype())?;
    let mut series = VtuSeries::new(Path::new(&folder), "prototype, D0 30 s 3 L0 285 mm, 28 deg")?;
    let mut points = Vec::new();
    let w = &mut Workspace::new();
    for step in 1..=5 {
        let r = fe.response(w, 0.05 * f64::from(step), 0.10)?;
        series.add(&fe.section_at(w, r.pressure_mpa, r.contraction)?, &r)?;
        points.push(serde_json::json!({
            "pressure_mpa": r.pressure_mpa,
            "contraction": r.contraction,
            "force_n": r.force_n,
            "volume_mm3": r.volume_mm3,
            "bulged_diameter_mm": r.bulged_diameter_mm,
        }));
    }
    series.finish()?;
    println!("{}", serde_json::json!({ "points": points }));
    Ok(())
}
