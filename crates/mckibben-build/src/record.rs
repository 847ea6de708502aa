//! The test record: what is expected, and room for what was measured.

use crate::{Plan, PullAt, build_sheet::grid};
use mckibben_core::analysis::STRETCH;
use mckibben_core::{extremes::peak, units::rounded};
use mckibben_report::{Document, Part};

/// The range of a load cell over the largest pull that is expected (a choice).
const LOAD_CELL: f64 = 1.25;

impl Plan {
    /// The highest pressure in MPa that a relief valve may let through.
    pub(crate) fn highest_mpa(&self) -> f64 {
        rounded(self.operating.in_use.pressure_mpa, 3, f64::floor)
    }
}

/// The record.
pub fn document(plan: &Plan) -> Document {
    let named = [
        "serial number",
        "tested by",
        "date of the test",
        "load cell, range",
    ];
    let mut title_block = plan.title_block.clone();
    title_block.extend(named.map(|name| (name.to_owned(), String::new())));
    let heading = |text: &str| Part::Heading(text.into());
    let highest = |at: &PullAt| at.range_n()[2];
    let range_n = LOAD_CELL * peak(plan.expected.iter().map(highest));
    Document {
        title: format!("Test record: {}", plan.title()),
        title_block,
        lead: plan.verdict().join(" "),
        parts: [
            heading("Pressures"),
            grid(&["", "by the model", "set"], pressures(plan)),
            heading("Proof and leak test"),
            grid(&["", "required", "measured"], proof(plan)),
            heading("First test"),
            Part::Text(format!(
                "Load cell for at least {}. test.csv has each distance between the inner faces of the \
                 heads with the pull that is expected; write the readings into it: `identify` reads it.",
                plan.shown.force(range_n)
            )),
        ]
        .into(),
        footer: String::new(),
    }
}

/// A row whose last cell is filled in by hand.
fn row(name: &str, text: String) -> Vec<String> {
    vec![name.to_owned(), text, String::new()]
}

fn pressures(plan: &Plan) -> Vec<Vec<String>> {
    let (shown, operating) = (&plan.shown, &plan.operating);
    let unknown = || "not known".to_owned();
    let limits = &operating.limits;
    let burst = limits.burst_pressure_mpa.zip(limits.burst_by);
    let burst = burst.map(|(mpa, by)| {
        let nominal = limits
            .nominal_burst_pressure_mpa
            .map(|p| format!(" at least, {} by nominal numbers", shown.short_pressure(p)));
        format!(
            "{}{}: {by}",
            shown.pressure(mpa),
            nominal.unwrap_or_default()
        )
    });
    let allowed = limits.allowed_pressure_mpa.map(|mpa| shown.pressure(mpa));
    vec![
        row("working pressure", shown.pressure(operating.pressure_mpa)),
        row("relief valve", shown.pressure(plan.highest_mpa())),
        row(
            "burst pressure, without the ends",
            burst.unwrap_or_else(unknown),
        ),
        row("allowed pressure", allowed.unwrap_or_else(unknown)),
        row("load of an end in use", shown.force(plan.loads.end_load_n)),
    ]
}

fn proof(plan: &Plan) -> Vec<Vec<String>> {
    let (shown, safety) = (&plan.shown, &plan.safety);
    let [proof, leak] =
        [safety.proof_pressure_mpa, safety.leak_pressure_mpa].map(|p| shown.pressure(p));
    vec![
        row(
            "length",
            format!("{} held", shown.length(plan.faces_mm(0.0))),
        ),
        row("pressure", proof),
        row(
            "then stretched, one minute",
            shown.length(plan.faces_mm(-STRETCH)),
        ),
        row(
            "load of an end",
            format!("{}; {}", plan.ends_carry(), plan.ends_hold()),
        ),
        row("marks moved", "0 mm".into()),
        row("leak test", format!("{leak}, {}", plan.medium())),
        row(
            "lost in five minutes",
            if plan.liquid {
                "no spot"
            } else {
                "5 % of the pressure at most"
            }
            .into(),
        ),
        row("passed, signature", String::new()),
    ]
}
