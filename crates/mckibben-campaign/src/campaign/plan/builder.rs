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
    vary: Vec<(String, String)>,
    test: String,
}

impl PlanBuilder {
    /// The muscle itself at all of these contractions and pressures.
    pub fn new(muscle: &Muscle, contractions: &[f64], pressures_mpa: &[f64]) -> Self {
        let list = |values: &[f64]| joined(values.iter().map(f64::to_string), ",");
        Self {
            muscle: muscle.to_string(),
            sampling: String::new(),
            vary: vec![],
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
        self.vary.push((key.into(), values.into()));
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
        let mut text = self.muscle;
        let mut vary = String::new();
        for (key, values) in self.vary {
            let without = Source::parse(&text)?.without(stated_key(&key));
            text = without.unwrap_or(text);
            vary += &format!("{key} = \"{values}\"\n");
        }
        for (table, lines) in [
            ("sampling", self.sampling),
            ("vary", vary),
            ("test", self.test),
        ] {
            text += &format!("\n[{table}]\n{lines}");
        }
        Plan::parse(&text)
    }
}
