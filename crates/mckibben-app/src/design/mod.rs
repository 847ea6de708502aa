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
    CandidateAnswer, CandidateJoint, ChoiceAnswer, ClosestAnswer, DesignAnswer, RejectedAnswer,
    SearchedAnswer,
};
pub use mckibben_design::Bundle;
pub use request::{DesignRequest, ObjectiveWord, OperatingPoint, TorqueWanted};

use crate::{Result, UncertaintyWords, Units, figure};
use answer::{muscle_file, not_checked};
use mckibben_build::{EndParts, Wishes};
use mckibben_core::{
    analysis::Evaluation, by_number::ByNumber, load::Load, model::Workspace, muscle::Muscle,
    progress::Progress, units::Dimension,
};
use mckibben_design::{Candidate, CandidatePoint, Ends, Outcome, Precision, design_with};
use mckibben_report::Figure;
use remedies::RelaxationAnswer;
use spec::Search;

/// A quantity in the units of requests.
fn plain(kind: Dimension, value: f64) -> String {
    Units::default().show(kind, value)
}

/// Curves are drawn of so many candidates.
const DRAWN: usize = 3;

/// Ranked muscles that fit, the reasons why others do not, and, where nothing fits, what would have
/// to give.
pub fn design(request: &DesignRequest, progress: &dyn Progress) -> Result<DesignAnswer> {
    let search = request.search()?;
    let Search { spec, policy, .. } = &search;
    // A mesh that one muscle has no room for is no reason against each of them.
    policy.model.build(&spec.base)?;
    let found = policy.with_models(|models| design_with(spec, models, progress))?;
    let mut answer = search.answered(&found)?;
    if let Some(winner) = found.candidates.first() {
        answer.cycle = request.cycle_of(winner, spec, progress)?;
        let cycle = answer.cycle.as_ref();
        answer.decision.extend(cycle.map(|cycle| cycle.line()));
        let figure = request.figure.as_ref();
        answer.figure = figure.map(|unit| search.draw(&found, unit)).transpose()?;
    }
    Ok(answer)
}

impl Search<'_> {
    fn answered(&self, found: &Outcome) -> Result<DesignAnswer> {
        let Self {
            request,
            spec,
            policy,
        } = self;
        let first = found.candidates.first();
        let words = first.and_then(|winner| self.words(winner));
        let closest = found.rejected.first().filter(|_| first.is_none());
        let remedy = |change| RelaxationAnswer::new(change, self);
        Ok(DesignAnswer {
            decision: self.decision(found, words.as_ref()),
            model: policy.model.name().into(),
            searched_with: policy.searches().into(),
            max_pressure_mpa: spec.max_pressure_mpa,
            wanted: spec.wanted.clone(),
            searched: SearchedAnswer::new(spec),
            liquid: spec.liquid.as_ref().map(|supply| supply.liquid.clone()),
            load: match spec.wanted.load() {
                Some(Load::Force { force_n }) => Some(format!("force:{force_n}N")),
                _ => request.load.load.clone(),
            },
            assumptions: self.assumptions(found),
            looked_at: found.looked_at.0,
            fitting: found.looked_at.1,
            candidates: found
                .candidates
                .iter()
                .map(|c| CandidateAnswer::new(c, spec))
                .collect(),
            choices: found
                .choices
                .iter()
                .map(|c| ChoiceAnswer::new(c, spec))
                .collect(),
            rejected: found.rejected.iter().map(RejectedAnswer::from).collect(),
            warnings: match first {
                Some(winner) => answer::warnings(winner, found.bundle.as_ref(), spec),
                None => not_checked(found, spec.max_pressure_mpa),
            },
            closest: closest.map(|rejected| ClosestAnswer {
                rejected: rejected.into(),
                relaxations: found.relaxations.iter().map(remedy).collect(),
            }),
            cycle: None,
            bundle: found.bundle.clone(),
            figure: None,
            muscle_files: found
                .candidates
                .iter()
                .enumerate()
                .map(|(i, c)| muscle_file(i, c, spec))
                .collect(),
            uncertainty_words: words,
        })
    }

    /// The ± of the winner in words, at the point where it is largest.
    fn words(&self, winner: &Candidate) -> Option<UncertaintyWords> {
        let half = |q: &CandidatePoint| q.uncertainty_n.unwrap_or_default();
        let response = &winner.points.iter().max_by_number(|q| half(q))?.response;
        let model = self.policy.model.build(&winner.muscle).ok()?;
        let workspace = &mut Workspace::new();
        let mut model = Evaluation::new(&*model, workspace, self.spec.options());
        let place = (response.pressure_mpa, response.contraction);
        let predicted = model.predicted(place.0, place.1, response.force_n);
        Some(UncertaintyWords::at(predicted, place, &mut model))
    }

    /// Curves of the best muscles, and the points of the first.
    fn draw(&self, found: &Outcome, unit: &Units) -> Result<Figure> {
        let options = (self.spec.options(), self.request.model.name.is_some());
        let mut drawn = vec![];
        for c in found.candidates.iter().take(DRAWN) {
            drawn.push((c, self.policy.model.build(&c.muscle)?));
        }
        let first = drawn.iter().take(1).flat_map(|(c, _)| &c.points);
        let point = |q: &CandidatePoint| OperatingPoint {
            force_n: q.required_n,
            contraction: q.response.contraction,
        };
        let points = Vec::from_iter(first.map(point));
        Ok(figure::design(&drawn, &points, options, unit))
    }
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
