//! One share of several.

use crate::campaign::plan::MOST_PARTS;
use std::{fmt, str::FromStr};

/// Share `index` of `count`, from 1: the blocks whose number leaves `index − 1` when divided by
/// `count`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    index: u64,
    count: u64,
}

impl Shard {
    /// Share `index` of `count`, from 1; `None` where there is no such share.
    pub fn new(index: u64, count: u64) -> Option<Self> {
        (index >= 1 && index <= count && count <= MOST_PARTS).then_some(Self { index, count })
    }

    /// Whether a block belongs to it.
    pub fn holds(self, block: u64) -> bool {
        block % self.count == self.index - 1
    }

    /// Into how many shards the campaign is split.
    pub fn count(self) -> u64 {
        self.count
    }

    /// How many of so many blocks are its own.
    pub fn size(self, all: u64) -> u64 {
        all.saturating_sub(self.index - 1).div_ceil(self.count)
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
        let shard =
            pair.and_then(|(i, n)| Self::new(i.trim().parse().ok()?, n.trim().parse().ok()?));
        shard.ok_or_else(|| {
            format!(
                "\"{text}\" is not a valid share; expected i/n with i from 1 to n and n up to \
                 {MOST_PARTS}, such as 2/8"
            )
        })
    }
}
