//! From the texts of flags to numbers.

use crate::{Problem, bad_flag};
use mckibben::units::{Dimension, RangeError, Values, parse_quantity, parse_values, short_numbers};
use mckibben_app::ProblemKind;
use std::sync::OnceLock;

pub fn quantity(flag: &str, text: &str, dimension: Dimension) -> Result<f64, Problem> {
    let value =
        parse_quantity(text, dimension).map_err(|e| bad_flag(flag, ProblemKind::Quantity, e))?;
    let text = text.trim();
    if dimension == Dimension::Volume && value != 0.0 && text.parse::<f64>().is_ok() {
        // Volumes are read in mL, and the unit inside is a thousandth of it.
        let message = format!("{flag}: \"{text}\" has no unit, and a bare number is mm³");
        return Err(Problem::new(
            ProblemKind::Quantity,
            message,
            format!("write {text}mL or {text}mm3"),
        ));
    }
    check_unit(flag, text, dimension);
    Ok(value)
}

/// The note on the unit of a pressure that was typed.
static UNIT_NOTE: OnceLock<String> = OnceLock::new();

/// The note on a pressure that was typed as a bare number, beside an answer or a problem.
pub fn unit_hint() -> Option<&'static str> {
    UNIT_NOTE.get().map(String::as_str)
}

/// A bare number is a pressure in MPa; where that is high, bar was probably meant.
fn check_unit(flag: &str, text: &str, dimension: Dimension) {
    const HIGH_MPA: f64 = 1.0;
    if dimension != Dimension::Pressure || !(flag.ends_with("pressure") || flag == "--supply") {
        return;
    }
    let parts = text.split([',', ':']).flat_map(|part| part.split(".."));
    let numbers: Result<Vec<f64>, _> = parts.map(|part| part.trim().parse::<f64>()).collect();
    if let Some(high) = numbers
        .ok()
        .and_then(|list| list.into_iter().find(|p| *p >= HIGH_MPA))
    {
        UNIT_NOTE.get_or_init(|| format!("{flag} {text}: {}", meant(high)));
    }
}

/// Refuses what is no contraction ratio. No muscle shortens by its whole length, so that `15` was
/// meant as 15 %.
pub fn check_contractions(flag: &str, text: &str, list: &[f64]) -> Result<(), Problem> {
    let Some(&e) = list.iter().find(|e| e.abs() >= 1.0) else {
        return Ok(());
    };
    let text = text.trim();
    let message =
        format!("{flag}: \"{text}\" is not a valid contraction ratio ΔL/L0, which lies below 1");
    let hint = if list.len() == 1 && e > 1.0 && e < 100.0 && !text.contains('%') {
        format!("write {e}% or {}", e / 100.0)
    } else {
        "write 15% or 0.15".to_owned()
    };
    Err(Problem::new(ProblemKind::Quantity, message, hint))
}

/// A list or range from a flag.
pub fn values(flag: &str, text: &str, dimension: Dimension) -> Result<Values, Problem> {
    let wrong = |e: RangeError| {
        let quantity = matches!(e, RangeError::Quantity(_));
        bad_flag(
            flag,
            if quantity {
                ProblemKind::Quantity
            } else {
                ProblemKind::Range
            },
            e,
        )
    };
    let values = parse_values(text, dimension).map_err(wrong)?;
    check_unit(flag, text, dimension);
    Ok(values)
}

/// What a bare pressure as high as no muscle bears may have been meant to be.
fn meant(mpa: f64) -> String {
    /// Pressures of muscles in MPa.
    const USUAL: std::ops::RangeInclusive<f64> = 0.08..=1.2;
    let units = ["bar", "psi", "kPa", "mbar", "Pa"];
    let inside = |unit: &str| Some(Dimension::Pressure.unit(unit)?.inside(mpa));
    let likely: Vec<&str> = units
        .into_iter()
        .filter(|unit| inside(unit).is_some_and(|p| USUAL.contains(&p)))
        .collect();
    let [mpa, bar] = [mpa, 10.0 * mpa].map(|v| short_numbers(&v.to_string()).into_owned());
    let said = format!("a bare {mpa} is {mpa} MPa = {bar} bar");
    match likely[..] {
        [] => format!("{said}; for bar write {mpa}bar"),
        [one] => format!("{said}; was {one} meant? write {mpa}{one}"),
        _ => {
            let write: Vec<String> = likely.iter().map(|unit| format!("{mpa}{unit}")).collect();
            format!(
                "{said}; was {} meant? write {}",
                likely.join(" or "),
                write.join(" or ")
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_high_bare_pressure_has_a_likely_unit() {
        for (mpa, said) in [
            (6.0, "6 MPa = 60 bar; was bar meant? write 6bar"),
            (36.0, "36 MPa = 360 bar; was psi meant? write 36psi"),
            (
                100.0,
                "100 MPa = 1000 bar; was psi or kPa meant? write 100psi or 100kPa",
            ),
            (250.0, "was kPa meant? write 250kPa"),
            (250_000.0, "was Pa meant? write 250000Pa"),
            (40.0e6, "for bar write 40000000bar"),
        ] {
            let text = meant(mpa);
            assert!(text.contains(said), "{text}");
        }
    }
}
