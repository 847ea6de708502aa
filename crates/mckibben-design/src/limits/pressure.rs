//! Limits that lower the pressure up to which a muscle is used.

use super::check::Show;
use crate::{
    Relaxation,
    relaxation::{Change, three_digits},
    trial::Trial,
};
use mckibben_core::{
    analysis::{FailureMode, LEAST_SAFETY, PROVED, RELIEF, bisect},
    model::{ModelError, Result},
    units::Dimension,
};

/// Why a muscle is not used up to the pressure of the supply.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Below {
    /// It keeps its distance from a failure at this pressure in MPa.
    Failure(FailureMode, f64),
    /// Its fittings are rated for no more.
    Rated,
    /// Its strands are strained to their limit.
    Strained,
    /// No model answers beyond this pressure in MPa.
    Unanswered(f64),
}

impl Below {
    /// Why more is not allowed, with pressures written by `show`.
    pub fn describe(&self, show: Show<'_>) -> String {
        let mpa = |p| show(Dimension::Pressure, p);
        match self {
            Self::Failure(by, at_mpa) => {
                format!("more is not allowed, because {by} at {}", mpa(*at_mpa))
            }
            Self::Rated => "its fittings are rated for no more".into(),
            Self::Strained => "there its strands are stretched to their limit".into(),
            Self::Unanswered(up_to_mpa) => format!("no model answers beyond {}", mpa(*up_to_mpa)),
        }
    }
}

/// Halvings towards the pressure at which strands are strained to their limit.
const HALVINGS: usize = 40;

/// Lowers the highest pressure of a muscle to the least of its limits.
pub fn lower(trial: &mut Trial<'_>) -> Result<()> {
    let allowed = trial.burst.allowed().map(|allowed| {
        let below = match allowed.by {
            FailureMode::Fittings => Below::Rated,
            FailureMode::StrandStrain => Below::Strained,
            FailureMode::NoAnswer => Below::Unanswered(allowed.failure_mpa()),
            by => Below::Failure(by, allowed.failure_mpa()),
        };
        (allowed.mpa, below)
    });
    if let Some((mpa, below)) = allowed {
        // With room for the relief valve, which opens at the allowed pressure.
        if mpa / RELIEF < trial.highest_mpa {
            (trial.highest_mpa, trial.below) = (mpa / RELIEF, Some(below));
        }
    }
    strained(trial)
}

/// The strands are strained by no more than their limit, not shortened and at the operating points.
fn strained(trial: &mut Trial<'_>) -> Result<()> {
    let Some(bound) = trial.spec.limits.strand_strain else {
        return Ok(());
    };
    for contraction in contractions(trial) {
        let high = trial.highest_mpa;
        let mut bears = |p: f64| match trial.strand_strain(p, contraction) {
            Ok(strain) => Ok(strain.is_none_or(|strain| strain <= bound)),
            // Where they stretch further there is no answer at all.
            Err(ModelError::Overstretched { .. } | ModelError::NoEquilibrium(_)) => Ok(false),
            Err(error) => Err(error),
        };
        if bears(high)? {
            continue;
        }
        let (high, _) = bisect(0.0, high, HALVINGS, |p| bears(p).unwrap_or(false));
        (trial.highest_mpa, trial.below) = (high, Some(Below::Strained));
    }
    Ok(())
}

/// Where the strands are held against their limit: not shortened and at the operating points.
fn contractions(trial: &Trial<'_>) -> Vec<f64> {
    let points = trial.spec.points(trial.muscle);
    std::iter::once(0.0)
        .chain(points.iter().map(|q| q.contraction))
        .collect()
}

/// A limit of the pressure that may be moved.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub enum PressureLimit {
    Supply,
    Safety,
    StrandStrain,
}

impl PressureLimit {
    /// What limits the pressure of a muscle, where it may be moved.
    pub fn of(trial: &Trial<'_>) -> Option<Self> {
        match trial.below {
            None => Some(Self::Supply),
            Some(Below::Failure(..)) => Some(Self::Safety),
            Some(Below::Strained) => Some(Self::StrandStrain),
            Some(Below::Rated | Below::Unanswered(_)) => None,
        }
    }

    /// The change that allows a pressure.
    pub fn allow(self, needed_mpa: f64, trial: &mut Trial<'_>) -> Option<Change> {
        let limits = &trial.spec.limits;
        let (supply_mpa, share) = (trial.spec.max_pressure_mpa, trial.spec.supply_share);
        if self != Self::Supply && needed_mpa > share * supply_mpa {
            return None;
        }
        Some(match self {
            Self::Supply => {
                let pressure_mpa = three_digits(needed_mpa / share, true);
                let change = Relaxation::MaxPressure {
                    pressure_mpa,
                    extrapolated: pressure_mpa > trial.model.info().range.pressure_mpa.1,
                };
                ((pressure_mpa / supply_mpa).ln(), change)
            }
            Self::Safety => {
                let most_mpa = RELIEF * needed_mpa;
                let failures = trial.burst.modes();
                let margins = failures.iter().filter_map(|(by, at)| {
                    let least = Some(at.least_mpa()?).filter(|p| *p < PROVED * most_mpa);
                    Some(
                        at.mpa()
                            .unwrap_or(f64::INFINITY)
                            .min(least.unwrap_or(f64::INFINITY))
                            / by.share()
                            / most_mpa,
                    )
                });
                let burst_margin = three_digits(margins.reduce(f64::min)?, false);
                if burst_margin < LEAST_SAFETY {
                    return None;
                }
                let change = Relaxation::MinBurstMargin { burst_margin };
                ((limits.burst_margin? / burst_margin).ln(), change)
            }
            Self::StrandStrain => {
                let places = contractions(trial).into_iter();
                let strains = places.filter_map(|e| trial.strand_strain(needed_mpa, e).ok()?);
                let strand_strain = three_digits(strains.reduce(f64::max)?, true);
                let change = Relaxation::MaxStrandStrain { strand_strain };
                ((strand_strain / limits.strand_strain?).ln(), change)
            }
        })
    }
}
