//! The pressure at which the rubber tears: where its largest stretch in the unloaded muscle is that
//! at which a strip of it breaks.
//!
//! The unloaded muscle is the widest. With stiff strands its stretch ends at the neutral angle of
//! 54.7°, so that most rubbers never reach it. The stretch at break is 1 plus the elongation at
//! break of a test in one axis; in two axes, at notches and after ageing rubber breaks earlier.

use super::{
    failure::{FailurePressure, NoBurst},
    radii::Radii,
};
use crate::{
    analysis::{
        error::Result,
        evaluation::{Evaluation, Options},
        sweep::Sweep,
    },
    model::{ModelKind, Workspace},
    muscle::{Muscle, NEUTRAL_ANGLE_DEG},
    rubber::{RubberLaw, library},
};
use std::iter::{once, successors};

/// Where the search ends if nothing else fails before, in MPa.
const HIGHEST_MPA: f64 = 20.0;
/// Strain of the strands up to which the stretch at the neutral angle is a bound.
const STRAND_STRAIN: f64 = 0.1;
/// First pressure of the search over the shear modulus, and the ratio of one to the next.
const FIRST: f64 = 0.05;
const GROWTH: f64 = 1.5;
/// Share of the first pressure at which the search begins.
const ALMOST_NONE: f64 = 1e-9;

/// The stretch at which the rubber of a muscle breaks, where it is known.
pub fn stretch_at_break(muscle: &Muscle) -> Option<f64> {
    Some(1.0 + library::elongation_at_break(&muscle.tube().rubber)?)
}

/// The pressure at which the rubber of the unloaded muscle tears, below one at which another part
/// fails.
pub fn tearing(muscle: &Muscle, below_mpa: f64) -> Result<FailurePressure> {
    let Some(breaks) = stretch_at_break(muscle) else {
        let why = NoBurst::Missing("the elongation at break of this rubber is not known");
        return Ok(FailurePressure::Unknown(why));
    };
    // At the neutral angle, with elastic strands.
    if Radii::new(muscle).largest_stretch(NEUTRAL_ANGLE_DEG.to_radians(), 1.0 + STRAND_STRAIN)
        < breaks
    {
        return Ok(FailurePressure::None);
    }
    let model = ModelKind::ThickWall.build(muscle)?;
    let mut workspace = Workspace::new();
    let over = |p: f64| -> Result<f64> {
        let free = Evaluation::new(&*model, &mut workspace, Options::extrapolating())
            .free_contraction(p)?;
        Ok(model
            .response(&mut workspace, p, free)?
            .max_stretch
            .unwrap_or(1.0)
            - breaks)
    };
    let highest = below_mpa.min(HIGHEST_MPA);
    let first = FIRST * muscle.rubber().law.shear_modulus_mpa();
    let growing = successors(Some(first.min(highest)), |p| {
        (*p < highest).then(|| (GROWTH * p).min(highest))
    });
    let mut sweep = Sweep::new(true, 0.0, over);
    let pressures = once(ALMOST_NONE * first).chain(growing);
    if let Some(p) = sweep.first(pressures, false, f64::NEG_INFINITY)? {
        return Ok(FailurePressure::at(p));
    }
    Ok(match sweep.least(f64::abs) {
        Some((last, _)) if last < highest => {
            FailurePressure::Unknown(NoBurst::NoAnswerBeyond(last))
        }
        _ => FailurePressure::None,
    })
}
