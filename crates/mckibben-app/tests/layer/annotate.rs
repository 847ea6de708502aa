//! Units of fields in the schemas.

use mckibben_app::COMMANDS;
use mckibben_core::muscle::Measure;
use serde_json::Value;
use std::collections::BTreeSet;

const UNIT: &str = "x-unit";
const QUANTITY: &str = "x-quantity";

/// Last words of names of plain numbers: what has a unit ends with it. A new word here is one more
/// kind of plain number.
const PLAIN: &str = "above aicc angle area at beta blocked braid by certainty chance command contractions correlation \
    correlations command default difference deviation divide efficiency ends error errors fitted published \
    exponent factor fit fixed formula friction from held high ideal interval isobar \
    largest limit low margin maximum measured mesh minimum modulus multiply neutral opening ours \
    predicted     overshoot overstress of points prony r ratio range reach reference relative rms rubber share \
    sheet smallest speed squared start stiffer stretch take up \
    tolerance to torques transfer turns value values weight weights width x y stretched use";

fn is_number(field: &Value, defs: &Value, deeper: usize) -> bool {
    let Some(deeper) = deeper.checked_sub(1) else {
        return false;
    };
    let list = |key: &str| field[key].as_array().into_iter().flatten();
    let is = |kind: &Value| kind == "number";
    is(&field["type"])
        || list("type").any(is)
        || list("anyOf")
            .chain(list("oneOf"))
            .chain(list("prefixItems"))
            .any(|f| is_number(f, defs, deeper))
        || field
            .get("items")
            .is_some_and(|items| is_number(items, defs, deeper))
        || field["$ref"]
            .as_str()
            .and_then(|path| path.rsplit('/').next())
            .is_some_and(|name| {
                defs[name].get("properties").is_none() && is_number(&defs[name], defs, deeper)
            })
}

/// Every field with a number below a schema.
fn each(schema: &Value, defs: &Value, visit: &mut dyn FnMut(&str, &Value)) {
    for (name, field) in schema
        .get("properties")
        .and_then(Value::as_object)
        .into_iter()
        .flatten()
    {
        if is_number(field, defs, 6) {
            visit(name, field);
        }
    }
    match schema {
        Value::Object(map) => map.values().for_each(|v| each(v, defs, visit)),
        Value::Array(list) => list.iter().for_each(|v| each(v, defs, visit)),
        _ => {}
    }
}

#[test]
fn every_number_of_every_schema_has_a_unit_that_is_known_or_is_a_plain_one() {
    let (mut units, mut unknown) = (BTreeSet::new(), BTreeSet::new());
    for command in COMMANDS.iter() {
        let schema = command.schema();
        for side in ["request", "answer", "error"] {
            each(&schema[side], &schema[side]["$defs"], &mut |name, field| {
                if field.get(UNIT).is_some() || field.get(QUANTITY).is_some() {
                    units.insert(name.to_owned());
                } else if !Measure::of_field(name).is_some_and(Measure::is_plain)
                    && !name
                        .split('_')
                        .rfind(|word| word.chars().all(|c| c.is_ascii_alphabetic()))
                        .is_some_and(|word| PLAIN.split_whitespace().any(|plain| plain == word))
                {
                    unknown.insert(format!("{}: {name}", command.name));
                }
            });
        }
    }
    assert!(
        unknown.is_empty(),
        "neither a unit nor a plain number: {unknown:#?}"
    );
    assert!(units.len() > 150, "{units:?}");
}

#[test]
fn units_are_those_of_the_names_and_shares_those_that_are_stated() {
    let force = mckibben_app::schema("force").unwrap();
    let slip = &force["request"]["$defs"]["MuscleFields"]["properties"]["slip_mm_per_n"];
    assert_eq!(slip[UNIT], "mm/N");
    assert_eq!(slip[QUANTITY], "compliance");
    assert_eq!(
        force["answer"]["properties"]["force_per_pressure_n_per_mpa"][UNIT],
        "N/MPa"
    );
    let design = mckibben_app::schema("design").unwrap();
    assert_eq!(
        design["request"]["properties"]["stiffness"][QUANTITY],
        "stiffness"
    );
}
