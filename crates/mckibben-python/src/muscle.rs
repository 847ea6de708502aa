//! A muscle: its file, its measures, and its models.

use crate::{error::Wrong, model::Model, request, run, value};
use mckibben::muscle::Muscle as Held;
use mckibben::muscle::measures::{STIFFNESS, fields};
use mckibben::{muscle::file::to_toml, rubber::RubberLaw};
use mckibben_app::{
    AskFields, BoundModel, ModelFields, MuscleFields, Problem, ProblemKind, Result, TextFile,
    muscle_of, understood, with_parameters,
};
use mckibben_fit::identify::Target;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
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

/// The muscle of fields, with the rubber of a table `tube.material`.
fn described(request: &Value, rubber: Option<&str>) -> Result<Held> {
    let fields: MuscleFields = understood(request)?;
    let base = match &fields.named.muscle {
        Some(file) => muscle_of(file)?,
        None => Held::prototype(),
    };
    let Some(text) = rubber else {
        return fields.over(&base);
    };
    let mut made = base.parts().clone();
    let own = TextFile {
        name: String::new(),
        text: text.to_owned(),
    };
    let wrong = |e: Problem| {
        let message = e
            .message
            .trim_start_matches([':', '0', '1', '2', '3', '4', '5', '6', '7', '8', '9']);
        Problem::new(ProblemKind::Rubber, message.trim_start(), e.hint.clone()).in_field("rubber")
    };
    made.tube.rubber = muscle_of(&own).map_err(wrong)?.parts().tube.rubber.clone();
    fields.over(&Held::from_parts(made)?.with_bench_of(&base))
}

/// With the field to blame: the first one of the request that the message names by itself or by its
/// key in a muscle file.
fn blamed(problem: Problem, request: &Value) -> Problem {
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
                    .filter(|_| request.get(field).is_some())
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
    /// The muscle that a muscle file and fields describe; with a rubber, the table `tube.material`
    /// of one.
    #[new]
    #[pyo3(signature = (request: "dict[str, typing.Any]", rubber: "str | None" = None))]
    fn new(py: Python<'_>, request: &Bound<'_, PyAny>, rubber: Option<String>) -> PyResult<Self> {
        let request = request::given(py, "check", request)?;
        Ok(run::quick(py, |_| {
            described(&request, rubber.as_deref())
                .map(Self::from)
                .map_err(|problem| Wrong::from(blamed(problem, &request)))
        })?)
    }

    /// The fields by which a muscle is given, of this one; those that it does not have are left
    /// out.
    #[pyo3(signature = () -> "dict[str, typing.Any]")]
    fn fields<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        value::answer(py, &json!(MuscleFields::from_muscle(&self.held)))
    }

    /// Constants and measures by which a model has derivatives, with their values.
    fn parameters(&self) -> Vec<(String, f64)> {
        let unknown = [
            Target::ContractionOffset,
            Target::DeadVolume,
            Target::StiffnessExponent,
            Target::Modulus,
        ];
        let all = Target::all(&self.held)
            .into_iter()
            .filter(|target| !unknown.contains(target));
        all.filter_map(|t| Some((t.name(&self.held), t.value(&self.held)?)))
            .collect()
    }

    /// The same with other values of constants and measures, all others held.
    #[pyo3(signature = (values: "dict[str, float]"))]
    fn changed(&self, values: &Bound<'_, PyDict>) -> PyResult<Self> {
        let values = values
            .iter()
            .map(|(name, value)| Ok((name.extract()?, value.extract()?)));
        let values: Vec<(String, f64)> = values.collect::<PyResult<_>>()?;
        Ok(with_parameters(&self.held, &values)
            .map(Self::from)
            .map_err(Wrong::from)?)
    }

    /// Nominal stress in MPa of the rubber at stretches: `uniaxial`, `planar` or `equibiaxial`,
    /// with plane stress and constant volume.
    fn stress(&self, mode: &str, stretches: Vec<f64>) -> PyResult<Vec<f64>> {
        let law = &self.held.tube().rubber.law;
        if let Some(wrong) = stretches.iter().find(|s| !(**s > 0.0 && s.is_finite())) {
            let message =
                format!("a stretch of {wrong}: it is the length over that at rest, above 0");
            let problem = Problem::new(ProblemKind::Quantity, message, "").in_field("stretch");
            return Err(Wrong::from(problem).into());
        }
        let stress: fn(&_, f64) -> f64 = match mode {
            "uniaxial" => RubberLaw::uniaxial_stress_mpa,
            "planar" => RubberLaw::planar_stress_mpa,
            "equibiaxial" => RubberLaw::equibiaxial_stress_mpa,
            _ => return Err(PyValueError::new_err("uniaxial, planar or equibiaxial")),
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
        Ok(run::quick(py, |_| {
            let (model, asking): (ModelFields, AskFields) =
                (understood(&request)?, understood(&request)?);
            Ok(Model {
                bound: BoundModel::new(&self.held, &model, asking)?,
            })
        })?)
    }
}
