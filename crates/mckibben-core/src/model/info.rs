//! Data of a model besides its results: name, source, range of validity, accuracy.

use super::{Accuracy, ModelRange, notes};
use crate::muscle::Muscle;
use serde::Serialize;
use std::{borrow::Cow, sync::Arc};

/// Name and one line of a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
pub struct ModelEntry {
    /// The word for `model`.
    pub name: &'static str,
    /// What it is.
    pub description: &'static str,
    /// Where it comes from: author, year, equation.
    #[serde(skip)]
    pub source: &'static str,
}

/// A model bound to its muscle: name, source, range, error.
#[derive(Debug, Clone)]
pub struct ModelInfo {
    /// The word for `--model`.
    pub name: Cow<'static, str>,
    /// Where it comes from: author, year, equation.
    pub source: Cow<'static, str>,
    /// The muscle it answers for.
    pub muscle: Arc<Muscle>,
    /// The pressures and contractions for which it was made, and what of the muscle lies outside of
    /// its box.
    #[doc(hidden)]
    pub range: ModelRange,
    /// What is known of its error.
    #[doc(hidden)]
    pub accuracy: Accuracy,
    /// Whether an answer takes milliseconds or more: searches then ask it at fewer places.
    pub costly: bool,
    /// Sentences that belong into the warnings of any answer: what of the muscle it does not use.
    pub notes: Vec<String>,
}

impl ModelInfo {
    /// Of any muscle in an open range, with an unknown error, by straight strands on the surface of
    /// a tube on its first inflation.
    pub fn new(entry: &ModelEntry, muscle: &Muscle) -> Self {
        Self {
            notes: notes::of_a_simple_tube(entry.name, muscle),
            name: entry.name.into(),
            source: entry.source.into(),
            muscle: Arc::new(muscle.clone()),
            range: ModelRange::for_muscle(muscle),
            accuracy: Accuracy::UNKNOWN,
            costly: false,
        }
    }
}
