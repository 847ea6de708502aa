//! Axis ranges and ticks at 1, 2 or 5 times a power of ten, and how numbers are written.

use crate::figure::{Axis, FigureError, Result};
use mckibben_units::tidy;

/// The drawn range of an axis with its ticks.
#[derive(Debug)]
pub struct Scale {
    pub low: f64,
    pub high: f64,
    /// Places of the ticks, rising, all within the range.
    pub ticks: Vec<f64>,
    /// Text of each tick, in units of 10^`exponent`.
    pub labels: Vec<String>,
    /// Power of ten taken out of the tick texts (a multiple of 3, mostly 0).
    pub exponent: i32,
}

impl Scale {
    /// Where a value lies in the range: 0 at the low end, 1 at the high end.
    pub fn part(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }
}

/// Lowest and highest finite value, if there is any.
pub fn extent(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values
        .filter(|v| v.is_finite())
        .fold(None, |seen, v| match seen {
            None => Some((v, v)),
            Some((low, high)) => Some((v.min(low), v.max(high))),
        })
}

/// Chooses range and ticks of an axis with about `wanted` intervals.
pub fn scale(axis: &Axis, data: Option<(f64, f64)>, wanted: usize) -> Result<Scale> {
    let wrong = |low: f64, high: f64| {
        let name = &axis.label;
        FigureError::Drawing(format!(
            "axis \"{name}\": {low} to {high} is not a range that can be drawn"
        ))
    };
    if let Some((low, high)) = axis.range {
        let span = high - low;
        // the span must be finite, positive and not lost in the rounding of its ends
        if !(span.is_finite()
            && span > 1e-12 * low.abs().max(high.abs())
            && span >= f64::MIN_POSITIVE * 1e20)
        {
            return Err(wrong(low, high));
        }
        return Ok(finish(low, high, wanted, false));
    }
    let (mut low, mut high) = data.unwrap_or((0.0, 1.0));
    if axis.from_zero {
        low = low.min(0.0);
        high = high.max(0.0);
    }
    if !(high - low).is_finite() || low.abs().max(high.abs()) > 1e300 {
        return Err(wrong(low, high));
    }
    (low, high) = widen(low, high);
    Ok(finish(low, high, wanted, true))
}

/// Gives values that are all (nearly) equal a range around them.
fn widen(low: f64, high: f64) -> (f64, f64) {
    let size = low.abs().max(high.abs());
    if size < 1e-280 {
        return (if low < 0.0 { -1.0 } else { 0.0 }, 1.0);
    }
    if high - low > 1e-9 * size {
        (low, high)
    } else {
        (low - 0.1 * size, high + 0.1 * size)
    }
}

/// The 1-2-5 step whose ticks fit best: near the wanted number, little empty room.
fn best_step(low: f64, high: f64, wanted: usize, outward: bool) -> f64 {
    let wanted = wanted.max(1) as f64;
    let span = high - low;
    let around = (span / wanted).log10().floor() as i32;
    let mut best = (f64::INFINITY, span);
    for exponent in around - 1..=around + 1 {
        for digit in [1.0, 2.0, 5.0] {
            let step = digit * 10f64.powi(exponent);
            let covered = if outward {
                let (first, last) = outer(low, high, step);
                (last - first) * step
            } else {
                span
            };
            let count = covered / step;
            if !(0.9..=2.2 * wanted).contains(&count) {
                continue;
            }
            let crowding = (count / wanted).ln().abs();
            let waste = covered / span - 1.0;
            let liking = if digit == 2.0 { 0.02 } else { 0.0 };
            let cost = 0.6 * crowding + 1.5 * waste + liking;
            if cost < best.0 {
                best = (cost, step);
            }
        }
    }
    best.1
}

/// Numbers of the tick at or below `low` and at or above `high`.
fn outer(low: f64, high: f64, step: f64) -> (f64, f64) {
    // an end that is a tick but for rounding stays on that tick
    ((low / step + 1e-9).floor(), (high / step - 1e-9).ceil())
}

fn finish(low: f64, high: f64, wanted: usize, outward: bool) -> Scale {
    let step = best_step(low, high, wanted, outward);
    let (first, last) = if outward {
        outer(low, high, step)
    } else {
        ((low / step - 1e-9).ceil(), (high / step + 1e-9).floor())
    };
    let count = (last - first).clamp(0.0, 200.0) as usize;
    // 0.3, not 0.30000000000000004.
    let tick = |i: usize| tidy((first + i as f64) * step, 15);
    let mut ticks: Vec<f64> = (0..=count).map(tick).collect();
    let (low, high) = if outward {
        let from = ticks.first().copied().unwrap_or(low);
        let to = ticks.last().copied().unwrap_or(high);
        (from.min(low), to.max(high))
    } else {
        ticks.retain(|t| *t >= low - 1e-9 * step && *t <= high + 1e-9 * step);
        (low, high)
    };
    let exponent = exponent_for(low, high);
    let labels = ticks
        .iter()
        .map(|t| tick_text(*t, step, exponent))
        .collect();
    Scale {
        low,
        high,
        ticks,
        labels,
        exponent,
    }
}

/// Decimals needed to write a 1-2-5 step (negative for steps of ten and more).
fn decimals_of(step: f64) -> i32 {
    -((step.log10() + 1e-9).floor() as i32)
}

/// Power of ten to take out of the tick texts so that they stay short.
fn exponent_for(low: f64, high: f64) -> i32 {
    let size = low.abs().max(high.abs());
    if (1e-2..1e5).contains(&size) {
        0
    } else {
        ((size.log10() + 1e-9) / 3.0).floor() as i32 * 3
    }
}

fn tick_text(tick: f64, step: f64, exponent: i32) -> String {
    let decimals = (decimals_of(step) + exponent).clamp(0, 15) as usize;
    let scaled = if exponent == 0 {
        tick
    } else {
        tick / 10f64.powi(exponent)
    };
    typographic(&format!("{scaled:.decimals$}"))
}

/// Writes `-` as a minus sign and drops the sign of a zero.
pub fn typographic(text: &str) -> String {
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|b| matches!(b, b'0' | b'.')) => rest.to_owned(),
        Some(rest) => format!("\u{2212}{rest}"),
        None => text.to_owned(),
    }
}

/// `×10³` and the like.
pub fn power_text(exponent: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digits = exponent.to_string();
    let raised = digits
        .chars()
        .map(|c| c.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize]));
    "×10".chars().chain(raised).collect()
}
