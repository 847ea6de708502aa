//! McKibben muscles in motion: a muscle, or a mechanism with several, on valves over time.
//!
//! A [`Drive`] says what moves ([`Mechanism`]: [`SingleMuscle`] with a load, or a joint), what
//! pulls ([`Actuated`]: a force model, its air, its valve, its friction), what is commanded
//! ([`Commanded`]) and for how long; [`run`] integrates it into a [`Motion`]. Around that: [`Linear`]
//! (the system about an equilibrium: eigenvalues, frequency response, bandwidth) and [`size`] (the
//! smallest valve that is quick enough).
//!
//! Units: mm, MPa, N, s, kg, K; air in g; energies in J at the surface and mJ (= N mm) inside. A
//! pressure is gauge unless its name says `absolute`. `docs/motion-equations.md` has the equations
//! on one page.
//!
//! ```
//! use mckibben_core::model::{Ideal, ForceModel};
//! use mckibben_core::muscle::Muscle;
//! use mckibben_motion::*;
//!
//! let model = Ideal::between_ends(&Muscle::prototype());
//! let load = SingleMuscle { stops_mm: (0.0, 100.0), ..SingleMuscle::hanging(&model, 10.0) };
//! let valve = Valve::new(Orifice::new(0.5, 0.3)?);
//! let target = Commanded::Pressure(vec![Command::Steps(vec![(0.0, 0.0), (0.1, 0.3)])]);
//! let drive = Drive::new(load.clone(), vec![Actuated::new(model.clone(), Actuator::Valve(valve))], target, 1.0);
//! let motion = run(&drive, &mckibben_core::progress::Silent)?;
//! assert!(motion.rise_time_s.is_some());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

// The physics is documented on its public types.
#![warn(clippy::print_stdout, clippy::print_stderr)]

mod air;
mod catalogue;
mod command;
mod control;
mod drive;
mod equilibrium;
mod error;
mod events;
mod file;
mod flows;
mod fluid;
mod hose;
#[doc(hidden)]
pub mod integrate;
mod linear;
mod liquid;
mod locate;
mod mechanism;
mod member;
mod metrics;
mod motion;
mod orifice;
mod record;
mod run;
mod series;
mod simulation;
mod size;
#[doc(hidden)]
pub mod state;
mod system;
mod valve;
mod viscoelastic;

pub use air::{ATMOSPHERE_MPA, Air, HEAT_RATIO, Heat};
pub use command::Command;
pub use control::{Pid, PidOutput};
pub use drive::{Actuated, Actuator, Commanded, Drive, Supply};
pub use equilibrium::{Equilibrium, equilibrium};
pub use error::MotionError;
pub use events::{Event, EventKind};
pub use fluid::Fluid;
pub use hose::Hose;
pub use linear::Linear;
pub use liquid::{LiquidFill, LiquidValve, Pump, Restriction, Syringe};
pub use mechanism::{Coordinate, Lever, Mechanism, SingleMuscle};
pub use motion::{Energies, Motion, MotionEnd};
pub use orifice::Orifice;
pub use run::run;
pub use series::{MotionSeries, MuscleSeries};
pub use simulation::{Simulation, SimulationState};
pub use valve::{Valve, ValveKind};
#[doc(hidden)]
pub use {
    air::{Flow, REFERENCE_DENSITY_G_PER_L},
    catalogue::{NamedValve, conductance_of_rated_flow, valve_named, valves},
    error::{OnStop, Result},
    file::{
        DriveFile, DriveKeys, Names, Subject, Tables, drive_names, number_at, parse_drive,
        with_value,
    },
    motion::{Moves, StepFigures},
    orifice::{LINEAR_SHARE, in_series},
    run::run_as_far,
    size::size,
    viscoelastic::{Branch, Prony},
};
