//! A share of a plan.

mod environment;
mod share;

pub use environment::{ENGINES, Engine, ShardError};
pub use share::Shard;

use std::fmt;
use std::str::FromStr;

/// Which share is wanted: a stated one, or that of the environment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShardChoice {
    Given(Shard),
    /// The one that an engine's environment variables name: `auto`, or `auto/64` where the engine gives no count.
    Auto {
        /// The count, where it is stated.
        count: Option<u64>,
    },
}

impl FromStr for ShardChoice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim().strip_prefix("auto") {
            Some("") => Ok(Self::Auto { count: None }),
            Some(rest) => match rest.strip_prefix('/').and_then(|n| n.trim().parse().ok()) {
                Some(count) if count > 0 => Ok(Self::Auto { count: Some(count) }),
                _ => {
                    Err(format!("\"{text}\" is not a valid share; expected auto, or auto/N such as auto/64"))
                }
            },
            None => text.parse().map(Self::Given),
        }
    }
}

impl fmt::Display for ShardChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Given(shard) => write!(f, "{shard}"),
            Self::Auto { count: None } => f.write_str("auto"),
            Self::Auto { count: Some(count) } => write!(f, "auto/{count}"),
        }
    }
}

impl ShardChoice {
    /// The share, with the value of each environment variable.
    pub fn shard(self, variable: impl Fn(&str) -> Option<String>) -> Result<Shard, ShardError> {
        match self {
            Self::Given(shard) => Ok(shard),
            Self::Auto { count } => environment::shard(&variable, count),
        }
    }
}
