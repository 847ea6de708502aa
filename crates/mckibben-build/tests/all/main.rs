//! Builds.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod files;
mod plugs;
