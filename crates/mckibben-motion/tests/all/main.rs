//! Motion against closed forms, identities and rates of convergence.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod chamber;
mod control;
mod ends;
mod external;
mod frequency;
mod measured;
mod mechanics;
mod random;
mod refusals;
mod stepped;
mod support;
mod verification;
