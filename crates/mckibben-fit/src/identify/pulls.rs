//! Some parameters of a muscle by least squares of its pulls.
//!
//! With the pull F(P, ε) of the model on the branch of a point, r = F(P, ε) − F, whatever of the three
//! was measured. Points state both branches; of rows in time order the friction has their history.

use super::{
    IdentificationRequest, Identified, Target, by_section::by_section, history, with_values,
};
use crate::{
    least_squares::{Estimate, Residuals, Unknown, estimate},
    measured::DataPoint,
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

/// The residuals as a function of some parameters.
pub struct Pulls<'a> {
    /// Model, bounds and friction.
    pub request: &'a IdentificationRequest<'a>,
    /// The start.
    pub muscle: &'a Muscle,
    /// The parameters that vary.
    pub targets: &'a [Target],
    /// What was measured.
    pub points: &'a [DataPoint],
    /// Of each measured pull that of the mean of the branches in N, and G in N/mm; of the law of the
    /// friction alone, which leaves them as they are.
    pub means: Vec<WithoutFriction>,
    /// c_f of the friction that is estimated.
    pub friction_share: f64,
}

/// What was found.
#[derive(Debug)]
pub struct Found {
    /// With the values that were found.
    pub muscle: Muscle,
    /// Each with its interval.
    pub parameters: Vec<Identified>,
    /// The points that were fitted, with model less measured in N.
    pub left: Vec<(DataPoint, f64)>,
}

impl<'a> Pulls<'a> {
    /// All in N, without friction.
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
            let pull_n = match self.means.get(i) {
                None => model.force_n(p, e)?,
                Some((mean_n, pivoting)) => {
                    let law = model.model.muscle().friction().filter(|_| p > 0.0);
                    let half = law.map_or(0.0, |law| law.half_width_n(p, *pivoting));
                    let share = shares
                        .as_ref()
                        .map_or(-point.at.direction().sign(), |z| z[i]);
                    mean_n - share * half
                }
            };
            Ok(pull_n - point.at.force_n)
        })
    }

    /// What the model says of every point without friction.
    pub fn without_friction(&self) -> Option<Vec<WithoutFriction>> {
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
        rows.into_iter().map(Result::ok).collect()
    }

    /// The parameters that come closest to the points, which count by their weights.
    pub fn found(&self, unknowns: &[Unknown], weights: &[f64]) -> Option<Found> {
        let found = estimate(self, unknowns, weights).ok()?;
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
