//! McKibben pneumatic muscles: rubber laws, force models, their inverses, curves, and design.
//!
//! Data flows one way: specification → [`muscle`] → [`model`] → response → curve → figure. The hinge is
//! [`model::ForceModel`]: whatever answers F(P, ε) for a muscle can be inverted, plotted, compared and designed with.
//!
//! Units: mm, MPa (= N/mm²), N. Angles are in degrees where a name says `_deg`.
//!
//! ```
//! use mckibben::analysis::{free_contraction, pressure_at};
//! use mckibben::model::{ForceModel, ThickWall};
//! use mckibben::muscle::Muscle;
//!
//! let muscle = Muscle::prototype().with_section(40.0, 2.0)?;
//! let model = ThickWall::new(&muscle);
//! let pull = model.response(0.25, 0.10)?;
//! assert!(pull.force_n > 900.0 && pull.bulged_diameter_mm > Some(50.0));
//! // Which pressure gives 500 N at 10 %, and how far does it contract when nothing holds it?
//! let pressure_mpa = pressure_at(&model, 500.0, 0.10, false)?;
//! assert!(pressure_mpa < 0.25);
//! assert!(free_contraction(&model, 0.25, false)? < muscle.max_ideal_contraction());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![cfg_attr(test, allow(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

pub mod analysis;
pub mod answer;
pub mod compare;
pub mod curve;
pub mod design;
pub mod formula;
pub mod identify;
pub mod least_squares;
pub mod model;
pub mod muscle;
mod nearest;
pub mod progress;
pub mod rubber;
pub mod study;
pub mod units;
