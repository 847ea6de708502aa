//! The pressure at which a part of the blocked muscle carries what it bears, and that of its
//! strands.
//!
//!   T(P_b, 0) = T_max,   T(P, ε) the tension of the most loaded strand, T_max its strength
//!
//! T is the solved one of the model that answers, so that P_b is not in proportion to it: strands
//! stretch, the rubber carries a part of the pressure, and both change with the pressure. The
//! contraction is 0: the blocked muscle is the worst case. An ideal muscle has
//!
//!   T = P b² cosθ / (2 π N n²)     (b strand length, n turns, N strands)
//!
//! which falls with contraction because θ grows, and in a real one the rubber carries more of the
//! pressure the more it is widened. A muscle that a load stretches beyond its length at rest (ε <
//! 0) bursts earlier; [`Warning::StrandsBreak`](crate::warning::Warning) says so of the answer in
//! question. Of strands whose number or strength is an estimate the least P_b is that of strands
//! weaker by [`Strands::load_factor`](crate::muscle::Strands::load_factor), as stiff as before.

use super::failure::{Burst, FailurePressure, NoBurst};
use crate::{
    analysis::{
        error::{AnalysisError, Result},
        root::find_root,
    },
    model::{ForceModel, ModelError, ModelKind, Response, Workspace},
    warning::VALIDATED_STRAND_STRAIN,
};

/// Pressures in MPa up to which a burst is sought.
const HIGHEST_MPA: f64 = 1e4;
/// P_b is known to this share.
const TOLERANCE: f64 = 1e-10;
/// Pressures at which no equilibrium is found are closed in on to this share.
const EDGE: f64 = 1e-6;

/// The pressure at which the strands of a model's muscle break, where they do not bear a pressure
/// in MPa, and whether the thick-wall model gave it.
///
/// # Errors
/// [`AnalysisError`] where the work is cancelled, or the model has no answer at all.
pub fn breaking(model: &dyn ForceModel, up_to_mpa: f64) -> Result<(FailurePressure, bool)> {
    let muscle = model.muscle();
    let strength_n = match Burst::strand_strength_n(muscle) {
        Ok(strength_n) => strength_n,
        Err(why) => return Ok((FailurePressure::Unknown(why), false)),
    };
    let bears = |n: f64| overloaded(model, &|r| r.strand_tension_n, n, up_to_mpa);
    let factor = muscle.braid().strands.map_or(1.0, |s| s.load_factor());
    let least = bears(strength_n / factor)?;
    if factor <= 1.0 || least.0 == FailurePressure::None {
        return Ok(least);
    }
    Ok((bears(strength_n)?.0.down_to(least.0, up_to_mpa), least.1))
}

/// The pressure at which the strands of a model's blocked muscle are stretched to the limit of the
/// validated range, where they are not at one in MPa.
///
/// # Errors
/// [`AnalysisError`] where the work is cancelled, or the model has no answer at all.
pub fn strained(model: &dyn ForceModel, up_to_mpa: f64) -> Result<FailurePressure> {
    let muscle = model.muscle();
    if muscle.strand_strain(0.0).is_none() {
        return Ok(FailurePressure::None);
    }
    let strain = |r: &Response| muscle.strand_strain(r.braid_tension_n?);
    Ok(overloaded(model, &strain, VALIDATED_STRAND_STRAIN, up_to_mpa)?.0)
}

/// What a part carries in a state, in N, or its strain; `None` of a model that does not give it.
pub(super) type Load<'a> = dyn Fn(&Response) -> Option<f64> + 'a;

/// The pressure at which a part of the blocked muscle carries what it bears, in N, where it does
/// not bear a pressure in MPa, and whether the thick-wall model gave it.
pub(super) fn overloaded(
    model: &dyn ForceModel,
    load: &Load<'_>,
    bears: f64,
    up_to_mpa: f64,
) -> Result<(FailurePressure, bool)> {
    let answers = model.companion().unwrap_or(model);
    let blocked = || Blocked {
        model: answers,
        workspace: Workspace::new(),
        load,
        bears,
    };
    if up_to_mpa < HIGHEST_MPA && blocked().over(up_to_mpa).is_ok_and(|over| over < 0.0) {
        return Ok((FailurePressure::None, false));
    }
    let thick = ModelKind::ThickWall.build(model.muscle())?;
    // Of the infinitely long muscle: where the other begins to search.
    let mut of_thick = Blocked {
        model: &*thick,
        workspace: Workspace::new(),
        load,
        bears,
    };
    let near = of_thick.fails_near(1.0);
    let start = if let Ok(Failure::Fails(p) | Failure::Ends(p)) = near {
        p
    } else {
        1.0
    };
    match blocked().fails_near(start) {
        Err(AnalysisError::Unknown { .. }) => Ok((closed(near?, &mut of_thick), true)),
        failure => Ok((closed(failure?, &mut of_thick), false)),
    }
}

