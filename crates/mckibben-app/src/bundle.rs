//! The schemas of all commands.

use crate::{
    COMMANDS, CommandEntry, Problem, find,
    schemas::{root, schema_of},
};
use schemars::generate::Contract;
use serde_json::{Map, Value, json};

/// The JSON Schema of a command: `request`, `answer` and `error`.
pub fn schema(command: &str) -> Result<Value, Problem> {
    Ok(find(command)?.schema())
}

impl CommandEntry {
    /// Its JSON Schema: `request`, `answer` and `error`.
    pub fn schema(&self) -> Value {
        let [answer, error] =
            [self.schemas.answer, root::<Problem>()].map(|of| schema_of(of, Contract::Serialize));
        json!({ "request": self.request_schema(), "answer": answer, "error": error })
    }
}

/// Request, answer and error of every command, and in `$defs`, once, what they refer to: all
/// schemas in one document, for front ends that make their forms, flags or functions of it.
///
/// Beside the keywords of JSON Schema a field has `x-unit` and `x-quantity` (see `annotate`). A measure of the muscle also has its bounds (`minimum`, …), its value where nothing is stated
/// (`default`), `x-symbol`, its short name in formulas, and `x-key`, its key in a muscle file.
pub fn bundle() -> Value {
    let mut all = Map::new();
    let mut defs = Map::new();
    for command in COMMANDS.iter() {
        let mut parts = command.schema();
        for part in parts
            .as_object_mut()
            .into_iter()
            .flat_map(|parts| parts.values_mut())
        {
            let Some(part) = part.as_object_mut() else {
                continue;
            };
            part.remove("$schema");
            if let Some(Value::Object(of_part)) = part.remove("$defs") {
                defs.extend(of_part);
            }
        }
        defs.insert("Problem".into(), parts["error"].take());
        parts["error"] = json!({ "$ref": "#/$defs/Problem" });
        parts["long"] = command.long.into();
        all.insert(command.name.into(), parts);
    }
    all.insert("$defs".into(), defs.into());
    all.into()
}
