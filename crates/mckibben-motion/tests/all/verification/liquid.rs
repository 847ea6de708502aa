//! Liquids: a rigid vessel on a valve and on a pump, and a muscle on a syringe and with the liquid
//! shut in against the static filling of the same muscle ([`mckibben_core::load::fill`]), which solves
//! for the volume, without equations of motion.
//!
//! With Q = a⁻¹ … of a restriction Δp = a Q² + b Q, and K = V dp/dV of the liquid in a vessel V,
//! the time from Q0 to Q1 is t = (V/K) (2 a (Q0 − Q1) + b ln(Q0/Q1)).

use super::{Vessel, driven, opening, ran, rows::Rows};
use mckibben_core::{
    analysis::{Evaluation, Options},
    liquid::Liquid,
    load::{Fill, Filling, Load},
    model::{ThickWall, Workspace},
    muscle::Muscle,
};
use mckibben_motion::{
    ATMOSPHERE_MPA, Actuated, Actuator, Command, Commanded, Drive, Fluid, Linear, LiquidFill,
    LiquidValve, Motion, Pump, Restriction, SingleMuscle, Syringe, ValveKind,
};
use std::f64::consts::TAU;

/// Bulk modulus of the vessel's liquid in MPa, so that its volume changes by less than 10⁻⁵.
const STIFF_MPA: f64 = 1e5;
/// Volume of the vessel in mm³.
const VOLUME_MM3: f64 = 0.2e6;
const KV_MM3_PER_S: f64 = 10.0;
const PUSHED_MM3: f64 = 60e3;
const DEAD_MM3: f64 = 50e3;

fn water(bulk_modulus_mpa: f64, dead_volume_mm3: f64) -> Option<Fluid> {
    Some(Fluid::Liquid(LiquidFill {
        liquid: Liquid::named("water", 0.0)
            .ok()?
            .with_bulk_modulus(bulk_modulus_mpa)
            .ok()?,
        temperature_k: 293.15,
        dead_volume_mm3,
    }))
}

/// The pressure of the vessel in MPa after a time, from none.
fn vessel(actuator: Actuator, until_s: f64) -> Option<f64> {
    let model = Vessel::default();
    let held = SingleMuscle::held(&model);
    let muscle = Actuated {
        fluid: water(STIFF_MPA, 0.0)?,
        initial_pressure_mpa: Some(0.0),
        ..Actuated::new(model.clone(), actuator)
    };
    let drive = driven(&held, muscle, opening(1.0), (until_s, 1e-10));
    ran(&Drive {
        output_step_s: until_s,
        ..drive
    })?
    .series
    .muscles
    .first()?
    .pressure_mpa
    .last()
    .copied()
}

/// A valve as wide in both directions.
fn valve() -> Option<Actuator> {
    let restriction = Restriction::new(KV_MM3_PER_S).ok()?;
    Some(Actuator::LiquidValve(LiquidValve {
        kind: ValveKind::DEFAULT,
        supply: restriction,
        tank: restriction,
        line: None,
    }))
}

/// Time in s in which 0.6 MPa before the valve become 0.15 MPa.
fn throttled_s() -> f64 {
    // Δp = a Q² + b Q at 1 bar and Kv, with the laminar term of a thousandth.
    let square = 0.1 * 0.9982 / KV_MM3_PER_S.powi(2);
    let linear = 1e-3 * square * KV_MM3_PER_S;
    let flow = |p: f64| ((linear * linear + 4.0 * square * p).sqrt() - linear) / (2.0 * square);
    let fast = flow(0.6);
    let slow = flow(0.15);
    VOLUME_MM3 / STIFF_MPA * (2.0 * square * (fast - slow) + linear * (fast / slow).ln())
}

/// The muscle with 10 kg of both comparisons.
struct Hanging {
    model: ThickWall,
    load: Load,
}

impl Hanging {
    fn new() -> Self {
        Self {
            model: ThickWall::between_ends(&Muscle::prototype()),
            load: Load::Mass {
                mass_kg: 10.0,
                level: false,
            },
        }
    }

    /// Where the volume of the syringe brings it; the rest in the syringe counts as dead volume.
    fn filled(&self) -> Option<Fill> {
        let liquid = Liquid::named("water", 0.0).ok()?;
        let filling = Filling {
            liquid: &liquid,
            volume_mm3: PUSHED_MM3,
            dead_volume_mm3: 2.0 * DEAD_MM3,
            load: Some(&self.load),
            held_at: None,
        };
        Evaluation::new(&self.model, &mut Workspace::new(), Options::default())
            .fill(&filling)
            .ok()
    }

