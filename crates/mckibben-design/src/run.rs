//! A design: searched with a fast model, settled with the one that is believed.

use crate::{
    Build, Candidate, Models, Reason, Rejected, Relaxation, Spec, SpecError,
    candidate::candidate,
    limits::check::{Probe, Score, probe, probe_with},
    line::STEPS,
    relax::{Kind, Misses},
    search::{NEARLY, NEARLY_SHORT, Pick, SPARE, Search, SearchResult},
    trial::Trial,
};
use mckibben_core::{
    progress::{Progress, Silent},
    threads,
    units::Values,
};
use std::cmp::Ordering;

/// What a design found.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// Muscles that fit, best first.
    pub candidates: Vec<Candidate>,
    /// Muscles that do not, those that came closest first.
    pub rejected: Vec<Rejected>,
    /// How many muscles were looked at, and how many of them fit.
    pub looked_at: (usize, usize),
    /// Where nothing fits: the muscle that comes closest, and what would have to give.
    pub closest: Option<Closest>,
    /// The muscles that fit or nearly do by the model of the search, those of the least score
    /// first.
    likely: Vec<(Score, Pick)>,
}

impl Outcome {
    /// Where no candidate is sure to give what is wanted: the best muscle that is, by the lower end
    /// of the ± (95 %).
    pub fn to_be_sure(
        &self,
        spec: &Spec,
        models: Models<'_>,
        progress: &dyn Progress,
    ) -> Option<Candidate> {
        let is_sure = |c: &Candidate| c.sure_pressure_mpa.is_some();
        if spec.guaranteed.is_some()
            || self.candidates.is_empty()
            || self.candidates.iter().any(is_sure)
        {
            return None;
        }
        let sure = Spec {
            guaranteed: Some(0.95),
            top: 1,
            ..searched(spec, models)
        };
        if spec.tubes.is_empty() {
            return design_with(&sure, models, progress).ok()?.candidates.pop();
        }
        // What is sure is among what fits, and no smaller.
        settled(&Search::new(&sure, models, progress), models, &self.likely).pop()
    }
}

/// The muscle that comes closest where nothing fits.
#[derive(Debug, Clone)]
pub struct Closest {
    /// Its measures and why it does not fit.
    pub rejected: Rejected,
    /// The muscles of the search, those that miss by least first.
    picks: Vec<Pick>,
}

impl Closest {
    /// The smallest change of each kind with which a muscle of the search of `spec` fits, those
    /// that ask for least first.
    pub fn relaxations(
        &self,
        spec: &Spec,
        models: Models<'_>,
        progress: &dyn Progress,
    ) -> Vec<Relaxation> {
        let spec = searched(spec, models);
        Misses::new(
            &Search::new(&spec, models, progress),
            models.decides(),
            &self.picks,
        )
        .relaxations()
    }

    /// The largest share of what is wanted that one of these muscles gives; `None` where less of it
    /// does not help.
    pub fn largest_share(
        &self,
        spec: &Spec,
        models: Models<'_>,
        progress: &dyn Progress,
    ) -> Option<f64> {
        let spec = searched(spec, models);
        let search = Search::new(&spec, models, progress);
        let pulls =
            Misses::new(&search, models.decides(), &self.picks).least(|kind| kind == Kind::Pull);
        pulls.into_iter().find_map(|change| match change.1 {
            Relaxation::Force { share, .. } => Some(share),
            _ => None,
        })
    }
}

/// What muscles are ranked by is larger by less than this share by the model of the search; of
/// short muscles the two are further apart.
const RANK: f64 = 0.03;
const RANK_SHORT: f64 = 0.2;
/// Where none of those fits: so many that miss by more, the nearest first. The largest diameter of
/// the two models differs by up to a tenth where little is contracted.
const FARTHER: usize = 40;
/// Muscles that are settled side by side.
const CHUNK: usize = 4;
/// Shares by which the two models' diameters may differ, tried one after the other.
const WIDTHS: [f64; 3] = [0.01, 0.05, 0.25];

/// Searches a specification with one model.
///
/// # Errors
/// [`SpecError`] where the specification cannot be searched, also because none of its combinations
/// is a muscle; that nothing fits is an [`Outcome`].
pub fn design(spec: &Spec, build: &Build<'_>) -> Result<Outcome, SpecError> {
    design_with(spec, Models::one(build), &Silent)
}

