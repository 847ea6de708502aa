//! The answer to a drive.

use crate::{Event, MotionError, MotionSeries};
use mckibben_core::warning::sentence;
use serde::{Serialize, Serializer};

/// A motion.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
#[non_exhaustive]
pub struct Motion {
    /// What was recorded, lists of one length.
    pub series: MotionSeries,
    /// 10–90 % of the first step that moved it, s; of a commanded position this and what follows
    /// are against the set-point, else against where the step ended.
    #[serialize_always]
    pub rise_time_s: Option<f64>,
    /// Time until it stays within 2 % of its stroke, s.
    #[serialize_always]
    pub settling_time_s: Option<f64>,
    /// Overshoot beyond its end, as a share of its stroke.
    #[serialize_always]
    pub overshoot: Option<f64>,
    /// Time until the pressure is within 2 % of its first rise, s.
    #[serialize_always]
    pub fill_time_s: Option<f64>,
    /// Likewise of its first fall, s.
    #[serialize_always]
    pub vent_time_s: Option<f64>,
    /// Every step of the command that moved it.
    #[schemars(with = "Vec<serde_json::Value>")]
    #[doc(hidden)]
    pub steps: Vec<StepFigures>,
    /// Largest speed of a muscle's load, mm/s: of all that was integrated, not of the points of the
    /// series alone.
    pub largest_velocity_mm_per_s: Option<f64>,
    /// The same of a joint, °/s.
    pub largest_velocity_deg_per_s: Option<f64>,
    /// Whether it rests at the end, within 2 % of its stroke; none if the command still changes
    /// there, or both ends are fixed.
    #[serde(rename = "at_rest", serialize_with = "rests")]
    #[schemars(with = "Option<bool>")]
    #[serialize_always]
    pub end: Option<MotionEnd>,
    /// Where a muscle's load rests in the end under the commanded pressure, without friction.
    pub equilibrium_contraction: Option<f64>,
    /// Where a joint rests in the end under the commanded pressures, without friction, degrees.
    pub equilibrium_angle_deg: Option<f64>,
    /// Reason why the run stopped early; the series covers the computed part.
    #[serde(rename = "ended_early", serialize_with = "sentence")]
    #[schemars(with = "Option<String>")]
    pub ended: Option<MotionError>,
    /// Air from the supply, normal litres (0 °C, 101.325 kPa); 0 with a liquid.
    pub air_normal_litres: f64,
    /// Liquid from the supply, or pushed out of a syringe at the end, mm³ at atmospheric pressure.
    pub liquid_volume_mm3: Option<f64>,
    /// The same over the last whole period of a periodic command.
    pub air_normal_litres_per_cycle: Option<f64>,
    /// Energies, J.
    #[schemars(with = "serde_json::Value")]
    pub energies: Energies,
    /// Of commanded pressures: the poles about the state that the first step reaches (the mean of a
    /// periodic command), real and imaginary part, 1/s. One is 0 where the air's temperature does
    /// not change: that of its mass.
    pub poles_per_s: Vec<(f64, f64)>,
    /// Frequency |Im λ|/2π of the fastest pair of them, Hz.
    pub eigenfrequency_hz: Option<f64>,
    /// Natural frequency of load and muscle without damping at constant pressure, Hz.
    pub frequency_constant_pressure_hz: Option<f64>,
    /// The same with shut valves, Hz; none of a regulator, which has none.
    pub frequency_shut_hz: Option<f64>,
    /// Of commanded pressures: frequency up to which small changes about the state that the first
    /// step reaches (the mean of a periodic command) are followed (−3 dB), Hz; of two muscles of a
    /// joint, changes against each other. A valve lets air in and out half of the time each.
    pub bandwidth_hz: Option<f64>,
    /// The same while the (first) muscle is filled, Hz.
    pub bandwidth_filling_hz: Option<f64>,
    /// The same while it is vented, Hz.
    pub bandwidth_venting_hz: Option<f64>,
    /// What happened: ends of stroke, slack, valve switching, reversals.
    #[schemars(with = "Vec<serde_json::Value>")]
    pub events: Vec<Event>,
    /// Air mass that is missing, over what flowed: 0 but for rounding.
    #[serde(skip)]
    pub mass_defect: f64,
    /// The load lies on its lower stop all the time though the command moves: by how much it is too
    /// heavy ([`run_as_far`](crate::run_as_far)).
    #[serde(skip)]
    pub never_lifted: Option<MotionError>,
}

impl Motion {
    /// Whether it rests at the end, where it can.
    pub fn at_rest(&self) -> Option<bool> {
        self.end.map(MotionEnd::rests)
    }
}

impl MotionEnd {
    fn rests(self) -> bool {
        self.moves == Moves::Rests
    }
}

fn rests<S: Serializer>(end: &Option<MotionEnd>, serializer: S) -> Result<S::Ok, S::Error> {
    end.map(MotionEnd::rests).serialize(serializer)
}

/// The end of a motion whose command has become constant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionEnd {
    /// How the load moves over the last tenth of the time since the command became constant.
    #[doc(hidden)]
    pub moves: Moves,
    /// Between which coordinates it moves there, in mm or rad.
    pub between: (f64, f64),
}

/// How a load moves at the end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Moves {
    /// It stays within 2 % of its way (within 0.0001 of the muscle's length where that is more).
    Rests,
    /// It goes to and fro by more than that.
    Swings,
    /// It goes on in one direction by more than that.
    Creeps,
}

/// The answer to one step of the command, up to the next.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct StepFigures {
    /// When the command changed, in s.
    pub time_s: f64,
    /// The coordinate there.
    pub from: f64,
    /// The set-point of a commanded position, else the coordinate at the end of the piece.
    pub to: f64,
    /// From 10 % to 90 % of the way between them, in s.
    pub rise_time_s: Option<f64>,
    /// From the command until it stays within 2 % of the way, in s; `None` where it still moves at
    /// the end.
    pub settling_time_s: Option<f64>,
    /// Farthest beyond it, as a share of the way.
    pub overshoot: f64,
}

/// Energies of the whole run in J.
///
/// ```text
/// enthalpy_in − enthalpy_out + heat = Δ(m cv T) + gas_work
/// gas_work = stored + static_work + p_atm ΔV
/// static_work + viscoelastic − friction = Δload + Δkinetic + damper + impacts
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Energies {
    /// Enthalpy of the air from the supply; of a liquid p V and stored energy at the pressure of
    /// the muscle, of a syringe the work of its piston.
    pub enthalpy_in_j: f64,
    /// The same of the outflow.
    pub enthalpy_out_j: f64,
    /// Heat from the walls to the air.
    pub heat_j: f64,
    /// Growth of the air's internal energy m cv T, or of the energy stored in the liquid.
    pub internal_j: f64,
    /// ∫ p dV, absolute.
    pub gas_work_j: f64,
    /// What rubber and braid store more than at the start, as it follows from the other terms of
    /// the second line.
    pub stored_j: f64,
    /// ∫ F dx of the models' pull.
    pub static_work_j: f64,
    /// ∫ F_f dx: lost in braid friction.
    pub friction_j: f64,
    /// Work of the viscoelastic part of the pull; negative: lost.
    pub viscoelastic_j: f64,
    /// Lost in the damper.
    pub damper_j: f64,
    /// Lost in impacts on stops.
    pub impacts_j: f64,
    /// Growth of the load's potential energy, and work against a force or torque from outside.
    pub load_j: f64,
    /// Growth of the kinetic energy.
    pub kinetic_j: f64,
    /// Work of the muscles while they shorten, ∫ (F v)₊ dt.
    pub work_j: f64,
}
