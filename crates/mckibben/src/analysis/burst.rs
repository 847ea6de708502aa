//! The burst pressure of a muscle: one value for each muscle and model.
//!
//!   T(P_b, 0) = T_max,   T(P, ε) the tension of the most loaded strand, T_max its strength
//!
//! T is the solved one of the model that answers, so that P_b is not in proportion to it: strands give way, the rubber carries a part of
//! the pressure, and both change with the pressure. The contraction is 0: the blocked muscle is the worst case. An ideal muscle has
//!
//!   T = P b² cosθ / (2 π N n²)     (b strand length, n turns, N strands)
//!
//! which falls with contraction because θ grows, and in a real one the rubber carries more of the pressure the more it is widened. A
//! muscle that a load stretches beyond its length at rest (ε < 0) bursts earlier; [`Warning::StrandsBreak`](crate::warning::Warning) says
//! so of the answer in question. P_b is that of a new braid under a slow rise of the pressure: abrasion, fatigue and the clamping at the
//! terminals are no part of it, and `design` keeps a margin of 4.

use super::error::AnalysisError;
use super::root::{RootError, find_root};
use crate::model::{ForceModel, ModelError, ModelKind, Workspace};
use crate::muscle::Muscle;
use std::fmt;

/// Pressures in MPa up to which a burst is sought.
const HIGHEST_MPA: f64 = 1e4;
/// P_b is known to this share.
const TOLERANCE: f64 = 1e-10;
/// Pressures at which no equilibrium is found are closed in on to this share.
const EDGE: f64 = 1e-6;

/// What is known of a muscle's burst.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Burst {
    /// The strands reach their strength at this pressure in MPa, or the muscle has no equilibrium beyond it.
    At {
        /// P_b in MPa.
        pressure_mpa: f64,
        /// The answering model has no tension of the strands, and the thick-wall model gave it.
        from_thick_wall: bool,
    },
    /// Nothing is known, since a number is missing or the model has no answer up to there.
    Unknown(NoBurst),
}

/// Why a burst pressure is not known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NoBurst {
    /// Neither the number of the strands nor their strength is stated.
    NoStrands,
    /// The number of the strands is stated, and their strength is not.
    NoStrength,
    /// The model has no answer beyond this pressure in MPa, and the strands hold up to it.
    NoAnswer {
        /// The largest pressure with an answer.
        up_to_mpa: f64,
    },
}

impl fmt::Display for NoBurst {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoStrands => f.write_str(
                "the strength of the braid is not stated; give `strands` (how many) and `strand_strength` (such as \"40 N\") in [braid] of the muscle file",
            ),
            Self::NoStrength => f.write_str(
                "the strength of the strands is not stated; give `strand_strength` (such as \"40 N\") in [braid] of the muscle file",
            ),
            Self::NoAnswer { up_to_mpa } if *up_to_mpa == 0.0 => {
                f.write_str("the model has no answer for the blocked muscle; another model may answer")
            }
            Self::NoAnswer { up_to_mpa } => write!(
                f,
                "the model has no answer beyond {up_to_mpa:.3} MPa ({:.2} bar), and up to there the strands hold; another model may answer",
                10.0 * up_to_mpa
            ),
        }
    }
}

impl Burst {
    /// P_b in MPa, where it is known.
    pub fn pressure_mpa(&self) -> Option<f64> {
        match *self {
            Self::At { pressure_mpa, .. } => Some(pressure_mpa),
            Self::Unknown(_) => None,
        }
    }

    /// What a muscle must state for its burst pressure to be known.
    pub fn missing(muscle: &Muscle) -> Option<NoBurst> {
        match muscle.braid().strands {
            None => Some(NoBurst::NoStrands),
            Some(strands) if strands.strength_n.is_none() => Some(NoBurst::NoStrength),
            Some(_) => None,
        }
    }
}

/// The burst pressure of a model's muscle. The answer does not depend on what the workspace was used for before.
///
/// # Errors
/// [`AnalysisError`] where the budget is spent, or the model has no answer at all.
pub fn burst<M: ForceModel + ?Sized>(model: &M, workspace: &Workspace) -> Result<Burst, AnalysisError> {
    let strength = match Burst::missing(model.muscle()) {
        Some(missing) => return Ok(Burst::Unknown(missing)),
        None => model.muscle().braid().strands.and_then(|s| s.strength_n).unwrap_or(f64::INFINITY),
    };
    let thick = ModelKind::ThickWall.build(model.muscle())?;
    let budget = workspace.budget();
    // Of the infinitely long muscle: where the other begins to search.
    let mut of_thick = Strands { model: &*thick, workspace: Workspace::within(budget.clone()), strength };
    let near = of_thick.break_near(1.0);
    let found = match model.extensions().companion {
        Some(companion) => {
            let workspace = Workspace::within(budget.clone());
            Strands { model: companion, workspace, strength }.break_near(guess(&near))
        }
        None => {
            let workspace = Workspace::within(budget.clone());
            Strands { model, workspace, strength }.break_near(guess(&near))
        }
    };
    match found {
        Err(AnalysisError::Unknown { .. }) => Ok(burst_of(near?, &mut of_thick, true)),
        found => Ok(burst_of(found?, &mut of_thick, false)),
    }
}

