//! The pressure at which the rubber tears: where its largest stretch in the unloaded muscle is that at which a strip of it breaks.
//!
//! The unloaded muscle is the widest. With stiff strands its stretch ends at the neutral angle of 54.7°, so that most rubbers never reach it. The stretch at break
//! is 1 plus the elongation at break of a test in one axis; in two axes, at notches and after ageing rubber breaks earlier.

use super::failure::{FailurePressure, NoBurst};
use super::radii::Radii;
use crate::analysis::error::{AnalysisError, Result};
use crate::analysis::evaluation::{Evaluation, Options};
use crate::analysis::root::find_root;
use crate::model::{ModelError, ModelKind, Workspace};
use crate::muscle::{Muscle, NEUTRAL_ANGLE_DEG};
use crate::rubber::{RubberLaw, library};

/// Where the search ends if nothing else fails before, in MPa.
const HIGHEST_MPA: f64 = 20.0;
/// Strain of the strands up to which the stretch at the neutral angle is a bound.
const STRAND_STRAIN: f64 = 0.1;
/// First pressure of the search over the shear modulus, and the ratio of one to the next.
const FIRST: f64 = 0.05;
const GROWTH: f64 = 1.5;
/// The pressure is known to this share.
const TOLERANCE: f64 = 1e-9;

/// The stretch at which the rubber of a muscle breaks, where it is known.
pub fn stretch_at_break(muscle: &Muscle) -> Option<f64> {
    let name = muscle.tube().rubber.name.as_deref()?;
    Some(1.0 + library::entry(name).ok()?.max_strain?)
}

/// The pressure at which the rubber of the unloaded muscle tears, below one at which another part fails.
pub fn tearing(muscle: &Muscle, below_mpa: f64) -> Result<FailurePressure> {
    let Some(breaks) = stretch_at_break(muscle) else {
        return Ok(FailurePressure::Unknown(NoBurst::NoElongation));
    };
    // At the neutral angle, with elastic strands.
    if Radii::new(muscle).largest_stretch(NEUTRAL_ANGLE_DEG.to_radians(), 1.0 + STRAND_STRAIN) < breaks {
        return Ok(FailurePressure::None);
    }
    let (model, mut workspace) = (ModelKind::ThickWall.build(muscle)?, Workspace::new());
    let mut over = |p: f64| -> Result<f64> {
        let free = Evaluation::new(&*model, &mut workspace, Options::extrapolating()).free_contraction(p)?;
        Ok(model.response(&mut workspace, p, free)?.max_stretch.unwrap_or(1.0) - breaks)
    };
    let highest = below_mpa.min(HIGHEST_MPA);
    let mut low = 0.0;
    let mut high = FIRST * muscle.rubber().law.shear_modulus_mpa();
    while low < highest {
        high = high.min(highest);
        match over(high) {
            Ok(excess) if excess >= 0.0 => {
                let root = find_root(&mut over, low.max(TOLERANCE * high), high, TOLERANCE * high)?;
                return Ok(FailurePressure::At(root.unwrap_or(high)));
            }
            Ok(_) => (low, high) = (high, GROWTH * high),
            Err(error @ AnalysisError::Model(ModelError::Cancelled(_))) => return Err(error),
            // Not taut yet, or beyond the last equilibrium.
            Err(_) if low == 0.0 => (low, high) = (high, GROWTH * high),
            Err(_) => {
                return Ok(FailurePressure::Unknown(NoBurst::NoAnswerBeyond(low)));
            }
        }
    }
    Ok(FailurePressure::None)
}
