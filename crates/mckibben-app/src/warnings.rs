//! Warnings of a whole answer: each once, not once for each point.

use mckibben_core::{
    analysis::{Burst, Evaluation},
    answer::Answer,
    model::Response,
    muscle::Muscle,
    warning::{Warning, of_response},
};

/// What points of a muscle warn of: each sentence once, of each kind the gravest.
pub fn of_points<'a>(answers: impl Iterator<Item = &'a Answer>) -> Vec<Warning> {
    Warning::gravest(answers.flat_map(|a| &a.warnings))
}

/// What holds of a muscle at a pressure in MPa, whatever it pulls: its burst, and where nobody has
/// measured.
pub fn of_muscle(burst: &Burst, muscle: &Muscle, p: f64) -> impl Iterator<Item = Warning> {
    burst
        .warnings(p)
        .into_iter()
        .chain(Warning::not_measured(muscle, p))
}

/// The same of responses of one muscle.
pub fn of_responses<'a>(
    muscle: &Muscle,
    responses: impl Iterator<Item = &'a Response>,
) -> Vec<Warning> {
    let all = Vec::from_iter(
        muscle
            .warnings()
            .into_iter()
            .map(Warning::from)
            .chain(responses.flat_map(|r| of_response(muscle, r))),
    );
    Warning::gravest(&all)
}

/// The largest stretch of a model's rubber at points of pressure in MPa and contraction: at each
/// pressure that of the largest contraction that is not slack, since contraction stretches the
/// wall. `None` where the rubber's data have no end.
pub fn largest_stretch(evaluation: &mut Evaluation<'_>, points: &[(f64, f64)]) -> Option<f64> {
    evaluation.model.muscle().tube().rubber.fitted_to_stretch?;
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.total_cmp(&a.1)));
    let mut stretch = |&(p, e): &(f64, f64)| evaluation.point(p, e).ok()?.response.rubber_stretch();
    sorted
        .chunk_by(|a, b| a.0 == b.0)
        .filter_map(|same| same.iter().find_map(&mut stretch))
        .reduce(f64::max)
}
