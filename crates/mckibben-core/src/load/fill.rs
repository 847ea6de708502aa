//! A muscle that a volume of liquid is pushed into: pressure, stroke, energies, and the stiffness
//! with the liquid shut in.

mod filling;
mod stroke;
mod way;

pub use filling::Filling;

use super::Load;
use crate::{
    analysis::{AnalysisError, Evaluation, HIGHEST_PRESSURE_MPA, Options},
    answer::{Answer, exactly},
    model::ModelError,
    refused::Refused,
};
use serde::Serialize;
use thiserror::Error;
use way::{Leg, Slopes, Way};

/// Where a filled muscle is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FillState {
    /// At its length at rest: it pulls less than the load.
    NotLifted,
    /// In balance with the load, or at its free contraction.
    Balanced,
    /// At the contraction at which it is held.
    Held,
}

mckibben_units::display_as_serde_word!(FillState);

/// A muscle with a volume pushed in.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Fill {
    /// The muscle there. Its ± are those of the pull at this pressure and contraction, and of the
    /// contraction at this volume.
    #[serde(flatten)]
    pub answer: Answer,
    /// Where it is.
    pub state: FillState,
    /// Volume that was pushed in, at atmospheric pressure, mm³.
    pub pushed_volume_mm3: f64,
    /// How far the muscle is shortened, mm; below zero where it extends.
    pub stroke_mm: f64,
    /// Cavity at the start, mm³.
    pub rest_volume_mm3: f64,
    /// What of the volume the liquid's own compression takes, mm³: (V0 + Vd + ΔV)(1 − φ).
    pub compressed_volume_mm3: f64,
    /// Bulk modulus of liquid and gas together at this pressure, MPa.
    pub effective_bulk_modulus_mpa: f64,
    /// Stiffness of the muscle with the liquid shut in, N/mm: K + F_P V_ε/(L0 (V_P + C)), C =
    /// −(V0 + Vd + ΔV) dφ/dP.
    pub shut_stiffness_n_per_mm: f64,
    /// Work of the pump against the gauge pressure, J: ∫ P dV + `liquid_energy_j`.
    pub pump_work_j: f64,
    /// Energy stored in rubber and strands, J: ∫ P dV less the work on the load and what friction
    /// took.
    pub muscle_energy_j: f64,
    /// Energy stored in the liquid and its gas, J.
    pub liquid_energy_j: f64,
    /// Work on the load, J.
    pub load_work_j: f64,
    /// What the muscle's friction took, J, on a branch of the hysteresis.
    pub friction_work_j: Option<f64>,
}

