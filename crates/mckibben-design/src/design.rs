//! The main job: what to take, what else there is, and where nothing does what would have to give.

use crate::{
    Candidate, Limits, Models, Objective, Rejected, Relaxation, Spec, SpecError,
    assess::Assessed,
    bundle::{Bundle, of_candidate},
    enumerate::Place,
    held::{Held, Job, Precision},
    relaxation::relaxations,
    search::Search,
};
use mckibben_core::{
    muscle::{Muscle, Tube},
    progress::{Progress, Silent},
};
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
    let held = search.answer(spec, None, spec.top);
    let candidates: Vec<Candidate> = held.iter().filter_map(|h| search.candidate(h)).collect();
    let choices = match candidates.first() {
        Some(first) => search.choices(first),
        None => search.best_chances(),
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
        rejected: search.rejected(candidates.is_empty()),
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

impl Search<'_> {
    fn best(&self, kind: ChoiceKind, spec: &Spec, cast: Option<bool>) -> Option<Choice> {
        Some(Choice {
            kind,
            candidate: self.candidate(self.answer(spec, cast, 1).first()?)?,
        })
    }

    /// The first beside those of other chances, of the other make and number, and as sold.
    fn choices(&self, first: &Candidate) -> Vec<Choice> {
        let spec = self.spec;
        let others = CHANCES
            .into_iter()
            .filter(|chance| spec.certainty.is_some_and(|c| c != *chance));
        let of_chance = |chance: f64| {
            let spec = Spec {
                certainty: Some(chance),
                ..spec.clone()
            };
            self.best(ChoiceKind::Chance, &spec, None)
        };
        let make = if first.is_cast {
            ChoiceKind::Sold
        } else {
            ChoiceKind::Cast
        };
        let of_make = (!spec.tubes.is_empty())
            .then(|| self.best(make, spec, Some(!first.is_cast)))
            .flatten();
        let (number, counts) = match first.count > spec.count {
            true => (ChoiceKind::One, (spec.count, spec.count)),
            false => (
                ChoiceKind::Several,
                (spec.count + 1, spec.most_side_by_side),
            ),
        };
        let of_number = (counts.0 <= counts.1)
            .then(|| self.best(number, &of_counts(spec, counts), None))
            .flatten();
        let is_other = |choice: &Choice| {
            let is_smaller = choice.candidate.envelope_mm() < first.envelope_mm();
            choice.candidate.muscle != first.muscle
                && (choice.kind != ChoiceKind::Several || is_smaller)
        };
        let mut choices = vec![Choice {
            kind: ChoiceKind::Take,
            candidate: first.clone(),
        }];
        let others = others.filter_map(of_chance).chain(of_make).chain(of_number);
        choices.extend(others.filter(is_other));
        choices.extend(self.products(first.radius_mm));
        choices
    }

    /// Where nothing reaches the certainty: the best chance of one, and of as many as may be.
    fn best_chances(&self) -> Vec<Choice> {
        let spec = self.spec;
        let numbers = [
            (ChoiceKind::One, spec.count),
            (ChoiceKind::Several, spec.most_side_by_side),
        ];
        let best = |(kind, count): (ChoiceKind, u32)| {
            let spec = Spec {
                certainty: Some(spec.certainty?.min(LEAST_CHANCE)),
                objective: Objective::Chance,
                ..of_counts(spec, (count, count))
            };
            self.best(kind, &spec, None)
        };
        let several = usize::from(spec.most_side_by_side > spec.count);
        numbers
            .into_iter()
            .take(1 + several)
            .filter_map(best)
            .collect()
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
                    burst_margin: None,
                    tube_margin: None,
                    strand_strain: None,
                    stretch: None,
                    fitted_stretch: false,
                    ..spec.limits
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

/// A specification of other numbers side by side.
fn of_counts(spec: &Spec, (count, most_side_by_side): (u32, u32)) -> Spec {
    Spec {
        count,
        most_side_by_side,
        ..spec.clone()
    }
}

/// A muscle as sold at the length that is stated, to which it is cut; `None` where its own lies
/// outside of the lengths that are searched.
fn cut(spec: &Spec, muscle: &Muscle) -> Option<Muscle> {
    if let Some(lengths) = &spec.length_mm {
        let (low, high) = lengths.bounds();
        return (low..=high)
            .contains(&muscle.length_mm())
            .then(|| muscle.clone());
    }
    if spec.base.length_mm() == muscle.length_mm() {
        return Some(muscle.clone());
    }
    // The ± of its bench is that of its own length: the other one has the general ±.
    let tube = Tube {
        length_mm: spec.base.length_mm(),
        ..muscle.tube().clone()
    };
    muscle.with_tube(tube).ok()
}
