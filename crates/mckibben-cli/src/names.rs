//! Flags that take the name of something, or more than the names: completion offers the names, and
//! what else is typed is judged by whoever reads it.

use clap::builder::{PossibleValue, StringValueParser, TypedValueParser};
use clap::{Arg, Command, error::Error};
use mckibben::{rubber, sleeve};
use mckibben_app::{ExportListRequest, Model, export_list};
use mckibben_fit::{rubber::Form, validation::library};
use std::ffi::OsStr;

/// A text, for which there are names.
#[derive(Debug, Clone)]
pub struct Names(Vec<String>);

/// The names for a flag.
pub fn for_flag(flag: &str) -> Option<Names> {
    Some(Names(match flag {
        "model" | "models" => Model::all()
            .into_iter()
            .map(|m| m.name.to_owned())
            .collect(),
        "target" => {
            let all = export_list(&ExportListRequest {}).ok()?;
            all.targets.iter().map(|t| t.name.to_owned()).collect()
        }
        "rubber" | "rubbers" => rubber::library::entries()
            .ok()?
            .iter()
            .map(|e| e.name.clone())
            .collect(),
        "braid" | "braids" => sleeve::library::entries()
            .ok()?
            .iter()
            .map(|e| e.sleeve.shape.name.clone())
            .collect(),
        "laws" => Form::words()
            .into_iter()
            .chain(["all".to_owned()])
            .collect(),
        // Everything with a name.
        "any" => {
            let tubes = mckibben_design::tubes::catalogue()
                .ok()?
                .iter()
                .map(|t| t.name.clone());
            let lists = ["braid", "rubber", "model"]
                .into_iter()
                .filter_map(for_flag)
                .flat_map(|names| names.0);
            tubes.chain(lists).chain(library::names()).collect()
        }
        _ => return None,
    }))
}

impl TypedValueParser for Names {
    type Value = String;

    fn parse_ref(
        &self,
        command: &Command,
        arg: Option<&Arg>,
        value: &OsStr,
    ) -> Result<String, Error> {
        StringValueParser::new().parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(self.0.iter().map(PossibleValue::new)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn completion_knows_the_names_and_parsing_takes_more() {
        for (flag, one) in [
            ("model", "thick-wall"),
            ("target", "opensim"),
            ("rubber", "dragon-skin-30"),
            ("braid", "s-muscle-20"),
            ("any", "dmsp-20-300"),
        ] {
            let names = for_flag(flag).unwrap();
            assert!(
                names
                    .possible_values()
                    .unwrap()
                    .any(|v| v.get_name() == one),
                "{one}"
            );
            let parsed =
                names.parse_ref(&Command::new("mckibben"), None, OsStr::new("formula.json"));
            assert_eq!(parsed.unwrap(), "formula.json");
        }
    }
}
