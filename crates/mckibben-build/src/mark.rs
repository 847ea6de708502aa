//! The mark of a build.

/// What every file of this crate has in it, so that a later run knows it.
pub const MARK: &str = "mckibben build";
