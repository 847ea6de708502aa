//! The hash of numbers.

use mckibben_core::hash::digits;
use sha2::{Digest, Sha256};

/// The hash of the bits of numbers, in their order: `sha256:` and its hexadecimal digits.
pub fn numbers(numbers: impl Iterator<Item = f64>) -> String {
    let mut hash = Sha256::new();
    numbers.for_each(|number| hash.update(number.to_le_bytes()));
    format!("sha256:{}", digits(hash))
}
