//! A share of a plan.

mod environment;

pub use environment::{ENGINES, Engine, ShardError};

use std::fmt;
use std::str::FromStr;

/// Share `index` of `count`, from 1: the blocks whose number leaves `index − 1` when divided by `count`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    index: u64,
    count: u64,
}

impl Shard {
    /// Everything.
    pub const WHOLE: Self = Self { index: 1, count: 1 };

    /// Share `index` of `count`, from 1; `None` where there is no such share.
    pub fn new(index: u64, count: u64) -> Option<Self> {
        (index >= 1 && index <= count).then_some(Self { index, count })
    }

    /// Whether a block belongs to it.
    pub fn holds(self, block: u64) -> bool {
        block % self.count == self.index - 1
    }

    /// Its number, from 1.
    pub fn index(self) -> u64 {
        self.index
    }

    /// Shares in all.
    pub fn count(self) -> u64 {
        self.count
    }

    /// Its blocks of so many.
    pub fn blocks(self, all: u64) -> impl Iterator<Item = u64> {
        (self.index - 1..all).step_by(usize::try_from(self.count).unwrap_or(usize::MAX))
    }

    /// A name for files.
    pub(super) fn file_name(self) -> String {
        format!("{}-of-{}", self.index, self.count)
    }

    /// The share of a file's name.
    pub(super) fn of_file_name(name: &str) -> Option<Self> {
        let (index, count) = name.split_once("-of-")?;
        Self::new(index.parse().ok()?, count.parse().ok()?)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let pair = text.split_once('/');
        let shard = pair.and_then(|(i, n)| Self::new(i.trim().parse().ok()?, n.trim().parse().ok()?));
        shard.ok_or_else(|| {
            format!("\"{text}\" is not a valid share; expected i/n with i from 1 to n, such as 2/8, or auto, or auto/8")
        })
    }
}

/// Which share is wanted: a stated one, or that of the environment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShardChoice {
    /// This one.
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
    ///
    /// # Errors
    /// [`ShardError`] where no variable names a share, or two name different ones.
    pub fn shard(self, variable: impl Fn(&str) -> Option<String>) -> Result<Shard, ShardError> {
        match self {
            Self::Given(shard) => Ok(shard),
            Self::Auto { count } => environment::shard(&variable, count),
        }
    }
}
