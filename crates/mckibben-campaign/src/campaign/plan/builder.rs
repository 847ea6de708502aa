//! A plan from a muscle, without a file.

use super::{Plan, SamplingMethod, vary::stated_key};
use mckibben_core::{
    joined,
    muscle::{
        Muscle,
        file::{FileError, Source},
    },
};

/// A plan in the making: a muscle, what varies of it, and its points. What it makes is the plan of a
/// text, which every table of it carries.
///
/// ```
/// use mckibben_campaign::campaign::{PlanBuilder, SamplingMethod};
/// use mckibben_core::muscle::Muscle;
///
/// let plan = PlanBuilder::new(&Muscle::prototype(), &[0.0, 0.1], &[0.1, 0.2, 0.3])
///     .vary("tube.outer_diameter", "20..50 mm")
///     .vary("braid.angle", "22..30 deg")
///     .sampled(SamplingMethod::Sobol, 200, 1)
///     .build()?;
/// assert_eq!((plan.muscles(), plan.points_per_muscle()), (200, 6));
/// # Ok::<(), mckibben_core::muscle::file::FileError>(())
/// ```
#[must_use]
#[derive(Debug, Clone)]
pub struct PlanBuilder {
    muscle: String,
    sampling: String,
    vary: String,
    test: String,
}

impl PlanBuilder {
    /// The muscle itself at all of these contractions and pressures.
    pub fn new(muscle: &Muscle, contractions: &[f64], pressures_mpa: &[f64]) -> Self {
        let list = |values: &[f64]| joined(values.iter().map(f64::to_string), ",");
        Self {
            muscle: muscle.to_string(),
            sampling: String::new(),
            vary: String::new(),
            test: format!(
                "contractions = \"{}\"\npressures = \"{} MPa\"\n",
                list(contractions),
                list(pressures_mpa)
            ),
        }
    }

    /// Varies a quantity by its key in `[vary]`: over levels (`20,30 mm`, `1..5:1 mm`) or, where
    /// muscles are sampled, an interval (`20..50 mm`).
    pub fn vary(mut self, key: &str, values: &str) -> Self {
        let source = Source::parse(&self.muscle).ok();
        if let Some(without) = source.and_then(|source| source.without(stated_key(key))) {
            self.muscle = without;
        }
        self.vary += &format!("{key} = \"{values}\"\n");
        self
    }

    /// So many muscles in place of every level with every other.
    pub fn sampled(mut self, method: SamplingMethod, samples: u64, seed: u32) -> Self {
        self.sampling = format!("method = \"{method}\"\nsamples = {samples}\nseed = {seed}\n");
        self
    }

    /// A further line of `[test]`, such as `sensitivities = true`.
    pub fn test(mut self, line: &str) -> Self {
        self.test += line;
        self
    }

    /// The plan.
    ///
    /// # Errors
    /// [`FileError`] with the key that is wrong, as of a plan's file.
    pub fn build(self) -> Result<Plan, FileError> {
        Plan::parse(&format!(
            "{}\n[sampling]\n{}\n[vary]\n{}\n[test]\n{}",
            self.muscle, self.sampling, self.vary, self.test
        ))
    }
}
