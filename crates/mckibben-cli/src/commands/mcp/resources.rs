//! Resources: help of the commands, example files, schemas of files.

use super::messages::{PARAMS, Wrong};
use crate::commands::help::{helps, long_help};
use clap::Command;
use mckibben_app::{file_kinds, file_schema};
use serde_json::{Value, json};

const HELP: &str = "mckibben://help/";
const EXAMPLE: &str = "mckibben://examples/";
const SCHEMA: &str = "mckibben://schema/";

pub fn list(root: &Command) -> Vec<Value> {
    let help = helps(root).into_iter().map(|(name, about)| entry(HELP, &name, &about, "text/plain"));
    let examples = mckibben_web::paths()
        .filter_map(|path| path.strip_prefix("examples/").map(str::to_owned))
        .filter(|name| !name.contains('/'))
        .map(|name| entry(EXAMPLE, &name, "Example file", kind_of(&name)));
    let schemas = file_kinds()
        .map(|kind| entry(SCHEMA, kind, &format!("JSON Schema of a {kind} file"), "application/schema+json"));
    help.chain(examples).chain(schemas).collect()
}

fn entry(prefix: &str, name: &str, about: &str, kind: &str) -> Value {
    let uri = format!("{prefix}{}", name.replace(' ', "-"));
    json!({ "uri": uri, "name": name, "description": about, "mimeType": kind })
}

fn kind_of(name: &str) -> &'static str {
    match name.rsplit('.').next() {
        Some("toml") => "application/toml",
        Some("csv") => "text/csv",
        _ => "text/plain",
    }
}

pub fn read(params: &Value, root: &Command) -> Result<Value, Wrong> {
    let uri = params["uri"].as_str().unwrap_or_default();
    let found = None
        .or_else(|| Some((long_help(root, &uri.strip_prefix(HELP)?.replace('-', " "))?, "text/plain")))
        .or_else(|| {
            let name = uri.strip_prefix(EXAMPLE)?;
            let bytes = mckibben_web::file(&format!("examples/{name}"))?;
            Some((String::from_utf8(bytes.into_owned()).ok()?, kind_of(name)))
        })
        .or_else(|| {
            let schema = file_schema(uri.strip_prefix(SCHEMA)?).ok()?;
            Some((format!("{schema:#}\n"), "application/schema+json"))
        });
    let Some((text, kind)) = found else {
        let shown: String = uri.chars().take(120).collect();
        return Err((PARAMS, format!("there is no resource \"{shown}\"; resources/list names all")));
    };
    Ok(json!({ "contents": [{ "uri": uri, "mimeType": kind, "text": text }] }))
}