/// Where the strands break, or the last pressure with an answer.
enum Found {
    Breaks(f64),
    Ends(f64),
}

fn guess(near: &Result<Found, AnalysisError>) -> f64 {
    match near {
        Ok(Found::Breaks(p) | Found::Ends(p)) => *p,
        Err(_) => 1.0,
    }
}

/// A muscle without an equilibrium has burst: where the infinitely long one has none beyond the same pressure, too.
fn burst_of(found: Found, thick: &mut Strands<'_, dyn ForceModel>, from_thick_wall: bool) -> Burst {
    const BEYOND: f64 = 1.1;
    match found {
        Found::Breaks(pressure_mpa) => Burst::At { pressure_mpa, from_thick_wall },
        Found::Ends(pressure_mpa) => match thick.over(BEYOND * pressure_mpa) {
            Ok(over) if over < 0.0 => Burst::Unknown(NoBurst::NoAnswer { up_to_mpa: pressure_mpa }),
            _ => Burst::At { pressure_mpa, from_thick_wall },
        },
    }
}

/// The strands of a blocked muscle under a model.
struct Strands<'m, M: ForceModel + ?Sized> {
    model: &'m M,
    workspace: Workspace,
    strength: f64,
}

impl<M: ForceModel + ?Sized> Strands<'_, M> {
    /// T − T_max of the blocked muscle, in N.
    fn over(&mut self, pressure_mpa: f64) -> Result<f64, AnalysisError> {
        let tension = self.model.response(&mut self.workspace, pressure_mpa, 0.0)?.strand_tension_n;
        let unknown =
            AnalysisError::Unknown { model: self.model.info().name.to_string(), quantity: "strand tension" };
        Ok(tension.ok_or(unknown)? - self.strength)
    }

    /// The pressure at which the strands break, sought from one that is thought to be near.
    fn break_near(&mut self, near: f64) -> Result<Found, AnalysisError> {
        const STRIDE: f64 = 1.05;
        let strength = self.strength;
        // (pressure, T − T_max) below and above, and a pressure without an answer.
        let mut low: Option<(f64, f64)> = None;
        let mut high: Option<(f64, f64)> = None;
        let mut without = f64::INFINITY;
        let mut refused = None;
        let mut p = near.clamp(1e-6, HIGHEST_MPA);
        loop {
            match self.over(p) {
                Ok(over) if over >= 0.0 => high = Some((p, over)),
                Ok(over) => low = Some((p, over)),
                Err(AnalysisError::Model(ModelError::Exceeded(exceeded))) => {
                    return Err(ModelError::Exceeded(exceeded).into());
                }
                Err(error @ AnalysisError::Unknown { .. }) => return Err(error),
                Err(error) => {
                    without = p;
                    refused = Some(error);
                }
            }
            p = match (low, high) {
                (Some(low), Some(high)) => return self.between(low.0, high.0),
                // The tension is nearly in proportion to the pressure.
                (None, Some((p, over))) => (p * strength / (over + strength) / STRIDE).min(p / STRIDE),
                (Some((p, over)), None) => {
                    let next =
                        (p * strength / (over + strength).max(f64::MIN_POSITIVE)).min(4.0 * p) * STRIDE;
                    let next = if next >= without { 0.5 * (p + without) } else { next };
                    if p >= HIGHEST_MPA || without - p <= EDGE * p {
                        return Ok(Found::Ends(p));
                    }
                    next.min(HIGHEST_MPA)
                }
                (None, None) => 0.5 * p,
            };
            if p < 1e-9 {
                // Not even without pressure.
                let none =
                    ModelError::NoEquilibrium { reason: "the blocked muscle has no equilibrium".into() };
                return Err(refused.unwrap_or_else(|| none.into()));
            }
        }
    }

    fn between(&mut self, low: f64, high: f64) -> Result<Found, AnalysisError> {
        match find_root(|p| self.over(p), low, high, TOLERANCE * high) {
            Ok(p) => Ok(Found::Breaks(p)),
            Err(RootError::Function(error)) => Err(error),
            // Both signs were found.
            Err(RootError::NotBracketed { .. }) => Ok(Found::Breaks(low)),
        }
    }
}
