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
    /// A whole number.
    Whole,
    /// A text.
    Text,
    /// True or false.
    Truth,
    /// A list.
    List(Box<Self>),
    /// An object with these fields.
    Fields(Vec<(String, Self)>),
    /// One of several, or what no schema says.
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
        // A field that may be left out is what it is or null.
        let there = |list: &[Value], null: &dyn Fn(&Value) -> bool| {
            let mut rest: Vec<Value> = list.iter().filter(|v| !null(v)).cloned().collect();
            rest.pop().filter(|_| rest.is_empty())
        };
        if let Some(list) = schema["anyOf"].as_array() {
            let one = there(list, &|v| v["type"] == "null");
            return one.map_or(Self::Any, |of| Self::at(&of, defs, deeper));
        }
        let kind = match &schema["type"] {
            Value::Array(list) => there(list, &|v| v == "null"),
            one => Some(one.clone()),
        };
        match kind.as_ref().and_then(Value::as_str) {
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
    ///
    /// # Errors
    /// [`Problem`] of kind `usage` in the field.
    pub(crate) fn check(&self, value: &Value) -> Result<(), Problem> {
        self.within("", value)
    }

    fn within(&self, field: &str, value: &Value) -> Result<(), Problem> {
        let wanted = match (self, value) {
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
            (Self::Number(Some(unit)), _) => format!("a number in {unit}"),
            (Self::Number(None), _) => "a number without a unit".to_owned(),
            (Self::Whole, _) => "a whole number".to_owned(),
            (Self::Text, _) => "a text".to_owned(),
            (Self::Truth, _) => "true or false".to_owned(),
            (Self::List(_), _) => "a list".to_owned(),
            (Self::Fields(_), _) => "an object of fields".to_owned(),
        };
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
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn said(command: &str, request: &Value) -> (String, Option<String>) {
        let problem = crate::find(command).unwrap().check(request).unwrap_err();
        assert_eq!(problem.kind, ProblemKind::Usage);
        (problem.message, problem.field)
    }

    #[test]
    fn what_a_field_wants_and_what_was_given_are_said() {
        for (command, request, words, field) in [
            (
                "force",
                json!({"end_factor": "1 mm"}),
                "`end_factor` is a number without a unit, not the text \"1 mm\"",
                "end_factor",
            ),
            (
                "force",
                json!({"pressure_mpa": "2bar"}),
                "`pressure_mpa` is a number in MPa, not the text \"2bar\"",
                "pressure_mpa",
            ),
            (
                "force",
                json!({"pressure_mpa": true}),
                "`pressure_mpa` is a number in MPa, not true",
                "pressure_mpa",
            ),
            ("force", json!({"pressure_mpa": 0.2, "model": 5}), "`model` is a text, not 5", "model"),
            (
                "curve",
                json!({"pressures_mpa": [0.1, "x"]}),
                "`pressures_mpa` is a number in MPa, not the text \"x\"",
                "pressures_mpa",
            ),
            ("curve", json!({"pressures_mpa": 0.1}), "`pressures_mpa` is a list, not 0.1", "pressures_mpa"),
            ("design", json!({"top": 1.5}), "`top` is a whole number, not 1.5", "top"),
            (
                "design",
                json!({"tolerance": {"modulus": "5 %"}}),
                "`modulus` is a number without a unit, not the text \"5 %\"",
                "modulus",
            ),
        ] {
            assert_eq!(said(command, &request), (words.to_owned(), Some(field.to_owned())), "{request}");
        }
        assert_eq!(said("force", &json!([])).0, "a request is an object of fields, not a list");
    }

    /// A number's place in any request refuses a text in these words, not in those of a parser.
    #[test]
    fn every_number_of_every_request_refuses_a_text_by_its_name() {
        let mut seen = 0;
        for command in crate::COMMANDS.iter() {
            let expected = Expected::of(&command.schema()["request"]);
            for (name, of) in expected.fields() {
                if !matches!(of, Expected::Number(_) | Expected::Whole) {
                    continue;
                }
                let problem = command.check(&json!({ name: "1 furlong" })).unwrap_err();
                assert_eq!(problem.field.as_ref(), Some(name), "{}", command.name);
                assert!(problem.message.ends_with("not the text \"1 furlong\""), "{problem}");
                seen += 1;
            }
        }
        assert!(seen > 150, "{seen}");
    }

    #[test]
    fn null_is_what_was_left_out_and_long_texts_are_shortened() {
        let force = crate::find("force").unwrap();
        assert_eq!(force.check(&json!({"pressure_mpa": 0.2, "end_factor": null})), Ok(()));
        let (words, _) = said("force", &json!({"pressure_mpa": "é".repeat(100_000)}));
        assert!(words.len() < 200 && words.ends_with("é…\""), "{words}");
    }
}
