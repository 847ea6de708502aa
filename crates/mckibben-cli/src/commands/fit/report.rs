//! `fit --report`: the paper's campaign computed anew, and how everything compares.

use super::text::errors_row;
use crate::asked::Asked;
use crate::failure::{Failure, NO_ANSWER};
use crate::output::text::{number, table};
use crate::progress::Bar;
use mckibben_app::{FitReportAnswer, FitReportRequest, fit_report};
use mckibben_campaign::fit::constants::Constants;

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    let answer = fit_report(&FitReportRequest {}, &Bar::new("steps"))?;
    asked.show(&answer, "findings", || text(&answer))?;
    Ok(if answer.ok() { 0 } else { NO_ANSWER })
}

fn text(answer: &FitReportAnswer) -> String {
    let r = &answer.results;
    let rows = r.findings.iter().map(|f| {
        let (e, w) = (&f.errors, &f.errors.worst);
        vec![
            f.at_most.map_or_else(|| "–".into(), |v| number(100.0 * v, 3)),
            format!("{:.2}", 100.0 * e.max),
            format!("{:.2}", 100.0 * e.rms),
            format!("{:.1}", 100.0 * e.max_12),
            format!("{:.1}", e.max_n),
            e.points.to_string(),
            f.comparison.clone(),
            format!(
                "D0 {} s {} P {} ε {}",
                number(w.outer_diameter_mm, 4),
                number(w.wall_mm, 3),
                number(w.pressure_mpa, 3),
                number(w.contraction, 3)
            ),
        ]
    });
    let header = ["at most", "max %", "rms %", "(12) %", "max N", "points", "comparison", "worst at"];
    let mut out = String::from(
        "In % of the finite elements' blocked force of the same muscle at 0.25 MPa, over points where they pull\n\n",
    );
    out.push_str(&table(&header, rows.collect()));
    let (c, shipped) = (&r.constants, Constants::shipped());
    out.push_str(&format!(
        "\nFitted constants: C10 {:.4} MPa, k {:.0} N/mm at D0 40, growing like D0^{:.2} (shipped: {}, {}, {})\n",
        c.c10_mpa,
        c.stiffness_at_40_n_per_mm,
        c.exponent,
        shipped.c10_mpa,
        shipped.stiffness_at_40_n_per_mm,
        shipped.exponent
    ));
    out.push_str(&format!("global has {} terms\n", r.global_terms));
    out.push_str(
        "\nRandom muscles of any size and material, where they pull, in % of the blocked force at the same pressure\n\n",
    );
    let header = ["model", "points", "muscles", "rms %", "95 % of them %", "99 % %", "max %"];
    let rows = r.random_muscles.iter().map(|row| errors_row(&row.model, &row.errors));
    out.push_str(&table(&header, rows.collect()));
    out
}
