//! Ranges and lists of quantities.

use super::{
    convert::{convert, tidy},
    dimension::Dimension,
    quantity::{QuantityError, factor, plausible, shortened, split},
};
use thiserror::Error;

/// The most points a range or list may hold.
pub const MAX_POINTS: usize = 1_000_000;

/// What `--wall 1..5`, `--wall 1..5:0.5` and `--wall 1,2,3` mean.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Single values: one number, a list, or a range with a step (both ends in).
    List(Vec<f64>),
    /// Everything between two ends: a range without a step.
    Interval(f64, f64),
}

impl Values {
    /// The values themselves; an interval is cut into `divisions` equal parts, both ends in.
    pub fn sampled(&self, divisions: usize) -> Vec<f64> {
        match self {
            Values::List(list) => list.clone(),
            Values::Interval(low, high) => {
                let n = divisions.max(1);
                (0..=n)
                    .map(|i| tidy(low + (high - low) * i as f64 / n as f64, 12))
                    .collect()
            }
        }
    }

    /// Smallest and largest value.
    pub fn bounds(&self) -> (f64, f64) {
        match self {
            Values::Interval(low, high) => (*low, *high),
            Values::List(list) => list
                .iter()
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &v| {
                    (a.min(v), b.max(v))
                }),
        }
    }
}

/// Why a text is not a range or list.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RangeError {
    /// One of its numbers cannot be read.
    #[error("{0}")]
    Quantity(#[from] QuantityError),
    /// What is wrong with it otherwise.
    #[error("{0}")]
    Form(String),
}

/// Reads a number, a list `1,2,3`, a range `0..0.25` or a range with a step `0..0.25:0.01`. A unit
/// behind the last number holds for all that carry none (`0..2.5:0.1bar`, `20,80,150N`).
///
/// ```
/// use mckibben_units::{Dimension, Values, parse_values};
/// let p = parse_values("0..2.5:0.5bar", Dimension::Pressure)?;
/// assert_eq!(p, Values::List(vec![0.0, 0.05, 0.1, 0.15, 0.2, 0.25]));
/// # Ok::<(), mckibben_units::RangeError>(())
/// ```
pub fn parse_values(text: &str, dimension: Dimension) -> Result<Values, RangeError> {
    let text = text.trim();
    let parsed = if let Some((low, rest)) = text.split_once("..") {
        let (high, step) = match rest.split_once(':') {
            Some((high, step)) => (high, Some(step)),
            None => (rest, None),
        };
        let mut parts = vec![split(low, dimension)?, split(high, dimension)?];
        if let Some(step) = step {
            parts.push(split(step, dimension)?);
        }
        range(&parts, text, dimension)?
    } else if text.contains(':') {
        return Err(RangeError::Form(format!(
            "\"{text}\" has a step but no range: write low..high:step"
        )));
    } else {
        let count = text.bytes().filter(|b| *b == b',').count() + 1;
        if count > MAX_POINTS {
            return Err(too_many(text, count as f64));
        }
        let parts = text
            .split(',')
            .map(|p| split(p, dimension))
            .collect::<Result<Vec<_>, _>>()?;
        let factors = factors(&parts, text, dimension)?;
        Values::List(
            parts
                .iter()
                .zip(factors)
                .map(|(p, f)| convert(p.0, f))
                .collect(),
        )
    };
    let all = parsed.sampled(1);
    if !all.iter().all(|value| value.is_finite()) {
        return Err(QuantityError::not_finite(&shortened(text), dimension).into());
    }
    if all.into_iter().all(plausible) {
        Ok(parsed)
    } else {
        Err(QuantityError::beyond(&shortened(text), dimension).into())
    }
}

