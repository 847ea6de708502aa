//! What a muscle is held against, each limit as a number that is at most zero where it is met.

use crate::line::NO_SCORE;
use crate::trial::{Below, Trial};
use crate::{Build, Objective, OperatingPoint, Spec};
use mckibben::model::{ModelError, ThickWall};
use mckibben::muscle::Muscle;
use mckibben::units::{Dimension, rounded};
use serde::{Deserialize, Serialize};

/// A kind of limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Limit {
    /// The pull that is wanted, at the highest pressure that supply and muscle allow.
    Force,
    /// The largest outer diameter at the operating points.
    BulgedDiameter,
    /// The largest stretch of the rubber at the operating points.
    MaxStretch,
    /// The push at which the muscle buckles as a column, at the operating points.
    Buckling,
    /// The largest liquid volume that is pushed in up to the operating points.
    LiquidVolume,
}

impl Limit {
    /// The share of the bound by which a value misses it; at most 0 where it is met.
    pub(super) fn missed_by(self, value: f64, bound: f64) -> f64 {
        match self {
            Self::Force => 1.0 - value / bound,
            _ => value / bound - 1.0,
        }
    }
}

/// One limit at one place: what the muscle has there, and what it may have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Check {
    /// What is limited.
    pub limit: Limit,
    /// What the muscle has: N, mm, mm³ or a stretch.
    pub value: f64,
    /// What it may have.
    pub bound: f64,
    /// Contraction and pressure of a force.
    pub contraction: f64,
    pub pressure_mpa: f64,
    /// What keeps that pressure below that of the supply.
    pub by: Option<Below>,
}

impl Check {
    fn new(limit: Limit, value: f64, bound: f64) -> Self {
        Self {
            limit,
            value,
            bound,
            contraction: 0.0,
            pressure_mpa: 0.0,
            by: None,
        }
    }

    /// The share by which the limit is missed; at most 0 where it is met.
    pub fn excess(&self) -> f64 {
        self.limit.missed_by(self.value, self.bound)
    }

    /// What the muscle has and what it may have, with pressures, forces and lengths written by
    /// `show`.
    pub fn describe(&self, show: impl Fn(Dimension, f64) -> String) -> String {
        let (value, bound) = (self.value, self.bound);
        match self.limit {
            Limit::Force => {
                let mpa = |p| show(Dimension::Pressure, p);
                let below = self
                    .by
                    .map_or_else(String::new, |below| format!("; {}", below.describe(mpa)));
                let pull = rounded(value, 3, f64::floor).max(value.trunc());
                format!(
                    "{} at {} and {} %, {} required{below}",
                    show(
                        Dimension::Force,
                        if value * bound > 0.0 { pull } else { 0.0 }
                    ),
                    mpa(self.pressure_mpa),
                    round(100.0 * self.contraction),
                    show(Dimension::Force, bound)
                )
            }
            Limit::BulgedDiameter => {
                let bulged = (10.0 * value).round() / 10.0;
                let [bulged, limit] = [bulged, bound].map(|v| show(Dimension::Length, v));
                format!("bulged diameter {bulged}, at most {limit} allowed")
            }
            Limit::MaxStretch => format!("rubber stretched to {value:.2}, at most {bound} allowed"),
            Limit::Buckling => {
                let [push, limit] =
                    [value.ceil(), bound.floor()].map(|v| show(Dimension::Force, v));
                format!("buckles at {limit} between two joints, {push} required")
            }
            Limit::LiquidVolume => {
                let (volume, limit) = ((0.1 * value).ceil() / 100.0, round(1e-3 * bound));
                format!("takes {volume} mL of liquid, at most {limit} mL allowed")
            }
        }
    }
}

fn round(v: f64) -> f64 {
    (v * 1e4).round() / 1e4
}

/// What muscles are ranked by, the smaller the better: the objective, then what decides between two
/// that are equal in it.
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
        self.checks
            .iter()
            .max_by(|a, b| a.excess().total_cmp(&b.excess()))
    }

    /// The shares by which limits are missed, summed.
    pub(super) fn miss(&self) -> f64 {
        self.checks.iter().map(|c| c.excess().max(0.0)).sum()
    }

    /// Whether every limit is met.
    pub(super) fn fits(&self) -> bool {
        self.checks.iter().all(|c| c.excess() <= 0.0)
    }
}

