//! What the fields of a request hold, from its schema: a field with something else in it is named, with what belongs there and what was given.

use crate::problem::{Problem, ProblemKind};
use serde_json::Value;

/// No request is nested deeper.
const DEEPEST: usize = 8;
/// Longer texts are shortened where they are repeated to their sender.
const LONGEST: usize = 40;

/// What a place of a request holds.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Expected {
    /// A number, in the unit of its field where that has one.
    Number(Option<String>),
    Whole,
    Text,
    Truth,
    List(Box<Self>),
    /// An object with these fields.
    Fields(Vec<(String, Self)>),
    OneOf(Vec<Self>),
    /// What no schema says.
    Any,
}

impl Expected {
    /// What a schema of a request describes.
    pub(crate) fn of(request: &Value) -> Self {
        Self::at(request, &request["$defs"], DEEPEST)
    }

    fn at(schema: &Value, defs: &Value, deeper: usize) -> Self {
        let Some(deeper) = deeper.checked_sub(1) else { return Self::Any };
        let named = |path: &Value| Some(&defs[path.as_str()?.rsplit('/').next()?]);
        if let Some(of) = named(&schema["$ref"]) {
            return Self::at(of, defs, deeper);
        }
        if let Some(list) = ["anyOf", "oneOf"].iter().find_map(|key| schema[*key].as_array()) {
            // A field that may be left out is what it is or null.
            let kinds = list.iter().filter(|of| of["type"] != "null").map(|of| Self::at(of, defs, deeper));
            let mut kinds: Vec<Self> = kinds.collect();
            return match kinds.pop() {
                None => Self::Any,
                Some(one) if kinds.iter().all(|of| *of == one) => one,
                Some(last) => Self::OneOf(kinds.into_iter().chain([last]).collect()),
            };
        }
        let mut types = match &schema["type"] {
            Value::Array(list) => list.iter().filter_map(Value::as_str).filter(|t| *t != "null").collect(),
            one => Vec::from_iter(one.as_str()),
        };
        match types.pop().filter(|_| types.is_empty()) {
            Some("number") => Self::Number(schema["x-unit"].as_str().map(str::to_owned)),
            Some("integer") => Self::Whole,
            Some("string") => Self::Text,
            Some("boolean") => Self::Truth,
            Some("array") => match schema.get("items").map(|items| Self::at(items, defs, deeper)) {
                // The unit of a list is that of its numbers.
                Some(Self::Number(None)) => {
                    Self::List(Box::new(Self::Number(schema["x-unit"].as_str().map(str::to_owned))))
                }
                Some(items) => Self::List(Box::new(items)),
                None => Self::Any,
            },
            Some("object") => {
                let fields = schema["properties"].as_object().into_iter().flatten();
                Self::Fields(fields.map(|(name, of)| (name.clone(), Self::at(of, defs, deeper))).collect())
            }
            _ => Self::Any,
        }
    }

    /// The fields of an object.
    pub(crate) fn fields(&self) -> &[(String, Self)] {
        if let Self::Fields(fields) = self { fields } else { &[] }
    }

    /// Whether a request has in each field what belongs there; what is unknown or missing is not looked at.
    pub(crate) fn check(&self, value: &Value) -> Result<(), Problem> {
        self.within("", value)
    }

    fn within(&self, field: &str, value: &Value) -> Result<(), Problem> {
        match (self, value) {
            (Self::Fields(fields), Value::Object(given)) => {
                return given.iter().try_for_each(|(name, value)| {
                    let known = fields.iter().find(|(known, _)| known == name);
                    known.map_or(Ok(()), |(_, of)| of.within(name, value))
                });
            }
            (Self::List(of), Value::Array(list)) => {
                return list.iter().try_for_each(|value| of.within(field, value));
            }
            (Self::Any, _) | (_, Value::Null) => return Ok(()),
            (Self::Number(_), Value::Number(_)) => return Ok(()),
            (Self::Whole, Value::Number(number)) if !number.is_f64() => return Ok(()),
            (Self::Text, Value::String(_)) | (Self::Truth, Value::Bool(_)) => return Ok(()),
            (Self::OneOf(kinds), _) if kinds.iter().any(|of| of.within(field, value).is_ok()) => {
                return Ok(());
            }
            _ => {}
        }
        let wanted = self.words();
        let given = match value {
            Value::String(text) => {
                let start: String = text.chars().take(LONGEST).collect();
                let more = if start.len() < text.len() { "…" } else { "" };
                format!("the text \"{start}{more}\"")
            }
            Value::Array(_) => "a list".to_owned(),
            Value::Object(_) => "an object of fields".to_owned(),
            number_or_truth => number_or_truth.to_string(),
        };
        let what = if field.is_empty() { "a request".to_owned() } else { format!("`{field}`") };
        let hint = match (self, value) {
            (Self::Number(Some(_)), Value::String(_)) => {
                "give the number alone; its unit is in the name of the field"
            }
            (Self::Number(None) | Self::Whole, Value::String(_)) => "give the number alone",
            (Self::Fields(_), _) if field.is_empty() => "such as {\"pressure_mpa\": 0.2}",
            _ => "",
        };
        let problem = Problem::new(ProblemKind::Usage, format!("{what} is {wanted}, not {given}"), hint);
        Err(if field.is_empty() { problem } else { problem.in_field(field) })
    }

    fn words(&self) -> String {
        match self {
            Self::Number(Some(unit)) => format!("a number in {unit}"),
            Self::Number(None) => "a number without a unit".to_owned(),
            Self::Whole => "a whole number".to_owned(),
            Self::Text => "a text".to_owned(),
            Self::Truth => "true or false".to_owned(),
            Self::List(_) => "a list".to_owned(),
            Self::Fields(_) => "an object of fields".to_owned(),
            Self::OneOf(kinds) => {
                let mut words: Vec<String> = kinds.iter().map(Self::words).collect();
                words.dedup();
                words.join(" or ")
            }
            Self::Any => "a value".to_owned(),
        }
    }
}
