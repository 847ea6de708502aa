//! McKibben pneumatic muscles for Rust programs: one crate to add, with the parts by features.
//!
//! Begin with a [`Muscle`](muscle::Muscle), by hand or of a muscle file; [`Model::of`] makes a
//! [`MuscleModel`] of it, which answers pulls, pressures and contractions, each with what a muscle
//! that is built will do. [`JointModel`] turns two of them against each other,
//! [`motion::Simulation`] steps them in a control loop, [`decide`] finds the muscle for a
//! specification.
//!
//! ```
//! use mckibben::prelude::*;
//!
//! // Finite elements of the paper's prototype, with everything at its ends.
//! let mut model = Model::FE.of(&Muscle::prototype())?;
//! let pull = model.force_n(0.25, 0.10)?;
//! assert!((pull - 491.43).abs() < 0.01);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Units: mm, MPa (= N/mm²), N, s, kg; angles are in degrees where a name says `_deg`.
//!
//! | feature | what it adds |
//! |---|---|
//! | `fem` | finite elements: [`Model::FE`], deformed shapes |
//! | `design` | [`design`], [`decide`] (with `fem`) |
//! | `fit` | constants from measured points, [`MuscleModel::gradient`] |
//! | `motion` | valves, loads and joints over time |
//! | `campaign` | many finite-element tests from a plan, formulas fitted to them |
//! | `export` | code for controllers and simulators |
//! | `threads` | searches, lists of points and campaigns on all cores |
//! | `whole` | every model by name, and the keys that there are in errors of files |
//!
//! The first four, `threads` and `whole` are in the default. Without any there are muscles, rubbers, the
//! closed forms (with `whole`) with their inverses, and joints.

#![warn(missing_docs)]
#![warn(clippy::print_stdout, clippy::print_stderr)]

mod any_model;
#[cfg(all(feature = "design", feature = "fem"))]
mod decide;
#[cfg(feature = "fit")]
pub mod gradient;
#[cfg(feature = "fit")]
mod identify;
mod joint_model;
mod muscle_model;
pub mod prelude;

pub use any_model::Model;
#[cfg(all(feature = "design", feature = "fem"))]
pub use decide::{Deciding, decide};
pub use joint_model::JointModel;
#[cfg(feature = "campaign")]
pub use mckibben_campaign as campaign;
#[doc(no_inline)]
pub use mckibben_core::*;
#[cfg(feature = "design")]
pub use mckibben_design as design;
#[cfg(feature = "export")]
pub use mckibben_export as export;
#[cfg(feature = "fem")]
pub use mckibben_fem as fem;
#[cfg(feature = "fit")]
pub use mckibben_fit as fit;
#[cfg(feature = "motion")]
pub use mckibben_motion as motion;
pub use muscle_model::MuscleModel;

/// The Rust programs of README and book are run as those of the documentation.
#[cfg(all(doctest, feature = "fem", feature = "fit", feature = "motion"))]
mod pages {
    #[doc = include_str!("../../../README.md")]
    struct Readme;
    #[doc = include_str!("../../../docs/rust.md")]
    struct Rust;
}
