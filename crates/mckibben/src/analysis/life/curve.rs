//! The life of a rubber that a user measured: cycles to failure over the load of a cycle.
//!
//! Between neighbouring points ln N is linear in the logarithm of stretch or energy density. Outside of the curve there is no answer.

use serde::Serialize;
use std::fmt;
use thiserror::Error;

/// What the cycles of a curve depend on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum LifeLevel {
    /// The largest stretch of a cycle.
    LargestStretch,
    /// The range of the strain energy density in a cycle, MPa.
    EnergyDensity,
}

impl fmt::Display for LifeLevel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::LargestStretch => "largest stretch",
            Self::EnergyDensity => "range of the energy density in MPa",
        })
    }
}

/// Why a curve gives no life.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum LifeCurveError {
    /// One point is no curve.
    #[error("a life curve needs at least two points with different levels; {points} given")]
    TooFew {
        /// How many there are.
        points: usize,
    },
    /// A number that no test has.
    #[error(
        "{value} is not a valid number of a life curve: stretches are above 1, energies and cycles above 0"
    )]
    NoNumber {
        /// The number.
        value: f64,
    },
    /// More cycles at a higher level.
    #[error(
        "the cycles of a life curve must not rise with its level, and do so up to {level}; give the mean of repeated tests"
    )]
    Rising {
        /// The higher level.
        level: f64,
    },
    /// More cycles than the curve has.
    #[error(
        "{cycles:.3e} cycles are required with their scatter, and the life curve ends at {longest:.3e}: require fewer, or test the rubber longer"
    )]
    TooLong {
        /// Cycles that are required.
        cycles: f64,
        /// The most of the curve.
        longest: f64,
    },
    /// Not within the curve.
    #[error(
        "the {of} is {value:.4}, and the life curve reaches from {low} to {high}: measure the rubber there"
    )]
    Outside {
        /// What the curve depends on.
        of: LifeLevel,
        /// Its value in the muscle.
        value: f64,
        /// The lowest of the curve.
        low: f64,
        /// The highest.
        high: f64,
    },
}

/// Cycles to failure of a rubber.
#[derive(Debug, Clone, PartialEq)]
pub struct LifeCurve {
    of: LifeLevel,
    /// (level, cycles) by rising level.
    points: Vec<(f64, f64)>,
}

impl LifeCurve {
    /// A curve from its points in any order.
    pub fn new(of: LifeLevel, mut points: Vec<(f64, f64)>) -> Result<Self, LifeCurveError> {
        let least = if of == LifeLevel::LargestStretch { 1.0 } else { 0.0 };
        let valid = |&(level, cycles): &(f64, f64)| {
            let is = |value: f64, above: f64| value.is_finite() && value > above;
            if !is(level, least) { Some(level) } else { (!is(cycles, 0.0)).then_some(cycles) }
        };
        if let Some(value) = points.iter().find_map(valid) {
            return Err(LifeCurveError::NoNumber { value });
        }
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        if let Some(pair) = points.windows(2).find(|pair| pair[0].0 == pair[1].0 || pair[1].1 > pair[0].1) {
            return Err(LifeCurveError::Rising { level: pair[1].0 });
        }
        if points.len() < 2 {
            return Err(LifeCurveError::TooFew { points: points.len() });
        }
        Ok(Self { of, points })
    }

    /// What the cycles depend on.
    pub fn of(&self) -> LifeLevel {
        self.of
    }

    /// The lowest and the highest level.
    pub fn reach(&self) -> (f64, f64) {
        (self.points[0].0, self.points[self.points.len() - 1].0)
    }

    /// Cycles to failure at a level.
    pub fn cycles(&self, level: f64) -> Result<f64, LifeCurveError> {
        let (low, high) = self.reach();
        let pair = self.points.windows(2).find(|pair| pair[0].0 <= level && level <= pair[1].0);
        let outside = || LifeCurveError::Outside { of: self.of, value: level, low, high };
        let &[(x0, n0), (x1, n1)] = pair.ok_or_else(outside)? else { return Err(outside()) };
        Ok(n0 * ((n1 / n0).ln() * (level / x0).ln() / (x1 / x0).ln()).exp())
    }

    /// The highest level of the curve at which the rubber lasts so many cycles: below it the rubber lasts as many, or more.
    pub fn level(&self, cycles: f64) -> Result<f64, LifeCurveError> {
        let last = self.points[self.points.len() - 1];
        if cycles <= last.1 {
            return Ok(last.0);
        }
        let pair = self.points.windows(2).rev().find(|pair| pair[1].1 < cycles && cycles <= pair[0].1);
        let longest = LifeCurveError::TooLong { cycles, longest: self.points[0].1 };
        let Some(&[(x0, n0), (x1, n1)]) = pair else { return Err(longest) };
        Ok(x0 * ((x1 / x0).ln() * (cycles / n0).ln() / (n1 / n0).ln()).exp())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A power law N = 8·10⁵ λ⁻⁵ comes back between its points, and no number beyond them.
    #[test]
    fn a_power_law_comes_back_between_its_points_and_ends_with_them() {
        let law = |x: f64| 8e5 * x.powi(-5);
        let points = [3.0, 1.2, 2.0].map(|x| (x, law(x))).to_vec();
        let curve = LifeCurve::new(LifeLevel::LargestStretch, points).unwrap();
        for x in [1.2, 1.5, 2.0, 2.9, 3.0] {
            assert!((curve.cycles(x).unwrap() / law(x) - 1.0).abs() < 1e-12, "{x}");
        }
        let LifeCurveError::Outside { low, high, .. } = curve.cycles(1.19).unwrap_err() else { panic!() };
        assert_eq!((low, high), (1.2, 3.0));
        assert!(curve.cycles(3.01).is_err() && curve.cycles(f64::NAN).is_err());
        for x in [1.2, 1.5, 2.0, 2.9, 3.0] {
            assert!((curve.level(law(x)).unwrap() / x - 1.0).abs() < 1e-12, "{x}");
        }
        // Fewer cycles than at its highest level: the curve says nothing beyond it.
        assert_eq!(curve.level(1.0), Ok(3.0));
        assert!(matches!(curve.level(1.1 * law(1.2)), Err(LifeCurveError::TooLong { .. })));
    }

    #[test]
    fn a_curve_that_is_none_is_refused() {
        let of = |level, points: &[(f64, f64)]| LifeCurve::new(level, points.to_vec()).unwrap_err();
        let stretch = LifeLevel::LargestStretch;
        assert_eq!(of(stretch, &[(2.0, 1e5)]), LifeCurveError::TooFew { points: 1 });
        assert_eq!(of(stretch, &[(2.0, 1e5), (1.0, 1e7)]), LifeCurveError::NoNumber { value: 1.0 });
        assert_eq!(of(stretch, &[(2.0, 1e5), (3.0, 0.0)]), LifeCurveError::NoNumber { value: 0.0 });
        assert_eq!(of(stretch, &[(2.0, 1e5), (3.0, 2e5)]), LifeCurveError::Rising { level: 3.0 });
        let energy = LifeLevel::EnergyDensity;
        assert_eq!(of(energy, &[(0.5, 1e5), (0.5, 2e5)]), LifeCurveError::Rising { level: 0.5 });
        assert!(LifeCurve::new(energy, vec![(0.5, 1e5), (0.7, 1e4)]).is_ok());
    }
}
