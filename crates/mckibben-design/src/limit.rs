//! What a muscle is held against, each limit as a number that is at most zero where it is met.

use crate::trial::Trial;
use crate::{Build, Objective, OperatingPoint, Spec};
use mckibben::analysis::burst::{ends, mesh};
use mckibben::analysis::{FailureMode, FailurePressure, burst};
use mckibben::model::{ModelError, ThickWall};
use mckibben::muscle::Muscle;
use mckibben::warning::strand_strength_n;
use serde::{Deserialize, Serialize};

/// A kind of limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Limit {
    /// The pull that is wanted, at the maximum pressure.
    Force,
    /// The largest outer diameter at the operating points.
    BulgedDiameter,
    /// The largest stretch of the rubber at the operating points.
    MaxStretch,
    /// The largest strain of the strands at the maximum pressure.
    StrandStrain,
    /// The least ratio of burst pressure to maximum pressure.
    BurstMargin,
    /// The push at which the muscle buckles as a column, at the operating points.
    Buckling,
    /// The largest liquid volume that is pushed in up to the operating points.
    LiquidVolume,
}

impl Limit {
    /// The share of the bound by which a value misses it; at most 0 where it is met.
    pub(super) fn missed_by(self, value: f64, bound: f64) -> f64 {
        match self {
            Self::Force | Self::BurstMargin => 1.0 - value / bound,
            _ => value / bound - 1.0,
        }
    }
}

/// Margin of what never fails.
const NEVER: f64 = 1e6;

/// One limit at one place: what the muscle has there, and what it may have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Check {
    /// What is limited.
    pub limit: Limit,
    /// What the muscle has: N, mm, mm³, a strain, a stretch or a margin.
    pub value: f64,
    /// What it may have.
    pub bound: f64,
    /// Contraction and pressure of a force.
    pub contraction: f64,
    pub pressure_mpa: f64,
    /// How the muscle fails, for a burst.
    pub by: FailureMode,
}

impl Check {
    fn new(limit: Limit, value: f64, bound: f64) -> Self {
        Self { limit, value, bound, contraction: 0.0, pressure_mpa: 0.0, by: FailureMode::Strands }
    }

    /// The share by which the limit is missed; at most 0 where it is met.
    pub fn excess(&self) -> f64 {
        self.limit.missed_by(self.value, self.bound)
    }
}

/// What muscles are ranked by, the smaller the better: the objective, then what decides between two that are equal in it.
pub(super) type Score = [f64; 2];

/// A muscle held against a specification.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Probe {
    /// The limits, of every muscle of a specification in one order.
    pub(super) checks: Vec<Check>,
    /// What the muscles are ranked by, where every limit is met.
    pub(super) score: Score,
}

impl Probe {
    /// The limit that is missed by most, or met by least.
    pub(super) fn worst(&self) -> Option<&Check> {
        self.checks.iter().max_by(|a, b| a.excess().total_cmp(&b.excess()))
    }

    /// Whether every limit is met.
    pub(super) fn fits(&self) -> bool {
        self.checks.iter().all(|c| c.excess() <= 0.0)
    }
}

/// Holds a muscle against a specification.
pub(super) fn probe(spec: &Spec, build: &Build<'_>, muscle: &Muscle) -> Result<Probe, ModelError> {
    probe_with(Trial::new(spec, build, muscle)?, true)
}

