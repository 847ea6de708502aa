//! What share of points that were held out of a fit lies within the ± that the fit leaves.

use super::case::{CaseFit, MuscleCase};
use super::coverage::COVERAGE;
use crate::identify::{Build, IdentifyError, Request, identify_with};
use crate::least_squares::Loss;
use crate::measured::{DataPoint, mean_of_data};
use mckibben::analysis::force_on;
use mckibben::model::Workspace;
use mckibben::progress::Progress;
use mckibben::uncertainty::uncertainty;
use mckibben::verification::{CaseKind, Measure, VerificationRow};

/// Parts into which the points of a set are divided; each is held out of one fit.
const PARTS: usize = 5;
/// The share of points may differ by so much from the 95 % that the ± states.
const TOLERANCE: f64 = 0.02;

/// A point that was held out of a fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeldOut {
    /// Measured less computed, in N.
    pub left_n: f64,
    /// The ± there, in N.
    pub half_width_n: f64,
    /// The computed blocked force at the same pressure, in N.
    pub blocked_n: f64,
    /// Pressure in MPa.
    pub pressure_mpa: f64,
    /// ε.
    pub contraction: f64,
}

impl HeldOut {
    /// Whether the ± holds it.
    pub fn is_held(&self) -> bool {
        self.left_n.abs() <= self.half_width_n
    }
}

/// The fit of a set that states the most of it: that with the most constants, on all points.
pub fn richest(set: &MuscleCase) -> Option<&CaseFit> {
    let whole = set.fits.iter().filter(|fit| fit.split.is_none());
    whole.rev().max_by_key(|fit| fit.free.len())
}

/// The points of a set that a fit is made to.
pub fn points_of(set: &MuscleCase, fit: &CaseFit) -> Vec<DataPoint> {
    if fit.both_branches {
        set.points.iter().filter(|p| !p.at.branch.is_mean()).copied().collect()
    } else {
        mean_of_data(&set.points)
    }
}

/// Fits a muscle to some points of its bench and judges others by the ± of that fit: those within its range.
///
/// # Errors
/// [`IdentifyError`].
pub fn judged<B: Build>(
    fit: &CaseFit,
    fitted: &[DataPoint],
    others: &[DataPoint],
    build: &B,
    progress: &dyn Progress,
) -> Result<Vec<HeldOut>, IdentifyError> {
    let request = Request {
        muscle: &fit.muscle,
        free: &fit.free,
        fixed: &[],
        points: fitted,
        loss: Loss::Squares,
        two_sided: false,
    };
    let found = identify_with(&request, build, progress)?;
    let Some(bench) = found.bench else { return Ok(vec![]) };
    let own = found.muscle.clone().with_bench(bench.clone());
    let model = build(&own).map_err(IdentifyError::Model)?;
    let w = &mut Workspace::new();
    let of_it = |p: &&DataPoint| found.candidate.of_section(&p.section).is_ok_and(|m| m == found.muscle);
    let one = |p: &DataPoint| {
        let (pressure_mpa, contraction) =
            (p.at.pressure_mpa, p.at.contraction + found.candidate.contraction_offset);
        if bench.outside(pressure_mpa, contraction) > 0.0 {
            return None;
        }
        let direction = p.at.branch;
        let force_n = force_on(&*model, w, pressure_mpa, contraction, direction).ok()?;
        let parts = uncertainty(&*model, w, (pressure_mpa, contraction), force_n, direction)?;
        Some(HeldOut {
            left_n: p.at.force_n - force_n.max(0.0),
            half_width_n: parts.total(),
            blocked_n: model.force_n(w, pressure_mpa, 0.0).ok()?,
            pressure_mpa,
            contraction,
        })
    };
    Ok(others.iter().filter(of_it).filter_map(one).collect())
}

/// Every point of a set, each judged by a fit that it was held out of.
///
/// # Errors
/// [`IdentifyError`].
pub fn of_set<B: Build>(
    set: &MuscleCase,
    build: &B,
    progress: &dyn Progress,
) -> Result<Vec<HeldOut>, IdentifyError> {
    let Some(fit) = richest(set) else { return Ok(vec![]) };
    let points = points_of(set, fit);
    let mut all = vec![];
    for part in 0..PARTS {
        let held = |i: usize| i % PARTS == part;
        let of = |wanted: bool| -> Vec<DataPoint> {
            points.iter().enumerate().filter(|(i, _)| held(*i) == wanted).map(|(_, p)| *p).collect()
        };
        all.extend(judged(fit, &of(false), &of(true), build, progress)?);
    }
    Ok(all)
}

/// The share of points that are within their ±.
pub fn share(list: &[HeldOut]) -> Option<f64> {
    (!list.is_empty()).then(|| list.iter().filter(|p| p.is_held()).count() as f64 / list.len() as f64)
}
