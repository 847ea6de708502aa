//! Every measured muscle beside its first fit: pull over contraction, a panel for each of its lengths.

use super::caption;
use super::curves::pull;
use crate::units::Units;
use mckibben::{model::Workspace, muscle::Muscle};
use mckibben_fit::measured::{DataPoint, Section, mean_of_data};
use mckibben_fit::{identify::Build, validation::case::MuscleCase, validation::report::FitResult};
use mckibben_report::{Axis, Figure, Palette, Panel, Series};

/// Pressures of a panel at most; of more some are shown.
const CURVES: usize = 5;
/// Points of a line.
const LINE: u32 = 30;

/// Measured points and lines of a model, muscle by muscle.
pub(crate) fn measured(
    cases: &[&MuscleCase],
    found: &[FitResult],
    model: (&str, &Build<'_>),
    u: &Units,
) -> Figure {
    let name = model.0;
    let about = format!(
        "Dots: measured, means of the branches; lines: {name} with what the first fit of each muscle found, over ε at constant pressure"
    );
    let mut figure = Figure::new(format!("Measured muscles and {name}"))
        .caption(caption(&about))
        .palette(Palette::Sequential);
    for (number, case) in cases.iter().enumerate() {
        let Some(first) = found.iter().find(|r| r.case == number && r.fit == 0) else { continue };
        figure = panels(figure, case, &first.muscle, model.1, u);
    }
    figure.columns(2)
}

/// A panel for each length of a muscle.
fn panels(mut figure: Figure, case: &MuscleCase, muscle: &Muscle, build: &Build<'_>, u: &Units) -> Figure {
    let means = mean_of_data(&case.points);
    let mut sections: Vec<Section> = vec![];
    for p in &means {
        if !sections.contains(&p.section) {
            sections.push(p.section);
        }
    }
    for section in &sections {
        let own: Vec<&DataPoint> = means.iter().filter(|p| p.section == *section).collect();
        let title = match section.length_mm {
            Some(length) if sections.len() > 1 => format!("{}: {}", case.facts.name, u.length.show(length)),
            _ => case.facts.title.clone(),
        };
        figure = figure.panel(panel(title, &own, muscle, build, u));
    }
    figure
}

fn panel(title: String, points: &[&DataPoint], found: &Muscle, build: &Build<'_>, u: &Units) -> Panel {
    let mut panel = Panel::new(Axis::new("contraction ratio ε [–]").from_zero(), pull(u));
    let mut pressures: Vec<f64> = points.iter().map(|p| p.at.pressure_mpa).collect();
    pressures.sort_by(f64::total_cmp);
    pressures.dedup();
    let (all, last) = (pressures.len(), pressures.len().saturating_sub(1));
    let shown: Vec<f64> = match pressures.len() {
        n if n <= CURVES => pressures,
        _ => (1..=CURVES).map(|i| pressures[i * last / CURVES]).collect(),
    };
    let some =
        if shown.len() < all { format!(" ({} of {all} pressures)", shown.len()) } else { String::new() };
    panel = panel.title(title + &some);
    let muscle = points.first().and_then(|p| p.section.apply(found).ok());
    let model = muscle.and_then(|m| build(&m).ok());
    let mut workspace = Workspace::new();
    for (n, &pressure) in shown.iter().enumerate() {
        let at = || points.iter().filter(|p| p.at.pressure_mpa == pressure);
        let dots: Vec<(f64, f64)> = at().map(|p| (p.at.contraction, u.force.value(p.at.force_n))).collect();
        let end = at().map(|p| p.at.contraction).fold(0.0, f64::max);
        panel = panel.series(Series::scatter(u.pressure.show(pressure), dots).colour(n));
        let Some(model) = &model else { continue };
        let line = (0..=LINE).filter_map(|i| {
            let contraction = end * f64::from(i) / f64::from(LINE);
            let force_n = model.force_n(&mut workspace, pressure, contraction).ok()?;
            (force_n >= 0.0).then(|| (contraction, u.force.value(force_n)))
        });
        panel = panel.series(Series::new("", line.collect::<Vec<_>>()).colour(n));
    }
    panel
}
