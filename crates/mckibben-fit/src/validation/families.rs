//! What the ± of a muscle that is built covers where a whole family of measured muscles is left out,
//! and what all families tell of one that nobody measured.
//!
//! A family is what one maker, or one workshop, made; a series of it is one muscle of one length.
//! The constants y of a series are those with the largest posterior for all of its points, with a
//! wide prior; those of a family are the means yf of its series. With J families, and m0 and s0 of
//! what one would say without any,
//!
//! What the families tell together is a population ([`population`](super::population)).

use super::{
    case::MuscleCase,
    coverage::validated,
    population::{Population, Told},
    residual::Fitter,
};
use crate::{
    identify::{Posterior, PosteriorRequest, written_bench},
    measured::{DataPoint, Quantity, Section},
};
use mckibben_core::{
    analysis::{Evaluation, Options},
    built::{Belief, Experience, Predictor, Prior},
    extremes::peak,
    model::Workspace,
    muscle::{Constant, Constants, EndsMade, Muscle},
    threads,
    verification::{Measure, VerificationRow},
};
use nalgebra::{SMatrix, SVector};
use std::{f64::consts::SQRT_2, fmt};

/// One measured muscle of one length.
pub struct Series {
    pub family: String,
    pub name: String,
    pub source: String,
    pub muscle: Muscle,
    pub angle_deviation_deg: Option<f64>,
    pub points: Vec<DataPoint>,
}

/// The series of the measured muscles that belong to a family.
pub fn series(sets: &[&MuscleCase]) -> Vec<Series> {
    let mut out = vec![];
    for set in sets {
        let (Some(family), Some(fit)) = (&set.facts.family, set.fits.first()) else {
            continue;
        };
        let mut sections: Vec<Section> = vec![];
        for point in &set.points {
            if !sections.contains(&point.section) {
                sections.push(point.section);
            }
        }
        for section in sections {
            let Ok(muscle) = section.apply(&fit.muscle) else {
                continue;
            };
            let own = set.points.iter().filter(|p| p.section == section);
            let length = section
                .length_mm
                .map_or_else(String::new, |l| format!(", {l} mm"));
            out.push(Series {
                family: family.clone(),
                name: format!("{}{length}", set.facts.title),
                source: set.facts.source.clone(),
                muscle,
                angle_deviation_deg: set.facts.angle_deviation_deg,
                points: own.copied().collect(),
            });
        }
    }
    out
}

/// What one would say of each constant without any measured muscle: m0 and s0, a judgement. Ends that
/// are crimped give way less than those that are clamped by hand.
fn without_families() -> Experience {
    let belief = |centre, deviation| Belief { centre, deviation };
    Experience {
        pull_factor: belief(0.0, 0.055),
        seating: belief(0.05, 0.035),
        compliance_crimped: belief(0.02, 0.02),
        compliance_clamped: belief(0.04, 0.02),
        compliance_unknown: belief(0.03, 0.02),
        take_up: belief(0.02, 0.014),
        modulus: belief(0.0, 0.2),
        friction: belief(0.08, 0.04),
        friction_in_rubber: belief(0.02, 0.02),
        specimen: [
            0.055,
            0.035,
            0.02,
            0.014,
            0.2,
            ANGLE_OF_SPECIMENS_DEG,
            0.1,
            0.02,
        ],
        length: [0.04, 0.03, 0.02, 0.014, 0.2, 0.0, 0.0, 0.0],
    }
}

/// Standard deviation of the angle between specimens of a product.
const ANGLE_OF_SPECIMENS_DEG: f64 = 0.4;
/// Standard deviation of ln of the modulus of a rubber that is guessed.
const GUESSED_RUBBER: f64 = 0.35;

/// The prior of a measured muscle whose rubber nobody stated.
fn prior_of(series: &Series, experience: &Experience) -> Prior {
    let mut prior = Prior::of(&series.muscle, experience);
    let angle = &mut prior.deviation[Constant::Angle as usize];
    *angle = series.angle_deviation_deg.unwrap_or(*angle);
    prior.deviation[Constant::Modulus as usize] = GUESSED_RUBBER;
    prior
}

/// A series with the constants of all of its points.
pub struct Known<'a> {
    pub series: &'a Series,
    /// What its points tell, with a wide prior.
    pub posterior: Posterior,
    told: Told,
}

fn posterior(
    series: &Series,
    points: &[DataPoint],
    (experience, prior): (&Experience, &Prior),
    by: Fitter<'_>,
) -> Option<Posterior> {
    PosteriorRequest {
        muscle: &series.muscle,
        points,
        build: by.build,
        experience,
        prior,
        progress: by.progress,
        search: true,
    }
    .posterior()
    .ok()
    .flatten()
}

