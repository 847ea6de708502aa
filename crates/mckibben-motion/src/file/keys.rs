//! The keys of a drive file.

use super::command::Course;
use crate::valve::ValveKind;
use mckibben_core::{
    liquid::LIQUIDS,
    muscle::file::named,
    rubber::over_time::Prony,
    units::{
        Interval, NotNegative, Positive,
        typed::{
            Conductance, Damping, Flow, Force, Length, Mass, Pressure, Ratio, Temperature, Time,
            Torque, Volume,
        },
    },
};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;

/// A muscle or a joint with valve, air, load and command, for its motion; of a muscle the position
/// is a ratio, of a joint an angle.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DriveKeys<Position = Ratio> {
    /// Path of a muscle file, relative to this file
    #[serde(rename = "muscle")]
    _muscle: Option<String>,
    /// Path of a joint file, relative to this file
    #[serde(rename = "joint")]
    _joint: Option<String>,
    /// The air supply
    #[serde(default)]
    pub supply: OfSupply,
    /// A valve for each muscle
    pub valve: Option<OfValve>,
    /// An ideal regulator, in place of a valve
    pub regulator: Option<OfRegulator>,
    /// A pump of a liquid for each muscle, which runs both ways
    pub pump: Option<OfPump>,
    /// A syringe of a liquid for each muscle
    pub syringe: Option<OfSyringe>,
    /// The air in the muscle
    pub air: Option<OfAir>,
    /// A liquid in the muscle, in place of air
    pub liquid: Option<OfLiquid>,
    /// The load of a muscle
    pub load: Option<OfLoad>,
    /// Motion with the friction of the muscle
    #[serde(default)]
    pub friction: OfFriction,
    /// Viscoelasticity of the rubber
    #[serde(default)]
    pub rubber: OfRubber,
    /// The controller of a position
    pub controller: Option<OfController>,
    /// What is commanded: pressure, valve, volume or position
    pub command: OfCommand<Position>,
    /// Where it starts, at rest; else where its first commands hold it
    pub start: Option<OfStart<Position>>,
    /// A force or torque from outside
    #[serde(default)]
    pub external: OfExternal,
    /// Name, for people
    #[serde(rename = "name")]
    _name: Option<String>,
    /// Notes, for people
    #[serde(rename = "notes")]
    _notes: Option<String>,
}

#[derive(Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct OfSupply {
    /// Gauge pressure of the supply, or of a pump's relief valve
    pub pressure: Option<Positive<Pressure>>,
    /// Temperature of the air and of the walls
    pub temperature: Option<Temperature>,
}

/// How a valve or a pump opens.
#[derive(Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Opens {
    Proportional,
    OnOff,
}

/// Where the command of a pressure opens a proportional valve wide, in MPa, and half of an on–off
/// valve's dead band.
const WIDE_OPEN_MPA: f64 = 0.05;
const HYSTERESIS_MPA: f64 = 0.005;

