//! Equilibrium of a body at given pressure and length, at given pressure and pull, or at given
//! length and pull.
//!
//! All unknowns but those of the last station are condensed along the chain; what remains is the
//! terminal's displacement w with
//!
//!   F(w + dw) = S dw − b,
//!
//! S = dF/dw from the factorised tangent, b the condensed right-hand side. Length control
//! prescribes dw, so the end moves together with everything behind it; force control takes dw =
//! (F + b)/S from it; pressure control the same with the condensed ∂V/∂x.

use super::{
    assembly::{Assembled, assemble},
    discretisation::{Discretisation, Ends},
    neighbour::Neighbours,
};
use crate::{
    FemError, Result,
    element::{
        q2::{MODES, NODES},
        strand::STRAND_POINTS,
    },
    solver::{
        body::{Control, State, Totals},
        dense,
        newton::{NewtonSystem, Stopped},
    },
};
use mckibben_core::{extremes::peak, model::ThickWall, muscle::Crimp};
use std::mem::take;
use std::sync::Arc;

/// The last station after everything else was condensed.
#[derive(Debug, Clone)]
pub struct EndSystem {
    /// Number of the unknowns of the last station that are free.
    pub free: usize,
    /// Unknowns of the last station that are not held, with their places here: those that follow the
    /// terminal are the last one.
    places: Vec<(usize, usize)>,
    /// Factorised (free, w).
    pub matrix: Vec<f64>,
    y: Vec<f64>,
}

impl EndSystem {
    fn new(d: &Discretisation) -> Self {
        let ends = d.problem.ends;
        let nodes = d.layout.nodes();
        let free = if ends == Ends::Bonded { 0 } else { nodes };
        let place = |i: usize| match (ends, i % 2) {
            (Ends::Sliding, 0) | (Ends::Pole, 1) => Some((i, i / 2)),
            (Ends::Bonded | Ends::Sliding, 1) => Some((i, free)),
            _ => None,
        };
        Self {
            free,
            places: (0..2 * nodes).filter_map(place).collect(),
            matrix: vec![0.0; (free + 1).pow(2)],
            y: vec![0.0; free + 1],
        }
    }

    /// Condenses the Schur complement of the last station; gives the number of negative pivots.
    fn factorise(&mut self, end: &[f64], m: usize) -> Result<usize, usize> {
        let size = self.y.len();
        self.matrix.fill(0.0);
        for &(p, i) in &self.places {
            for &(q, j) in &self.places {
                self.matrix[i * size + j] += end[p.min(q) * m + p.max(q)];
            }
        }
        dense::eliminate(&mut self.matrix, size, self.free)
    }

    /// S = dF/dw.
    pub fn stiffness(&self) -> f64 {
        self.matrix[self.matrix.len() - 1]
    }

    /// The condensed right-hand side b of the terminal; keeps the rest for [`Self::backward`].
    fn forward(&mut self, end: &[f64]) -> f64 {
        let n = self.free;
        self.y.fill(0.0);
        for &(p, i) in &self.places {
            self.y[i] += end[p];
        }
        dense::forward(&self.matrix, n + 1, n, &mut self.y);
        self.y[n]
    }

    /// Writes the solution of the last station for a given dw.
    fn backward(&mut self, end: &mut [f64], dw: f64) {
        let n = self.free;
        self.y[n] = dw;
        dense::backward(&self.matrix, n + 1, n, &mut self.y);
        end.fill(0.0);
        for &(p, i) in &self.places {
            end[p] = self.y[i];
        }
    }
}

/// A body with its memory, ready to be solved.
#[derive(Debug, Clone)]
pub struct Body {
    /// What does not change.
    pub discretisation: Arc<Discretisation>,
    /// The present iterate.
    pub state: State,
    /// What is kept fixed.
    pub control: Control,
    /// Sums of the last assembly.
    pub totals: Totals,
    /// The last assembly.
    pub assembled: Assembled,
    pub(super) end: EndSystem,
    /// The last step.
    step: State,
    /// For sensitivities and pressure control.
    second: Vec<f64>,
    /// Whether the tangent is that of the present state.
    pub(super) linearised: bool,
    /// The infinitely long muscle of the same rubber and braid: where first guesses come from.
    pub(super) endless: Option<Arc<ThickWall>>,
    /// Muscles that differ a little in one number, for sensitivities.
    pub(super) neighbours: Neighbours,
}

