//! What the ± covers of points that were left out: predicted by other points, pressures or lengths
//! of their muscle, by another specimen, or by other families of muscles.

use crate::{case::MuscleCase, families::Known, fit::predicted, left_out_families};
use mckibben_core::{extremes::peak, muscle::Braid, threads};
use mckibben_fit::{
    identify::Build,
    least_squares::Errors,
    library::residual::{Residual, residuals},
    measured::{DataPoint, distinct, same},
};

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
enum Way {
    /// A fifth of the points of a muscle by the others.
    Points,
    /// A fifth of the pressures by the others.
    Pressures,
    /// Each length by the others, and by each other one.
    Lengths,
    /// A muscle by another one that is the same product, or of the same make at another angle.
    Specimens,
    /// A family by the others, and so many points of each of its muscles.
    Families(usize),
}

/// The ways of the table, in its words.
const WAYS: [(Way, &str); 8] = [
    (Way::Points, "a fifth of the points"),
    (Way::Pressures, "a fifth of the pressures"),
    (Way::Lengths, "each length, also by each other one"),
    (Way::Specimens, "a muscle, by another specimen"),
    (Way::Families(0), "a whole family of muscles"),
    (Way::Families(1), "a family, with 1 own point"),
    (Way::Families(3), "a family, with 3 own points"),
    (Way::Families(10), "a family, with 10 own points"),
];

/// What the ± covers in one way, by series.
pub struct Coverage {
    pub way: &'static str,
    series: Vec<SeriesJudged>,
}

/// What the ± of the measured muscles covers in every way, by what each series tells.
pub fn left_out(cases: &[&MuscleCase], known: &[Known<'_>], build: &Build<'_>) -> Vec<Coverage> {
    let one = |(way, words)| Coverage {
        way: words,
        series: match way {
            Way::Families(own_points) => left_out_families::left_out(known, own_points, build),
            Way::Specimens => specimens(cases, build),
            _ => threads::map(cases, |&case| {
                let fit = case.fits.first()?;
                let pairs = pairs(way, &case.points_of(fit), fit.muscle.length_mm());
                let of = |(from, rest): &(Vec<_>, Vec<_>)| predicted(build, fit, from, rest).ok();
                let all: Vec<_> = pairs.iter().filter_map(of).collect();
                Some(judged(&case.facts.title, &all.concat()))
            })
            .into_iter()
            .flatten()
            .filter(|s| !s.1.is_empty())
            .collect(),
        },
    };
    WAYS.into_iter().map(one).collect()
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
fn specimens(cases: &[&MuscleCase], build: &Build<'_>) -> Vec<SeriesJudged> {
    let one = |from: &MuscleCase, to: &MuscleCase| {
        let muscle = from.identified.as_ref()?;
        let fit = to.fits.first()?;
        let other = &fit.muscle;
        let is_product = from.facts.product.is_some();
        let is_sibling =
            is_product || muscle.tube().outer_diameter_mm == other.tube().outer_diameter_mm;
        if to.facts.rms_of_blocked.is_none()
            || from.name == to.name
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
        let braid = Braid {
            angle_deg: braid.angle_deg,
            ..muscle.braid().clone()
        };
        let muscle = muscle.with_braid(braid).ok()?;
        let mut points = to.points_of(fit);
        // They state their length or have that of their muscle.
        for point in &mut points {
            point.section.length_mm.get_or_insert(other.length_mm());
        }
        let title = format!("{} by {}", to.facts.title, from.facts.title);
        Some(judged(&title, &residuals(build, &muscle, &points, 0.0)))
    };
    let pairs = cases
        .iter()
        .flat_map(|from| cases.iter().map(move |to| (from, to)));
    pairs.filter_map(|(from, to)| one(from, to)).collect()
}

/// What the ± covers of some points.
pub struct Covered {
    pub points: usize,
    /// Share of the points inside.
    pub share: f64,
    /// Mean half-width and mean difference over the largest pull; the latter is below zero where the
    /// prediction is too strong.
    pub half: f64,
    pub bias: f64,
}

impl Covered {
    fn of(list: &[Judged]) -> Self {
        let inside = list.iter().filter(|j| j.off.abs() <= j.half).count();
        let mean = |of: fn(&Judged) -> f64| Errors::new(list.iter().map(of)).mean;
        Self {
            points: list.len(),
            share: inside as f64 / list.len().max(1) as f64,
            half: mean(|j| j.half),
            bias: mean(|j| j.off),
        }
    }
}

impl Coverage {
    pub fn all(&self) -> Covered {
        let all: Vec<Judged> = self.series.iter().flat_map(|s| &s.1).copied().collect();
        Covered::of(&all)
    }

    /// What is covered of each series.
    pub fn series(&self) -> impl ExactSizeIterator<Item = Covered> {
        self.series.iter().map(|(_, list)| Covered::of(list))
    }
}
