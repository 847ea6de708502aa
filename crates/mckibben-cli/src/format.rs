//! The form of an output.

use clap::ValueEnum;

/// Form of the output.
#[derive(Clone, Copy, PartialEq, Default, ValueEnum)]
pub enum Format {
    /// Aligned text with units
    #[default]
    Text,
    /// One JSON object; keys carry their unit
    Json,
    /// One row per point; columns carry their unit
    Csv,
}
