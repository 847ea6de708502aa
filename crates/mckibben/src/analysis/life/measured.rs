//! Lives of muscles that somebody measured or states, with their conditions: `data/lives.toml`. Sources: Woods et al. 2012 \[woods2012\], Delta Robotics
//! 2026 \[delta2026\]. They are printed beside what wears in a muscle, and no number of cycles follows from them.

use crate::catalogue::{Catalogue, CatalogueError, Row};
use serde::Serialize;

const TEXT: &str = include_str!("../../../data/lives.toml");

/// A life of a muscle.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MeasuredLife {
    /// Which muscle.
    pub muscle: String,
    /// Cycles that it lasted at least.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at_least_cycles: Option<f64>,
    /// Cycles that it lasted at most.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at_most_cycles: Option<f64>,
    /// How its ends are clamped.
    pub ends: String,
    /// What the number is.
    pub kind: String,
    /// Pressure, contraction and whatever else is stated.
    pub conditions: String,
    /// Where it is stated.
    pub source: String,
    /// How sure it is: `stated` by the source, or `second hand`.
    pub certainty: String,
}

/// All of them.
///
/// # Errors
/// [`CatalogueError`], which no released program should see.
pub fn lives() -> Result<Vec<MeasuredLife>, CatalogueError> {
    let one = |row: Row<'_>| {
        Ok(MeasuredLife {
            muscle: row.text("muscle")?.to_owned(),
            at_least_cycles: row.number("at_least_cycles")?,
            at_most_cycles: row.number("at_most_cycles")?,
            ends: row.text("ends")?.to_owned(),
            kind: row.text("kind")?.to_owned(),
            conditions: row.text("conditions")?.to_owned(),
            source: row.source_text().to_owned(),
            certainty: row.text("certainty")?.to_owned(),
        })
    };
    Catalogue::parse(TEXT)?.rows("life").into_iter().map(one).collect()
}
