//! The stiffness of a joint whose valves are shut: the air in each muscle stays, and pushes back.

use crate::{
    analysis::{ATMOSPHERE_MPA, HEAT_RATIO},
    model::Response,
};
use serde::Serialize;

/// −dτ/dφ with the valves shut, in N m/rad: at constant temperature for slow turns, without heat
/// exchange for quick ones.
///
/// The mass of air in a muscle stays, p Vⁿ = const with n = 1 (isothermal) or γ = 1.4 (adiabatic),
/// p absolute. With the pull F and the volume V at a pressure P and a shortening Δ of the muscle,
/// and a = dΔ/dφ,
///
///   dP/dφ = −n p V_Δ a / (V + n p V_P),   −dτ/dφ = K + Σ a² n p V_Δ F_P / (V + n p V_P).
///
/// V is the cavity of the muscle: hoses and fittings are not counted, and make the air softer. A
/// slack muscle adds nothing.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, schemars::JsonSchema)]
pub struct ShutStiffness {
    /// −dτ/dφ with the valves shut, the air at constant temperature, N m/rad; not known where the
    /// model has no volume.
    #[serde(rename = "stiffness_shut_isothermal_nm_per_rad")]
    pub isothermal_nm_per_rad: Option<f64>,
    /// The same without heat exchange, N m/rad.
    #[serde(rename = "stiffness_shut_adiabatic_nm_per_rad")]
    pub adiabatic_nm_per_rad: Option<f64>,
}

impl ShutStiffness {
    /// Of no air: zero.
    pub(super) const NONE: Self = Self {
        isothermal_nm_per_rad: Some(0.0),
        adiabatic_nm_per_rad: Some(0.0),
    };

    /// With −dτ/dφ at constant pressures.
    pub(super) fn over(self, stiffness_nm_per_rad: f64) -> Self {
        let whole = |air: Option<f64>| air.map(|air| air + stiffness_nm_per_rad);
        Self {
            isothermal_nm_per_rad: whole(self.isothermal_nm_per_rad),
            adiabatic_nm_per_rad: whole(self.adiabatic_nm_per_rad),
        }
    }

    /// Adds the air of a taut muscle of this length at an arm.
    pub(super) fn add(&mut self, response: &Response, length_mm: f64, arm_mm: f64) {
        let air = |n: f64| air_nm_per_rad(response, length_mm, arm_mm, n);
        let more = |k: Option<f64>, n: f64| Some(k? + air(n)?);
        self.isothermal_nm_per_rad = more(self.isothermal_nm_per_rad, 1.0);
        self.adiabatic_nm_per_rad = more(self.adiabatic_nm_per_rad, HEAT_RATIO);
    }
}

/// a² n p V_Δ F_P / (V + n p V_P) in N m/rad.
fn air_nm_per_rad(response: &Response, length_mm: f64, arm_mm: f64, n: f64) -> Option<f64> {
    let p = response.pressure_mpa + ATMOSPHERE_MPA;
    let by_shortening = response.volume_per_contraction_mm3? / length_mm;
    let pull = response.force_per_pressure_mm2.unwrap_or(by_shortening);
    let stores = response.volume_mm3? + n * p * response.volume_per_pressure_mm3_per_mpa?;
    (stores > 0.0).then(|| 1e-3 * arm_mm * arm_mm * n * p * by_shortening * pull / stores)
}
