//! All integration tests of the crate in one executable: one link in place of many.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod choice;
mod design;
mod design_grid;
mod extensile;
mod joint;
