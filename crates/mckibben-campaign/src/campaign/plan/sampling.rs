//! How the axes of a plan are sampled.

use super::axis::Axis;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The most muscles of a plan.
pub const MOST_MUSCLES: u64 = 20_000_000;
/// Points of one of Sobol's nets: the library has 16 direction numbers of each dimension.
const NET: u64 = 1 << 16;

/// How muscles are taken from the ranges.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SamplingMethod {
    /// Every level with every other.
    #[default]
    Factorial,
    /// Sobol's sequence, Owen-scrambled by its seed (Burley 2020 \[burley2020\]). Beyond 65,536
    /// points further nets of so many follow, each scrambled independently of the others.
    Sobol,
    /// A table of one's own.
    #[serde(skip_deserializing)]
    Table,
}

mckibben_core::units::display_as_serde_word!(SamplingMethod);

/// A way of sampling.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Sampling {
    /// Factorial, or a sequence of random points.
    pub method: SamplingMethod,
    /// Muscles; not of a factorial plan.
    pub samples: u64,
    /// Seed of the random numbers, up to 32 bits, where there are some.
    pub seed: Option<u32>,
}

/// Where the muscles of a plan lie in the unit cube of its axes.
#[derive(Debug, Clone)]
pub struct Design {
    pub sampling: Sampling,
    pub muscles: u64,
    /// Of a table the values of all muscles, axis by axis.
    listed: Vec<Vec<f64>>,
}

impl Design {
    /// Of a table with the values of all muscles, axis by axis.
    pub fn new(sampling: Sampling, axes: &[Axis], listed: Vec<Vec<f64>>) -> Self {
        let levels = axes.iter().map(Axis::levels);
        Self {
            sampling,
            muscles: match sampling.method {
                SamplingMethod::Factorial => levels.fold(1, u64::saturating_mul),
                _ => sampling.samples,
            },
            listed,
        }
    }

    /// The value of an axis for a muscle.
    pub fn value(&self, axes: &[Axis], axis: usize, number: u64) -> f64 {
        match self.sampling.method {
            SamplingMethod::Factorial => {
                // The first axis changes slowest.
                let faster: u64 = axes[axis + 1..].iter().map(Axis::levels).product();
                axes[axis].level(number / faster % axes[axis].levels())
            }
            SamplingMethod::Table => self.listed[axis][number as usize],
            SamplingMethod::Sobol => {
                let seed = self.sampling.seed.unwrap_or(1);
                let (net, point) = (number / NET, number % NET);
                // Odd and large, so that nets of neighbouring seeds differ.
                let scramble = seed.wrapping_add((net as u32).wrapping_mul(0x9e37_79b9));
                axes[axis].at_share(f64::from(sobol_burley::sample(
                    point as u32,
                    axis as u32,
                    scramble,
                )))
            }
        }
    }
}
