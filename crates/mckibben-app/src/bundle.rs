//! All schemas in one document, for front ends that make their forms, flags or functions of it.
//!
//! Beside the keywords of JSON Schema a field has `x-unit` and `x-quantity` (see `annotate`) and `x-group`, the group of fields to which it
//! belongs in a form or a help text: `muscle`, `model`. A measure of the muscle also has its bounds (`minimum`, …), its value where nothing
//! is stated (`default`), `x-symbol`, its short name in formulas, and `x-key`, its key in a muscle file.

use crate::commands::COMMANDS;
use serde_json::{Map, Value, json};

/// Request, answer and error of every command, and in `$defs`, once, what they refer to.
pub fn bundle() -> Value {
    let (mut all, mut defs) = (Map::new(), Map::new());
    for command in COMMANDS.iter() {
        let mut parts = command.schema();
        for part in parts.as_object_mut().into_iter().flat_map(|parts| parts.values_mut()) {
            let Some(part) = part.as_object_mut() else { continue };
            part.remove("$schema");
            if let Some(Value::Object(own)) = part.remove("$defs") {
                defs.extend(own);
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
