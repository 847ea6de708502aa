//! From a specification to muscles: the main job.
//!
//! A [`Spec`] says which pull is wanted at which contraction, with which pressure, and within which
//! bounds. [`design`] answers with ranked [`Candidate`]s, with the reason why others fail, and, where
//! nothing fits, with the best chance there is and what would have to give.
//!
//! The muscles are enumerated from lists (tubes × sleeves × rubbers × lengths × pulleys), screened
//! with a fast model, sorted by the objective, and settled by the model that decides from the best
//! on. What is taken is the first whose chance reaches the certainty: with the median m and the
//! standard deviation σ of what a built muscle pulls at the highest pressure,
//!
//! ```text
//! chance = min over points Φ((n m − F)/(n σ))
//! ```
//!
//! of n muscles side by side, as one sets the pressure after they are built; one error is common to
//! all points and muscles. What is sold comes before what is cast, and one before several, unless
//! the other is smaller by a third.
//!
//! The smallest muscle that pulls 700 N at 15 % with at most 0.25 MPa:
//!
//! ```
//! use mckibben_core::model::ThickWall;
//! use mckibben_design::{OperatingPoint, Spec, design};
//!
//! let wanted = OperatingPoint { force_n: 700.0, contraction: 0.15 };
//! let outcome = design(&Spec::new(vec![wanted], 0.25), &|muscle| Ok(Box::new(ThickWall::between_ends(muscle))))?;
//! let best = outcome.candidates.first().ok_or("nothing fits")?;
//! assert!(best.chance >= Some(0.9) && best.pressure_mpa <= 0.25);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod assess;
pub mod bundle;
mod candidate;
mod demand;
mod design;
mod enumerate;
mod held;
mod limits;
mod models;
mod relaxation;
mod search;
mod spec;
pub mod tubes;

pub use assess::{normal_deviations, normal_share};
pub use bundle::Bundle;
pub use candidate::{Candidate, CandidatePoint, Rejected};
pub use demand::{Demand, JointDemand, OperatingPoint, TorqueWanted};
pub use design::{Choice, ChoiceKind, Outcome, design, design_with};
pub use held::Precision;
pub use limits::{Check, Limit, Limits, SAFETY, Show, why_no_more};
pub use mckibben_core::warning::VALIDATED_STRAND_STRAIN;
pub use models::{Build, Models, ScreenedMuscles, near_the_box};
pub use relaxation::Relaxation;
pub use spec::{
    BraidChoice, CERTAINTY, Ends, EndsOf, LARGEST_BUNDLE, Objective, Product, SUPPLY_SHARE, Spec,
    SpecError,
};
pub use tubes::{TubeError, TubePart};
