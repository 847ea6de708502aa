//! SHA-256, the one hash of plans, tables and points.

use sha2::{Digest, Sha256};
use std::io::{Result, Write};

/// The hash of what is written to it.
#[derive(Default)]
pub struct Running(Sha256);

impl Running {
    /// In hexadecimal digits.
    pub fn digits(self) -> String {
        let bytes = self.0.finalize();
        bytes.iter().map(|b| format!("{b:02x}")).collect()
    }
}

impl Write for Running {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        self.0.update(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<()> {
        Ok(())
    }
}

/// The hash of some bytes in hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    Running(Sha256::new_with_prefix(bytes)).digits()
}

/// The hash of the bits of numbers, in their order: `sha256:` and its hexadecimal digits.
pub fn numbers(numbers: impl Iterator<Item = f64>) -> String {
    let mut hash = Sha256::new();
    numbers.for_each(|number| hash.update(number.to_le_bytes()));
    format!("sha256:{}", Running(hash).digits())
}
