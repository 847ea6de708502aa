//! A case of the verification.

use mckibben::verification::VerificationRow;

/// A case: its rows.
pub type VerificationCase = fn() -> Vec<VerificationRow>;
