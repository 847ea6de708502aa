//! Help: what is said first, in which groups, on how many lines.

use super::command;
use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
};

/// What a flag of help prints in a terminal of 80 columns.
fn at_80(words: &str) -> String {
    let words = std::iter::once("mckibben").chain(words.split(' '));
    let shown = command().term_width(80).try_get_matches_from(words);
    shown.unwrap_err().render().to_string()
}

fn headings(help: &str) -> Vec<&str> {
    let known = ["Question", "Limits", "Muscle", "Advanced", "Output"];
    let lines = help.lines().filter_map(|line| line.strip_suffix(':'));
    lines.filter(|line| known.contains(line)).collect()
}

/// What flags exclude and require exists, and no two have one name.
#[test]
fn flags_agree_with_each_other() {
    command().debug_assert();
}

#[test]
fn the_short_help_of_force_pressure_and_contraction_fits_a_screen_of_40_lines() {
    for name in ["force", "pressure", "contraction"] {
        let help = at_80(&format!("{name} -h"));
        let lines = help.lines().count();
        assert!(lines <= 40, "{name}: {lines} lines\n{help}");
        assert!(
            help.lines().all(|line| line.chars().count() <= 80),
            "{help}"
        );
        assert_eq!(
            headings(&help),
            ["Question", "Muscle", "Advanced", "Output"],
            "{help}"
        );
        let more = format!("All flags, with details: mckibben {name} --help");
        assert!(help.contains(&more), "{help}");
        let before = help.split("\nMuscle:").next().unwrap();
        assert!(
            before.contains("-e, --contraction") || name == "contraction",
            "{help}"
        );
    }
}

#[test]
fn the_long_help_has_every_flag_in_the_same_groups() {
    const USUAL: [&str; 4] = ["Question", "Muscle", "Advanced", "Output"];
    const LIMITED: [&str; 5] = ["Question", "Limits", "Muscle", "Advanced", "Output"];
    const OF_FILES: [&str; 3] = ["Question", "Advanced", "Output"];
    for (name, groups) in [
        ("force", &USUAL[..]),
        ("curve", &USUAL),
        ("design", &LIMITED),
        ("simulate", &USUAL),
        ("compare", &USUAL),
        ("identify", &USUAL),
        ("rubber", &USUAL),
        ("fit", &["Question", "Output"]),
        ("joint", &OF_FILES),
        ("motion", &OF_FILES),
    ] {
        let help = at_80(&format!("{name} --help"));
        assert_eq!(headings(&help), groups, "{name}: {help}");
        let short = at_80(&format!("{name} -h"));
        assert!(short.lines().count() < help.lines().count(), "{name}");
        let words = short.split_whitespace();
        for flag in words.filter(|word| word.starts_with("--")) {
            assert!(help.contains(flag.trim_end_matches(',')), "{name}: {flag}");
        }
    }
}

fn flags(text: &str) -> BTreeSet<String> {
    let words = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '-'));
    words
        .filter(|word| word.starts_with("--"))
        .map(str::to_owned)
        .collect()
}

/// The long help of a command and of those below it.
fn helps(command: &mut clap::Command) -> String {
    let own = command.render_long_help().to_string();
    let below = command.get_subcommands_mut().map(helps);
    own + &below.collect::<String>()
}

/// What the pages say in `--flag` is a flag of a command, if it is not one of another program.
#[test]
fn flags_of_the_pages_exist() {
    /// Lines of other programs and of scripts of this repository.
    const OTHERS: [&str; 6] = ["cargo ", "checks/", "web/", "mypy ", "rustc ", "taplo "];
    let mut all = command();
    all.build();
    let known = flags(&helps(&mut all));
    assert!(
        known.contains("--relaxation") && known.len() > 100,
        "{known:?}"
    );
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let pages = std::fs::read_dir(docs)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let is_page = |path: &PathBuf| path.extension().is_some_and(|end| end == "md");
    let mut unknown = vec![];
    for path in pages.filter(is_page) {
        let text = std::fs::read_to_string(&path).unwrap();
        // Code in sentences and tables; blocks run in tests of their own.
        let outside = text.split("\n```").step_by(2);
        let code = outside.flat_map(|part| part.split('`').skip(1).step_by(2));
        let own = code.filter(|code| !OTHERS.iter().any(|other| code.contains(other)));
        for flag in own.flat_map(flags) {
            if !known.contains(&flag) {
                unknown.push(format!("{}: {flag}", path.display()));
            }
        }
    }
    assert!(unknown.is_empty(), "{unknown:#?}");
}

/// What every command writes, and where (`tests/all/files.rs`): command, flag with its file or
/// folder, and the file that is in its way.
const WRITERS: &str = include_str!("../../tests/rows/writers.tsv");

/// Flags with a file or folder that is read.
const READ: [&str; 16] = [
    "log", "data", "columns", "muscle", "parts", "model", "models", "formula", "rubber", "rubbers",
    "load", "braid", "tube", "tubes", "samples", "terms",
];

/// The flags of a command and of those below it that name a file or folder.
fn with_files(path: &str, command: &clap::Command, out: &mut Vec<(String, String)>) {
    for arg in command.get_arguments() {
        let names = arg.get_value_names().unwrap_or_default().iter();
        let is_file = names
            .into_iter()
            .any(|name| name.contains("FILE") || name.contains("DIR"));
        let flag = arg
            .get_long()
            .filter(|flag| is_file && !READ.contains(flag));
        out.extend(flag.map(|flag| (path.to_owned(), flag.to_owned())));
    }
    for below in command.get_subcommands() {
        let path = format!("{path} {}", below.get_name());
        with_files(path.trim_start(), below, out);
    }
}

#[test]
fn no_flag_that_names_an_output_is_missing_from_the_test_of_outputs() {
    let writers: Vec<Vec<&str>> = WRITERS
        .lines()
        .map(|line| line.split('\t').collect())
        .collect();
    let mut all = command();
    all.build();
    let mut flags = vec![];
    with_files("", &all, &mut flags);
    assert!(flags.len() > 30, "{flags:?}");
    for (command, flag) in flags {
        let typed = match &*flag {
            "output" => "-o ".to_owned(),
            flag => format!("--{flag} "),
        };
        // Figures are of all commands alike, and a campaign has a separate test.
        let once = flag.starts_with("plot") || command == "campaign";
        let has =
            |row: &Vec<&str>| (once || row[0].starts_with(&command)) && row[1].starts_with(&typed);
        assert!(writers.iter().any(has), "{command} --{flag}");
    }
}
