//! What a report takes from the plan of a build: the drawing, the margins of safety, the sheet of the first test.

use crate::{Units, number, percent, words::fixed};
use mckibben::analysis::{Burst, FailurePressure, SAFETY};
use mckibben::muscle::Direction;
use mckibben_build::{Plan, drawing_svg};
use mckibben_report::Part;

/// The margins of safety, and the drawing.
pub(super) fn front(plan: &Plan, burst: &Burst, units: &Units) -> Vec<Part> {
    let drawing = drawing_svg(plan).ok().map(Part::Drawing);
    margins(plan, burst, units).into_iter().chain(drawing).collect()
}

/// The pressure of each failure over the working pressure, beside what is required.
fn margins(plan: &Plan, burst: &Burst, units: &Units) -> Vec<Part> {
    let working_mpa = plan.operating.pressure_mpa;
    let mut rows: Vec<Vec<String>> = burst
        .modes()
        .into_iter()
        .map(|(mode, at)| {
            let required = number(SAFETY * mode.share(), 3);
            let (pressure, factor) = match at {
                FailurePressure::At(p) => (units.pressure.show(p), fixed(p / working_mpa, 1)),
                FailurePressure::None => ("at no pressure".into(), "–".into()),
                FailurePressure::Unknown(why) => {
                    (format!("not known: {}", units.sentence(&why.to_string())), "–".into())
                }
            };
            vec![mode.to_string(), factor, required, pressure]
        })
        .collect();
    if let Some(rated) = burst.rated_mpa {
        let factor = fixed(rated / working_mpa, 1);
        rows.push(vec!["the fittings are rated for".into(), factor, "1".into(), units.pressure.show(rated)]);
    }
    let safety = plan.safety;
    let head = ["failure", "factor", "required", "pressure"].map(str::to_owned).to_vec();
    vec![
        Part::Heading("Margins of safety".into()),
        Part::Text(format!(
            "Factor: pressure of the failure over {}. Estimates of new parts under a slowly rising pressure; proof test with water at {}. The air holds {} J.",
            units.pressure.show(working_mpa),
            units.pressure.show(safety.proof_pressure_mpa),
            number(safety.air_energy_j, 2),
        )),
        Part::Table { head, rows },
    ]
}

/// The points of the first test, with a column to fill in.
pub(super) fn test_sheet(plan: &Plan, units: &Units) -> Vec<Part> {
    let length_mm = plan.muscle.length_mm();
    let mut rows: Vec<Vec<String>> = vec![];
    for (i, point) in plan.test.iter().enumerate() {
        let branch = if point.branch == Direction::Elongation { "falling" } else { "rising" };
        rows.push(vec![
            (i + 1).to_string(),
            units.length.show(length_mm * (1.0 - point.contraction)),
            percent(point.contraction),
            units.pressure.show(point.pressure_mpa),
            branch.into(),
            String::new(),
        ]);
    }
    let pull = format!("measured pull [{}]", units.force.name);
    let head = ["no.", "distance of the clamps", "contraction", "pressure", "pressure is", &pull];
    vec![
        Part::Heading("Bench test".into()),
        Part::Text(
            "Set the distance, then the pressure, row by row and without going back; write the pull down. `mckibben build` writes the same rows as test.csv, which `mckibben identify` reads."
                .into(),
        ),
        Part::Table { head: head.map(str::to_owned).to_vec(), rows },
    ]
}
