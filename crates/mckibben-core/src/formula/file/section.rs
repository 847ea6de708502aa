//! The files of formulas for muscles of one make: the paper's, and sums of products of powers.

use super::{
    check::{is_zero, name, power},
    head::{Format, Kind, Read, read},
};
use crate::formula::{
    Body, Coefficients, Formula, FormulaErrors, FormulaRange, GlobalTerms, Made, Provenance,
    Scales, Term, error::FormulaError, paper_terms,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The file of a formula for muscles of one make.
#[serde_with_macros::skip_serializing_none]
#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(expecting = "an object")]
pub struct SectionFile<T> {
    format: Format,
    #[serde(deserialize_with = "name")]
    name: String,
    kind: Kind,
    #[serde(skip_deserializing)]
    equation: String,
    scales: Option<Scales>,
    terms: Vec<T>,
    made_for: Made,
    range: FormulaRange,
    errors: FormulaErrors,
    provenance: Provenance,
}

#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(expecting = "an object")]
pub struct PaperTerm {
    name: String,
    #[serde(skip_deserializing)]
    unit: &'static str,
    value: f64,
}

#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(expecting = "an object")]
pub struct GlobalTerm {
    #[serde(skip_deserializing)]
    name: String,
    powers: Powers,
    #[serde(skip_deserializing)]
    unit: &'static str,
    value: f64,
}

/// Powers of x, p, e, d; those of zero are omitted.
#[serde_with_macros::apply(crate = "serde_with_macros", u8 => #[serde(skip_serializing_if = "is_zero", deserialize_with = "power")])]
#[derive(Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields, expecting = "an object")]
struct Powers {
    wall_ratio: u8,
    pressure: u8,
    contraction: u8,
    outer_diameter: u8,
}

impl Formula {
    pub(super) fn file<T: Serialize>(
        self,
        kind: Kind,
        scales: Option<Scales>,
        terms: Vec<T>,
    ) -> SectionFile<T> {
        SectionFile {
            format: Format::One,
            kind,
            equation: self.equation(),
            scales,
            terms,
            name: self.name,
            made_for: self.made_for,
            range: self.range,
            errors: self.errors,
            provenance: self.provenance,
        }
    }
}

/// The terms of the paper's formula as its file has them.
pub fn paper_list(c: &Coefficients) -> Vec<PaperTerm> {
    paper_terms(c)
        .into_iter()
        .map(|(name, unit, value)| PaperTerm { name, unit, value })
        .collect()
}

/// The terms of a sum as its file has them.
pub fn global_list(t: &GlobalTerms) -> Vec<GlobalTerm> {
    let one = |t: &Term| {
        let [wall_ratio, pressure, contraction, outer_diameter] = t.powers;
        let powers = Powers {
            wall_ratio,
            pressure,
            contraction,
            outer_diameter,
        };
        GlobalTerm {
            name: t.name(),
            powers,
            unit: "MPa",
            value: t.value,
        }
    };
    t.terms.iter().map(one).collect()
}

fn section<T>(file: SectionFile<T>, body: Body) -> Formula {
    let SectionFile {
        name,
        made_for,
        range,
        errors,
        provenance,
        ..
    } = file;
    Formula {
        name,
        body,
        made_for,
        range,
        errors,
        provenance,
    }
}

pub fn paper(text: &str) -> Read<Formula> {
    let file: SectionFile<PaperTerm> = read(text)?;
    let coefficients = coefficients(&file.terms)?;
    Ok(section(file, Body::Paper(Box::new(coefficients))))
}

fn coefficients(terms: &[PaperTerm]) -> Read<Coefficients> {
    let mut given = [[[None; 3]; 6]; 3];
    for (i, PaperTerm { name, value, .. }) in terms.iter().enumerate() {
        let unknown = || {
            FormulaError::unknown(
                &format!("terms[{i}].name"),
                &format!("{name:.40}"),
                "A11 … A63, B11 … B63, C11 … C62",
            )
        };
        let (f, k, j) = place_of_coefficient(name).ok_or_else(unknown)?;
        if given[f][k][j].replace(*value).is_some() {
            return Err(FormulaError::twice(name));
        }
    }
    let mut x = [[[0.0; 3]; 6]; 3];
    for (f, letter) in ["A", "B", "C"].into_iter().enumerate() {
        for k in 0..6 {
            for j in 0..3 {
                let number = if f == 2 { j } else { j + 1 };
                let optional = f == 2 && j == 0;
                let missing =
                    || FormulaError::missing(&format!("terms: {letter}{}{number}", k + 1));
                x[f][k][j] = match given[f][k][j] {
                    None if optional => 0.0,
                    given => given.ok_or_else(missing)?,
                };
            }
        }
    }
    let [a, b, c] = x;
    Ok(Coefficients { a, b, c })
}

/// `A11` → family, k, column.
fn place_of_coefficient(name: &str) -> Option<(usize, usize, usize)> {
    let letters: Vec<char> = name.chars().collect();
    let [letter, k, number] = letters.as_slice() else {
        return None;
    };
    let family = ['A', 'B', 'C'].iter().position(|l| l == letter)?;
    let k = k.to_digit(10)? as usize;
    let number = number.to_digit(10)? as usize;
    let column = if family == 2 {
        number
    } else {
        number.checked_sub(1)?
    };
    ((1..=6).contains(&k) && column < 3).then(|| (family, k - 1, column))
}

/// The powers of the terms of a `global` formula: a list of them, or those of a formula's file.
pub fn powers(text: &str) -> Read<Vec<[u8; 4]>> {
    if text.trim_start().starts_with('[') {
        return read(text);
    }
    match global(text)?.body {
        Body::Global(sum) => Ok(sum.terms.iter().map(|term| term.powers).collect()),
        Body::Paper(_) => Err(FormulaError::new("is no formula of the kind global")),
    }
}

pub fn global(text: &str) -> Read<Formula> {
    let file: SectionFile<GlobalTerm> = read(text)?;
    let scales = file.scales.ok_or_else(|| FormulaError::missing("scales"))?;
    let mut terms: Vec<Term> = vec![];
    for GlobalTerm { powers, value, .. } in &file.terms {
        let Powers {
            wall_ratio,
            pressure,
            contraction,
            outer_diameter,
        } = *powers;
        let term = Term {
            powers: [wall_ratio, pressure, contraction, outer_diameter],
            value: *value,
        };
        if terms.iter().any(|t| t.powers == term.powers) {
            return Err(FormulaError::twice(&term.name()));
        }
        terms.push(term);
    }
    if terms.is_empty() {
        return Err(FormulaError::new("`terms`: expected at least one term"));
    }
    Ok(section(file, Body::Global(GlobalTerms { scales, terms })))
}
