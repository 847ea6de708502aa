//! The fields of a muscle in requests.

use mckibben_app::{ForceRequest, MuscleFields};
use mckibben_core::muscle::Measure;
use serde_json::{Map, Value};

/// An identity: what is written is read, and in the order of the schema.
#[test]
fn fields_are_written_and_read_again_with_all_measures_among_them() {
    let mut fields = MuscleFields {
        rubber: Some("paper".into()),
        ..MuscleFields::default()
    };
    for (i, (_, measure)) in mckibben_core::muscle::measures::fields().enumerate() {
        fields.measures.set(measure, 1.0 + i as f64);
    }
    let request = ForceRequest {
        question: fields.clone().into(),
        ..ForceRequest::default()
    };
    let text = serde_json::to_string(&request).unwrap();
    assert_eq!(
        serde_json::from_str::<ForceRequest>(&text)
            .unwrap()
            .question
            .muscle,
        fields
    );
    let mut written: Value = serde_json::from_str(&text).unwrap();
    let written: Map<String, Value> = serde_json::from_value(written["muscle"].take()).unwrap();
    let schema =
        mckibben_app::schema("force").unwrap()["request"]["$defs"]["MuscleFields"]["properties"]
            .take();
    let names: Vec<&String> = schema.as_object().unwrap().keys().collect();
    let of_muscle = |name: &String| name == "rubber" || Measure::of_field(name).is_some();
    let order: Vec<_> = written
        .keys()
        .filter(|k| of_muscle(k))
        .map(|k| names.iter().position(|n| *n == k))
        .collect();
    assert!(
        order.is_sorted() && order.len() == fields.measures.iter().count() + 1,
        "{text}"
    );
    let wrong = serde_json::from_str::<ForceRequest>(r#"{ "muscle": { "grip_mm": "x" } }"#)
        .unwrap_err()
        .to_string();
    assert!(
        wrong.contains("\"x\"") && wrong.contains("length"),
        "{wrong}"
    );
}
