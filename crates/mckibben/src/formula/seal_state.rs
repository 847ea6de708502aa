//! What the seal of a formula's file says.

use std::fmt;

/// What the seal of a formula's file says.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum SealState {
    /// Its numbers are those that were written.
    #[default]
    Sealed,
    /// There is none.
    Absent,
    /// Its numbers were changed since.
    Changed {
        /// Force at the check point in N as it was written, and as it is now.
        check_n: Option<(f64, f64)>,
    },
}

impl SealState {
    /// Whether what the file says of its errors holds for its terms, as far as it can be seen.
    pub fn is_intact(self) -> bool {
        !matches!(self, Self::Changed { .. })
    }

    /// What belongs into the warnings of any answer of a formula of this name.
    pub fn warning(self, name: &str) -> Option<String> {
        (self != Self::Sealed).then(|| format!("the formula {name} {self}"))
    }
}

impl fmt::Display for SealState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sealed => f.write_str("is as it was written"),
            Self::Absent => f.write_str("has no seal (checksum): its numbers and its ± cannot be verified"),
            Self::Changed { check_n } => {
                f.write_str(
                    "was changed after it was written: its seal (checksum) does not match, and its ± is not valid",
                )?;
                match check_n {
                    Some((then, now)) => write!(
                        f,
                        " (at its check point it gives {now:.4} N; when it was written {then:.4} N)"
                    ),
                    None => Ok(()),
                }
            }
        }
    }
}
