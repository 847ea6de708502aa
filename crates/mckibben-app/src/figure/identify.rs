//! What was identified: the model over the points, and the residuals.

use super::{caption, contraction, pressure, pull, said, some_of, told_apart};
use crate::{percent, units::Units};
use mckibben_core::{
    analysis::Evaluation, by_number::ByNumber, extremes::ends, model::Workspace, muscle::Direction,
};
use mckibben_fit::{
    identify::{Build, Identification, PointFit},
    measured::{Section, distinct, same},
};
use mckibben_report::{Axis, Figure, Panel, Series, Style};

/// Curves of one figure at most; of more levels some are shown.
const CURVES: usize = 6;

/// Some of many, first and last among them.
fn thinned(list: &[f64]) -> Vec<f64> {
    if list.len() <= CURVES {
        return list.to_vec();
    }
    (0..CURVES)
        .map(|i| list[i * (list.len() - 1) / (CURVES - 1)])
        .collect()
}

/// What is fixed along the curves of a figure, and so what its colours mean.
struct Levels {
    isobaric: bool,
    fixed: Vec<f64>,
    /// How many there are; some of them are drawn.
    all: usize,
}

impl Levels {
    fn new(identified: &Identification) -> Self {
        let at = || identified.points.iter().map(|f| f.point.at);
        let pressures = distinct(at().map(|p| p.pressure_mpa));
        let contractions = distinct(at().map(|p| p.contraction));
        let isobaric = pressures.len() <= contractions.len();
        let all = if isobaric { pressures } else { contractions };
        Self {
            isobaric,
            fixed: thinned(&all),
            all: all.len(),
        }
    }

    /// What a caption says of those that are not drawn.
    fn shown(&self) -> String {
        let what = if self.isobaric {
            "pressures"
        } else {
            "contractions"
        };
        some_of(self.fixed.len(), self.all, what)
    }

    fn key(&self, f: &PointFit) -> f64 {
        self.states(f)[0]
    }

    /// What is fixed along a curve, and what varies.
    fn states(&self, f: &PointFit) -> [f64; 2] {
        let at = &f.point.at;
        if self.isobaric {
            [at.pressure_mpa, at.contraction]
        } else {
            [at.contraction, at.pressure_mpa]
        }
    }

    /// The level that is nearest to a point.
    fn nearest(&self, f: &PointFit) -> usize {
        let off = |n: usize| (self.fixed[n] - self.key(f)).abs();
        (0..self.fixed.len())
            .min_by_number(|&a| off(a))
            .unwrap_or_default()
    }

    fn label(&self, n: usize, u: &Units) -> String {
        let value = self.fixed[n];
        if self.isobaric {
            u.pressure.show(value)
        } else {
            format!("ε {}", percent(value))
        }
    }
}

/// The model over the points of the first muscle, and the residuals of all over contraction and
/// pressure.
pub fn identified(
    identified: &Identification,
    build: &Build<'_>,
    origin: &str,
    about: &str,
    u: &Units,
) -> Figure {
    let mut figure = Figure::new(format!("Identified from {origin}")).sequential();
    let sections = sections(identified);
    let levels = Levels::new(identified);
    for section in sections.iter().take(if sections.len() > 1 { 2 } else { 1 }) {
        figure = figure.panel(fit(
            identified,
            build,
            section,
            &levels,
            u,
            sections.len() > 1,
        ));
    }
    let bands = figure
        .panels
        .iter()
        .flat_map(|panel| &panel.series)
        .filter(|series| series.style == Style::Band);
    let said = said(&bands.cloned().collect::<Vec<_>>(), "");
    let shown = levels.shown();
    let rms = u.force.to(identified.rms_n, 3);
    figure = figure.caption(caption(format!(
        "Dots: data; lines: {about}{said}{shown}. rms {rms} {}",
        u.force.name
    )));
    let residuals = |x: fn(&PointFit) -> f64, axis: Axis, scale: f64| {
        let mut panel = Panel::new(axis, Axis::new(u.force.heading("model − data")).from_zero());
        for n in 0..levels.fixed.len() {
            let points = identified
                .points
                .iter()
                .filter(|f| levels.nearest(f) == n)
                .map(|f| (scale * x(f), u.force.value(f.residual_n)));
            let points = Series::scatter(levels.label(n, u), points).colour(n);
            if !points.points.is_empty() {
                panel = panel.series(points);
            }
        }
        panel
    };
    figure
        .panel(residuals(|f| f.point.at.contraction, contraction(), 1.0))
        .panel(residuals(
            |f| f.point.at.pressure_mpa,
            pressure(u),
            u.pressure.value(1.0),
        ))
}

