//! From points and parameters to an [`Identification`].

use super::{
    Build, DataError, Identification, Identified, IdentifyError, Parameter, PointFit, Result,
    Target, TrialMuscle, advice,
    bench::bench,
    history,
    problem::Problem,
    result::{spread, spreads},
    signs,
};
use crate::{
    least_squares::{Estimate, EstimateError, Loss, Residuals, Unknown, estimate},
    measured::{DataPoint, Quantity},
};
use mckibben_core::{
    cancel::Cancelled,
    extremes::peak,
    model::ModelError,
    muscle::{
        Direction, Muscle, MuscleError,
        measures::{FRICTION_COEFFICIENT, FRICTION_EXPONENT, GRIP, SEATING, SLIP},
    },
    progress::{Progress, Silent},
    rubber::RubberLaw,
};

/// An identification that is requested.
#[derive(Clone, Copy)]
pub struct IdentificationRequest<'a> {
    /// The muscle, with a value for everything that is not free.
    pub muscle: &'a Muscle,
    pub free: &'a [Parameter],
    /// Values in place of those of the muscle.
    pub fixed: &'a [(Target, f64)],
    /// Lowest and highest values where nothing is named in `free`.
    pub bounds: &'a [(Target, (f64, f64))],
    pub points: &'a [DataPoint],
    pub build: &'a Build<'a>,
    pub progress: &'a dyn Progress,
    pub loss: Loss,
    /// Whether forces of zero and below are measurements: by default the muscle was slack there.
    pub two_sided: bool,
    /// Whether the points are in time order, so that the friction has their history; `branch` then
    /// counts in the first row of a table.
    pub history: bool,
}

