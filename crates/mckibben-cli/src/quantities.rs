//! From the texts of flags to numbers.

use crate::failure::Failure;
use crate::typed::meant;
use mckibben::units::{Dimension, RangeError, Values, parse_quantity, parse_values};
use mckibben_app::ProblemKind;
use std::sync::OnceLock;

pub fn quantity(flag: &str, text: Option<&str>, dimension: Dimension) -> Result<Option<f64>, Failure> {
    let wrong = |e| Failure::flag(flag, ProblemKind::Quantity, e);
    let one =
        |t: &str| parse_quantity(t, dimension).map_err(wrong).inspect(|_| mind_the_unit(flag, t, dimension));
    text.map(one).transpose()
}

/// What to mind about the unit of a pressure that was typed.
static MIND: OnceLock<String> = OnceLock::new();

/// What the user should mind about a pressure that was typed as a bare number; to be said beside an answer, and where there is none.
pub fn unit_hint() -> Option<&'static str> {
    MIND.get().map(String::as_str)
}

/// A bare number is a pressure in MPa; where that is high, bar was probably meant.
fn mind_the_unit(flag: &str, text: &str, dimension: Dimension) {
    const HIGH_MPA: f64 = 1.0;
    if dimension != Dimension::Pressure || !(flag.ends_with("pressure") || flag == "--supply") {
        return;
    }
    let parts = text.split([',', ':']).flat_map(|part| part.split(".."));
    let numbers: Result<Vec<f64>, _> = parts.map(|part| part.trim().parse::<f64>()).collect();
    if let Some(high) = numbers.ok().and_then(|list| list.into_iter().find(|p| *p >= HIGH_MPA)) {
        MIND.get_or_init(|| format!("{flag} {text}: {}", meant(high)));
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
    let message = format!("{flag}: \"{text}\" is not a valid contraction ratio ΔL/L0, which lies below 1");
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
    let all =
        |t: &str| parse_values(t, dimension).map_err(wrong).inspect(|_| mind_the_unit(flag, t, dimension));
    text.map(all).transpose()
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
