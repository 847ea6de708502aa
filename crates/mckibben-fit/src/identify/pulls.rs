//! Some parameters of a muscle by least squares of its pulls.
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
    IdentificationRequest, Identified, Target, by_section::by_section, history, with_values,
};
use crate::{
    least_squares::{Estimate, Residuals, Unknown, estimate},
    measured::{DataPoint, Quantity},
};
use mckibben_core::{
    analysis::{Evaluation, Options},
    extremes::peak,
    model::{ModelError, Workspace, pivoting_n_per_mm},
    muscle::{
        Muscle,
        measures::{FRICTION_COEFFICIENT, FRICTION_EXPONENT, FRICTION_LEVER},
    },
};

/// A pull without friction in N, and how it changes with the lever of the ends in N/mm.
pub type WithoutFriction = (f64, f64);

/// Half the width of a hysteresis loop at 1 MPa, roughly: a start for C.
fn start_of_coefficient(points: &[DataPoint], exponent: f64) -> f64 {
    let p_mpa = peak(points.iter().map(|p| p.at.pressure_mpa)).max(1e-3);
    0.05 * peak(points.iter().map(|p| p.at.force_n)).max(1.0) / p_mpa.powf(exponent)
}

/// Where a search begins.
pub fn start(target: Target, muscle: &Muscle, points: &[DataPoint]) -> Option<f64> {
    target.value(muscle).or_else(|| match target {
        Target::Measure(m) if *m == FRICTION_COEFFICIENT => {
            let exponent = Target::Measure(&FRICTION_EXPONENT).value(muscle)?;
            Some(start_of_coefficient(points, exponent))
        }
        // Inside of its bounds, and small beside the muscle.
        other => other.identify()?.start(muscle),
    })
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

/// The residuals as a function of some parameters.
pub struct Pulls<'a> {
    pub request: &'a IdentificationRequest<'a>,
    pub muscle: &'a Muscle,
    pub targets: &'a [Target],
    pub points: &'a [DataPoint],
    /// N per unit of the measured quantity, by [`Quantity`].
    pub scales: [f64; 4],
    /// Of each measured pull that of the mean of the branches in N, and G in N/mm; of the law of the
    /// friction alone, which leaves them as they are.
    pub means: Vec<WithoutFriction>,
    /// c_f of the friction that is estimated.
    pub friction_share: f64,
}

/// What was found.
#[derive(Debug)]
pub struct Found {
    pub muscle: Muscle,
    pub parameters: Vec<Identified>,
    /// The points that were fitted, with model less measured in N.
    pub left: Vec<(DataPoint, f64)>,
}

impl<'a> Pulls<'a> {
    pub fn new(
        request: &'a IdentificationRequest<'a>,
        muscle: &'a Muscle,
        targets: &'a [Target],
        points: &'a [DataPoint],
    ) -> Self {
        Self {
            request,
            muscle,
            targets,
            points,
            scales: [1.0; 4],
            means: vec![],
            friction_share: 0.0,
        }
    }

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
                let options = Options {
                    direction: self.points[i].at.direction(),
                    friction_share: self.friction_share,
                    ..Options::default()
                };
                out.push(one(&mut Evaluation::new(&*model, w, options), i));
            }
            Some(out)
        })
    }

    /// Residual of every point in N, or why it has none.
    pub fn rows(&self, x: &[f64]) -> Option<Vec<Result<f64, ModelError>>> {
        let muscle = self.muscle_at(x)?;
        let in_order = self.request.history.then_some(self.request.points);
        let shares = in_order.and_then(|rows| history::shares(rows, self.points, &muscle));
        self.of_points(&muscle, |model, i| {
            let point = &self.points[i];
            let (p, e) = (point.at.pressure_mpa, point.at.contraction);
            let off = match point.measured {
                Quantity::Contraction => at_measured_pull(model, point)?.contraction - e,
                Quantity::Pressure => at_measured_pull(model, point)?.pressure_mpa - p,
                _ if self.means.is_empty() => model.force_n(p, e)? - point.at.force_n,
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
        })
    }

    /// The points that the model answers with its pull without friction, and what it says there.
    pub fn means(&self) -> Option<(Vec<DataPoint>, Vec<WithoutFriction>)> {
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

    /// N per unit of each quantity at the start.
    pub fn mean_slopes(&self, start: &[f64]) -> Option<[f64; 4]> {
        if self.points.iter().all(|p| p.measured == Quantity::Force) {
            return None;
        }
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

    /// The parameters that come closest to the points.
    pub fn found(&self, unknowns: &[Unknown]) -> Option<Found> {
        let found = estimate(self, unknowns, &self.weights()?).ok()?;
        let parameters = parameters(self, unknowns, &found);
        let values: Vec<f64> = parameters.iter().map(|p| p.value).collect();
        Some(Found {
            muscle: self.muscle_at(&values)?,
            parameters,
            left: self.points.iter().copied().zip(found.residuals).collect(),
        })
    }
}

impl Residuals for Pulls<'_> {
    fn residuals_at(&self, x: &[f64]) -> Option<Vec<f64>> {
        self.rows(x)?.into_iter().map(Result::ok).collect()
    }
}

fn parameters(problem: &Pulls<'_>, unknowns: &[Unknown], found: &Estimate) -> Vec<Identified> {
    let one = |(i, target): (usize, &Target)| {
        let value = unknowns[i].at_its_bound(found.x[i]);
        let at_bound = found.at_bound[i];
        let half_width = found.half_widths[i];
        Identified {
            target: Some(*target),
            name: target.name(problem.muscle),
            start: unknowns[i].start,
            value,
            unit: target.unit(problem.muscle),
            standard_error: found.standard_errors[i],
            half_width,
            prior_standard_deviation: None,
            identifiable: !at_bound && half_width <= target.limit(problem.muscle, value),
            at_bound,
            matters: at_bound || half_width.is_finite(),
        }
    };
    problem.targets.iter().enumerate().map(one).collect()
}