/// The muscles of the data, those with most points first.
fn sections(identified: &Identification) -> Vec<Section> {
    let mut list: Vec<(Section, usize)> = vec![];
    for f in &identified.points {
        match list.iter_mut().find(|s| s.0 == f.point.section) {
            Some(entry) => entry.1 += 1,
            None => list.push((f.point.section, 1)),
        }
    }
    list.sort_by_key(|s| std::cmp::Reverse(s.1));
    // The first and the last of several: the ends of the range, as a rule.
    if list.len() > 2 {
        let last = list.len() - 1;
        list.swap(1, last);
    }
    list.into_iter().map(|s| s.0).collect()
}

fn fit(
    identified: &Identification,
    build: &Build<'_>,
    section: &Section,
    levels: &Levels,
    u: &Units,
    named: bool,
) -> Panel {
    let mine = Vec::from_iter(
        identified
            .points
            .iter()
            .filter(|f| f.point.section == *section),
    );
    let isobaric = levels.isobaric;
    let x_of = |f: &PointFit| levels.states(f)[1];
    let shown = |x: f64| if isobaric { x } else { u.pressure.value(x) };
    let x = if isobaric { contraction() } else { pressure(u) };
    let mut panel = Panel::new(x, pull(u));
    let muscle = section.apply(&identified.muscle);
    if named && let Ok(m) = &muscle {
        let [diameter, wall] = [m.outer_diameter_mm(), m.wall_mm()].map(|mm| u.length.show(mm));
        panel = panel.title(format!("D0 {diameter}, s {wall}"));
    }
    // What the points tell of a built muscle belongs to the muscle of the file.
    let is_own = muscle.as_ref().is_ok_and(|m| *m == identified.muscle);
    let muscle = if is_own {
        Ok(identified.with_bench())
    } else {
        muscle
    };
    let mut bands = vec![];
    let model = muscle.ok().and_then(|m| build(&m).ok());
    for (n, &value) in levels.fixed.iter().enumerate() {
        let key = |f: &&&PointFit| same(levels.key(f), value);
        let label = levels.label(n, u);
        let on = Vec::from_iter(mine.iter().filter(key));
        let dots = on
            .iter()
            .map(|f| (shown(x_of(f)), u.force.value(f.point.at.force_n)));
        panel = panel.series(Series::scatter(label.clone(), dots).colour(n));
        let Some(model) = &model else { continue };
        let (low, high) = ends(on.iter().map(|f| x_of(f)));
        let mut branches = Vec::from_iter(on.iter().map(|f| f.point.at.direction()));
        branches.sort_by_key(|b| *b as u8);
        branches.dedup();
        for branch in branches {
            let workspace = &mut Workspace::new();
            let mut evaluation = Evaluation::new(model.as_ref(), workspace, branch);
            let mut edges = vec![];
            let points = (0..=40).filter_map(|i| {
                let x = low + (high - low) * f64::from(i) / 40.0;
                let (pressure, contraction) = if isobaric { (value, x) } else { (x, value) };
                // A muscle does not push.
                let force = evaluation
                    .force_n(pressure, contraction)
                    .ok()
                    .filter(|f| *f >= 0.0)?;
                let x = shown(x);
                let built = evaluation.predicted(pressure, contraction, force);
                let Some((built, _)) = built.filter(|_| is_own) else {
                    return Some((x, u.force.value(force)));
                };
                let ends = [built.predicted_low_n, built.predicted_high_n];
                let [low, high] = ends.map(|n| u.force.value(n));
                edges.push((x, low, high));
                Some((x, u.force.value(built.predicted_n)))
            });
            let style = if branch == Direction::Elongation {
                Style::Dashed
            } else {
                Style::Line
            };
            panel = panel.series(Series::new("", points).style(style).colour(n));
            bands.extend((edges.len() > 1).then(|| Series::band(&edges).colour(n)));
        }
    }
    panel.series.extend(told_apart(bands));
    panel
}
