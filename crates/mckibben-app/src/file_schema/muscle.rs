//! The muscle file.

use super::parts::{
    boolean, named, needing, number, pairs, positive, quantity, root, table, text, word, word_or,
};
use mckibben::muscle::Measure;
use mckibben::muscle::measures::{STIFFNESS, Written, of_section};
use mckibben::rubber::{Constant, Law, LawKind, library};
use mckibben::sleeve;
use mckibben::units::Dimension;
use serde_json::{Value, json};

pub(super) fn schema() -> Value {
    root(tables())
}

pub(super) fn tables() -> Vec<(&'static str, Value)> {
    // A damaged table of names leaves the key without them.
    let rubbers = library::entries().unwrap_or_default().iter().map(|entry| entry.name.as_str());
    let tube = measures("tube").chain([
        ("rubber".to_owned(), named("Name of a rubber (`mckibben parts list rubbers`), a hardness such as \"shore:30A\", or a stress such as \"s100:0.6MPa\"", rubbers)),
        ("material".to_owned(), material()),
    ]);
    let sleeves = sleeve::library::entries().unwrap_or_default().iter().map(|entry| entry.sleeve.name());
    let braid = measures("braid").chain([
        (
            "name".to_owned(),
            named("Name of a sleeve (`mckibben parts list sleeves`); it gives angle and strands", sleeves),
        ),
        (
            "strand_diameter".to_owned(),
            positive(Dimension::Length, "Diameter of a round strand, in place of its area"),
        ),
        ("compression".to_owned(), boolean("Whether the strands carry compression")),
    ]);
    vec![
        ("tube", table("The rubber tube", tube)),
        ("braid", table("The braided sleeve", braid)),
        ("terminals", table("The ends", measures("terminals"))),
        (
            "friction",
            table("Friction of the braid: half of the width of the hysteresis loop", measures("friction")),
        ),
        ("model", models()),
        ("identified", identified()),
    ]
}

/// The measures of a table, with the bounds that their numbers have.
fn measures(section: &'static str) -> impl Iterator<Item = (String, Value)> {
    of_section(section).map(|measure| (measure.name().to_owned(), of_measure(measure)))
}

fn of_measure(measure: &'static Measure) -> Value {
    if *measure == STIFFNESS {
        return word_or(&["paper", "inextensible"], positive(measure.dimension, measure.about()));
    }
    if measure.key == "terminals.end_factor" {
        return end_factor();
    }
    let sentence = measure.sentence();
    let mut schema = match (measure.written, measure.dimension) {
        (Written::Number, _) | (Written::Special, Dimension::Ratio) => number(&sentence),
        _ => quantity(measure.dimension, sentence.trim_end_matches('.')),
    };
    if let Some(unit) = measure.unit {
        schema["x-unit"] = unit.into();
    }
    if !measure.symbol().is_empty() {
        schema["x-symbol"] = measure.symbol().into();
    }
    for (end, value) in measure.bounds.ends() {
        schema[if end == "above" { "exclusiveMinimum" } else { end }] = value.into();
    }
    if let Some(usual) = measure.usual() {
        schema["default"] = usual.into();
    }
    schema
}

/// `[tube.material]`: the keys beside the constants, then those of each law.
fn material() -> Value {
    let softening = table(
        "Softening of rubber that was stretched before (Ogden & Roxburgh 1999)",
        [("r", number("r")), ("m", quantity(Dimension::Pressure, "m")), ("beta", number("β"))],
    );
    let common = [
        ("law", word("The law of the rubber (`mckibben parts list rubbers`)", Law::names())),
        ("name", text("Where the constants come from")),
        ("bulk_modulus", word_or(&["incompressible"], positive(Dimension::Pressure, "Bulk modulus"))),
        ("fitted_to_stretch", number("Largest stretch of the data behind the constants")),
        ("softening", needing(softening, &["r", "m"])),
        (
            "conditioned",
            quantity(
                Dimension::Pressure,
                "What the rubber has seen: a pressure, or a strain such as \"50 %\"",
            ),
        ),
        ("prony", pairs("Shares of the stress that relax, each with a time constant: [[0.2, \"2 s\"]]")),
        ("held", word_or(&["long"], quantity(Dimension::Time, "How long the rubber was held"))),
    ];
    let common = common.into_iter().map(|(key, schema)| (key.to_owned(), schema));
    let mut constants: Vec<(String, Value)> = vec![];
    for kind in Law::KINDS {
        for constant in kind.constants {
            let schema = of_constant(constant, kind);
            match constants.iter_mut().find(|known| known.0 == constant.name) {
                None => constants.push((constant.name.to_owned(), schema)),
                // The same letter in two laws.
                Some(known) if known.1 != schema => {
                    let former = known.1.take();
                    known.1 = json!({ "description": former["description"], "anyOf": [former, schema] });
                }
                Some(_) => {}
            }
        }
    }
    let laws = Law::KINDS.iter().map(|kind| {
        json!({
            "if": { "properties": { "law": { "const": kind.name } }, "required": ["law"] },
            "then": { "required": kind.names() },
        })
    });
    let laws: Vec<Value> = laws.collect();
    let mut schema =
        needing(table("A rubber of one's own: a law and its constants", common.chain(constants)), &["law"]);
    schema["allOf"] = laws.into();
    schema
}

fn of_constant(constant: &'static Constant, kind: &LawKind) -> Value {
    let one = match constant.is_modulus() {
        true => quantity(constant.dimension, constant.doc),
        false => number(constant.doc),
    };
    if !kind.is_sum {
        return one;
    }
    json!({ "type": "array", "items": one, "minItems": 1, "description": format!("{}, of each term", constant.doc) })
}

/// A number, or a function of the pressure.
fn end_factor() -> Value {
    let about = "End factor k of Tondu & Lopez: a number, or { a, b } for a·e^(−P) + b with P in bar";
    let of_pressure = needing(table(about, [("a", number("a")), ("b", number("b"))]), &["a", "b"]);
    json!({ "description": about, "anyOf": [{ "type": "number" }, of_pressure] })
}

fn models() -> Value {
    table(
        "What belongs to one model",
        [
            ("tondu-lopez", table("The model tondu-lopez", [("end_factor", end_factor())])),
            ("conical-ends", table("The model conical-ends", [("cone_factor", number("Cone factor kc"))])),
        ],
    )
}

/// `identify` writes it; people leave it as it is.
fn identified() -> Value {
    let list = |about: &str| json!({ "type": "array", "description": about });
    let keys = [
        ("laboratory", text("Who measured it; left out of one's own muscle")),
        ("model", text("The model of the fit")),
        ("lengths", list("Lengths at rest of the muscles that were measured, this one first")),
        ("points", number("Number of points")),
        ("branches", list("Branches of the hysteresis loop")),
        ("pressure", list("Lowest and highest pressure")),
        ("contraction", list("Lowest and highest contraction")),
        ("scatter", quantity(Dimension::Force, "95 % half-width of a point about the fit")),
        ("fit", list("95 % half-width of the fitted pull in N: rows by pressure, columns by contraction")),
        ("parameters", list("Names of what was identified")),
        ("covariance", list("Covariance, in the units of the parameters")),
        ("of", text("Checksum of the muscle")),
    ];
    table("What a bench says of this muscle; `identify` writes it", keys)
}
