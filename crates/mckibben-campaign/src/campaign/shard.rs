//! A share of a plan.

use std::fmt;
use std::str::FromStr;

/// Share `index` of `count`, from 1: the blocks whose number leaves `index − 1` when divided by `count`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    index: u64,
    count: u64,
}

impl Shard {
    /// Whether a block belongs to it.
    pub fn holds(self, block: u64) -> bool {
        block % self.count == self.index - 1
    }

    /// Shares in all.
    pub fn count(self) -> u64 {
        self.count
    }

    /// A name for files.
    pub(super) fn file_name(self) -> String {
        format!("{}-of-{}", self.index, self.count)
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
        let numbers = text.split_once('/').and_then(|(i, n)| {
            let number = |t: &str| t.trim().parse::<u64>().ok();
            Some((number(i)?, number(n)?))
        });
        match numbers {
            Some((index, count)) if index >= 1 && index <= count => Ok(Self { index, count }),
            _ => {
                Err(format!("\"{text}\" is not a valid share; expected i/n with i from 1 to n, such as 2/8"))
            }
        }
    }
}
