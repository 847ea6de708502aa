//! Equilibria of one muscle, found from the nearest one known.

use super::discrete::{BraidSpec, Discrete, State};
use super::equilibrium::Control;
use super::error::FemError;
use super::path::{Guess, Halt, Walker};
use crate::solver::newton::Stopped;
use mckibben::model::{ForceModel, ThickWall, Workspace};
use std::sync::Arc;

/// Equilibria that are kept.
const KEPT: usize = 8;
/// Points that extrapolate the next one along a curve.
const TRAIL: usize = 4;
/// A state is near where its pressure differs by less than this share and its contraction by less than [`NEAR`].
const NEAR_PRESSURE: f64 = 0.6;
const NEAR: f64 = 0.08;

/// A muscle's elements, its states and their memory.
#[derive(Debug, Clone)]
pub struct Engine {
    /// The body and its way of walking.
    pub walker: Walker,
    thick_wall: Arc<ThickWall>,
    half: f64,
    kept: Vec<State>,
    oldest: usize,
    /// Last states along a curve, newest last.
    trail: Vec<State>,
    trailed: usize,
}

/// See [`Engine::budget`].
const BUDGET: usize = 50;
const BUDGET_PULLING: usize = 600;
/// Factorisations of a point of a curve that its neighbours did not foretell.
const BUDGET_CURVE: usize = 250;

/// Strands are taut at this share of the pressure at which the endless muscle begins to pull.
const TAUT: f64 = 1.3;
/// First share of the way down from there.
const LET_DOWN: f64 = 0.3;

/// Along what a curve runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Along {
    /// Pressures at one length or one pull.
    Pressure,
    /// Lengths at one pressure.
    Length,
}

impl Engine {
    /// The elements of a muscle at rest, and the endless muscle of the same make.
    pub fn new(discrete: Arc<Discrete>, thick_wall: Arc<ThickWall>) -> Self {
        let rest = State::rest(&discrete);
        let half = 0.5 * thick_wall.muscle().length_mm();
        Self {
            walker: Walker::new(discrete),
            thick_wall,
            half,
            kept: Vec::with_capacity(KEPT),
            oldest: 0,
            trail: vec![rest; TRAIL],
            trailed: 0,
        }
    }

    /// Half the length at rest in mm.
    pub fn half_length(&self) -> f64 {
        self.half
    }

    /// Keeps the present equilibrium for later questions.
    pub fn keep(&mut self) {
        let state = &self.walker.body.state;
        if self.kept.len() < KEPT {
            self.kept.push(state.clone());
        } else {
            self.kept[self.oldest].copy_from(state);
            self.oldest = (self.oldest + 1) % KEPT;
        }
    }

    /// The kept equilibrium at exactly this pressure in MPa and contraction, as a response tells them.
    pub fn kept_at(&self, pressure: f64, contraction: f64) -> Option<&State> {
        self.kept.iter().find(|s| s.pressure == pressure && 0.0 - s.terminal / self.half == contraction)
    }

    /// Whether the last tangent was that of a stable equilibrium.
    pub fn stable(&self) -> bool {
        self.walker.body.unstable_directions() == 0
    }

    /// The same, and under a held pull also that a longer muscle pulls harder.
    pub fn stable_under(&self, control: Control) -> bool {
        self.stable()
            && (!matches!(control, Control::Force(_)) || self.walker.body.terminal_stiffness() > 0.0)
    }

    /// Finds the equilibrium at a pressure in MPa and a contraction.
    ///
    /// First from the nearest one kept, then straight from rest, then the long way: pressurised at rest length to where
    /// the strands are taut, contracted, and let down.
    ///
    /// # Errors
    /// [`FemError`].
    pub fn reach(&mut self, pressure: f64, contraction: f64) -> Result<(), FemError> {
        if !(pressure.is_finite() && contraction < 0.95 && contraction > -0.95) {
            return Err(FemError::Question { pressure_mpa: pressure, contraction });
        }
        let terminal = -contraction * self.half;
        if self.near_kept(pressure, terminal) {
            self.keep();
            return Ok(());
        }
        let before = self.walker.effort.iterations;
        self.walker.allow(Some(self.budget(pressure, contraction)));
        let found = if self.leap(pressure, terminal) {
            Ok(())
        } else {
            self.long_way(pressure, terminal)
                .or_else(|halt| self.straight(pressure, terminal).map_err(|_| halt))
        };
        self.walker.allow(None);
        found.map_err(|(reason, last)| FemError::Path {
            pressure_mpa: pressure,
            contraction,
            reason,
            iterations: self.walker.effort.iterations - before,
            last,
        })?;
        self.keep();
        Ok(())
    }

