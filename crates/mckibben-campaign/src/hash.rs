//! The hash of numbers.

use hmac_sha256::Hash;
use mckibben_core::hash::digits;

/// The hash of the bits of numbers, in their order: `sha256:` and its hexadecimal digits.
pub fn numbers(numbers: impl Iterator<Item = f64>) -> String {
    let mut hash = Hash::new();
    numbers.for_each(|number| hash.update(number.to_le_bytes()));
    format!("sha256:{}", digits(hash))
}