    fn load(&self) -> SingleMuscle {
        SingleMuscle {
            stops_mm: (0.0, 200.0),
            damping_n_s_per_m: 500.0,
            ..SingleMuscle::new(&self.model, self.load.clone())
        }
    }

    fn muscle(&self, actuator: Actuator, dead_mm3: f64) -> Option<Actuated> {
        Some(Actuated {
            fluid: water(2179.0, dead_mm3)?,
            ..Actuated::new(self.model.clone(), actuator)
        })
    }

    /// The muscle that a syringe fills within a second, at rest.
    fn pushed(&self) -> Option<Motion> {
        let load = self.load();
        let syringe = Syringe {
            volume_mm3: PUSHED_MM3 + DEAD_MM3,
            time_constant_s: 0.02,
        };
        let muscle = self.muscle(Actuator::Syringe(syringe), DEAD_MM3)?;
        let ramp = Command::Ramps(vec![(0.0, 0.0), (1.0, PUSHED_MM3)]);
        ran(&driven(
            &load,
            muscle,
            Commanded::Volume(vec![ramp]),
            (6.0, 1e-8),
        ))
    }

    /// Frequency in Hz with the valve shut at the pressure of the filling.
    fn hertz(&self, at: &Fill) -> Option<f64> {
        let load = SingleMuscle {
            damping_n_s_per_m: 0.0,
            ..self.load()
        };
        let mut muscle = self.muscle(valve()?, 2.0 * DEAD_MM3)?;
        muscle.initial_pressure_mpa = Some(at.answer.response.pressure_mpa);
        Some(
            Linear::new(&driven(&load, muscle, opening(0.0), (1.0, 1e-6)))
                .ok()?
                .oscillation()?
                .0,
        )
    }
}

/// What the filled muscle has at rest and its motion at the end, in the order of the rows.
fn compared() -> Option<[(f64, f64); 5]> {
    let hanging = Hanging::new();
    let filled = hanging.filled()?;
    let still = &filled.answer.response;
    let pushed = hanging.pushed()?;
    let muscle = pushed.series.muscles.first()?;
    let e = pushed.energies;
    let kept = e.enthalpy_in_j - e.enthalpy_out_j - e.internal_j - e.gas_work_j;
    Some([
        (still.pressure_mpa, *muscle.pressure_mpa.last()?),
        (still.contraction, *muscle.contraction.last()?),
        // Both ends of the filling's work against gauge pressure; the ramp is slow and the load
        // damped, so that the piston's work has more.
        (
            filled.pump_work_j,
            e.enthalpy_in_j
                - 1e-3 * ATMOSPHERE_MPA * pushed.liquid_volume_mm3?
                - (e.damper_j + e.kinetic_j + e.impacts_j),
        ),
        (
            (1e3 * filled.shut_stiffness_n_per_mm / 10.0).sqrt() / TAU,
            hanging.hertz(&filled)?,
        ),
        (0.0, kept / e.enthalpy_in_j),
    ])
}

/// A vessel on a valve and on a pump.
pub fn vessels(rows: &mut Rows) {
    let valve = valve().and_then(|valve| vessel(valve, throttled_s()));
    let pump = Pump {
        kind: ValveKind::DEFAULT,
        flow_mm3_per_s: 2.0,
        line: None,
    };
    let pumped = vessel(Actuator::Pump(pump), 0.3 * VOLUME_MM3 / (STIFF_MPA * 2.0));
    rows.add("liquid: p of a vessel on a valve (MPa)", 0.45, valve, 1e-5);
    rows.add("liquid: p of a vessel on a pump (MPa)", 0.3, pumped, 1e-5);
}

/// A muscle on a syringe, and with the liquid shut in.
pub fn filled(rows: &mut Rows) {
    let values = compared();
    let of_muscle = [
        ("p of a muscle on a syringe (MPa)", 1e-6),
        ("its contraction", 1e-6),
        ("work of its piston less what the damper took (J)", 1e-4),
        ("10 kg on the muscle with the liquid shut in (Hz)", 1e-4),
        ("energy that is lost, of the work of the piston", 1e-6),
    ];
    for (i, (name, tolerance)) in of_muscle.into_iter().enumerate() {
        if i == 4 {
            rows.source = "identity: what goes in, comes out and stays";
        }
        let (reference, ours) = values.map(|v| v[i]).unzip();
        rows.add(format!("liquid: {name}"), reference, ours, tolerance);
    }
}
