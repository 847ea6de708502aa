//! Charge and discharge of a rigid vessel through a valve after ISO 6358.
//!
//! C 0.5 L/(s bar), b 0.3, V 0.2 L, supply 6 bar above the atmosphere, 20 °C. With x = p/p_s and k
//! = R T0 ρ0 C/V the charge at constant temperature is x = x0 + k t as long as it is choked (x ≤
//! b), then x = b + (1 − b) sin(k (t − t_b)/(1 − b)); without heat it ends at T = T0 κ/(1 + (κ − 1)
//! x0). A choked discharge is an exponential of time, or a power without heat.

use super::{driven, ran, rows::Rows};
use mckibben_core::{
    extremes::peak,
    model::{ForceModel, ModelEntry, ModelError, ModelInfo, Response, Workspace},
    muscle::Muscle,
};
use mckibben_motion::{
    ATMOSPHERE_MPA, Actuated, Actuator, Air, Drive, Fluid, Heat, Motion, Orifice, SingleMuscle,
    Valve,
};

/// The supply's absolute pressure in MPa.
const SUPPLY_MPA: f64 = 0.6 + ATMOSPHERE_MPA;
/// k in 1/s: 287 J/(kg K) · 293.15 K · 1.185 kg/m³ · 0.5e-8 m³/(s Pa) / 0.2e-3 m³, from the design
/// note.
const RATE_PER_S: f64 = 2.492_905;
const CRITICAL: f64 = 0.3;

/// A vessel of a fixed volume, which does not pull.
#[derive(Debug, Clone)]
pub struct Vessel {
    info: ModelInfo,
    /// Volume in mm³.
    pub volume_mm3: Option<f64>,
}

impl Default for Vessel {
    fn default() -> Self {
        let entry = ModelEntry {
            name: "vessel",
            description: "a rigid vessel",
            source: "a rigid vessel",
        };
        // Something that has a length.
        Self {
            info: ModelInfo::new(&entry, &Muscle::prototype()),
            volume_mm3: Some(0.2e6),
        }
    }
}

impl ForceModel for Vessel {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn response(&self, _: &mut Workspace, p: f64, e: f64) -> Result<Response, ModelError> {
        Ok(Response {
            pressure_mpa: p,
            contraction: e,
            volume_mm3: self.volume_mm3,
            stiffness_n_per_mm: Some(1.0),
            force_per_pressure_mm2: Some(0.0),
            volume_per_pressure_mm3_per_mpa: Some(0.0),
            volume_per_contraction_mm3: Some(0.0),
            ..Response::default()
        })
    }
}

/// The vessel after a time in s with its valve open to the supply (1) or to the atmosphere (−1),
/// from a gauge pressure in MPa.
pub fn after(heat: Heat, opening: f64, from_mpa: f64, until_s: f64) -> Option<Motion> {
    let model = Vessel::default();
    let held = SingleMuscle::held(&model);
    let valve = Valve::new(Orifice::new(0.5, CRITICAL).ok()?);
    let mut muscle = Actuated::new(model.clone(), Actuator::Valve(valve));
    muscle.fluid = Fluid::Air(Air {
        heat,
        ..Air::default()
    });
    muscle.initial_pressure_mpa = Some(from_mpa);
    let drive = driven(&held, muscle, super::opening(opening), (until_s, 1e-11));
    ran(&Drive {
        output_step_s: until_s,
        ..drive
    })
}

/// Absolute pressure in MPa at the end of a motion.
pub fn pressure(motion: Option<&Motion>) -> Option<f64> {
    Some(motion?.series.muscles.first()?.pressure_mpa.last()? + ATMOSPHERE_MPA)
}

/// Temperature in K at the end of a motion.
fn temperature(motion: Option<Motion>) -> Option<f64> {
    motion?
        .series
        .muscles
        .first()?
        .temperature_k
        .last()
        .copied()
}

/// Charges and discharges.
pub fn vessel(rows: &mut Rows) {
    let from = ATMOSPHERE_MPA / SUPPLY_MPA;
    let choked_s = (CRITICAL - from) / RATE_PER_S;
    let mut row = |name: &str, reference: f64, ours: Option<f64>, tolerance| {
        rows.add(format!("vessel: {name}"), reference, ours, tolerance);
    };
    // The standard's flow up to 0.99 p_s; beyond it the linear range about equal pressures.
    let late_s = choked_s + (1.0 - CRITICAL) * (0.69_f64 / 0.7).asin() / RATE_PER_S;
    let charge = |heat, until_s| after(heat, 1.0, 0.0, until_s);
    let discharge = |heat, until_s| after(heat, -1.0, 0.6, until_s);
    let p = |motion: Option<Motion>| pressure(motion.as_ref());
    let warm = charge(Heat::Adiabatic, 2.0);
    let cold = discharge(Heat::Adiabatic, 0.2);
    let warm_k = 293.15 * 1.4 / (1.0 + 0.4 * from);
    let choked = p(charge(Heat::Isothermal, choked_s));
    let late = p(charge(Heat::Isothermal, late_s));
    let polytropic = temperature(charge(Heat::Polytropic(1.4), 2.0));
    let out = p(discharge(Heat::Isothermal, 0.1));
    row(
        "p at the end of the choked charge (MPa)",
        CRITICAL * SUPPLY_MPA,
        choked,
        1e-6,
    );
    row(
        "p of the charge at 0.99 p_s (MPa)",
        0.99 * SUPPLY_MPA,
        late,
        1e-6,
    );
    row(
        "p of the adiabatic charge at its end (MPa)",
        SUPPLY_MPA,
        pressure(warm.as_ref()),
        1e-7,
    );
    row(
        "T of the adiabatic charge at its end (K)",
        warm_k,
        temperature(warm),
        1e-6,
    );
    row(
        "T of a polytropic charge with n = κ (K)",
        warm_k,
        polytropic,
        1e-6,
    );
    row(
        "p of the isothermal discharge after 0.1 s (MPa)",
        0.546_580_1,
        out,
        2e-7,
    );
    row(
        "p of the adiabatic discharge after 0.2 s (MPa)",
        0.360_541_2,
        pressure(cold.as_ref()),
        2e-7,
    );
    row(
        "T of the adiabatic discharge after 0.2 s (K)",
        242.397_8,
        temperature(cold),
        2e-7,
    );
}

/// What charges with each kind of heat lose of air and energy.
pub fn balances(rows: &mut Rows) {
    let heats = [
        Heat::Isothermal,
        Heat::Polytropic(1.2),
        Heat::Adiabatic,
        Heat::Transfer(30.0),
    ];
    let motions: Option<Vec<Motion>> = heats
        .into_iter()
        .map(|heat| after(heat, 1.0, 0.0, 0.3))
        .collect();
    let largest =
        |value: fn(&Motion) -> f64| Some(peak(motions.as_ref()?.iter().map(value).map(f64::abs)));
    let energy = largest(|m| {
        let e = m.energies;
        (e.enthalpy_in_j - e.enthalpy_out_j + e.heat_j - e.internal_j - e.gas_work_j)
            / e.enthalpy_in_j
    });
    let air = largest(|m| m.mass_defect);
    let name = "vessel: air that is lost, of that in it";
    rows.add(name, 0.0, air, 1e-12);
    let name = "vessel: energy that is lost, of the enthalpy";
    rows.add(name, 0.0, energy, 1e-7);
}
