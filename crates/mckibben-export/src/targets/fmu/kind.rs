//! The kinds of units.

/// What drives a unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Pressure,
    /// The command of a valve.
    Valve,
}