/// The constants of every series, with a wide prior.
pub fn known<'a>(all: &'a [Series], by: Fitter<'_>) -> Vec<Known<'a>> {
    let wide = without_families();
    let one = |series: &&'a Series| {
        let mut prior = prior_of(series, &wide);
        prior.deviation[Constant::Friction as usize] *= 2.0;
        let posterior = posterior(series, &series.points, (&wide, &prior), by)?;
        Some(Known {
            series,
            told: told(&posterior),
            posterior,
        })
    };
    let list: Vec<&Series> = all.iter().collect();
    threads::map(&list, one).into_iter().flatten().collect()
}

/// What the points of a series tell beside the prior: Λ = C⁻¹ − Σ0⁻¹, Λ x̂ = C⁻¹ x − Σ0⁻¹ x0.
fn told(posterior: &Posterior) -> Told {
    let Posterior {
        constants,
        covariance,
        prior,
        ..
    } = posterior;
    const N: usize = Constant::ALL.len();
    let c = SMatrix::<f64, N, N>::from_fn(|i, k| covariance[i][k]);
    let mut precision = c.try_inverse().unwrap_or_else(SMatrix::zeros);
    let mut weighted = precision * SVector::<f64, N>::from_iterator(constants.iter().copied());
    for i in 0..N {
        let variance = prior.deviation[i].powi(2).max(1e-12);
        precision[(i, i)] -= 1.0 / variance;
        weighted[i] -= prior.centre[i] / variance;
        // A constant that no series has is told by none.
        if prior.deviation[i] == 0.0 {
            precision.row_mut(i).fill(0.0);
            precision.column_mut(i).fill(0.0);
            weighted[i] = 0.0;
        }
    }
    Told {
        precision,
        weighted,
    }
}

/// Another specimen of a product is made by another family, of the same rubber and braid.
fn specimen(population: &Population, wide: &Experience) -> Constants {
    Constant::ALL.map(|constant| {
        let i = constant as usize;
        match constant {
            Constant::PullFactor | Constant::Seating | Constant::Compliance | Constant::TakeUp => {
                population.families[i].hypot(population.series[i])
            }
            Constant::Modulus => SQRT_2 * population.series[i],
            _ => wide.specimen[i],
        }
    })
}

