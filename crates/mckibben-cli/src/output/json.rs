//! JSON shapes; keys carry their unit.

use mckibben::answer::Answer;
use mckibben::curve::{Curve, CurvePoint, Test};
use mckibben::model::Response;
use mckibben::muscle::Muscle;
use serde_json::{Map, Value, json};

/// Pretty JSON with a newline behind.
pub fn print(value: &Value) -> String {
    format!("{value:#}\n")
}

fn put(map: &mut Map<String, Value>, key: &str, value: Option<f64>) {
    if let Some(v) = value.filter(|v| v.is_finite()) {
        map.insert(key.into(), json!(v));
    }
}

/// What a model knows beyond pressure, contraction and force.
pub fn put_response(map: &mut Map<String, Value>, r: &Response) {
    put(map, "volume_mm3", r.volume_mm3);
    put(map, "stiffness_n_per_mm", r.stiffness_n_per_mm);
    put(map, "force_per_pressure_n_per_mpa", r.force_per_pressure_mm2);
    put(map, "strand_tension_n", r.strand_tension_n);
    put(map, "braid_tension_n", r.braid_tension_n);
    put(map, "bulged_diameter_mm", r.bulged_diameter_mm);
    put(map, "max_stretch", r.max_stretch);
}

/// One answered point.
pub fn answer(a: &Answer) -> Value {
    let mut map = Map::new();
    map.insert("model".into(), json!(a.model));
    map.extend(answer_fields(a));
    map.insert("warnings".into(), json!(a.warnings));
    Value::Object(map)
}

fn answer_fields(a: &Answer) -> Map<String, Value> {
    let mut map = Map::new();
    put(&mut map, "pressure_mpa", Some(a.response.pressure_mpa));
    put(&mut map, "contraction", Some(a.response.contraction));
    put(&mut map, "force_n", Some(a.response.force_n));
    map.insert("slack".into(), json!(a.slack));
    put(&mut map, "start_pressure_mpa", a.start_pressure_mpa);
    put(&mut map, "free_contraction", a.free_contraction);
    put_response(&mut map, &a.response);
    put(&mut map, "uncertainty_n", a.uncertainty_n);
    map
}

/// One point of a curve; without an answer it carries `status` and `cause`.
pub fn curve_point(p: &CurvePoint) -> Value {
    match &p.answer {
        Ok(a) => {
            let mut map = answer_fields(a);
            map.insert("status".into(), json!("ok"));
            if !a.warnings.is_empty() {
                map.insert("warnings".into(), json!(a.warnings));
            }
            Value::Object(map)
        }
        Err(error) => {
            let mut map = Map::new();
            put(&mut map, "pressure_mpa", Some(p.pressure_mpa));
            put(&mut map, "contraction", p.contraction);
            put(&mut map, "wanted_force_n", p.force_n);
            map.insert("status".into(), json!(status(error)));
            map.insert("cause".into(), json!(error.to_string()));
            Value::Object(map)
        }
    }
}

/// The word for why a point has no answer.
pub fn status(error: &mckibben::analysis::AnalysisError) -> &'static str {
    use mckibben::analysis::AnalysisError;
    use mckibben::model::ModelError;
    match error {
        AnalysisError::Model(ModelError::OutOfRange { .. }) => "out_of_range",
        AnalysisError::Model(ModelError::NotConverged { .. } | ModelError::Stopped { .. }) => "not_converged",
        _ => "no_answer",
    }
}

/// A family of curves.
pub fn curves(model: &str, test: Test, list: &[Curve], muscle: &Muscle) -> Value {
    let points: Vec<Value> = list.iter().flat_map(|c| c.points.iter().map(curve_point)).collect();
    json!({ "model": model, "test": test.name(), "muscle": self::muscle(muscle), "points": points })
}

/// A muscle's measures.
pub fn muscle(m: &Muscle) -> Value {
    let mut map = Map::new();
    put(&mut map, "outer_diameter_mm", Some(m.outer_diameter_mm()));
    put(&mut map, "wall_mm", Some(m.wall_mm()));
    put(&mut map, "length_mm", Some(m.length_mm()));
    put(&mut map, "angle_deg", Some(m.braid().angle_deg));
    map.insert("rubber".into(), json!(super::text::rubber_name(m)));
    map.insert("braid".into(), json!(super::text::braid_name(m)));
    Value::Object(map)
}
