//! What the ± covers of points that were left out: predicted by other points, pressures or lengths
//! of their muscle, by another specimen, or by other families of muscles.

use super::{
    case::{CaseFit, MuscleCase},
    coverage::{COVERAGE, validated},
    families::{self, Known},
    library::library,
    residual::{Fitter, Residual, residuals},
};
use crate::{
    identify::Result,
    least_squares::Errors,
    measured::{DataPoint, distinct, same},
};
use mckibben_core::{
    extremes::peak,
    muscle::{Braid, Muscle},
    threads,
    verification::{Measure, VerificationRow},
};
use std::fmt;

/// Parts into which the points, or the pressures, of a muscle are divided.
const PARTS: usize = 5;

/// A measured point beside its prediction.
#[derive(Debug, Clone, Copy)]
pub struct Judged {
    /// Measured less median, over the largest pull of the series.
    pub off: f64,
    /// Half of the interval over it.
    pub half: f64,
}

/// A series of points by its name.
pub type SeriesJudged = (String, Vec<Judged>);

/// What is left out, and what predicts it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Way {
    /// A fifth of the points of a muscle by the others.
    Points,
    /// A fifth of the pressures by the others.
    Pressures,
    /// Each length by the others, and by each other one.
    Lengths,
    /// A muscle by another one that is the same product, or of the same make at another angle.
    Specimens,
    /// A family by the others, and so many points of each of its muscles.
    Families { own_points: usize },
}

impl Way {
    /// The ways of the table.
    pub const ALL: [Self; 8] = [
        Self::Points,
        Self::Pressures,
        Self::Lengths,
        Self::Specimens,
        Self::Families { own_points: 0 },
        Self::Families { own_points: 1 },
        Self::Families { own_points: 3 },
        Self::Families { own_points: 10 },
    ];
}

impl fmt::Display for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Points => "a fifth of the points by the others",
            Self::Pressures => "a fifth of the pressures by the others",
            Self::Lengths => "each length by the others, and by each other one",
            Self::Specimens => "a muscle by another specimen",
            Self::Families { own_points: 0 } => "a family by the others",
            Self::Families { own_points: 1 } => "a family by the others and 1 own point",
            Self::Families { own_points } => {
                return write!(f, "a family by the others and {own_points} own points");
            }
        })
    }
}

/// What the ± covers, by series.
pub struct Coverage {
    pub way: Way,
    pub series: Vec<SeriesJudged>,
}

