//! What a plan will cost, measured with a few of its muscles.

use super::plan::Plan;
use super::store::{Provenance, Table, part};
use super::{CampaignError, solve};
use mckibben::progress::Progress;
use std::time::{Duration, Instant};

/// The most muscles of a measurement.
const MOST: u64 = 256;
/// The step from muscle to muscle as a share of the plan: the golden ratio, whose multiples fill the plan evenly however many there are.
const STEP: f64 = 0.618_033_988_749_894_9;

/// Time and size of some muscles of a plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Timing {
    /// Muscles that were computed.
    pub muscles: u64,
    /// Seconds of one thread for a muscle.
    pub seconds_per_muscle: f64,
    /// Bytes of a muscle in a table.
    pub bytes_per_muscle: f64,
}

impl Plan {
    /// Computes muscles that are spread over the plan, on one thread, for about so long; at least one.
    pub fn timed(&self, most: Duration, progress: &dyn Progress) -> Result<Timing, CampaignError> {
        let provenance = Provenance::of(self);
        let mut table = Table::new(&provenance.layout);
        // Without the plan's text, which stands in a file once.
        let empty = part(&provenance, 0, &table)?.len();
        let (from, all, mut muscles) = (Instant::now(), self.muscles(), 0);
        while muscles < MOST.min(all) && (muscles == 0 || from.elapsed() < most) {
            let share = (muscles as f64 * STEP).fract();
            let number = if all <= MOST { muscles } else { ((share * all as f64) as u64).min(all - 1) };
            for row in solve::rows(self, number) {
                table.push(row);
            }
            progress.check()?;
            muscles += 1;
        }
        let seconds = from.elapsed().as_secs_f64();
        let bytes = part(&provenance, 0, &table)?.len().saturating_sub(empty);
        let one = 1.0 / muscles.max(1) as f64;
        Ok(Timing { muscles, seconds_per_muscle: seconds * one, bytes_per_muscle: bytes as f64 * one })
    }
}
