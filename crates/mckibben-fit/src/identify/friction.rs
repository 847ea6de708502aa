//! The law of the friction, by least squares beside the constants that were found.
//!
//! With the pull F(P, ε) of the model on the branch of a point, by the measured quantity:
//!
//!   force        r = F(P, ε) − F
//!   contraction  r = g (ε(P, F) − ε)
//!   pressure     r = g (P(F, ε) − P)
//!
//! g: N per unit of the measured quantity, the mean slope at the start, so that all residuals are
//! in N. Points state both branches; of rows in time order the friction has their history.

use super::{
    IdentificationRequest, Identified, Result, Target, by_section::by_section, history, with_values,
};
use crate::{
    least_squares::{Estimate, Loss, Unknown, estimate},
    measured::{DataPoint, Quantity, distinct},
};
use mckibben_core::{
    analysis::Evaluation,
    extremes::peak,
    model::{ModelError, Workspace, pivoting_n_per_mm},
    muscle::{
        Direction, Muscle,
        measures::{FRICTION_COEFFICIENT, FRICTION_EXPONENT, FRICTION_LEVER, FRICTION_PRESLIDING},
    },
};

/// A muscle with the law of its friction.
pub struct FrictionLaw {
    pub muscle: Muscle,
    pub parameters: Vec<Identified>,
    /// The points that were fitted, with what is left in N.
    pub left: Vec<(DataPoint, f64)>,
}

/// What is sought: what is named as free, else C and β where both branches were measured, and the
/// presliding length of rows in time order; nothing that is fixed.
fn targets(
    request: &IdentificationRequest<'_>,
    muscle: &Muscle,
    points: &[DataPoint],
) -> Vec<Target> {
    let has = |branch| points.iter().any(|p| p.at.branch == Some(branch));
    let mut out = if !request.free.is_empty() {
        request.free.to_vec()
    } else if request.history {
        let law = muscle.friction().is_some_and(|f| f.coefficient > 0.0);
        let level = if law {
            &FRICTION_COEFFICIENT
        } else {
            &FRICTION_LEVER
        };
        [level, &FRICTION_PRESLIDING].map(Target::Measure).to_vec()
    } else if has(Direction::Contraction) && has(Direction::Elongation) {
        let some = distinct(points.iter().map(|p| p.at.pressure_mpa)).len() > 2;
        let exponent = some.then_some(Target::Measure(&FRICTION_EXPONENT));
        let level = Target::Measure(&FRICTION_COEFFICIENT);
        [level].into_iter().chain(exponent).collect()
    } else {
        vec![]
    };
    out.retain(|t| t.is_of_friction() && request.fixed.iter().all(|f| f.0 != *t));
    out
}

/// Half the width of the hysteresis loop that the data show at 1 MPa, roughly: a start for C.
fn start_of_coefficient(points: &[DataPoint], exponent: f64) -> f64 {
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

/// P, ε, F, ∂F/∂ε and ∂F/∂P.
struct Local {
    pressure_mpa: f64,
    contraction: f64,
    force: f64,
    by_contraction: f64,
    by_pressure: f64,
}

fn local(model: &mut Evaluation<'_>, p: f64, e: f64) -> Result<Local, ModelError> {
    let r = model.response(p, e)?;
    Ok(Local {
        pressure_mpa: p,
        contraction: e,
        force: r.force_n,
        by_contraction: -model.stiffness_n_per_mm(&r)? * model.model.muscle().length_mm(),
        by_pressure: model.force_per_pressure_mm2(&r)?,
    })
}

/// The contraction or pressure at which the model has the measured pull, by Newton's method from
/// the measured one.
fn at_measured_pull(model: &mut Evaluation<'_>, point: &DataPoint) -> Result<Local, ModelError> {
    let at = &point.at;
    let mut p = at.pressure_mpa;
    let mut e = at.contraction;
    const STEPS: usize = 30;
    for _ in 0..STEPS {
        let here = local(model, p, e)?;
        let rest = here.force - at.force_n;
        // The last step is not checked: its error is the square of this.
        let done = rest.abs() <= 1e-6 * (1.0 + at.force_n.abs());
        if point.measured == Quantity::Contraction {
            // A muscle pulls less the shorter it is.
            let slope = here.by_contraction.min(-1e-6);
            e -= (rest / slope).clamp(-0.05, 0.05);
            e = e.clamp(-0.9, 0.94);
        } else {
            let slope = here.by_pressure.max(1e-6);
            let largest = 0.5 * p + 0.02;
            p = (p - (rest / slope).clamp(-largest, largest)).max(0.0);
        }
        if done {
            return Ok(Local {
                pressure_mpa: p,
                contraction: e,
                ..here
            });
        }
    }
    Err(ModelError::not_converged(p, e))
}

/// The residuals as a function of the law.
struct Problem<'a> {
    request: &'a IdentificationRequest<'a>,
    muscle: &'a Muscle,
    targets: &'a [Target],
    points: &'a [DataPoint],
    /// N per unit of the measured quantity, by [`Quantity`].
    scales: [f64; 4],
    /// Of each measured pull that of the mean of the branches in N, and G in N/mm.
    means: Vec<(f64, f64)>,
}

