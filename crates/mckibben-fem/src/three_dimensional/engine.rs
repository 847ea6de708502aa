//! Equilibria of one muscle: from a neighbour, from the axisymmetric equilibrium, or by a walk from rest.

use super::body::Body;
use super::discrete::Discrete;
use super::guess::carry_over;
use super::mesh::{BrickMesh, BrickSpec};
use super::parts::Parts;
use super::plug::Plug;
use super::state::State;
use crate::axisymmetric::equilibrium::Control;
use crate::axisymmetric::{Axisymmetric, FemError, LastConverged};
use crate::solver::newton::{self, Effort, NewtonOptions, Stopped};
use mckibben::model::Workspace;
use mckibben::muscle::{BraidStiffness, Muscle};
use std::f64::consts::PI;
use std::sync::Arc;

/// Equilibria that are kept.
const KEPT: usize = 4;
/// A kept state serves where pressures differ by less than this share and contractions by less than `NEAR`.
const NEAR_PRESSURE: f64 = 0.15;
const NEAR: f64 = 0.01;
/// Smallest share of a leg that is tried.
const SMALLEST: f64 = 1.0 / 128.0;
/// Share of a leg that is tried first.
const FIRST: f64 = 0.25;
/// Equilibria that are not stable and are told of.
const NOTICED: usize = 16;
/// Factorisations that a walk may cost.
const BUDGET: usize = 400;
/// Strands are taut at this multiple of the pressure at which the endless muscle begins to pull.
const TAUT: f64 = 1.3;

/// A muscle's elements, its states and their memory.
#[derive(Debug)]
pub struct Engine {
    /// The body; its state is an equilibrium whenever a method has returned `Ok`.
    pub body: Body,
    /// The grid.
    pub mesh: Arc<BrickMesh>,
    /// Settings of Newton's method.
    pub newton: NewtonOptions,
    /// Cost so far.
    pub effort: Effort,
    axisymmetric: Option<Axisymmetric>,
    /// Memory of the axisymmetric model.
    guide: Workspace,
    width: f64,
    kept: Vec<State>,
    trail: Vec<(f64, State)>,
    unstable: Vec<Unstable>,
}

/// What of a muscle's elements does not change.
#[derive(Debug, Clone)]
pub struct Fixed {
    /// The grid.
    pub mesh: Arc<BrickMesh>,
    discrete: Arc<Discrete>,
    axisymmetric: Option<Axisymmetric>,
    width: f64,
}

impl Fixed {
    /// Divides a muscle.
    ///
    /// # Errors
    /// [`FemError`] where the mesh is none.
    pub fn new(muscle: &Muscle, spec: &BrickSpec) -> Result<Self, FemError> {
        let tube = muscle.tube();
        let angle = muscle.braid().angle_rad();
        // How far the plug reaches into the tube is the muscle's to say.
        let insertion = muscle.terminals().insertion_mm;
        let plug = spec.plug.map(|p| Plug { insertion_mm: p.insertion_mm.or(Some(insertion)), ..p });
        let spec = &BrickSpec { plug, ..*spec };
        let mesh = BrickMesh::new(
            tube.inner_radius_mm(),
            tube.outer_radius_mm(),
            0.5 * tube.length_mm,
            angle,
            spec,
        )?;
        Ok(Self {
            axisymmetric: axisymmetric(muscle, &mesh),
            width: PI * muscle.outer_diameter_mm() * angle.cos() / (4 * (mesh.grid()[1] - 1)) as f64,
            discrete: Arc::new(Discrete::new(Parts::of(muscle, &mesh))?),
            mesh: Arc::new(mesh),
        })
    }

    /// Pieces of strands and where they lie.
    pub fn discrete(&self) -> &Discrete {
        &self.discrete
    }
}

/// An equilibrium that is not stable and that was met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unstable {
    /// Step of the walk from rest; 0 for an answer that no walk led to.
    pub step: usize,
    /// Pressure in MPa.
    pub pressure_mpa: f64,
    /// Contraction ratio.
    pub contraction: f64,
    /// Negative eigenvalues of the tangent with the terminal held.
    pub directions: usize,
}

impl Engine {
    /// The elements of a muscle.
    ///
    /// # Errors
    /// [`FemError`] where the mesh is none or too large.
    pub fn new(muscle: &Muscle, spec: &BrickSpec) -> Result<Self, FemError> {
        Self::of(&Fixed::new(muscle, spec)?)
    }