impl<'a> IdentificationRequest<'a> {
    /// The usual request: nothing fixed, least squares, forces above zero, points in no order.
    pub fn new(
        muscle: &'a Muscle,
        free: &'a [Parameter],
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
            loss: Loss::Squares,
            two_sided: false,
            history: false,
        }
    }

    /// The muscle at values of the free parameters.
    pub(super) fn candidate(&self, x: &[f64]) -> Result<TrialMuscle, MuscleError> {
        let free = self.free.iter().map(|p| p.target).zip(x.iter().copied());
        let values: Vec<_> = self.fixed.iter().copied().chain(free).collect();
        TrialMuscle::new(self.muscle, &values)
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
fn unknowns(request: &IdentificationRequest<'_>) -> Result<Vec<Unknown>> {
    let muscle = request.muscle;
    let free = request.free.iter().map(|p| p.target);
    let named: Vec<Target> = free.chain(request.fixed.iter().map(|f| f.0)).collect();
    if let Some(twice) = (1..named.len()).find(|i| named[..*i].contains(&named[*i])) {
        let name = named[twice].name(muscle);
        return Err(IdentifyError::Refused(format!(
            "{name} is named twice, free or fixed: name it once"
        )));
    }
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
        let (low, high) = p.bounds.unwrap_or_else(|| p.target.natural_bounds(muscle));
        if !(start >= low && start <= high && low < high) {
            return Err(IdentifyError::Refused(format!(
                "{name}: the start {start} lies outside of the bounds {low} to {high}: write \
                 {name}=START:LOW:HIGH"
            )));
        }
        let scale = p.target.limit(muscle, start);
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

/// The weights of the points, and whether they state their errors.
fn weights(points: &[DataPoint], scale: impl Fn(Quantity) -> f64) -> Result<(Vec<f64>, bool)> {
    let stated = points.iter().filter(|p| p.error.is_some()).count();
    let without = points.iter().find(|p| p.error.is_none());
    if let Some(DataPoint { line, .. }) = without.filter(|_| stated > 0) {
        return Err(DataError::SomeErrors {
            stated,
            all: points.len(),
            line: *line,
        }
        .into());
    }
    let one = |p: &DataPoint| p.weight / p.error.map_or(1.0, |e| (e * scale(p.measured)).powi(2));
    Ok((points.iter().map(one).collect(), stated > 0))
}

/// Refuses numbers that are none.
pub(super) fn check(points: &[DataPoint]) -> Result<(), DataError> {
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

/// Identifies the free parameters of a muscle so that its model comes closest to the points.
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
    let flipped = signs::check(request.muscle, request.points, request.two_sided)?;
    match search(request, &flipped) {
        // The search cannot tell a model without an answer from a caller who has gone.
        _ if request.progress.cancelled() => Err(Cancelled.into()),
        Err(
            IdentifyError::Estimate(_)
            | IdentifyError::NoRubber { .. }
            | IdentifyError::Start { .. },
        ) if !flipped.is_empty() => Err(IdentifyError::Flipped(flipped.join("; "))),
        result => result,
    }
}

/// A minimum of the residuals, with the unknowns that are at their bounds set to these.
struct Minimum<'a> {
    unknowns: &'a [Unknown],
    estimate: &'a Estimate,
    x: &'a [f64],
}

fn search(request: &IdentificationRequest<'_>, flipped: &[String]) -> Result<Identification> {
    if request.free.is_empty() {
        let message = "nothing is free: name at least one parameter to identify";
        return Err(IdentifyError::Refused(message.into()));
    }
    let unknowns = unknowns(request)?;
    let start: Vec<f64> = unknowns.iter().map(|u| u.start).collect();
    let (counted, slack) = pulls_and_slack(request);
    let too_few = |points| too_few(points, slack.len(), unknowns.len());
    if counted.len() <= unknowns.len() {
        return Err(too_few(counted.len()));
    }
    let mut notes = advice::before(request, &counted)?;
    notes.extend_from_slice(flipped);
    let first = request.candidate(&start)?;
    (request.build)(&first.muscle).map_err(IdentifyError::Model)?;

    let history = request.history.then_some(request.points);
    let problem_of = |points| Problem::new(request, (points, history), &start);
    let no_answer = IdentifyError::Estimate(EstimateError::Start);
    // Residuals at the start, point by point.
    let rows = problem_of(&counted).rows(&start);
    let (points, first_residuals, left_out) = leave_out(&counted, rows.ok_or(no_answer.clone())?)?;
    notes.extend(left_out);
    let problem = problem_of(&points);
    let (weights, errors_stated) = weights(&points, |q| problem.scale(q))?;
    let estimate = estimate(&problem, &unknowns, &weights, request.loss).map_err(|e| match e {
        EstimateError::TooFew { points, .. } => too_few(points),
        EstimateError::NoMinimum { ref at, .. } => {
            let end = problem.candidate(at);
            end.and_then(|end| check_modulus(request, &first.muscle, &end.muscle).err())
                .unwrap_or(IdentifyError::Estimate(e))
        }
        other => IdentifyError::Estimate(other),
    })?;
    // Unknowns at a bound are set to it, where that is a muscle.
    let bounded = unknowns.iter().zip(&estimate.x);
    let on_bounds = bounded.map(|(u, x)| u.at_its_bound(*x)).collect();
    let muscle_at = |x: Vec<f64>| Some((problem.candidate(&x)?, x));
    let (candidate, x) = muscle_at(on_bounds)
        .or_else(|| muscle_at(estimate.x.clone()))
        .ok_or(no_answer)?;
    check_modulus(request, &first.muscle, &candidate.muscle)?;
    let minimum = Minimum {
        unknowns: &unknowns,
        estimate: &estimate,
        x: &x,
    };
    let fitted = fits(&problem, &points, &estimate, &weights);
    let all = spread("all", &estimate.residuals);
    let inside = estimate.at_bound.iter().filter(|b| !**b).count();
    let mut out = Identification {
        muscle: candidate.muscle.clone(),
        parameters: parameters(&problem, &minimum, &candidate.muscle),
        candidate,
        correlation: estimate.correlation.clone(),
        spreads: spreads(&fitted),
        freedom: points.len().saturating_sub(inside).max(1),
        points: fitted,
        slack,
        rms_before_n: spread("start", &first_residuals).rms_n,
        rms_n: all.rms_n,
        max_n: all.max_n,
        deviation: estimate.deviation,
        errors_stated,
        notes,
        bench: None,
    };
    out.notes
        .extend(advice::zero_of_load_cell(&out, &estimate.slopes));
    out.bench = bench(request, &out);
    out.notes.extend(advice::after(&out, request));
    Ok(out)
}

/// The points that count, and of them those at which the muscle was slack.
pub fn pulls_and_slack(request: &IdentificationRequest<'_>) -> (Vec<DataPoint>, Vec<DataPoint>) {
    let noise_n = noise_n(request.points);
    let pulls = |p: &DataPoint| {
        request.two_sided || p.measured != Quantity::Force || p.at.force_n > noise_n
    };
    let counted = request.points.iter().filter(|p| p.weight > 0.0).copied();
    counted.partition(pulls)
}

/// Fewer points than parameters.
pub fn too_few(points: usize, dropped: usize, parameters: usize) -> IdentifyError {
    IdentifyError::Data(DataError::TooFew {
        points,
        dropped,
        parameters,
    })
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

/// Each point with its residual.
fn fits(
    problem: &Problem<'_>,
    points: &[DataPoint],
    estimate: &Estimate,
    weights: &[f64],
) -> Vec<PointFit> {
    let outliers = advice::outliers(&estimate.residuals, weights);
    let one = |(i, point): (usize, &DataPoint)| PointFit {
        point: *point,
        residual: estimate.residuals[i] / problem.scale(point.measured),
        residual_n: estimate.residuals[i],
        weight: estimate.weights[i],
        outlier: outliers[i],
    };
    points.iter().enumerate().map(one).collect()
}

/// No rubber of which muscles are made is softer, in MPa.
const SOFTEST_MPA: f64 = 1e-3;
/// An end displacement above this share of the outer diameter is implausible.
const LONGEST_END: f64 = 0.3;

/// Refuses a modulus that fell towards zero.
fn check_modulus(request: &IdentificationRequest<'_>, start: &Muscle, end: &Muscle) -> Result<()> {
    let modulus = |m: &Muscle| m.tube().rubber.law.shear_modulus_mpa();
    match request.free.iter().find(|p| p.target.is_of_law()) {
        Some(p) if modulus(end) < SOFTEST_MPA.min(0.01 * modulus(start)) => {
            let name = p.target.name(request.muscle);
            Err(IdentifyError::NoRubber(format!(
                "{name} falls towards zero, to {:.1e} MPa",
                modulus(end)
            )))
        }
        _ => Ok(()),
    }
}

/// The largest displacement of an end at the points, in mm; `None` of what is no end.
fn end_displacement_mm(
    request: &IdentificationRequest<'_>,
    target: Target,
    value: f64,
    muscle: &Muscle,
) -> Option<f64> {
    match target {
        Target::Measure(m) if *m == SEATING || *m == GRIP => Some(value),
        Target::Measure(m) if *m == SLIP => {
            let ends = muscle.ends();
            let load = |p: &DataPoint| ends.load_n(p.at.pressure_mpa, p.at.force_n);
            Some(value * peak(request.points.iter().map(load)))
        }
        _ => None,
    }
}

type Kept = (Vec<DataPoint>, Vec<f64>, Option<String>);

/// Points without an answer at the start are left out, where they are few: those that remain with
/// their residuals, and a sentence on the others.
fn leave_out(points: &[DataPoint], rows: Vec<Result<f64, ModelError>>) -> Result<Kept> {
    let mut kept = vec![];
    let mut residuals = vec![];
    let mut lines = vec![];
    let mut first = None;
    for (point, row) in points.iter().zip(rows) {
        match row {
            Ok(residual) => {
                kept.push(*point);
                residuals.push(residual);
            }
            Err(error) => {
                lines.push(point.line);
                first.get_or_insert(error);
            }
        }
    }
    let all = points.len();
    let n = lines.len();
    let Some(error) = first else {
        return Ok((kept, residuals, None));
    };
    if 5 * n > all {
        let line = lines[0];
        let which = format!("{n} of {all} points at the starting values (first: line {line})");
        return Err(IdentifyError::Start(which, error));
    }
    let note = format!(
        "{n} points ({}) have no answer of the model at the start and were left out: {error}",
        advice::lines(&lines)
    );
    Ok((kept, residuals, Some(note)))
}

fn parameters(problem: &Problem<'_>, minimum: &Minimum<'_>, muscle: &Muscle) -> Vec<Identified> {
    let request = problem.request;
    let Minimum {
        unknowns,
        estimate,
        x,
    } = *minimum;
    let matters = |i: usize| {
        let mut x = estimate.x.clone();
        x[i] += 0.1 * unknowns[i].scale;
        let change = |(a, b): (&f64, &f64)| (a - b).abs() > 1e-9 * (1.0 + b.abs());
        let moves = |r: Vec<f64>| r.iter().zip(&estimate.residuals).any(change);
        estimate.standard_errors[i].is_finite() || problem.residuals_at(&x).is_none_or(moves)
    };
    let one = |i: usize| {
        let target = request.free[i].target;
        let value = x[i];
        let limit = target.limit(muscle, value);
        let displacement = end_displacement_mm(request, target, value, muscle);
        let implausible =
            displacement.is_some_and(|mm| mm > LONGEST_END * muscle.outer_diameter_mm());
        Identified {
            target: Some(target),
            name: target.name(request.muscle),
            start: unknowns[i].start,
            value,
            unit: target.unit(request.muscle),
            standard_error: estimate.standard_errors[i],
            half_width: estimate.half_widths[i],
            limit,
            prior_standard_deviation: None,
            identifiable: !estimate.at_bound[i] && !implausible && estimate.half_widths[i] <= limit,
            at_bound: estimate.at_bound[i],
            matters: matters(i),
            implausible,
        }
    };
    (0..x.len()).map(one).collect()
}
