//! `design`: from a specification to ranked muscles.

mod answer;
mod assumed;
mod bought;
mod bundle;
mod decision;
mod page;
mod remedies;
mod request;

pub use answer::{
    CandidateAnswer, CandidateJoint, ClosestAnswer, DemandAnswer, DesignAnswer, RejectedAnswer,
    SearchedAnswer,
};
pub use bought::BoughtAnswer;
pub use bundle::{BundleAnswer, BundlePoint};
pub use request::{DesignRequest, ObjectiveWord, OperatingPoint, TorqueWanted};

use crate::{Model, Result, UncertaintyWords, Units, figure, not_measured};
use answer::{muscle_file, not_checked, out_of_reach};
use decision::Decision;
use mckibben::analysis::Evaluation;
use mckibben::model::{ForceModel, ModelError, Workspace};
use mckibben::muscle::Muscle;
use mckibben::progress::{CancelOnly, Progress};
use mckibben_design::{
    Build, Candidate, CandidatePoint, Models, Outcome, SearchedMuscles, Spec, design_joint,
    design_with,
};
use mckibben_report::Figure;
use remedies::{RelaxationAnswer, of_parts};
use request::Search;

/// Curves are drawn of so many candidates.
const DRAWN: usize = 3;

/// Ranked muscles that fit, the reasons why others do not, and, where nothing fits, what would have
/// to give.
pub fn design(request: &DesignRequest, progress: &dyn Progress) -> Result<DesignAnswer> {
    let mut single = Searched::run(request, progress)?;
    let longer = request
        .longer()
        .filter(|_| single.outcome.closest.is_some());
    if let Some(longer) = &longer {
        single = Searched::run(longer, progress)?;
    }
    let request = longer.as_ref().unwrap_or(request);
    let (
        several,
        Searched {
            spec,
            policy,
            outcome,
        },
    ) = match single.as_bundle(request, progress)? {
        Some((several, bundle)) => (Some(several), bundle),
        None => (None, single),
    };
    let request = several.as_ref().unwrap_or(request);
    let decide = |m: &Muscle| policy.model.bound(m);
    let winner = outcome.candidates.first();
    let figure = match &request.figure {
        Some(unit) if winner.is_some() => Some(draw(&spec, &decide, &outcome, unit)?),
        _ => None,
    };
    let sure =
        policy.with_models(|models| outcome.to_be_sure(&spec, models, &CancelOnly(progress)));
    progress.check()?;
    let to_be_sure = sure.as_ref().map(|c| CandidateAnswer::new(c, &spec));
    let decision = Decision {
        spec: &spec,
        length_by: assumed::length_by(request),
        candidates: &outcome.candidates,
        to_be_sure: to_be_sure.as_ref(),
    };
    let decision = decision.lines();
    let supply_mpa = spec.max_pressure_mpa;
    let mut warnings = winner.map_or_else(|| not_checked(&outcome, supply_mpa), answer::warnings);
    let bundle = bundle::of_winner(request, &decide, winner);
    // Where no pitch is given they touch just where they are required to pull.
    warnings.extend(
        bundle
            .as_ref()
            .filter(|_| request.pitch_mm.is_some())
            .and_then(BundleAnswer::warning),
    );
    if let Some(c) = winner {
        warnings.extend(not_measured(&c.muscle, c.highest_pressure_mpa)?);
    }
    let closest = outcome.closest.as_ref().map(|closest| {
        let progress = &CancelOnly(progress);
        let changes = policy.with_models(|models| {
            let mut changes = closest.relaxations(&spec, models, progress);
            changes.extend(of_parts(request, &spec, models, closest, progress));
            changes
        });
        let changes = changes.into_iter();
        ClosestAnswer {
            rejected: (&closest.rejected).into(),
            relaxations: changes
                .map(|change| RelaxationAnswer::new(change, &spec, request))
                .collect(),
            hint: out_of_reach(&spec),
        }
    });
    let mut assumptions = assumed::assumptions(request, &spec);
    if longer.is_some() {
        let length_mm = crate::number(spec.base.length_mm(), 4);
        let because = "because of a shorter muscle the stroke is too large a share (`length_mm`)";
        assumptions.insert(
            0,
            format!("the length L0 is {length_mm}\u{a0}mm, {because}"),
        );
    }
    if let Some(count) = several.as_ref().and_then(|several| several.count) {
        let said = format!(
            "{count} equal muscles share what is required, because no single one does it (`count`)"
        );
        assumptions.insert(0, said);
    }
    Ok(DesignAnswer {
        decision,
        model: policy.model.name().into(),
        searched_with: policy.searches().into(),
        max_pressure_mpa: supply_mpa,
        wanted: DemandAnswer::new(&spec.wanted),
        searched: SearchedAnswer::new(&spec),
        liquid: spec.liquid.as_ref().map(|supply| supply.liquid.clone()),
        load: request.load.load.clone(),
        assumptions,
        looked_at: outcome.looked_at.0,
        fitting: outcome.looked_at.1,
        candidates: outcome
            .candidates
            .iter()
            .map(|c| CandidateAnswer::new(c, &spec))
            .collect(),
        uncertainty_words: words(&spec, &decide, winner),
        rejected: outcome.rejected.iter().map(RejectedAnswer::from).collect(),
        warnings,
        to_be_sure,
        closest,
        bundle,
        bought: bought::bought(request, &spec),
        figure,
        muscle_files: outcome
            .candidates
            .iter()
            .enumerate()
            .map(|(i, c)| muscle_file(i, c))
            .collect(),
    })
}

/// Counts that are tried, as multiples of the least.
const COUNTS: [f64; 4] = [1.0, 1.01, 1.5, 2.0];

/// A specification with its models and what was found.
struct Searched {
    spec: Spec,
    policy: ModelPolicy,
    outcome: Outcome,
}

