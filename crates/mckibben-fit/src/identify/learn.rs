//! What points tell of a muscle, beside what is known of all muscles: the default identification.
//!
//! All constants of a built muscle are free, with a prior ([`posterior`](super::posterior)); what
//! the points do not tell stays where the prior is. Where both branches were measured, the law of
//! the friction C·P^β follows by least squares of the pulls with the constants that were found.

use super::{
    Identification, IdentificationRequest, Identified, Parameter, PointFit, Posterior,
    PosteriorRequest, Result, Target, advice, bench,
    default_parameters::{default_parameters, default_targets, not_free},
    identify,
    result::{spread, spreads},
    run::{pulls_and_slack, too_few},
    signs,
};
use crate::measured::{DataPoint, Quantity};
use mckibben_core::{
    built::{Experience, HALF_95, Prior},
    muscle::{
        Constant, Muscle,
        measures::{ANGLE, SEATING, SLIP, TAKE_UP},
    },
};

/// A constant whose deviation fell below this share of that before was learnt from the points.
const LEARNT: f64 = 0.7;

/// The constants of a muscle with the largest posterior.
///
/// # Errors
/// As [`identify`].
pub fn learn(request: &IdentificationRequest<'_>) -> Result<Identification> {
    let base = request.candidate(&[])?.muscle;
    let flipped = signs::check(&base, request.points, request.two_sided)?;
    let (counted, slack) = pulls_and_slack(request);
    if counted.is_empty() {
        return Err(too_few(0, slack.len(), 0));
    }
    let mut notes = advice::before(request, &counted)?;
    notes.extend(flipped);
    let experience = Experience::built_in();
    let prior = prior(request, &base, experience);
    let bounds = bounds(request, &base)?;
    let found = PosteriorRequest {
        muscle: &base,
        points: &counted,
        build: request.build,
        experience,
        prior: &prior,
        progress: request.progress,
        bounds: &bounds,
        search: true,
    };
    let none = || {
        super::IdentifyError::Refused(
            "the model has no answer at the points with any constants near to those of the muscle"
                .to_owned(),
        )
    };
    let found = found.posterior()?.ok_or_else(none)?;
    let muscle = base.with_constants(&found.constants)?;
    let friction = friction_law(request, &muscle, &counted)?;
    let (muscle, law) = match friction {
        Some(law) => (law.muscle, law.parameters),
        None => (muscle, vec![]),
    };
    let of = counted.iter().copied();
    let left = bench::left_over(request, &muscle, of, Some(&found.constants))?.ok_or_else(none)?;
    let written = Posterior {
        covariance: found.covariance.clone(),
        ..left.clone()
    };
    let model = (request.build)(&muscle)
        .map_err(super::IdentifyError::Model)?
        .info()
        .name
        .to_string();
    let points = fits(&left);
    let residuals: Vec<f64> = points.iter().map(|f| f.residual_n).collect();
    let all = spread("all", &residuals);
    let parameters: Vec<Identified> = Shown::all(&base)
        .filter_map(|shown| shown.identified(&base, &muscle, &found))
        .chain(law)
        .collect();
    notes.extend(zero_of_load_cell(request, &counted));
    notes.extend(advice::pattern(&points));
    let mut candidate = request.candidate(&[])?;
    candidate.muscle = muscle.clone();
    Ok(Identification {
        bench: bench::written(&muscle, &written, model, request.history),
        candidate,
        correlation: correlation(&parameters, &found),
        spreads: spreads(&points),
        freedom: points.len(),
        rms_before_n: found.rms_before_n,
        rms_n: all.rms_n,
        max_n: all.max_n,
        deviation: all.rms_n,
        errors_stated: false,
        notes,
        muscle,
        parameters,
        points,
        slack,
    })
}

/// C·P^β by least squares, where both branches were measured.
fn friction_law(
    request: &IdentificationRequest<'_>,
    muscle: &Muscle,
    points: &[DataPoint],
) -> Result<Option<Identification>> {
    let mut targets = default_targets(muscle, points, false);
    targets.retain(|target| target.is_of_friction());
    if targets.is_empty() {
        return Ok(None);
    }
    let free: Vec<Parameter> = targets.into_iter().map(Parameter::free).collect();
    let law = identify(&IdentificationRequest {
        muscle,
        free: &free,
        fixed: &[],
        points,
        ..*request
    });
    // A muscle whose loop is no law keeps the share.
    Ok(law.ok())
}

/// Each point with what is left, model less measured.
fn fits(posterior: &Posterior) -> Vec<PointFit> {
    let off: Vec<f64> = posterior
        .points
        .iter()
        .map(|(point, predicted_n)| predicted_n - point.at.force_n)
        .collect();
    let weights: Vec<f64> = posterior.points.iter().map(|p| p.0.weight).collect();
    let outliers = advice::outliers(&off, &weights);
    let one = |(i, (point, _)): (usize, &(DataPoint, f64))| PointFit {
        point: DataPoint {
            measured: Quantity::Force,
            ..*point
        },
        residual: off[i],
        residual_n: off[i],
        weight: weights[i],
        outlier: outliers[i],
    };
    posterior.points.iter().enumerate().map(one).collect()
}

