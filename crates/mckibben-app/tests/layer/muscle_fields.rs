//! The fields of a muscle in requests.

use mckibben_app::{ForceRequest, MuscleFields};
use mckibben_core::muscle::{Measure, Muscle};
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

/// An identity: each measure of a muscle may be a field or a key of `with`, in any mixture and any
/// order.
#[test]
fn what_states_a_measure_does_not_matter() {
    let stated = [
        ("outer_diameter_mm", "tube.outer_diameter", 30.0),
        ("wall_mm", "tube.wall_thickness", 3.0),
        ("length_mm", "tube.length", 250.0),
        ("strand_length_mm", "braid.strand_length", 277.1),
        ("turns", "braid.turns", 1.5),
        ("seating_mm", "terminals.seating", 1.6),
    ];
    let whole = muscle_of(&stated, 0, 0);
    for mixture in 0..1 << stated.len() {
        for turned in [0, 1, 4] {
            assert_eq!(muscle_of(&stated, mixture, turned), whole, "{mixture:b}");
        }
    }
    // What contradicts itself is refused in any mixture: a strand that does not reach from end to end.
    let short =
        stated.map(|(field, key, value)| (field, key, if value == 277.1 { 240.0 } else { value }));
    for mixture in 0..1 << stated.len() {
        let problem = fields_of(&short, mixture, 0).resolve().unwrap_err();
        assert!(problem.message.contains("250"), "{mixture:b}: {problem}");
    }
}

fn fields_of(stated: &[(&str, &str, f64)], mixture: usize, turned: usize) -> MuscleFields {
    let mut fields = MuscleFields::default();
    for (i, (field, key, value)) in stated.iter().enumerate() {
        let measure = Measure::of_field(field).unwrap();
        if mixture >> i & 1 == 0 {
            fields.measures.set(measure, *value);
        } else {
            fields.with.push(format!("{key}={value}"));
        }
    }
    let count = fields.with.len();
    fields.with.rotate_left(turned.min(count));
    fields
}

fn muscle_of(stated: &[(&str, &str, f64)], mixture: usize, turned: usize) -> Muscle {
    fields_of(stated, mixture, turned).resolve().unwrap()
}
