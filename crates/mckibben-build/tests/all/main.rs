//! Builds.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod by_hand;
mod files;
mod plugs;
mod proof;
