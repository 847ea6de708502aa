//! Why parts do not make a muscle.

use crate::refused::Refused;

/// What is wrong with a muscle: the fields are keys as in the muscle file.
pub type MuscleError = Refused;

/// Refuses a value with its unit unless it is `fine`, and says what it must be. A key may carry an
/// explanation behind it: "terminals.end_factor at 0 MPa (a + b)".
pub fn must(
    fine: bool,
    key: &'static str,
    value: f64,
    unit: &str,
    must: &str,
) -> Result<(), MuscleError> {
    let field = key.split(' ').next().unwrap_or(key);
    let of_model = (field == "terminals.end_factor").then_some("model.tondu-lopez.end_factor");
    MuscleError::unless(fine, [field].into_iter().chain(of_model), || {
        let given = format!("{value}\u{a0}{unit}");
        format!("{key} is {}; it must {must}", given.trim_end())
    })
}

pub fn positive(key: &'static str, value: f64, unit: &str) -> Result<(), MuscleError> {
    let fine = value.is_finite() && value > 0.0;
    must(fine, key, value, unit, "be above zero and finite")
}

pub fn not_negative(key: &'static str, value: f64, unit: &str) -> Result<(), MuscleError> {
    let fine = value.is_finite() && value >= 0.0;
    must(fine, key, value, unit, "not be below zero, and finite")
}