impl Problem<'_> {
    fn muscle_at(&self, x: &[f64]) -> Option<Muscle> {
        let values = self.targets.iter().copied().zip(x.iter().copied());
        with_values(self.muscle, &values.collect::<Vec<_>>()).ok()
    }

    /// A value of every point by the model of its muscle on its branch.
    fn of_points<T: Send>(
        &self,
        muscle: &Muscle,
        one: impl Fn(&mut Evaluation<'_>, usize) -> Result<T, ModelError> + Sync,
    ) -> Option<Vec<Result<T, ModelError>>> {
        by_section(self.points, |section, places| {
            self.request.progress.check().ok()?;
            let model = (self.request.build)(&section.apply(muscle).ok()?).ok()?;
            let w = &mut Workspace::new();
            let mut out = vec![];
            for &i in places {
                let direction = self.points[i].at.direction();
                out.push(one(&mut Evaluation::new(&*model, w, direction), i));
            }
            Some(out)
        })
    }

    /// Residual of every point in N.
    fn residuals(&self, x: &[f64]) -> Option<Vec<f64>> {
        let muscle = self.muscle_at(x)?;
        let in_order = self.request.history.then_some(self.request.points);
        let shares = in_order.and_then(|rows| history::shares(rows, self.points, &muscle));
        self.of_points(&muscle, |model, i| {
            let point = &self.points[i];
            let (p, e) = (point.at.pressure_mpa, point.at.contraction);
            let off = match point.measured {
                Quantity::Contraction => at_measured_pull(model, point)?.contraction - e,
                Quantity::Pressure => at_measured_pull(model, point)?.pressure_mpa - p,
                _ => {
                    let (mean_n, pivoting) = self.means[i];
                    let law = model.model.muscle().friction().filter(|_| p > 0.0);
                    let half = law.map_or(0.0, |law| law.half_width_n(p, pivoting));
                    let share = shares
                        .as_ref()
                        .map_or(-point.at.direction().sign(), |z| z[i]);
                    mean_n - share * half - point.at.force_n
                }
            };
            Ok(self.scales[point.measured as usize] * off)
        })?
        .into_iter()
        .map(Result::ok)
        .collect()
    }

    /// The points that the model answers with its pull without friction, and what it says there.
    fn means(&self) -> Option<(Vec<DataPoint>, Vec<(f64, f64)>)> {
        let stated = self.muscle.friction().is_some_and(|f| f.lever_mm > 0.0);
        let has_lever = stated || self.targets.contains(&Target::Measure(&FRICTION_LEVER));
        let rows = self.of_points(self.muscle, |model, i| {
            let at = &self.points[i].at;
            let (p, e) = (at.pressure_mpa, at.contraction);
            let Evaluation {
                model, workspace, ..
            } = model;
            let mean_n = model.force_n(workspace, p, e)?;
            let pivoting = if has_lever && p > 0.0 {
                pivoting_n_per_mm(*model, workspace, p, e)?
            } else {
                0.0
            };
            Ok((mean_n, pivoting))
        })?;
        let answered = self.points.iter().zip(rows);
        Some(
            answered
                .filter_map(|(p, row)| Some((*p, row.ok()?)))
                .unzip(),
        )
    }

    fn mean_slopes(&self, start: &[f64]) -> Option<[f64; 4]> {
        let at = |p: &DataPoint| (p.at.pressure_mpa, p.at.contraction);
        let of_point = |model: &mut Evaluation<'_>, i: usize| {
            let (p, e) = at(&self.points[i]);
            local(model, p, e)
        };
        let list = self.of_points(&self.muscle_at(start)?, of_point)?;
        let mean = |quantity: Quantity, slope: fn(&Local) -> f64| {
            let read = list.iter().zip(self.points);
            let slopes: Vec<f64> = read
                .filter(|r| r.1.measured == quantity)
                .filter_map(|r| Some(slope(r.0.as_ref().ok()?).abs()))
                .collect();
            let mean = slopes.iter().sum::<f64>() / slopes.len().max(1) as f64;
            if mean > 0.0 { mean } else { 1.0 }
        };
        let mut out = [1.0; 4];
        out[Quantity::Contraction as usize] = mean(Quantity::Contraction, |l| l.by_contraction);
        out[Quantity::Pressure as usize] = mean(Quantity::Pressure, |l| l.by_pressure);
        Some(out)
    }

    /// Points count by their weight, and by their error where all state it.
    fn weights(&self) -> Option<Vec<f64>> {
        let stated = self.points.iter().filter(|p| p.error.is_some()).count();
        let scale = |p: &DataPoint| self.scales[p.measured as usize];
        let one = |p: &DataPoint| p.weight / p.error.map_or(1.0, |e| (e * scale(p)).powi(2));
        let all = stated == 0 || stated == self.points.len();
        all.then(|| self.points.iter().map(one).collect())
    }

    fn unknowns(&self) -> Option<Vec<Unknown>> {
        let one = |target: &Target| {
            let identify = target.identify()?;
            let stated = target.value(self.muscle).or_else(|| match target {
                Target::Measure(m) if **m == FRICTION_COEFFICIENT => {
                    let exponent = Target::Measure(&FRICTION_EXPONENT).value(self.muscle)?;
                    Some(start_of_coefficient(self.points, exponent))
                }
                _ => identify.start(self.muscle),
            });
            let start = stated?;
            let bounds = self.request.bounds.iter().find(|b| b.0 == *target);
            let (low, high) = bounds.map_or_else(|| identify.bounds(self.muscle), |b| b.1);
            let scale = identify.limit(start);
            (start >= low && start <= high).then_some(Unknown {
                start,
                low,
                high,
                scale: if scale > 0.0 { scale } else { 1.0 },
            })
        };
        self.targets.iter().map(one).collect()
    }
}

