//! Schemas of files.

use mckibben_app::file_schema;

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
