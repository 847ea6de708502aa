//! Tension tests with the laws fitted to them.

use super::{caption, some_of};
use mckibben_core::{
    by_number::SortByNumber,
    extremes::{ends, even},
};
use mckibben_fit::rubber::{FittedLaw, Mode, TensionFit};
use mckibben_report::{Axis, Figure, Panel, Series, Style};

/// Most laws on one figure.
const LAWS: usize = 6;
/// Stretch to which a test without points is drawn.
const WITHOUT_POINTS: f64 = 2.0;

/// One panel a test, also for tests without points: there the laws part. Laws that are unstable in
/// a muscle are dashed, those held stable dotted.
pub fn tension(fit: &TensionFit, file: &str) -> Figure {
    let laws = drawn(fit);
    let some = some_of(laws.len(), fit.laws.len(), "laws");
    let mut figure = Figure::new("Laws fitted to tension tests")
        .caption(caption(format!(
        "Nominal stress; points of {file}{some}. Dashed: unstable over the stretches of a muscle; \
         dotted: constrained to be stable"
    )))
        .columns(3)
        .size_mm(240.0, 110.0);
    for mode in Mode::OF_ONE_STRETCH {
        figure = figure.panel(panel(mode, fit, &laws));
    }
    match general(fit, &laws) {
        Some(panel) => figure.columns(4).size_mm(320.0, 110.0).panel(panel),
        None => figure,
    }
}

/// The laws, the recommended one first, then by AICc; a free fit and its stable neighbour are two.
fn drawn(fit: &TensionFit) -> Vec<&FittedLaw> {
    let first = fit.recommended.and_then(|i| fit.laws.get(i));
    let mut others: Vec<&FittedLaw> = fit
        .laws
        .iter()
        .enumerate()
        .filter(|(i, _)| fit.recommended != Some(*i))
        .map(|o| o.1)
        .collect();
    others.sort_by_number(|a| a.quality.aicc);
    first.into_iter().chain(others).take(LAWS).collect()
}

/// Laws against points of sheets, whose two stretches no axis holds.
fn general(fit: &TensionFit, laws: &[&FittedLaw]) -> Option<Panel> {
    let points = Vec::from_iter(fit.points.iter().filter(|p| p.mode == Mode::General));
    points.first()?;
    let (low, high) = ends(points.iter().map(|p| p.nominal_stress_mpa));
    let room = 0.05 * (high - low).max(1e-9);
    let range = (low - room, high + room);
    let x = Axis::new("measured P [MPa]").range(range.0, range.1);
    let y = Axis::new("law P [MPa]").range(range.0, range.1);
    let line = [(range.0, range.0), (range.1, range.1)];
    let mut panel = Panel::new(x, y).title(Mode::General.name());
    panel = panel.series(Series::new("", line).colour(LAWS));
    for (n, law) in laws.iter().enumerate() {
        let inside = points
            .iter()
            .map(|p| (p.nominal_stress_mpa, p.stress_mpa(&law.law)))
            .filter(|p| p.1 >= range.0 && p.1 <= range.1);
        panel = panel.series(Series::scatter("", inside).colour(n));
    }
    Some(panel)
}

fn panel(mode: Mode, fit: &TensionFit, laws: &[&FittedLaw]) -> Panel {
    let points = Vec::from_iter(fit.points.iter().filter(|p| p.mode == mode));
    let (low, far) = ends(points.iter().map(|p| p.stretch).chain([1.0]));
    let end = if points.is_empty() {
        WITHOUT_POINTS.min(fit.fitted_to_stretch)
    } else {
        far
    };
    let stress = |l: &FittedLaw, x: f64| mode.nominal_stress_mpa(&l.law, x).unwrap_or_default();
    // The height follows from points, else from the laws that are stable: an unstable one may run
    // anywhere.
    let measured = points.iter().map(|p| p.nominal_stress_mpa);
    let stable = laws
        .iter()
        .filter(|l| points.is_empty() && l.quality.stable)
        .map(|l| stress(l, end));
    let heights = measured.chain(stable).filter(|y| y.is_finite());
    let (bottom, top) = ends(heights.chain([0.0]));
    let x = Axis::new("stretch λ [–]").range(low, end + 0.03 * (end - low));
    let mut y = Axis::new("stress P [MPa]");
    if top > bottom {
        y = y.range(1.05 * bottom, 1.08 * top);
    }
    let title = if points.is_empty() {
        format!("{mode} (no points)")
    } else {
        mode.name().to_owned()
    };
    let mut panel = Panel::new(x, y).title(title);
    let labelled = |text: String| {
        if mode == Mode::Uniaxial {
            text
        } else {
            String::new()
        }
    };
    if !points.is_empty() {
        let list = points.iter().map(|p| (p.stretch, p.nominal_stress_mpa));
        panel = panel.series(Series::scatter(labelled("measured".into()), list).colour(LAWS));
    }
    for (n, law) in laws.iter().enumerate() {
        let line = even((low, end), 120).map(|x| (x, stress(law, x)));
        // A law on its bound may lie on another one, as Mooney–Rivlin with C01 = 0 on the
        // neo-Hookean.
        let style = match (law.quality.stable, law.constrained) {
            (false, _) => Style::Dashed,
            (true, true) => Style::Dotted,
            (true, false) => Style::Line,
        };
        let held = if law.constrained {
            ", constrained to be stable"
        } else {
            ""
        };
        panel = panel.series(
            Series::new(labelled(format!("{}{held}", law.form.name())), line)
                .colour(n)
                .style(style),
        );
    }
    panel
}
