//! The two forms of a factorisation.

/// What is factorised.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// L Lᵀ.
    Positive,
    /// L D Lᵀ.
    Indefinite,
}
