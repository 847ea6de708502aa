//! What can be asked of any [`ForceModel`](crate::model::ForceModel): inverses, blocked force, free contraction, dead pressure, work, air, burst and what wears.

mod air;
mod ask;
pub mod burst;
mod characteristics;
mod error;
mod golden;
mod inverse;
mod root;
mod sweep;

pub use air::{ATMOSPHERE_MPA, Air, HEAT_RATIO, air_per_stroke, normal_litres};
pub use ask::{Options, force_on, friction_on, response_on, slope_by_pressure, source_of, stiffness_of};
pub use burst::{Burst, FailureMode, FailurePressure, NoBurst, SAFETY, burst};
pub use characteristics::{free_contraction, start_pressure_mpa, work_per_stroke_j};
pub use error::{AnalysisError, Result};
pub use golden::{Abscissa, golden};
pub(crate) use inverse::{HIGHEST_PRESSURE_MPA, straight_strands};
pub use inverse::{contraction_at, contraction_or_stretch_at, pressure_at, pressure_below};
pub use root::find_root;
