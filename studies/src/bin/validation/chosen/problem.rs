//! Residuals of the points and their derivatives by the parameters.
//!
//! With the pull F(P, ε; θ) of the model, friction included, by the measured quantity:
//!
//!   force        r = F(P, ε; θ) − F,           ∂r/∂θ = ∂F/∂θ
//!   contraction  r = g (ε(P, F; θ) − ε),       ∂r/∂θ = −g ∂F/∂θ / (∂F/∂ε)
//!   pressure     r = g (P(F, ε; θ) − P),       ∂r/∂θ = −g ∂F/∂θ / (∂F/∂P)
//!
//! g: N per unit of the measured quantity, the mean slope at the start, so that all residuals are
//! in N. ∂F/∂θ is that of the model ([`Slopes`](mckibben_core::model::Slopes)) where it has one.

use super::{ChosenFit, Parameter};
use mckibben_core::{
    analysis::{Evaluation, Options},
    model::{ForceModel, ModelError, Result, Workspace},
    muscle::{
        BraidStiffness, Friction, Muscle,
        measures::{FRICTION_COEFFICIENT, FRICTION_EXPONENT},
    },
    threads,
};

use mckibben_fit::{
    identify::{Target, with_values},
    least_squares::Residuals,
    measured::{DataPoint, Quantity, Section},
};

/// Rows of one muscle that one model answers, in an order that suits a model with a memory.
struct Chunk {
    section: Section,
    rows: Vec<usize>,
}

/// Parts of the rows of one muscle: fixed, so that answers do not depend on the number of threads.
const PARTS: usize = 4;
const LEAST: usize = 24;

/// The residuals as a function of the free parameters.
pub struct Problem<'a> {
    pub(super) request: &'a ChosenFit<'a>,
    points: &'a [DataPoint],
    chunks: Vec<Chunk>,
    /// N per unit of the measured quantity, by [`Quantity`].
    scales: [f64; 4],
    /// Whether the model knows all derivatives.
    analytic: bool,
    /// c_f of the friction that is estimated, where all points are of one branch.
    friction_share: f64,
}

/// P, ε, F, ∂F/∂ε and ∂F/∂P.
struct Local {
    pressure_mpa: f64,
    contraction: f64,
    force: f64,
    by_contraction: f64,
    by_pressure: f64,
}

fn local(m: &dyn ForceModel, w: &mut Workspace, p: f64, e: f64, options: Options) -> Result<Local> {
    let mut model = Evaluation::new(m, w, options);
    let r = model.response(p, e)?;
    Ok(Local {
        pressure_mpa: p,
        contraction: e,
        force: r.force_n,
        by_contraction: -model.stiffness_n_per_mm(&r)? * m.muscle().length_mm(),
        by_pressure: model.force_per_pressure_mm2(&r)?,
    })
}

