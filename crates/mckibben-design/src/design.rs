//! The main job: what to take, what else there is, and where nothing does what would have to give.

use crate::{
    Candidate, Limits, Models, Objective, Product, Rejected, Relaxation, Spec, SpecError,
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
    /// Why it is among the choices.
    pub kind: ChoiceKind,
    /// The muscle with its numbers.
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
    let candidates = search.answer(spec, None, spec.top);
    let (choices, relaxations) = match candidates.first() {
        Some(first) => (search.choices(first), vec![]),
        None => (search.best_chances(), relaxations(&search)),
    };
    let bundle = candidates.first().filter(|c| c.count > 1);
    let fitting = search.screened.iter().filter(|held| held.fits());
    let outcome = Outcome {
        bundle: bundle.map(|first| of_candidate(spec, models.decides(), first)),
        choices,
        rejected: search.rejected(candidates.is_empty()),
        looked_at: (search.looked_at, fitting.count()),
        relaxations,
        candidates,
    };
    progress.check()?;
    Ok(outcome)
}

impl Search<'_> {
    /// The best of another specification of the same list.
    fn best(
        &self,
        kind: ChoiceKind,
        cast: Option<bool>,
        change: impl Fn(&mut Spec),
    ) -> Option<Choice> {
        let mut spec = self.spec.clone();
        change(&mut spec);
        let candidate = self.answer(&spec, cast, 1).pop()?;
        Some(Choice { kind, candidate })
    }

    /// The first beside those of other chances, of the other make and number, and as sold.
    fn choices(&self, first: &Candidate) -> Vec<Choice> {
        let spec = self.spec;
        let mut others = vec![];
        for chance in CHANCES {
            if spec.certainty.is_some_and(|certainty| certainty != chance) {
                let of_chance = |spec: &mut Spec| spec.certainty = Some(chance);
                others.extend(self.best(ChoiceKind::Chance, None, of_chance));
            }
        }
        if !spec.tubes.is_empty() {
            let make = match first.is_cast {
                true => ChoiceKind::Sold,
                false => ChoiceKind::Cast,
            };
            others.extend(self.best(make, Some(!first.is_cast), |_| ()));
        }
        if first.count > spec.count {
            let alone = |spec: &mut Spec| spec.most_side_by_side = spec.count;
            others.extend(self.best(ChoiceKind::One, None, alone));
        } else if spec.count < spec.most_side_by_side {
            let more = |spec: &mut Spec| spec.count += 1;
            others.extend(self.best(ChoiceKind::Several, None, more));
        }
        others.retain(|choice| {
            let is_smaller = choice.candidate.envelope_mm() < first.envelope_mm();
            choice.candidate.muscle != first.muscle
                && (choice.kind != ChoiceKind::Several || is_smaller)
        });
        let take = Choice {
            kind: ChoiceKind::Take,
            candidate: first.clone(),
        };
        others.insert(0, take);
        let products = spec.products.iter();
        others.extend(products.filter_map(|one| self.product(one, first.radius_mm)));
        others
    }

    /// Where nothing reaches the certainty: the best chance of one, and of as many as may be.
    fn best_chances(&self) -> Vec<Choice> {
        let Some(certainty) = self.spec.certainty else {
            return vec![];
        };
        let (one, most) = (self.spec.count, self.spec.most_side_by_side);
        let mut numbers = vec![(ChoiceKind::One, one)];
        numbers.extend((most > one).then_some((ChoiceKind::Several, most)));
        let best = |(kind, count)| {
            self.best(kind, None, |spec| {
                spec.certainty = Some(certainty.min(LEAST_CHANCE));
                spec.objective = Objective::Chance;
                (spec.count, spec.most_side_by_side) = (count, count);
            })
        };
        numbers.into_iter().filter_map(best).collect()
    }

    /// A muscle as sold that would do. Burst, strands and rubber are its seller's matter.
    fn product(&self, product: &Product, radius_mm: f64) -> Option<Choice> {
        let spec = self.spec;
        let muscle = cut(spec, &product.muscle)?;
        let bench_mpa = product.muscle.bench()?.pressure_mpa.1;
        let job = Job {
            place: Place::of(&muscle),
            radius_mm,
            count: None,
        };
        let own = Spec {
            max_pressure_mpa: (spec.supply_share * spec.max_pressure_mpa).min(bench_mpa),
            supply_share: 1.0,
            base: muscle,
            tubes: vec![],
            rubbers: vec![],
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
        let candidate = self.decided(&own, job.place, |assessed| {
            let held = Held::new(assessed, job, Precision::Exact).ok()?;
            match held.fits() && held.chance.is_some() {
                true => Candidate::new(assessed, &held).ok(),
                false => None,
            }
        })?;
        Some(Choice {
            kind: ChoiceKind::Product,
            candidate: Candidate {
                product: Some(product.name.clone()),
                ..candidate
            },
        })
    }
}

/// A muscle as sold at the length that is stated, to which it is cut; `None` where its own lies
/// outside of the lengths that are searched.
fn cut(spec: &Spec, muscle: &Muscle) -> Option<Muscle> {
    let own_mm = muscle.length_mm();
    if let Some(lengths) = &spec.length_mm {
        let (low, high) = lengths.bounds();
        return (low..=high).contains(&own_mm).then(|| muscle.clone());
    }
    let length_mm = spec.base.length_mm();
    if length_mm == own_mm {
        return Some(muscle.clone());
    }
    // The ± of its bench is that of its own length: the other one has the general ±.
    let tube = Tube {
        length_mm,
        ..muscle.tube().clone()
    };
    muscle.with_tube(tube).ok()
}
