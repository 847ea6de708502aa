//! A body, its state and its tangent: Newton's method for it.
//!
//! Unknowns are displacements u, the terminal's w, and multipliers: pressures of the bricks and
//! tensions of the strands, carried along as separate variables so that stiff constraints do not
//! slow Newton's method down (Magisano, Leonetti & Garcea 2017). `saddle.rs` solves the linear
//! systems.

use super::{
    assembly::{Assembled, assemble},
    discretisation::{Discretisation, share},
    saddle::{Constraints, constraint_residual, dot, gather},
};
use crate::{
    FemError, Result,
    solver::{
        body::{Control, State, Totals},
        newton::{NewtonSystem, Solved, Stopped},
        sparse::SparseCholesky,
    },
};
use mckibben_core::{cancel, extremes::peak};
use std::sync::Arc;

/// Tolerances of conjugate gradients: inside of Newton's method, and for derivatives.
const LOOSE: f64 = 1e-4;
const TIGHT: f64 = 1e-11;

/// Share of the scale of residuals above which rounding raises it.
const ROUNDING: f64 = 1e-9;

/// A body with its state.
#[derive(Debug)]
pub struct Body {
    /// What does not change.
    pub discretisation: Arc<Discretisation>,
    /// The present iterate.
    pub state: State,
    /// What the last assembly filled.
    pub assembled: Assembled,
    /// What is kept fixed.
    pub control: Control,
    /// Totals of the last assembly.
    pub totals: Totals,
    /// Tolerance of conjugate gradients inside of Newton's method.
    pub tolerance: f64,
    cholesky: SparseCholesky,
    step: State,
}

/// What moves a body away from its present state, as far as its tangent tells.
enum Cause {
    /// Its residual, and by how much the terminal moves in mm.
    Residual(f64),
    /// 1 mm of the terminal.
    Terminal,
    /// 1 MPa of pressure.
    Pressure,
}

impl Body {
    /// A body at rest.
    ///
    /// # Errors
    /// [`FemError::Refused`] where there is not enough memory.
    pub fn new(discretisation: impl Into<Arc<Discretisation>>) -> Result<Self> {
        let discretisation = discretisation.into();
        let cholesky = SparseCholesky::new(discretisation.analysis.clone())
            .ok_or_else(|| FemError::too_large(discretisation.free))?;
        let d = &discretisation;
        let nodes = d.problem.nodes.len();
        let state = State::rest(3 * nodes, d.bricks() * d.modes, d.problem.trusses.len());
        Ok(Self {
            assembled: Assembled::new(&discretisation),
            step: state.clone(),
            control: Control::Length(0.0),
            totals: Totals::default(),
            tolerance: LOOSE,
            cholesky,
            state,
            discretisation,
        })
    }

    /// Residual and tangent of the present state.
    pub fn assemble(&mut self) -> Result<Totals, Stopped> {
        self.totals = assemble::<true>(&self.discretisation, &self.state, &mut self.assembled)?;
        Ok(self.totals)
    }

    /// Factorises the last assembled tangent.
    pub fn factorise_assembled(&mut self) -> Solved {
        self.cholesky.factorise(&self.assembled.values)
    }

    /// Residual and factorised tangent of the present state.
    pub fn factorise(&mut self) -> Result<Totals, Stopped> {
        self.assemble()?;
        self.factorise_assembled()?;
        Ok(self.totals)
    }

    /// Negative eigenvalues of the last tangent with the terminal held: zero for a stable
    /// equilibrium.
    pub fn unstable_directions(&self) -> usize {
        self.cholesky.negative
    }

    /// The terminal's column of the tangent, and its diagonal entry.
    fn terminal_column(&self) -> (&[f64], f64) {
        let entries = self.discretisation.pattern().entries();
        let n = self.discretisation.free;
        (
            &self.assembled.values[entries..entries + n],
            self.assembled.values[entries + n],
        )
    }

