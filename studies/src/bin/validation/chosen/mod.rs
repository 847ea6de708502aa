//! Chosen constants of a measured muscle by least squares of its pulls, without a prior.
//!
//! Any parameter of [`Target`] is free. Standard errors are those of linearised least squares
//! (Seber & Wild 2003 \[seber2003\], ch. 2). A parameter is identifiable where the half-width of its
//! 95 % interval is below its limit and it lies on no bound.

mod parameter;
mod problem;

pub use parameter::Parameter;

use mckibben_core::{
    built::{Experience, Prior},
    extremes::peak,
    muscle::{
        Constant, Direction, Muscle,
        measures::{FRICTION_COEFFICIENT, FRICTION_EXPONENT},
    },
};
use mckibben_fit::{
    identify::{
        Build, IdentificationRequest, Identified, IdentifyError, Target, doubts, left_over,
        pulls_and_slack, written_bench,
    },
    least_squares::{Estimate, EstimateError, Loss, Unknown, estimate},
    measured::DataPoint,
};
use parameter::{limit, natural_bounds};
use problem::Problem;

/// Constants of a muscle that are sought.
#[derive(Clone, Copy)]
pub struct ChosenFit<'a> {
    /// The muscle, with a value for everything that is not free.
    pub muscle: &'a Muscle,
    pub free: &'a [Parameter],
    pub points: &'a [DataPoint],
    pub build: &'a Build<'a>,
    /// Whether forces of zero and below are measurements: by default the muscle was slack there.
    pub two_sided: bool,
}

/// The muscle that was found.
#[derive(Debug)]
pub struct Chosen {
    pub muscle: Muscle,
    pub parameters: Vec<Identified>,
    /// The points that counted, each with model less measured in N.
    pub points: Vec<(DataPoint, f64)>,
    /// Root mean square of these, in N.
    pub rms_n: f64,
}

impl<'a> ChosenFit<'a> {
    /// The usual fit: forces above zero.
    pub fn new(
        muscle: &'a Muscle,
        free: &'a [Parameter],
        points: &'a [DataPoint],
        build: &'a Build<'a>,
    ) -> Self {
        Self {
            muscle,
            free,
            points,
            build,
            two_sided: false,
        }
    }

    fn request(&self) -> IdentificationRequest<'a> {
        IdentificationRequest {
            two_sided: self.two_sided,
            ..IdentificationRequest::new(self.muscle, &[], self.points, self.build)
        }
    }

    /// The constants with which the model comes closest to the points.
    ///
    /// # Errors
    /// [`IdentifyError`] for points that do not tell them.
    pub fn found(&self) -> Result<Chosen, IdentifyError> {
        doubts(self.muscle, self.points)?;
        search(self)
    }

    /// The muscle that was found, with its bench: what points tell beside its constants.
    pub fn with_bench(&self, found: &Chosen) -> Muscle {
        let prior = Prior::of(&found.muscle, Experience::built_in());
        let mut kept = [0.0; Constant::ALL.len()];
        kept[Constant::Friction as usize] = prior.centre[Constant::Friction as usize];
        let points: Vec<DataPoint> = found.points.iter().map(|p| p.0).collect();
        let left = left_over(&self.request(), &found.muscle, &points, &kept);
        let bench = left.ok().flatten().and_then(|left| {
            let model = (self.build)(&found.muscle).ok()?.info().name.to_string();
            written_bench(&found.muscle, &left, model, false)
        });
        match bench {
            Some(bench) => found.muscle.clone().with_bench(bench),
            None => found.muscle.clone(),
        }
    }
}

/// Half the width of the hysteresis loop that the data show at 1 MPa, roughly: a start for C.
fn friction_start(points: &[DataPoint], exponent: f64) -> f64 {
    let sum = |branch| {
        let list = points.iter().filter(|p| p.at.branch == Some(branch));
        let (f, n) = list.fold((0.0, 0.0), |(f, n), p| (f + p.at.force_n, n + 1.0));
        if n > 0.0 { f / n } else { 0.0 }
    };
    let p = points.iter().map(|p| p.at.pressure_mpa).sum::<f64>() / points.len().max(1) as f64;
    let forces = peak(points.iter().map(|p| p.at.force_n));
    let half = 0.5 * (sum(Direction::Elongation) - sum(Direction::Contraction));
    half.max(0.005 * forces).max(1e-3) / p.max(1e-3).powf(exponent)
}

