//! The main job: what to take, what else there is, and where nothing does what would have to give.

use crate::{
    Candidate, Limits, Models, Rejected, Relaxation, Spec, SpecError,
    assess::Assessed,
    bundle::{Bundle, of_candidate},
    enumerate::Place,
    held::{Held, Job, Precision},
    relaxation::relaxations,
    search::{Query, Search},
};
use mckibben_core::progress::{Progress, Silent};
use serde::Serialize;

/// Chances for which the width of a muscle is told.
const CHANCES: [f64; 3] = [0.5, 0.9, 0.99];
/// The chance below which a muscle is no answer at all.
const LEAST_CHANCE: f64 = 0.01;

/// What a design found.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// Muscles that fit, best first; the first is what to take.
    pub candidates: Vec<Candidate>,
    /// The first beside others that one may choose; where nothing fits what has the best chance.
    pub choices: Vec<Choice>,
    /// Muscles that do not fit, those that came closest first.
    pub rejected: Vec<Rejected>,
    /// How many muscles were looked at, and how many of them fit by the model of the screen.
    pub looked_at: (usize, usize),
    /// Where nothing fits: what to change, what asks for least first.
    pub relaxations: Vec<Relaxation>,
    /// What the muscles of a bundle do together.
    pub bundle: Option<Bundle>,
}

/// A muscle that one may choose.
#[derive(Debug, Clone)]
pub struct Choice {
    pub kind: ChoiceKind,
    pub candidate: Candidate,
}

/// What a choice is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ChoiceKind {
    /// The first, which is taken.
    Take,
    /// The best of another chance: 0.5, 0.9, or 0.99.
    Chance,
    /// One alone, where several are taken or nothing fits.
    One,
    /// Several, where one is taken or nothing fits.
    Several,
    /// One whose tube is sold, where that of the first is cast.
    Sold,
    /// One whose tube is cast, where that of the first is sold.
    Cast,
    /// A muscle as sold.
    Product,
}

/// Searches a specification with one model.
///
/// # Errors
/// [`SpecError`] where the specification cannot be searched, also because none of its combinations
/// is a muscle; that nothing fits is an [`Outcome`].
pub fn design(spec: &Spec, build: &crate::Build<'_>) -> Result<Outcome, SpecError> {
    design_with(spec, Models::one(build), &Silent)
}

