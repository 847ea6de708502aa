//! Muscles as the text of their file: what a muscle of Python holds, and by which it is compared, hashed and pickled.

use crate::{error::Wrong, run, value};
use mckibben::{muscle::Muscle, muscle::file::to_toml, rubber::RubberLaw};
use mckibben_app::{MuscleFields, Problem, ProblemKind, TextFile, muscle_of, understood, with_parameters};
use mckibben_fit::identify::Target;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The muscle that a muscle file and fields describe, as the text of a muscle file; with a rubber, the table `tube.material` of one.
#[pyfunction]
#[pyo3(signature = (request: "dict[str, typing.Any]", rubber = None))]
pub fn muscle_text(py: Python<'_>, request: &Bound<'_, PyAny>, rubber: Option<String>) -> PyResult<String> {
    let request = value::request(request)?;
    Ok(run::quick(py, |_| {
        let request: MuscleFields = understood(&request)?;
        let base = match &request.named.muscle {
            Some(file) => muscle_of(file)?,
            None => Muscle::prototype(),
        };
        let Some(text) = rubber else { return Ok(to_toml(&request.over(&base)?)) };
        let mut made = base.parts().clone();
        made.tube.rubber =
            muscle_of(&TextFile { name: "tube.material".into(), text })?.parts().tube.rubber.clone();
        let base = Muscle::from_parts(made).map_err(Problem::from)?.with_bench_of(&base);
        Ok(to_toml(&request.over(&base)?))
    })?)
}

/// Constants and measures of a muscle by which a model has derivatives, with their values and units.
#[pyfunction]
pub fn parameters(text: String) -> PyResult<Vec<(String, f64, &'static str)>> {
    let muscle = muscle_of(&TextFile { name: "muscle".into(), text }).map_err(Wrong::from)?;
    let known = |target: &Target| {
        !matches!(
            target,
            Target::ContractionOffset | Target::DeadVolume | Target::StiffnessExponent | Target::Modulus
        )
    };
    let all = Target::all(&muscle).into_iter().filter(known);
    let row = |t: Target| Some((t.name(&muscle), t.value(&muscle)?, t.unit(&muscle)));
    Ok(all.filter_map(row).collect())
}

/// The fields by which a muscle is given, of this one; those that it does not have are left out.
#[pyfunction]
#[pyo3(signature = (text: "str") -> "dict[str, typing.Any]")]
pub fn muscle_fields(py: Python<'_>, text: String) -> PyResult<Bound<'_, PyAny>> {
    let muscle = muscle_of(&TextFile { name: "muscle".into(), text }).map_err(Wrong::from)?;
    let wrong = |e: serde_json::Error| Wrong::from(Problem::new(ProblemKind::Internal, e.to_string(), ""));
    value::answer(py, &serde_json::to_value(MuscleFields::from_muscle(&muscle)).map_err(wrong)?)
}

/// Nominal stress in MPa of the rubber of a muscle at stretches: `uniaxial`, `planar` or `equibiaxial`, with plane stress and constant volume.
#[pyfunction]
#[pyo3(signature = (text: "str", mode: "str", stretches: "list[float]"))]
pub fn rubber_stress(text: String, mode: &str, stretches: Vec<f64>) -> PyResult<Vec<f64>> {
    let muscle = muscle_of(&TextFile { name: "muscle".into(), text }).map_err(Wrong::from)?;
    let law = muscle.tube().rubber.law.clone();
    if let Some(wrong) = stretches.iter().find(|s| !(**s > 0.0 && s.is_finite())) {
        let message = format!("a stretch of {wrong}: it is the length over that at rest, above 0");
        let problem = Problem::new(ProblemKind::Quantity, message, "").in_field("stretch");
        return Err(Wrong::from(problem).into());
    }
    let stress = |stretch: &f64| match mode {
        "planar" => law.planar_stress_mpa(*stretch),
        "equibiaxial" => law.equibiaxial_stress_mpa(*stretch),
        _ => law.uniaxial_stress_mpa(*stretch),
    };
    Ok(stretches.iter().map(stress).collect())
}

/// The muscle with other values of constants and measures, all others held.
#[pyfunction]
#[pyo3(signature = (text: "str", values: "dict[str, float]"))]
pub fn muscle_with(text: String, values: &Bound<'_, PyDict>) -> PyResult<String> {
    let muscle = muscle_of(&TextFile { name: "muscle".into(), text }).map_err(Wrong::from)?;
    let values = values.iter().map(|(name, value)| Ok((name.extract()?, value.extract()?)));
    let values: Vec<(String, f64)> = values.collect::<PyResult<_>>()?;
    Ok(to_toml(&with_parameters(&muscle, &values).map_err(Wrong::from)?))
}