fn range(parts: &[(f64, &str)], text: &str, dimension: Dimension) -> Result<Values, RangeError> {
    let factors = factors(parts, text, dimension)?;
    let value = |i: usize| convert(parts[i].0, factors[i]);
    let low = value(0);
    let high = value(1);
    if low > high {
        return Err(RangeError::Form(format!(
            "the range \"{text}\" is reversed: write the smaller value first"
        )));
    }
    if parts.len() < 3 {
        return Ok(Values::Interval(low, high));
    }
    let step = value(2);
    if step <= 0.0 {
        return Err(RangeError::Form(format!(
            "the step in \"{text}\" must be above zero"
        )));
    }
    let steps = (high - low) / step;
    if steps.is_nan() || steps >= MAX_POINTS as f64 {
        return Err(too_many(text, steps + 1.0));
    }
    // Counted in the step's own unit, so that the points are the decimals the user had in mind.
    let (num, den) = factors[2];
    let from = low * den / num;
    let by = parts[2].0;
    let whole = (steps + 1e-9).floor() as usize;
    let mut list: Vec<f64> = (0..=whole)
        .map(|i| convert(tidy(from + by * i as f64, 12), factors[2]))
        .collect();
    if let Some(last) = list.last_mut() {
        if (*last - high).abs() <= 1e-9 * step {
            *last = high;
        } else {
            list.push(high);
        }
    }
    Ok(Values::List(list))
}

/// The unit of each part: its own, or the last one's where only that carries one.
fn factors(
    parts: &[(f64, &str)],
    text: &str,
    dimension: Dimension,
) -> Result<Vec<(f64, f64)>, RangeError> {
    let last = parts.last().map_or("", |p| p.1);
    // Zero is zero in every unit.
    let bare = parts.iter().any(|p| p.1.is_empty() && p.0 != 0.0);
    let units = parts.iter().filter(|p| !p.1.is_empty()).count();
    if bare && units > usize::from(!last.is_empty()) {
        let text = shortened(text);
        return Err(RangeError::Form(format!(
            "in \"{text}\" some values carry a unit and some do not: put one unit after the last \
             value, or one after each"
        )));
    }
    parts
        .iter()
        .map(|p| if p.1.is_empty() { last } else { p.1 })
        .map(|unit| factor(unit, &shortened(text), dimension).map_err(RangeError::from))
        .collect()
}

fn too_many(text: &str, points: f64) -> RangeError {
    let text = shortened(text);
    RangeError::Form(format!(
        "\"{text}\" makes {points:.3e} points, more than {MAX_POINTS}: take a larger step"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_list(text: &str, dimension: Dimension, list: &[f64]) {
        assert_eq!(
            parse_values(text, dimension),
            Ok(Values::List(list.to_vec())),
            "{text}"
        );
    }

    #[test]
    fn both_ends_are_in_and_decimals_stay_decimals() {
        let Values::List(list) = parse_values("0..0.25:0.01", Dimension::Pressure).unwrap() else {
            panic!()
        };
        assert_eq!((list.len(), list[15], list[25]), (26, 0.15, 0.25));
        is_list("0..20:5%", Dimension::Ratio, &[0.0, 0.05, 0.10, 0.15, 0.20]);
        // A step that does not divide the range still ends at the end.
        is_list("0..1:0.4", Dimension::Ratio, &[0.0, 0.4, 0.8, 1.0]);
    }

    #[test]
    fn one_unit_behind_the_last_holds_for_all() {
        is_list("1,2,3bar", Dimension::Pressure, &[0.1, 0.2, 0.3]);
        assert_eq!(
            parse_values("1bar..2.5bar", Dimension::Pressure),
            Ok(Values::Interval(0.1, 0.25))
        );
        for mixed in ["1bar,2,3bar", "1bar,2", "0..2bar:1"] {
            let refused = parse_values(mixed, Dimension::Pressure);
            assert!(matches!(refused, Err(RangeError::Form(_))), "{refused:?}");
        }
    }

    #[test]
    fn zero_needs_no_unit() {
        is_list("0,10%,20%", Dimension::Ratio, &[0.0, 0.1, 0.2]);
        is_list("0..10%:5%", Dimension::Ratio, &[0.0, 0.05, 0.1]);
        is_list("-1bar,0", Dimension::Pressure, &[-0.1, 0.0]);
        is_list("0,1,2", Dimension::Pressure, &[0.0, 1.0, 2.0]);
    }

    #[test]
    fn ranges_that_make_no_sense_are_refused() {
        for text in ["5..1", "1..5:0", "0..1:1e-9", "3:1"] {
            let refused = parse_values(text, Dimension::Length);
            assert!(matches!(refused, Err(RangeError::Form(_))), "{refused:?}");
        }
        for text in ["..", "1,,2", "1..2..3"] {
            assert!(parse_values(text, Dimension::Length).is_err(), "{text}");
        }
    }
}
