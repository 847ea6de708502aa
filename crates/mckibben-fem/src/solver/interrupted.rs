//! Why a walk ended.

use super::newton::Stopped;
use crate::error::LastConverged;

/// Why a walk ended, and the last equilibrium on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interrupted {
    /// Why the last step was given up.
    pub reason: Stopped,
    /// The last equilibrium.
    pub last: LastConverged,
}
