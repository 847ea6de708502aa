//! Energy of a section that is bent at constant curvature, per unit of length at rest.
//!
//! A circle of outer radius r about an axis of curvature κ and stretch λ becomes oval by ζ without a change of its circumference: towards the bend it is
//! lower by ζ r, across it wider by as much (Brazier 1927 \[brazier1927\]). At the angle ψ from the outside of the bend the stretch along the muscle is
//!
//!   l(ψ) = λ (1 + κ a (cosψ − ζ cos³ψ)),   a = √((ro² + ri²)/2) of the wall, r + t/2 of the strands,
//!
//! and rubber moves around the circumference as it likes: at ψ the wall is as wide as in a straight muscle of the radius h(ψ), with
//! (1/2π) ∮ r/h dψ = 1 since the circumference is closed. With a multiplier m
//!
//!   E(λ, κ, r) = stat over h, m of  (1/2π) ∮ (r/h) [E(l(ψ), h) − m] dψ + m,   h ∂E/∂h − E + m = 0 at each ψ,
//!
//! E(λ, r) on the right of wall and braid of the straight muscle ([`super::super`]). To second order in κ it is the energy of
//! [`BendingStiffness`](crate::model::BendingStiffness) (a test). The volume under the outer surface is π r² (1 − 3ζ²/2) λ (Pappus), and the wall as a ring
//! adds its energy of bending, so that ζ has the spring K2 = π [3P + 9D/Rm³] per present length, U = ½ K2 (ζ r)², D = μ s³/3. The integral is a sum over
//! equal angles, which converges exponentially. Two limits:
//!
//! - strands that are fixed to the tube follow its fibres: E is that of wall and braid at each ψ;
//! - strands that slide along their own length: a strand has one tension over its turns, and its length over whole turns changes by a second-order
//!   amount whose sign depends on its path (+ with the pitch of the straight helix, − on a geodesic). It is left out: E is that of the wall at each ψ,
//!   and the braid's at λ and r.

use super::jet::Jet;
use crate::model::thick_wall::ThickWall;
use crate::model::{ModelError, WallEnergy};
use std::f64::consts::PI;

/// Angles over half of the circumference.
pub(super) const ANGLES: usize = 12;
const STEPS: usize = 80;

/// How strands follow a bend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Strands {
    /// They slide along their own length.
    Sliding,
    /// They are fixed to the tube.
    Fixed,
}

/// The state of a bent section: stretch of the axis, curvature in 1/mm, outer radius in mm, ζ, multiplier in N.
#[derive(Clone, Copy)]
pub(super) struct Section {
    pub stretch: Jet,
    pub curvature: Jet,
    pub radius: Jet,
    pub oval: Jet,
    pub multiplier: Jet,
}

impl ThickWall {
    /// E(λ, κ, r) with its multiplier, by a number of angles over half of the circumference.
    pub(super) fn bent_energy(
        &self,
        strands: Strands,
        of: &Section,
        angles: usize,
    ) -> Result<Jet, ModelError> {
        let k = self.k.unwrap_or(0.0);
        let (one, l, r) = (Jet::constant(1.0), of.stretch, of.radius);
        let middle = (r * r - l.recip() * (0.5 * self.wall.section())).sqrt();
        let outside = r + Jet::constant(self.offset);
        let mut sum = Jet::constant(0.0);
        for i in 0..angles {
            let cos = (PI * (i as f64 + 0.5) / angles as f64).cos();
            let height = Jet::constant(cos) - of.oval * cos.powi(3);
            let at = |a: Jet| l * (one + of.curvature * a * height);
            let wall = at(middle);
            let braid = match strands {
                Strands::Fixed => Some(at(outside)),
                Strands::Sliding => None,
            };
            sum = sum + self.around(k, &wall, braid.as_ref(), &of.multiplier, r.v)?;
        }
        let around = r * sum * (1.0 / angles as f64) + of.multiplier;
        Ok(match strands {
            Strands::Fixed => around,
            Strands::Sliding => {
                let b = self.braid(k, l.v, r.v);
                around + Jet::of([&l, &r], b.w, [b.l, b.r], [[b.ll, b.lr], [b.lr, b.rr]])
            }
        })
    }

    /// stat over h of (E(l, h) − m)/h, at the stretch l of the wall and of the strands.
    fn around(&self, k: f64, wall: &Jet, braid: Option<&Jet>, m: &Jet, r: f64) -> Result<Jet, ModelError> {
        let (lw, lb) = (wall.v, braid.map_or(1.0, |b| b.v));
        let at = |h: f64| {
            let w = self.wall.energy(&self.law, lw, h);
            let b = braid.map(|_| self.braid(k, lb, h));
            let b = b.map_or_else(WallEnergy::default, |b| WallEnergy {
                w: b.w,
                l: b.l,
                r: b.r,
                ll: b.ll,
                lr: b.lr,
                rr: b.rr,
            });
            (w, b)
        };
        let none = ModelError::NoEquilibrium {
            reason: format!(
                "no equilibrium of the bent section at a stretch of {lw:.3} on one side: take a larger radius or a lower pressure"
            ),
        };
        if !(lw > 0.0 && lb > 0.0 && m.v.is_finite()) {
            return Err(none);
        }
        let (mut low, mut high) = ((self.wall.section() / lw).sqrt(), 3.0 * r);
        let mut h = r.max(1.001 * low);
        for _ in 0..STEPS {
            let (w, b) = at(h);
            let slope = h * (w.rr + b.rr);
            let f = h * (w.r + b.r) - w.w - b.w + m.v;
            let step = -f / slope;
            if f.is_finite() && slope > 0.0 && step.abs() < 1e-13 * h {
                let (i, by) = (1.0 / h, [w.l, b.l]);
                let curvature = (w.rr + b.rr) * i;
                // ∂²/∂h∂(lw, lb, m)
                let mixed = [w.lr * i - w.l * i * i, b.lr * i - b.l * i * i, i * i];
                let own = [w.ll * i, b.ll * i, 0.0];
                let second = std::array::from_fn(|p| {
                    std::array::from_fn(|q| {
                        let direct = if p == q { own[p] } else { 0.0 };
                        direct - mixed[p] * mixed[q] / curvature
                    })
                });
                let first = [by[0] * i, by[1] * i, -i];
                let value = (w.w + b.w - m.v) * i;
                let still = Jet::constant(1.0);
                return Ok(Jet::of([wall, braid.unwrap_or(&still), m], value, first, second));
            }
            if !f.is_finite() {
                // A law that locks, or a bore that closes.
                if h < r {
                    low = h
                } else {
                    high = h
                }
                h = 0.5 * (low + high);
                continue;
            }
            if f > 0.0 {
                high = h
            } else {
                low = h
            }
            let next = h + step;
            h = if slope > 0.0 && next > low && next < high { next } else { 0.5 * (low + high) };
            if high - low < 4.0 * f64::EPSILON * high {
                break;
            }
        }
        Err(none)
    }
}
