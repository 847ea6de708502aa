//! `fit --report`: the paper's campaign computed anew, and how everything compares.

use super::text::ERRORS;
use crate::{Asked, Bar, Failure, NO_ANSWER, Units, tabled};
use mckibben_app::{FitReportAnswer, FitReportRequest, fit_report};
use mckibben_campaign::fit::constants::Constants;

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    let answer = fit_report(&FitReportRequest {}, &Bar::new("steps"))?;
    asked.show(&answer, "findings", || text(&answer))?;
    Ok(if answer.ok() { 0 } else { NO_ANSWER })
}

const FINDINGS: &str = "at_most_of_blocked=at_most:3~% max_of_blocked=largest:3% rms_of_blocked=rms:3% max_of_isobar=(12):3% max_n=largest:3 points comparison outer_diameter_mm=worst_at_D0 wall_mm=s pressure_mpa=P contraction=ε";

fn text(answer: &FitReportAnswer) -> String {
    let r = &answer.results;
    let u = Units::default();
    let mut out = String::from(
        "In % of the finite elements' blocked force of the same muscle at 0.25 MPa, over points where they pull\n\n",
    );
    out.push_str(&tabled(&r.findings, FINDINGS, &u));
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
    out + &tabled(&r.random_muscles, &format!("model {ERRORS}"), &u)
}
