//! Newton's method with a tangent that may serve twice.
//!
//! The last correction of a solve is usually so small that the next residual is below the
//! tolerance: it is then computed alone, and where it is a little above, the old tangent corrects
//! once more. Nothing is allocated.

use mckibben_core::cancel::Cancelled;
use thiserror::Error;

/// A system of equations at its present iterate.
pub trait NewtonSystem {
    /// Size of the residual relative to what it is made of.
    ///
    /// # Errors
    /// [`Stopped`] where the iterate is not admissible.
    fn residual(&mut self) -> Result<f64>;

    /// The same, with the tangent factorised.
    fn linearise(&mut self) -> Result<f64>;

    /// Solves with the last tangent and moves on; gives the relative size of the correction.
    fn correct(&mut self) -> Result<f64>;

    /// Takes back half of the last correction, or of what is left of it.
    fn retreat(&mut self);
}

/// An iterate, or why it is none.
pub type Result<T, E = Stopped> = std::result::Result<T, E>;

/// Why an iterate is not admissible or the iteration ended without an answer.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum Stopped {
    /// An element is turned inside out.
    #[error("the wall folds: in one place the rubber would be turned inside out")]
    Inverted,
    /// A number that is not finite: a law beyond its limit.
    #[error("the rubber is stretched past the limit of its law")]
    NotFinite,
    /// A pivot of the tangent that is zero or no number.
    #[error("the muscle has no stiffness against some change of its shape: it buckles")]
    Singular,
    /// Corrections that do not become smaller.
    #[error("the iteration for the deformed shape did not converge")]
    Iterations,
    /// No equilibrium continues the one before.
    #[error("the equilibrium path from the taut muscle ends before this point")]
    Branch,
    /// The equilibrium is not stable.
    #[error("the equilibrium is unstable")]
    Unstable,
    /// The work that a question may cost is spent.
    #[error("the iteration for the deformed shape was stopped because it took too long")]
    Budget,
    /// The caller wanted the work to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// Corrections beyond any sense.
    #[error("the iteration for the deformed shape diverged")]
    Diverged,
}

/// The last equilibrium on a way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LastConverged {
    /// Pressure in MPa.
    pub pressure_mpa: f64,
    /// Contraction ratio.
    pub contraction: f64,
    /// Pull in N.
    pub force_n: f64,
}

/// Why a walk ended, and the last equilibrium on it.
#[derive(Debug, Clone, Copy)]
pub struct Interrupted {
    /// Why the last step was given up.
    pub reason: Stopped,
    /// The last equilibrium.
    pub last: LastConverged,
}

/// An equilibrium, or why there is none.
pub type Solved = Result<()>;

/// A walk to an equilibrium, or where it ended before.
pub type Walked = Result<(), Interrupted>;

impl Stopped {
    /// Whether further attempts are useless: the allowed work is done.
    pub fn is_final(&self) -> bool {
        matches!(self, Self::Budget | Self::Cancelled(_))
    }
}

/// Settings of [`solve`].
#[derive(Debug, Clone)]
pub struct NewtonOptions {
    /// Largest relative residual of an answer.
    pub tolerance: f64,
    /// Most corrections.
    pub iterations: usize,
    /// Below this correction the residual is computed before a new tangent.
    pub small: f64,
    /// Above this sum of corrections the iteration is given up: the answer would not continue where
    /// it began.
    pub reach: f64,
    /// Most factorisations of one solve.
    pub factorisations: usize,
    /// Whether the last tangent is that of an equilibrium near by: the first correction uses it.
    pub neighbour: bool,
}

impl NewtonOptions {
    /// The defaults.
    pub const DEFAULT: Self = Self {
        tolerance: 1e-10,
        iterations: 20,
        small: 2e-3,
        reach: f64::INFINITY,
        factorisations: usize::MAX,
        neighbour: false,
    };
}

/// What a solve cost.
#[derive(Debug, Clone, Copy, Default)]
pub struct Effort {
    /// Corrections.
    pub iterations: usize,
    /// Tangents assembled and factorised.
    pub factorisations: usize,
    /// Last relative residual.
    pub residual: f64,
    /// How far the last solve went from where it began: the sum of its corrections' sizes.
    pub moved: f64,
}

const RETREATS: usize = 6;
/// Above this correction the iteration is given up.
const LARGE: f64 = 50.0;
/// A correction below this is rounding: the residual may then be as large as [`ROUNDING_RESIDUAL`].
const ROUNDING: f64 = 1e-11;
const ROUNDING_RESIDUAL: f64 = 1e-8;

/// A new tangent, and the residual: where the last correction leads to no admissible iterate, at a
/// share of it.
fn linearise_on_way(
    system: &mut dyn NewtonSystem,
    most: usize,
    factorisations: &mut usize,
) -> Result<f64> {
    let mut retreats = 0;
    loop {
        if *factorisations >= most {
            return Err(Stopped::Budget);
        }
        *factorisations += 1;
        match system.linearise() {
            Err(Stopped::Inverted | Stopped::NotFinite) if retreats < RETREATS => {
                retreats += 1;
                system.retreat();
            }
            result => return result,
        }
    }
}

/// Runs Newton's method until the residual is below the tolerance. Adds its cost to `effort`, also
/// where it fails. `watch` sees every residual and may end the iteration.
///
/// # Errors
/// [`Stopped`]; the system then holds an iterate that is no answer.
pub fn solve(
    system: &mut dyn NewtonSystem,
    options: &NewtonOptions,
    effort: &mut Effort,
    mut watch: impl FnMut(f64) -> Result<()>,
) -> Result<()> {
    let most = effort.factorisations.saturating_add(options.factorisations);
    effort.moved = 0.0;
    if options.neighbour {
        effort.iterations += 1;
        watch(system.residual()?)?;
        effort.moved += system.correct()?;
    }
    effort.factorisations += 1;
    let mut norm = system.linearise()?;
    watch(norm)?;
    for iteration in 0..=options.iterations {
        effort.residual = norm;
        if norm <= options.tolerance {
            return Ok(());
        }
        if iteration == options.iterations {
            break;
        }
        effort.iterations += 1;
        let size = system.correct()?;
        effort.moved += size;
        if !(..LARGE).contains(&size) {
            return Err(Stopped::Diverged);
        }
        if effort.moved > options.reach {
            return Err(Stopped::Branch);
        }
        if size < options.small
            && let Ok(next) = system.residual()
        {
            watch(next)?;
            let gain = next / norm;
            norm = next;
            // One more turn with the old tangent where that is likely to be the last (modified
            // Newton method).
            if norm > options.tolerance && gain * norm <= options.tolerance {
                effort.iterations += 1;
                effort.moved += system.correct()?;
                norm = system.residual()?;
                watch(norm)?;
            }
            if norm <= options.tolerance {
                continue;
            }
        }
        norm = linearise_on_way(system, most, &mut effort.factorisations)?;
        watch(norm)?;
        if size < ROUNDING && norm <= ROUNDING_RESIDUAL {
            effort.residual = norm;
            return Ok(());
        }
    }
    Err(Stopped::Iterations)
}
