//! What points tell of a muscle, beside what is known of all muscles.
//!
//! All constants of a built muscle are free, or those that are named, with a prior
//! ([`posterior`](super::posterior)); what the points do not tell stays where the prior is. Where
//! both branches were measured, the law of the friction C·P^β follows by least squares of the pulls
//! with the constants that were found ([`friction`](super::friction)).

use super::{
    Build, DataError, Identification, Identified, IdentifyError, ParameterError, PointFit,
    Posterior, PosteriorRequest, Result, Target, advice, bench,
    friction::friction_law,
    history,
    parameter::unknown,
    posterior::{Zero, without_zero},
    pulls::Found,
    result::{spread, spreads},
    shown::Shown,
    signs,
    values::with_values,
};
use crate::measured::{DataPoint, Quantity};
use mckibben_core::{
    built::{Experience, Prior},
    extremes::peak,
    joined,
    muscle::{Constant, Muscle},
    progress::{Progress, Silent},
};

/// An identification that is requested.
#[derive(Clone, Copy)]
pub struct IdentificationRequest<'a> {
    /// The muscle, with a value for everything that is not free.
    pub muscle: &'a Muscle,
    /// The constants that are sought, the others being known; all where nothing is named.
    pub free: &'a [Target],
    /// Values in place of those of the muscle.
    pub fixed: &'a [(Target, f64)],
    /// Lowest and highest values.
    pub bounds: &'a [(Target, (f64, f64))],
    /// What was measured.
    pub points: &'a [DataPoint],
    /// Makes the model of a muscle.
    pub build: &'a Build<'a>,
    /// Hears how far it is, and may end it.
    pub progress: &'a dyn Progress,
    /// Whether forces of zero and below are measurements: by default the muscle was slack there.
    pub two_sided: bool,
    /// Whether the points are in time order, so that the friction has their history; `branch` then
    /// counts in the first row of a table.
    pub history: bool,
}

impl<'a> IdentificationRequest<'a> {
    /// The usual request: nothing fixed, forces above zero, points in no order.
    pub fn new(
        muscle: &'a Muscle,
        free: &'a [Target],
        points: &'a [DataPoint],
        build: &'a Build<'a>,
    ) -> Self {
        Self {
            muscle,
            free,
            fixed: &[],
            bounds: &[],
            points,
            build,
            progress: &Silent,
            two_sided: false,
            history: false,
        }
    }
}

/// Refuses numbers that are none.
fn check(points: &[DataPoint]) -> Result<(), DataError> {
    let wrong = points
        .iter()
        .find_map(|p| p.impossible().map(|found| (p.line, found)));
    wrong.map_or(Ok(()), |(line, (quantity, value))| {
        Err(DataError::Impossible {
            line,
            quantity,
            value,
        })
    })
}

/// The constants of a muscle with the largest posterior.
///
/// # Errors
/// [`IdentifyError`] for points that are too few, or that no such muscle gives, and for names that
/// are no constants of it.
pub fn identify(request: &IdentificationRequest<'_>) -> Result<Identification> {
    check(request.points)?;
    let directed;
    let points = if request.history {
        directed = history::directed(request.points)?;
        &directed
    } else {
        request.points
    };
    let request = &IdentificationRequest { points, ..*request };
    let base = with_values(request.muscle, request.fixed)?;
    check_names(request, &base)?;
    let flipped = signs::check(&base, request.points, request.two_sided)?;
    let (counted, slack) = pulls_and_slack(request);
    if counted.is_empty() {
        return Err(DataError::NoPull { slack: slack.len() }.into());
    }
    let mut notes = advice::before(request, &counted)?;
    notes.extend(flipped);
    let experience = Experience::built_in();
    let prior = prior(request, &base, experience);
    let bounds = bounds(request, &base);
    let sought = PosteriorRequest {
        muscle: &base,
        points: &counted,
        build: request.build,
        experience,
        prior: &prior,
        progress: request.progress,
        bounds: &bounds,
        search: true,
        zero: request.free.contains(&Target::ForceOffset),
    };
    let found = sought.posterior()?.ok_or_else(|| {
        let none = "the model has no answer at the points with any constants near to those of the \
            muscle";
        IdentifyError::Refused(none.to_owned())
    })?;
    let zero_n = found.zero.as_ref().map_or(0.0, |zero| zero.value_n);
    let pulls = counted.iter().map(|point| without_zero(*point, zero_n));
    let pulls: Vec<DataPoint> = pulls.collect();
    let mut identified = identified(request, &base, &pulls, &found)?;
    identified.slack = slack;
    if found.zero.is_none() {
        notes.extend(advice::zero_of_load_cell(&sought));
    }
    notes.extend(advice::after(&identified, request));
    identified.notes = notes;
    Ok(identified)
}

