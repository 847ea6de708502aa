//! McKibben pneumatic muscles for Rust programs: one crate to add, with the parts by features.
//!
//! Everything of `mckibben-core` (muscles, rubbers, force models, inverses, joints, curves) is
//! here; by features come [`design`], [`fem`], [`fit`] and [`motion`] (all in the default),
//! `campaign` and `export`.
//!
//! ```
//! use mckibben::prelude::*;
//!
//! // Finite elements of the paper's prototype, with everything at its ends.
//! let model = mckibben::fem::axisymmetric::Axisymmetric::between_ends(&Muscle::prototype())?;
//! let pull = model.force_n(&mut Workspace::new(), 0.25, 0.10)?;
//! assert!((pull - 491.43).abs() < 0.01);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![warn(missing_docs)]

#[cfg(feature = "campaign")]
pub use mckibben_campaign as campaign;
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
