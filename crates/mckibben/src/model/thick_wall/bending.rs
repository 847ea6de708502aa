//! Bending of the infinitely long muscle: its stiffness against small curvatures, and the load at which it buckles as a column.
//!
//! The section stays a circle of radius r. A curvature κ of the muscle's axis gives the fibre at the angle φ the axial stretch
//! λ (1 + κ a cosφ), with a = √((ro² + ri²)/2) for the wall (exact for the second moment of its section) and a = rb for the strands, and the
//! tube may widen on one side: its outer radius counts as r + β cosφ there. To second order the energy of wall and braid, E(λ, r) of
//! [`super`], is per length at rest
//!
//!   ½ EI κ² = min over β of  ¼ [ λ² κ² Σ a² E_λλ + 2 κ β λ Σ a (E_λr − E_λ/r) + β² Σ E_rr ]
//!
//! Σ: over wall and braid. The volume under the outer surface, π r² λ, does not change (Pappus). Two limits:
//!
//! - strands that slide on the tube without friction do not follow its fibres: the wall alone resists;
//! - strands that are fixed to the tube: wall and braid. Where they do not stretch, β = −κ λ rb cos²θ0 λ/(sin²θ0 rb/Rs²), and the ideal muscle
//!   has EI = π P λ r⁴ cos²θ (1 + 2 cos²θ)/sin⁴θ.
//!
//! A muscle between two joints buckles at F = π² EI/(λ² L0²) (Euler), EI here per length now. Shear is left out. Derived here; no measured muscle is known to compare with.

use super::ThickWall;
use crate::model::{ForceModel, Result, WallEnergy};
use std::f64::consts::PI;

/// Stiffness against bending at a state, in N mm².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BendingStiffness {
    /// Of the wall alone: strands that slide on the tube.
    pub sliding_n_mm2: f64,
    /// Of wall and strands that are fixed to it.
    pub fixed_n_mm2: f64,
}

/// Second-order energy in (λ, r): its part in κ², κβ and β².
#[derive(Default)]
struct Second {
    curvature: f64,
    mixed: f64,
    widening: f64,
}

impl Second {
    fn add(self, e: &WallEnergy, (l, r): (f64, f64), a: f64) -> Self {
        Self {
            curvature: self.curvature + l * l * a * a * e.ll,
            mixed: self.mixed + l * a * (e.lr - e.l / r),
            widening: self.widening + e.rr,
        }
    }

    /// EI per length at rest, with β at its minimum or as it must be, per κ.
    fn stiffness(&self, beta: Option<f64>) -> f64 {
        let beta = beta.unwrap_or(-self.mixed / self.widening);
        0.5 * (self.curvature + 2.0 * self.mixed * beta + self.widening * beta * beta)
    }
}

impl ThickWall {
    /// Stiffness against bending at a pressure and contraction.
    pub fn bending(&self, pressure_mpa: f64, contraction: f64) -> Result<BendingStiffness> {
        let (l, _, _) = self.stretch(pressure_mpa, contraction);
        let s = self.state(pressure_mpa, l)?;
        let (r, rb) = (s.r, s.r + self.offset);
        let w = self.wall.energy(&self.law, l, r);
        let middle = (r * r - 0.5 * self.wall.section() / l).sqrt();
        let wall = Second::default().add(&w, (l, r), middle);
        let sliding = wall.stiffness(None);
        let fixed = match self.k {
            Some(k) => {
                let b = self.braid(k, l, r);
                let b = WallEnergy { w: b.w, l: b.l, r: b.r, ll: b.ll, lr: b.lr, rr: b.rr };
                wall.add(&b, (l, r), rb).stiffness(None)
            }
            None => {
                let (a, b) = (self.cos2, self.sin2 / (self.rs * self.rs));
                // Tension of the strands per slope of their stretch, from ∂Π/∂r = 0.
                let t = ((2.0 * PI * r * l * pressure_mpa - w.r) / (b * rb)).max(0.0);
                let braid = WallEnergy {
                    w: 0.0,
                    l: t * a * l,
                    r: t * b * rb,
                    ll: t * a * (1.0 - a * l * l),
                    lr: -t * a * l * b * rb,
                    rr: t * b * (1.0 - b * rb * rb),
                };
                let taut = (t > 0.0).then_some(-l * a * l / b);
                wall.add(&braid, (l, r), rb).stiffness(taut)
            }
        };
        Ok(BendingStiffness { sliding_n_mm2: sliding / l, fixed_n_mm2: fixed / l })
    }

