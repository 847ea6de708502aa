//! Flags that take the name of something, or more than the names: completion offers the names, and what else is typed is judged by
//! whoever reads it.

use clap::builder::{PossibleValue, StringValueParser, TypedValueParser};
use clap::{Arg, Command, error::Error};
use mckibben::{rubber, sleeve};
use mckibben_app::{ExportListRequest, Model, export_list};
use mckibben_fit::{rubber::Form, validation::library};
use std::ffi::OsStr;

/// A text, for which there are names.
#[derive(Debug, Clone, Copy)]
pub struct Names(fn() -> Vec<String>);

pub const MODELS: Names = Names(|| Model::all().into_iter().map(|m| m.name.to_string()).collect());
pub const TARGETS: Names = Names(|| {
    export_list(&ExportListRequest {})
        .map(|all| all.targets.into_iter().map(|t| t.name.to_owned()).collect())
        .unwrap_or_default()
});
/// Rubbers of the library.
pub const RUBBERS: Names =
    Names(|| rubber::library::entries().unwrap_or_default().iter().map(|e| e.name.clone()).collect());
/// Sleeves of the library.
pub const SLEEVES: Names = Names(|| {
    sleeve::library::entries().unwrap_or_default().iter().map(|e| e.sleeve.shape.name.clone()).collect()
});
/// Laws of rubbers.
pub const LAWS: Names = Names(|| Form::words().into_iter().chain(["all".to_owned()]).collect());
/// Everything with a name.
pub const NAMES: Names = Names(|| {
    let tubes = mckibben_design::tubes::catalogue().unwrap_or_default().iter().map(|t| t.name.clone());
    let lists = [SLEEVES, RUBBERS, MODELS].into_iter().flat_map(|names| (names.0)());
    tubes.chain(lists).chain(library::names()).collect()
});

/// The names for a flag.
pub fn of(flag: &str) -> Option<Names> {
    Some(match flag {
        "model" | "models" => MODELS,
        "target" => TARGETS,
        "rubber" | "rubbers" => RUBBERS,
        "braid" | "braids" => SLEEVES,
        "laws" => LAWS,
        "any" => NAMES,
        _ => return None,
    })
}

impl TypedValueParser for Names {
    type Value = String;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<String, Error> {
        StringValueParser::new().parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new((self.0)().into_iter().map(PossibleValue::new)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn completion_knows_the_names_and_parsing_takes_more() {
        for (names, one) in [
            (MODELS, "thick-wall"),
            (TARGETS, "opensim"),
            (RUBBERS, "dragon-skin-30"),
            (SLEEVES, "s-muscle-20"),
            (NAMES, "dmsp-20-300"),
        ] {
            assert!(names.possible_values().unwrap().any(|v| v.get_name() == one), "{one}");
            let parsed = names.parse_ref(&Command::new("mckibben"), None, OsStr::new("formula.json"));
            assert_eq!(parsed.unwrap(), "formula.json");
        }
    }
}
