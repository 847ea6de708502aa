//! Schemas of files.

use crate::reply;
use mckibben_app::file_schema;
use serde_json::json;

/// Every law can be written with the keys of the schema, and the schema asks for its constants.
#[test]
fn a_law_needs_its_constants_and_every_law_is_named() {
    let material = &file_schema("muscle").unwrap()["properties"]["tube"]["properties"]["material"];
    let names = mckibben_core::rubber::Law::names();
    assert_eq!(
        material["properties"]["law"]["enum"]
            .as_array()
            .unwrap()
            .len(),
        names.len()
    );
    for (name, rule) in names.iter().zip(material["allOf"].as_array().unwrap()) {
        assert_eq!(rule["if"]["properties"]["law"]["const"], *name);
        for constant in rule["then"]["required"].as_array().unwrap() {
            assert!(
                material["properties"]
                    .get(constant.as_str().unwrap())
                    .is_some(),
                "{name}: {constant}"
            );
        }
    }
}

#[test]
fn a_kind_that_is_not_there_is_named_with_the_nearest() {
    let problem = file_schema("muscel").unwrap_err();
    assert_eq!(problem.hint, "did you mean muscle?");
}

/// A muscle file that was written names the schema of its kind.
#[test]
fn a_schema_bounds_its_values_and_a_written_file_names_it() {
    let schema = file_schema("muscle").unwrap();
    let diameter = &schema["properties"]["tube"]["properties"]["outer_diameter"];
    assert_eq!(
        (&diameter["exclusiveMinimum"], &diameter["x-unit"]),
        (&json!(0.0), &json!("mm"))
    );
    let wanted = json!({ "force_n": 40, "contraction": 0.1, "max_pressure_mpa": 0.25, "certainty": 0.5, "tubes": ["latex-1/4x3/8in"] });
    let design = reply("design", wanted);
    let text = design["muscle_files"][0]["text"].as_str().unwrap();
    assert_eq!(text.lines().nth(2), Some("#:schema muscle.schema.json"));
}
