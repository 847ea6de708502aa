//! What is commanded over time.

use crate::{MotionError, Result, error::within};
use mckibben_core::extremes::ends;
use std::f64::consts::TAU;

/// A value over time: pressure in MPa, opening, or position.
#[derive(Debug, Clone, PartialEq)]
pub enum Command {
    /// Always the same.
    Constant(f64),
    /// (time in s, value): the value from that time on; before the first time the first value.
    Steps(Vec<(f64, f64)>),
    /// (time in s, value) joined by straight lines; constant before and after. A sampled table is
    /// one.
    Ramps(Vec<(f64, f64)>),
    /// mean + amplitude sin(2π f t + phase).
    Sine {
        /// Mean.
        mean: f64,
        /// Amplitude.
        amplitude: f64,
        /// f in Hz.
        frequency_hz: f64,
        /// Phase in rad.
        phase_rad: f64,
    },
    /// A sine whose frequency grows linearly from one to the other within a time, and stays.
    Chirp {
        /// Mean.
        mean: f64,
        /// Amplitude.
        amplitude: f64,
        /// First frequency in Hz.
        from_hz: f64,
        /// Last frequency in Hz.
        to_hz: f64,
        /// Within this time in s.
        duration_s: f64,
    },
}

impl Command {
    /// The same in another unit.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        match &mut self {
            Self::Constant(value) => *value *= factor,
            Self::Steps(points) | Self::Ramps(points) => {
                points.iter_mut().for_each(|p| p.1 *= factor)
            }
            Self::Sine {
                mean, amplitude, ..
            }
            | Self::Chirp {
                mean, amplitude, ..
            } => {
                *mean *= factor;
                *amplitude *= factor;
            }
        }
        self
    }

    /// A sampled table of times and values.
    ///
    /// # Errors
    /// [`MotionError::Refused`] where times do not grow strictly or a number is not finite.
    pub fn table(points: Vec<(f64, f64)>) -> Result<Self> {
        let table = Self::Ramps(points);
        table.check()?;
        Ok(table)
    }

    /// Whether it is a command.
    pub fn check(&self) -> Result<()> {
        let require = |holds: bool, what: &str, value, must| {
            let refused = || MotionError::value(&format!("the command's {what}"), value, must);
            holds.then_some(()).ok_or_else(refused)
        };
        let finite =
            |what: &str, value: f64| require(value.is_finite(), what, value, "a finite number");
        let positive = |what: &str, value: f64| {
            finite(what, value).and(require(value > 0.0, what, value, "above zero"))
        };
        match self {
            Self::Constant(value) => finite("value", *value),
            Self::Steps(points) | Self::Ramps(points) => {
                MotionError::require(!points.is_empty(), || {
                    "a command needs at least one time and value".into()
                })?;
                points
                    .iter()
                    .try_for_each(|p| finite("time", p.0).and(finite("value", p.1)))?;
                for (number, pair) in (2..).zip(points.windows(2)) {
                    let before = pair[0].0;
                    let after = pair[1].0;
                    MotionError::require(after > before, || {
                        format!(
                            "the command's times must increase: {after} s follows {before} s (point \
                             {number})"
                        )
                    })?;
                }
                Ok(())
            }
            Self::Sine {
                mean,
                amplitude,
                frequency_hz,
                phase_rad,
            } => {
                finite("mean", *mean)?;
                finite("amplitude", *amplitude)?;
                finite("phase", *phase_rad)?;
                positive("frequency in Hz", *frequency_hz)
            }
            Self::Chirp {
                mean,
                amplitude,
                from_hz,
                to_hz,
                duration_s,
            } => {
                finite("mean", *mean)?;
                finite("amplitude", *amplitude)?;
                positive("first frequency in Hz", *from_hz)?;
                positive("last frequency in Hz", *to_hz)?;
                positive("duration in s", *duration_s)
            }
        }
    }

    /// The value at a time, by the piece that holds at the time `within`: at a breakpoint the side
    /// of `within` counts.
    pub fn value_within(&self, time_s: f64, within: f64) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Steps(points) => points
                .get(points.partition_point(|p| p.0 <= within).saturating_sub(1))
                .map_or(0.0, |p| p.1),
            Self::Ramps(points) => {
                let after = points.partition_point(|p| p.0 <= within);
                let last = points.len().saturating_sub(1);
                match (
                    after.checked_sub(1).and_then(|i| points.get(i)),
                    points.get(after),
                ) {
                    (Some(a), Some(b)) => a.1 + (b.1 - a.1) * (time_s - a.0) / (b.0 - a.0),
                    (None, Some(b)) => b.1,
                    _ => points.get(last).map_or(0.0, |p| p.1),
                }
            }
            Self::Sine {
                mean,
                amplitude,
                frequency_hz,
                phase_rad,
            } => mean + amplitude * (TAU * frequency_hz * time_s + phase_rad).sin(),
            Self::Chirp {
                mean,
                amplitude,
                from_hz,
                to_hz,
                duration_s,
            } => {
                let rate = (to_hz - from_hz) / duration_s;
                let phase = if within < *duration_s {
                    (from_hz + 0.5 * rate * time_s) * time_s
                } else {
                    0.5 * (from_hz + to_hz) * duration_s + to_hz * (time_s - duration_s)
                };
                mean + amplitude * (TAU * phase).sin()
            }
        }
    }

    /// The value at a time, after a step there.
    pub fn value(&self, time_s: f64) -> f64 {
        self.value_within(time_s, time_s)
    }

    /// Where the integration begins anew.
    pub fn breakpoints(&self) -> Vec<f64> {
        match self {
            Self::Constant(_) | Self::Sine { .. } => vec![],
            Self::Steps(points) | Self::Ramps(points) => points.iter().map(|p| p.0).collect(),
            Self::Chirp { duration_s, .. } => vec![*duration_s],
        }
    }

    /// Smallest and largest value it can take.
    pub fn bounds(&self) -> (f64, f64) {
        match self {
            Self::Constant(value) => (*value, *value),
            Self::Steps(points) | Self::Ramps(points) => ends(points.iter().map(|p| p.1)),
            Self::Sine {
                mean, amplitude, ..
            }
            | Self::Chirp {
                mean, amplitude, ..
            } => (mean - amplitude.abs(), mean + amplitude.abs()),
        }
    }

    pub(crate) fn check_bounds(&self, what: &'static str, low: f64, high: f64) -> Result<()> {
        let (least, most) = self.bounds();
        within(what, least, low, high)?;
        within(what, most, low, high)
    }

    /// Its period in s, if it is periodic.
    pub fn period_s(&self) -> Option<f64> {
        if let Self::Sine { frequency_hz, .. } = self {
            Some(1.0 / frequency_hz)
        } else {
            None
        }
    }
}