fn parameters(problem: &Problem<'_>, unknowns: &[Unknown], found: &Estimate) -> Vec<Identified> {
    let one = |(i, target): (usize, &Target)| {
        let value = unknowns[i].at_its_bound(found.x[i]);
        let at_bound = found.at_bound[i];
        let half_width = found.half_widths[i];
        let limit = target
            .identify()
            .map_or(0.0, |identify| identify.limit(value));
        Identified {
            target: Some(*target),
            name: target.name(problem.muscle),
            start: unknowns[i].start,
            value,
            unit: target.unit(problem.muscle),
            standard_error: found.standard_errors[i],
            half_width,
            prior_standard_deviation: None,
            identifiable: !at_bound && half_width <= limit,
            at_bound,
            matters: at_bound || half_width.is_finite(),
        }
    };
    problem.targets.iter().enumerate().map(one).collect()
}

/// The law that comes closest to points that pull; `None` where they tell none: a muscle whose loop
/// is no law keeps the share.
pub fn friction_law(
    request: &IdentificationRequest<'_>,
    muscle: &Muscle,
    points: &[DataPoint],
) -> Option<FrictionLaw> {
    let targets = targets(request, muscle, points);
    if targets.is_empty() || points.len() <= targets.len() {
        return None;
    }
    let mut problem = Problem {
        request,
        muscle,
        targets: &targets,
        points,
        scales: [1.0; 4],
        means: vec![],
    };
    // Points without an answer are left out, where they are few.
    let (kept, means) = problem.means()?;
    if 5 * (points.len() - kept.len()) > points.len() {
        return None;
    }
    problem.points = &kept;
    problem.means = means;
    let unknowns = problem.unknowns()?;
    let start: Vec<f64> = unknowns.iter().map(|u| u.start).collect();
    if kept.iter().any(|p| p.measured != Quantity::Force) {
        problem.scales = problem.mean_slopes(&start).unwrap_or(problem.scales);
    }
    let residuals = |x: &[f64]| problem.residuals(x);
    let found = estimate(&residuals, &unknowns, &problem.weights()?, Loss::Squares).ok()?;
    let parameters = parameters(&problem, &unknowns, &found);
    let values: Vec<f64> = parameters.iter().map(|p| p.value).collect();
    Some(FrictionLaw {
        muscle: problem.muscle_at(&values)?,
        parameters,
        left: kept.iter().copied().zip(found.residuals).collect(),
    })
}