impl Searched {
    fn run(request: &DesignRequest, progress: &dyn Progress) -> Result<Self> {
        let Search {
            spec,
            policy,
            radius_mm,
        } = request.search()?;
        // A mesh that one muscle has no room for is no reason against each of them.
        policy.model.bound(&spec.base)?;
        let (spec, outcome) = policy.with_models(|models| match &radius_mm {
            Some(radius_mm) => design_joint(&spec, radius_mm, models, progress),
            None => design_with(&spec, models, progress).map(|outcome| (spec, outcome)),
        })?;
        Ok(Self {
            spec,
            policy,
            outcome,
        })
    }

    /// Where no single muscle meets what is required, and no number of them is given: as few side
    /// by side as do, and as the envelope has room for.
    fn as_bundle(
        &self,
        request: &DesignRequest,
        progress: &dyn Progress,
    ) -> Result<Option<(DesignRequest, Self)>> {
        let closest = self
            .outcome
            .closest
            .as_ref()
            .filter(|_| request.count.is_none());
        let share = self
            .policy
            .with_models(|models| closest?.largest_share(&self.spec, models, progress));
        let counts = share
            .into_iter()
            .flat_map(|share| COUNTS.map(|multiple| (multiple / share).ceil()));
        for count in counts.take_while(|count| *count <= f64::from(mckibben_design::bundle::MOST)) {
            let several = DesignRequest {
                count: Some(count as u32),
                ..request.clone()
            };
            let bundle = Self::run(&several, &CancelOnly(progress))?;
            if !bundle.outcome.candidates.is_empty() {
                return Ok(Some((several, bundle)));
            }
        }
        Ok(None)
    }
}

/// The ± of the winner in words, at the point where it is largest.
fn words(spec: &Spec, build: &Build<'_>, winner: Option<&Candidate>) -> Option<UncertaintyWords> {
    let winner = winner?;
    let half = |q: &CandidatePoint| q.uncertainty_n.unwrap_or(0.0);
    let response = winner
        .points
        .iter()
        .max_by(|a, b| half(a).total_cmp(&half(b)))?
        .response;
    let (model, workspace) = (build(&winner.muscle).ok()?, &mut Workspace::new());
    let mut model = Evaluation::new(&*model, workspace, spec.options());
    let parts = model.uncertainty(
        response.pressure_mpa,
        response.contraction,
        response.force_n,
    );
    Some(UncertaintyWords::at(
        parts,
        &mut model,
        response.pressure_mpa,
    ))
}

fn draw(spec: &Spec, build: &Build<'_>, outcome: &Outcome, unit: &Units) -> Result<Figure> {
    let options = spec.options();
    let drawn = outcome.candidates.iter().take(DRAWN);
    let drawn: Vec<(&Candidate, Box<dyn ForceModel>)> = drawn
        .map(|c| Ok((c, build(&c.muscle)?)))
        .collect::<Result<_, ModelError>>()?;
    let points = outcome
        .candidates
        .first()
        .map(|c| c.points.iter().map(|q| q.wanted).collect());
    let points: Vec<OperatingPoint> = points.unwrap_or_default();
    Ok(figure::design(&drawn, &points, options, unit))
}

/// Which model looks at a muscle of the search, and which one decides.
#[derive(Debug, Clone)]
pub(super) struct ModelPolicy {
    /// Where none was named: what searches the muscles that it is good for.
    pub(super) quick: Option<(Model, SearchedMuscles)>,
    /// What searches all others, and decides.
    pub(super) model: Model,
}

/// Muscles that `universal` searches: L0/D0 at least, θ0 in degrees, wall over D0 at most. Its box
/// is narrower; it only ranks what `fe` then decides of and corrects by up to a quarter of the
/// diameter. On random muscles 95 % of its pulls are within 1.4 % of the blocked force of those of
/// `fe` where L0/D0 is 3 to 5, 5.4 % where it is 2 to 3, 12.6 % where it is 1.5 to 2, 1.2 % where
/// θ0 is 14° to 18°, 0.04 % where it is 35° to 42°, 1.1 % where it is 42° to 48°.
const LEAST_SLENDERNESS: f64 = 1.5;
const ANGLES: std::ops::RangeInclusive<f64> = 14.0..=48.0;
/// Largest wall over D0 that `universal` searches. Beyond, of nearly solid rods, its pull rises and
/// falls with the pressure, and each inverse searches the whole range.
const THICKEST: f64 = 0.38;

/// Whether a muscle is searched with `universal`.
pub(super) fn near_the_box(muscle: &Muscle) -> bool {
    muscle.length_mm() >= LEAST_SLENDERNESS * muscle.outer_diameter_mm()
        && ANGLES.contains(&muscle.braid().angle_deg)
        && muscle.wall_mm() <= THICKEST * muscle.outer_diameter_mm()
}

impl ModelPolicy {
    /// Does something with the models of a search.
    fn with_models<T>(&self, work: impl FnOnce(Models<'_>) -> T) -> T {
        let (look, decide) = (|m: &Muscle| self.look(m), |m: &Muscle| self.model.bound(m));
        let settle = self
            .quick
            .as_ref()
            .map(|quick| (&decide as &Build<'_>, quick.1));
        work(Models {
            search: &look,
            settle,
        })
    }

    /// Name of the model that searches.
    pub(super) fn searches(&self) -> &str {
        self.quick
            .as_ref()
            .map_or(&self.model, |quick| &quick.0)
            .name()
    }

    /// The model that searches, bound to a muscle.
    pub(super) fn look(&self, muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
        match &self.quick {
            Some((quick, is_good)) if is_good(muscle) => quick.build(muscle),
            _ => self.model.bound(muscle),
        }
    }
}
