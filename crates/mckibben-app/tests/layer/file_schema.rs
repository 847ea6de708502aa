//! Schemas of files.

use mckibben::joint::parse_joint;
use mckibben::muscle::file::{FileError, parse_muscle};
use mckibben_app::file_schema;
use mckibben_motion::{Tables, parse_drive};
use serde_json::Value;

/// The keys that a reader accepts in a table, from what it says of one that is not among them.
fn accepted(error: &FileError) -> Vec<String> {
    let said = error.to_string();
    let known = said.split_once("known here: ").unwrap_or_else(|| panic!("{said}")).1;
    known.split(", ").map(str::to_owned).collect()
}

fn sorted(mut keys: Vec<String>) -> Vec<String> {
    keys.sort();
    keys
}

/// Keys of the schema at a path of tables.
fn keys(schema: &Value, path: &[&str]) -> Vec<String> {
    let table = path.iter().fold(schema, |table, key| &table["properties"][*key]);
    table["properties"].as_object().unwrap_or_else(|| panic!("{path:?}")).keys().cloned().collect()
}

/// An identity: every table of every schema has the keys that the reader accepts there, no more and no fewer.
#[test]
fn keys_of_schemas_are_those_that_readers_accept() {
    type Read = fn(&str) -> Option<FileError>;
    let muscle: Read = |text| parse_muscle(text).err();
    let joint: Read = |text| parse_joint(text).err();
    let drive: Read = |text| parse_drive(text, &Tables::default()).err();
    let head = "muscle = 'm.toml'\n[valve]\nsonic_conductance = '0.5 L/(s bar)'\n";
    let of_joint = "[joint]\nradius = '25 mm'\n[muscle_1]\nfile = 'm.toml'\n";
    let command = "[command]\npressure = '3 bar'\nuntil = '1 s'\n";
    let checks: Vec<(&str, Read, Vec<&str>, String)> = vec![
        ("muscle", muscle, vec![], "zzz = 1\n".into()),
        ("muscle", muscle, vec!["tube"], "[tube]\nzzz = 1\n".into()),
        ("muscle", muscle, vec!["braid"], "[braid]\nzzz = 1\n".into()),
        ("muscle", muscle, vec!["terminals"], "[terminals]\nzzz = 1\n".into()),
        ("muscle", muscle, vec!["friction"], "[friction]\nzzz = 1\n".into()),
        ("muscle", muscle, vec!["model"], "[model]\nzzz = 1\n".into()),
        ("muscle", muscle, vec!["identified"], "[identified]\nzzz = 1\n".into()),
        ("joint", joint, vec![], "zzz = 1\n".into()),
        ("joint", joint, vec!["joint"], "[joint]\nzzz = 1\n".into()),
        ("joint", joint, vec!["muscle_1"], "[muscle_1]\nzzz = 1\n".into()),
        ("joint", joint, vec!["spring"], format!("{of_joint}[spring]\nzzz = 1\n")),
        ("joint", joint, vec!["link"], format!("{of_joint}[link]\nzzz = 1\n")),
        ("drive", drive, vec![], format!("zzz = 1\n{head}{command}")),
        ("drive", drive, vec!["supply"], format!("{head}{command}[supply]\nzzz = 1\n")),
        ("drive", drive, vec!["valve"], format!("{head}zzz = 1\n{command}")),
        ("drive", drive, vec!["air"], format!("{head}{command}[air]\nzzz = 1\n")),
        ("drive", drive, vec!["load"], format!("{head}{command}[load]\nzzz = 1\n")),
        ("drive", drive, vec!["friction"], format!("{head}{command}[friction]\nzzz = 1\n")),
        ("drive", drive, vec!["rubber"], format!("{head}{command}[rubber]\nzzz = 1\n")),
        ("drive", drive, vec!["command"], format!("{head}{command}zzz = 1\n")),
        ("drive", drive, vec!["controller"], format!("{head}{command}[controller]\nzzz = 1\n")),
    ];
    for (kind, read, path, text) in checks {
        let error = read(&text).unwrap_or_else(|| panic!("{text} is accepted"));
        assert_eq!(
            sorted(keys(&file_schema(kind).unwrap(), &path)),
            sorted(accepted(&error)),
            "{kind} {path:?}"
        );
    }
}

/// The same of plans, whose tables begin with those of a muscle.
#[test]
fn keys_of_plans_are_those_that_the_reader_accepts() {
    let plan = file_schema("plan").unwrap();
    let test = "[test]\ncontractions = '0'\npressures = '0.1'\n";
    for (path, text) in [
        (vec![], format!("zzz = 1\n{test}")),
        (vec!["sampling"], format!("{test}[sampling]\nzzz = 1\n")),
        (vec!["test"], format!("{test}zzz = 1\n")),
        (vec!["vary"], format!("{test}[vary]\nzzz = 1\n")),
        (vec!["vary", "tube"], format!("{test}[vary.tube]\nzzz = 1\n")),
        (vec!["vary", "tube", "material"], format!("{test}[vary.tube.material]\nzzz = 1\n")),
        (vec!["vary", "braid"], format!("{test}[vary.braid]\nzzz = 1\n")),
        (vec!["vary", "terminals"], format!("{test}[vary.terminals]\nzzz = 1\n")),
        (vec!["vary", "friction"], format!("{test}[vary.friction]\nzzz = 1\n")),
    ] {
        let error = mckibben_campaign::campaign::Plan::parse(&text).unwrap_err();
        assert_eq!(sorted(keys(&plan, &path)), sorted(accepted(&error)), "{path:?}");
    }
}

/// Every law can be written with the keys of the schema, and the schema asks for its constants.
#[test]
fn a_law_needs_its_constants_and_every_law_is_named() {
    let material = &file_schema("muscle").unwrap()["properties"]["tube"]["properties"]["material"];
    let names = mckibben::rubber::Law::names();
    assert_eq!(material["properties"]["law"]["enum"].as_array().unwrap().len(), names.len());
    for (name, rule) in names.iter().zip(material["allOf"].as_array().unwrap()) {
        assert_eq!(rule["if"]["properties"]["law"]["const"], *name);
        for constant in rule["then"]["required"].as_array().unwrap() {
            assert!(material["properties"].get(constant.as_str().unwrap()).is_some(), "{name}: {constant}");
        }
    }
}

#[test]
fn a_kind_that_is_not_there_is_named_with_the_nearest() {
    let problem = file_schema("muscel").unwrap_err();
    assert_eq!(problem.hint, "did you mean muscle?");
}
