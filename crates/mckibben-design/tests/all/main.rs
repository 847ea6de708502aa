//! All integration tests of the crate in one executable: one link in place of many.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod bundle;
mod chance;
mod choice;
mod demand;
mod design;
mod design_grid;
mod every_field;
mod extensile;
mod joint;
mod tubes;