impl Body {
    /// A body at rest.
    pub fn new(discretisation: impl Into<Arc<Discretisation>>) -> Self {
        let discretisation = discretisation.into();
        let tensions = STRAND_POINTS * discretisation.strands.len();
        let state = State::rest(discretisation.layout.unknowns(), 0, tensions);
        Self {
            assembled: Assembled::new(&discretisation),
            end: EndSystem::new(&discretisation),
            step: state.clone(),
            second: vec![0.0; state.u.len()],
            linearised: false,
            endless: None,
            neighbours: Neighbours::default(),
            control: Control::Length(0.0),
            totals: Totals::default(),
            state,
            discretisation,
        }
    }

    /// A muscle at rest, and the infinitely long muscle of the same rubber and braid.
    pub fn of_muscle(discretisation: Arc<Discretisation>, endless: Arc<ThickWall>) -> Self {
        Self {
            endless: Some(endless),
            ..Self::new(discretisation)
        }
    }

    /// Residual and factorised tangent of the present state.
    pub fn factorise(&mut self) -> Result<Totals, Stopped> {
        self.linearised = false;
        self.totals = assemble::<true>(&self.discretisation, &self.state, &mut self.assembled)?;
        let m = self.discretisation.layout.station();
        self.end
            .factorise(&self.assembled.chain.end, m)
            .map_err(|_| Stopped::Singular)?;
        self.linearised = true;
        Ok(self.totals)
    }

    /// The same of an equilibrium; nothing is done where the last tangent is that of the present
    /// state.
    pub(super) fn tangent(&mut self) -> Result<()> {
        if !self.linearised {
            self.factorise()
                .map_err(|reason| FemError::at_force(self.totals.pull, reason))?;
        }
        Ok(())
    }

    /// Half of ∂V/∂P at fixed length in mm³/MPa, of the last tangent, and ∂F/∂P as
    /// [`crate::solver::body::Body::force_per_pressure`] has it.
    pub fn by_pressure(&mut self) -> (f64, f64) {
        let mut rhs = take(&mut self.second);
        rhs.copy_from_slice(&self.assembled.volume);
        let b = self.condense(&mut rhs);
        self.backward(&mut rhs, 0.0);
        let volume = rhs
            .iter()
            .zip(&self.assembled.volume)
            .map(|(u, v)| u * v)
            .sum();
        self.second = rhs;
        (volume, -b)
    }

    /// ∂F at fixed length for a change of the residual: `change` = ∂(∂Π/∂x); its last station
    /// counts as a change of the reaction. Overwrites `change`.
    pub fn force_change(&mut self, change: &mut [f64]) -> f64 {
        change.iter_mut().for_each(|x| *x = -*x);
        -self.condense(change)
    }

    /// Solves with the last tangent and the terminal moved by `dw`; the right-hand side becomes the
    /// solution.
    pub fn solve_linear(&mut self, rhs: &mut [f64], dw: f64) {
        self.condense(rhs);
        self.backward(rhs, dw);
    }

    fn backward(&mut self, rhs: &mut [f64], dw: f64) {
        let last = self.discretisation.layout.end();
        self.end.backward(&mut rhs[last..], dw);
        self.assembled.chain.backward(rhs);
    }

    /// Augments and forward-substitutes a right-hand side; gives what arrives at the terminal.
    fn condense(&mut self, rhs: &mut [f64]) -> f64 {
        self.augment(rhs);
        for i in 0..self.discretisation.layout.nodes() {
            rhs[2 * i + 1] = 0.0;
        }
        self.assembled.chain.forward(rhs);
        self.end.forward(&rhs[self.discretisation.layout.end()..])
    }

    /// The tangent is that of the augmented system; so must be the right-hand side.
    fn augment(&self, rhs: &mut [f64]) {
        let d = &self.discretisation;
        let l = self.discretisation.layout;
        let beta = 1.0 - d.augment * d.compliance;
        for slab in 0..l.along {
            let stations = l.stations(slab);
            for i in 0..l.through {
                let index = slab * l.through + i;
                let share = d.augment / d.elements[index].volume;
                let at = l.pressure(slab, i);
                for k in 0..MODES {
                    let value = share * rhs[at + k];
                    rhs[at + k] *= beta;
                    let [br, bz] = [
                        &self.assembled.coupling[index][0][k],
                        &self.assembled.coupling[index][1][k],
                    ];
                    for a in 0..NODES {
                        let place = stations[a / 3] + 2 * (2 * i + a % 3);
                        rhs[place] += value * br[a];
                        rhs[place + 1] += value * bz[a];
                    }
                }
            }
            if l.multipliers {
                for g in 0..STRAND_POINTS {
                    let value = d.augment_strand * rhs[l.tension(slab) + g];
                    let first = &self.assembled.strand[slab * STRAND_POINTS + g];
                    for i in 0..6 {
                        rhs[stations[i / 2] + 4 * l.through + i % 2] += value * first[i];
                    }
                }
            }
        }
    }

