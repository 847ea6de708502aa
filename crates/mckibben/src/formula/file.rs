//! Formulas as JSON: the types that a file is read into and written from. Keys carry their unit.

use super::error::{FormulaError, Problem};
use super::{
    Body, Coefficients, Deficit, Document, Form, Formula, FormulaErrors, FormulaRange, GlobalTerms, Made,
    Provenance, Scales, Term, UniversalErrors, UniversalFormula, UniversalRange, UniversalTerm, paper_terms,
};
use serde::de::{DeserializeOwned, Error, IgnoredAny, Unexpected};
use serde::{Deserialize, Deserializer, Serialize};

#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
enum Format {
    #[serde(rename = "mckibben formula 1")]
    One,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
enum Kind {
    Paper,
    Global,
    Universal,
}

/// What every file has.
#[derive(Debug, Deserialize)]
#[serde(expecting = "an object")]
struct Head {
    format: Format,
    kind: Kind,
    /// Whatever else there is; with it a list is not taken for an object.
    #[serde(flatten)]
    _rest: IgnoredAny,
}

/// A formula's file.
#[derive(Debug, Clone, Serialize)]
#[serde(untagged)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) enum File {
    Paper(SectionFile<PaperTerm>),
    Global(SectionFile<GlobalTerm>),
    Universal(UniversalFile),
}

/// The file of a formula for muscles of one make.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(expecting = "an object")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct SectionFile<T> {
    format: Format,
    #[serde(deserialize_with = "name")]
    name: String,
    kind: Kind,
    #[serde(skip_deserializing)]
    equation: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    scales: Option<Scales>,
    terms: Vec<T>,
    made_for: Made,
    range: FormulaRange,
    errors: FormulaErrors,
    provenance: Provenance,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(expecting = "an object")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct PaperTerm {
    name: String,
    #[serde(skip_deserializing)]
    unit: &'static str,
    value: f64,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(expecting = "an object")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct GlobalTerm {
    #[serde(skip_deserializing)]
    name: String,
    powers: Powers,
    #[serde(skip_deserializing)]
    unit: &'static str,
    value: f64,
}

/// Powers of x, p, e, d; those of zero are left out.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, expecting = "an object")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Powers {
    #[serde(skip_serializing_if = "is_zero", deserialize_with = "up_to::<20, _>")]
    wall_ratio: u8,
    #[serde(skip_serializing_if = "is_zero", deserialize_with = "up_to::<20, _>")]
    pressure: u8,
    #[serde(skip_serializing_if = "is_zero", deserialize_with = "up_to::<20, _>")]
    contraction: u8,
    #[serde(skip_serializing_if = "is_zero", deserialize_with = "up_to::<20, _>")]
    outer_diameter: u8,
}

/// The file of a universal formula.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(expecting = "an object")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct UniversalFile {
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

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(expecting = "an object")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct EndTerm {
    #[serde(skip_deserializing)]
    name: String,
    powers: EndPowers,
    #[serde(skip_deserializing)]
    unit: &'static str,
    value: f64,
}

/// Powers of the variables of both forms; those of zero are left out.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, expecting = "an object")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct EndPowers {
    #[serde(skip_serializing_if = "is_zero", deserialize_with = "up_to::<{ Form::HIGHEST }, _>")]
    wall: u8,
    #[serde(skip_serializing_if = "is_zero", deserialize_with = "up_to::<{ Form::HIGHEST }, _>")]
    angle: u8,
    #[serde(skip_serializing_if = "is_zero", deserialize_with = "up_to::<{ Form::HIGHEST }, _>")]
    slope: u8,
    #[serde(skip_serializing_if = "is_zero", deserialize_with = "up_to::<{ Form::HIGHEST }, _>")]
    bulge: u8,
    #[serde(skip_serializing_if = "is_zero", deserialize_with = "up_to::<{ Form::HIGHEST }, _>")]
    modulus: u8,
    #[serde(skip_serializing_if = "is_zero", deserialize_with = "up_to::<{ Form::HIGHEST }, _>")]
    strain: u8,
    #[serde(skip_serializing_if = "is_zero", deserialize_with = "up_to::<{ Form::HIGHEST }, _>")]
    shortening: u8,
}

