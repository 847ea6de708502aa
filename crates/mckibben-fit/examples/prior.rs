//! What the measured muscles tell of one that nobody measured, as `crates/mckibben-core/data/prior.json`
//! keeps it: `cargo run --release -p mckibben-fit --example prior > FILE`; with the word `table` behind it what the ±
//! covers of points that are left out, series by series.

use mckibben_core::{model::ForceModel, muscle::Muscle, progress::Silent};
use mckibben_fem::elements::Elements;
use mckibben_fit::validation::{
    built_in,
    families::{self, Known},
    left_out::{Way, left_out},
    residual::Fitter,
};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let build = |m: &Muscle| -> Result<Box<dyn ForceModel>, _> {
        Ok(Elements::Axisymmetric(Default::default()).build(m)?)
    };
    let by = Fitter {
        build: &build,
        progress: &Silent,
    };
    let sets = built_in::muscles()?;
    let series = families::series(&sets);
    let known = families::known(&series, by);
    if std::env::args().any(|a| a == "table") {
        for way in Way::ALL {
            print!("{}", left_out(way, &sets, &known, by));
        }
        return Ok(());
    }
    let all: Vec<&Known<'_>> = known.iter().collect();
    let experience = families::experience(&all);
    println!("{}", serde_json::to_string_pretty(&experience.rounded())?);
    Ok(())
}
