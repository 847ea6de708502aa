//! The list of measures.

use mckibben_app::{MeasuresRequest, measures};
use mckibben_core::muscle::measures::{SECTIONS, STIFFNESS};

/// The fields are those of the requests' schema, with the same bounds, defaults and units.
#[test]
fn measures_are_the_fields_of_requests() {
    let entries = measures(&MeasuresRequest {}).unwrap().measures;
    let force = mckibben_app::schema("force").unwrap();
    let fields = &force["request"]["$defs"]["MuscleFields"]["properties"];
    for entry in &entries {
        let field = entry
            .field
            .unwrap_or_else(|| panic!("{} has no field", entry.key));
        let schema = &fields[field];
        assert_eq!(schema["x-key"], entry.key);
        assert!(SECTIONS.contains(&entry.group));
        let ends = [
            ("x-above", entry.above),
            ("x-minimum", entry.minimum),
            ("x-maximum", entry.maximum),
        ];
        for (name, value) in ends {
            assert_eq!(
                schema.get(name).and_then(serde_json::Value::as_f64),
                value,
                "{field} {name}"
            );
        }
        if entry.key != STIFFNESS.key {
            assert_eq!(
                schema.get("default").and_then(serde_json::Value::as_f64),
                entry.default,
                "{field}"
            );
        }
    }
    let keyed = fields
        .as_object()
        .unwrap()
        .values()
        .filter(|f| f.get("x-key").is_some())
        .count();
    assert_eq!(keyed, entries.len());
}
