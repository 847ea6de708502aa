//! Linear systems with multipliers.
//!
//! The unknowns' tangent K holds γ/V G Gᵀ of every constraint, so that with β = 1 − γ/k
//!
//!   K du + Σ β G dm = b + Σ (γ/V) G d,    G du − (V/k) dm = d
//!
//! Where γ = k (β = 0) the multipliers follow from du. The others solve [V/k + β G K⁻¹ Gᵀ] dm = G
//! K⁻¹(…) − d by conjugate gradients with V/γ for a preconditioner (augmented Lagrangian: Fortin &
//! Glowinski 1983 \[fortin1983\]).

use super::{
    assembly::Assembled,
    discretisation::{Discretisation, share},
};
use crate::solver::{body::State, sparse::SparseCholesky};
use mckibben_core::cancel;

const ITERATIONS: usize = 60;

/// Constraints of a body at its last assembly.
pub struct Constraints<'a> {
    /// The body.
    pub d: &'a Discretisation,
    /// Its last assembly.
    pub assembled: &'a Assembled,
    /// Its factorised tangent.
    pub cholesky: &'a mut SparseCholesky,
    /// Tolerance of conjugate gradients.
    pub tolerance: f64,
}

impl Constraints<'_> {
    /// Whether any constraint needs conjugate gradients.
    fn iterated(&self) -> bool {
        self.d
            .materials
            .iter()
            .any(|m| share(m.compliance, m.augment) > 0.0)
            || self.d.strand.iter().any(|&(c, g)| share(c, g) > 0.0)
    }

    /// Calls `each` with (number, G's displacements and values, V, 1/k, γ) for every constraint
    /// that acts: first the bricks' (number 0 …), then the strands' (number bricks·modes …).
    fn each_constraint(&self, mut each: impl FnMut(usize, &[u32], &[f64], f64, f64, f64)) {
        let (d, nn) = (self.d, self.d.per_brick);
        for e in 0..d.bricks() {
            let nodes = &d.problem.bricks[e];
            let volume = d.rest[e].volume;
            let material = d.material(e);
            for k in 0..d.modes {
                let m = e * d.modes + k;
                let gradient = &self.assembled.gradient[m * nn * 3..(m + 1) * nn * 3];
                each(
                    m,
                    nodes,
                    gradient,
                    volume,
                    material.compliance,
                    material.augment,
                );
            }
        }
        let first = d.bricks() * d.modes;
        for (t, ((ends, truss), &(n, _, carries))) in d
            .problem
            .trusses
            .iter()
            .zip(&self.assembled.strands)
            .enumerate()
        {
            if carries {
                let gradient = [-n[0], -n[1], -n[2], n[0], n[1], n[2]];
                let (compliance, augment) = d.strand[t];
                each(
                    first + t,
                    ends,
                    &gradient,
                    truss.length_mm,
                    compliance,
                    augment,
                );
            }
        }
    }

    /// G du for every constraint.
    fn defects(&self, du: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        self.each_constraint(|m, nodes, g, _, _, _| {
            let mut sum = 0.0;
            for (node, g) in nodes.iter().zip(g.chunks_exact(3)) {
                let at = 3 * *node as usize;
                sum += g[0] * du[at] + g[1] * du[at + 1] + g[2] * du[at + 2];
            }
            out[m] = sum;
        });
    }

    /// Defects of displacements beyond those wanted.
    fn excess_defects(&self, du: &[f64], wanted: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; wanted.len()];
        self.defects(du, &mut out);
        out.iter_mut().zip(wanted).for_each(|(r, d)| *r -= d);
        out
    }

    /// z = (γ/V) r
    fn precondition(&self, r: &[f64], z: &mut [f64]) {
        z.fill(0.0);
        self.each_constraint(|m, _, _, volume, _, augment| z[m] = augment / volume * r[m]);
    }

    /// out += Σ β G m, in displacements.
    pub fn forces(&self, m: &[f64], out: &mut [f64]) {
        self.each_constraint(|number, nodes, g, _, compliance, augment| {
            let value = share(compliance, augment) * m[number];
            if value != 0.0 {
                for (node, g) in nodes.iter().zip(g.chunks_exact(3)) {
                    let at = 3 * *node as usize;
                    (0..3).for_each(|i| out[at + i] += value * g[i]);
                }
            }
        });
    }

    /// Solves; `b` holds b + Σ (γ/V) G d of the unknowns, `du` the displacements that are given
    /// (the terminal's), and takes the solution; `dm` holds d and takes the multipliers. Where the
    /// work is cancelled what is there is no solution.
    pub fn solve(&mut self, b: &mut [f64], du: &mut [f64], dm: &mut [f64]) {
        self.cholesky.solve(b);
        spread(self.d, b, du);
        let wanted = dm.to_vec();
        let mut shares = vec![0.0; dm.len()];
        self.each_constraint(|m, _, _, _, compliance, augment| {
            shares[m] = share(compliance, augment)
        });
        dm.fill(0.0);
        if self.iterated() {
            let mut r = self.excess_defects(du, &wanted);
            self.conjugate_gradients(&shares, du, &mut r, dm);
        }
        // Those that were condensed follow.
        let r = self.excess_defects(du, &wanted);
        self.each_constraint(|m, _, _, volume, _, augment| {
            if shares[m] == 0.0 {
                dm[m] = augment / volume * r[m];
            }
        });
    }

    /// Right-hand side in `r`; corrects `du` as well. The matrix is symmetric in the inner product
    /// Σ β x y, in which constraints with β = 0 have no part.
    fn conjugate_gradients(
        &mut self,
        shares: &[f64],
        du: &mut [f64],
        r: &mut [f64],
        x: &mut [f64],
    ) {
        let d = self.d;
        let tolerance = self.tolerance;
        let n = r.len();
        let inner = |a: &[f64], b: &[f64]| {
            a.iter()
                .zip(b)
                .zip(shares)
                .map(|((x, y), w)| w * x * y)
                .sum::<f64>()
        };
        let mut z = vec![0.0; n];
        let mut p = vec![0.0; n];
        let mut s = vec![0.0; n];
        let mut full = vec![0.0; du.len()];
        let mut b = vec![0.0; d.free];
        self.precondition(r, &mut z);
        p.copy_from_slice(&z);
        let mut rz = inner(r, &z);
        let first = rz;
        for _ in 0..ITERATIONS {
            let close = rz <= tolerance * tolerance * first || first == 0.0;
            if rz.is_nan() || close || cancel::check().is_err() {
                return;
            }
            // w = K⁻¹ β Gᵀ p, s = V/k p + G w
            full.fill(0.0);
            self.forces(&p, &mut full);
            gather(d, &full, &mut b);
            self.cholesky.solve(&mut b);
            full.fill(0.0);
            spread(d, &b, &mut full);
            self.defects(&full, &mut s);
            self.each_constraint(|m, _, _, volume, compliance, _| {
                s[m] += volume * compliance * p[m]
            });
            let curvature = inner(&p, &s);
            if curvature.is_nan() || curvature <= 0.0 {
                return;
            }
            let alpha = rz / curvature;
            for i in 0..n {
                x[i] += alpha * p[i];
                r[i] -= alpha * s[i];
            }
            for (u, w) in du.iter_mut().zip(&full) {
                *u -= alpha * w;
            }
            self.precondition(r, &mut z);
            let next = inner(r, &z);
            let beta = next / rz;
            rz = next;
            for (p, z) in p.iter_mut().zip(&z) {
                *p = z + beta * *p;
            }
        }
    }
}

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

pub fn spread(d: &Discretisation, x: &[f64], u: &mut [f64]) {
    for (x, place) in x.iter().zip(&d.place) {
        u[*place as usize] = *x;
    }
}

pub fn gather(d: &Discretisation, u: &[f64], x: &mut [f64]) {
    for (x, place) in x.iter_mut().zip(&d.place) {
        *x = u[*place as usize];
    }
}

/// d = −c: the defects of the constraints.
pub fn constraint_residual(d: &Discretisation, s: &State, work: &Assembled, out: &mut [f64]) {
    let bricks = d.bricks() * d.modes;
    for (o, c) in out.iter_mut().zip(&work.defect) {
        *o = -c;
    }
    for (t, (_, strain, carries)) in work.strands.iter().enumerate() {
        let length = d.problem.trusses[t].1.length_mm;
        out[bricks + t] = if *carries {
            -length * (strain - s.q[t] * d.strand[t].0)
        } else {
            0.0
        };
    }
}