    /// The push in N at which a muscle between two joints buckles, of strands that slide and of strands that are fixed to the tube.
    pub fn buckling_n(&self, pressure_mpa: f64, contraction: f64) -> Result<(f64, f64)> {
        let length_mm = (1.0 - contraction) * self.info().muscle.length_mm();
        let of = |stiffness: f64| (PI / length_mm).powi(2) * stiffness;
        let BendingStiffness { sliding_n_mm2, fixed_n_mm2 } = self.bending(pressure_mpa, contraction)?;
        Ok((of(sliding_n_mm2), of(fixed_n_mm2)))
    }
}

#[cfg(test)]
mod tests {
    use crate::model::ThickWall;
    use crate::muscle::{Braid, BraidStiffness, Muscle, Rubber, Tube};
    use crate::rubber::{Law, NeoHookean};
    use std::f64::consts::PI;

    fn model(mu_mpa: f64, wall_mm: f64, angle_deg: f64, stiffness: BraidStiffness) -> ThickWall {
        let tube = Tube {
            outer_diameter_mm: 20.0,
            wall_mm,
            rubber: Rubber::of(Law::NeoHookean(NeoHookean { mu_mpa })),
            ..Tube::prototype()
        };
        let m = Muscle::prototype().with_tube(tube).unwrap();
        let braid = Braid { angle_deg, stiffness, ..m.braid().clone() };
        ThickWall::new(&m.with_braid(braid).unwrap())
    }

    /// A beam of incompressible rubber at rest: E I = 3 μ π (Ro⁴ − Ri⁴)/4, at any wall.
    #[test]
    fn at_rest_the_wall_alone_is_a_beam() {
        for wall in [0.5, 2.0, 6.0] {
            let beam = 3.0 * 0.4 * PI * (1e4 - (10.0_f64 - wall).powi(4)) / 4.0;
            let found = model(0.4, wall, 60.0, BraidStiffness::NewtonPerMm(100.0)).bending(0.0, 0.0).unwrap();
            assert!((found.sliding_n_mm2 / beam - 1.0).abs() < 1e-9, "{wall} {found:?}");
            assert!(found.fixed_n_mm2 >= found.sliding_n_mm2, "{found:?}");
        }
    }

    /// Without rubber and with rigid strands by hand: π P r⁴ cos²θ (1 + 2 cos²θ)/sin⁴θ; stiff strands tend to it.
    #[test]
    fn strands_that_are_fixed_stiffen_the_ideal_muscle_as_by_hand() {
        for angle in [25.0_f64, 40.0, 62.0] {
            for e in [-0.03, 0.0, 0.04] {
                let rigid = model(1e-9, 1.0, angle, BraidStiffness::Inextensible);
                let cos = (1.0 - e) * angle.to_radians().cos();
                let (cos2, sin2) = (cos * cos, 1.0 - cos * cos);
                let r = 10.0 * sin2.sqrt() / angle.to_radians().sin();
                let by_hand = PI * 0.2 * r.powi(4) * cos2 * (1.0 + 2.0 * cos2) / (sin2 * sin2);
                let found = rigid.bending(0.2, e).unwrap().fixed_n_mm2;
                assert!((found / by_hand - 1.0).abs() < 1e-6, "{angle} {e} {found} {by_hand}");
                let stiff = model(1e-9, 1.0, angle, BraidStiffness::NewtonPerMm(1e6));
                let found = stiff.bending(0.2, e).unwrap().fixed_n_mm2;
                assert!((found / by_hand - 1.0).abs() < 1e-3, "{angle} {e} {found} {by_hand}");
            }
        }
    }
}