/// A table with what a valve and a pump have in common.
macro_rules! with_opening {
    ($(#[$about:meta])* struct $name:ident { $($own:tt)* }) => {
        $(#[$about])*
        #[derive(Deserialize, JsonSchema)]
        #[serde(deny_unknown_fields)]
        pub struct $name {
            $($own)*
            /// How it opens
            pub kind: Option<Opens>,
            /// Time constant of a proportional valve
            pub lag: Option<Time>,
            /// Error of the pressure at which a proportional valve is wide open
            pub wide_open_at: Option<Positive<Pressure>>,
            /// Half of the dead band of an on-off valve
            pub hysteresis: Option<Positive<Pressure>>,
            /// Whether an on-off valve has a closed centre
            pub closed_centre: Option<bool>,
            /// Length of the hose to the muscle
            pub hose_length: Option<Positive<Length>>,
            /// Its inner diameter
            pub hose_diameter: Option<Positive<Length>>,
        }

        impl $name {
            /// How it moves.
            pub fn moves(&self) -> ValveKind {
                match self.kind {
                    Some(Opens::OnOff) => ValveKind::OnOff {
                        hysteresis_mpa: self.hysteresis.map_or(HYSTERESIS_MPA, f64::from),
                        closed_centre: self.closed_centre.unwrap_or(true),
                    },
                    Some(Opens::Proportional) | None => ValveKind::Proportional {
                        time_constant_s: self.lag.unwrap_or_default().0,
                        gain_per_mpa: 1.0 / self.wide_open_at.map_or(WIDE_OPEN_MPA, f64::from),
                    },
                }
            }
        }
    };
}

with_opening! {
    struct OfValve {
        /// Name of a valve on sale
        #[schemars(schema_with = "valves")]
        pub name: Option<String>,
        /// Sonic conductance C (ISO 6358)
        pub sonic_conductance: Option<Positive<Conductance>>,
        /// Critical pressure ratio b
        #[schemars(range(min = 0, max = 1))]
        pub critical_ratio: Option<f64>,
        /// C of the way out
        pub exhaust_conductance: Option<Positive<Conductance>>,
        /// b of the way out
        #[schemars(range(min = 0, max = 1))]
        pub exhaust_critical_ratio: Option<f64>,
        /// Of a liquid: flow coefficient Kv, the flow of water at 1 bar
        pub flow_coefficient: Option<Positive<Flow>>,
        /// Kv of the way out
        pub return_coefficient: Option<Positive<Flow>>,
    }
}

with_opening! {
    struct OfPump {
        /// Largest flow; the supply's pressure is that of its relief valve
        pub flow: Positive<Flow>,
    }
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OfRegulator {
    /// Time constant with which it follows its command
    pub time_constant: Positive<Time>,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OfSyringe {
    /// What it holds; it is full at the start
    pub volume: Positive<Volume>,
    /// Time constant with which its piston follows
    pub time_constant: Option<Positive<Time>>,
}

#[derive(Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct OfAir {
    /// Volume beside the muscle
    pub dead_volume: Volume,
    /// Exchange of heat: a word, or a coefficient such as "25 W/(m2 K)"
    #[schemars(schema_with = "heats")]
    pub heat: Option<String>,
    /// Polytropic index, in place of heat
    #[schemars(range(min = 1, max = 1.4))]
    pub polytropic_index: Option<f64>,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OfLiquid {
    /// The liquid
    #[schemars(schema_with = "liquids")]
    pub name: String,
    /// Its bulk modulus, in place of that of the table
    pub bulk_modulus: Option<Positive<Pressure>>,
    /// Gas in it by volume at atmospheric pressure
    #[serde(default)]
    pub gas_share: Ratio,
    /// Volume beside the muscle, without hose and syringe
    #[serde(default)]
    pub dead_volume: Volume,
}

#[derive(Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct OfLoad {
    /// Mass that hangs from the muscle
    pub mass: Option<Positive<Mass>>,
    /// Whether the mass slides on a level track
    pub level: Option<bool>,
    /// A load such as "spring:2N/mm@50N", "lever:5kg@300mm/40mm" or "table:load.csv"
    pub line: Option<String>,
    /// Damper
    pub damping: Option<Damping>,
    /// Lowest and highest shortening, such as "0..80 mm"
    pub stops: Option<Interval<Length>>,
    /// Contraction at which both ends are held, in place of a load
    pub held: Option<Ratio>,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OfStart<Position> {
    /// Contraction, or angle of a joint
    pub position: Option<Position>,
    /// Pressures, one for each muscle
    #[serde(default)]
    pub pressures: Vec<Pressure>,
}

#[derive(Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct OfExternal {
    /// Of a muscle: force that stretches it, or pairs of times and forces
    pub force: Option<Course<Force>>,
    /// Of a joint: torque that turns it to +, or pairs of times and torques
    pub torque: Option<Course<Torque>>,
}

#[derive(Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct OfFriction {
    /// C of the friction C P^β in N/MPa^β, in place of the muscle's
    pub coefficient: Option<NotNegative<f64>>,
    /// Over which length the friction builds up after a reversal
    pub presliding: Option<Positive<Length>>,
}

#[derive(Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct OfRubber {
    /// Shares of the wall's pull, each with a time constant: [[0.1, "50 ms"]]
    pub prony: Prony,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OfController {
    /// Gain in MPa (or opening) per contraction of 1, or in MPa/rad of a joint: 0.5 or "5 bar/rad"
    pub proportional: Gain,
    /// Integral gain in MPa/s (or opening/s) per contraction of 1, or in MPa/(rad s) of a joint
    pub integral: Option<Gain>,
    /// Derivative gain in MPa s (or opening s) per contraction of 1, or in MPa s/rad of a joint
    pub derivative: Option<Gain>,
    /// Time constant of the filter of the derivative
    pub filter: Option<Positive<Time>>,
    /// Time constant of the back-calculation
    pub tracking: Option<Positive<Time>>,
    /// What the controller commands
    pub output: Option<Output>,
    /// Pressure without an error of the position
    #[serde(default)]
    pub bias: Pressure,
}

/// A gain in the unit inside, or with its unit.
#[derive(Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Gain {
    Number(f64),
    Said(String),
}

#[derive(Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Output {
    Pressure,
    Opening,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OfCommand<Position> {
    /// Pressure, or pairs of times and pressures
    pub pressure: Option<Course<Pressure>>,
    /// Pressure of the first muscle
    pub pressure_1: Option<Course<Pressure>>,
    /// Pressure of the second muscle
    pub pressure_2: Option<Course<Pressure>>,
    /// Opening of the valve, -1 to 1, or pairs of times and openings
    pub valve: Option<Course<f64>>,
    /// Opening of the first valve
    pub valve_1: Option<Course<f64>>,
    /// Opening of the second valve
    pub valve_2: Option<Course<f64>>,
    /// Volume that a syringe pushes out, or pairs of times and volumes
    pub volume: Option<Course<Volume>>,
    /// Volume of the first syringe
    pub volume_1: Option<Course<Volume>>,
    /// Volume of the second syringe
    pub volume_2: Option<Course<Volume>>,
    /// Contraction, or angle of a joint
    pub position: Option<Course<Position>>,
    /// End of the run
    pub until: Positive<Time>,
    /// Time between two points of the result
    pub output_step: Option<Positive<Time>>,
}

fn valves(_: &mut SchemaGenerator) -> Schema {
    named(
        crate::catalogue::valves()
            .iter()
            .map(|valve| valve.name.as_str()),
    )
}

fn heats(_: &mut SchemaGenerator) -> Schema {
    named(["isothermal", "adiabatic"].into_iter())
}

fn liquids(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "enum": LIQUIDS.map(|liquid| liquid.name) })
}
