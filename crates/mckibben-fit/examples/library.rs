//! The muscles of the library: identifies each measured muscle that is named again, by its library
//! fit, and prints its muscle file: `cargo run --release -p mckibben-fit --example library --
//! tondu2012 > crates/mckibben-fit/data/measured/tondu2012/identified.toml`.

use mckibben_core::{
    model::ForceModel,
    muscle::{Bench, Muscle, file::to_toml},
};
use mckibben_fem::elements::Elements;
use mckibben_fit::validation::{built_in, chosen::ChosenFit};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let build = |m: &Muscle| -> Result<Box<dyn ForceModel>, _> {
        Ok(Elements::Axisymmetric(Default::default()).build(m)?)
    };
    let name = std::env::args().nth(1).unwrap_or_default();
    let sets = built_in::muscles()?;
    let case = sets.iter().find(|case| case.facts.name == name);
    let case = case.ok_or_else(|| format!("no measured muscle is named \"{name}\""))?;
    let fit = case.fit_of_library().ok_or("it has no fit")?;
    let points = case.points_of(fit);
    let chosen = ChosenFit::new(&fit.muscle, &fit.free, &points, &build);
    let muscle = chosen.with_bench(&chosen.found()?);
    let bench = muscle.bench().ok_or("it has no bench")?.clone();
    let muscle = muscle.with_bench(Bench {
        laboratory: Some(case.facts.source.clone()),
        ..bench
    });
    print!("{}", to_toml(&muscle));
    Ok(())
}
