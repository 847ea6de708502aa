//! What a muscle is held against, each limit as a number that is at most zero where it is met.

use crate::candidate::stroke;
use crate::{Build, Objective, OperatingPoint, Spec};
use mckibben::analysis::burst::{ends, mesh};
use mckibben::analysis::{AnalysisError, Evaluation, FailureMode, FailurePressure, burst};
use mckibben::cancel;
use mckibben::model::{ForceModel, ModelError, ModelKind, Response, ThickWall, Workspace};
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
            Self::BulgedDiameter
            | Self::MaxStretch
            | Self::StrandStrain
            | Self::Buckling
            | Self::LiquidVolume => value / bound - 1.0,
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
    probe_with(spec, build, muscle, true)
}

/// [`probe`]; without a score, which costs inverses, where it is not asked for.
pub(super) fn probe_with(
    spec: &Spec,
    build: &Build<'_>,
    muscle: &Muscle,
    scored: bool,
) -> Result<Probe, ModelError> {
    let workspace = &mut Workspace::new();
    // Of what is to end, not even the model is made.
    cancel::check()?;
    let model = build(muscle)?;
    let model = &mut Evaluation::new(model.as_ref(), workspace, spec.options());
    let max = spec.max_pressure_mpa;
    let thick_wall = ModelKind::ThickWall.build(muscle)?;
    let thick_wall = &*thick_wall;
    let mut checks = vec![];
    let points = spec.points(muscle);
    for &point in points.iter() {
        if !spec.extrapolate {
            let info = model.model.info();
            info.range.check(&info.name, max, point.contraction)?;
        }
        let mut value = model.force_n(max, point.contraction)?;
        if let Some(widths) = spec.half_widths() {
            let parts = model.uncertainty(max, point.contraction, value);
            value -= widths * parts.map_or(0.0, |parts| parts.total()) * point.force_n.signum();
        }
        let (contraction, pressure_mpa) = (point.contraction, max);
        checks.push(Check { contraction, pressure_mpa, ..Check::new(Limit::Force, value, point.force_n) });
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
            let p = if checks[i].excess() > 0.0 { max } else { need(spec, model, point)? };
            highest = highest.max(p);
            if buckles {
                let least_n = ThickWall::new(muscle).buckling_n(p, point.contraction)?;
                checks.push(Check::new(Limit::Buckling, point.force_n.abs(), least_n));
            }
            if pumped {
                let at = (p, point.contraction);
                let amount = stroke(spec, model, thick_wall, at).0.map(|s| s.amount());
                if let Some(bound) = most_liquid {
                    let unknown = || ModelError::NoVolume { model: model.model.info().name.to_string() };
                    checks.push(Check::new(Limit::LiquidVolume, amount.ok_or_else(unknown)?, bound));
                }
                fluid = fluid.max(amount.unwrap_or(f64::INFINITY));
            }
            if !(shaped || by_pressure) {
                continue;
            }
            let (full, _) = full_response(model, thick_wall, p, point.contraction)?;
            if let (Some(bound), Some(value)) = (limits.bulged_diameter_mm, full.bulged_diameter_mm) {
                checks.push(Check::new(Limit::BulgedDiameter, value, bound));
            }
            if let (Some(bound), Some(value)) = (stretch, full.rubber_stretch()) {
                checks.push(Check::new(Limit::MaxStretch, value, bound));
            }
            bulge = bulge.max(full.bulged_diameter_mm.unwrap_or(0.0));
        }
    }
    checks.extend(strands(spec, &points, model, thick_wall)?);
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
pub(super) fn strands(
    spec: &Spec,
    points: &[OperatingPoint],
    model: &mut Evaluation<'_>,
    thick_wall: &dyn ForceModel,
) -> Result<Vec<Check>, ModelError> {
    let (limits, max, muscle) = (&spec.limits, spec.max_pressure_mpa, model.model.muscle());
    let strength = strand_strength_n(muscle);
    let mut checks = vec![];
    let places = || std::iter::once(0.0).chain(points.iter().map(|q| q.contraction));
    if let Some(bound) = limits.strand_strain {
        let mut largest: Option<f64> = None;
        for e in places() {
            let (full, _) = full_response(model, thick_wall, max, e)?;
            let strain = full.braid_tension_n.and_then(|t| muscle.strand_strain(t));
            largest = strain.map_or(largest, |s| Some(largest.map_or(s, |l| l.max(s))));
        }
        checks.extend(largest.map(|value| Check::new(Limit::StrandStrain, value, bound)));
    }
    let Some(bound) = limits.burst_margin else { return Ok(checks) };
    let pull_off = muscle.terminals().pull_off_n;
    // Blocked, as the burst pressure is; without an equilibrium at that pressure it bursts before.
    let blocked = (strength.is_some() || pull_off.is_some())
        .then(|| full_response(model, thick_wall, bound * max, 0.0).ok().map(|(r, _)| r))
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

/// The pressure a point takes, where the pull at the maximum pressure is known to be enough.
pub(super) fn need(
    spec: &Spec,
    model: &mut Evaluation<'_>,
    point: &OperatingPoint,
) -> Result<f64, ModelError> {
    let OperatingPoint { force_n, contraction } = *point;
    if let Some(p) = model.pressure_below(force_n, contraction, spec.max_pressure_mpa) {
        return Ok(p);
    }
    match model.pressure_at(force_n, contraction) {
        Ok(p) => Ok(p.min(spec.max_pressure_mpa)),
        Err(AnalysisError::Model(error)) => Err(error),
        // At the lowest pressure of its range the model already pulls more: that pressure is enough.
        Err(AnalysisError::NoPressure { nearest_force_n, nearest_pressure_mpa, .. })
            if nearest_force_n / force_n >= 1.0 =>
        {
            Ok(nearest_pressure_mpa)
        }
        Err(_) => Ok(spec.max_pressure_mpa),
    }
}

/// A response with what the model does not know filled in from the thick-wall model.
pub(super) fn full_response(
    model: &mut Evaluation<'_>,
    thick_wall: &dyn ForceModel,
    p: f64,
    contraction: f64,
) -> Result<(Response, Vec<&'static str>), ModelError> {
    cancel::check()?;
    let mut r = model.model.response(model.workspace, p, contraction)?;
    let mut filled = vec![];
    if r.bulged_diameter_mm.is_some() && r.volume_mm3.is_some() && r.max_stretch.is_some() {
        return Ok((r, filled));
    }
    if let Ok(other) = thick_wall.response(model.workspace, p, contraction) {
        let mut fill = |slot: &mut Option<f64>, value: Option<f64>, name| {
            if slot.is_none() && value.is_some() {
                *slot = value;
                filled.push(name);
            }
        };
        fill(&mut r.bulged_diameter_mm, other.bulged_diameter_mm, "bulged diameter");
        fill(&mut r.volume_mm3, other.volume_mm3, "volume");
        fill(&mut r.max_stretch, other.max_stretch, "stretch");
        fill(&mut r.middle_stretch, other.middle_stretch, "stretch");
        fill(&mut r.braid_tension_n, other.braid_tension_n, "strand tension");
        fill(&mut r.strand_tension_n, other.strand_tension_n, "strand tension");
        fill(&mut r.stiffness_n_per_mm, other.stiffness_n_per_mm, "stiffness");
    }
    Ok((r, filled))
}
