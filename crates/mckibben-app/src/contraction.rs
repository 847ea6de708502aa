//! A contraction in a request: a ratio, a percentage, or a shortening whose ratio follows from the
//! length of the muscle.

use crate::{Problem, ProblemKind, Result, finite};
use mckibben_core::units::{
    Dimension, RangeError, tidy,
    typed::{Length, List, Ratio},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::str::FromStr;

/// Contraction ratios ε = ΔL/L0, each a number below 1 or a percentage; or shortenings ΔL, such as
/// 22mm. As text a list or a range of them.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "Given", into = "Vec<f64>")]
#[schemars(with = "List<Ratio>", inline)]
pub struct Contractions {
    values: Vec<f64>,
    /// They are shortenings in mm.
    in_mm: bool,
}

/// One of [`Contractions`].
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "Given", into = "f64")]
#[schemars(with = "Ratio", inline)]
pub struct Contraction(Contractions);

/// What JSON may have in its place.
#[derive(Deserialize)]
#[serde(untagged, expecting = "a contraction ratio is expected, such as 0.15")]
enum Given {
    One(f64),
    Several(Vec<f64>),
    Text(String),
}

impl Contractions {
    /// The ratios, of a muscle of the length L0 in mm.
    pub fn of_length(&self, length_mm: f64) -> Result<Vec<f64>> {
        let of_length = |value: &f64| match self.in_mm {
            true => tidy(value / length_mm, 15),
            false => *value,
        };
        self.values
            .iter()
            .map(|value| ratio(of_length(value)))
            .collect::<Result<_>>()
            .map_err(|problem| match self.in_mm {
                true => problem.with_hint(format!("the muscle is {length_mm} mm long")),
                false => problem,
            })
    }
}

impl Contraction {
    /// The ratio, of a muscle of the length L0 in mm.
    pub fn of_length(&self, length_mm: f64) -> Result<f64> {
        Ok(self
            .0
            .of_length(length_mm)?
            .first()
            .copied()
            .unwrap_or_default())
    }
}

impl From<f64> for Contraction {
    fn from(ratio: f64) -> Self {
        Self(vec![ratio].into())
    }
}

impl From<Vec<f64>> for Contractions {
    fn from(values: Vec<f64>) -> Self {
        Self {
            values,
            in_mm: false,
        }
    }
}

impl From<Contractions> for Vec<f64> {
    fn from(contractions: Contractions) -> Self {
        contractions.values
    }
}

impl From<Contraction> for f64 {
    fn from(contraction: Contraction) -> Self {
        contraction.0.values.first().copied().unwrap_or_default()
    }
}

impl FromStr for Contractions {
    type Err = Problem;

    fn from_str(text: &str) -> Result<Self> {
        let text = text.trim();
        let unit = text.trim_start_matches(|c: char| !c.is_alphabetic() && c != '%');
        let in_mm = !unit.is_empty() && Dimension::Length.unit(unit).is_some();
        let values = if in_mm {
            text.parse::<List<Length>>().map(|list| list.0)
        } else {
            text.parse::<List<Ratio>>().map(|list| list.0)
        };
        Ok(Self {
            values: values.map_err(|error| {
                let kind = match error {
                    RangeError::Quantity(_) => ProblemKind::Quantity,
                    RangeError::Form(_) => ProblemKind::Range,
                };
                kind.problem(error)
            })?,
            in_mm,
        })
    }
}

impl FromStr for Contraction {
    type Err = Problem;

    fn from_str(text: &str) -> Result<Self> {
        let contractions: Contractions = text.parse()?;
        if contractions.values.len() == 1 {
            return Ok(Self(contractions));
        }
        let error = text.parse::<Ratio>().err();
        Err(ProblemKind::Quantity
            .problem(error.map_or_else(String::new, |error| error.to_string())))
    }
}

impl TryFrom<Given> for Contractions {
    type Error = Problem;

    fn try_from(given: Given) -> Result<Self> {
        match given {
            Given::One(ratio) => Ok(vec![ratio].into()),
            Given::Several(ratios) => Ok(ratios.into()),
            Given::Text(text) => text.parse(),
        }
    }
}

impl TryFrom<Given> for Contraction {
    type Error = Problem;

    fn try_from(given: Given) -> Result<Self> {
        match given {
            Given::One(ratio) => Ok(ratio.into()),
            Given::Text(text) => text.parse(),
            Given::Several(_) => {
                Err(ProblemKind::Quantity.problem("one contraction is needed, not a list"))
            }
        }
    }
}

/// A contraction ratio. No muscle shortens by its whole length, so that 15 was meant as 15 %.
pub fn ratio(contraction: f64) -> Result<f64> {
    let e = finite("contraction", contraction)?;
    if is_ratio(e) {
        Ok(e)
    } else {
        Err(no_ratio("contraction", e))
    }
}

/// Whether a number may be a contraction ratio: muscles that extend may become more than twice as
/// long.
pub fn is_ratio(e: f64) -> bool {
    const LONGEST: f64 = -1.5;
    e > LONGEST && e < 1.0
}

/// A number that is no contraction ratio.
pub fn no_ratio(field: &str, e: f64) -> Problem {
    let message = format!("{e} is not a valid contraction ratio ΔL/L0, which lies below 1");
    // Less is a percentage that was read as one.
    let hint = if (2.0..100.0).contains(&e) {
        format!("write {e}% or {}", e / 100.0)
    } else {
        "write 15% or 0.15".to_owned()
    };
    Problem::new(ProblemKind::Quantity, message, hint).in_field(field)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: 22 mm of 220 mm are a tenth.
    #[test]
    fn a_shortening_is_a_ratio_of_the_length() {
        for (text, ratio) in [("22mm", 0.1), ("15%", 0.15), ("0.2", 0.2)] {
            let read: Contraction = text.parse().unwrap();
            assert_eq!(read.of_length(220.0), Ok(ratio), "{text}");
        }
        let curve: Contractions = "0..22:11mm".parse().unwrap();
        assert_eq!(curve.of_length(220.0), Ok(vec![0.0, 0.05, 0.1]));
        let fifteen: Contraction = "15".parse().unwrap();
        let refused = fifteen.of_length(220.0).unwrap_err();
        assert_eq!(refused.hint, "write 15% or 0.15");
        // What was typed as a percentage or a length is not answered as a number.
        for typed in ["150 %", "1.5", "300mm"] {
            let read: Contraction = typed.parse().unwrap();
            let hint = read.of_length(200.0).unwrap_err().hint;
            assert!(!hint.contains("1.5%"), "{typed}: {hint}");
        }
    }
}
