//! What can be asked of any [`ForceModel`](crate::model::ForceModel): inverses, blocked force, free contraction, dead pressure, work, air and burst.

mod air;
mod ask;
mod characteristics;
mod error;
mod golden;
mod inverse;
mod root;

pub use air::{ATMOSPHERE_MPA, Air, air_per_stroke, normal_litres};
pub use ask::{Options, force_on, response_on, source_of};
pub(crate) use ask::{friction_half_width_n, stiffness_of};
pub use characteristics::{
    blocked_force_n, burst_pressure_mpa, free_contraction, start_pressure_mpa, work_per_stroke_j,
};
pub use error::AnalysisError;
pub(crate) use golden::{Place, golden};
pub use inverse::{contraction_at, pressure_at};
pub(crate) use inverse::{pressure_up_to, straight_strands};
pub use root::{RootError, find_root};
