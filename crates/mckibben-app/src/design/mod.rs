//! `design`: from a specification to ranked muscles.

mod answer;
mod request;

pub use answer::{
    CandidateAnswer, ClosestAnswer, DesignAnswer, DesignPoint, RejectedAnswer, RelaxationAnswer,
    SpreadAnswer, Verified, VerifiedPoint,
};
pub use request::{Choice, DesignRequest, ObjectiveWord, ToleranceFields, Verify, Wanted};

use crate::figure;
use crate::model::Model;
use crate::problem::Problem;
use mckibben::analysis::pressure_at;
use mckibben::answer::Options;
use mckibben::design::{Candidate, Outcome, Spec, Spread, design_with, spread};
use mckibben::model::{ForceModel, ModelError, Workspace};
use mckibben::muscle::Muscle;
use mckibben::progress::Progress;
use request::{Search, Searching};

/// Curves are drawn of so many candidates.
const DRAWN: usize = 3;

/// Ranked muscles that fit, the reasons why others do not, and, where nothing fits, what would have to give.
///
/// # Errors
/// [`Problem`] for a specification that cannot be searched; that nothing fits is an answer.
pub fn design(request: &DesignRequest, progress: &dyn Progress) -> Result<DesignAnswer, Problem> {
    let Search { spec, model } = request.search()?;
    let build = |m: &Muscle| model.build(m);
    let outcome = design_with(&spec, &build, progress)?;
    let spreads = spreads(request, &build, &outcome)?;
    let winner = outcome.candidates.first();
    let verified = match (request.verify, winner) {
        (Verify::Fe, Some(winner)) if winner.model != Model::FE.name() => verified(&spec, winner)?,
        _ => vec![],
    };
    let figure = match request.figure {
        Some(unit) if winner.is_some() => Some(draw(&spec, &model, &outcome, unit)?),
        _ => None,
    };
    Ok(DesignAnswer::new(spec, model.name(), outcome, &spreads, verified, figure))
}

fn spreads(
    request: &DesignRequest,
    build: &mckibben::design::Build<'_>,
    outcome: &Outcome,
) -> Result<Vec<Spread>, Problem> {
    let Some(tolerances) = request.tolerances()? else { return Ok(vec![]) };
    let Some(winner) = outcome.candidates.first() else { return Ok(vec![]) };
    let one = |q: &mckibben::design::CandidatePoint| {
        spread(&winner.muscle, build, q.wanted, q.pressure_mpa, tolerances)
    };
    Ok(winner.points.iter().map(one).collect::<Result<Vec<_>, _>>()?)
}

/// What finite elements say of the winner.
fn verified(spec: &Spec, winner: &Candidate) -> Result<Vec<VerifiedPoint>, Problem> {
    let fe = Model::FE.build(&winner.muscle)?;
    let mut workspace = Workspace::new();
    let mut out = vec![];
    for point in &spec.points {
        let available = fe.force_n(&mut workspace, spec.max_pressure_mpa, point.contraction);
        let pressure =
            pressure_at(&*fe, &mut workspace, point.force_n, point.contraction, Options::extrapolating());
        out.push(VerifiedPoint {
            force_n: point.force_n,
            contraction: point.contraction,
            pressure_mpa: pressure.ok(),
            force_at_max_pressure_n: available.as_ref().ok().copied(),
            cause: available.err().map(|e| e.to_string()),
        });
    }
    Ok(out)
}

fn draw(
    spec: &Spec,
    model: &Searching,
    outcome: &Outcome,
    unit: crate::words::PressureUnit,
) -> Result<mckibben_report::Figure, Problem> {
    let options = Options { extrapolate: spec.extrapolate, ..Options::default() };
    let drawn = outcome.candidates.iter().take(DRAWN);
    let drawn: Vec<(&Candidate, Box<dyn ForceModel>)> =
        drawn.map(|c| Ok((c, model.build(&c.muscle)?))).collect::<Result<_, ModelError>>()?;
    Ok(figure::design(&drawn, &spec.points, spec.max_pressure_mpa, options, unit))
}
