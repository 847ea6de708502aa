//! From the texts of flags to numbers.

use crate::failure::Failure;
use mckibben::units::{Dimension, RangeError, Values, parse_quantity, parse_values};
use mckibben_app::ProblemKind;

/// A quantity from a flag.
pub fn quantity(flag: &str, text: Option<&str>, dimension: Dimension) -> Result<Option<f64>, Failure> {
    let wrong = |e| Failure::flag(flag, ProblemKind::Quantity, e);
    text.map(|t| parse_quantity(t, dimension).map_err(wrong)).transpose()
}

/// A plain number from a flag.
pub fn ratio(flag: &str, text: Option<&str>) -> Result<Option<f64>, Failure> {
    quantity(flag, text, Dimension::Ratio)
}

/// A contraction ratio from a flag. No muscle shortens by its whole length, so that `15` was meant as 15 %.
pub fn contraction(flag: &str, text: Option<&str>) -> Result<Option<f64>, Failure> {
    let found = ratio(flag, text)?;
    if let (Some(e), Some(text)) = (found.filter(|e| e.abs() >= 1.0), text) {
        return Err(no_contraction(flag, text, e));
    }
    Ok(found)
}

fn no_contraction(flag: &str, text: &str, e: f64) -> Failure {
    let text = text.trim();
    let message = format!("{flag}: \"{text}\" is no contraction ratio ΔL/L0, which lies below 1");
    let hint = if e > 1.0 && e < 100.0 && !text.contains('%') {
        format!("write {e}% or {}", e / 100.0)
    } else {
        "write 15% or 0.15".to_owned()
    };
    Failure::input(ProblemKind::Quantity, message, hint)
}

/// A list or range from a flag.
pub fn values(flag: &str, text: Option<&str>, dimension: Dimension) -> Result<Option<Values>, Failure> {
    let wrong = |e: RangeError| {
        let quantity = matches!(e, RangeError::Quantity(_));
        Failure::flag(flag, if quantity { ProblemKind::Quantity } else { ProblemKind::Range }, e)
    };
    text.map(|t| parse_values(t, dimension).map_err(wrong)).transpose()
}

/// A list or range as points; an interval without a step is cut into `divisions` parts.
pub fn points(
    flag: &str,
    text: Option<&str>,
    dimension: Dimension,
    divisions: usize,
) -> Result<Option<Vec<f64>>, Failure> {
    Ok(values(flag, text, dimension)?.map(|v| v.sampled(divisions)))
}

/// Pressures from `--pressure`.
pub fn pressures(text: Option<&str>, divisions: usize) -> Result<Option<Vec<f64>>, Failure> {
    points("--pressure", text, Dimension::Pressure, divisions)
}

/// Contraction ratios from `--contraction`.
pub fn contractions(text: Option<&str>) -> Result<Option<Vec<f64>>, Failure> {
    let list = points("--contraction", text, Dimension::Ratio, 20)?;
    if let (Some(list), Some(text)) = (&list, text)
        && let Some(&e) = list.iter().find(|e| e.abs() >= 1.0)
    {
        return Err(no_contraction("--contraction", text, if list.len() == 1 { e } else { 0.0 }));
    }
    Ok(list)
}

/// Pulls from `--force`.
pub fn forces(text: Option<&str>) -> Result<Option<Vec<f64>>, Failure> {
    points("--force", text, Dimension::Force, 5)
}
