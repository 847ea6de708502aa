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
    /// One of several.
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
    ///
    /// # Errors
    /// [`Problem`] of kind `usage` in the field.
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

    /// What it is, in words.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::COMMANDS;
    use serde_json::json;

    fn said(command: &str, request: &Value) -> (String, Option<String>) {
        let problem = crate::find(command).unwrap().read(request.clone()).unwrap_err();
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
                let problem = command.read(json!({ name: "1 furlong" })).unwrap_err();
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
        force.read(json!({"pressure_mpa": 0.2, "end_factor": null})).unwrap();
        let (words, _) = said("force", &json!({"pressure_mpa": "é".repeat(100_000)}));
        assert!(words.len() < 200 && words.ends_with("é…\""), "{words}");
    }

    /// What a schema may be: itself, or each of those that it refers to.
    fn kinds<'s>(schema: &'s Value, defs: &'s Value, out: &mut Vec<&'s Value>) {
        if let Some(name) = schema["$ref"].as_str().and_then(|path| path.rsplit('/').next()) {
            return kinds(&defs[name], defs, out);
        }
        match ["anyOf", "oneOf"].iter().find_map(|key| schema[*key].as_array()) {
            Some(list) => list.iter().for_each(|one| kinds(one, defs, out)),
            None => out.push(schema),
        }
    }

    /// Places of a schema that hold an object, or a list of them, as a request with a list there; each with its field.
    fn with_lists(schema: &Value) -> Vec<(String, Value)> {
        let mut out = vec![];
        for (field, own) in schema["properties"].as_object().into_iter().flatten() {
            let mut all = vec![];
            kinds(own, &schema["$defs"], &mut all);
            let takes = |kind: &str| all.iter().any(|k| k["type"].to_string().contains(kind));
            if all.iter().any(|kind| kind["properties"].is_object()) && !takes("array") {
                out.push((field.clone(), json!({ field.as_str(): ["a", "b"] })));
            }
            for items in all.iter().filter_map(|kind| kind.get("items")) {
                let mut inner = vec![];
                kinds(items, &schema["$defs"], &mut inner);
                if inner.iter().any(|kind| kind["properties"].is_object()) {
                    out.push((field.clone(), json!({ field.as_str(): [["a", "b"]] })));
                }
            }
        }
        out
    }

    #[test]
    fn no_command_takes_a_list_for_an_object() {
        let mut asked = 0;
        for command in COMMANDS.iter() {
            for (field, request) in with_lists(&command.schema()["request"]) {
                asked += 1;
                let problem =
                    crate::ask_value(command.name, request.clone(), &mckibben::progress::Silent).unwrap_err();
                let said = format!("{} {request}: {problem} {:?}", command.name, problem.field);
                assert!(
                    problem.kind == ProblemKind::Usage && problem.message.ends_with("not a list"),
                    "{said}"
                );
                assert_eq!(problem.field.as_deref(), Some(field.as_str()), "{said}");
                assert_eq!(command.read(request.clone()).unwrap_err(), problem, "{said}");
            }
        }
        assert!(asked > 50, "{asked}");
    }

    #[test]
    fn lists_and_numbers_are_taken_where_the_schema_has_them() {
        let design = COMMANDS.iter().find(|c| c.name == "design").unwrap();
        for angle in [json!(20.0), json!([20.0, 25.0]), json!({ "low": 20.0, "high": 30.0 })] {
            let request = json!({ "points": [{ "force_n": 300.0, "contraction": 0.1 }], "angle_deg": angle });
            design.read(request).unwrap();
        }
    }
}