/// Where the part fails, or the last pressure with an answer.
enum Failure {
    Fails(f64),
    Ends(f64),
}

/// A muscle without an equilibrium has burst: where the infinitely long one has none beyond the
/// same pressure, too.
fn closed(failure: Failure, thick: &mut Blocked<'_>) -> FailurePressure {
    const BEYOND: f64 = 1.1;
    match failure {
        Failure::Fails(pressure_mpa) => FailurePressure::at(pressure_mpa),
        Failure::Ends(pressure_mpa) => match thick.over(BEYOND * pressure_mpa) {
            Ok(over) if over < 0.0 => {
                FailurePressure::Unknown(NoBurst::NoAnswerBeyond(pressure_mpa))
            }
            _ => FailurePressure::at(pressure_mpa),
        },
    }
}

/// A part of the blocked muscle under a model.
struct Blocked<'m> {
    model: &'m dyn ForceModel,
    workspace: Workspace,
    load: &'m Load<'m>,
    bears: f64,
}

impl Blocked<'_> {
    /// What it carries less what it bears, in N.
    fn over(&mut self, pressure_mpa: f64) -> Result<f64> {
        let response = self
            .model
            .response(&mut self.workspace, pressure_mpa, 0.0)?;
        let unknown = AnalysisError::Unknown {
            model: self.model.info().name.to_string(),
            quantity: "strand tension",
        };
        Ok((self.load)(&response).ok_or(unknown)? - self.bears)
    }

    /// The pressure at which it fails, sought from one that is thought to be near.
    fn fails_near(&mut self, near: f64) -> Result<Failure> {
        const STRIDE: f64 = 1.05;
        let bears = self.bears;
        // (pressure, excess) below and above, and a pressure without an answer.
        let mut low: Option<(f64, f64)> = None;
        let mut high: Option<(f64, f64)> = None;
        let mut without = f64::INFINITY;
        let mut refused = None;
        let mut p = near.clamp(1e-6, HIGHEST_MPA);
        loop {
            match self.over(p) {
                Ok(over) if over >= 0.0 => high = Some((p, over)),
                Ok(over) => low = Some((p, over)),
                Err(error @ AnalysisError::Model(ModelError::Cancelled(_))) => return Err(error),
                Err(error @ AnalysisError::Unknown { .. }) => return Err(error),
                Err(error) => {
                    without = p;
                    refused = Some(error);
                }
            }
            p = match (low, high) {
                (Some(low), Some(high)) => return self.between(low.0, high.0),
                // The load is nearly in proportion to the pressure.
                (None, Some((p, over))) => (p * bears / (over + bears) / STRIDE).min(p / STRIDE),
                (Some((p, over)), None) => {
                    let next =
                        (p * bears / (over + bears).max(f64::MIN_POSITIVE)).min(4.0 * p) * STRIDE;
                    let next = if next >= without {
                        0.5 * (p + without)
                    } else {
                        next
                    };
                    if p >= HIGHEST_MPA || without - p <= EDGE * p {
                        return Ok(Failure::Ends(p));
                    }
                    next.min(HIGHEST_MPA)
                }
                (None, None) => 0.5 * p,
            };
            if p < 1e-9 {
                // Not even without pressure.
                let none =
                    ModelError::NoEquilibrium("the blocked muscle has no equilibrium".into());
                return Err(refused.unwrap_or_else(|| none.into()));
            }
        }
    }

    fn between(&mut self, low: f64, high: f64) -> Result<Failure> {
        // Both signs were found.
        Ok(Failure::Fails(
            find_root(|p| self.over(p), low, high, TOLERANCE * high)?.unwrap_or(low),
        ))
    }
}
