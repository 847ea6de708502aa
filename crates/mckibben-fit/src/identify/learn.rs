//! What points tell of a muscle, beside what is known of all muscles: the default identification.
//!
//! All constants of a built muscle are free, with a prior ([`posterior`](super::posterior)); what
//! the points do not tell stays where the prior is. Where both branches were measured, the law of
//! the friction C·P^β follows by least squares of the pulls with the constants that were found.

use super::{
    Identification, Identified, Parameter, PointFit, Posterior, PosteriorRequest, Request, Result,
    Target, advice, bench, default_targets, identify,
    result::{spread, spreads},
    run::{pulls_and_slack, too_few},
    signs,
};
use crate::measured::{DataPoint, Quantity, distinct};
use mckibben_core::{
    built::{Experience, HALF_95, Prior},
    muscle::{
        Constant, Direction, Muscle,
        measures::{FRICTION_COEFFICIENT, FRICTION_EXPONENT},
    },
};

/// A constant whose deviation fell below this share of that before was learnt from the points.
const LEARNT: f64 = 0.7;

/// The constants of a muscle with the largest posterior.
///
/// # Errors
/// As [`identify`].
pub fn learn(request: &Request<'_>) -> Result<Identification> {
    let base = request.candidate(&[])?.muscle;
    let flipped = signs::check(&base, request.points, request.two_sided)?;
    let (counted, slack) = pulls_and_slack(request);
    if counted.is_empty() {
        return Err(too_few(0, slack.len(), 0));
    }
    let mut notes = advice::before(request, &counted)?;
    notes.extend(flipped);
    let experience = Experience::built_in();
    let prior = Prior::of(&base, experience);
    let ask = PosteriorRequest {
        muscle: &base,
        points: &counted,
        build: request.build,
        experience,
        prior: &prior,
        progress: request.progress,
        search: false,
    };
    let none = || {
        super::IdentifyError::Refused(
            "the model has no answer at the points with any constants near to those of the muscle"
                .to_owned(),
        )
    };
    let before = ask.posterior()?.ok_or_else(none)?;
    let found = PosteriorRequest {
        search: true,
        ..ask
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
    let start: Vec<f64> = fits(&before).iter().map(|f| f.residual_n).collect();
    let parameters: Vec<Identified> = Constant::ALL
        .into_iter()
        .filter_map(|constant| parameter(constant, &base, &muscle, &found))
        .chain(law)
        .collect();
    notes.extend(from_prior(&parameters));
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
        rms_before_n: spread("start", &start).rms_n,
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
    request: &Request<'_>,
    muscle: &Muscle,
    points: &[DataPoint],
) -> Result<Option<Identification>> {
    let has = |branch| points.iter().any(|p| p.at.branch == Some(branch));
    if !Direction::BRANCHES.into_iter().all(has) {
        return Ok(None);
    }
    let exponent = distinct(points.iter().map(|p| p.at.pressure_mpa)).len() > 2;
    let free: Vec<Parameter> = [&FRICTION_COEFFICIENT, &FRICTION_EXPONENT]
        .into_iter()
        .take(if exponent { 2 } else { 1 })
        .map(|measure| Parameter::free(Target::Measure(measure)))
        .collect();
    let law = identify(&Request {
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

/// How a constant stands in the muscle file: its name, the value without it, its unit, and what one
/// unit of the constant makes of the value; `None` where the constant is a logarithm of a factor.
type Shown = (String, f64, &'static str, Option<f64>);

fn shown(constant: Constant, base: &Muscle) -> Option<Shown> {
    let d0_mm = base.outer_diameter_mm();
    let ends = base.terminals();
    let law = &base.tube().rubber.law;
    let of = |name: &str, value: f64, unit, factor| Some((name.to_owned(), value, unit, factor));
    match constant {
        Constant::PullFactor => of("pull_factor", 1.0, "", None),
        Constant::Seating => of(
            "terminals.seating",
            ends.seating_mm.unwrap_or(0.0),
            "mm",
            Some(d0_mm),
        ),
        Constant::Compliance => of(
            "terminals.slip",
            ends.slip_mm_per_n.unwrap_or(0.0),
            "mm/N",
            Some(1.0 / d0_mm),
        ),
        Constant::TakeUp => of(
            "braid.take_up",
            base.braid().take_up_mpa.unwrap_or(0.0),
            "MPa",
            Some(1.0),
        ),
        // A law of one constant is that constant.
        Constant::Modulus => match law.constants().as_slice() {
            [one] => of(
                &format!("tube.material.{}", one.name),
                one.value,
                "MPa",
                None,
            ),
            _ => of("tube.material.modulus", 1.0, "", None),
        },
        Constant::Angle => of("braid.angle", base.braid().angle_deg, "deg", Some(1.0)),
        Constant::Strands => of(
            "braid.stiffness",
            base.family_stiffness_n_per_mm()?,
            "N/mm",
            None,
        ),
        Constant::Friction => of("friction_share", 0.0, "", Some(1.0)),
    }
}

/// A constant that was found; none that no muscle of this kind has.
fn parameter(
    constant: Constant,
    base: &Muscle,
    muscle: &Muscle,
    found: &Posterior,
) -> Option<Identified> {
    let i = constant as usize;
    let before = found.prior.deviation[i];
    let is_law = constant == Constant::Friction && muscle.friction().is_some();
    if before == 0.0 || is_law {
        return None;
    }
    let deviation = found.covariance[i][i].sqrt();
    let (name, zero, unit, factor) = shown(constant, base)?;
    let value_at = |x: f64| factor.map_or(zero * x.exp(), |factor| zero + factor * x);
    let value = value_at(found.constants[i]);
    let slope = factor.unwrap_or(value).abs();
    let at_bound = factor.is_some() && constant != Constant::Angle && value <= 0.0;
    Some(Identified {
        target: match constant {
            Constant::Modulus if base.tube().rubber.law.constants().len() == 1 => {
                Some(Target::Law(0))
            }
            Constant::Modulus => Some(Target::Modulus),
            Constant::Strands => Some(Target::Stiffness),
            _ => None,
        },
        name,
        start: value_at(found.prior.centre[i]),
        value,
        unit,
        standard_error: slope * deviation,
        half_width: HALF_95 * slope * deviation,
        limit: HALF_95 * slope * before * LEARNT,
        identifiable: deviation < LEARNT * before,
        at_bound,
        matters: true,
        implausible: false,
    })
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
fn zero_of_load_cell(request: &Request<'_>, points: &[DataPoint]) -> Option<String> {
    let targets = default_targets(request.muscle, points, false);
    let free: Vec<Parameter> = targets.into_iter().map(Parameter::free).collect();
    let found = identify(&Request {
        free: &free,
        fixed: &[],
        points,
        ..*request
    });
    let is_zero = |note: &String| note.contains("force_offset");
    found.ok()?.notes.into_iter().find(is_zero)
}

/// Which constants the points did not tell.
fn from_prior(parameters: &[Identified]) -> Option<String> {
    let kept = parameters.iter().filter(|p| !p.identifiable);
    let names: Vec<&str> = kept.map(|p| p.name.as_str()).collect();
    (!names.is_empty()).then(|| {
        format!(
            "from the measured muscles, not from these points: {}",
            names.join(", ")
        )
    })
}
