//! Results as text, JSON and CSV, and where they go.

pub mod csv;
pub mod json;
pub mod text;
mod write;

pub use write::{emit, save, warn};
