//! McKibben pneumatic muscles for Rust programs: one crate to add, with the parts by features.
//!
//! Begin with a [`Muscle`], by hand or of a muscle file; [`Model::of`] makes a
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
//! | `fem` | finite elements: [`Model::FE`] |
//! | `design` | [`design`], [`decide`]; with it `fem` |
//! | `fit` | constants from measured points, [`MuscleModel::gradient`] |
//! | `motion` | valves, loads and joints over time |
//! | `export` | code for controllers and simulators |
//! | `threads` | searches and lists of points on all cores |
//! | `whole` | every model by name, and the keys that there are in errors of files |
//!
//! The first four, `threads` and `whole` are in the default. Without any there are muscles, rubbers, the
//! closed forms (with `whole`) with their inverses, and joints.
//!
//! What is here is what a program builds on: it changes with the version alone, and is listed in
//! `docs/rust-api.txt`. The crates below (`mckibben-core`, `mckibben-fem`, `mckibben-campaign`, …)
//! are the parts that the program is made of, and have no such line.

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod any_model;
#[cfg(feature = "design")]
pub mod design;
#[cfg(feature = "motion")]
mod drive;
#[cfg(feature = "fit")]
pub mod fit;
mod joint_model;
mod muscle_model;
pub mod prelude;

pub use any_model::Model;
#[cfg(feature = "design")]
pub use design::{Deciding, decide};
pub use joint_model::JointModel;
pub use mckibben_core::{
    analysis::{Allowed, AnalysisError, Burst, FailureMode, FailurePressure, NoBurst, Safety},
    answer::Answer,
    built::{Built, BuiltShift},
    cancel::Cancelled,
    formula::FormulaError,
    joint::{
        Joint, JointError, JointMuscle, JointPoint, JointSpring, Link, MuscleState, Path, Rest,
        Turning,
    },
    liquid::{Liquid, LiquidSupply},
    load::{Lever, Load, LoadTable},
    model::{ForceModel, ModelEntry, ModelError, ModelInfo, RangeViolation, Response, Workspace},
    muscle::{
        Braid, BraidStiffness, Direction, EndsMade, Friction, Muscle, Strands, Terminals, Tube,
        file::{FileError, read_muscle},
    },
    progress::{Progress, Silent},
    refused::Refused,
    rubber::{
        Biaxial, Bulk, Conditioned, Constant, InvariantDerivatives, InvariantLaw, Law,
        LawConstants, LawFault, Principal, Rubber, RubberLaw, check_law,
    },
    units::{
        Dimension, QuantityError, Values,
        typed::{Pressure, Ratio as Contraction},
    },
    warning::{Warning, WarningKind},
};
pub use muscle_model::MuscleModel;
#[cfg(feature = "motion")]
pub use {drive::DriveBuilder, mckibben_motion as motion};

/// Code for controllers and simulators.
#[cfg(feature = "export")]
pub mod export {
    pub use mckibben_export::{
        Artefact, BoxRequest, Content, ExportError, ExportTarget, ExportedJoint, ExportedMuscle,
        File, FormErrors,
    };
}

/// The Rust programs of README and book are run as those of the documentation.
#[cfg(all(doctest, feature = "fem", feature = "fit", feature = "motion"))]
mod pages {
    #[doc = include_str!("../../../README.md")]
    struct Readme;
    #[doc = include_str!("../../../docs/rust.md")]
    struct Rust;
}
