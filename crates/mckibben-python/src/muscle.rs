//! A muscle: its file, its measures, and its models.

use crate::{error::Wrong, model::Model, request, run, value};
use mckibben_app::{
    BoundModel, MuscleFields, Problem, ProblemKind, QuestionFields, understood, with_parameters,
};
use mckibben_core::{
    muscle::{
        Muscle as Held,
        file::to_toml,
        measures::{STIFFNESS, fields},
    },
    rubber::RubberLaw,
};
use mckibben_fit::identify::Target;
use pyo3::prelude::*;
use serde_json::{Value, json};

/// A muscle.
#[pyclass(frozen, module = "mckibben._native")]
pub struct Muscle {
    held: Held,
    /// The text of its file.
    #[pyo3(get)]
    text: String,
}

impl From<Held> for Muscle {
    fn from(held: Held) -> Self {
        Self {
            text: to_toml(&held),
            held,
        }
    }
}

/// With the field to blame: the first one of the muscle that the message names by itself or by its
/// key in a muscle file.
fn blamed(problem: Problem, muscle: &Value) -> Problem {
    let named = match problem.kind {
        ProblemKind::Rubber => Some("rubber"),
        ProblemKind::Braid => Some("braid"),
        _ => {
            let keys = fields().map(|(field, measure)| (field, measure.key));
            let place = |(field, key): (&'static str, &str)| {
                let place = problem
                    .message
                    .find(key)
                    .or_else(|| problem.message.find(&format!("`{field}`")));
                place
                    .filter(|_| muscle.get(field).is_some())
                    .map(|place| (place, field))
            };
            keys.chain([("stiffness", STIFFNESS.key)])
                .filter_map(place)
                .min()
                .map(|(_, field)| field)
        }
    };
    match (&problem.field, named) {
        (None, Some(field)) => problem.in_field(field),
        _ => problem,
    }
}

#[pymethods]
impl Muscle {
    /// The muscle of a request.
    #[new]
    #[pyo3(signature = (request: "dict[str, typing.Any]"))]
    fn new(py: Python<'_>, request: &Bound<'_, PyAny>) -> PyResult<Self> {
        let request = request::given(py, "check", request)?;
        run::quick(py, |_| {
            let question: QuestionFields = understood(&request)?;
            Ok(question
                .muscle
                .resolve()
                .map_err(|problem| blamed(problem, &request["muscle"]))?
                .into())
        })
    }

    /// The fields by which a muscle is given, of this one; those that it does not have are left
    /// out.
    #[pyo3(signature = () -> "dict[str, typing.Any]")]
    fn fields<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        value::answer(py, &json!(MuscleFields::from_muscle(&self.held)))
    }

    /// Constants and measures by which a model has derivatives, with their values.
    fn parameters(&self) -> Vec<(String, f64)> {
        Target::all(&self.held)
            .into_iter()
            .filter(|target| *target != Target::Modulus)
            .filter_map(|t| Some((t.name(&self.held), t.value(&self.held)?)))
            .collect()
    }

    /// The same with other values of constants and measures, all others held.
    fn changed(&self, values: Vec<(String, f64)>) -> PyResult<Self> {
        Ok(with_parameters(&self.held, &values)
            .map(Self::from)
            .map_err(Wrong::from)?)
    }

    /// Nominal stress in MPa of the rubber at stretches: `uniaxial`, `planar` or `equibiaxial`,
    /// with plane stress and constant volume.
    fn stress(&self, mode: &str, stretches: Vec<f64>) -> PyResult<Vec<f64>> {
        let law = &self.held.tube().rubber.law;
        let wrong = |field: &str, message: String| {
            Err(
                Wrong::from(Problem::new(ProblemKind::Quantity, message, "").in_field(field))
                    .into(),
            )
        };
        if let Some(none) = stretches.iter().find(|s| !(**s > 0.0 && s.is_finite())) {
            return wrong(
                "stretch",
                format!("a stretch of {none}: it is the length over that at rest, above 0"),
            );
        }
        let stress: fn(&_, f64) -> f64 = match mode {
            "uniaxial" => RubberLaw::uniaxial_stress_mpa,
            "planar" => RubberLaw::planar_stress_mpa,
            "equibiaxial" => RubberLaw::equibiaxial_stress_mpa,
            _ => return wrong("mode", "uniaxial, planar or equibiaxial".into()),
        };
        Ok(stretches
            .iter()
            .map(|stretch| stress(law, *stretch))
            .collect())
    }

    /// The model that a request names, of this muscle.
    #[pyo3(signature = (request: "dict[str, typing.Any]"))]
    fn model(&self, py: Python<'_>, request: &Bound<'_, PyAny>) -> PyResult<Model> {
        let request = request::given(py, "force", request)?;
        run::quick(py, |_| {
            let question: QuestionFields = understood(&request)?;
            Ok(Model {
                bound: BoundModel::new(&self.held, question.model.choose()?, question.asking)?,
            })
        })
    }
}