/// Starts and bounds of the free parameters.
fn unknowns(request: &ChosenFit<'_>) -> Result<Vec<Unknown>, IdentifyError> {
    let muscle = request.muscle;
    let one = |p: &Parameter| {
        let name = p.target.name(muscle);
        let value = p.target.value(muscle).or_else(|| match p.target {
            Target::Measure(m) if *m == FRICTION_COEFFICIENT => {
                let exponent = Target::Measure(&FRICTION_EXPONENT).value(muscle)?;
                Some(friction_start(request.points, exponent))
            }
            // Inside of its bounds, and small beside the muscle.
            other => other.identify().and_then(|i| i.start(muscle)),
        });
        let start = p.start.or(value).ok_or_else(|| {
            IdentifyError::Refused(format!(
                "{name} has no value to begin with in this muscle: write {name}=START"
            ))
        })?;
        let (low, high) = p.bounds.unwrap_or_else(|| natural_bounds(p.target, muscle));
        if !(start >= low && start <= high && low < high) {
            return Err(IdentifyError::Refused(format!(
                "{name}: the start {start} lies outside of the bounds {low} to {high}: write \
                 {name}=START:LOW:HIGH"
            )));
        }
        let scale = limit(p.target, muscle, start);
        let scale = if scale > 0.0 { scale } else { 1.0 };
        // A lower end without an upper one is known to the search, the reverse is not.
        let low = if low.is_infinite() && high.is_finite() {
            start - 1e6 * scale
        } else {
            low
        };
        Ok(Unknown {
            start,
            low,
            high,
            scale,
        })
    };
    request.free.iter().map(one).collect()
}

fn search(fit: &ChosenFit<'_>) -> Result<Chosen, IdentifyError> {
    let refused = |message: String| IdentifyError::Refused(message);
    let unknowns = unknowns(fit)?;
    let start: Vec<f64> = unknowns.iter().map(|u| u.start).collect();
    let (counted, _) = pulls_and_slack(&fit.request());
    if counted.len() <= unknowns.len() {
        let (points, parameters) = (counted.len(), unknowns.len());
        return Err(refused(format!(
            "{points} points that pull do not determine {parameters} parameters"
        )));
    }
    let no_answer = IdentifyError::Estimate(EstimateError::Start);
    // Points without an answer at the start are left out, where they are few.
    let rows = Problem::new(fit, &counted, &start).rows(&start);
    let rows = rows.ok_or(no_answer.clone())?;
    let answered = counted.iter().zip(rows).filter(|row| row.1.is_ok());
    let points: Vec<DataPoint> = answered.map(|row| *row.0).collect();
    if 5 * (counted.len() - points.len()) > counted.len() {
        return Err(no_answer);
    }
    let problem = Problem::new(fit, &points, &start);
    let weight = |p: &DataPoint| {
        let error = |e: f64| (e * problem.scale(p.measured)).powi(2);
        p.weight / p.error.map_or(1.0, error)
    };
    let weights: Vec<f64> = points.iter().map(weight).collect();
    let estimate = estimate(&problem, &unknowns, &weights, Loss::Squares)
        .map_err(IdentifyError::Estimate)?;
    // Unknowns at a bound are set to it, where that is a muscle.
    let bounded = unknowns.iter().zip(&estimate.x);
    let on_bounds = bounded.map(|(u, x)| u.at_its_bound(*x)).collect();
    let muscle_at = |x: Vec<f64>| Some((problem.candidate(&x)?, x));
    let (muscle, x) = muscle_at(on_bounds)
        .or_else(|| muscle_at(estimate.x.clone()))
        .ok_or(no_answer)?;
    let squares: f64 = estimate.residuals.iter().map(|r| r * r).sum();
    Ok(Chosen {
        parameters: parameters(fit, &unknowns, &estimate, &x),
        muscle,
        rms_n: (squares / points.len() as f64).sqrt(),
        points: points.iter().copied().zip(estimate.residuals).collect(),
    })
}

fn parameters(
    fit: &ChosenFit<'_>,
    unknowns: &[Unknown],
    estimate: &Estimate,
    x: &[f64],
) -> Vec<Identified> {
    let one = |i: usize| {
        let target = fit.free[i].target;
        let half_width = estimate.half_widths[i];
        let at_bound = estimate.at_bound[i];
        Identified {
            target: Some(target),
            name: target.name(fit.muscle),
            start: unknowns[i].start,
            value: x[i],
            unit: target.unit(fit.muscle),
            standard_error: estimate.standard_errors[i],
            half_width,
            prior_standard_deviation: None,
            identifiable: !at_bound && half_width <= limit(target, fit.muscle, x[i]),
            at_bound,
            matters: at_bound || half_width.is_finite(),
        }
    };
    (0..x.len()).map(one).collect()
}
