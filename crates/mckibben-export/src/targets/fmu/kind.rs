//! The kinds of units.

/// What drives a unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// The pressure.
    Pressure,
    /// The command of a valve.
    Valve,
}
