//! SHA-256, the one hash of plans, tables and points.

use sha2::{Digest, Sha256};

/// The hash of what was added, in hexadecimal digits.
pub fn digits(hash: Sha256) -> String {
    hash.finalize().iter().map(|b| format!("{b:02x}")).collect()
}

/// The hash of some bytes in hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    digits(Sha256::new_with_prefix(bytes))
}

/// The hash of the bits of numbers, in their order: `sha256:` and its hexadecimal digits.
pub fn numbers(numbers: impl Iterator<Item = f64>) -> String {
    let mut hash = Sha256::new();
    numbers.for_each(|number| hash.update(number.to_le_bytes()));
    format!("sha256:{}", digits(hash))
}
