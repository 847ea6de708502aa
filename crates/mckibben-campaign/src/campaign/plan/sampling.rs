//! How the axes of a plan are sampled.

use super::axis::Axis;
use rand_chacha::{
    ChaCha8Rng,
    rand_core::{Rng, SeedableRng},
};

/// The most muscles of a plan.
pub const MOST_MUSCLES: u64 = 20_000_000;
/// The most of a Latin hypercube, whose order is held in memory: 8 MB for each quantity.
pub const MOST_STRATA: u64 = 1_000_000;
/// Points of one of Sobol's nets: the library has 16 direction numbers of each dimension.
const NET: u64 = 1 << 16;

/// A way of sampling.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sampling {
    /// Every level with every other.
    Factorial,
    /// As many strata as samples on each axis, each hit once (McKay, Beckman & Conover 1979
    /// \[mckay1979\]).
    LatinHypercube { samples: u64, seed: u64 },
    /// Sobol's sequence, Owen-scrambled by its seed (Burley 2020 \[burley2020\]). Beyond 65,536
    /// points further nets of so many follow, each scrambled independently of the others.
    Sobol {
        samples: u64,
        /// Seed, up to 32 bits.
        seed: u32,
    },
    /// A table of one's own.
    Table { samples: u64 },
}

impl Sampling {
    /// Its word in plans.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Factorial => "factorial",
            Self::LatinHypercube { .. } => "latin-hypercube",
            Self::Sobol { .. } => "sobol",
            Self::Table { .. } => "table",
        }
    }

    pub fn seed(&self) -> Option<u64> {
        match *self {
            Self::Factorial | Self::Table { .. } => None,
            Self::LatinHypercube { seed, .. } => Some(seed),
            Self::Sobol { seed, .. } => Some(u64::from(seed)),
        }
    }
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
    pub fn new(sampling: Sampling, axes: &[Axis]) -> Self {
        let (muscles, listed) = match sampling {
            Sampling::Factorial => (
                axes.iter()
                    .fold(1_u64, |all, a| all.saturating_mul(a.levels())),
                vec![],
            ),
            Sampling::LatinHypercube { samples, seed } => (
                samples,
                (0..axes.len())
                    .map(|axis| strata(samples, seed, axis as u64))
                    .collect(),
            ),
            Sampling::Sobol { samples, .. } | Sampling::Table { samples } => (samples, vec![]),
        };
        Self {
            sampling,
            muscles,
            listed,
        }
    }

    /// Of a table: the values axis by axis.
    pub fn of_table(samples: u64, values: Vec<Vec<f64>>) -> Self {
        Self {
            sampling: Sampling::Table { samples },
            muscles: samples,
            listed: values,
        }
    }

    /// The value of an axis for a muscle.
    pub fn value(&self, axes: &[Axis], axis: usize, number: u64) -> f64 {
        match self.sampling {
            Sampling::Factorial => {
                // The first axis changes slowest.
                let faster: u64 = axes[axis + 1..].iter().map(Axis::levels).product();
                axes[axis].level(number / faster % axes[axis].levels())
            }
            Sampling::LatinHypercube { .. } => {
                axes[axis].at_share(self.listed[axis][number as usize])
            }
            Sampling::Table { .. } => self.listed[axis][number as usize],
            Sampling::Sobol { seed, .. } => {
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
fn strata(n: u64, seed: u64, axis: u64) -> Vec<f64> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
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