/// What some series tell of a muscle that nobody measured.
pub fn experience(known: &[&Known<'_>]) -> Experience {
    let wide = without_families();
    // One population for all; c and η have a centre for each way in which muscles are made.
    let by = |made: Belief, friction: Belief, keep: &dyn Fn(&Muscle) -> bool| {
        let beliefs = [
            wide.pull_factor,
            wide.seating,
            made,
            wide.take_up,
            Belief {
                centre: 0.0,
                deviation: GUESSED_RUBBER,
            },
            Belief {
                centre: 0.0,
                deviation: 0.8,
            },
            Belief {
                centre: 0.0,
                deviation: 0.1,
            },
            friction,
        ];
        let without = Population {
            centre: beliefs.map(|b| b.centre),
            families: beliefs.map(|b| b.deviation),
            series: wide.length,
            count: 0,
        };
        let mut families: Vec<(&str, Vec<&Told>)> = vec![];
        for one in known.iter().filter(|k| keep(&k.series.muscle)) {
            let name = one.series.family.as_str();
            match families.iter_mut().find(|f| f.0 == name) {
                Some(family) => family.1.push(&one.told),
                None => families.push((name, vec![&one.told])),
            }
        }
        let families: Vec<Vec<&Told>> = families.into_iter().map(|f| f.1).collect();
        Population::of(&families, &without)
    };
    let made = |made: EndsMade| move |m: &Muscle| m.terminals().made == Some(made);
    let all = by(wide.compliance_unknown, wide.friction, &|_| true);
    let of = |population: &Population, constant: Constant| Belief {
        centre: population.centre[constant as usize],
        deviation: population.deviation()[constant as usize],
    };
    let crimped = by(
        wide.compliance_crimped,
        wide.friction,
        &made(EndsMade::Crimped),
    );
    let clamped = by(
        wide.compliance_clamped,
        wide.friction,
        &made(EndsMade::Clamped),
    );
    let bare = by(wide.compliance_unknown, wide.friction, &|m| {
        !m.braid().in_rubber
    });
    let hoses = by(wide.compliance_unknown, wide.friction_in_rubber, &|m| {
        m.braid().in_rubber
    });
    Experience {
        pull_factor: of(&all, Constant::PullFactor),
        seating: of(&all, Constant::Seating),
        compliance_crimped: of(&crimped, Constant::Compliance),
        compliance_clamped: of(&clamped, Constant::Compliance),
        compliance_unknown: of(&all, Constant::Compliance),
        take_up: of(&all, Constant::TakeUp),
        friction: of(&bare, Constant::Friction),
        friction_in_rubber: of(&hoses, Constant::Friction),
        modulus: wide.modulus,
        specimen: specimen(&all, &wide),
        length: Constant::ALL.map(|c| match c {
            // The angle, strands and friction of a hose do not change where it is cut.
            Constant::Angle | Constant::Strands | Constant::Friction => 0.0,
            _ => all.series[c as usize],
        }),
    }
}

/// A measured point beside its prediction.
#[derive(Debug, Clone, Copy)]
pub struct Judged {
    /// Measured less median, over the largest pull of the series.
    pub off: f64,
    /// Half of the interval over it.
    pub half: f64,
}

/// The points of a series by a predictor of its muscle, or of one made from it.
fn judged(
    series: &Series,
    muscle: &Muscle,
    predictor: &Predictor,
    points: &[DataPoint],
    by: Fitter<'_>,
) -> Option<Vec<Judged>> {
    let model = (by.build)(muscle).ok()?;
    let highest_mpa = peak(series.points.iter().map(|p| p.at.pressure_mpa));
    let largest_n = predictor.at(highest_mpa, 0.0, 0.0)?.force_n;
    let w = &mut Workspace::new();
    let one = |point: &DataPoint| {
        let (p, e) = (point.at.pressure_mpa, point.at.contraction);
        let branch = point.at.direction();
        let two_sided = Options {
            two_sided: true,
            ..branch.into()
        };
        let mut model = Evaluation::new(&*model, w, two_sided);
        let force_n = model.force_n(p, e).ok()?;
        let (built, parts) = model.predicted_by(predictor, p, e, force_n)?;
        let (friction_n, half_n) = if branch.is_mean() {
            let of_mean = mckibben_core::built::UncertaintyParts {
                friction: None,
                ..parts
            };
            (built.predicted_shift_n.friction, of_mean.total())
        } else {
            (0.0, built.half_n().max(parts.total()))
        };
        let median_n = built.predicted_n - friction_n;
        // A muscle that pulls nothing is slack.
        let median_n = if point.measured == Quantity::Force {
            median_n.max(0.0)
        } else {
            median_n
        };
        Some(Judged {
            off: (point.at.force_n - median_n) / largest_n,
            half: half_n / largest_n,
        })
    };
    Some(points.iter().filter_map(one).collect())
}

/// How the muscles of a table are known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Way {
    /// By the other families alone.
    Nothing,
    /// By so many of its own points, and the other families.
    OwnPoints(usize),
}

impl Way {
    /// The ways of the table.
    pub const ALL: [Self; 4] = [
        Self::Nothing,
        Self::OwnPoints(1),
        Self::OwnPoints(3),
        Self::OwnPoints(10),
    ];

    fn name(self) -> String {
        match self {
            Self::Nothing => "no own points".to_owned(),
            Self::OwnPoints(1) => "1 own point".to_owned(),
            Self::OwnPoints(n) => format!("{n} own points"),
        }
    }
}

/// What the ± covers, by series.
pub struct Coverage {
    pub way: Way,
    pub series: Vec<(String, Vec<Judged>)>,
}

/// Points of a series that are spread over its pressures and contractions, from ε 0.03 on: `n` of
/// them.
fn spread(points: &[DataPoint], n: usize) -> Vec<usize> {
    const LEAST: f64 = 0.03;
    let highest_mpa = peak(points.iter().map(|p| p.at.pressure_mpa));
    let largest = peak(points.iter().map(|p| p.at.contraction));
    let mut order: Vec<usize> = (0..points.len())
        .filter(|&i| points[i].at.contraction >= LEAST)
        .collect();
    let place = |i: usize| {
        let at = points[i].at;
        (
            at.pressure_mpa / highest_mpa,
            at.contraction / largest,
            0.5 * at.direction().sign(),
        )
    };
    // The first in the middle, each further one farthest from those before it.
    let middle = (0.6, 0.4, 0.0);
    let apart =
        |a: (f64, f64, f64), b: (f64, f64, f64)| (a.0 - b.0).hypot(a.1 - b.1).hypot(a.2 - b.2);
    order.sort_by(|&i, &k| apart(place(i), middle).total_cmp(&apart(place(k), middle)));
    let mut out: Vec<usize> = order.iter().take(1).copied().collect();
    while out.len() < n.min(order.len()) {
        let nearest = |i: usize| {
            out.iter()
                .map(|&k| apart(place(i), place(k)))
                .fold(f64::INFINITY, f64::min)
        };
        let next = order
            .iter()
            .copied()
            .max_by(|&i, &k| nearest(i).total_cmp(&nearest(k)));
        out.extend(next);
    }
    out
}

