//! The fits of measured muscles, and what they say of points.

use crate::{
    Result,
    case::{CaseFit, MuscleCase},
    chosen::ChosenFit,
};
use mckibben_core::{
    built::{Experience, Prior},
    muscle::{Bench, Muscle},
    progress::Silent,
};
use mckibben_fit::{
    identify::{Build, IdentificationRequest, Identified, Posterior, PosteriorRequest, identify},
    library::residual::{Residual, residuals},
    measured::{DataPoint, mean_of_data},
};

/// The muscle and the constants of a fit to points: least squares of the pulls, from one side,
/// without history.
pub fn fitted(
    build: &Build<'_>,
    fit: &CaseFit,
    points: &[DataPoint],
) -> Result<(Muscle, Vec<Identified>)> {
    if fit.free.is_empty() {
        return Ok((fit.muscle.clone(), vec![]));
    }
    let found = ChosenFit::new(&fit.muscle, &fit.free, points, build).found()?;
    Ok((found.muscle, found.parameters))
}

/// What the muscle that some points of a bench give, beside what is known of all muscles, says of
/// others.
pub fn predicted(
    build: &Build<'_>,
    fit: &CaseFit,
    points: &[DataPoint],
    others: &[DataPoint],
) -> Result<Vec<Residual>> {
    let section = points.first().map(|p| p.section.apply(&fit.muscle));
    let muscle = section.and_then(|m| m.ok()).unwrap_or(fit.muscle.clone());
    let request = IdentificationRequest::new(&muscle, &[], points, build);
    let muscle = identify(&request)?.with_bench();
    Ok(residuals(build, &muscle, others, 0.0))
}

/// What points tell of the constants of a muscle beside a prior.
pub fn posterior(
    muscle: &Muscle,
    points: &[DataPoint],
    (experience, prior): (&Experience, &Prior),
    build: &Build<'_>,
) -> Option<Posterior> {
    let request = PosteriorRequest {
        muscle,
        points,
        build,
        experience,
        prior,
        progress: &Silent,
        bounds: &[],
        search: true,
        zero: false,
    };
    request.posterior().ok().flatten()
}

/// Means of branches and points without one, then the single branches. A point whose other branch
/// is missing is in the second list alone.
pub fn compared<'a>(means: &'a [DataPoint], points: &'a [DataPoint]) -> Vec<&'a DataPoint> {
    let is_mean = |p: &&DataPoint| p.at.direction().is_mean();
    let single = points.iter().filter(|p| !is_mean(p));
    means.iter().filter(is_mean).chain(single).collect()
}

/// Identifies a muscle from the mean of its branches as its first fit says, and compares all its
/// points with it; on single branches with a friction that is estimated by c_f.
pub fn first_fit_residuals(
    case: &MuscleCase,
    friction_share: f64,
    build: &Build<'_>,
) -> Result<Vec<Residual>> {
    let fit = case.fits.first().ok_or("no fit")?;
    let means = mean_of_data(&case.points);
    let (muscle, _) = fitted(build, fit, &means)?;
    let points = compared(&means, &case.points);
    Ok(residuals(build, &muscle, points, friction_share))
}

/// The muscle of the library that a case gives by its library fit, with the bench that states its ±
/// and with its source.
pub fn identified(case: &MuscleCase, build: &Build<'_>) -> Result<Muscle> {
    let fit = case.fits.get(case.library_fit).ok_or("no fit")?;
    let points = case.points_of(fit);
    let chosen = ChosenFit::new(&fit.muscle, &fit.free, &points, build);
    let muscle = chosen.with_bench(&chosen.found()?);
    let bench = muscle.bench().ok_or("no bench")?.clone();
    Ok(muscle.with_bench(Bench {
        laboratory: Some(case.facts.source.clone()),
        ..bench
    }))
}
