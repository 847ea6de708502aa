//! Equilibria with a load as people read them.

use super::LoadAnswer;
use crate::{
    Units, number,
    print::{Page, Rows, Table},
    units::{JOULES, NORMAL_LITRES, PERCENT},
};
use mckibben_core::load::{Balance, LoadError};

/// An equilibrium at a pressure, or why there is none.
type Line<'a> = (f64, Option<&'a Balance>, &'static str);

impl LoadAnswer {
    /// A table of the equilibria, and the stroke between the lowest and the highest pressure.
    pub fn onto(&self, page: &mut Page, u: &Units) {
        let lines: Vec<Line<'_>> = self
            .at
            .iter()
            .flat_map(|at| {
                let nothing =
                    at.error.as_ref().filter(|_| at.equilibria.is_empty()).map(
                        |error| match error {
                            LoadError::NotLifted { .. } => "not lifted",
                            _ => "none",
                        },
                    );
                at.equilibria
                    .iter()
                    .map(|e| {
                        let balance = if e.stable { "stable" } else { "unstable" };
                        (e.answer.response.pressure_mpa, Some(e), balance)
                    })
                    .chain(nothing.map(|word| (at.pressure_mpa, None, word)))
            })
            .collect();
        let table = Table::of(&lines)
            .text(&u.pressure.heading("P"), |l| u.pressure.bare(l.0))
            .quantity("ε", &PERCENT, |l| {
                l.1.map(|e| e.answer.response.contraction)
            })
            .quantity("as built", &PERCENT, |l| {
                l.1.map(|e| (e.answer.predicted, e.answer.contraction_uncertainty))
            })
            .quantity("x", &u.length.digits(4), |l| l.1.map(|e| e.shortening_mm))
            .quantity("F", &u.force.digits(4), |l| {
                l.1.map(|e| e.answer.response.force_n)
            })
            .quantity("muscle and load", &u.stiffness(), |l| {
                l.1.map(|e| e.stiffness_n_per_mm)
            })
            .text("balance", |l| l.2)
            .text("f [Hz]", |l| {
                l.1.and_then(|e| Some(number(e.frequency_hz?, 3)))
            });
        page.paragraph(format!("load {}", self.load));
        page.table(table);
        if let Some(cycle) = &self.cycle {
            page.gap();
            page.rows(
                Rows::default()
                    .quantity("stroke", &u.length.digits(4), cycle.stroke_mm)
                    .quantity("from", &u.pressure, cycle.from_pressure_mpa)
                    .quantity("to", &u.pressure, cycle.to_pressure_mpa)
                    .quantity("work on the load", &JOULES, cycle.work_j)
                    .quantity("air of a filling", &NORMAL_LITRES, cycle.air_normal_litres)
                    .quantity("its exergy", &JOULES, cycle.air_exergy_j)
                    .quantity("work over exergy", &PERCENT, cycle.efficiency),
            );
        }
    }
}
