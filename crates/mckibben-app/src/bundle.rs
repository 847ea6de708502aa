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

#[cfg(test)]
mod tests {
    use super::*;

    /// What lets definitions of all commands be in one list.
    #[test]
    fn definitions_of_one_name_are_one() {
        let defs = bundle()["$defs"].take();
        for command in COMMANDS.iter() {
            for part in command.schema().as_object_mut().unwrap().values_mut() {
                for (name, own) in
                    part["$defs"].as_object().into_iter().flatten().filter(|d| d.0 != "Problem")
                {
                    assert_eq!(own, &defs[name], "{}: {name}", command.name);
                }
            }
        }
    }

    #[test]
    fn measures_have_what_a_form_needs() {
        let all = bundle();
        let fields = &all["force"]["request"]["properties"];
        let wall = json!({
            "description": "Wall thickness s of the tube at rest, mm.", "type": ["number", "null"], "format": "double",
            "x-group": "muscle", "x-key": "tube.wall_thickness", "x-symbol": "s", "x-quantity": "length", "x-unit": "mm",
            "exclusiveMinimum": 0.0, "default": 3.0,
        });
        assert_eq!(fields["wall_mm"], wall);
        assert_eq!(
            (&fields["seating_mm"]["minimum"], &fields["seating_mm"]["default"]),
            (&json!(0.0), &json!(0.0))
        );
        assert_eq!(
            (&fields["prestretch"]["minimum"], &fields["prestretch"]["maximum"]),
            (&json!(0.5), &json!(2.0))
        );
        assert!(fields["prestretch"].get("x-unit").is_none());
        assert_eq!(
            (&fields["rubber"]["x-group"], &fields["mesh"]["x-group"]),
            (&json!("muscle"), &json!("model"))
        );
        assert!(fields["pressure_mpa"].get("x-group").is_none());
    }
}