/// What the ± of the measured muscles covers in one way.
pub fn left_out(
    way: Way,
    sets: &[&'static MuscleCase],
    known: &[Known<'_>],
    by: Fitter<'_>,
) -> Coverage {
    let series = match way {
        Way::Families { own_points } => families::left_out(known, own_points, by),
        Way::Specimens => specimens(sets, by),
        _ => threads::map(sets, |&set| {
            let fit = set.fits.first()?;
            let pairs = pairs(way, &set.points_of(fit), fit.muscle.length_mm());
            let predicted = |(fitted, rest): &(Vec<_>, Vec<_>)| by.predicted(fit, fitted, rest);
            let all: Vec<_> = pairs.iter().filter_map(|p| predicted(p).ok()).collect();
            Some(judged(&set.facts.title, &all.concat()))
        })
        .into_iter()
        .flatten()
        .filter(|s| !s.1.is_empty())
        .collect(),
    };
    Coverage { way, series }
}

/// Points that are fitted, and others that these predict.
fn pairs(way: Way, points: &[DataPoint], length_mm: f64) -> Vec<(Vec<DataPoint>, Vec<DataPoint>)> {
    let parts = match way {
        Way::Points => (0..PARTS)
            .map(|i| points.iter().skip(i).step_by(PARTS).copied().collect())
            .collect(),
        Way::Lengths => parts(points, usize::MAX, |p| {
            p.section.length_mm.unwrap_or(length_mm)
        }),
        _ => parts(points, PARTS, |p| p.at.pressure_mpa),
    };
    let each = 0..parts.len();
    let others = |i: usize| each.clone().filter(move |&k| k != i);
    let mut pairs = vec![];
    for i in each.clone().filter(|_| parts.len() > 1) {
        let of_others = Vec::from_iter(others(i).flat_map(|k| parts[k].iter().copied()));
        pairs.push((of_others, parts[i].clone()));
        if way == Way::Lengths && parts.len() > 2 {
            pairs.extend(others(i).map(|k| (parts[k].clone(), parts[i].clone())));
        }
    }
    pairs
}

/// Points in parts, each of a few values of a quantity.
fn parts(
    points: &[DataPoint],
    parts: usize,
    value: impl Fn(&DataPoint) -> f64,
) -> Vec<Vec<DataPoint>> {
    let values = distinct(points.iter().map(&value));
    let of_part = |part: &[f64]| {
        let is_in = |p: &&DataPoint| part.iter().any(|v| same(*v, value(p)));
        points.iter().filter(is_in).copied().collect()
    };
    let size = values.len().div_ceil(parts).max(1);
    values.chunks(size).map(of_part).collect()
}

impl Fitter<'_> {
    /// What the muscle that some points of a bench give says of others.
    pub fn predicted(
        &self,
        fit: &CaseFit,
        fitted: &[DataPoint],
        others: &[DataPoint],
    ) -> Result<Vec<Residual>> {
        let section = fitted.first().map(|p| p.section.apply(&fit.muscle));
        let fit = CaseFit {
            muscle: section.and_then(|m| m.ok()).unwrap_or(fit.muscle.clone()),
            ..fit.clone()
        };
        let muscle = self.learnt(&fit, fitted)?.with_bench();
        Ok(residuals(self.build, &muscle, others, 0.0))
    }
}

fn judged(title: &str, residuals: &[Residual]) -> SeriesJudged {
    let largest_n = peak(residuals.iter().map(|r| r.blocked_n));
    let one = |r: &Residual| {
        let (off_n, half_n) = r.of_built_n?;
        Some(Judged {
            off: off_n / largest_n,
            half: half_n / largest_n,
        })
    };
    (title.to_owned(), residuals.iter().filter_map(one).collect())
}

/// The constants of each muscle of the library, with the length or the angle of another that is the
/// same product (specimen, fittings, gauge and zero of the length differ) or a sibling of another
/// angle, against the points of the other.
fn specimens(sets: &[&'static MuscleCase], by: Fitter<'_>) -> Vec<SeriesJudged> {
    let pairs = library()
        .unwrap_or_default()
        .into_iter()
        .flat_map(|from| sets.iter().map(move |to| (from, *to)));
    let specimen = |((from, muscle), to): ((&MuscleCase, &Muscle), &'static MuscleCase)| {
        let fit = to.fits.first()?;
        let other = &fit.muscle;
        let is_product = from.facts.product.is_some();
        let is_sibling =
            is_product || muscle.tube().outer_diameter_mm == other.tube().outer_diameter_mm;
        if to.rms_of_blocked.is_none()
            || from.facts.name == to.facts.name
            || from.facts.product != to.facts.product
            || !is_sibling
        {
            return None;
        }
        let braid = if is_product {
            muscle.braid()
        } else {
            other.braid()
        };
        let muscle = muscle
            .with_braid(Braid {
                angle_deg: braid.angle_deg,
                ..muscle.braid().clone()
            })
            .ok()?;
        let mut points = to.points_of(fit);
        // They state their length or have that of their muscle.
        for point in &mut points {
            point.section.length_mm.get_or_insert(other.length_mm());
        }
        let title = format!("{} by {}", to.facts.title, from.facts.title);
        Some(judged(&title, &residuals(by.build, &muscle, &points, 0.0)))
    };
    pairs.filter_map(specimen).collect()
}

fn inside(list: &[Judged]) -> f64 {
    let held = list.iter().filter(|j| j.off.abs() <= j.half).count();
    held as f64 / list.len().max(1) as f64
}

/// What the differences from the medians, and the halves of the intervals, amount to.
fn errors(list: &[Judged]) -> [Errors; 2] {
    [|j: &Judged| j.off, |j: &Judged| j.half].map(|of| Errors::new(list.iter().map(of)))
}

impl Coverage {
    /// Points, share of them inside, mean half-width and bias over the largest pull (below zero
    /// where the prediction is too strong), and the share of the worst series.
    fn summary(&self) -> (usize, f64, f64, f64, f64) {
        let all: Vec<Judged> = self.series.iter().flat_map(|s| &s.1).copied().collect();
        let [off, half] = errors(&all);
        let worst = self.series.iter().map(|s| inside(&s.1)).fold(1.0, f64::min);
        (all.len(), inside(&all), half.mean, off.mean, worst)
    }

    /// The share of the points inside, beside 95 %.
    fn row(&self) -> VerificationRow {
        let (_, share, ..) = self.summary();
        let name = format!("left out, {}", self.line());
        let row = VerificationRow::new(name, "all measured muscles", COVERAGE, Some(share), 0.0);
        validated(row, Measure::Share, Some((COVERAGE - share).max(0.0)))
    }

    fn line(&self) -> String {
        let (points, share, half, bias, worst) = self.summary();
        format!(
            "{}: {points} points of {} series, {:.1} % within the ± ({:.1} % of the largest pull, \
             bias {:+.1} %, worst series {:.0} %)",
            self.way,
            self.series.len(),
            100.0 * share,
            100.0 * half,
            100.0 * bias,
            100.0 * worst
        )
    }
}

/// A row for each way.
pub(super) fn cases(sets: &[&'static MuscleCase], by: Fitter<'_>) -> Vec<VerificationRow> {
    let series = families::series(sets);
    let known = families::known(&series, by);
    let row = |way| left_out(way, sets, &known, by).row();
    Way::ALL.into_iter().map(row).collect()
}

impl fmt::Display for Coverage {
    /// The summary, and series by series.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.line())?;
        for (name, list) in &self.series {
            let [off, half] = errors(list);
            writeln!(
                f,
                "  {name}: {} points, inside {:.0} %, half-width {:.1} %, bias {:+.1} %, rms {:.1} %",
                list.len(),
                100.0 * inside(list),
                100.0 * half.mean,
                100.0 * off.mean,
                100.0 * off.rms
            )?;
        }
        Ok(())
    }
}
