//! All integration tests of the crate in one executable: one link in place of many.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod answers;
mod axisymmetric;
mod branches;
mod built;
mod conditioned;
mod contact;
mod eighth;
mod element;
mod extensile;
mod plugs;
mod prestretch;
mod seated;
mod shared;
mod small_angles;
mod solver;
mod sweep;
mod temperature;
mod three_dimensional;
mod verification;
mod vtu;
