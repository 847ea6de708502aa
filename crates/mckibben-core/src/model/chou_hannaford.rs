//! Chou and Hannaford's correction for the wall: it takes room, and its thickness stays.
//!
//!   F = (π D90²/4) P (3cos²θ − 1) + π P [s D90 (2 sinθ − 1/sinθ) − s²],   D90 = D0/sinθ0,  cosθ = (1−ε) cosθ0
//!     = −P dV/dL,   V = π (r − s)² L
//!
//! Source: Chou & Hannaford (1996) \[chou1996\], whose text was not at hand: the formula is taken
//! from Tondu's review (2012) \[tondu2012\] and agrees with the volume above.

use super::{
    ForceModel, ModelEntry, ModelInfo, Result,
    pantograph::Pantograph,
    proportional::{PerPressure, proportional},
};
use crate::muscle::Muscle;
use std::f64::consts::PI;

pub const ENTRY: ModelEntry = ModelEntry {
    name: "chou-hannaford",
    description: "ideal muscle inside of a wall of constant thickness",
    source: "Chou & Hannaford 1996 [chou1996], as given by Tondu 2012 [tondu2012]",
};

/// The ideal muscle whose pressure acts inside of a wall of constant thickness s.
///
/// The rubber carries nothing, though it would: at ε = 0 and strands that do not stretch a real
/// muscle pulls as if the pressure acted on the outer diameter. So this formula pulls too little at
/// small contractions.
pub fn build(muscle: &Muscle) -> Result<Box<dyn ForceModel>> {
    let info = ModelInfo::new(&ENTRY, muscle);
    let braid = Pantograph::from_muscle(muscle);
    let wall_mm = muscle.wall_mm();
    let per_pressure = move |contraction: f64| {
        let g = braid.shape_at(contraction)?;
        let bore = g.r - wall_mm;
        if bore <= 0.0 {
            return Err(braid.no_shape(contraction));
        }
        Ok(PerPressure {
            f: -PI * (bore * bore + 2.0 * bore * g.r1 * g.l),
            f_l: -2.0 * PI * (2.0 * bore * g.r1 + g.r1 * g.r1 * g.l + bore * g.r2 * g.l),
            volume_mm3: PI * bore * bore * (1.0 - contraction) * braid.length,
            diameter_mm: 2.0 * g.r,
            tension: None,
        })
    };
    proportional(info, per_pressure)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Ideal, Workspace};

    #[test]
    fn it_is_the_published_formula() {
        let m = Muscle::prototype();
        let model = build(&m).unwrap();
        let (p, s, d90) = (
            0.2,
            m.wall_mm(),
            m.outer_diameter_mm() / m.braid().angle_rad().sin(),
        );
        for e in [-0.02, 0.0, 0.1, 0.3] {
            let cos = (1.0 - e) * m.braid().angle_rad().cos();
            let sin = (1.0 - cos * cos).sqrt();
            let published = PI * d90 * d90 / 4.0 * p * (3.0 * cos * cos - 1.0)
                + PI * p * (s * d90 * (2.0 * sin - 1.0 / sin) - s * s);
            let force = model.force_n(&mut Workspace::new(), p, e).unwrap();
            assert!(
                (force - published).abs() < 1e-10 * published.abs().max(1.0),
                "{force} {published}"
            );
        }
    }

    #[test]
    fn without_a_wall_it_is_the_ideal_formula() {
        let thin = Muscle::prototype().with_section(30.0, 1e-9).unwrap();
        let (a, b) = (build(&thin).unwrap(), Ideal::between_ends(&thin));
        for e in [0.0, 0.15, 0.3] {
            assert!(
                (a.force_n(&mut Workspace::new(), 0.2, e).unwrap()
                    - b.force_n(&mut Workspace::new(), 0.2, e).unwrap())
                .abs()
                    < 1e-6
            );
        }
    }
}
