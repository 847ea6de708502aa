//! Direction of motion: the branch of the hysteresis loop.

use serde::{Deserialize, Serialize};

/// Which way the muscle moves, and so on which branch of its hysteresis loop it is.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize, schemars::JsonSchema,
)]
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

mckibben_units::display_as_serde_word!(Direction);

impl Direction {
    /// All of them.
    pub const ALL: [Direction; 3] = [
        Direction::Mean,
        Direction::Contraction,
        Direction::Elongation,
    ];

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
