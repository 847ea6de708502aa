//! Whole numbers with a least and a largest value.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::str::FromStr;

/// A whole number from `LOW` to `HIGH`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "usize")]
#[schemars(with = "usize", inline)]
pub struct Count<const LOW: usize, const HIGH: usize>(pub usize);

impl<const LOW: usize, const HIGH: usize> TryFrom<usize> for Count<LOW, HIGH> {
    type Error = String;

    fn try_from(n: usize) -> Result<Self, String> {
        if !(LOW..=HIGH).contains(&n) {
            return Err(format!("{n} is not from {LOW} to {HIGH}"));
        }
        Ok(Self(n))
    }
}

impl<const LOW: usize, const HIGH: usize> FromStr for Count<LOW, HIGH> {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        text.trim()
            .parse::<usize>()
            .map_err(|_| format!("{text} is not a whole number from {LOW} to {HIGH}"))?
            .try_into()
    }
}