/// [`probe`]; without a score, which costs inverses, where it is not asked for.
pub(super) fn probe_with(mut trial: Trial<'_>, scored: bool) -> Result<Probe, ModelError> {
    let Trial { spec, muscle, .. } = trial;
    let max = spec.max_pressure_mpa;
    let mut checks = vec![];
    let points = spec.points(muscle);
    for &OperatingPoint { force_n, contraction } in points.iter() {
        if !spec.extrapolate {
            let info = trial.model.info();
            info.range.check(&info.name, max, contraction)?;
        }
        let mut value = trial.strongest_n(contraction)?;
        if let Some(widths) = spec.half_widths() {
            let half = trial.uncertainty_n((max, contraction), value);
            value -= widths * half.unwrap_or(0.0) * force_n.signum();
        }
        let check = Check::new(Limit::Force, value, force_n);
        checks.push(Check { contraction, pressure_mpa: max, ..check });
    }
    let limits = &spec.limits;
    let stretch = limits.stretch.or(muscle.tube().rubber.fitted_to_stretch.filter(|_| limits.fitted_stretch));
    let most_liquid = limits.liquid_volume_mm3.filter(|_| spec.liquid.is_some());
    let pumped = most_liquid.is_some() || scored && spec.objective == Objective::Air;
    let shaped = limits.bulged_diameter_mm.is_some() || stretch.is_some();
    let by_pressure =
        scored && matches!(spec.objective, Objective::Pressure | Objective::Air | Objective::BulgedDiameter);
    let (mut highest, mut fluid, mut bulge) = (0.0_f64, 0.0_f64, 0.0_f64);
    let strong = checks.iter().all(|c| c.excess() <= 0.0);
    let buckles = limits.buckling && spec.wanted.extends();
    if shaped || by_pressure || pumped || buckles || scored && strong && spec.objective == Objective::Diameter
    {
        for (i, point) in points.iter().enumerate() {
            // Too weak: its other limits are looked at where it pulls hardest.
            let p = if checks[i].excess() > 0.0 { max } else { trial.need(point)? };
            highest = highest.max(p);
            if buckles {
                let least_n = ThickWall::new(muscle).buckling_n(p, point.contraction)?;
                checks.push(Check::new(Limit::Buckling, point.force_n.abs(), least_n));
            }
            if pumped {
                let amount = trial.stroke(p, point.contraction).0.map(|s| s.amount);
                if let Some(bound) = most_liquid {
                    let unknown = || ModelError::NoVolume { model: trial.model.info().name.to_string() };
                    checks.push(Check::new(Limit::LiquidVolume, amount.ok_or_else(unknown)?, bound));
                }
                fluid = fluid.max(amount.unwrap_or(f64::INFINITY));
            }
            if !(shaped || by_pressure) {
                continue;
            }
            let (full, _) = trial.full_response(p, point.contraction)?;
            if let (Some(bound), Some(value)) = (limits.bulged_diameter_mm, full.bulged_diameter_mm) {
                checks.push(Check::new(Limit::BulgedDiameter, value, bound));
            }
            if let (Some(bound), Some(value)) = (stretch, full.rubber_stretch()) {
                checks.push(Check::new(Limit::MaxStretch, value, bound));
            }
            bulge = bulge.max(full.bulged_diameter_mm.unwrap_or(0.0));
        }
    }
    checks.extend(strands(&mut trial, &points)?);
    let margin = points.iter().zip(&checks).map(|(q, c)| c.value / q.force_n - 1.0);
    let score = match spec.objective {
        Objective::Diameter => [muscle.outer_diameter_mm(), highest],
        Objective::Pressure => [highest, 0.0],
        Objective::Air => [fluid, 0.0],
        Objective::Margin => [-margin.fold(f64::INFINITY, f64::min), 0.0],
        Objective::BulgedDiameter => [bulge, 0.0],
        Objective::Length => [muscle.length_mm(), muscle.outer_diameter_mm()],
    };
    Ok(Probe { checks, score })
}

/// Whether a muscle meets a specification by a model.
pub fn fits(spec: &Spec, build: &Build<'_>, muscle: &Muscle) -> bool {
    probe(spec, build, muscle).is_ok_and(|p| p.fits())
}

/// What the strands bear at the maximum pressure, not shortened and at the operating points.
pub(super) fn strands(trial: &mut Trial<'_>, points: &[OperatingPoint]) -> Result<Vec<Check>, ModelError> {
    let Trial { spec, muscle, .. } = *trial;
    let (limits, max) = (&spec.limits, spec.max_pressure_mpa);
    let strength = strand_strength_n(muscle);
    let mut checks = vec![];
    let places = || std::iter::once(0.0).chain(points.iter().map(|q| q.contraction));
    if let Some(bound) = limits.strand_strain {
        let mut largest: Option<f64> = None;
        for e in places() {
            let (full, _) = trial.full_response(max, e)?;
            let strain = full.braid_tension_n.and_then(|t| muscle.strand_strain(t));
            largest = strain.map_or(largest, |s| Some(largest.map_or(s, |l| l.max(s))));
        }
        checks.extend(largest.map(|value| Check::new(Limit::StrandStrain, value, bound)));
    }
    let Some(bound) = limits.burst_margin else { return Ok(checks) };
    let pull_off = muscle.terminals().pull_off_n;
    // Blocked, as the burst pressure is; without an equilibrium at that pressure it bursts before.
    let blocked = (strength.is_some() || pull_off.is_some())
        .then(|| trial.full_response(bound * max, 0.0).ok().map(|(r, _)| r))
        .flatten();
    let mut margin = |by, value: f64| {
        checks.push(Check { by, ..Check::new(Limit::BurstMargin, value, bound) });
    };
    if let Some(strength) = strength {
        let tension = blocked.as_ref().map_or(f64::INFINITY, |r| r.strand_tension_n.unwrap_or(0.0));
        margin(FailureMode::Strands, bound * strength / tension.max(0.0));
    }
    match mesh::herniation(muscle) {
        FailurePressure::At(p) => margin(FailureMode::Mesh, (p / max / FailureMode::Mesh.share()).min(NEVER)),
        FailurePressure::None => margin(FailureMode::Mesh, NEVER),
        FailurePressure::Unknown(_) => {}
    }
    if let Some(bears) = pull_off {
        let load =
            blocked.as_ref().map_or(f64::INFINITY, |r| ends::clamp_load_n(muscle, r.force_n, r.pressure_mpa));
        margin(FailureMode::Ends, (bound * bears / load.max(0.0)).min(NEVER));
    }
    Ok(checks)
}

/// The decisive failure of a muscle, and its pressure over the maximum pressure and its share of the margin, solved for: where the margin is missed, that of its check is in proportion to the
/// strands' tension alone.
pub(super) fn burst_margin(spec: &Spec, build: &Build<'_>, muscle: &Muscle) -> Option<(FailureMode, f64)> {
    let solved = burst(build(muscle).ok()?.as_ref()).ok()?;
    let (by, pressure_mpa) = solved.decisive()?;
    Some((by, pressure_mpa / spec.max_pressure_mpa))
}
