//! How the axes of a plan are sampled.

use super::axis::Axis;
use rand_chacha::{
    ChaCha8Rng,
    rand_core::{Rng, SeedableRng},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The most muscles of a plan.
pub const MOST_MUSCLES: u64 = 20_000_000;
/// The most of a Latin hypercube, whose order is held in memory: 8 MB for each quantity.
pub const MOST_STRATA: u64 = 1_000_000;
/// Points of one of Sobol's nets: the library has 16 direction numbers of each dimension.
const NET: u64 = 1 << 16;

/// How muscles are taken from the ranges.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SamplingMethod {
    /// Every level with every other.
    #[default]
    Factorial,
    /// As many strata as samples on each axis, each hit once (McKay, Beckman & Conover 1979
    /// \[mckay1979\]).
    LatinHypercube,
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
    /// Axis by axis of all muscles: of a Latin hypercube the shares, of a table the values.
    listed: Vec<Vec<f64>>,
}

impl Design {
    /// Of a table with the values of all muscles, axis by axis.
    pub fn new(sampling: Sampling, axes: &[Axis], values: Vec<Vec<f64>>) -> Self {
        let Sampling { samples, seed, .. } = sampling;
        let strata = |axis: usize| strata(samples, seed.unwrap_or(1), axis as u64);
        Self {
            sampling,
            muscles: match sampling.method {
                SamplingMethod::Factorial => axes
                    .iter()
                    .fold(1_u64, |all, a| all.saturating_mul(a.levels())),
                _ => samples,
            },
            listed: match sampling.method {
                SamplingMethod::LatinHypercube => (0..axes.len()).map(strata).collect(),
                _ => values,
            },
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
            SamplingMethod::LatinHypercube => {
                axes[axis].at_share(self.listed[axis][number as usize])
            }
            SamplingMethod::Table => self.listed[axis][number as usize],
            SamplingMethod::Sobol => {
                let seed = self.sampling.seed.unwrap_or(1);
                let (net, point) = (number / NET, number % NET);
                // Odd and large, so that nets of neighbouring seeds differ.
                let scramble = seed.wrapping_add((net as u32).wrapping_mul(0x9e37_79b9));
                let share = sobol_burley::sample(point as u32, axis as u32, scramble);
                axes[axis].at_share(f64::from(share))
            }
        }
    }
}

/// One axis of a Latin hypercube: a share in each of `n` strata, in random order. Each axis has one
/// stream.
fn strata(n: u64, seed: u32, axis: u64) -> Vec<f64> {
    let mut random = ChaCha8Rng::seed_from_u64(u64::from(seed));
    random.set_stream(axis);
    let mut order: Vec<u64> = (0..n).collect();
    for i in (1..order.len()).rev() {
        // Multiply and shift: uneven by at most n/2⁶⁴.
        let j = ((u128::from(random.next_u64()) * (i as u128 + 1)) >> 64) as usize;
        order.swap(i, j);
    }
    let mut unit = || (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
    order
        .into_iter()
        .map(|stratum| ((stratum as f64 + unit()) / n as f64).min(1.0 - f64::EPSILON))
        .collect()
}