    /// The same of what is divided already.
    ///
    /// # Errors
    /// [`FemError::TooLarge`] where there is not enough memory.
    pub fn of(fixed: &Fixed) -> Result<Self, FemError> {
        Ok(Self {
            body: Body::new(fixed.discrete.clone())?,
            mesh: fixed.mesh.clone(),
            newton: NewtonOptions { tolerance: 1e-9, iterations: 14, ..NewtonOptions::default() },
            effort: Effort::default(),
            axisymmetric: fixed.axisymmetric.clone(),
            guide: Workspace::new(),
            width: fixed.width,
            kept: vec![],
            trail: vec![],
            unstable: vec![],
        })
    }

    /// Half the length at rest in mm.
    pub fn half_length(&self) -> f64 {
        self.body.discrete.half
    }

    /// The contraction of the present state.
    pub fn contraction(&self) -> f64 {
        0.0 - self.body.state.terminal / self.half_length()
    }

    /// The axisymmetric model of the same muscle, with the mesh's length and angle, and its memory.
    pub fn axisymmetric(&mut self) -> Option<(&Axisymmetric, &mut Workspace)> {
        Some((self.axisymmetric.as_ref()?, &mut self.guide))
    }

    /// Forgets every equilibrium.
    pub fn forget(&mut self) {
        self.kept.clear();
        self.trail.clear();
        self.unstable.clear();
        self.guide = Workspace::new();
    }

    /// One Newton solve from the present iterate.
    ///
    /// # Errors
    /// [`Stopped`]; the body then holds no equilibrium.
    pub fn solve(&mut self, control: Control) -> Result<(), Stopped> {
        self.body.control = control;
        newton::solve(&mut self.body, &self.newton, &mut self.effort, |_| ())
    }

    /// Equilibria that were met and are not stable, the first ones.
    pub fn unstable(&self) -> &[Unstable] {
        &self.unstable
    }

    /// Solves with the terminal at `w` from the present iterate, as one step of a walk.
    pub(crate) fn step(&mut self, step: usize, w: f64) -> Result<(), Stopped> {
        self.solve(Control::Length(w))?;
        self.notice(step);
        Ok(())
    }

    /// Notes an equilibrium that is not stable.
    fn notice(&mut self, step: usize) {
        let directions = self.body.unstable_directions();
        if directions > 0 && self.unstable.len() < NOTICED {
            let (pressure_mpa, contraction) = (self.body.state.pressure, self.contraction());
            self.unstable.push(Unstable { step, pressure_mpa, contraction, directions });
        }
    }

    fn keep(&mut self) {
        if self.kept.len() == KEPT {
            self.kept.remove(0);
        }
        self.kept.push(self.body.state.clone());
    }

    /// Makes the kept equilibrium at exactly this pressure in MPa and contraction, as a response tells them, the present one.
    pub(super) fn back_to(&mut self, pressure: f64, contraction: f64) -> bool {
        let half = self.half_length();
        let same = |s: &&State| s.pressure == pressure && 0.0 - s.terminal / half == contraction;
        let Some(state) = self.kept.iter().find(same) else { return false };
        self.body.state.copy_from(state);
        true
    }

    /// Finds the equilibrium at a pressure in MPa and a contraction.
    ///
    /// # Errors
    /// [`FemError`].
    pub fn reach(&mut self, pressure: f64, contraction: f64) -> Result<(), FemError> {
        if !(pressure.is_finite() && contraction < 0.95 && contraction > -0.95) {
            return Err(FemError::Question { pressure_mpa: pressure, contraction });
        }
        let terminal = -contraction * self.half_length();
        if self.near_kept(pressure, terminal) || self.guessed(pressure, contraction) {
            self.notice(0);
            self.keep();
            return Ok(());
        }
        self.walk_from_rest(pressure, contraction)
    }

    /// The same without a neighbour or the axisymmetric equilibrium: from rest, step by step.
    ///
    /// # Errors
    /// [`FemError`].
    pub fn walk_from_rest(&mut self, pressure: f64, contraction: f64) -> Result<(), FemError> {
        let terminal = -contraction * self.half_length();
        let before = self.effort.iterations;
        self.long_way(pressure, terminal).map_err(|(reason, last)| FemError::Path {
            pressure_mpa: pressure,
            contraction,
            reason,
            iterations: self.effort.iterations - before,
            last,
        })?;
        self.keep();
        Ok(())
    }