    /// The step that the last tangent predicts, and by how much ∂Π/∂w changes. Where the work is
    /// cancelled on the way neither is right: who makes an answer of them looks at the flag
    /// afterwards.
    fn respond(&mut self, cause: Cause, tolerance: f64) -> (f64, State) {
        let mut out = self.state.clone();
        let d = &self.discretisation;
        let (dw, pressure) = match cause {
            Cause::Residual(terminal) => (terminal, 0.0),
            Cause::Terminal => (1.0, 0.0),
            Cause::Pressure => (0.0, 1.0),
        };
        let by_residual = matches!(cause, Cause::Residual(_));
        let bricks = d.bricks() * d.modes;
        let mut b = vec![0.0; d.free];
        let mut dm = vec![0.0; bricks + d.problem.trusses.len()];
        if by_residual {
            gather(d, &self.assembled.force, &mut b);
            b.iter_mut().for_each(|x| *x = -*x);
            constraint_residual(d, &self.state, &self.assembled, &mut dm);
        } else if pressure > 0.0 {
            let mut all = self.assembled.cavity.clone();
            for (v, dead) in all.iter_mut().zip(d.problem.dead.iter().flatten()) {
                *v += dead;
            }
            gather(d, &all, &mut b);
        }
        let (column, diagonal) = self.terminal_column();
        for (b, k) in b.iter_mut().zip(column) {
            *b -= k * dw;
        }
        out.u.fill(0.0);
        for &i in &d.terminal {
            out.u[i as usize] = dw;
        }
        let assembled = &self.assembled;
        let mut constraints = Constraints {
            d,
            assembled,
            cholesky: &mut self.cholesky,
            tolerance,
        };
        constraints.solve(&mut b, &mut out.u, &mut dm);
        // What the iterated multipliers do to the terminal.
        let mut forces = vec![0.0; out.u.len()];
        constraints.forces(&dm, &mut forces);
        gather(d, &out.u, &mut b);
        let (column, _) = self.terminal_column();
        let mut change = diagonal * dw + dot(column, &b);
        change += d.terminal.iter().map(|&i| forces[i as usize]).sum::<f64>();
        if pressure > 0.0 {
            let cavity = &self.assembled.cavity;
            change -= d.terminal.iter().map(|&i| cavity[i as usize]).sum::<f64>();
            change -= d.problem.cap_mm2 / 3.0;
        }
        out.p.copy_from_slice(&dm[..bricks]);
        out.q.copy_from_slice(&dm[bricks..]);
        out.terminal = dw;
        out.pressure = pressure;
        if by_residual {
            // Strands that do not carry forget their tension.
            for (t, (_, _, carries)) in self.assembled.strands.iter().enumerate() {
                if !carries {
                    out.q[t] = -self.state.q[t];
                }
            }
        }
        (change, out)
    }

    /// ∂F/∂P at fixed length in mm², of the last tangent.
    pub fn force_per_pressure(&mut self) -> f64 {
        4.0 * self.respond(Cause::Pressure, TIGHT).0
    }

    /// dF/dw of the whole muscle for a displacement of one terminal, in N/mm: twice the stiffness
    /// ∂F/∂L; and −∂V/∂L at fixed pressure in mm², by Maxwell's relation the same as ∂F/∂P; of the
    /// last tangent.
    pub fn terminal_response(&mut self) -> (f64, f64) {
        let (change, out) = self.respond(Cause::Terminal, TIGHT);
        let volume =
            dot(&self.assembled.cavity, &out.u) + self.discretisation.problem.cap_mm2 / 3.0;
        (4.0 * change, -4.0 * volume)
    }

    /// ∂V/∂P of the whole cavity at fixed length in mm³/MPa, of the last tangent.
    pub fn volume_per_pressure(&mut self) -> f64 {
        let (_, out) = self.respond(Cause::Pressure, TIGHT);
        8.0 * dot(&self.assembled.cavity, &out.u)
    }

    /// The size of nodal forces in N against which residuals are measured.
    pub fn force_scale(&self) -> f64 {
        let d = &self.discretisation;
        let volume = d.rest.iter().map(|m| m.volume).sum::<f64>() / d.bricks().max(1) as f64;
        (d.shear + self.state.pressure.abs()) * volume.powf(2.0 / 3.0)
    }

    /// Relative residual of the last assembly together with what is held.
    fn norm(&self) -> f64 {
        let d = &self.discretisation;
        let scale = self.force_scale();
        let free = peak(
            d.place
                .iter()
                .map(|&i| self.assembled.force[i as usize].abs()),
        );
        let held = self
            .control
            .missed(&self.state, self.totals.pull, d.radius, scale);
        // Where the multipliers are iterated, the defects of the constraints count as well.
        let rubber = &d.materials[0];
        let defect = if share(rubber.compliance, rubber.augment) > 0.0 {
            self.totals.defect
        } else {
            0.0
        };
        (free / scale.max(d.rounding_n / ROUNDING))
            .max(held)
            .max(defect)
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
        let reaction = 0.25 * self.totals.pull;
        let (dw, held) = match self.control {
            Control::Length(w) => (w - self.state.terminal, None),
            Control::Force(f) => (0.0, Some((f, Cause::Terminal))),
            Control::Pressure { terminal, force } => (
                terminal - self.state.terminal,
                Some((force, Cause::Pressure)),
            ),
        };
        let (change, mut step) = self.respond(Cause::Residual(dw), self.tolerance);
        if let Some((force, cause)) = held {
            let (per, unit) = self.respond(cause, self.tolerance);
            step.add((0.25 * force - reaction - change) / per, &unit);
        }
        cancel::check()?;
        self.state.add(1.0, &step);
        let size = peak(step.u.iter().map(|x| x.abs())) / self.discretisation.radius;
        let sum = size + step.pressure + step.u.iter().sum::<f64>();
        self.step = step;
        if sum.is_finite() {
            Ok(size)
        } else {
            Err(Stopped::Diverged)
        }
    }

    fn retreat(&mut self) {
        self.state.add(-0.5, &self.step);
        self.step.scale(0.5);
    }
}
