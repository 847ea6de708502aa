//! What augmenting leaves of a constraint.

/// β = 1 − γ/k; what is left by rounding where γ = k is zero.
pub(super) fn share(compliance: f64, augment: f64) -> f64 {
    let share = 1.0 - augment * compliance;
    if share > 1e-12 { share } else { 0.0 }
}