    fn stable(&self) -> bool {
        self.body.unstable_directions() == 0
    }

    fn near_kept(&mut self, pressure: f64, terminal: f64) -> bool {
        let half = self.half_length();
        let distance = |s: &State| {
            let p = (s.pressure - pressure).abs() / (s.pressure.abs().max(pressure.abs()) + 1e-12);
            (p / NEAR_PRESSURE).max((s.terminal - terminal).abs() / half / NEAR)
        };
        let nearest = self.kept.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let Some(state) = nearest.filter(|s| distance(s) < 1.0) else { return false };
        self.body.state.copy_from(state);
        self.body.state.pressure = pressure;
        self.solve(Control::Length(terminal)).is_ok() && self.stable()
    }

    /// Newton's method from the axisymmetric equilibrium.
    fn guessed(&mut self, pressure: f64, contraction: f64) -> bool {
        let terminal = -contraction * self.half_length();
        let found = self.axisymmetric().map(|(m, w)| m.section_at(w, pressure, contraction));
        let Some(Ok(section)) = found else {
            return false;
        };
        let state = &mut self.body.state;
        (state.pressure, state.terminal) = (pressure, terminal);
        carry_over(&self.body.discrete, &self.mesh, &section, self.width, state);
        self.solve(Control::Length(terminal)).is_ok()
    }

    /// Pressurised at rest length to where the strands are taut, contracted, and let down.
    fn long_way(&mut self, pressure: f64, terminal: f64) -> Result<(), (Stopped, LastConverged)> {
        let pulling = self
            .axisymmetric()
            .map(|(m, w)| m.engine(w))
            .and_then(|e| e.pulling_pressure(-terminal / e.half_length()))
            .unwrap_or(0.0);
        let taut = pressure.max(TAUT * pulling);
        self.body.state = State::rest(&self.body.discrete);
        let start = self.effort.factorisations;
        let mut steps = 0;
        self.walk(taut, 0.0, start, &mut steps)?;
        self.walk(taut, terminal, start, &mut steps)?;
        if taut > pressure { self.walk(pressure, terminal, start, &mut steps) } else { Ok(()) }
    }

    /// Walks from the present equilibrium to a pressure and a displacement of the terminal; `FIRST` is the share of the
    /// way that is tried first, `steps` counts equilibria. Steps that fail are halved, steps that succeed are followed by one twice as large, and
    /// the last two states extrapolate the next.
    fn walk(
        &mut self,
        pressure: f64,
        terminal: f64,
        start: usize,
        steps: &mut usize,
    ) -> Result<(), (Stopped, LastConverged)> {
        let mut base = self.body.state.clone();
        let mut before: Option<(State, f64)> = None;
        let (p0, w0) = (base.pressure, base.terminal);
        let (mut done, mut step) = (0.0_f64, FIRST);
        loop {
            let next = (done + step).min(1.0);
            self.body.state.copy_from(&base);
            if let Some((earlier, size)) = &before {
                let ratio = (next - done) / size;
                self.body.state.add(ratio, &base);
                self.body.state.add(-ratio, earlier);
            }
            self.body.state.pressure = p0 + next * (pressure - p0);
            let w = w0 + next * (terminal - w0);
            match self.solve(Control::Length(w)) {
                Ok(()) => {
                    *steps += 1;
                    self.notice(*steps);
                    if next >= 1.0 {
                        return Ok(());
                    }
                    before = Some((base, next - done));
                    base = self.body.state.clone();
                    step = 2.0 * (next - done);
                    done = next;
                }
                Err(stop) => {
                    step = 0.5 * (next - done);
                    let factorisations = self.effort.factorisations - start;
                    let stop =
                        if factorisations > BUDGET { Stopped::Budget { factorisations } } else { stop };
                    if step < SMALLEST || matches!(stop, Stopped::Budget { .. }) {
                        self.body.state.copy_from(&base);
                        let totals = self.body.evaluate().unwrap_or_default();
                        let last = LastConverged {
                            pressure_mpa: base.pressure,
                            contraction: self.contraction(),
                            force_n: totals.pull,
                            smallest_j: totals.smallest_j,
                        };
                        return Err((stop, last));
                    }
                }
            }
        }
    }

