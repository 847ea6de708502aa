//! A muscle held against a specification: how many of it are needed, with which chance, and what of
//! the limits they meet.

use crate::{
    Ends, Limit, Objective, OperatingPoint,
    assess::{Assessed, Pull, normal_deviations, normal_share},
    bundle::envelope_ratio,
    candidate::NINE_OF_TEN,
    enumerate::Place,
    limits::{AtPoint, Check, LIMITS, all_g},
};
use mckibben_core::{
    analysis::{PROOF_TO_WORKING, burst::ends::clamp_load_n},
    model::Result,
    muscle::Muscle,
};

/// Length over diameter below which a muscle is short, and the angle of a steep braid in degrees.
const SHORT: f64 = 3.0;
const STEEP_DEG: f64 = 42.0;

/// A place of the list with what is chosen around it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Job {
    pub place: Place,
    /// Radius of the pulley of a joint in mm.
    pub radius_mm: f64,
    /// So many side by side; as few as do where it is not said.
    pub count: Option<u32>,
}

/// How a muscle is held against its limits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Precision {
    /// At pressures that are in proportion to the pull, without the mass of its ends.
    Rough,
    /// At the pressures that the points take.
    Exact,
}

/// So many muscles side by side, held against a specification.
#[derive(Debug, Clone)]
pub struct Held {
    /// The place, with so many of it.
    pub job: Job,
    pub count: u32,
    /// The limits, of every muscle of a specification in one order.
    pub checks: Vec<Check>,
    /// The probability that they meet every point at some pressure that is allowed, where the
    /// model's error is known.
    pub chance: Option<f64>,
    /// What they are ranked by, the smaller the better: the objective, then what decides between
    /// two that are equal in it.
    pub score: [f64; 2],
    /// The larger of bulged tube and ends of one, mm.
    pub width_mm: f64,
    pub ends: Ends,
    /// What is required of all of them, with the pull of one at the highest pressure.
    pub pulls: Vec<(OperatingPoint, Pull)>,
    pub is_cast: bool,
    /// Whether the fast model may err by more: a short muscle, or a steep braid.
    pub is_far_off: bool,
}

impl Held {
    pub fn new(assessed: &mut Assessed<'_>, job: Job, precision: Precision) -> Result<Self> {
        let (spec, muscle) = (assessed.spec, assessed.muscle);
        let whole = spec.wanted.points(muscle.length_mm(), job.radius_mm);
        assessed.keep_strands(&whole)?;
        let highest_mpa = assessed.highest_mpa;
        let mut pulls = vec![];
        for q in whole {
            assessed.check_range(highest_mpa, q.contraction)?;
            pulls.push((q, assessed.pull(highest_mpa, q.contraction)?));
        }
        let mut held = Self {
            job,
            count: 1,
            checks: vec![],
            chance: None,
            score: [0.0; 2],
            width_mm: 0.0,
            ends: Ends::NONE,
            pulls,
            is_cast: job.place.tube(spec).is_some_and(|tube| tube.is_cast),
            is_far_off: muscle.length_mm() / muscle.outer_diameter_mm() < SHORT
                || muscle.braid().angle_deg > STEEP_DEG,
        };
        let z = spec.deviations();
        let count = job.count.unwrap_or(spec.count_of(held.least_count(z, 1.0)));
        (held.count, held.job.count) = (count, Some(count));
        held.chance = held.chance_of(count);
        let many = f64::from(count);
        let check = |(q, pull): &(OperatingPoint, Pull)| Check {
            limit: Limit::Force,
            value: many * pull.quantile_n(z, q.force_n),
            bound: q.force_n,
            contraction: q.contraction,
            pressure_mpa: highest_mpa,
            by: assessed.below,
        };
        held.checks = held.pulls.iter().map(check).collect();
        let points = held.pressures(assessed, precision)?;
        let pressure_mpa = points.iter().map(|p| p.1).fold(0.0, f64::max);
        held.ends = match precision {
            Precision::Rough => ends_at(assessed, pressure_mpa),
            Precision::Exact => held.ends_proved(assessed, pressure_mpa),
        };
        let mut air = 0.0_f64;
        for (point, pressure_mpa) in points {
            let mut response = assessed.full_response(pressure_mpa, point.contraction);
            if response.is_err() && precision == Precision::Rough {
                response = assessed.full_response(highest_mpa, point.contraction);
            }
            let mut at = AtPoint {
                spec,
                muscle,
                response: response?,
                assessed,
                count,
                radius_mm: job.radius_mm,
                point,
                pressure_mpa,
                ends: held.ends,
            };
            held.width_mm = held.width_mm.max(at.width_mm());
            for entry in &LIMITS {
                let numbers = (entry.numbers)(&mut at)?;
                held.checks.extend(numbers.map(|(value, bound)| Check {
                    limit: entry.limit,
                    value,
                    bound,
                    contraction: point.contraction,
                    pressure_mpa,
                    by: None,
                }));
            }
            if spec.objective == Objective::Air {
                let stroke = at.assessed.stroke(pressure_mpa, point.contraction);
                air = air.max(many * stroke.unwrap_or(f64::INFINITY));
            }
        }
        held.score = held.scored(spec.objective, muscle, pressure_mpa, air);
        Ok(held)
    }

