//! The file of a formula for muscles of every make.

use super::{
    check::{is_zero, name, up_to},
    head::{Format, Kind, Read, read},
};
use crate::formula::{
    Deficit, Form, Provenance, UniversalErrors, UniversalFormula, UniversalRange, UniversalTerm,
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

/// Powers of the variables of both forms; those of zero are omitted.
#[serde_with_macros::apply(crate = "serde_with_macros", u8 => #[serde(skip_serializing_if = "is_zero", deserialize_with = "up_to::<{ Form::HIGHEST }, _>")])]
#[derive(Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields, expecting = "an object")]
struct EndPowers {
    wall: u8,
    angle: u8,
    slope: u8,
    bulge: u8,
    modulus: u8,
    strain: u8,
    shortening: u8,
}

impl EndPowers {
    fn new(form: Form, [wall, angle, third, modulus, fifth]: [u8; 5]) -> Self {
        let common = Self {
            wall,
            angle,
            modulus,
            ..Self::default()
        };
        match form {
            Form::Membrane => Self {
                slope: third,
                strain: fifth,
                ..common
            },
            Form::Bulge => Self {
                bulge: third,
                shortening: fifth,
                ..common
            },
        }
    }

    /// In the order of a form's variables; `None` where another form's are given.
    fn powers(self, form: Form) -> Option<[u8; 5]> {
        let Self {
            wall,
            angle,
            slope,
            bulge,
            modulus,
            strain,
            shortening,
        } = self;
        let (list, others) = match form {
            Form::Membrane => ([wall, angle, slope, modulus, strain], [bulge, shortening]),
            Form::Bulge => ([wall, angle, bulge, modulus, shortening], [slope, strain]),
        };
        (others == [0, 0]).then_some(list)
    }
}

impl From<UniversalFormula> for UniversalFile {
    fn from(formula: UniversalFormula) -> Self {
        let form = formula.deficit.form;
        let one = |t: &UniversalTerm| EndTerm {
            name: formula.term_name(t),
            powers: EndPowers::new(form, t.powers),
            unit: "1",
            value: t.value,
        };
        Self {
            format: Format::One,
            kind: Kind::Universal,
            equation: formula.equation(),
            form,
            terms: formula.deficit.terms.iter().map(one).collect(),
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
    let UniversalFile {
        name,
        form,
        terms,
        range,
        errors,
        provenance,
        ..
    } = file;
    let deficit = Deficit {
        form,
        terms: vec![],
    };
    let mut formula = UniversalFormula {
        name,
        deficit,
        range,
        errors,
        provenance,
    };
    for (i, EndTerm { powers, value, .. }) in terms.into_iter().enumerate() {
        let foreign = || {
            FormulaError::new(format!(
                "`terms[{i}].powers`: a variable that the form {form} does not have"
            ))
        };
        let term = UniversalTerm {
            powers: powers.powers(form).ok_or_else(foreign)?,
            value,
        };
        if formula
            .deficit
            .terms
            .iter()
            .any(|t| t.powers == term.powers)
        {
            return Err(FormulaError::twice(&formula.term_name(&term)));
        }
        formula.deficit.terms.push(term);
    }
    Ok(formula)
}
