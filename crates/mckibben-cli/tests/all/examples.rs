//! Every command that is shown to users works as shown.

use crate::common::{command, copy, names, ran, root, words};
use std::path::Path;

/// Runs a command as shown, `mckibben` and what follows.
fn works(folder: &Path, line: &str) {
    let words = words(line);
    let mut words: Vec<&str> = words.iter().skip(1).map(String::as_str).collect();
    if let ["serve", more @ ..] = &words[..] {
        return crate::serve::works(folder, more);
    }
    // They are run in one folder.
    words.push("--overwrite");
    let result = ran(command(folder).args(words).output().unwrap());
    assert_eq!(result.code, 0, "{line}\n{}", result.err);
}

/// The help of a command and of all commands below it.
fn helps(path: &[String], out: &mut Vec<(String, String)>) {
    // As on a terminal of the usual width: an example must not be wrapped there.
    let mut command = command(&root());
    let help = ran(command
        .args(path)
        .arg("--help")
        .env("COLUMNS", "80")
        .output()
        .unwrap())
    .ok();
    let help = help.text().to_owned();
    if let Some((_, list)) = help.split_once("\nCommands:\n") {
        let names = list.lines().take_while(|l| l.starts_with("  "));
        for name in names
            .filter(|l| !l.starts_with("   "))
            .filter_map(|l| l.split_whitespace().next())
        {
            helps(&[path, &[name.to_owned()]].concat(), out);
        }
    }
    out.push((path.join(" "), help));
}

/// The examples of every command's help.
fn shown_by_help() -> Vec<String> {
    let mut list = vec![];
    helps(&[], &mut list);
    let mut out = vec![];
    for (name, help) in list {
        let text = help.replace("\\\n", "");
        let shown = text
            .lines()
            .filter(|l| l.starts_with("  mckibben "))
            .map(|l| l.trim().to_owned());
        let before = out.len();
        out.extend(shown);
        let parent = help.contains("\nCommands:\n");
        assert!(
            parent || out.len() > before,
            "the help of `{name}` shows no example"
        );
    }
    out
}

#[test]
fn the_commands_in_help_texts_run() {
    let help = shown_by_help();
    assert!(help.len() >= 14, "{} examples", help.len());
    let dir = copy();
    for line in help {
        works(dir.path(), &line);
    }
    for written in ["f.svg", "muscle.svg", "winner.toml"] {
        assert!(dir.path().join(written).is_file(), "{written} is written");
    }
}

/// The folder of every muscle among the examples.
#[test]
fn every_muscle_of_the_examples_can_be_built() {
    let dir = copy();
    let mut built = 0;
    for name in names(&dir.path().join("examples")) {
        let path = dir.path().join("examples").join(&name);
        let text = std::fs::read_to_string(path).unwrap_or_default();
        if name.ends_with(".toml") && text.contains("[tube]") {
            works(
                dir.path(),
                &format!("mckibben build examples/{name} -o folder-{built}"),
            );
            built += 1;
        }
    }
    assert!(built >= 10, "{built}");
}
