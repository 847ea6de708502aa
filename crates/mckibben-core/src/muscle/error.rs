//! Why parts do not make a muscle.

use crate::refused::Refused;

/// What is wrong with a muscle: the fields are keys as in the muscle file.
pub type MuscleError = Refused;

/// That a value with its unit must be something else. A key may carry an explanation behind it:
/// "terminals.end_factor at 0 MPa (a + b)".
pub fn must(key: &'static str, value: f64, unit: &str, must: &str) -> MuscleError {
    let field = key.split(' ').next().unwrap_or(key);
    let of_model = (field == "terminals.end_factor").then_some("model.tondu-lopez.end_factor");
    let given = format!("{value}\u{a0}{unit}");
    let message = format!("{key} is {}; it must {must}", given.trim_end());
    MuscleError::new([field].into_iter().chain(of_model), message)
}

pub fn positive(key: &'static str, value: f64, unit: &str) -> Result<(), MuscleError> {
    let fine = value.is_finite() && value > 0.0;
    if fine {
        Ok(())
    } else {
        Err(must(key, value, unit, "be above zero and finite"))
    }
}

pub fn not_negative(key: &'static str, value: f64, unit: &str) -> Result<(), MuscleError> {
    let fine = value.is_finite() && value >= 0.0;
    if fine {
        Ok(())
    } else {
        Err(must(key, value, unit, "not be below zero, and finite"))
    }
}