    /// The equilibrium with a given pull in N and pressure in MPa.
    ///
    /// # Errors
    /// [`FemError`].
    pub fn reach_force(&mut self, force: f64, pressure: f64) -> Result<(), FemError> {
        let found = self.axisymmetric().map(|(m, w)| m.at_force(w, force, pressure));
        let mut contraction = match found {
            Some(Ok(s)) => s.response.contraction,
            Some(Err(e)) => return Err(e),
            None => 0.0,
        };
        let mut reason = Stopped::Iterations { iterations: 0, residual: f64::INFINITY };
        for _ in 0..8 {
            self.reach(pressure, contraction)?;
            match self.solve(Control::Force(force)) {
                Ok(()) => {
                    self.keep();
                    return Ok(());
                }
                Err(stop) => reason = stop,
            }
            self.reach(pressure, contraction)?;
            let stiffness = self.stiffness()?;
            let step = (self.body.totals.pull - force) / (stiffness * self.half_length());
            contraction += step.clamp(-0.02, 0.02);
        }
        Err(FemError::Force { force_n: force, reason })
    }

    /// dF/dw of the present equilibrium.
    fn stiffness(&mut self) -> Result<f64, FemError> {
        let force_n = self.body.totals.pull;
        self.body.factorise().map_err(|reason| FemError::Force { force_n, reason })?;
        Ok(self.body.terminal_stiffness())
    }

    /// The equilibrium with a given pull in N at a contraction; its pressure is sought.
    ///
    /// # Errors
    /// [`FemError`].
    pub fn reach_pressure(&mut self, force: f64, contraction: f64) -> Result<(), FemError> {
        let terminal = -contraction * self.half_length();
        let Some((model, guide)) = self.axisymmetric() else {
            let reason = Stopped::Diverged { correction: 0.0 };
            return Err(FemError::Force { force_n: force, reason });
        };
        let pressure = model.at_pressure_for(guide, force, contraction)?.response.pressure_mpa;
        self.reach(pressure, contraction)?;
        self.solve(Control::Pressure { terminal, force })
            .map_err(|reason| FemError::Force { force_n: force, reason })?;
        self.keep();
        Ok(())
    }

    /// Begins a curve.
    pub fn begin_trail(&mut self) {
        self.trail.clear();
    }

    /// Adds the present equilibrium to the curve, at `place`.
    pub fn trail_here(&mut self, place: f64) {
        if self.trail.len() == 3 {
            self.trail.remove(0);
        }
        self.trail.push((place, self.body.state.clone()));
    }

    /// Solves for the next point of a curve from what the last points foretell; `false` where that does not lead to an
    /// equilibrium.
    pub fn next(&mut self, place: f64, pressure: f64, control: Control) -> bool {
        if self.trail.is_empty() || self.trail.iter().any(|t| t.0 == place) {
            return false;
        }
        let state = &mut self.body.state;
        state.scale(0.0);
        for (i, (x, s)) in self.trail.iter().enumerate() {
            let others = self.trail.iter().enumerate().filter(|(j, _)| *j != i);
            let weight: f64 = others.map(|(_, (y, _))| (place - y) / (x - y)).product();
            state.add(weight, s);
        }
        state.pressure = pressure;
        self.solve(control).is_ok() && self.stable()
    }
}

/// The axisymmetric model of the same muscle, with the mesh's length and angle and the same strands.
fn axisymmetric(muscle: &Muscle, mesh: &BrickMesh) -> Option<Axisymmetric> {
    let mut tube = muscle.tube().clone();
    tube.length_mm = 2.0 * mesh.half_length_mm();
    let mut braid = muscle.braid().clone();
    if let Some(k) = muscle.family_stiffness_n_per_mm() {
        // Strands of the mesh lie closer together where they are steeper.
        let ratio = braid.angle_rad().cos() / mesh.angle_rad().cos();
        braid.stiffness = BraidStiffness::NewtonPerMm(k * ratio);
    }
    braid.angle_deg = mesh.angle_rad().to_degrees();
    braid.measured = None;
    let muscle = muscle.with_tube(tube).ok()?.with_braid(braid).ok()?;
    Axisymmetric::new(&muscle).ok()
}