    /// The fewest muscles that pull a share of what is required, by a quantile.
    pub fn least_count(&self, z: Option<f64>, share: f64) -> f64 {
        let needed = |(q, pull): &(OperatingPoint, Pull)| {
            let one_n = pull.quantile_n(z, q.force_n);
            match q.force_n * one_n > 0.0 {
                true => (share * q.force_n / one_n).ceil(),
                false => f64::INFINITY,
            }
        };
        self.pulls.iter().map(needed).fold(1.0, f64::max)
    }

    /// The probability that so many meet all points: one error is common to all of them and to all
    /// points.
    pub fn chance_of(&self, count: u32) -> Option<f64> {
        let count = f64::from(count);
        let mut least = f64::INFINITY;
        for (q, pull) in &self.pulls {
            let (median_n, sd_n) = pull.spread?;
            let spare_n = q.force_n.signum() * (count * median_n - q.force_n);
            least = least.min(spare_n / (count * sd_n));
        }
        Some(normal_share(least))
    }

    /// The points of one of them.
    pub fn points(&self) -> Vec<OperatingPoint> {
        let one = |(q, _): &(OperatingPoint, Pull)| OperatingPoint {
            force_n: q.force_n / f64::from(self.count),
            ..*q
        };
        self.pulls.iter().map(one).collect()
    }

    /// The points of one of them, and the pressure in MPa that each takes.
    fn pressures(
        &self,
        assessed: &mut Assessed<'_>,
        precision: Precision,
    ) -> Result<Vec<(OperatingPoint, f64)>> {
        let z = assessed.spec.deviations();
        let highest_mpa = assessed.highest_mpa;
        let one = |(point, check): (OperatingPoint, &Check)| {
            // A muscle that is too weak is held against its other limits where it pulls hardest.
            let pressure_mpa = match (check.excess() <= 0.0, precision) {
                (false, _) => highest_mpa,
                (true, Precision::Rough) => highest_mpa * check.bound / check.value,
                (true, Precision::Exact) => assessed.need_mpa(&point, z)?,
            };
            Ok((point, pressure_mpa))
        };
        self.points()
            .into_iter()
            .zip(&self.checks)
            .map(one)
            .collect()
    }

    /// The ends for a proof test above the pressure below which nine of ten end, estimated from that
    /// in MPa which is surely enough.
    fn ends_proved(&self, assessed: &mut Assessed<'_>, sure_mpa: f64) -> Ends {
        let z = assessed.spec.deviations();
        let high = self
            .chance
            .map(|chance| normal_deviations(NINE_OF_TEN[1] * chance));
        // In proportion to the pull, which is too much: some pressure only takes up slack.
        let more = |(q, pull): &(OperatingPoint, Pull)| {
            let [sure_n, high_n] = [z, high].map(|z| pull.quantile_n(z, q.force_n));
            sure_n / high_n
        };
        let more = self.pulls.iter().map(more).fold(1.0, f64::max);
        let used_mpa = assessed.highest_mpa.min(more * sure_mpa);
        let proof_mpa = assessed.burst.highest_proof_mpa(used_mpa);
        assessed.proved_ends(proof_mpa).unwrap_or(Ends::NONE)
    }

    fn scored(&self, objective: Objective, m: &Muscle, pressure_mpa: f64, air: f64) -> [f64; 2] {
        let circle = envelope_ratio(self.count);
        let size = circle * self.width_mm * m.length_mm().sqrt();
        let mass_g = all_g(m, self.ends, self.count);
        match objective {
            Objective::Diameter => [circle * m.outer_diameter_mm(), pressure_mpa],
            Objective::Pressure => [pressure_mpa, size],
            Objective::Air => [air, size],
            Objective::Chance => {
                let pull = self.checks.iter().find(|c| c.limit == Limit::Force);
                let missing = pull.map_or(0.0, |c| c.bound / c.value);
                [self.chance.map_or(missing, |chance| 1.0 - chance), size]
            }
            Objective::BulgedDiameter => [size, mass_g.unwrap_or_default()],
            Objective::Length => [m.length_mm(), circle * m.outer_diameter_mm()],
            Objective::Mass => [mass_g.unwrap_or(f64::INFINITY), size],
        }
    }

    /// The limits that are missed.
    pub fn missed(&self) -> impl Iterator<Item = &Check> {
        self.checks.iter().filter(|c| c.excess() > 0.0)
    }

    /// Whether every limit is met.
    pub fn fits(&self) -> bool {
        self.checks.iter().all(|c| c.excess() <= 0.0)
    }

    /// The shares by which limits are missed, summed; of a muscle that may not pull at all the
    /// chance tells how far it is from what is required.
    pub fn miss(&self) -> f64 {
        let missed = |c: &Check| match (c.limit, self.chance) {
            (Limit::Force, Some(chance)) if c.excess() > 1.0 => 2.0 - chance,
            _ => c.excess().max(0.0),
        };
        self.checks.iter().map(missed).sum()
    }
}

/// The ends for a pressure in MPa, before its proof test is known.
fn ends_at(assessed: &mut Assessed<'_>, pressure_mpa: f64) -> Ends {
    let Some(ends) = assessed.spec.ends else {
        return Ends::NONE;
    };
    let blocked = assessed.evaluation().force_n(pressure_mpa, 0.0);
    let blocked_n = blocked.unwrap_or(0.0).max(0.0);
    let load_n = PROOF_TO_WORKING * clamp_load_n(assessed.muscle, blocked_n, pressure_mpa);
    ends(assessed.muscle, [load_n; 2], Precision::Rough).unwrap_or(Ends::NONE)
}
