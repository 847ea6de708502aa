//! `design`: from a specification to ranked muscles.

mod answer;
mod assumed;
mod cycle;
mod decision;
mod page;
mod policy;
mod remedies;
mod request;
mod spec;

pub use answer::{
    CandidateAnswer, CandidateJoint, ClosestAnswer, DemandAnswer, DesignAnswer, RejectedAnswer,
    SearchedAnswer,
};
pub use mckibben_design::{Bought, Bundle, BundlePoint};
pub use request::{DesignRequest, ObjectiveWord, OperatingPoint, TorqueWanted};

use crate::{Model, Result, UncertaintyWords, Units, figure};
use answer::{muscle_file, not_checked, out_of_reach, touches};
use decision::Decision;
use mckibben_core::{
    analysis::Evaluation,
    by_number::ByNumber,
    load::Load,
    model::{ForceModel, ModelError, Workspace},
    muscle::Muscle,
    progress::Progress,
    warning::Warning,
};
use mckibben_design::{
    Build, Candidate, CandidatePoint, Demand, Design, Outcome, Several, Spec,
    bought::{Product, bought},
};
use mckibben_fit::library::{PREFIX, library};
use mckibben_report::Figure;
use remedies::RelaxationAnswer;
use spec::Search;

/// Curves are drawn of so many candidates.
const DRAWN: usize = 3;

/// Ranked muscles that fit, the reasons why others do not, and, where nothing fits, what would have
/// to give.
pub fn design(request: &DesignRequest, progress: &dyn Progress) -> Result<DesignAnswer> {
    let search = request.search()?;
    let Search { task, policy, .. } = &search;
    // A mesh that one muscle has no room for is no reason against each of them.
    policy.model.bound(&task.spec.base)?;
    let found = policy.with_models(|models| task.solve(models, progress))?;
    let mut answer = answered(&search, &found)?;
    answer.load = match &found.spec.wanted {
        Demand::Load {
            load: Load::Force { force_n },
            ..
        } => Some(format!("force:{force_n}N")),
        _ => request.load.load.clone(),
    };
    if let Some(winner) = found.outcome.candidates.first() {
        answer.cycle = request.cycle_of(winner, &found.spec, progress)?;
        answer
            .decision
            .extend(answer.cycle.as_ref().map(|cycle| cycle.line()));
    }
    if let (Some(unit), false) = (&request.figure, answer.candidates.is_empty()) {
        let decide = |m: &Muscle| policy.model.bound(m);
        answer.figure = Some(draw(&found.spec, &decide, &found.outcome, unit)?);
    }
    Ok(answer)
}

fn answered(search: &Search, found: &Design) -> Result<DesignAnswer> {
    let Search { policy, stated, .. } = search;
    let Design { spec, outcome, .. } = found;
    let candidates = outcome.candidates.iter();
    let several = |several: &Option<Several>| {
        let several = several.as_ref()?;
        Some(CandidateAnswer::new(
            &several.candidate,
            spec,
            several.count,
        ))
    };
    let decide = |m: &Muscle| policy.model.bound(m);
    let uncertainty_words = words(spec, &decide, outcome.candidates.first());
    let decision = Decision {
        found,
        measure: uncertainty_words
            .as_ref()
            .and_then(|words| words.bench.clone()),
        length_by: stated.length_by,
    };
    Ok(DesignAnswer {
        decision: decision.lines(),
        model: policy.model.name().into(),
        searched_with: policy.searches().into(),
        max_pressure_mpa: spec.max_pressure_mpa,
        wanted: DemandAnswer::new(&spec.wanted),
        searched: SearchedAnswer::new(spec),
        liquid: spec.liquid.as_ref().map(|supply| supply.liquid.clone()),
        load: None,
        assumptions: stated.assumptions(found),
        looked_at: outcome.looked_at.0,
        fitting: outcome.looked_at.1,
        candidates: candidates
            .clone()
            .map(|c| CandidateAnswer::new(c, spec, spec.count))
            .collect(),
        choices: decision.choices(),
        other_make: outcome
            .other_make
            .as_ref()
            .map(|c| CandidateAnswer::new(c, spec, spec.count)),
        slimmest_bundle: several(&found.slimmest_bundle),
        uncertainty_words,
        rejected: outcome.rejected.iter().map(RejectedAnswer::from).collect(),
        warnings: warnings(found)?,
        closest: outcome.closest.as_ref().map(|closest| ClosestAnswer {
            rejected: (&closest.rejected).into(),
            relaxations: found
                .relaxations
                .iter()
                .map(|change| RelaxationAnswer::new(change, found, stated))
                .collect(),
            hint: out_of_reach(spec),
        }),
        cycle: None,
        to_be_sure: several(&found.to_be_sure),
        bundle: found.bundle.clone(),
        bought: as_sold(spec, stated.is_cut),
        figure: None,
        muscle_files: candidates
            .enumerate()
            .map(|(i, c)| muscle_file(i, c, spec))
            .collect(),
    })
}

/// What the user should know of the best muscle and of its bundle.
fn warnings(found: &Design) -> Result<Vec<Warning>> {
    let Design { spec, outcome, .. } = found;
    let Some(winner) = outcome.candidates.first() else {
        return Ok(not_checked(outcome, spec.max_pressure_mpa));
    };
    let mut warnings = answer::warnings(winner);
    // Where no pitch is given they touch just where they are required to pull.
    let bundle = found.bundle.as_ref().filter(|_| spec.pitch_mm.is_some());
    warnings.extend(bundle.and_then(touches));
    let highest_mpa = winner.highest_pressure_mpa;
    warnings.extend(Warning::not_measured(&winner.muscle, highest_mpa));
    Ok(warnings)
}

/// The muscles of the library that have a product and would do, by finite elements.
fn as_sold(spec: &Spec, is_cut: bool) -> Vec<Bought> {
    let products = library().into_iter().filter_map(|(of, muscle)| {
        Some(Product {
            name: format!("{PREFIX}{}", of.facts.name),
            product: of.facts.product.as_deref()?,
            muscle,
        })
    });
    bought(spec, is_cut, &|m| Model::FE.build(m), products)
}

/// The ± of the winner in words, at the point where it is largest.
fn words(spec: &Spec, build: &Build<'_>, winner: Option<&Candidate>) -> Option<UncertaintyWords> {
    let winner = winner?;
    let half = |q: &CandidatePoint| q.uncertainty_n.unwrap_or(0.0);
    let CandidatePoint {
        response,
        model_force_n,
        ..
    } = winner.points.iter().max_by_number(|q| half(q))?;
    let model = build(&winner.muscle).ok()?;
    let workspace = &mut Workspace::new();
    let mut model = Evaluation::new(&*model, workspace, spec.options());
    let place = (response.pressure_mpa, response.contraction);
    let predicted = model.predicted(place.0, place.1, *model_force_n);
    Some(UncertaintyWords::at(predicted, place, &mut model))
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