/// Why a volume has no answer.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FillError {
    /// More than the model answers for.
    #[error(
        "the muscle takes {:.4} cm³ up to {pressure_mpa}\u{a0}MPa and a contraction of \
         {contraction:.4}, where the range of the model or of the load ends, and {:.4} cm³ are too \
         much: push in less",
        1e-3 * .largest_mm3, 1e-3 * .volume_mm3
    )]
    TooLarge {
        /// The volume in mm³.
        volume_mm3: f64,
        /// The largest that has an answer in mm³.
        largest_mm3: f64,
        /// The pressure there in MPa.
        pressure_mpa: f64,
        /// The contraction there.
        contraction: f64,
    },
    /// A hold or a load that the muscle does not meet.
    #[error(transparent)]
    Refused(#[from] Refused),
    /// The model has no answer.
    #[error(transparent)]
    Analysis(#[from] AnalysisError),
}

impl From<ModelError> for FillError {
    fn from(error: ModelError) -> Self {
        Self::Analysis(error.into())
    }
}

impl Evaluation<'_> {
    /// The muscle after a volume was pushed in.
    pub fn fill(&mut self, filling: &Filling<'_>) -> Result<Fill, FillError> {
        let options = self.options;
        let length_mm = self.model.muscle().length_mm();
        self.check(filling)?;
        let rest_mm3 = self.cavity_mm3(0.0, 0.0)?;
        let (highest_mpa, furthest) = self.ends(filling.load);
        let lowest_mpa = self.model.info().range.pressure_mpa.0;
        // The way begins without pressure, which may be outside of the range; where it ends is
        // checked.
        let along = Options {
            extrapolate: options.extrapolate || lowest_mpa > 0.0,
            ..options
        };
        let way = &mut Way {
            evaluation: self.with(along),
            filling: *filling,
            rest_mm3,
            length_mm,
        };
        let (walked, is_in) = way.walk(highest_mpa, furthest)?;
        let (leg, _, at) = walked[walked.len() - 1];
        let (pressure_mpa, contraction) = way.state_on_leg(leg, at)?;
        let volume_mm3 = filling.volume_mm3;
        if !is_in {
            return Err(FillError::TooLarge {
                volume_mm3,
                largest_mm3: way.pushed_mm3(leg, at)?,
                pressure_mpa,
                contraction,
            });
        }
        let state = match leg {
            Leg::Load => FillState::Balanced,
            Leg::At(_) if filling.held_at == Some(0.0) || contraction != 0.0 => FillState::Held,
            Leg::At(_) => FillState::NotLifted,
        };
        let mut cavity_j = 0.0;
        let mut friction_j = 0.0;
        for (leg, from, to) in walked {
            let (cavity, friction) = way.works_j(leg, (from, to))?;
            (cavity_j, friction_j) = (cavity_j + cavity, friction_j + friction);
        }
        let load_n = way.load_n(contraction);
        let stroke_mm = contraction * length_mm;
        let load_work_j = filling.load.map_or(0.0, |load| load.energy_j(stroke_mm));
        let liquid = filling.liquid;
        let whole_mm3 = rest_mm3 + filling.dead_volume_mm3 + volume_mm3;
        let liquid_energy_j = 1e-3 * whole_mm3 * liquid.energy_mpa(pressure_mpa);
        let slopes = Slopes::at(self, pressure_mpa, contraction)?;
        let gives_way =
            slopes.volume_by_pressure + whole_mm3 * liquid.compliance_per_mpa(pressure_mpa);
        let shut_stiffness_n_per_mm = slopes.stiffness
            + slopes.force_by_pressure * slopes.volume_by_contraction / (length_mm * gives_way);
        let mut answer = self.answer(pressure_mpa, contraction)?;
        if state == FillState::Balanced {
            // The liquid gives less pressure to a muscle that is shorter.
            let held = shut_stiffness_n_per_mm - slopes.stiffness
                + filling
                    .load
                    .map_or(0.0, |load| load.slope_n_per_mm(stroke_mm));
            answer = self.with_built_contraction(exactly(answer, load_n), held);
        }
        Ok(Fill {
            answer,
            state,
            pushed_volume_mm3: volume_mm3,
            stroke_mm,
            rest_volume_mm3: rest_mm3,
            compressed_volume_mm3: whole_mm3 * (1.0 - liquid.relative_volume(pressure_mpa)),
            effective_bulk_modulus_mpa: liquid.effective_bulk_modulus_mpa(pressure_mpa),
            shut_stiffness_n_per_mm,
            pump_work_j: cavity_j + liquid_energy_j,
            muscle_energy_j: cavity_j - load_work_j - friction_j,
            liquid_energy_j,
            load_work_j,
            friction_work_j: (!options.direction.is_mean()).then_some(friction_j),
        })
    }

    /// Refuses a hold to which filling does not bring the muscle, and a load to which it gives way.
    fn check(&self, filling: &Filling<'_>) -> Result<(), Refused> {
        let extends = self.model.muscle().is_extensile();
        let (sign, side) = if extends {
            (-1.0, "a contraction of zero or below")
        } else {
            (1.0, "zero or above")
        };
        let held_at = filling.held_at.unwrap_or_default();
        Refused::unless(sign * held_at >= 0.0, ["contraction"], || {
            format!(
                "the muscle is filled at its length at rest and does not come to a contraction of \
                 {held_at}: hold it at {side} or leave `contraction` out"
            )
        })?;
        let pulls = filling.load.is_some_and(|load| load.force_n(0.0) > 0.0);
        Refused::unless(!(extends && pulls), ["load"], || {
            "a muscle that extends gives way to a load that pulls: fill it free, or hold it".into()
        })
    }

    /// The pressure in MPa and the contraction, of a muscle that extends below zero, beyond which
    /// there is no answer.
    fn ends(&self, load: Option<&Load>) -> (f64, f64) {
        let muscle = self.model.muscle();
        let range = &self.model.info().range;
        let open = (f64::NEG_INFINITY, f64::INFINITY);
        let ((_, highest_mpa), (low, high)) = if self.options.extrapolate {
            (open, open)
        } else {
            (range.pressure_mpa, range.contraction)
        };
        let (least_mm, most_mm) = load.map_or(open, Load::reach_mm);
        let length_mm = muscle.length_mm();
        let furthest = if muscle.is_extensile() {
            low.max(least_mm / length_mm).max(-1.5)
        } else {
            // Beyond the ideal muscle's largest contraction nothing pulls but strands that stretch
            // a little.
            high.min(most_mm / length_mm)
                .min(1.3 * muscle.max_ideal_contraction() + 0.05)
                .min(0.95)
        };
        (highest_mpa.min(HIGHEST_PRESSURE_MPA), furthest)
    }
}

#[cfg(test)]
mod tests;
