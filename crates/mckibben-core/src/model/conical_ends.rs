//! A cylinder between two cones: the ends taper from the terminal to the bulge.
//!
//!   F = π r0² P {−1 + (2λ/tan²θ0) [λ + (kc ε/3)(1/f − 4)]},   f = r/r0 = √(1 − cos²θ0 λ²)/sinθ0
//!
//! Each cone has the length kc L0 ε and grows from r0 to r. Source: Tondu (2012) \[tondu2012\] eq.
//! (25), as it is there: pressure on the plugs π r0², and the work of the lateral surface at fixed
//! lengths.
//!
//! That is not −P dV/dL of the same body, V = π r0² L0 [f² λ + (2kc ε/3)(1 + f − 2f²)], which gives
//!
//!   F = π r0² P {−f² + (2kc/3)(1 + f − 2f²) + (2λ/tan²θ0) [λ + (kc ε/3)(1/f − 4)]}
//!
//! The published form leaves out that the cones are pressed on axially too: with kc = 0 it does not
//! become the ideal formula but pulls π (r² − r0²) P more.

use super::{
    ForceModel, ModelEntry, ModelError, ModelInfo, ModelRange, Result,
    pantograph::Pantograph,
    proportional::{PerPressure, proportional},
};
use crate::muscle::Muscle;
use std::f64::consts::PI;

pub const ENTRY: ModelEntry = ModelEntry {
    name: "conical-ends",
    description: "cylinder between two cones (Tondu 2012)",
    source: "Tondu 2012 [tondu2012] eq. (25)",
};

/// Tondu's cylinder with conical ends, as published, of a muscle whose cone factor kc is known.
///
/// # Errors
/// [`ModelError::Missing`] without a cone factor. Tips that would meet before the largest
/// contraction, kc > (1 − ε_max)/(2 ε_max), are refused with the muscle already.
pub fn build(muscle: &Muscle) -> Result<Box<dyn ForceModel>> {
    let kc = muscle.terminals().cone_factor.ok_or(ModelError::Missing {
        model: ENTRY.name,
        missing: "a cone factor: `cone_factor = 0.4` under [model.conical-ends] in the muscle file",
        key: "model.conical-ends.cone_factor",
    })?;
    let range = ModelRange {
        contraction: (0.0, muscle.max_ideal_contraction()),
        ..ModelRange::open()
    };
    let info = ModelInfo {
        range,
        ..ModelInfo::new(&ENTRY, muscle)
    };
    let braid = Pantograph::from_muscle(muscle);
    let per_pressure = move |contraction: f64| {
        let g = braid.shape_at(contraction)?;
        if contraction > 0.0 && g.l <= 2.0 * kc * contraction {
            return Err(ModelError::Geometry {
                contraction,
                lowest: 1.0 - 1.0 / braid.cos,
                highest: 1.0 / (1.0 + 2.0 * kc),
            });
        }
        let r0 = braid.r0;
        let f = g.r / r0;
        let f1 = g.r1 / r0;
        let cot2 = (braid.cos / braid.sin).powi(2);
        let k3 = kc / 3.0;
        let inner = g.l + k3 * contraction * (1.0 / f - 4.0);
        let inner_l = 1.0 - k3 * (1.0 / f - 4.0) - k3 * contraction * f1 / (f * f);
        let area = PI * r0 * r0;
        let l = 1.0 - contraction;
        let ends = 2.0 * kc * (1.0 - l) / 3.0 * (1.0 + f - 2.0 * f * f);
        Ok(PerPressure {
            f: area * (2.0 * g.l * cot2 * inner - 1.0),
            f_l: area * 2.0 * cot2 * (inner + g.l * inner_l),
            volume_mm3: Some(PI * r0 * r0 * braid.length * (f * f * l + ends)),
            diameter_mm: 2.0 * f * r0,
            tension: None,
        })
    };
    proportional(info, per_pressure)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        model::{Ideal, Workspace},
        muscle::Terminals,
    };

    fn model(cone_factor: Option<f64>) -> Result<Box<dyn ForceModel>> {
        let terminals = Terminals {
            cone_factor,
            ..Terminals::default()
        };
        build(&Muscle::prototype().with_terminals(terminals).unwrap())
    }

    #[test]
    fn at_rest_the_ends_do_nothing() {
        let ideal = Ideal::between_ends(&Muscle::prototype())
            .force_n(&mut Workspace::new(), 0.2, 0.0)
            .unwrap();
        for kc in [0.0, 0.3, 0.6] {
            assert!(
                (model(Some(kc))
                    .unwrap()
                    .force_n(&mut Workspace::new(), 0.2, 0.0)
                    .unwrap()
                    - ideal)
                    .abs()
                    < 1e-9 * ideal
            );
        }
    }

    #[test]
    fn without_cones_the_published_form_exceeds_the_ideal_one_by_the_annulus() {
        let (m, cones) = (Muscle::prototype(), model(Some(0.0)).unwrap());
        for e in [0.1, 0.3] {
            let ideal = Ideal::between_ends(&m)
                .force_n(&mut Workspace::new(), 0.2, e)
                .unwrap();
            let r = 0.5 * m.pantograph_diameter_mm(e);
            let annulus = 0.2 * PI * (r * r - 15.0 * 15.0);
            assert!(
                (cones.force_n(&mut Workspace::new(), 0.2, e).unwrap() - ideal - annulus).abs()
                    < 1e-9
            );
        }
    }

    #[test]
    fn the_cone_factor_is_required_and_bounded() {
        assert!(matches!(model(None), Err(ModelError::Missing { .. })));
        let e_max = Muscle::prototype().max_ideal_contraction();
        let largest = (1.0 - e_max) / (2.0 * e_max);
        assert!(model(Some(largest)).is_ok());
        let terminals = Terminals {
            cone_factor: Some(largest + 1e-6),
            ..Terminals::default()
        };
        let refused = Muscle::prototype().with_terminals(terminals);
        assert!(
            refused
                .unwrap_err()
                .to_string()
                .contains("the two tips touch")
        );
    }
}
