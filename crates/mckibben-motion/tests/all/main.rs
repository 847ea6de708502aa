//! Motion against closed forms, identities and rates of convergence.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod chamber;
mod command_files;
mod control;
mod drive_files;
mod ends;
mod external;
mod frequency;
mod integrate;
mod liquid;
mod measured;
mod mechanics;
mod random;
mod refusals;
mod state;
mod stepped;
mod support;
mod verification;
