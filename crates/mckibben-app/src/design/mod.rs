//! `design`: from a specification to ranked muscles.

mod answer;
mod assumed;
mod cycle;
mod decision;
mod page;
mod remedies;
mod request;
mod spec;

pub use answer::{
    CandidateAnswer, CandidateJoint, ChoiceAnswer, ClosestAnswer, DemandAnswer, DesignAnswer,
    RejectedAnswer, SearchedAnswer,
};
pub use mckibben_design::Bundle;
pub use request::{DesignRequest, ObjectiveWord, OperatingPoint, TorqueWanted};

use crate::{Result, UncertaintyWords, Units, figure};
use answer::{muscle_file, not_checked, touches};
use decision::Decision;
use mckibben_build::{EndParts, Wishes};
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
    Build, Candidate, CandidatePoint, Demand, Ends, Outcome, Precision, Spec, design_with,
};
use mckibben_report::Figure;
use remedies::RelaxationAnswer;
use spec::Search;

/// Curves are drawn of so many candidates.
const DRAWN: usize = 3;

/// Ranked muscles that fit, the reasons why others do not, and, where nothing fits, what would have
/// to give.
pub fn design(request: &DesignRequest, progress: &dyn Progress) -> Result<DesignAnswer> {
    let search = request.search()?;
    let Search { spec, policy, .. } = &search;
    // A mesh that one muscle has no room for is no reason against each of them.
    policy.model.bound(&spec.base)?;
    let found = policy.with_models(|models| design_with(spec, models, progress))?;
    let mut answer = answered(&search, &found)?;
    answer.load = match &spec.wanted {
        Demand::Load {
            load: Load::Force { force_n },
            ..
        } => Some(format!("force:{force_n}N")),
        _ => request.load.load.clone(),
    };
    if let Some(winner) = found.candidates.first() {
        answer.cycle = request.cycle_of(winner, spec, progress)?;
        answer
            .decision
            .extend(answer.cycle.as_ref().map(|cycle| cycle.line()));
    }
    if let (Some(unit), false) = (&request.figure, answer.candidates.is_empty()) {
        let decide = |m: &Muscle| policy.model.bound(m);
        answer.figure = Some(draw(
            (spec, request.model.name.is_some()),
            &decide,
            &found,
            unit,
        )?);
    }
    Ok(answer)
}

fn answered(search: &Search, found: &Outcome) -> Result<DesignAnswer> {
    let Search {
        spec,
        policy,
        stated,
    } = search;
    let candidates = found.candidates.iter();
    let choices = found.choices.iter();
    let decide = |m: &Muscle| policy.model.bound(m);
    let uncertainty_words = words(spec, &decide, found.candidates.first());
    let decision = Decision {
        spec,
        found,
        words: uncertainty_words.as_ref(),
        length_by: stated.length_by,
    };
    let closest = found
        .rejected
        .first()
        .filter(|_| found.candidates.is_empty());
    let remedy = |change| RelaxationAnswer::new(change, search);
    Ok(DesignAnswer {
        decision: decision.lines(),
        model: policy.model.name().into(),
        searched_with: policy.searches().into(),
        max_pressure_mpa: spec.max_pressure_mpa,
        wanted: DemandAnswer::new(&spec.wanted),
        searched: SearchedAnswer::new(spec),
        liquid: spec.liquid.as_ref().map(|supply| supply.liquid.clone()),
        load: None,
        assumptions: stated.assumptions(spec, found),
        looked_at: found.looked_at.0,
        fitting: found.looked_at.1,
        candidates: candidates
            .clone()
            .map(|c| CandidateAnswer::new(c, spec))
            .collect(),
        choices: choices.map(|c| ChoiceAnswer::new(c, spec)).collect(),
        rejected: found.rejected.iter().map(RejectedAnswer::from).collect(),
        warnings: warnings(spec, found)?,
        closest: closest.map(|rejected| ClosestAnswer {
            rejected: rejected.into(),
            relaxations: found.relaxations.iter().map(remedy).collect(),
        }),
        cycle: None,
        bundle: found.bundle.clone(),
        figure: None,
        muscle_files: candidates
            .enumerate()
            .map(|(i, c)| muscle_file(i, c, spec))
            .collect(),
        uncertainty_words,
    })
}

/// What the user should know of the best muscle and of its bundle.
fn warnings(spec: &Spec, found: &Outcome) -> Result<Vec<Warning>> {
    let Some(winner) = found.candidates.first() else {
        return Ok(not_checked(found, spec.max_pressure_mpa));
    };
    let mut warnings = answer::warnings(winner);
    // Where no pitch is given they touch just where they are required to pull.
    let bundle = found.bundle.as_ref().filter(|_| spec.pitch_mm.is_some());
    warnings.extend(bundle.and_then(|bundle| touches(bundle, winner)));
    warnings.extend(Warning::not_measured(
        &winner.muscle,
        winner.highest_pressure_mpa,
    ));
    Ok(warnings)
}

/// The ± of the winner in words, at the point where it is largest.
fn words(spec: &Spec, build: &Build<'_>, winner: Option<&Candidate>) -> Option<UncertaintyWords> {
    let winner = winner?;
    let half = |q: &CandidatePoint| q.uncertainty_n.unwrap_or_default();
    let response = &winner.points.iter().max_by_number(|q| half(q))?.response;
    let model = build(&winner.muscle).ok()?;
    let workspace = &mut Workspace::new();
    let mut model = Evaluation::new(&*model, workspace, spec.options());
    let place = (response.pressure_mpa, response.contraction);
    Some(UncertaintyWords::at(
        model.predicted(place.0, place.1, response.force_n),
        place,
        &mut model,
    ))
}

fn draw(
    (spec, is_model_named): (&Spec, bool),
    build: &Build<'_>,
    found: &Outcome,
    unit: &Units,
) -> Result<Figure> {
    let options = (spec.options(), is_model_named);
    let drawn = found.candidates.iter().take(DRAWN);
    let drawn: Vec<(&Candidate, Box<dyn ForceModel>)> = drawn
        .map(|c| Ok((c, build(&c.muscle)?)))
        .collect::<Result<_, ModelError>>()?;
    let points: Vec<OperatingPoint> = found
        .candidates
        .first()
        .map(|c| c.points.iter().map(|q| q.wanted).collect())
        .unwrap_or_default();
    Ok(figure::design(&drawn, &points, options, unit))
}

/// The ends of a muscle as `build` makes them.
pub fn design_ends(muscle: &Muscle, loads_n: [f64; 2], precision: Precision) -> Option<Ends> {
    let parts = EndParts::new(muscle, loads_n, &Wishes::default()).ok()?;
    Some(Ends {
        made: parts.ends.made,
        load_n: loads_n[0],
        width_mm: parts.widest_mm(),
        mass_g: match precision {
            Precision::Rough => 0.0,
            Precision::Exact => parts.air_plug.mass_g() + parts.eye_plug.mass_g(),
        },
    })
}
