//! A stroke between two pressures, and what it costs in air.

use super::{Balance, Load};
use crate::analysis::ATMOSPHERE_MPA;
use serde::Serialize;

/// From one equilibrium to another and back: filled from the lower pressure to the higher, vented
/// again.
///
/// Slow and at one temperature. With p = P + p_a absolute and V the cavity, a filling takes
/// Δ(pV)/p_a of air at atmospheric pressure.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Cycle {
    /// Lower pressure in MPa.
    pub from_pressure_mpa: f64,
    /// Higher pressure in MPa.
    pub to_pressure_mpa: f64,
    /// How far the load moves, mm.
    pub stroke_mm: f64,
    /// Work on the load, J.
    pub work_j: f64,
    /// Air of a filling, normal litres (0 °C, 101.325 kPa), where the model knows the cavity.
    pub air_normal_litres: Option<f64>,
}

/// The stroke between two equilibria of one muscle; `low` with its pressure, contraction and volume
/// there (those at rest length where the load is not lifted).
pub fn cycle(load: &Load, length_mm: f64, low: (f64, f64, Option<f64>), high: &Balance) -> Cycle {
    let (from_pressure_mpa, from_contraction, volume) = low;
    let there = &high.answer.response;
    let work_j = load.energy_j(high.shortening_mm) - load.energy_j(from_contraction * length_mm);
    // mm³ at atmospheric pressure
    let air = there.volume_mm3.zip(volume).map(|(v, v0)| {
        ((there.pressure_mpa + ATMOSPHERE_MPA) * v - (from_pressure_mpa + ATMOSPHERE_MPA) * v0)
            / ATMOSPHERE_MPA
    });
    Cycle {
        from_pressure_mpa,
        to_pressure_mpa: there.pressure_mpa,
        stroke_mm: high.shortening_mm - from_contraction * length_mm,
        work_j,
        air_normal_litres: air.map(crate::analysis::normal_litres),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        analysis::{Evaluation, Options},
        model::{ForceModel, Ideal, Workspace},
        muscle::Muscle,
    };

    /// ∫P dV of an ideal muscle is the work on the load: between two equilibria of a weight, P =
    /// F/A(ε) along the way.
    #[test]
    fn identity_the_work_of_an_ideal_muscle_is_that_of_its_pressure() {
        let (model, w) = (
            Ideal::between_ends(&Muscle::prototype()),
            &mut Workspace::new(),
        );
        let load = Load::Mass {
            mass_kg: 10.0,
            level: false,
        };
        let at = |p: f64, w: &mut Workspace| {
            Evaluation::new(&model, w, Options::default())
                .balances(&load, p)
                .unwrap()
                .remove(0)
        };
        let (low, high) = (at(0.1, w), at(0.3, w));
        let r = low.answer.response;
        let cycle = super::cycle(&load, 285.0, (0.1, r.contraction, r.volume_mm3), &high);
        assert!((cycle.work_j - 1e-3 * 98.0665 * cycle.stroke_mm).abs() < 1e-9);
        // ∫P dV by the rule of Simpson over the way of the weight.
        let n = 200;
        let (a, b) = (r.contraction, high.answer.response.contraction);
        let power = |e: f64, w: &mut Workspace| {
            let p = 98.0665 / model.pull(1.0, e);
            p * model
                .response(w, p, e)
                .unwrap()
                .volume_per_contraction_mm3
                .unwrap()
        };
        let h = (b - a) / n as f64;
        let sum: f64 = (0..=n)
            .map(|i| {
                let weight = if i == 0 || i == n {
                    1.0
                } else if i % 2 == 1 {
                    4.0
                } else {
                    2.0
                };
                weight * power(a + h * i as f64, w)
            })
            .sum();
        assert!((1e-3 * sum * h / 3.0 / cycle.work_j - 1.0).abs() < 1e-9);
    }
}
