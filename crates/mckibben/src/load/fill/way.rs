//! The way of a muscle that is filled: at its length at rest, with its load, at the contraction at which it is held.

use super::filling::Filling;
use crate::analysis::{AnalysisError, Evaluation, Result, find_root};
use crate::model::{ModelError, gauss};

/// Parts into which a leg of the way is cut in search of the volume; they grow with the distance from its start.
const STEPS: usize = 16;
/// Halvings towards the last place at which the model answers.
const CLOSING: usize = 12;
/// A pressure (MPa) or contraction is known to this.
const TOLERANCE: f64 = 1e-12;
/// Points of Gauss on a leg.
const POINTS: usize = 12;

/// A part of the way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Leg {
    /// At a contraction; the pressure rises.
    At(f64),
    /// In balance with the load; the contraction changes.
    Load,
}

/// The muscle on its way.
pub(super) struct Way<'a> {
    pub(super) evaluation: Evaluation<'a>,
    pub(super) filling: Filling<'a>,
    pub(super) rest_mm3: f64,
    pub(super) length_mm: f64,
}

impl Way<'_> {
    pub(super) fn load_n(&self, contraction: f64) -> f64 {
        self.filling.load.map_or(0.0, |load| load.force_n(contraction * self.length_mm))
    }

    /// (P, ε) at a place of a leg.
    pub(super) fn place(&mut self, leg: Leg, at: f64) -> Result<(f64, f64)> {
        match leg {
            Leg::At(contraction) => Ok((at, contraction)),
            Leg::Load => Ok((self.evaluation.pressure_at(self.load_n(at), at)?, at)),
        }
    }

    /// ΔV that brings the muscle to a place of a leg, in mm³.
    pub(super) fn pushed_mm3(&mut self, leg: Leg, at: f64) -> Result<f64> {
        let (p, e) = self.place(leg, at)?;
        let cavity_mm3 = self.evaluation.cavity_mm3(p, e)?;
        Ok(self.filling.liquid.pushed_mm3((self.rest_mm3, cavity_mm3), self.filling.dead_volume_mm3, p))
    }

    /// The place of a leg at which the volume is in; else the last one with an answer.
    pub(super) fn seek(&mut self, leg: Leg, (from, to): (f64, f64)) -> Result<Result<f64, f64>> {
        if from == to {
            return Ok(Err(to));
        }
        let wanted = self.filling.volume_mm3;
        let mut left = |at: f64| self.pushed_mm3(leg, at).map(|pushed| pushed - wanted);
        let ended = |e: &AnalysisError| matches!(e, AnalysisError::Model(ModelError::Cancelled(_)));
        let (mut near, mut beyond) = (from, None);
        for i in 1..=STEPS {
            let at = if i == STEPS { to } else { from + (to - from) * (i as f64 / STEPS as f64).powi(2) };
            match left(at) {
                Ok(more) if more >= 0.0 => {
                    beyond = Some(at);
                    break;
                }
                Ok(_) => near = at,
                Err(error) if ended(&error) => return Err(error),
                Err(_) => {
                    let mut edge = at;
                    for _ in 0..CLOSING {
                        let middle = 0.5 * (near + edge);
                        match left(middle) {
                            Ok(more) if more >= 0.0 => {
                                beyond = Some(middle);
                                break;
                            }
                            Ok(_) => near = middle,
                            Err(error) if ended(&error) => return Err(error),
                            Err(_) => edge = middle,
                        }
                    }
                    break;
                }
            }
        }
        let Some(beyond) = beyond else { return Ok(Err(near)) };
        // More than the volume may be in from the start of the leg on.
        Ok(Ok(find_root(&mut left, near, beyond, TOLERANCE)?.unwrap_or(near)))
    }

    /// (∫ P dV, what friction took) in J along a part of a leg.
    pub(super) fn works_j(&mut self, leg: Leg, (from, to): (f64, f64)) -> Result<(f64, f64)> {
        let (mut cavity, mut friction) = (0.0, 0.0);
        for &(x, weight) in gauss(POINTS) {
            let at = from + 0.5 * (to - from) * (1.0 + x);
            let step = 0.5 * (to - from) * weight;
            let (p, e) = self.place(leg, at)?;
            let slopes = Slopes::at(&mut self.evaluation, p, e)?;
            cavity += step
                * p
                * match leg {
                    Leg::At(_) => slopes.volume_by_pressure,
                    Leg::Load => {
                        let load = self.filling.load;
                        let held =
                            slopes.stiffness + load.map_or(0.0, |l| l.slope_n_per_mm(e * self.length_mm));
                        let pressure = held * self.length_mm / slopes.force_by_pressure;
                        slopes.volume_by_contraction + slopes.volume_by_pressure * pressure
                    }
                };
            if leg == Leg::Load {
                friction -= step * self.length_mm * self.evaluation.friction_n(p, e)?;
            }
        }
        Ok((1e-3 * cavity, 1e-3 * friction))
    }
}

/// V_P, V_ε, F_P and K = ∂F/∂L of a model, or by differences where it does not state them.
pub(super) struct Slopes {
    pub(super) volume_by_pressure: f64,
    pub(super) volume_by_contraction: f64,
    pub(super) force_by_pressure: f64,
    pub(super) stiffness: f64,
}

impl Slopes {
    pub(super) fn at(evaluation: &mut Evaluation<'_>, p: f64, e: f64) -> Result<Self> {
        const STEP: f64 = 1e-5;
        let r = evaluation.response(p, e)?;
        let volume_by_pressure = match r.volume_per_pressure_mm3_per_mpa {
            Some(slope) => slope,
            None => {
                let (low, high) = ((p - STEP).max(0.0), p + STEP);
                (evaluation.cavity_mm3(high, e)? - evaluation.cavity_mm3(low, e)?) / (high - low)
            }
        };
        let volume_by_contraction = match r.volume_per_contraction_mm3 {
            Some(slope) => slope,
            None => {
                (evaluation.cavity_mm3(p, e + STEP)? - evaluation.cavity_mm3(p, e - STEP)?) / (2.0 * STEP)
            }
        };
        Ok(Self {
            volume_by_pressure,
            volume_by_contraction,
            force_by_pressure: evaluation.force_per_pressure_mm2(&r)?,
            stiffness: evaluation.stiffness_n_per_mm(&r)?,
        })
    }
}