/// The muscle with the constants that were found, and with the law of its friction.
fn identified(
    request: &IdentificationRequest<'_>,
    base: &Muscle,
    counted: &[DataPoint],
    found: &Posterior,
) -> Result<Identification> {
    let muscle = base.with_constants(&found.constants)?;
    let law = friction_law(request, &muscle, found).unwrap_or_else(|| Found {
        muscle,
        parameters: vec![],
        left: vec![],
    });
    let muscle = law.muscle;
    let mut left = bench::left_over(request, &muscle, counted, &found.constants)?
        .unwrap_or_else(|| found.clone());
    // Of rows in time order the friction has a history, which the bench does not know.
    let points = if request.history && !law.left.is_empty() {
        fits(law.left)
    } else {
        let off = left.points.iter().map(|(point, off_n, _)| (*point, -off_n));
        fits(off.collect())
    };
    // Constants that are held are not known better for it.
    if request.free.is_empty() {
        left.covariance.clone_from(&found.covariance);
        left.variance_factor = found.variance_factor;
    }
    let model = (request.build)(&muscle)
        .map_err(IdentifyError::Model)?
        .info()
        .name
        .to_string();
    let residuals: Vec<f64> = points.iter().map(|f| f.residual_n).collect();
    let all = spread("all", &residuals);
    let parameters: Vec<Identified> = Shown::all(base)
        .filter_map(|shown| shown.identified(base, &muscle, found))
        .chain(law.parameters)
        .chain(found.zero.as_ref().map(Zero::identified))
        .collect();
    Ok(Identification {
        bench: bench::written(&muscle, &left, model, request.history).map(|written| {
            bench::shifted(written, request.muscle, &found.constants).sealed(&muscle)
        }),
        correlation: correlation(&parameters, found),
        spreads: spreads(&points),
        freedom: points.len(),
        rms_before_n: found.rms_before_n,
        rms_n: all.rms_n,
        max_n: all.max_n,
        deviation: all.rms_n,
        mismatch: advice::mismatch(found, base),
        notes: vec![],
        slack: vec![],
        muscle,
        parameters,
        points,
    })
}

/// The points that count, without volumes, and of them those at which the muscle was slack.
pub fn pulls_and_slack(request: &IdentificationRequest<'_>) -> (Vec<DataPoint>, Vec<DataPoint>) {
    let noise_n = noise_n(request.points);
    let pulls = |p: &DataPoint| {
        request.two_sided || p.measured != Quantity::Force || p.at.force_n > noise_n
    };
    let counts = |p: &&DataPoint| p.weight > 0.0 && p.measured != Quantity::Volume;
    let counted = request.points.iter().filter(counts).copied();
    counted.partition(pulls)
}

/// Up to which reading in N a load cell may show no pull: three times what it shows below zero, of
/// two readings at least, which a muscle that lies slack does not pull.
fn noise_n(points: &[DataPoint]) -> f64 {
    const DEVIATIONS: f64 = 3.0;
    /// More than this share of the largest pull is a zero that is off, or a flipped sign.
    const MOST: f64 = 0.05;
    let forces: Vec<f64> = points
        .iter()
        .filter(|p| p.measured == Quantity::Force && p.weight > 0.0)
        .map(|p| p.at.force_n)
        .collect();
    let below: Vec<f64> = forces.iter().copied().filter(|f| *f < 0.0).collect();
    if below.len() < 2 {
        return 0.0;
    }
    let squares: f64 = below.iter().map(|f| f * f).sum();
    let deviation_n = (squares / below.len() as f64).sqrt();
    (DEVIATIONS * deviation_n).min(MOST * peak(forces))
}

/// Each point with what is left in N, model less measured.
fn fits(left: Vec<(DataPoint, f64)>) -> Vec<PointFit> {
    let (points, off): (Vec<DataPoint>, Vec<f64>) = left.into_iter().unzip();
    let weights: Vec<f64> = points.iter().map(|p| p.weight).collect();
    let outliers = advice::outliers(&off, &weights);
    let one = |(i, point): (usize, DataPoint)| PointFit {
        point: DataPoint {
            measured: Quantity::Force,
            ..point
        },
        residual_n: off[i],
        outlier: outliers[i],
    };
    points.into_iter().enumerate().map(one).collect()
}

