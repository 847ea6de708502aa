//! A design: searched with a fast model, settled with the one that is believed.

use crate::{
    Build, Candidate, Models, Objective, Reason, Rejected, Relaxation, Spec, SpecError,
    candidate::candidate,
    choice::{EQUAL, Sharing, order, ranked},
    limits::check::{Probe, Score, fits, probe, probe_with},
    line::STEPS,
    misses::{Kind, Misses},
    search::{NEARLY, NEARLY_SHORT, Pick, SPARE, Search, SearchResult},
    trial::Trial,
};
use mckibben_core::{
    analysis::bisect,
    by_number::SortByNumber,
    muscle::Muscle,
    progress::{Progress, Silent},
    threads,
    units::{Values, tidy},
};

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
    /// Where the candidates have tubes that are sold the best one that is cast, and vice versa.
    pub other_make: Option<Candidate>,
    /// What may take the place of one muscle, or is sure.
    pub(crate) sharing: Sharing,
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
pub const RANK: f64 = 0.03;
const RANK_SHORT: f64 = 0.2;
/// Where none of those fits: so many that miss by more, the nearest first. The largest diameter of
/// the two models differs by up to a tenth where little is contracted.
const FARTHER: usize = 40;
/// A tube that is sold comes before one that is cast as long as its muscle is at most so many times
/// as large.
pub const SOLD: f64 = 1.5;
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
    let (mut candidates, other_make) = settled_makes(&search, models, likely);
    if candidates.is_empty() && models.settle.is_some() {
        let farther = result
            .misses
            .iter()
            .filter(|miss| (NEARLY..=NEARLY_SHORT).contains(&miss.0));
        let farther: Vec<(Score, Pick)> = farther
            .take(FARTHER)
            .map(|miss| ([f64::NEG_INFINITY; 2], miss.1))
            .collect();
        candidates = settled(&search, models, &farther, spec.top);
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
    rejected.sort_by_number(missed);
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
        other_make,
        sharing: result.sharing,
    })
}

/// What is searched: outside of the range of a model as well, where another one decides.
pub fn searched(spec: &Spec, models: Models<'_>) -> Spec {
    Spec {
        extrapolate: spec.extrapolate || models.settle.is_some(),
        ..spec.clone()
    }
}

/// A muscle that holds by the model that decides, with what it is chosen by.
#[derive(Debug, Clone)]
pub struct Settled {
    pick: Pick,
    pub muscle: Muscle,
    pub score: Score,
    /// Largest outer diameter over the points in mm.
    pub bulged_mm: f64,
    /// Least pull to spare over the points, as a share of what is wanted.
    pub margin: f64,
    /// Largest half-width of the 95 % interval over the points, likewise.
    pub half_width: f64,
}

impl Settled {
    /// A muscle, where it holds.
    pub fn new(search: &Search<'_>, models: Models<'_>, pick: Pick) -> Option<Self> {
        let spec = search.spec;
        let build = models.decides();
        if search.progress.cancelled() {
            return None;
        }
        let pick = if models.settle.is_some() {
            corrected(search, build, pick)?
        } else {
            pick
        };
        let pick = shortened(search, build, pick);
        let muscle = search.muscle(pick).ok()?;
        if spec.guaranteed.is_some() && !search.is_near(pick, &muscle) {
            return None;
        }
        let mut trial = Trial::new(spec, build, &muscle).ok()?;
        let probe = probe_with(&mut trial, true).ok().filter(Probe::fits)?;
        let mut half_width = 0.0_f64;
        for q in spec.points(&muscle).iter() {
            let needed_mpa = trial.need(q).ok()?;
            let built = trial.predicted(needed_mpa, q.contraction);
            half_width = half_width.max(built.map_or(0.0, |b| b.half_n() / q.force_n.abs()));
        }
        Some(Self {
            pick,
            score: probe.score,
            bulged_mm: probe.bulged_mm,
            margin: probe.share() - 1.0,
            half_width,
            muscle,
        })
    }

    /// All that is known of it.
    pub fn candidate(&self, search: &Search<'_>, models: Models<'_>) -> Option<Candidate> {
        let mut trial = Trial::new(search.spec, models.decides(), &self.muscle).ok()?;
        let probe = probe_with(&mut trial, true).ok()?;
        let tube = search.tube(self.pick);
        Some(Candidate {
            tube: tube.map(|part| part.name.clone()),
            is_cast: tube.is_some_and(|part| part.is_cast),
            ..candidate(trial, &probe).ok()?
        })
    }
}

/// What holds by the model that decides: tubes that are sold, then those that are cast, or vice
/// versa; and the best of those that come second.
fn settled_makes(
    search: &Search<'_>,
    models: Models<'_>,
    likely: Vec<(Score, Pick)>,
) -> (Vec<Candidate>, Option<Candidate>) {
    let top = search.spec.top;
    let (cast, sold): (Vec<_>, Vec<_>) = likely
        .into_iter()
        .partition(|(_, pick)| search.is_cast(*pick));
    let mut candidates = settled(search, models, &sold, top);
    let mut others = settled(search, models, &cast, top);
    let first = |list: &[Candidate]| list.first().map_or(f64::INFINITY, |c| c.score[0]);
    if first(&candidates) > SOLD * first(&others) {
        std::mem::swap(&mut candidates, &mut others);
    }
    let other = others.first().filter(|_| !candidates.is_empty()).cloned();
    candidates.extend(others);
    candidates.truncate(top);
    (candidates, other)
}

/// Of likely muscles, those of the least score first, so many that hold by the model that decides,
/// best first.
fn settled(
    search: &Search<'_>,
    models: Models<'_>,
    likely: &[(Score, Pick)],
    top: usize,
) -> Vec<Candidate> {
    let mut found: Vec<Settled> = vec![];
    for some in likely.chunks(CHUNK) {
        // None of those that are left is better than the last that is printed, or equal to the
        // first.
        if let (Some(first), Some(last)) = (found.first(), found.get(top - 1))
            && some[0].0[0] > last.score[0].max(EQUAL * first.score[0])
        {
            break;
        }
        let one = |(_, pick): &(Score, Pick)| Settled::new(search, models, *pick);
        found.extend(threads::map(some, one).into_iter().flatten());
        found.sort_by(|a, b| order(&a.score, &b.score));
        found.dedup_by(|a, b| a.muscle == b.muscle);
    }
    let mut found = ranked(search.spec, found, |one| one);
    found.truncate(top);
    let whole = |one: &Settled| one.candidate(search, models);
    threads::map(&found, whole).into_iter().flatten().collect()
}

/// The shortest muscle that fits down to the next shorter one of the search, where that is what is
/// ranked by.
fn shortened(search: &Search<'_>, build: &Build<'_>, pick: Pick) -> Pick {
    const RATIO: f64 = 0.8;
    const HALVINGS: usize = 5;
    let spec = search.spec;
    let Some(Values::Interval(low, _)) = spec.length_mm else {
        return pick;
    };
    if spec.objective != Objective::Length {
        return pick;
    }
    let at = |length_mm: f64| pick.with_length(tidy(length_mm, 3));
    let least_mm = low.max(RATIO * pick.length_mm());
    let least_mm = least_mm.max(spec.least_slenderness * pick.d0);
    let is_too_short = |length_mm: f64| {
        let muscle = search.muscle(at(length_mm));
        !muscle.is_ok_and(|muscle| fits(spec, build, &muscle))
    };
    at(bisect(least_mm, pick.length_mm(), HALVINGS, is_too_short).1)
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
