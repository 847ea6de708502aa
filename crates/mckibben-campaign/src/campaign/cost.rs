//! What a plan will cost, before it is begun.

use super::plan::Plan;
use mckibben_fem::simulation::Elements;
use serde::Serialize;

/// Bytes of a number in a compressed table: 6 to 8 were measured.
const BYTES_OF_A_NUMBER: f64 = 8.0;
/// Columns that are numbers, without those of constants and sensitivities.
const NUMBERS: usize = 16;

/// About what a plan costs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Cost {
    /// Points, one row each.
    pub points: u64,
    /// Size of the table in bytes.
    pub bytes: f64,
    /// Time in seconds.
    pub seconds: f64,
}

impl Cost {
    /// What is begun only on request: a table of 10 GB, a day.
    pub const LARGE: (f64, f64) = (10e9, 86_400.0);

    /// Whether it is begun only on request.
    pub fn is_large(&self) -> bool {
        self.bytes > Self::LARGE.0 || self.seconds > Self::LARGE.1
    }
}

impl Plan {
    /// Points that one thread solves in a good second; between curves that pull and walls that fold there is a factor of ten.
    pub(super) fn points_per_second(&self) -> u64 {
        let testing = self.testing();
        match testing.elements {
            // Time grows with the elements along and with the square of those through the wall.
            Elements::Axisymmetric(mesh) => {
                let most = if testing.sensitivities { 512 } else { 4096 };
                let through = mesh.through.unwrap_or(1) as u64;
                6 * most / (through * through * mesh.along.unwrap_or(6) as u64).max(6)
            }
            // A hundred points of 600 bricks.
            Elements::ThreeDimensional(spec) => {
                let through = spec.through.unwrap_or(1) as u64;
                let sheet = spec.around.unwrap_or(14) * spec.along.unwrap_or(45);
                60_000 / (through * through * sheet as u64).max(60)
            }
        }
    }

    /// About what so many of its muscles cost on a number of threads.
    pub fn cost(&self, muscles: u64, threads: usize) -> Cost {
        let points = muscles.saturating_mul(self.points_per_muscle() as u64);
        let numbers = NUMBERS + self.constants().len() + self.sensitivities().len();
        let rate = self.points_per_second().max(1) as f64 * threads.max(1) as f64;
        Cost {
            points,
            bytes: points as f64 * BYTES_OF_A_NUMBER * numbers as f64,
            seconds: points as f64 / rate,
        }
    }
}