/// Holds a muscle against a specification.
pub(super) fn probe(spec: &Spec, build: &Build<'_>, muscle: &Muscle) -> Result<Probe, ModelError> {
    probe_with(&mut Trial::new(spec, build, muscle)?, true)
}

/// [`probe`]; without a score, which costs inverses, where none is needed.
pub(super) fn probe_with(trial: &mut Trial<'_>, scored: bool) -> Result<Probe, ModelError> {
    let Trial { spec, muscle, .. } = *trial;
    let max = trial.highest_mpa;
    let mut checks = vec![];
    let points = spec.points(muscle);
    for &OperatingPoint {
        force_n,
        contraction,
    } in points.iter()
    {
        if !spec.extrapolate {
            let info = trial.model.info();
            info.range.check(&info.name, max, contraction)?;
        }
        let pull_n = trial.strongest_n(contraction)?;
        let check = Check::new(
            Limit::Force,
            trial.sure_n(max, contraction, pull_n),
            force_n,
        );
        checks.push(Check {
            contraction,
            pressure_mpa: max,
            by: trial.below,
            ..check
        });
    }
    let limits = &spec.limits;
    let stretch = limits.stretch.or(muscle
        .tube()
        .rubber
        .fitted_to_stretch
        .filter(|_| limits.fitted_stretch));
    let most_liquid = limits.liquid_volume_mm3.filter(|_| spec.liquid.is_some());
    let pumped = most_liquid.is_some() || scored && spec.objective == Objective::Air;
    let by_pressure = scored && matches!(spec.objective, Objective::Pressure | Objective::Air);
    let by_width = scored && spec.objective == Objective::BulgedDiameter;
    let shaped = limits.bulged_diameter_mm.is_some() || stretch.is_some() || by_width;
    let (mut highest, mut fluid, mut bulge) = (0.0_f64, 0.0_f64, 0.0_f64);
    let strong = checks.iter().all(|c| c.excess() <= 0.0);
    let buckles = limits.buckling && spec.wanted.extends();
    if shaped
        || by_pressure
        || pumped
        || buckles
        || scored && strong && spec.objective == Objective::Diameter
    {
        for (i, point) in points.iter().enumerate() {
            // Too weak: its other limits are looked at where it pulls hardest.
            let p = if checks[i].excess() > 0.0 {
                max
            } else {
                trial.need(point)?
            };
            highest = highest.max(p);
            if buckles {
                let least_n = ThickWall::new(muscle).buckling_n(p, point.contraction)?;
                checks.push(Check::new(Limit::Buckling, point.force_n.abs(), least_n));
            }
            if pumped {
                let amount = trial.stroke(p, point.contraction).0;
                if let Some(bound) = most_liquid {
                    let unknown = || ModelError::NoVolume(trial.model.info().name.to_string());
                    checks.push(Check::new(
                        Limit::LiquidVolume,
                        amount.ok_or_else(unknown)?,
                        bound,
                    ));
                }
                fluid = fluid.max(amount.unwrap_or(f64::INFINITY));
            }
            if !shaped {
                continue;
            }
            let (full, _) = trial.full_response(p, point.contraction)?;
            if let (Some(bound), Some(value)) = (limits.bulged_diameter_mm, full.bulged_diameter_mm)
            {
                checks.push(Check::new(Limit::BulgedDiameter, value, bound));
            }
            if let (Some(bound), Some(value)) = (stretch, full.rubber_stretch()) {
                checks.push(Check::new(Limit::MaxStretch, value, bound));
            }
            bulge = bulge.max(full.bulged_diameter_mm.unwrap_or(0.0));
        }
    }
    let margin = points
        .iter()
        .zip(&checks)
        .map(|(q, c)| c.value / q.force_n - 1.0);
    let score = match spec.objective {
        _ if !scored => NO_SCORE,
        Objective::Diameter => [muscle.outer_diameter_mm(), highest],
        Objective::Pressure => [highest, 0.0],
        Objective::Air => [fluid, 0.0],
        Objective::Margin => [-margin.fold(f64::INFINITY, f64::min), 0.0],
        Objective::BulgedDiameter => [bulge, muscle.mass_g().unwrap_or(0.0)],
        Objective::Length => [muscle.length_mm(), muscle.outer_diameter_mm()],
    };
    Ok(Probe { checks, score })
}

/// Whether a muscle meets a specification by a model.
pub fn fits(spec: &Spec, build: &Build<'_>, muscle: &Muscle) -> bool {
    probe(spec, build, muscle).is_ok_and(|p| p.fits())
}
