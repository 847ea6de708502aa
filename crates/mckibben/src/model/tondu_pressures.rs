//! Smallest and largest sensible pressure of a muscle, at its largest ideal contraction.
//!
//!   P_min = G · h0/(1−h0) · (1/λ)(1 − 1/(λ1⁴ λ²)),   P_max = σb · h0/(1−h0) / (λ1² λ)
//!   h0 = s/r0,   λ = 1 − ε_max,   λ1 = ri/(r0 − s) (stretch of the bore)
//!
//! P_min is what it takes to blow up a thin tube of shear modulus G to its largest contraction; at P_max the tube, were
//! it alone, would reach the strength σb of its rubber (true stress). Source: Tondu (2012) \[tondu2012\] eqs. (23), (24).

use super::ModelError;
use super::pantograph::Pantograph;
use crate::muscle::Muscle;
use crate::rubber::RubberLaw;

/// h0/(1−h0), λ and λ1² at the largest ideal contraction.
fn at_largest_contraction(muscle: &Muscle) -> Result<(f64, f64, f64), ModelError> {
    let braid = Pantograph::of(muscle);
    let contraction = muscle.max_ideal_contraction();
    let shape = braid.at(contraction)?;
    let bore = braid.bore(&shape, contraction)?;
    let ri = muscle.tube().inner_radius_mm();
    Ok((muscle.wall_mm() / ri, shape.l, (bore.r / ri).powi(2)))
}

/// Smallest pressure in MPa (23), with the shear modulus of the muscle's rubber at rest.
///
/// # Errors
/// [`ModelError::Geometry`] where the wall is so thick that the bore would close.
pub fn smallest_pressure_mpa(muscle: &Muscle) -> Result<f64, ModelError> {
    let (wall, l, bore2) = at_largest_contraction(muscle)?;
    let g = muscle.rubber().law.shear_modulus_mpa();
    Ok(g * wall / l * (1.0 - 1.0 / (bore2 * bore2 * l * l)))
}

/// Largest pressure in MPa (24) for a rubber that breaks at a true stress of `strength_mpa`.
pub fn largest_pressure_mpa(muscle: &Muscle, strength_mpa: f64) -> Result<f64, ModelError> {
    let (wall, l, bore2) = at_largest_contraction(muscle)?;
    Ok(strength_mpa * wall / (bore2 * l))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::muscle::{Braid, Rubber, Tube};
    use crate::rubber::{Law, NeoHookean};

    fn muscle(angle_deg: f64) -> Muscle {
        let rubber = Rubber::of(Law::NeoHookean(NeoHookean { mu_mpa: 0.54 }));
        let tube = Tube::new(20.0, 1.0, 300.0, rubber);
        let braid = Braid { angle_deg, ..Braid::paper() };
        Muscle::prototype().with_tube(tube).and_then(|m| m.with_braid(braid)).unwrap()
    }

    /// Tondu (2012) \[tondu2012\]: h0 = .1, G = .54 MPa.
    #[test]
    fn smallest_pressures_of_tondu() {
        for (angle, bar) in [(20.0, 0.92), (30.0, 0.67)] {
            let p = 10.0 * smallest_pressure_mpa(&muscle(angle)).unwrap();
            assert!((p - bar).abs() < 0.005, "{angle}°: {p} bar");
        }
    }

    #[test]
    fn strength_by_shear_modulus_gives_their_ratio() {
        let m = muscle(20.0);
        let (_, l, bore2) = at_largest_contraction(&m).unwrap();
        let ratio = largest_pressure_mpa(&m, 0.54).unwrap() / smallest_pressure_mpa(&m).unwrap();
        assert!((ratio - 1.0 / (bore2 * (1.0 - 1.0 / (bore2 * bore2 * l * l)))).abs() < 1e-12);
    }
}
