//! Two equal muscles and the pulley between them.

use crate::line::{Merit, least, refine};
use crate::search::{Search, nice_steps};
use crate::spec::THICK_WALL;
use crate::{Demand, JointDemand, Models, Outcome, Spec, SpecError, design_with};
use mckibben::cancel::Cancelled;
use mckibben::progress::{CancelOnly, Progress};
use mckibben::units::Values;

/// Samples of an interval of radii, and golden sections after them.
const RADII: (usize, usize) = (10, 8);

/// Searches with the model that settles about the best radius of the other one, and the ratio of neighbours.
const NEAR: usize = 7;
const BESIDE: f64 = 1.15;

/// A radius with what it gave.
type Tried = (f64, Merit);

/// Searches radius and muscle for torques at angles: the radius with the best muscle, and what was found with it.
///
/// The radius of the demand in `spec` is not used; `radius_mm` says which are looked at. Of a long lever the muscle must
/// shorten more, of a short one it must pull more: between them lies the smallest muscle.
pub fn design_joint(
    spec: &Spec,
    radius_mm: &Values,
    models: Models<'_>,
    progress: &dyn Progress,
) -> Result<(Spec, Outcome), SpecError> {
    let on_radius = |spec: &Spec, radius_mm: f64| match &spec.wanted {
        Demand::Joint(joint) => {
            Spec { wanted: Demand::Joint(JointDemand { radius_mm, ..joint.clone() }), ..spec.clone() }
        }
        _ => spec.clone(),
    };
    let with = |radius_mm: f64| on_radius(spec, radius_mm);
    let (places, sections) = match radius_mm {
        Values::List(list) => (list.clone(), 0),
        Values::Interval(low, high) => (nice_steps(*low, *high, RADII.0), RADII.1),
    };
    let coarse = models.settle.is_some() && sections > 0;
    let total = places.len() + sections + 1 + if coarse { sections + NEAR } else { 0 };
    let mut done = 0;
    let mut first_error = None;
    // The best radius hardly depends on the model: where another one settles, the infinitely long muscle says about where it lies.
    let roughly = if coarse { Models { search: THICK_WALL, settle: None } } else { models };
    let mut tried = |spec: Spec, models: Models<'_>| -> (Merit, Spec) {
        progress.report(done, total);
        done += 1;
        match spec.check() {
            _ if progress.cancelled() => (Merit::NONE, spec),
            Ok(()) => {
                let spec = Spec { extrapolate: true, ..spec };
                let quiet = CancelOnly(progress);
                let search = Search::new(&spec, models, &quiet);
                let result = search.run();
                (result.merit().0, search.of_parts(&result))
            }
            Err(error) => {
                first_error.get_or_insert(error);
                (Merit::NONE, spec)
            }
        }
    };
    let looked: Vec<(Merit, Spec)> = places.iter().map(|&r| tried(with(r), roughly)).collect();
    let samples: Vec<Tried> = places.iter().zip(&looked).map(|(&r, look)| (r, look.0)).collect();
    let best = least(&samples, |t| t.1).filter(|&i| samples[i].1 != Merit::NONE);
    let Some(i) = best else {
        return match first_error {
            _ if progress.cancelled() => Err(Cancelled.into()),
            Some(error) => Err(error),
            // No muscle at all: the search of the first radius says why.
            None => {
                let spec = with(places.first().copied().unwrap_or_default());
                design_with(&spec, models, progress).map(|outcome| (spec, outcome))
            }
        };
    };
    let mut chosen = samples[i];
    // Near the best radius with its best parts alone.
    let near_best = looked[i].1.clone();
    let mut tried = |r: f64, models: Models<'_>| (r, tried(on_radius(&near_best, r), models).0);
    if sections > 0 {
        let mut found = refine(&samples, i, sections, |t| t.1, &mut |r| tried(r, roughly));
        if coarse {
            let (low, high) = radius_mm.bounds();
            let about = [1.0 / BESIDE, 1.0, BESIDE].map(|share| (found.0 * share).clamp(low, high));
            let near = about.map(|r| tried(r, models));
            let Some(i) = least(&near, |t| t.1) else { return Err(Cancelled.into()) };
            found = refine(&near, i, NEAR - 3, |t| t.1, &mut |r| tried(r, models));
        }
        // A pulley in tenths of a millimetre.
        let rounded = tried((found.0 * 10.0).round() / 10.0, models);
        chosen = if rounded.1.fits() || !found.1.fits() { rounded } else { found };
    }
    let spec = with(chosen.0);
    design_with(&spec, models, &CancelOnly(progress)).map(|outcome| (spec, outcome))
}