    /// Factorisations a question may cost: many where there must be an answer, ten ordinary ones' where the endless
    /// muscle does not pull or its strands stretch too far.
    fn budget(&self, pressure: f64, contraction: f64) -> usize {
        let Ok(endless) = self.thick_wall.response(&mut Workspace::new(), pressure, contraction) else {
            return BUDGET;
        };
        let d = &self.walker.body.discrete;
        let strain = match (d.make.braid, endless.braid_tension_n) {
            (Some(BraidSpec { stiffness: Some(k), angle_rad, .. }), Some(tension)) => {
                tension / (4.0 * std::f64::consts::PI * d.radius * angle_rad.cos() * k)
            }
            _ => 0.0,
        };
        if endless.force_n > 0.0 && strain < 0.05 { BUDGET_PULLING } else { BUDGET }
    }

    /// One step from rest to the answer.
    fn leap(&mut self, pressure: f64, terminal: f64) -> bool {
        let slack =
            self.thick_wall.response(&mut Workspace::new(), pressure, -terminal / self.half).ok().and_then(
                |r| {
                    let radius = 0.5 * r.bulged_diameter_mm?;
                    (r.braid_tension_n? <= 0.0).then_some(Guess::Slack { radius })
                },
            );
        [slack, Some(Guess::Taut), Some(Guess::Loads)]
            .into_iter()
            .flatten()
            .any(|from| self.walker.leap(pressure, terminal, from).is_ok() && self.stable())
    }

    fn factorised(&mut self) -> Result<(), FemError> {
        let force_n = self.walker.body.totals.pull;
        self.walker.body.factorise().map(|_| ()).map_err(|reason| FemError::Force { force_n, reason })
    }

    /// dF/dw of the present equilibrium, factorised anew.
    ///
    /// # Errors
    /// [`FemError::Force`] where the tangent is singular.
    pub fn tangent_stiffness(&mut self) -> Result<f64, FemError> {
        self.factorised()?;
        Ok(self.walker.body.terminal_stiffness())
    }

    /// ∂F/∂P of the present equilibrium, factorised anew.
    ///
    /// # Errors
    /// [`FemError::Force`] where the tangent is singular.
    pub fn tangent_per_pressure(&mut self) -> Result<f64, FemError> {
        self.factorised()?;
        Ok(self.walker.body.force_per_pressure())
    }

    fn straight(&mut self, pressure: f64, terminal: f64) -> Result<(), Halt> {
        self.walker.reset();
        self.walker.walk(pressure, terminal, 1.0)
    }

    fn near_kept(&mut self, pressure: f64, terminal: f64) -> bool {
        let distance = |s: &State| {
            let p = (s.pressure - pressure).abs() / (s.pressure.abs().max(pressure.abs()) + 1e-12);
            let e = (s.terminal - terminal).abs() / self.half;
            (p, e)
        };
        let nearest = self
            .kept
            .iter()
            .map(|s| (distance(s), s))
            .filter(|((p, e), _)| *p < NEAR_PRESSURE && *e < NEAR)
            .min_by(|((p, e), _), ((q, f), _)| {
                (p / NEAR_PRESSURE + e / NEAR).total_cmp(&(q / NEAR_PRESSURE + f / NEAR))
            });
        let Some((_, state)) = nearest else { return false };
        self.walker.start_from(state);
        self.walker.body.state.pressure = pressure;
        self.walker.solve(Control::Length(terminal)).is_ok() && self.stable()
    }

