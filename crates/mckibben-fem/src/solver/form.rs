//! The two forms of a factorisation.

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// L Lᵀ.
    Positive,
    /// L D Lᵀ.
    Indefinite,
}
