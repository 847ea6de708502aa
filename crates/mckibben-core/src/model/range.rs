//! The pressures, contractions and measures for which a model is valid.

use super::{
    ModelError, Result,
    interval::{Interval, Quantity, RangeViolation},
};
use crate::muscle::Muscle;

/// The box of a model for one muscle: pressures and contractions, the measures it was made for, and
/// what of the muscle lies outside.
#[must_use]
#[derive(Debug, Clone, PartialEq)]
pub struct ModelRange {
    /// Lowest and highest pressure in MPa.
    pub pressure_mpa: (f64, f64),
    /// Lowest and highest contraction ratio.
    pub contraction: (f64, f64),
    /// Bounds of the muscle's measures; empty where any will do.
    pub measures: Vec<Interval>,
    /// What of the muscle lies outside of them.
    pub muscle: Vec<RangeViolation>,
    /// Parts of the muscle that differ from what the model was made for and are not numbers
    /// ("the rubber is dragon-skin-30, the formula is for `antonelli2018`").
    pub make: Vec<String>,
}

impl ModelRange {
    /// Any pressure from zero, contractions from 0 to below 1, any muscle.
    pub fn open() -> Self {
        Self {
            pressure_mpa: (0.0, f64::INFINITY),
            contraction: (0.0, 1.0),
            measures: vec![],
            muscle: vec![],
            make: vec![],
        }
    }

    /// The same, of a muscle that extends also below 0.
    pub fn for_muscle(muscle: &Muscle) -> Self {
        let open = Self::open();
        if muscle.is_extensile() {
            open.stretched(muscle.braid().angle_deg)
        } else {
            open
        }
    }

    /// The same, also for muscles that a load stretches: until strands at this angle at rest, in
    /// degrees, are straight and as long as no strand becomes.
    pub fn stretched(self, angle_deg: f64) -> Self {
        /// Fibres of sleeves break at strains of 0.03 (aramid) to about 0.2 (polyamide).
        const LONGEST: f64 = 1.2;
        let lowest = 1.0 - LONGEST / angle_deg.to_radians().cos();
        Self {
            contraction: ((1e4 * lowest).floor() / 1e4, self.contraction.1),
            ..self
        }
    }

    /// The same with bounds on measures of the muscle, of which each is given with its value.
    pub fn with_measures(self, measures: &[(Interval, f64)]) -> Self {
        Self {
            measures: measures.iter().map(|m| m.0).collect(),
            muscle: measures
                .iter()
                .filter_map(|(interval, value)| {
                    interval.violation(*value, 1e-9 * interval.low.abs().max(1.0))
                })
                .collect(),
            ..self
        }
    }

    fn of_state(&self) -> [Interval; 2] {
        let pressure = Interval::new(Quantity::PRESSURE, self.pressure_mpa);
        [
            pressure,
            Interval::new(Quantity::CONTRACTION, self.contraction),
        ]
    }

    /// Everything that is outside at a pressure and contraction, the muscle's own violations first.
    pub fn violations(&self, pressure_mpa: f64, contraction: f64) -> Vec<RangeViolation> {
        let values = self.of_state().into_iter().zip([pressure_mpa, contraction]);
        // The comparison is exact but for the last bits of a sum such as 0.1 + 0.15.
        let outside = values.filter_map(|(interval, value)| interval.violation(value, 1e-12));
        self.muscle.iter().copied().chain(outside).collect()
    }

    /// Refuses what is outside.
    pub fn check(&self, model: &str, pressure_mpa: f64, contraction: f64) -> Result<()> {
        let violations = self.violations(pressure_mpa, contraction);
        if violations.is_empty() && self.make.is_empty() {
            return Ok(());
        }
        Err(ModelError::OutOfRange {
            model: model.into(),
            violations,
            make: self.make.clone(),
        })
    }
}