/// How a constant stands in the muscle file.
struct Shown {
    constant: Constant,
    /// The parameter of that name; the factor on the pull and the share of friction have none.
    target: Option<Target>,
    /// The value without the constant.
    zero: f64,
    /// What one unit of the constant makes of the value; `None` where it is the logarithm of a factor.
    factor: Option<f64>,
}

impl Shown {
    /// `None` where a muscle has no such constant.
    fn new(constant: Constant, base: &Muscle) -> Option<Self> {
        let d0_mm = base.outer_diameter_mm();
        let (target, factor) = match constant {
            Constant::PullFactor => (None, None),
            Constant::Seating => (Some(Target::Measure(&SEATING)), Some(d0_mm)),
            Constant::Compliance => (Some(Target::Measure(&SLIP)), Some(1.0 / d0_mm)),
            Constant::TakeUp => (Some(Target::Measure(&TAKE_UP)), Some(1.0)),
            // A law of one constant is that constant.
            Constant::Modulus => match base.tube().rubber.law.values().len() {
                1 => (Some(Target::Law(0)), None),
                _ => (Some(Target::Modulus), None),
            },
            Constant::Angle => (Some(Target::Measure(&ANGLE)), Some(1.0)),
            Constant::Strands => {
                base.family_stiffness_n_per_mm()?;
                (Some(Target::Stiffness), None)
            }
            Constant::Friction => (None, Some(1.0)),
        };
        let value = target.and_then(|target| target.value(base));
        Some(Self {
            constant,
            target,
            zero: value.unwrap_or(if factor.is_some() { 0.0 } else { 1.0 }),
            factor,
        })
    }

    fn all(base: &Muscle) -> impl Iterator<Item = Self> {
        Constant::ALL
            .into_iter()
            .filter_map(|constant| Self::new(constant, base))
    }

    fn name(&self, base: &Muscle) -> String {
        match self.target {
            Some(target) => target.name(base),
            None if self.constant == Constant::Friction => "friction_share".to_owned(),
            None => self.constant.word().to_owned(),
        }
    }

    fn value_of(&self, x: f64) -> f64 {
        match self.factor {
            Some(factor) => self.zero + factor * x,
            None => self.zero * x.exp(),
        }
    }

    fn constant_of(&self, value: f64) -> f64 {
        match self.factor {
            Some(factor) => (value - self.zero) / factor,
            None => (value / self.zero).ln(),
        }
    }

    /// The constant as it was found; none that is known.
    fn identified(&self, base: &Muscle, muscle: &Muscle, found: &Posterior) -> Option<Identified> {
        let i = self.constant as usize;
        let before = found.prior.deviation[i];
        let is_law = self.constant == Constant::Friction && muscle.friction().is_some();
        if before == 0.0 || is_law {
            return None;
        }
        let deviation = found.covariance[i][i].sqrt();
        let value = self.value_of(found.constants[i]);
        let slope = self.factor.unwrap_or(value).abs();
        Some(Identified {
            target: self.target,
            name: self.name(base),
            start: self.value_of(found.prior.centre[i]),
            value,
            unit: self.target.map_or("", |target| target.unit(base)),
            standard_error: slope * deviation,
            half_width: HALF_95 * slope * deviation,
            limit: HALF_95 * slope * before * LEARNT,
            prior_standard_deviation: Some(slope * before),
            identifiable: deviation < LEARNT * before,
            at_bound: found.at_bound[i],
            matters: true,
            implausible: false,
        })
    }
}

/// The bounds of constants by those of parameters.
fn bounds(
    request: &IdentificationRequest<'_>,
    base: &Muscle,
) -> Result<Vec<(Constant, (f64, f64))>> {
    let one = |&(target, (low, high)): &(Target, (f64, f64))| {
        let shown = Shown::all(base).find(|shown| shown.target == Some(target));
        let shown = shown.ok_or_else(|| not_free(target, base))?;
        Ok((
            shown.constant,
            (shown.constant_of(low), shown.constant_of(high)),
        ))
    };
    request.bounds.iter().map(one).collect()
}

/// What is known before: a constant that is fixed is known.
fn prior(request: &IdentificationRequest<'_>, base: &Muscle, experience: &Experience) -> Prior {
    let mut prior = Prior::of(base, experience);
    for shown in Shown::all(base) {
        let is_it = |(target, _): &(Target, f64)| {
            Some(*target) == shown.target
                || target.is_of_law() && shown.constant == Constant::Modulus
        };
        if request.fixed.iter().any(is_it) {
            prior.centre[shown.constant as usize] = 0.0;
            prior.deviation[shown.constant as usize] = 0.0;
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

/// A zero of the load cell, which shows in least squares: a prior has room for it.
fn zero_of_load_cell(request: &IdentificationRequest<'_>, points: &[DataPoint]) -> Option<String> {
    // Bounds of constants that least squares do not seek are no matter here.
    let request = IdentificationRequest {
        points,
        bounds: &[],
        ..*request
    };
    let free = default_parameters(&request).ok()?;
    let found = identify(&IdentificationRequest {
        free: &free,
        ..request
    });
    let is_zero = |note: &String| note.contains("force_offset");
    found.ok()?.notes.into_iter().find(is_zero)
}
