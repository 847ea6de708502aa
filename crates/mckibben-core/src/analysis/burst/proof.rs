//! The proof test of a muscle: once, with water, stretched in a frame.

use super::{Burst, PROOF_TO_BURST, RELIEF, ends::clamp_load_n};
use crate::{
    analysis::{Evaluation, Options},
    model::{Response, Result},
    muscle::{Direction, Muscle},
};

/// By this share of L0 the proof test stretches a muscle: a choice.
pub const STRETCH: f64 = 0.02;

impl Burst {
    /// Pressure of the proof test in MPa of a muscle that works at one in MPa. Stretched in it, on
    /// the branch of lengthening, its strands and ends carry at most the share of what they bear
    /// that a proof is of the burst pressure.
    ///
    /// # Errors
    /// Those of the model.
    #[doc(hidden)]
    pub fn stretched_proof_mpa(
        &self,
        evaluation: &mut Evaluation<'_>,
        working_mpa: f64,
    ) -> Result<f64> {
        let mut evaluation = evaluation.with(Options {
            direction: Direction::Elongation,
            ..evaluation.options
        });
        let mut proof_mpa = self.highest_proof_mpa(working_mpa);
        // The load is nearly in proportion to the pressure.
        for _ in 0..4 {
            let stretched = evaluation.response(proof_mpa, -STRETCH)?;
            let share = borne_share(evaluation.model.muscle(), &stretched);
            if share <= PROOF_TO_BURST {
                break;
            }
            proof_mpa *= PROOF_TO_BURST / share;
        }
        Ok(proof_mpa)
    }

    /// Whether a proof leaves room for a relief valve above the working pressure, both in MPa.
    pub fn is_proof(proof_mpa: f64, working_mpa: f64) -> bool {
        // To the last digit of what the allowed pressure follows from.
        proof_mpa >= RELIEF * working_mpa * (1.0 - 1e-9)
    }
}

/// What strands and ends carry in a state, over the least that they bear, the larger one.
fn borne_share(muscle: &Muscle, state: &Response) -> f64 {
    let strands = muscle.braid().strands;
    let strength_n = strands.and_then(|s| Some(s.strength_n? / s.load_factor()));
    let load_n = clamp_load_n(muscle, state.force_n, state.pressure_mpa);
    [
        (state.strand_tension_n, strength_n),
        (Some(load_n), muscle.terminals().pull_off_n),
    ]
    .into_iter()
    .filter_map(|(n, bears)| Some(n? / bears?))
    .fold(0.0, f64::max)
}
