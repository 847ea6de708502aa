//! The way of a muscle that is filled: at its length at rest, with its load, at the contraction at
//! which it is held.

use super::filling::Filling;
use crate::{
    analysis::{AnalysisError, Evaluation, Result, Sweep},
    model::gauss,
};

/// Parts into which a leg of the way is cut in search of the volume; they grow with the distance
/// from its start.
const STEPS: usize = 16;
/// Points of Gauss on a leg.
const POINTS: usize = 12;

/// A part of the way.
#[derive(Clone, Copy, PartialEq)]
pub enum Leg {
    /// At a contraction; the pressure rises.
    At(f64),
    /// In balance with the load; the contraction changes.
    Load,
}

/// A part of a leg that was walked, from one place to another.
pub type Part = (Leg, f64, f64);

/// The muscle on its way.
pub struct Way<'a> {
    pub evaluation: Evaluation<'a>,
    pub filling: Filling<'a>,
    pub rest_mm3: f64,
    pub length_mm: f64,
}

impl Way<'_> {
    pub fn load_n(&self, contraction: f64) -> f64 {
        self.filling
            .load
            .map_or(0.0, |load| load.force_n(contraction * self.length_mm))
    }

    /// The way until the volume is in, and whether it is: at rest, with the load up to the furthest
    /// contraction, then where it is held.
    pub fn walk(&mut self, highest_mpa: f64, furthest: f64) -> Result<(Vec<Part>, bool)> {
        let held_at = self.filling.held_at;
        let extends = self.evaluation.model.muscle().is_extensile();
        let sign = if extends { -1.0 } else { 1.0 };
        let stop = held_at.filter(|e| sign * e <= sign * furthest);
        // The pressure at which the load is lifted.
        let lifted_mpa = match self.state_on_leg(Leg::Load, 0.0) {
            _ if held_at == Some(0.0) => None,
            Ok((p, _)) => Some(p),
            Err(AnalysisError::NoPressure { .. }) => None,
            Err(error) => return Err(error),
        };
        let mut walked = vec![];
        let mut next = Some((Leg::At(0.0), 0.0, lifted_mpa.unwrap_or(highest_mpa)));
        while let Some((leg, from, to)) = next {
            let (at, is_in) = self.seek(leg, (from, to))?;
            walked.push((leg, from, at));
            next = match leg {
                _ if is_in => return Ok((walked, true)),
                Leg::At(_) if walked.len() == 1 => {
                    lifted_mpa.map(|_| (Leg::Load, 0.0, stop.unwrap_or(furthest)))
                }
                Leg::Load if stop == Some(at) => {
                    let (from, _) = self.state_on_leg(leg, at)?;
                    Some((Leg::At(at), from, highest_mpa))
                }
                _ => None,
            };
        }
        Ok((walked, false))
    }

    /// (P, ε) at a place of a leg.
    pub fn state_on_leg(&mut self, leg: Leg, at: f64) -> Result<(f64, f64)> {
        match leg {
            Leg::At(contraction) => Ok((at, contraction)),
            Leg::Load => Ok((self.evaluation.pressure_at(self.load_n(at), at)?, at)),
        }
    }

    /// ΔV that brings the muscle to a place of a leg, in mm³.
    pub fn pushed_mm3(&mut self, leg: Leg, at: f64) -> Result<f64> {
        let (p, e) = self.state_on_leg(leg, at)?;
        let cavity_mm3 = self.evaluation.cavity_mm3(p, e)?;
        Ok(self.filling.liquid.pushed_mm3(
            (self.rest_mm3, cavity_mm3),
            self.filling.dead_volume_mm3,
            p,
        ))
    }

    /// The place of a leg at which the volume is in; else the last one with an answer. And whether
    /// the volume is in.
    fn seek(&mut self, leg: Leg, (from, to): (f64, f64)) -> Result<(f64, bool)> {
        if from == to {
            return Ok((to, false));
        }
        let wanted_mm3 = self.filling.volume_mm3;
        let place = |share: f64| from + (to - from) * share;
        let excess =
            |share| -> Result<f64> { Ok(self.pushed_mm3(leg, place(share))? - wanted_mm3) };
        let mut sweep = Sweep::new(true, 0.0, excess);
        // More than the volume may be in from the start of the leg on.
        if sweep.sample(0.0)?.is_some_and(|excess| excess >= 0.0) {
            return Ok((from, true));
        }
        let shares = (0..=STEPS).map(|i| (i as f64 / STEPS as f64).powi(2));
        let share = match sweep.first(shares, false, f64::NEG_INFINITY)? {
            None => sweep.all_zeros()?.first().map(|zero| zero.at),
            share => share,
        };
        Ok((
            place(share.unwrap_or(sweep.least(f64::abs).map_or(0.0, |(share, _)| share))),
            share.is_some(),
        ))
    }

    /// (∫ P dV, what friction took) in J along a part of a leg.
    pub fn works_j(&mut self, leg: Leg, (from, to): (f64, f64)) -> Result<(f64, f64)> {
        let mut cavity = 0.0;
        let mut friction = 0.0;
        for &(x, weight) in gauss(POINTS) {
            let at = from + 0.5 * (to - from) * (1.0 + x);
            let step = 0.5 * (to - from) * weight;
            let (p, e) = self.state_on_leg(leg, at)?;
            let slopes = Slopes::at(&mut self.evaluation, p, e)?;
            cavity += step
                * p
                * match leg {
                    Leg::At(_) => slopes.volume_by_pressure,
                    Leg::Load => {
                        let load = self.filling.load;
                        let held = slopes.stiffness
                            + load.map_or(0.0, |l| l.slope_n_per_mm(e * self.length_mm));
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
pub struct Slopes {
    pub volume_by_pressure: f64,
    pub volume_by_contraction: f64,
    pub force_by_pressure: f64,
    pub stiffness: f64,
}

impl Slopes {
    pub fn at(evaluation: &mut Evaluation<'_>, p: f64, e: f64) -> Result<Self> {
        const STEP: f64 = 1e-5;
        let r = evaluation.response(p, e)?;
        let volume_by_pressure = if let Some(slope) = r.volume_per_pressure_mm3_per_mpa {
            slope
        } else {
            let low = (p - STEP).max(0.0);
            let high = p + STEP;
            (evaluation.cavity_mm3(high, e)? - evaluation.cavity_mm3(low, e)?) / (high - low)
        };
        let volume_by_contraction = match r.volume_per_contraction_mm3 {
            Some(slope) => slope,
            None => {
                (evaluation.cavity_mm3(p, e + STEP)? - evaluation.cavity_mm3(p, e - STEP)?)
                    / (2.0 * STEP)
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
