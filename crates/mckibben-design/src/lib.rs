//! From a specification to muscles: the main job.
//!
//! A [`Spec`] says which pull is wanted at which contraction, with which pressure, and within which
//! bounds. [`design`] answers with ranked [`Candidate`]s, with the [`Reason`] why others fail, and,
//! where nothing fits, with the muscle that comes closest and what would have to give.
//!
//! The smallest muscle that pulls 700 N at 15 % with at most 0.25 MPa:
//!
//! ```
//! use mckibben_core::prelude::*;
//! use mckibben_design::{OperatingPoint, Spec, design};
//!
//! let wanted = OperatingPoint { force_n: 700.0, contraction: 0.15 };
//! let outcome = design(&Spec::new(vec![wanted], 0.25), &|muscle| Ok(Box::new(ThickWall::between_ends(muscle))))?;
//! let best = outcome.candidates.first().ok_or("nothing fits")?;
//! assert!(best.margin >= 0.0 && best.pressure_mpa <= 0.25);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![warn(clippy::print_stdout, clippy::print_stderr)]

#[doc(hidden)]
pub mod bought;
#[doc(hidden)]
pub mod bundle;
mod candidate;
mod choice;
mod demand;
mod joint;
mod limits;
#[doc(hidden)]
pub mod line;
mod misses;
mod models;
mod other_parts;
mod reason;
mod relaxation;
mod run;
mod search;
mod spec;
mod task;
mod trial;
#[doc(hidden)]
pub mod tubes;

pub use candidate::{Candidate, CandidatePoint};
pub use demand::{Demand, JointDemand, Lift, OperatingPoint, TorqueWanted};
pub use joint::design_joint;
pub use limits::{Limit, Limits, SAFETY};
pub use mckibben_core::warning::VALIDATED_STRAND_STRAIN;
pub use reason::{Reason, Rejected};
pub use relaxation::Relaxation;
pub use run::{Closest, Outcome, design, design_with};
pub use spec::{BraidChoice, Objective, SUPPLY_SHARE, Spec, SpecError};
pub use task::Design;
#[doc(hidden)]
pub use {
    bought::Bought,
    bundle::{Bundle, BundlePoint},
    choice::{LARGEST_BUNDLE, Several},
    limits::{
        check::{Check, Show, fits},
        pressure::Below,
    },
    models::{Build, Models, SearchedMuscles, near_the_box},
    search::nice_steps,
    task::{Open, Task},
    tubes::{TubeError, TubePart},
};
