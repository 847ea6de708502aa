//! From a specification to muscles: the main job.
//!
//! A [`Spec`] says which pull is wanted at which contraction, with which pressure, and within which bounds. [`design`]
//! answers with ranked [`Candidate`]s, with the [`Reason`] why others fail, and, where nothing fits, with the muscle that
//! comes closest and what would have to give.

mod candidate;
mod demand;
mod joint;
mod limit;
mod line;
mod reason;
mod relax;
mod run;
mod search;
mod spec;
mod sure;
mod tolerance;

pub use crate::warning::VALIDATED_STRAND_STRAIN;
pub use candidate::{Candidate, CandidatePoint};
pub use demand::{Demand, JointDemand, Way};
pub use joint::design_joint;
pub use limit::{Limit, fits};
pub use reason::{Reason, Rejected};
pub use relax::Relaxation;
pub use run::{Closest, Models, Outcome, design, design_with};
pub use spec::{
    BraidChoice, Build, Limits, Objective, OperatingPoint, SAFETY, Spec, SpecError, TorqueWanted,
};
pub use sure::{Searcher, Sure, is_doubtful, to_be_sure};
pub use tolerance::{Spread, SpreadError, Tolerances, spread};
