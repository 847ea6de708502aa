//! SHA-256, the one hash of plans, tables and points.

use sha2::{Digest, Sha256};
use std::io::{Read, Result};

/// The hash of what is added.
#[derive(Default)]
pub struct Running(Sha256);

impl Running {
    pub fn add(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }

    /// Adds all that is to be read.
    pub fn add_all(&mut self, mut from: impl Read) -> Result<()> {
        let mut buffer = [0; 1 << 14];
        loop {
            match from.read(&mut buffer)? {
                0 => return Ok(()),
                read => self.add(&buffer[..read]),
            }
        }
    }

    /// In hexadecimal digits.
    pub fn digits(self) -> String {
        let bytes = self.0.finalize();
        bytes.iter().map(|b| format!("{b:02x}")).collect()
    }
}

/// The hash of some bytes in hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    let mut hash = Running::default();
    hash.add(bytes);
    hash.digits()
}

/// The hash of the bits of numbers, in their order: `sha256:` and its hexadecimal digits.
pub fn numbers(numbers: impl Iterator<Item = f64>) -> String {
    let mut hash = Running::default();
    numbers.for_each(|number| hash.add(&number.to_le_bytes()));
    format!("sha256:{}", hash.digits())
}
