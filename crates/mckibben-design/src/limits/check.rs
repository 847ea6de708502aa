//! What a muscle is held against, each limit as a number that is at most zero where it is met.

use super::{AT_POINTS, Limit, pressure::Below};
use crate::{Build, Objective, OperatingPoint, Spec, choice::size, trial::Trial};
use mckibben_core::{
    by_number::ByNumber,
    model::{Response, Result},
    muscle::Muscle,
    units::{Dimension, rounded},
};

/// Writes a pressure, a force or a length.
pub type Show<'a> = &'a dyn Fn(Dimension, f64) -> String;

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
    /// The share of the bound by which it is missed; at most 0 where it is met.
    pub fn excess(&self) -> f64 {
        match self.limit {
            Limit::Force => 1.0 - self.value / self.bound,
            _ => self.value / self.bound - 1.0,
        }
    }

    /// What the muscle has and what it may have, with pressures, forces and lengths written by
    /// `show`.
    pub fn describe(&self, show: Show<'_>) -> String {
        let value = self.value;
        let bound = self.bound;
        if let Some(entry) = self.limit.at_points() {
            return (entry.missed)(value, bound, show);
        }
        let below = self.by.map(|below| format!("; {}", below.describe(show)));
        let below = below.unwrap_or_default();
        let pull_n = if value * bound > 0.0 {
            rounded(value, 3, f64::floor).max(value.trunc())
        } else {
            0.0
        };
        format!(
            "{} at {} and {} %, {} required{below}",
            show(Dimension::Force, pull_n),
            show(Dimension::Pressure, self.pressure_mpa),
            round(100.0 * self.contraction),
            show(Dimension::Force, bound)
        )
    }
}

pub fn round(v: f64) -> f64 {
    (v * 1e4).round() / 1e4
}

/// What muscles are ranked by, the smaller the better: the objective, then what decides between two
/// that are equal in it.
pub type Score = [f64; 2];

/// Of a muscle that was not ranked.
pub const NO_SCORE: Score = [f64::INFINITY; 2];

/// A muscle held against a specification.
pub struct Probe {
    /// The limits, of every muscle of a specification in one order.
    pub checks: Vec<Check>,
    /// What the muscles are ranked by, where every limit is met.
    pub score: Score,
    /// Largest outer diameter at the points in mm, where it was ranked.
    pub bulged_mm: f64,
}

impl Probe {
    /// The limit that is missed by most, or met by least.
    pub fn worst(&self) -> Option<&Check> {
        self.checks.iter().max_by_number(|a| a.excess())
    }

    /// The shares by which limits are missed, summed.
    pub fn miss(&self) -> f64 {
        self.checks.iter().map(|c| c.excess().max(0.0)).sum()
    }

    /// The least share of what is wanted that it pulls at its highest pressure.
    pub fn share(&self) -> f64 {
        least_share(&self.checks)
    }

    /// Whether every limit is met.
    pub fn fits(&self) -> bool {
        self.checks.iter().all(|c| c.excess() <= 0.0)
    }
}

fn least_share(checks: &[Check]) -> f64 {
    let pulls = checks.iter().filter(|c| c.limit == Limit::Force);
    pulls
        .map(|c| c.value / c.bound)
        .fold(f64::INFINITY, f64::min)
}

/// A muscle at one of the operating points.
pub struct AtPoint<'t, 'a> {
    pub trial: &'t mut Trial<'a>,
    pub point: OperatingPoint,
    /// Whether its pull at the highest pressure is enough.
    is_strong: bool,
    pressure_mpa: Option<f64>,
    response: Option<Response>,
}

impl AtPoint<'_, '_> {
    pub fn spec(&self) -> &Spec {
        self.trial.spec
    }

    /// The pressure that the point takes. A muscle that is too weak is held against its other
    /// limits where it pulls hardest.
    pub fn pressure_mpa(&mut self) -> Result<f64> {
        if let Some(known) = self.pressure_mpa {
            return Ok(known);
        }
        let pressure_mpa = if self.is_strong {
            self.trial.need(&self.point)?
        } else {
            self.trial.highest_mpa
        };
        Ok(*self.pressure_mpa.insert(pressure_mpa))
    }

