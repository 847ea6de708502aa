//! Equilibria with a load, as text.

use super::keyed::{listed, tabled, value};
use super::text::{Units, pairs};
use mckibben::load::LoadError;
use mckibben_app::LoadAnswer;
use serde_json::{Value, json};

const EQUILIBRIA: &str = "pressure_mpa=P:4~ contraction+contraction_uncertainty=ε:% \
    shortening_mm=x force_n+uncertainty_n=F held_stiffness_n_per_mm=muscle_and_load balance \
    natural_frequency_hz=f:3~";
const CYCLE: &str = "stroke_mm from_pressure_mpa=from to_pressure_mpa=to work_j=work_on_the_load \
    air_normal_litres=air_of_a_filling air_exergy_j=its_exergy efficiency=work_over_exergy:%";

/// A table of the equilibria, and the stroke between the lowest and the highest pressure.
pub fn loaded(answer: &LoadAnswer, u: &Units) -> String {
    let rows = answer.at.iter().flat_map(|at| {
        let nothing = at.error.as_ref().filter(|_| at.equilibria.is_empty());
        let nothing = nothing.map(|error| match error {
            LoadError::NotLifted { .. } => "not lifted",
            _ => "none",
        });
        let equilibria = at
            .equilibria
            .iter()
            .map(|e| (value(e), if e.stable { "stable" } else { "unstable" }));
        let mut all: Vec<(Value, &str)> = equilibria.collect();
        all.extend(nothing.map(|word| (json!({ "pressure_mpa": at.pressure_mpa }), word)));
        all.into_iter().map(|(mut row, word)| {
            row["balance"] = word.into();
            row
        })
    });
    let mut text = format!("\nload {}\n{}", answer.load, tabled(rows, EQUILIBRIA, u));
    if let Some(cycle) = &answer.cycle {
        text += &format!("\n{}", pairs(&listed(&value(cycle), CYCLE, u)));
    }
    text
}