/// [`design`] with two models, which tells how far it is and can be ended before it is done.
pub fn design_with(
    spec: &Spec,
    models: Models<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, SpecError> {
    spec.check()?;
    let searched = searched(spec, models);
    let search = Search::new(&searched, models, progress);
    let mut result = search.run();
    if result.fits.is_empty()
        && result.misses.is_empty()
        && let Some(error) = result.invalid.take()
        && !progress.cancelled()
    {
        return Err(SpecError::NoMuscle(error));
    }
    let mut likely: Vec<(Score, Pick)> = result.fits.iter().chain(&result.near).copied().collect();
    for (score, pick) in &mut likely {
        score[0] -= score[0].abs() * if pick.is_short() { RANK_SHORT } else { RANK };
    }
    likely.sort_by(|a, b| order(&a.0, &b.0));
    let mut candidates = settled(&search, models, &likely);
    if candidates.is_empty() && models.settle.is_some() {
        let farther = result
            .misses
            .iter()
            .filter(|miss| (NEARLY..=NEARLY_SHORT).contains(&miss.0));
        let farther: Vec<(Score, Pick)> = farther
            .take(FARTHER)
            .map(|miss| ([f64::NEG_INFINITY; 2], miss.1))
            .collect();
        candidates = settled(&search, models, &farther);
    }
    progress.check()?;
    let decides = models.decides();
    let fitted = result
        .fits
        .iter()
        .map(|fit| fit.1)
        .filter(|_| candidates.is_empty());
    let picks: Vec<Pick> = fitted
        .chain(result.misses.iter().map(|miss| miss.1))
        .collect();
    let reject = |pick: &Pick| {
        let muscle = search.muscle(*pick).ok()?;
        let (reason, misses_by) = match probe(search.spec, decides, &muscle) {
            Ok(probe) => (
                Reason::Limit(*probe.worst().filter(|c| c.excess() > 0.0)?),
                Some(probe.miss()),
            ),
            Err(error) => (Reason::Model(error), None),
        };
        Some(Rejected::new(muscle, reason, misses_by))
    };
    // By the model that decides others may be closer than by that of the search.
    let nearest = &picks[..picks.len().min(spec.top + SPARE)];
    let mut rejected: Vec<Rejected> = threads::map(nearest, reject)
        .into_iter()
        .flatten()
        .collect();
    let missed = |r: &Rejected| r.misses_by.unwrap_or(f64::INFINITY);
    rejected.sort_by(|a, b| missed(a).total_cmp(&missed(b)));
    rejected.truncate(spec.top);
    let closest = rejected.first().filter(|_| candidates.is_empty());
    let closest = closest.map(|rejected| Closest {
        rejected: rejected.clone(),
        picks,
    });
    progress.check()?;
    Ok(Outcome {
        candidates,
        rejected,
        looked_at: (result.looked_at, result.fitted),
        closest,
        likely,
    })
}

/// What is searched: outside of the range of a model as well, where another one decides.
pub fn searched(spec: &Spec, models: Models<'_>) -> Spec {
    Spec {
        extrapolate: spec.extrapolate || models.settle.is_some(),
        ..spec.clone()
    }
}

fn order(a: &Score, b: &Score) -> Ordering {
    a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]))
}

/// Of likely muscles, those of the least score first, the ones that hold by the model that decides,
/// best first.
fn settled(search: &Search<'_>, models: Models<'_>, likely: &[(Score, Pick)]) -> Vec<Candidate> {
    let spec = search.spec;
    let build = models.decides();
    let one = |pick: &Pick| -> Option<Candidate> {
        if search.progress.cancelled() {
            return None;
        }
        let pick = if models.settle.is_some() {
            corrected(search, build, *pick)?
        } else {
            *pick
        };
        let muscle = search.muscle(pick).ok()?;
        if spec.guaranteed.is_some() && !search.is_near(pick, &muscle) {
            return None;
        }
        let mut trial = Trial::new(spec, build, &muscle).ok()?;
        let probe = probe_with(&mut trial, true).ok().filter(Probe::fits)?;
        let tube = search.tube(pick).map(|part| part.name.clone());
        candidate(trial, &probe)
            .ok()
            .map(|found| Candidate { tube, ..found })
    };
    let mut found: Vec<Candidate> = vec![];
    for some in likely.chunks(CHUNK) {
        // None of those that are left is better than the last that is printed.
        let last = found.get(spec.top - 1).map(|c| c.score[0]);
        if last.is_some_and(|last| some[0].0[0] > last) {
            break;
        }
        let picks: Vec<Pick> = some.iter().map(|(_, pick)| *pick).collect();
        found.extend(threads::map(&picks, one).into_iter().flatten());
        found.sort_by(|a, b| order(&a.score, &b.score));
        found.dedup_by(|a, b| a.muscle == b.muscle);
    }
    found.truncate(spec.top);
    found
}

/// The muscle with the diameter that the model which decides asks for.
fn corrected(search: &Search<'_>, build: &Build<'_>, mut pick: Pick) -> Option<Pick> {
    let Values::Interval(low, high) = &search.spec.outer_diameter_mm else {
        return Some(pick);
    };
    if search.tube(pick).is_some() {
        return Some(pick);
    }
    for width in WIDTHS {
        let from = (pick.d0 * (1.0 - width)).max(*low);
        let to = (pick.d0 * (1.0 + width)).min(*high);
        let (fit, _) = search.best_diameter_within(
            pick,
            (from, to),
            build,
            STEPS,
            &mut SearchResult::default(),
        );
        let Some(fit) = fit else { continue };
        // At an edge that is not a bound of the search the best one lies beyond.
        let edge = (fit.x - from < 1e-3 * fit.x && from > *low)
            || (to - fit.x < 1e-3 * fit.x && to < *high);
        if !edge || width == WIDTHS[WIDTHS.len() - 1] {
            pick.d0 = fit.x;
            return Some(pick);
        }
    }
    None
}
