//! Bending of the infinitely long muscle: its stiffness against small curvatures, and the load at
//! which it buckles as a column.
//!
//! The section stays a circle of radius r. A curvature κ of the muscle's axis gives the fibre at
//! the angle φ the axial stretch λ (1 + κ a cosφ), with a = √((ro² + ri²)/2) (exact for the second
//! moment of the wall's section), and the tube may widen on one side: its outer radius counts as
//! r + β cosφ there. To second order the energy of the wall, W(λ, r) of [`super`], is per length at
//! rest
//!
//!   ½ EI κ² = min over β of  ¼ [ λ² κ² a² W_λλ + 2 κ β λ a (W_λr − W_λ/r) + β² W_rr ]
//!
//! The volume under the outer surface, π r² λ, does not change (Pappus). Strands slide on the tube
//! without friction and do not follow its fibres: strands that do not slide would stiffen it.
//!
//! A muscle between two joints buckles at F = π² EI/(λ² L0²) (Euler), EI here per length now. Shear
//! is left out. Derived here; no measured muscle is known to compare with.

use super::ThickWall;
use crate::model::{ForceModel, Result};
use std::f64::consts::PI;

impl ThickWall {
    /// Stiffness of the wall against bending at a pressure and contraction, in N mm².
    fn bending_n_mm2(&self, pressure_mpa: f64, contraction: f64) -> Result<f64> {
        let (l, _, _) = self.stretch(pressure_mpa, contraction);
        let r = self.state(pressure_mpa, l)?.r;
        let w = self.wall.energy(&self.law, l, r);
        let a = (r * r - 0.5 * self.wall.section() / l).sqrt();
        // Second-order energy in κ², κβ and β².
        let curvature = l * l * a * a * w.ll;
        let mixed = l * a * (w.lr - w.l / r);
        let widening = w.rr;
        let beta = -mixed / widening;
        Ok(0.5 * (curvature + 2.0 * mixed * beta + widening * beta * beta) / l)
    }

    /// The push in N at which a muscle between two joints buckles.
    pub fn buckling_n(&self, pressure_mpa: f64, contraction: f64) -> Result<f64> {
        let length_mm = (1.0 - contraction) * self.info().muscle.length_mm();
        Ok((PI / length_mm).powi(2) * self.bending_n_mm2(pressure_mpa, contraction)?)
    }
}

#[cfg(test)]
mod tests {
    use crate::{
        model::ThickWall,
        muscle::{Braid, BraidStiffness, Muscle, Rubber, Tube},
        rubber::{Law, NeoHookean},
    };
    use std::f64::consts::PI;

    fn model(wall_mm: f64) -> ThickWall {
        let tube = Tube {
            outer_diameter_mm: 20.0,
            wall_mm,
            rubber: Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa: 0.4 })),
            ..Tube::prototype()
        };
        let m = Muscle::prototype().with_tube(tube).unwrap();
        let stiffness = BraidStiffness::NewtonPerMm(100.0);
        let braid = Braid {
            angle_deg: 60.0,
            stiffness,
            ..m.braid().clone()
        };
        ThickWall::between_ends(&m.with_braid(braid).unwrap())
    }

    /// A beam of incompressible rubber at rest: E I = 3 μ π (Ro⁴ − Ri⁴)/4, at any wall.
    #[test]
    fn at_rest_the_wall_alone_is_a_beam() {
        for wall in [0.5, 2.0, 6.0] {
            let beam = 3.0 * 0.4 * PI * (1e4 - (10.0_f64 - wall).powi(4)) / 4.0;
            let stiffness = model(wall).bending_n_mm2(0.0, 0.0).unwrap();
            assert!((stiffness / beam - 1.0).abs() < 1e-9, "{wall} {stiffness}");
        }
    }
}
