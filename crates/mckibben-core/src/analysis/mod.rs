//! What any [`ForceModel`](crate::model::ForceModel) gives: inverses, blocked force, free
//! contraction, dead pressure, work, air, burst and what wears.

mod air;
pub mod burst;
mod characteristics;
mod error;
mod evaluation;
mod golden;
mod inverse;
mod root;
mod sweep;

pub use air::{ATMOSPHERE_MPA, Air, HEAT_RATIO, normal_litres};
pub use burst::{
    Allowed, BUCKLING, Burst, FailureMode, FailurePressure, LEAST_SAFETY, NoBurst, PROOF_TO_BURST,
    PROOF_TO_WORKING, PROVED, PressureLimits, RELIEF, SAFETY, STRETCH, Safety, burst, burst_below,
};
pub use error::{AnalysisError, Result};
pub use evaluation::{Evaluation, Options, source_of};
pub(crate) use inverse::{HIGHEST_PRESSURE_MPA, straight_strands};
pub use root::{bisect, find_root, root_near};
pub(crate) use sweep::{Sweep, places};
