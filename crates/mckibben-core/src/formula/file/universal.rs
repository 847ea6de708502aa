//! The file of a formula for muscles of every make.

use super::{
    check::{is_zero, name},
    head::{Format, Kind, Read, read},
};
use crate::formula::{
    Provenance, UniversalErrors, UniversalFormula, UniversalRange, UniversalTerm,
    error::FormulaError,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The file of a universal formula.
#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(expecting = "an object")]
pub struct UniversalFile {
    format: Format,
    #[serde(deserialize_with = "name")]
    name: String,
    kind: Kind,
    #[serde(skip_deserializing)]
    equation: String,
    form: Form,
    terms: Vec<EndTerm>,
    range: UniversalRange,
    errors: UniversalErrors,
    provenance: Provenance,
}

/// What its terms correct.
#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum Form {
    /// The membrane's end with a correction for the wall.
    Membrane,
}

#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(expecting = "an object")]
struct EndTerm {
    #[serde(skip_deserializing)]
    name: String,
    powers: EndPowers,
    #[serde(skip_deserializing)]
    unit: &'static str,
    value: f64,
}

/// Powers of the variables; those of zero are omitted.
#[serde_with_macros::apply(crate = "serde_with_macros", u8 => #[serde(skip_serializing_if = "is_zero")])]
#[derive(Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields, expecting = "an object")]
struct EndPowers {
    wall: u8,
    angle: u8,
    slope: u8,
    modulus: u8,
    strain: u8,
}

impl From<UniversalFormula> for UniversalFile {
    fn from(formula: UniversalFormula) -> Self {
        let powers = |[wall, angle, slope, modulus, strain]: [u8; 5]| EndPowers {
            wall,
            angle,
            slope,
            modulus,
            strain,
        };
        let one = |t: &UniversalTerm| EndTerm {
            name: formula.term_name(t),
            powers: powers(t.powers),
            unit: "1",
            value: t.value,
        };
        Self {
            format: Format::One,
            kind: Kind::Universal,
            equation: formula.equation(),
            form: Form::Membrane,
            terms: formula.terms.iter().map(one).collect(),
            name: formula.name,
            range: formula.range,
            errors: formula.errors,
            provenance: formula.provenance,
        }
    }
}

pub fn universal(text: &str) -> Read<UniversalFormula> {
    formula(read(text)?)
}

/// Of a built-in text: a small engine does without the messages that name mistyped keys.
pub fn built_in(text: &str) -> Read<UniversalFormula> {
    formula(serde_json::from_str(text).map_err(FormulaError::json)?)
}

fn formula(file: UniversalFile) -> Read<UniversalFormula> {
    let mut formula = UniversalFormula {
        name: file.name,
        terms: vec![],
        range: file.range,
        errors: file.errors,
        provenance: file.provenance,
    };
    for EndTerm {
        powers: p, value, ..
    } in file.terms
    {
        let powers = [p.wall, p.angle, p.slope, p.modulus, p.strain];
        let term = UniversalTerm { powers, value };
        if powers.into_iter().map(u32::from).sum::<u32>() > 2 {
            let name = formula.term_name(&term);
            let why = format!("`terms`: the term {name} has more than two factors");
            return Err(FormulaError::new(why));
        }
        if formula.terms.iter().any(|t| t.powers == powers) {
            return Err(FormulaError::twice(&formula.term_name(&term)));
        }
        formula.terms.push(term);
    }
    Ok(formula)
}
