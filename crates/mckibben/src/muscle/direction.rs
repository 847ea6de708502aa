//! Direction of motion: the branch of the hysteresis loop.

use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// Which way the muscle moves, and so on which branch of its hysteresis loop it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Direction {
    /// Mean of both branches, without friction.
    #[default]
    Mean,
    /// The muscle shortens: lower branch, friction reduces the pull.
    Contraction,
    /// The muscle is lengthened: upper branch, friction increases the pull.
    Elongation,
}

/// A word that names no direction.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("\"{given}\" is not a direction of motion; expected mean, contraction or elongation")]
pub struct UnknownDirection {
    /// What was given.
    pub given: String,
}

impl Direction {
    /// All of them.
    pub const ALL: [Direction; 3] = [Direction::Mean, Direction::Contraction, Direction::Elongation];

    /// The two branches of the loop.
    pub const BRANCHES: [Direction; 2] = [Direction::Contraction, Direction::Elongation];

    /// What the muscle does on it.
    pub fn motion(self) -> &'static str {
        match self {
            Direction::Mean => "mean of both branches",
            Direction::Contraction => "shortening",
            Direction::Elongation => "lengthening",
        }
    }

    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            Direction::Mean => "mean",
            Direction::Contraction => "contraction",
            Direction::Elongation => "elongation",
        }
    }

    /// Sign of the friction force in the pull.
    pub fn sign(self) -> f64 {
        match self {
            Direction::Mean => 0.0,
            Direction::Contraction => -1.0,
            Direction::Elongation => 1.0,
        }
    }

    /// Whether it is [`Direction::Mean`].
    pub fn is_mean(&self) -> bool {
        *self == Direction::Mean
    }
}

impl fmt::Display for Direction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Direction {
    type Err = UnknownDirection;

    fn from_str(s: &str) -> Result<Self, UnknownDirection> {
        let found = Self::ALL.into_iter().find(|d| d.name() == s.trim());
        found.ok_or_else(|| UnknownDirection { given: s.chars().take(60).collect() })
    }
}
