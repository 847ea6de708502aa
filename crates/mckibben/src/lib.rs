//! McKibben pneumatic muscles: rubber laws, force models, their inverses, curves, and design.
//!
//! Data flows one way: specification → [`muscle`] → [`model`] → response → curve → figure. The hinge is
//! [`model::ForceModel`]: whatever answers F(P, ε) for a muscle can be inverted, plotted, compared and designed with.
//!
//! Units: mm, MPa (= N/mm²), N. Angles are in degrees where a name says `_deg`.

#![cfg_attr(test, allow(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

pub mod analysis;
pub mod answer;
pub mod compare;
pub mod curve;
pub mod design;
pub mod formula;
pub mod model;
pub mod muscle;
mod nearest;
pub mod rubber;
pub mod study;
pub mod units;