/// The contraction or pressure at which the model has the measured pull, by Newton's method from
/// the measured one.
fn at_measured_pull(
    m: &dyn ForceModel,
    w: &mut Workspace,
    point: &DataPoint,
    options: Options,
) -> Result<Local> {
    let at = &point.at;
    let mut p = at.pressure_mpa;
    let mut e = at.contraction;
    const STEPS: usize = 30;
    for _ in 0..STEPS {
        let here = local(m, w, p, e, options)?;
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

impl<'a> Problem<'a> {
    /// A problem of points; `start`: values of the free targets.
    pub fn new(request: &'a ChosenFit<'a>, points: &'a [DataPoint], start: &[f64]) -> Self {
        let mut out = Self {
            request,
            points,
            chunks: chunks(points),
            scales: [1.0; 4],
            analytic: false,
            friction_share: friction_share(request),
        };
        out.scales = out.mean_slopes(start).unwrap_or(out.scales);
        out.analytic = out.knows_derivatives(start);
        out
    }

    /// The branch of a point, with the friction of which it is.
    fn options(&self, point: &DataPoint) -> Options {
        Options {
            direction: point.at.direction(),
            friction_share: self.friction_share,
            ..Options::default()
        }
    }

    /// N per unit of a measured quantity.
    pub fn scale(&self, quantity: Quantity) -> f64 {
        self.scales[quantity as usize]
    }

    /// The muscle at values of the free targets.
    pub fn candidate(&self, x: &[f64]) -> Option<Muscle> {
        let free = self.request.free.iter().map(|p| p.target);
        let values: Vec<_> = free.zip(x.iter().copied()).collect();
        with_values(self.request.muscle, &values).ok()
    }

    /// Residual of every point in N, or why it has none.
    pub fn rows(&self, x: &[f64]) -> Option<Vec<Result<f64>>> {
        let candidate = self.candidate(x)?;
        self.over_rows(&candidate, |m, w, i| {
            let point = &self.points[i];
            let (at, options) = (&point.at, self.options(point));
            let (p, e) = (at.pressure_mpa, at.contraction);
            let off = match point.measured {
                Quantity::Contraction => at_measured_pull(m, w, point, options)?.contraction - e,
                Quantity::Pressure => at_measured_pull(m, w, point, options)?.pressure_mpa - p,
                _ => Evaluation::new(m, w, options).force_n(p, e)? - at.force_n,
            };
            Ok(self.scale(point.measured) * off)
        })
    }

    /// A value of every row, by the model of its muscle.
    fn over_rows<T: Send>(
        &self,
        candidate: &Muscle,
        one: impl Fn(&dyn ForceModel, &mut Workspace, usize) -> Result<T> + Sync,
    ) -> Option<Vec<Result<T>>> {
        let compute = |chunk: &Chunk| -> Option<Vec<Result<T>>> {
            let muscle = chunk.section.apply(candidate).ok()?;
            let model = (self.request.build)(&muscle).ok()?;
            let mut w = Workspace::new();
            Some(
                chunk
                    .rows
                    .iter()
                    .map(|&i| one(model.as_ref(), &mut w, i))
                    .collect(),
            )
        };
        let lists = threads::map(&self.chunks, compute);
        let mut out: Vec<Option<Result<T>>> = self.points.iter().map(|_| None).collect();
        for (chunk, list) in self.chunks.iter().zip(lists) {
            for (&i, value) in chunk.rows.iter().zip(list?) {
                out[i] = Some(value);
            }
        }
        out.into_iter().collect()
    }

    fn mean_slopes(&self, start: &[f64]) -> Option<[f64; 4]> {
        if self.points.iter().all(|p| p.measured == Quantity::Force) {
            return None;
        }
        let candidate = self.candidate(start)?;
        let list = self.over_rows(&candidate, |m, w, i| {
            let at = &self.points[i].at;
            local(
                m,
                w,
                at.pressure_mpa,
                at.contraction,
                self.options(&self.points[i]),
            )
        })?;
        let mean = |quantity: Quantity, slope: &dyn Fn(&Local) -> f64| {
            let slopes: Vec<f64> = list
                .iter()
                .zip(self.points)
                .filter(|r| r.1.measured == quantity)
                .filter_map(|r| Some(slope(r.0.as_ref().ok()?).abs()))
                .collect();
            let mean = slopes.iter().sum::<f64>() / slopes.len().max(1) as f64;
            if mean > 0.0 { mean } else { 1.0 }
        };
        Some([
            1.0,
            mean(Quantity::Contraction, &|l| l.by_contraction),
            mean(Quantity::Pressure, &|l| l.by_pressure),
            1.0,
        ])
    }

    /// Whether the model has all of ∂F/∂θ.
    fn knows_derivatives(&self, start: &[f64]) -> bool {
        let Some(muscle) = &self.candidate(start) else {
            return false;
        };
        // A braid that follows from the measures of the muscle has another derivative by these.
        let follows = matches!(
            muscle.braid().stiffness,
            BraidStiffness::Paper | BraidStiffness::OfStrands
        );
        let is_geometry = |p: &Parameter| p.target.identify().is_some_and(|i| i.is_geometry);
        if follows && self.request.free.iter().any(is_geometry)
            // Friction that is estimated, or from contact, depends on every free parameter.
            || self.friction_share > 0.0
            || muscle.friction().is_some_and(|f| f.lever_mm > 0.0)
        {
            return false;
        }
        let probe = || {
            let DataPoint { at, section, .. } = self.points.first()?;
            let model = (self.request.build)(&section.apply(muscle).ok()?).ok()?;
            let (p, e) = (at.pressure_mpa, at.contraction);
            model
                .force_by(&mut Workspace::new(), p, e, &self.names(muscle))
                .ok()?
        };
        probe().is_some()
    }

    /// Names whose ∂F is needed.
    fn names(&self, muscle: &Muscle) -> Vec<String> {
        let mut names: Vec<String> = vec![];
        for free in self.request.free {
            for (name, _) in chain_rule(free.target, 1.0, muscle) {
                if !names.contains(&name) {
                    names.push(name);
                }
            }
        }
        names
    }

    /// ∂F/∂θ of one point for every free target.
    fn slopes(
        &self,
        (m, w): (&dyn ForceModel, &mut Workspace),
        point: &DataPoint,
        x: &[f64],
        names: &[String],
        here: &Local,
    ) -> Result<Vec<f64>> {
        let p = here.pressure_mpa;
        let e = here.contraction;
        let not_known = || ModelError::not_finite(&m.info().name, p, e);
        let slopes = m.force_by(w, p, e, names)?.ok_or_else(not_known)?;
        let slope = |name: &str| {
            names
                .iter()
                .zip(&slopes)
                .find(|s| s.0 == name)
                .map_or(0.0, |s| *s.1)
        };
        let muscle = m.muscle();
        let friction = muscle.friction().copied();
        let sign = point.at.direction().sign();
        let one = |(free, &v): (&Parameter, &f64)| match free.target {
            Target::Measure(m) if point.section.states(m) => 0.0,
            Target::Measure(m) if m.section() == "friction" => {
                let by_law = |f: Friction| match m {
                    m if *m == FRICTION_COEFFICIENT => sign * p.powf(f.exponent),
                    m if *m == FRICTION_EXPONENT => {
                        sign * f.coefficient * p.powf(f.exponent) * p.ln()
                    }
                    // Its contact changes with everything: differences are taken.
                    _ => 0.0,
                };
                friction.filter(|_| p > 0.0).map_or(0.0, by_law)
            }
            other => chain_rule(other, v, muscle)
                .iter()
                .map(|(n, factor)| factor * slope(n))
                .sum(),
        };
        Ok(self.request.free.iter().zip(x).map(one).collect())
    }
}

/// c_f of the friction that is estimated: that of points of one branch alone, which do not tell it.
fn friction_share(request: &ChosenFit<'_>) -> f64 {
    let one = request.points.first().and_then(|p| p.at.branch);
    let of_one = one
        .filter(|one| !one.is_mean())
        .is_some_and(|one| request.points.iter().all(|p| p.at.branch == Some(one)));
    let known = request.free.iter().any(|p| p.target.is_of_friction());
    let muscle = request.muscle;
    if of_one && !known && muscle.friction().is_none() && !muscle.is_extensile()
    {
        muscle.friction_share()
    } else {
        0.0
    }
}

/// ∂F/∂θ of a target with the value v: names of which the model knows ∂F, each with the factor of
/// it.
fn chain_rule(target: Target, v: f64, muscle: &Muscle) -> Vec<(String, f64)> {
    match target {
        Target::Modulus => muscle
            .tube()
            .rubber
            .law
            .constants()
            .into_iter()
            .filter(|c| c.constant.is_modulus())
            .map(|c| (format!("tube.material.{}", c.name), c.value / v))
            .collect(),
        Target::Stiffness => vec![("braid.stiffness".to_owned(), 1.0)],
        Target::Measure(m) if m.section() == "friction" => vec![],
        Target::Law(_) | Target::Measure(_) => vec![(target.name(muscle), 1.0)],
    }
}

impl Residuals for Problem<'_> {
    fn residuals_at(&self, x: &[f64]) -> Option<Vec<f64>> {
        self.rows(x)?.into_iter().collect::<Result<Vec<f64>>>().ok()
    }

    fn by_unknowns(&self, x: &[f64]) -> Option<Vec<Vec<f64>>> {
        if !self.analytic {
            return None;
        }
        let candidate = self.candidate(x)?;
        let names = self.names(&candidate);
        let rows = self.over_rows(&candidate, |m, w, i| {
            let point = &self.points[i];
            let scale = self.scale(point.measured);
            let (here, factor) = if let Quantity::Contraction | Quantity::Pressure = point.measured
            {
                let here = at_measured_pull(m, w, point, self.options(point))?;
                let by = match point.measured {
                    Quantity::Contraction => here.by_contraction,
                    _ => here.by_pressure,
                };
                (here, -scale / by)
            } else {
                let at = &point.at;
                let (p, e) = (at.pressure_mpa, at.contraction);
                (local(m, w, p, e, self.options(point))?, scale)
            };
            Ok(self
                .slopes((m, w), point, x, &names, &here)?
                .into_iter()
                .map(|s| factor * s)
                .collect::<Vec<f64>>())
        })?;
        let rows = rows.into_iter().collect::<Result<Vec<Vec<f64>>>>().ok()?;
        Some(
            (0..x.len())
                .map(|c| rows.iter().map(|r| r[c]).collect())
                .collect(),
        )
    }
}

/// Rows by muscle, in parts, each by contraction and falling pressure.
fn chunks(points: &[DataPoint]) -> Vec<Chunk> {
    let mut groups: Vec<Chunk> = vec![];
    for (i, point) in points.iter().enumerate() {
        match groups.iter_mut().find(|g| g.section == point.section) {
            Some(group) => group.rows.push(i),
            None => groups.push(Chunk {
                section: point.section,
                rows: vec![i],
            }),
        }
    }
    let mut out = vec![];
    for mut group in groups {
        group.rows.sort_by(|&a, &b| {
            let (a, b) = (&points[a].at, &points[b].at);
            a.contraction
                .total_cmp(&b.contraction)
                .then(b.pressure_mpa.total_cmp(&a.pressure_mpa))
        });
        let size = group.rows.len().div_ceil(PARTS).max(LEAST);
        out.extend(group.rows.chunks(size).map(|rows| Chunk {
            section: group.section,
            rows: rows.to_vec(),
        }));
    }
    out
}
