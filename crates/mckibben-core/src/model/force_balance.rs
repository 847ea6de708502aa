//! Force balance: strands in equilibrium with the pressure inside of an incompressible wall.
//!
//!   F = P [2π r ri cot²θ − π ri²],   ri² = r² − (Ro² − Ri²)/λ,   r = r0 sinθ/sinθ0,  cosθ = λ cosθ0
//!
//! Hoop balance: the strands hold P·2 ri per unit of length; axial balance of a cut: F + P π ri² =
//! (tensions)·cosθ. Sources: Ferraresi et al. (2001) \[ferraresi2001\]; Kothera & Wereley (2009)
//! \[kothera2009\]; Tondu (2012) \[tondu2012\] eq. (18).

use super::{
    ForceModel, ModelEntry, ModelInfo, Result,
    pantograph::Pantograph,
    proportional::{PerPressure, proportional},
};
use crate::muscle::Muscle;
use std::f64::consts::PI;

pub const ENTRY: ModelEntry = ModelEntry {
    name: "force-balance",
    description: "incompressible wall without the rubber's own stress",
    source: "Ferraresi et al. 2001 [ferraresi2001]; Kothera & Wereley 2009 [kothera2009]; Tondu \
        2012 [tondu2012] eq. (18)",
};

/// The force balance of an incompressible wall whose rubber carries nothing.
///
/// The wall thins as the muscle bulges, but the rubber's own stress is left out, which costs force
/// at small contractions (a rubber wall hands the pressure on to the braid). Being no energy model
/// it breaks ∂F/∂P = −∂V/∂L; the volume given is that of the bore.
pub fn build(muscle: &Muscle) -> Result<Box<dyn ForceModel>> {
    let info = ModelInfo::new(&ENTRY, muscle);
    let braid = Pantograph::from_muscle(muscle);
    let per_pressure = move |contraction: f64| {
        let g = braid.shape_at(contraction)?;
        let bore = (g.r * g.r - braid.section / g.l).sqrt();
        if bore.is_nan() || bore == 0.0 {
            return Err(braid.no_shape(contraction));
        }
        let bore_l = (2.0 * g.r * g.r1 + braid.section / (g.l * g.l)) / (2.0 * bore);
        let sin2 = 1.0 - g.cos * g.cos;
        let cot2 = g.cos * g.cos / sin2;
        let cot2_l = 2.0 * g.cos * braid.cos / (sin2 * sin2);
        let both = g.r * bore;
        let both_l = g.r1 * bore + g.r * bore_l;
        Ok(PerPressure {
            f: 2.0 * PI * both * cot2 - PI * bore * bore,
            f_l: 2.0 * PI * (both_l * cot2 + both * cot2_l - bore * bore_l),
            volume_mm3: PI * bore * bore * (1.0 - contraction) * braid.length,
            diameter_mm: 2.0 * g.r,
            tension: Some(2.0 * PI * both * cot2 / g.cos),
        })
    };
    proportional(info, per_pressure)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Ideal, ModelError, Workspace};

    #[test]
    fn at_rest_it_is_the_closed_form() {
        let m = Muscle::prototype();
        let (d, di) = (m.outer_diameter_mm(), m.inner_diameter_mm());
        let cot2 = m.braid().angle_rad().tan().powi(-2);
        let expected = PI / 4.0 * 0.2 * (2.0 * d * di * cot2 - di * di);
        assert!(
            (build(&m)
                .unwrap()
                .force_n(&mut Workspace::new(), 0.2, 0.0)
                .unwrap()
                - expected)
                .abs()
                < 1e-9
        );
    }

    #[test]
    fn without_a_wall_it_is_the_ideal_formula() {
        let thin = Muscle::prototype().with_section(30.0, 1e-9).unwrap();
        let (a, b) = (build(&thin).unwrap(), Ideal::between_ends(&thin));
        for e in [0.0, 0.15, 0.3] {
            let (a, b) = (
                a.response(&mut Workspace::new(), 0.2, e).unwrap(),
                b.response(&mut Workspace::new(), 0.2, e).unwrap(),
            );
            assert!((a.force_n - b.force_n).abs() < 1e-6);
            assert!((a.braid_tension_n.unwrap() - b.braid_tension_n.unwrap()).abs() < 1e-6);
        }
    }

    #[test]
    fn a_closed_bore_is_an_error() {
        let thick = Muscle::prototype().with_section(30.0, 14.9).unwrap();
        assert!(matches!(
            build(&thick)
                .unwrap()
                .force_n(&mut Workspace::new(), 0.2, -0.1),
            Err(ModelError::Geometry { .. })
        ));
    }
}