    /// Relative residual of the last assembly together with what is held.
    fn norm(&self) -> f64 {
        let d = &self.discretisation;
        let scale = d.force_scale(self.state.pressure);
        let last = d.layout.end();
        let places = self.end.places.iter().filter(|(_, i)| *i < self.end.free);
        let free = peak(places.map(|(p, _)| self.assembled.residual[last + p].abs()));
        let held = self
            .control
            .missed(&self.state, self.totals.pull, d.radius, scale);
        self.totals.defect.max(free / scale).max(held)
    }

    /// Adds `share` of the last step.
    fn add_step(&mut self, share: f64) {
        self.linearised = false;
        self.state.add(share, &self.step);
    }

    /// q := k (c + ∂λf/∂u du), or the force of a crimp at that strain, at every strand point, with
    /// the derivatives of the last tangent.
    fn extrapolate_tensions(&mut self) {
        let d = &self.discretisation;
        let l = self.discretisation.layout;
        let Some((braid, k)) = d.problem.braid.and_then(|b| Some((b, b.stiffness?))) else {
            return;
        };
        for (slab, points) in d.strands.iter().enumerate() {
            let u = l.line(&self.state.u, slab, 2 * l.through);
            let stations = l.stations(slab);
            for (g, point) in points.iter().enumerate() {
                let index = slab * STRAND_POINTS + g;
                let first = &self.assembled.strand[index];
                let change: f64 = (0..6)
                    .map(|i| first[i] * self.step.u[stations[i / 2] + 4 * l.through + i % 2])
                    .sum();
                let strain = point.stretch(&u).value - 1.0 + change;
                let q = k * Crimp::force(braid.crimp.as_ref(), strain);
                self.step.q[index] = q - self.state.q[index];
            }
        }
    }
}

impl NewtonSystem for Body {
    fn residual(&mut self) -> Result<f64, Stopped> {
        self.totals = assemble::<false>(&self.discretisation, &self.state, &mut self.assembled)?;
        Ok(self.norm())
    }

    fn linearise(&mut self) -> Result<f64, Stopped> {
        self.factorise()?;
        Ok(self.norm())
    }

    fn correct(&mut self) -> Result<f64, Stopped> {
        let mut rhs = take(&mut self.step.u);
        for (x, r) in rhs.iter_mut().zip(&self.assembled.residual) {
            *x = -r;
        }
        let b = self.condense(&mut rhs);
        let s = self.end.stiffness();
        let mut dp = 0.0;
        let dw = match self.control {
            Control::Length(w) => w - self.state.terminal,
            Control::Force(f) => (f + b) / s,
            Control::Pressure { terminal, force } => {
                let dw = terminal - self.state.terminal;
                let mut second = take(&mut self.second);
                second.copy_from_slice(&self.assembled.volume);
                let v = self.condense(&mut second);
                dp = (s * dw - b - force) / v;
                for (x, y) in rhs.iter_mut().zip(&second) {
                    *x += dp * y;
                }
                self.second = second;
                dw
            }
        };
        let last = self.discretisation.layout.end();
        // With the right-hand side complete, the last station once more.
        self.end.forward(&rhs[last..]);
        self.end.backward(&mut rhs[last..], dw);
        self.assembled.chain.backward(&mut rhs);
        self.step.u = rhs;
        self.step.terminal = dw;
        self.step.pressure = dp;
        self.extrapolate_tensions();
        self.add_step(1.0);
        let l = self.discretisation.layout;
        let m = l.station();
        let moved = (0..l.along).flat_map(|slab| &self.step.u[slab * l.stride()..][..2 * m]);
        let size = peak(moved.map(|x| x.abs())) / self.discretisation.radius;
        if size.is_finite() && dw.is_finite() && dp.is_finite() {
            Ok(size)
        } else {
            Err(Stopped::Diverged)
        }
    }

    fn retreat(&mut self) {
        self.add_step(-0.5);
        self.step.scale(0.5);
    }
}
