//! The test record: what is expected, and room for what was measured.

use crate::{
    Plan, PullAt, TestPoint,
    build_sheet::grid,
    safety::relief_mpa,
    text::{percent, significant_n},
};
use mckibben_core::{
    built::{Left, Measurement},
    extremes::peak,
};
use mckibben_report::{Document, Part};

/// The range of a load cell over the largest pull that is expected (a choice).
const LOAD_CELL: f64 = 1.25;

impl Plan {
    /// The highest pressure in MPa that a relief valve may let through.
    pub(crate) fn highest_mpa(&self) -> f64 {
        let allowed_mpa = self.operating.limits.allowed_pressure_mpa;
        relief_mpa(
            self.safety.pressure_mpa,
            allowed_mpa.unwrap_or(f64::INFINITY),
        )
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
    let first = first(plan).map(|table| [heading("In a few minutes"), table]);
    let highest = |at: &PullAt| at.built.map_or(at.force_n, |b| b.predicted_high_n);
    let range_n = LOAD_CELL * peak(plan.expected.iter().map(highest));
    Document {
        title: format!("Test record: {}", plan.title()),
        title_block,
        lead: plan.verdict().join(" "),
        parts: [
            Part::Stop(plan.stops()),
            heading("Pressures"),
            grid(&["", "by the model", "set"], pressures(plan)),
            heading("Proof and leak test"),
            grid(&["", "required", "measured"], proof(plan)),
        ]
        .into_iter()
        .chain(first.into_iter().flatten())
        .chain([
            heading("First test"),
            Part::Text(format!(
                "Load cell for at least {}. Distances are between the inner faces of the heads. \
                 Write the pulls into test.csv too: `identify` reads it.",
                plan.shown.force(range_n)
            )),
            pulls(plan),
        ])
        .collect(),
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
    let end = "load of an end at the working pressure";
    vec![
        row("working pressure", shown.pressure(operating.pressure_mpa)),
        row("relief valve", shown.pressure(plan.highest_mpa())),
        row(
            "burst pressure, without the ends",
            burst.unwrap_or_else(unknown),
        ),
        row("allowed pressure", allowed.unwrap_or_else(unknown)),
        row(end, shown.force(plan.end_load_n)),
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
        row("pressure, one minute", proof),
        row("load of an end", shown.force(plan.proof_load_n)),
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

/// What is worth measuring before the test, as in the first rows of its sheet.
fn first(plan: &Plan) -> Option<Part> {
    let shown = &plan.shown;
    let p = shown.short_pressure(plan.operating.pressure_mpa);
    let one = |left: &Left| {
        let (what, minutes) = left.measurement.words();
        let set = match left.measurement {
            Measurement::HungLoad => "load, pressure, contraction".into(),
            Measurement::OnePull => format!("{p}, distance {}", shown.length(plan.faces_mm(0.05))),
            Measurement::FreeContraction => format!("{p}, no load"),
            Measurement::StartPressure | Measurement::Turns => "in muscle.toml".into(),
            // The test below.
            Measurement::TenPulls => return None,
        };
        let half = shown.force(significant_n(left.uncertainty_n));
        let worth = format!("± {half} ({minutes} min)");
        Some(vec![what.into(), set, worth, String::new()])
    };
    let rows = plan
        .operating
        .to_measure
        .as_ref()?
        .left
        .iter()
        .filter_map(one);
    let head = ["measure", "at", "then the pull is known to", "measured"];
    Some(grid(&head, rows.collect()))
}

/// What is expected at each point of the first test.
fn pulls(plan: &Plan) -> Part {
    let shown = &plan.shown;
    let pull = |(point, at): (&TestPoint, &PullAt)| {
        let interval = at.built.map(|built| {
            let ends = [built.predicted_low_n, built.predicted_high_n];
            let [low, high] = ends.map(|n| shown.force(n.max(0.0)));
            format!("{} ({low} to {high})", shown.force(built.predicted_n))
        });
        vec![
            shown.short_pressure(at.pressure_mpa),
            percent(at.contraction),
            shown.length(plan.faces_mm(at.contraction)),
            point.branch.to_string(),
            interval.unwrap_or_else(|| format!("{} (model alone)", shown.force(at.force_n))),
            String::new(),
        ]
    };
    let head = [
        "pressure",
        "contraction",
        "distance",
        "branch",
        "expected (95 %)",
        "measured",
    ];
    grid(
        &head,
        plan.test.iter().zip(&plan.expected).map(pull).collect(),
    )
}