/// Refuses names that are no constants which are sought, and those that are named twice.
fn check_names(request: &IdentificationRequest<'_>, base: &Muscle) -> Result<()> {
    let refuse = |target: Target, what: &str| {
        let name = target.name(base);
        Err(IdentifyError::Refused(format!("{name} {what}")))
    };
    for (i, &target) in request.free.iter().enumerate() {
        let fixed = request.fixed.iter().map(|f| f.0);
        if request.free[..i]
            .iter()
            .copied()
            .chain(fixed)
            .any(|other| other == target)
        {
            return refuse(target, "is named twice, free or fixed: name it once");
        }
        let is_beside = target.is_of_friction() || target == Target::ForceOffset;
        if !is_beside && !Shown::all(base).any(|shown| shown.is(target, base)) {
            let known = joined(can_be_free(base).map(|target| target.name(base)), ", ");
            return refuse(
                target,
                &format!(
                    "is stated, not identified: measure it and give its value (`fix`). Free can \
                     be {known}"
                ),
            );
        }
    }
    let others = request.fixed.iter().map(|f| f.0);
    let others = others.chain(request.bounds.iter().map(|b| b.0));
    if others.into_iter().any(|other| other == Target::ForceOffset) {
        let what = "is of the load cell, not of the muscle: free it without bounds, or subtract \
            what is known of it from the pulls";
        return refuse(Target::ForceOffset, what);
    }
    let is_free = |target: &Target| {
        let of_points = Shown::all(base).any(|shown| shown.target == Some(*target));
        of_points && request.free.is_empty() || request.free.contains(target)
    };
    match request.bounds.iter().find(|b| !is_free(&b.0)) {
        Some(b) => refuse(b.0, "has bounds and is not free: name it in `free` too"),
        None => Ok(()),
    }
}

/// What points may tell of a muscle.
fn can_be_free(base: &Muscle) -> impl Iterator<Item = Target> {
    let constants = Shown::all(base).filter_map(|shown| shown.target);
    let beside = |t: &Target| t.is_of_friction() || *t == Target::ForceOffset;
    constants.chain(Target::all(base).into_iter().filter(beside))
}

/// The parameter of a name that is free.
///
/// # Errors
/// A word that names none; those that can be free are named.
pub fn free_target(text: &str, base: &Muscle) -> Result<Target, ParameterError> {
    Target::parse(text, base).map_err(|_| unknown(text.trim(), can_be_free(base), base))
}

/// The bounds of constants by those of parameters.
fn bounds(request: &IdentificationRequest<'_>, base: &Muscle) -> Vec<(Constant, (f64, f64))> {
    let one = |&(target, (low, high)): &(Target, (f64, f64))| {
        let shown = Shown::all(base).find(|shown| shown.is(target, base))?;
        let of = |value| shown.constant_of(target, value, base);
        Some((shown.constant, (of(low), of(high))))
    };
    request.bounds.iter().filter_map(one).collect()
}

/// What is known before: a constant that is fixed, or not among those that are free, is known. The
/// share of the friction is then that of measured muscles.
fn prior(request: &IdentificationRequest<'_>, base: &Muscle, experience: &Experience) -> Prior {
    let mut prior = Prior::of(base, experience);
    for shown in Shown::all(base) {
        let is_fixed = |(target, _): &(Target, f64)| {
            Some(*target) == shown.target
                || target.is_of_law() && shown.constant == Constant::Modulus
        };
        let is_free = request.free.is_empty() || request.free.iter().any(|t| shown.is(*t, base));
        if !is_free || request.fixed.iter().any(is_fixed) {
            let i = shown.constant as usize;
            prior.deviation[i] = 0.0;
            if shown.constant != Constant::Friction {
                prior.centre[i] = 0.0;
            }
        }
    }
    prior
}

/// The correlation of the constants that are listed; those of the law of the friction have none.
fn correlation(parameters: &[Identified], found: &Posterior) -> Vec<Vec<f64>> {
    let listed: Vec<usize> = (0..Constant::ALL.len())
        .filter(|&i| found.prior.deviation[i] > 0.0)
        .collect();
    let of = |i: usize, k: usize| match (listed.get(i), listed.get(k)) {
        _ if i == k => 1.0,
        (Some(&a), Some(&b)) => {
            let c = &found.covariance;
            c[a][b] / (c[a][a] * c[b][b]).sqrt()
        }
        _ => 0.0,
    };
    let n = parameters.len();
    (0..n).map(|i| (0..n).map(|k| of(i, k)).collect()).collect()
}