/// [`design`] with two models, which tells how far it is and can be ended before it is done.
///
/// # Errors
/// Those of [`design`], and where the caller ended it.
pub fn design_with(
    spec: &Spec,
    models: Models<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, SpecError> {
    spec.check()?;
    // Outside of the range of a model as well, where another one decides.
    let spec = &Spec {
        extrapolate: spec.extrapolate || models.settle.is_some(),
        ..spec.clone()
    };
    let search = Search::new(spec, models, progress)?;
    let query = query_of(spec);
    let held = search.answer(query, spec.top);
    let candidates: Vec<Candidate> = held.iter().filter_map(|h| search.candidate(h)).collect();
    let choices = match candidates.first() {
        Some(first) => search.choices(query, first),
        None => search.best_chances(query),
    };
    progress.check()?;
    let relaxations = match candidates.is_empty() {
        true => relaxations(&search),
        false => vec![],
    };
    let bundle = candidates.first().filter(|c| c.count > 1);
    let outcome = Outcome {
        bundle: bundle.map(|first| of_candidate(spec, models.decides(), first)),
        choices,
        rejected: search.rejected(),
        looked_at: (
            search.looked_at,
            search.screened.iter().filter(|held| held.fits()).count(),
        ),
        relaxations,
        candidates,
    };
    progress.check()?;
    Ok(outcome)
}

/// What a specification asks of its list.
pub fn query_of(spec: &Spec) -> Query {
    Query {
        certainty: spec.certainty,
        counts: (spec.count, spec.most_side_by_side.max(spec.count)),
        cast: None,
        by_chance: false,
    }
}

impl Search<'_> {
    fn best(&self, kind: ChoiceKind, query: Query) -> Option<Choice> {
        let candidate = self.candidate(self.answer(query, 1).first()?)?;
        Some(Choice { kind, candidate })
    }

    /// The first beside those of other chances, of the other make and number, and as sold.
    fn choices(&self, query: Query, first: &Candidate) -> Vec<Choice> {
        let (least, most) = query.counts;
        let mut queries = vec![];
        if let Some(certainty) = query.certainty {
            let others = CHANCES.into_iter().filter(|chance| *chance != certainty);
            queries.extend(others.map(|chance| {
                let query = Query {
                    certainty: Some(chance),
                    ..query
                };
                (ChoiceKind::Chance, query)
            }));
        }
        let (make, number) = match first.is_cast {
            true => (ChoiceKind::Sold, (ChoiceKind::One, (least, least))),
            false => (ChoiceKind::Cast, (ChoiceKind::One, (least, least))),
        };
        if !self.spec.tubes.is_empty() {
            let cast = Some(!first.is_cast);
            queries.push((make, Query { cast, ..query }));
        }
        if first.count > least {
            queries.push((
                number.0,
                Query {
                    counts: number.1,
                    ..query
                },
            ));
        } else if most > least {
            let counts = (least + 1, most);
            queries.push((ChoiceKind::Several, Query { counts, ..query }));
        }
        let take = Choice {
            kind: ChoiceKind::Take,
            candidate: first.clone(),
        };
        let others = queries
            .into_iter()
            .filter_map(|(kind, query)| self.best(kind, query));
        let is_other = |choice: &Choice| {
            let same = choice.candidate.muscle == first.muscle;
            let smaller = choice.candidate.envelope_mm() < first.envelope_mm();
            !same && (choice.kind != ChoiceKind::Several || smaller)
        };
        let mut choices = vec![take];
        choices.extend(others.filter(is_other));
        choices.extend(self.products(first.radius_mm));
        choices
    }

    /// Where nothing reaches the certainty: the best chance of one, and of as many as may be.
    fn best_chances(&self, query: Query) -> Vec<Choice> {
        let (least, most) = query.counts;
        let numbers = [(ChoiceKind::One, least), (ChoiceKind::Several, most)];
        let numbers = numbers.into_iter().take(if most > least { 2 } else { 1 });
        let best = |(kind, count): (ChoiceKind, u32)| {
            let query = Query {
                certainty: Some(query.certainty?.min(LEAST_CHANCE)),
                counts: (count, count),
                by_chance: true,
                ..query
            };
            self.best(kind, query)
        };
        numbers.filter_map(best).collect()
    }

    /// The muscles as sold that would do. Burst, strands and rubber are their seller's matter.
    fn products(&self, radius_mm: f64) -> Vec<Choice> {
        let one = |product: &crate::Product| {
            let spec = self.spec;
            let muscle = cut(spec, &product.muscle)?;
            let bench_mpa = product.muscle.bench()?.pressure_mpa.1;
            let own = Spec {
                max_pressure_mpa: (spec.supply_share * spec.max_pressure_mpa).min(bench_mpa),
                supply_share: 1.0,
                base: muscle.clone(),
                tubes: vec![],
                products: vec![],
                ends: None,
                limits: Limits {
                    bulged_diameter_mm: spec.limits.bulged_diameter_mm,
                    envelope_mm: spec.limits.envelope_mm,
                    mass_g: spec.limits.mass_g,
                    liquid_volume_mm3: spec.limits.liquid_volume_mm3,
                    ..Limits::default()
                },
                ..spec.clone()
            };
            let job = Job {
                place: Place::of(&muscle),
                radius_mm,
                count: None,
            };
            let mut assessed = Assessed::new(&own, self.models.decides(), &muscle).ok()?;
            let held = Held::new(&mut assessed, job, Precision::Exact).ok()?;
            if !held.fits() || held.chance.is_none() {
                return None;
            }
            let candidate = Candidate {
                product: Some(product.name.clone()),
                ..Candidate::new(&mut assessed, &held).ok()?
            };
            Some(Choice {
                kind: ChoiceKind::Product,
                candidate,
            })
        };
        self.spec.products.iter().filter_map(one).collect()
    }
}

/// A muscle as sold at the length that is stated, to which it is cut; `None` where its own lies
/// outside of the lengths that are searched.
fn cut(
    spec: &Spec,
    muscle: &mckibben_core::muscle::Muscle,
) -> Option<mckibben_core::muscle::Muscle> {
    if let Some(lengths) = &spec.length_mm {
        let (low, high) = lengths.bounds();
        let is_inside = (low..=high).contains(&muscle.length_mm());
        return is_inside.then(|| muscle.clone());
    }
    if spec.base.length_mm() == muscle.length_mm() {
        return Some(muscle.clone());
    }
    // The ± of its bench is that of its own length: the other one has the general ±.
    let tube = mckibben_core::muscle::Tube {
        length_mm: spec.base.length_mm(),
        ..muscle.tube().clone()
    };
    muscle.with_tube(tube).ok()
}
