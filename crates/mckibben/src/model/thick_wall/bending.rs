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
//! A muscle between two joints buckles at F = π² EI/(λ² L0²) (Euler), EI here per length now. A rigid core rod that ends inside leaves the length
//! b = L − l of L to bend; it turns about the joint of its plug, so that
//!
//!   F = EI z²/b²,   tan z = −z l/b,   π/2 < z ≤ π,
//!
//! and one that leaves through a seal guides the muscle: it does not buckle. The play of the rod in the bore is left out, and so is shear. Derived here; no measured muscle is known to
//! compare with.

use super::ThickWall;
use crate::model::{ForceModel, ModelError, WallEnergy};
use crate::muscle::Rod;
use std::f64::consts::{FRAC_PI_2, PI};

/// z of tan z = −z q, between π/2 and π: bisection of sin z + q z cos z, which falls there.
fn half_wave(q: f64) -> f64 {
    let (mut low, mut high) = (FRAC_PI_2, PI);
    for _ in 0..60 {
        let z = 0.5 * (low + high);
        if z.sin() + q * z * z.cos() > 0.0 { low = z } else { high = z }
    }
    high
}

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
    pub fn bending(&self, pressure_mpa: f64, contraction: f64) -> Result<BendingStiffness, ModelError> {
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

    /// The push in N at which a muscle between two joints buckles, of strands that slide and of strands that are fixed to the tube; infinite on a
    /// core rod through a seal, which guides it.
    pub fn buckling_n(&self, pressure_mpa: f64, contraction: f64) -> Result<(f64, f64), ModelError> {
        let muscle = &self.info().muscle;
        let length_mm = (1.0 - contraction) * muscle.length_mm();
        let curvature2 = match muscle.rod() {
            None => (PI / length_mm).powi(2),
            Some(Rod { length_mm: None, .. }) => return Ok((f64::INFINITY, f64::INFINITY)),
            Some(Rod { length_mm: Some(rigid_mm), .. }) => {
                let free_mm = (length_mm - rigid_mm).max(f64::MIN_POSITIVE);
                (half_wave(rigid_mm / free_mm) / free_mm).powi(2)
            }
        };
        let of = |stiffness: f64| curvature2 * stiffness;
        let BendingStiffness { sliding_n_mm2, fixed_n_mm2 } = self.bending(pressure_mpa, contraction)?;
        Ok((of(sliding_n_mm2), of(fixed_n_mm2)))
    }
}

#[cfg(test)]
mod tests {
    use crate::model::{ForceModel, ThickWall};
    use crate::muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube};
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

    /// Roots of tan z = −z q by `brentq` of SciPy 1.17, and the column without a rod.
    #[test]
    fn a_rod_that_ends_inside_leaves_the_rest_to_buckle() {
        for (q, exact) in [(0.0, PI), (0.25, 2.570_431_6), (1.0, 2.028_757_8), (9.0, 1.638_505_2)] {
            assert!((super::half_wave(q) - exact).abs() < 1e-6, "{q} {}", super::half_wave(q));
        }
        let plain = model(0.4, 2.0, 60.0, BraidStiffness::NewtonPerMm(100.0));
        let muscle = plain.info().muscle.clone();
        let cored = |length: Option<f64>| {
            let ends =
                Terminals { rod_diameter_mm: Some(12.0), rod_length_mm: length, ..Terminals::default() };
            ThickWall::new(&muscle.with_terminals(ends).unwrap()).buckling_n(0.1, -0.02).unwrap().0
        };
        let free = plain.buckling_n(0.1, -0.02).unwrap().0;
        assert!((cored(Some(1e-9)) / free - 1.0).abs() < 1e-9);
        // Half of the length now on the rod: (2.0287578/(π/2))².
        assert!((cored(Some(0.51 * 285.0)) / free - 4.0 * (2.028_757_8 / PI).powi(2)).abs() < 1e-5);
        assert_eq!(cored(None), f64::INFINITY);
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