/// Every series by the families that it does not belong to.
pub fn left_out(known: &[Known<'_>], way: Way, by: Fitter<'_>) -> Coverage {
    let one = |of: &&Known<'_>| {
        let series = of.series;
        let others: Vec<&Known<'_>> = known
            .iter()
            .filter(|k| k.series.family != series.family)
            .collect();
        let experience = experience(&others);
        let prior = prior_of(series, &experience);
        let list = match way {
            Way::Nothing => {
                let predictor = Predictor::about(&series.muscle, prior.centre, prior.covariance())?;
                judged(series, &series.muscle, &predictor, &series.points, by)?
            }
            Way::OwnPoints(n) => {
                let own = spread(&series.points, n);
                let (mut fitted, mut rest) = (vec![], vec![]);
                for (i, point) in series.points.iter().enumerate() {
                    if own.contains(&i) {
                        fitted.push(*point);
                    } else {
                        rest.push(*point);
                    }
                }
                let posterior = posterior(series, &fitted, (&experience, &prior), by)?;
                let muscle = series.muscle.with_constants(&posterior.constants).ok()?;
                let bench = written_bench(&muscle, &posterior, "fe".to_owned(), false)?;
                let muscle = muscle.with_bench(bench);
                let predictor = Predictor::of(&muscle, &experience)?;
                judged(series, &muscle, &predictor, &rest, by)?
            }
        };
        Some((series.name.clone(), list))
    };
    let list: Vec<&Known<'_>> = known.iter().collect();
    Coverage {
        way,
        series: threads::map(&list, one).into_iter().flatten().collect(),
    }
}

fn inside(list: &[Judged]) -> f64 {
    let held = list.iter().filter(|j| j.off.abs() <= j.half).count();
    held as f64 / list.len().max(1) as f64
}

impl Coverage {
    fn all(&self) -> Vec<Judged> {
        self.series
            .iter()
            .flat_map(|s| s.1.iter().copied())
            .collect()
    }

    /// Share of the points inside, mean half-width and bias over the largest pull, and the share of
    /// the worst series.
    pub fn summary(&self) -> (f64, f64, f64, f64) {
        let all = self.all();
        let n = all.len().max(1) as f64;
        let worst = self.series.iter().map(|s| inside(&s.1));
        (
            inside(&all),
            all.iter().map(|j| j.half).sum::<f64>() / n,
            // Below zero where the prediction is too strong.
            all.iter().map(|j| j.off).sum::<f64>() / n,
            worst.fold(1.0, f64::min),
        )
    }
}

/// The rows of each way: the share of the points inside, and that of the worst series.
pub(super) fn cases(sets: &[&'static MuscleCase], by: Fitter<'_>) -> Vec<VerificationRow> {
    let all = series(sets);
    let known = known(&all, by);
    Way::ALL
    .into_iter()
    .map(|way| {
        let coverage = left_out(&known, way, by);
        let (share, half, bias, worst) = coverage.summary();
        let name = format!(
            "families left out, {}: {} points of {} series within the ± ({:.1} % of the largest \
             pull, bias {:+.1} %, worst series {:.0} %)",
            way.name(),
            coverage.all().len(),
            coverage.series.len(),
            100.0 * half,
            100.0 * bias,
            100.0 * worst
        );
        let row = VerificationRow::new(name, "all measured muscles", 0.95, Some(share), 0.0);
        validated(row, Measure::Share, Some((0.95 - share).max(0.0)))
    })
    .collect()
}

impl fmt::Display for Coverage {
    /// The summary, and series by series.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (share, half, bias, worst) = self.summary();
        writeln!(
            f,
            "{}: inside {:.1} %, half-width {:.1} %, bias {:+.1} %, worst series {:.0} %",
            self.way.name(),
            100.0 * share,
            100.0 * half,
            100.0 * bias,
            100.0 * worst
        )?;
        for (name, list) in &self.series {
            let n = list.len().max(1) as f64;
            let mean = |of: fn(&Judged) -> f64| 100.0 * list.iter().map(of).sum::<f64>() / n;
            let square = list.iter().map(|j| j.off * j.off).sum::<f64>() / n;
            writeln!(
                f,
                "  {name}: {} points, inside {:.0} %, half-width {:.1} %, bias {:+.1} %, rms {:.1} %",
                list.len(),
                100.0 * inside(list),
                mean(|j| j.half),
                mean(|j| j.off),
                100.0 * square.sqrt()
            )?;
        }
        Ok(())
    }
}
