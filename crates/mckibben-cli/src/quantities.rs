//! From the texts of flags to numbers.

use crate::failure::Failure;
use crate::output::warn;
use mckibben::units::{Dimension, RangeError, Values, parse_quantity, parse_values};
use mckibben_app::ProblemKind;
use std::sync::Once;

/// A quantity from a flag.
pub fn quantity(flag: &str, text: Option<&str>, dimension: Dimension) -> Result<Option<f64>, Failure> {
    mind_the_unit(flag, text, dimension);
    let wrong = |e| Failure::flag(flag, ProblemKind::Quantity, e);
    text.map(|t| parse_quantity(t, dimension).map_err(wrong)).transpose()
}

/// Says once that a bare number is a pressure in MPa, where that is so high that bar was probably meant.
fn mind_the_unit(flag: &str, text: Option<&str>, dimension: Dimension) {
    static SAID: Once = Once::new();
    const HIGH_MPA: f64 = 1.0;
    let Some(text) = text.filter(|_| dimension == Dimension::Pressure && flag.ends_with("pressure")) else {
        return;
    };
    let bare =
        text.split([',', ':']).flat_map(|part| part.split("..")).map(|part| part.trim().parse::<f64>());
    let Ok(numbers) = bare.collect::<Result<Vec<f64>, _>>() else { return };
    if let Some(high) = numbers.into_iter().find(|p| *p >= HIGH_MPA) {
        SAID.call_once(|| {
            warn(format!(
                "{flag} {text}: a bare {high} is {high} MPa = {} bar; for bar write {high}bar",
                10.0 * high
            ));
        });
    }
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
    mind_the_unit(flag, text, dimension);
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