    /// What the muscle is like there.
    pub fn response(&mut self) -> Result<Response> {
        if let Some(known) = self.response {
            return Ok(known);
        }
        let pressure_mpa = self.pressure_mpa()?;
        let (full, _) = self
            .trial
            .full_response(pressure_mpa, self.point.contraction)?;
        Ok(*self.response.insert(full))
    }

    /// What is pushed in from rest, normal litres of air or mm³ of liquid; `None` where no model
    /// gives it.
    pub fn stroke(&mut self) -> Result<Option<f64>> {
        let pressure_mpa = self.pressure_mpa()?;
        Ok(self.trial.stroke(pressure_mpa, self.point.contraction).0)
    }
}

/// The pull at the highest pressure against what is wanted.
fn pull(trial: &mut Trial<'_>, point: &OperatingPoint) -> Result<Check> {
    let pressure_mpa = trial.highest_mpa;
    let contraction = point.contraction;
    if !trial.spec.extrapolate {
        let info = trial.model.info();
        info.range.check(&info.name, pressure_mpa, contraction)?;
    }
    Ok(Check {
        limit: Limit::Force,
        value: trial.sure_n(pressure_mpa, contraction)?,
        bound: point.force_n,
        contraction,
        pressure_mpa,
        by: trial.below,
    })
}

/// Holds a muscle against a specification.
pub fn probe(spec: &Spec, build: &Build<'_>, muscle: &Muscle) -> Result<Probe> {
    probe_with(&mut Trial::new(spec, build, muscle)?, true)
}

/// [`probe`]; without a score, which costs inverses, where none is needed.
pub fn probe_with(trial: &mut Trial<'_>, scored: bool) -> Result<Probe> {
    let Trial { spec, muscle, .. } = *trial;
    let points = spec.points(muscle);
    let mut checks = points
        .iter()
        .map(|point| pull(trial, point))
        .collect::<Result<Vec<Check>>>()?;
    let is_strong = |check: &Check| check.excess() <= 0.0;
    let all_strong = checks.iter().all(is_strong);
    let (mut largest, mut bulged_mm) = (0.0_f64, 0.0_f64);
    for (i, point) in points.iter().enumerate() {
        let mut at = AtPoint {
            is_strong: is_strong(&checks[i]),
            trial,
            point: *point,
            pressure_mpa: None,
            response: None,
        };
        for entry in &AT_POINTS {
            let Some(bound) = (entry.bound)(&mut at)? else {
                continue;
            };
            checks.extend((entry.value)(&mut at)?.map(|value| Check {
                limit: entry.limit,
                value,
                bound,
                contraction: 0.0,
                pressure_mpa: 0.0,
                by: None,
            }));
        }
        if scored && all_strong {
            bulged_mm = bulged_mm.max(at.response()?.bulged_diameter_mm.unwrap_or(0.0));
        }
        largest = largest.max(match spec.objective {
            _ if !scored => 0.0,
            // One that is too weak costs no more inverses than its limits.
            Objective::Diameter if !all_strong => at.pressure_mpa.unwrap_or(0.0),
            Objective::Diameter | Objective::Pressure => at.pressure_mpa()?,
            Objective::Air => at.stroke()?.unwrap_or(f64::INFINITY),
            Objective::BulgedDiameter => at.response()?.bulged_diameter_mm.unwrap_or(0.0),
            Objective::Margin | Objective::Length => 0.0,
        });
    }
    let score = match spec.objective {
        _ if !scored => NO_SCORE,
        Objective::Diameter => [muscle.outer_diameter_mm(), largest],
        Objective::Pressure | Objective::Air => [largest, 0.0],
        Objective::Margin => [1.0 - least_share(&checks), 0.0],
        Objective::BulgedDiameter => [
            size(largest, muscle.length_mm()),
            muscle.mass_g().unwrap_or(0.0),
        ],
        Objective::Length => [muscle.length_mm(), muscle.outer_diameter_mm()],
    };
    Ok(Probe {
        checks,
        score,
        bulged_mm,
    })
}

/// Whether a muscle meets a specification by a model.
pub fn fits(spec: &Spec, build: &Build<'_>, muscle: &Muscle) -> bool {
    probe(spec, build, muscle).is_ok_and(|p| p.fits())
}
