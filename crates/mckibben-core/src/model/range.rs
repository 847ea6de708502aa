//! The pressures, contractions and measures for which a model is valid.

use super::{
    ModelError, Result,
    interval::{Quantity, RangeViolation},
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
    /// What of the muscle lies outside of the bounds on its measures.
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
    pub(super) fn with_measures<const N: usize>(
        self,
        measures: [(Quantity, (f64, f64), f64); N],
    ) -> Self {
        let outside = |(quantity, bounds, value): (Quantity, (f64, f64), f64)| {
            RangeViolation::of(quantity, bounds, value, 1e-9 * bounds.0.abs().max(1.0))
        };
        Self {
            muscle: measures.into_iter().filter_map(outside).collect(),
            ..self
        }
    }

    /// Everything that is outside at a pressure and contraction, the muscle's own violations first.
    pub fn violations(&self, pressure_mpa: f64, contraction: f64) -> Vec<RangeViolation> {
        // The comparison is exact but for the last bits of a sum such as 0.1 + 0.15.
        let outside = |quantity, bounds, value| RangeViolation::of(quantity, bounds, value, 1e-12);
        let pressure = outside(("pressure", "MPa"), self.pressure_mpa, pressure_mpa);
        let contraction = outside(("contraction", ""), self.contraction, contraction);
        let muscle = self.muscle.iter().copied();
        muscle.chain(pressure).chain(contraction).collect()
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