    fn long_way(&mut self, pressure: f64, terminal: f64) -> Result<(), Halt> {
        let taut = self.pulling_pressure(-terminal / self.half).map_or(pressure, |p| pressure.max(TAUT * p));
        let there = taut > pressure && self.walker.leap(taut, terminal, Guess::Taut).is_ok() && self.stable();
        if !there {
            self.walker.reset();
            self.walker.walk(taut, 0.0, 1.0)?;
            self.walker.walk(taut, terminal, 1.0)?;
        }
        // Strands go slack one after the other: small steps.
        if taut > pressure { self.walker.walk(pressure, terminal, LET_DOWN) } else { Ok(()) }
    }

    /// The pressure in MPa at which the endless muscle begins to pull at a contraction.
    pub fn pulling_pressure(&self, contraction: f64) -> Option<f64> {
        let high = self.walker.body.discrete.shear;
        let push = self.thick_wall.force_n(&mut Workspace::new(), 0.0, contraction).ok()?;
        let pull = self.thick_wall.force_n(&mut Workspace::new(), high, contraction).ok()?;
        let slope = (pull - push) / high;
        (slope > 0.0).then(|| (-push / slope).max(0.0))
    }

    /// The contraction at which the endless muscle pulls with `force` N, between `low` and the ideal maximum.
    pub fn guessed_contraction(&self, force: f64, pressure: f64, highest: f64) -> Option<f64> {
        let pull = |e: f64| self.thick_wall.force_n(&mut Workspace::new(), pressure, e).ok();
        let (mut low, mut high) = (-0.05, highest);
        pull(low)?;
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            match pull(middle) {
                Some(f) if f > force => low = middle,
                _ => high = middle,
            }
        }
        Some(low)
    }

    /// Begins a curve at the present equilibrium.
    pub fn begin_trail(&mut self) {
        self.trailed = 0;
        self.trail_here();
    }

    /// Adds the present equilibrium to the curve.
    pub fn trail_here(&mut self) {
        if self.trailed == TRAIL {
            self.trail.rotate_left(1);
            self.trailed -= 1;
        }
        self.trail[self.trailed].copy_from(&self.walker.body.state);
        self.trailed += 1;
    }

    /// Pressure of the last point of the curve in MPa.
    pub fn pressure_of_trail(&self) -> f64 {
        self.trail[self.trailed.saturating_sub(1)].pressure
    }

    /// Walks on from the last point of the curve in as many steps as it takes.
    pub fn walk_on(&mut self, pressure: f64, terminal: f64) -> bool {
        if self.trailed == 0 {
            return false;
        }
        self.walker.body.state.copy_from(&self.trail[self.trailed - 1]);
        self.walker.allow(Some(BUDGET_CURVE));
        let found = self.walker.walk(pressure, terminal, 1.0).is_ok() && self.stable();
        self.walker.allow(None);
        found
    }

    /// Solves for the next point of a curve from what the last points foretell (Lagrange's polynomial through them).
    ///
    /// # Errors
    /// [`Stopped`]; the body then holds no equilibrium.
    pub fn next(&mut self, along: Along, value: f64, control: Control) -> Result<(), Stopped> {
        let place = |s: &State| if along == Along::Pressure { s.pressure } else { s.terminal };
        let n = self.trailed;
        let mut weights = [0.0; TRAIL];
        for (i, weight) in weights[..n].iter_mut().enumerate() {
            *weight = 1.0;
            for j in (0..n).filter(|&j| j != i) {
                let (xi, xj) = (place(&self.trail[i]), place(&self.trail[j]));
                if xi == xj {
                    return Err(Stopped::Diverged { correction: f64::INFINITY });
                }
                *weight *= (value - xj) / (xi - xj);
            }
        }
        let state = &mut self.walker.body.state;
        state.x.fill(0.0);
        state.q.fill(0.0);
        (state.pressure, state.terminal) = (0.0, 0.0);
        for (weight, s) in weights[..n].iter().zip(&self.trail) {
            for (x, y) in state.x.iter_mut().zip(&s.x) {
                *x += weight * y;
            }
            for (x, y) in state.q.iter_mut().zip(&s.q) {
                *x += weight * y;
            }
            state.pressure += weight * s.pressure;
            state.terminal += weight * s.terminal;
        }
        if along == Along::Pressure {
            state.pressure = value;
        }
        self.walker.solve(control)
    }
}