impl EndPowers {
    fn of(form: Form, [wall, angle, third, modulus, fifth]: [u8; 5]) -> Self {
        let common = Self { wall, angle, modulus, ..Self::default() };
        match form {
            Form::Membrane => Self { slope: third, strain: fifth, ..common },
            Form::Bulge => Self { bulge: third, shortening: fifth, ..common },
        }
    }

    /// In the order of a form's variables; `None` where another form's stand there.
    fn of_form(self, form: Form) -> Option<[u8; 5]> {
        let Self { wall, angle, slope, bulge, modulus, strain, shortening } = self;
        let (list, others) = match form {
            Form::Membrane => ([wall, angle, slope, modulus, strain], [bulge, shortening]),
            Form::Bulge => ([wall, angle, bulge, modulus, shortening], [slope, strain]),
        };
        (others == [0, 0]).then_some(list)
    }
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde hands over references")]
fn is_zero(n: &u8) -> bool {
    *n == 0
}

fn up_to<'de, const MOST: u8, D: Deserializer<'de>>(d: D) -> Result<u8, D::Error> {
    let n = u8::deserialize(d)?;
    let expected = format!("a whole number from 0 to {MOST}");
    let wrong = || D::Error::invalid_value(Unexpected::Unsigned(n.into()), &expected.as_str());
    if n <= MOST { Ok(n) } else { Err(wrong()) }
}

fn name<'de, D: Deserializer<'de>>(d: D) -> Result<String, D::Error> {
    let name = String::deserialize(d)?;
    if name.trim().is_empty() { Err(D::Error::custom("is empty; expected a name")) } else { Ok(name) }
}

fn number<'de, D: Deserializer<'de>>(
    d: D,
    expected: &'static str,
    right: fn(f64) -> bool,
) -> Result<f64, D::Error> {
    let v = f64::deserialize(d)?;
    if right(v) { Ok(v) } else { Err(D::Error::invalid_value(Unexpected::Float(v), &expected)) }
}

pub(super) fn positive<'de, D: Deserializer<'de>>(d: D) -> Result<f64, D::Error> {
    number(d, "a number above zero", |v| v > 0.0)
}

pub(super) fn share<'de, D: Deserializer<'de>>(d: D) -> Result<f64, D::Error> {
    number(d, "zero or more", |v| v >= 0.0)
}

pub(super) fn maybe_positive<'de, D: Deserializer<'de>>(d: D) -> Result<Option<f64>, D::Error> {
    let v = Option::<f64>::deserialize(d)?;
    let wrong = |v: f64| D::Error::invalid_value(Unexpected::Float(v), &"a number above zero");
    v.filter(|v| *v <= 0.0).map_or(Ok(v), |v| Err(wrong(v)))
}

/// `[low, high]`
pub(super) fn interval<'de, D: Deserializer<'de>>(d: D) -> Result<(f64, f64), D::Error> {
    let (low, high) = <(f64, f64)>::deserialize(d)?;
    if low <= high {
        Ok((low, high))
    } else {
        Err(D::Error::custom("expected [low, high] with low ≤ high"))
    }
}

/// `[low, high]` or `[low, null]`
pub(super) fn open_interval<'de, D: Deserializer<'de>>(d: D) -> Result<(f64, f64), D::Error> {
    let (low, high) = <(f64, Option<f64>)>::deserialize(d)?;
    let high = high.unwrap_or(f64::INFINITY);
    if low <= high {
        Ok((low, high))
    } else {
        Err(D::Error::custom("expected [low, high] with low ≤ high"))
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for Document {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Formula".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        File::json_schema(generator)
    }
}

impl Formula {
    fn file<T>(self, kind: Kind, scales: Option<Scales>, terms: Vec<T>) -> SectionFile<T> {
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

impl From<Formula> for File {
    fn from(formula: Formula) -> Self {
        match &formula.body {
            Body::Paper(c) => {
                let terms =
                    paper_terms(c).into_iter().map(|(name, unit, value)| PaperTerm { name, unit, value });
                let terms = terms.collect();
                Self::Paper(formula.file(Kind::Paper, None, terms))
            }
            Body::Global(t) => {
                let one = |t: &Term| {
                    let [wall_ratio, pressure, contraction, outer_diameter] = t.powers;
                    let powers = Powers { wall_ratio, pressure, contraction, outer_diameter };
                    GlobalTerm { name: t.name(), powers, unit: "MPa", value: t.value }
                };
                let (scales, terms) = (Some(t.scales), t.terms.iter().map(one).collect());
                Self::Global(formula.file(Kind::Global, scales, terms))
            }
        }
    }
}

impl From<UniversalFormula> for File {
    fn from(formula: UniversalFormula) -> Self {
        let form = formula.deficit.form;
        let one = |t: &UniversalTerm| EndTerm {
            name: formula.term_name(t),
            powers: EndPowers::of(form, t.powers),
            unit: "1",
            value: t.value,
        };
        Self::Universal(UniversalFile {
            format: Format::One,
            kind: Kind::Universal,
            equation: formula.equation(),
            form,
            terms: formula.deficit.terms.iter().map(one).collect(),
            name: formula.name,
            range: formula.range,
            errors: formula.errors,
            provenance: formula.provenance,
        })
    }
}

/// The text of a file, with a newline at the end.
fn text(file: &impl Serialize) -> String {
    // Numbers, texts, lists and objects with texts as keys: nothing that JSON has not.
    serde_json::to_string_pretty(file).unwrap_or_default() + "\n"
}

type Read<T> = Result<T, FormulaError>;

fn read<T: DeserializeOwned>(text: &str) -> Read<T> {
    let mut source = serde_json::Deserializer::from_str(text);
    let value = serde_path_to_error::deserialize(&mut source).map_err(|e| {
        let path = e.path().to_string();
        Problem::of(&path, e.inner())
    })?;
    source.end().map_err(|e| Problem::Json(e.to_string()))?;
    Ok(value)
}

fn kind(text: &str) -> Read<Kind> {
    let Head { format: Format::One, kind, .. } = read(text)?;
    Ok(kind)
}

impl Document {
    /// Reads a text.
    ///
    /// # Errors
    /// [`FormulaError`] names the key.
    pub fn parse(text: &str) -> Read<Self> {
        match kind(text)? {
            Kind::Paper => paper(text).map(Self::Section),
            Kind::Global => global(text).map(Self::Section),
            Kind::Universal => universal(text).map(Self::Universal),
        }
    }
}

impl Formula {
    /// Reads a text.
    ///
    /// # Errors
    /// [`FormulaError`] names the key.
    pub fn parse(text: &str) -> Read<Self> {
        match Document::parse(text)? {
            Document::Section(formula) => Ok(formula),
            Document::Universal(_) => Err(other_kind("universal", "paper, global")),
        }
    }

    /// The formula as its file holds it, with a newline at the end. Reading it back gives the same formula to the bit.
    pub fn to_json(&self) -> String {
        text(self)
    }
}

impl UniversalFormula {
    /// Reads a text.
    ///
    /// # Errors
    /// [`FormulaError`] names the key.
    pub fn parse(text: &str) -> Read<Self> {
        match Document::parse(text)? {
            Document::Universal(formula) => Ok(formula),
            Document::Section(f) => Err(other_kind(f.kind(), "universal")),
        }
    }

    /// The formula as its file holds it, with a newline at the end. Reading it back gives the same formula to the bit.
    pub fn to_json(&self) -> String {
        text(self)
    }
}

fn other_kind(given: &str, known: &str) -> FormulaError {
    Problem::Unknown { key: "kind".into(), given: given.into(), known: known.into() }.into()
}

fn section<T>(file: SectionFile<T>, body: Body) -> Formula {
    let SectionFile { name, made_for, range, errors, provenance, .. } = file;
    Formula { name, body, made_for, range, errors, provenance }
}

fn paper(text: &str) -> Read<Formula> {
    let file: SectionFile<PaperTerm> = read(text)?;
    let coefficients = coefficients(&file.terms)?;
    Ok(section(file, Body::Paper(Box::new(coefficients))))
}

fn coefficients(terms: &[PaperTerm]) -> Read<Coefficients> {
    let mut found = [[[None; 3]; 6]; 3];
    for (i, PaperTerm { name, value, .. }) in terms.iter().enumerate() {
        let unknown = || Problem::Unknown {
            key: format!("terms[{i}].name"),
            given: name.chars().take(40).collect(),
            known: "A11 … A63, B11 … B63, C11 … C62".into(),
        };
        let (f, k, j) = place(name).ok_or_else(unknown)?;
        if found[f][k][j].replace(*value).is_some() {
            return Err(Problem::Twice { term: name.clone() }.into());
        }
    }
    let mut x = [[[0.0; 3]; 6]; 3];
    for (f, letter) in ["A", "B", "C"].into_iter().enumerate() {
        for k in 0..6 {
            for j in 0..3 {
                let number = if f == 2 { j } else { j + 1 };
                let optional = f == 2 && j == 0;
                let missing = || Problem::Missing { key: format!("terms: {letter}{}{number}", k + 1) };
                x[f][k][j] = match found[f][k][j] {
                    None if optional => 0.0,
                    found => found.ok_or_else(missing)?,
                };
            }
        }
    }
    let [a, b, c] = x;
    Ok(Coefficients { a, b, c })
}

/// `A11` → family, k, column.
fn place(name: &str) -> Option<(usize, usize, usize)> {
    let letters: Vec<char> = name.chars().collect();
    let [letter, k, number] = letters.as_slice() else { return None };
    let family = ['A', 'B', 'C'].iter().position(|l| l == letter)?;
    let (k, number) = (k.to_digit(10)? as usize, number.to_digit(10)? as usize);
    let column = if family == 2 { number } else { number.checked_sub(1)? };
    ((1..=6).contains(&k) && column < 3).then(|| (family, k - 1, column))
}

fn global(text: &str) -> Read<Formula> {
    let file: SectionFile<GlobalTerm> = read(text)?;
    let scales = file.scales.ok_or_else(|| Problem::Missing { key: "scales".into() })?;
    let mut terms: Vec<Term> = vec![];
    for GlobalTerm { powers, value, .. } in &file.terms {
        let Powers { wall_ratio, pressure, contraction, outer_diameter } = *powers;
        let term = Term { powers: [wall_ratio, pressure, contraction, outer_diameter], value: *value };
        if terms.iter().any(|t| t.powers == term.powers) {
            return Err(Problem::Twice { term: term.name() }.into());
        }
        terms.push(term);
    }
    if terms.is_empty() {
        let message = "expected at least one term".into();
        return Err(Problem::Wrong { key: "terms".into(), message }.into());
    }
    Ok(section(file, Body::Global(GlobalTerms { scales, terms })))
}

fn universal(text: &str) -> Read<UniversalFormula> {
    let UniversalFile { name, form, terms, range, errors, provenance, .. } = read(text)?;
    let deficit = Deficit { form, terms: vec![] };
    let mut formula = UniversalFormula { name, deficit, range, errors, provenance };
    for (i, EndTerm { powers, value, .. }) in terms.into_iter().enumerate() {
        let foreign = || Problem::Wrong {
            key: format!("terms[{i}].powers"),
            message: format!("a variable that the form {form} does not have"),
        };
        let term = UniversalTerm { powers: powers.of_form(form).ok_or_else(foreign)?, value };
        if formula.deficit.terms.iter().any(|t| t.powers == term.powers) {
            return Err(Problem::Twice { term: formula.term_name(&term) }.into());
        }
        formula.deficit.terms.push(term);
    }
    Ok(formula)
}
