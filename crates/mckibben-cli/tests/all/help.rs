//! Help and manual pages: what is said first, and on how many lines.

use crate::common::{command, folder, mckibben, names, ran, root, run_in};
use std::path::Path;

/// What a command prints in a terminal of 80 columns.
fn at_80(words: &str) -> String {
    let output = command(&root())
        .args(words.split(' '))
        .env("COLUMNS", "80")
        .output()
        .unwrap();
    ran(output).ok().text().to_owned()
}

fn headings(help: &str) -> Vec<&str> {
    let known = ["Question", "Limits", "Muscle", "Advanced", "Output"];
    let lines = help.lines().filter_map(|line| line.strip_suffix(':'));
    lines.filter(|line| known.contains(line)).collect()
}

#[test]
fn the_short_help_of_force_pressure_and_contraction_fits_a_screen_of_40_lines() {
    for name in ["force", "pressure", "contraction"] {
        let help = at_80(&format!("{name} -h"));
        assert!(
            help.lines().count() <= 40,
            "{name}: {} lines\n{help}",
            help.lines().count()
        );
        assert!(
            help.lines().all(|line| line.chars().count() <= 80),
            "{help}"
        );
        assert_eq!(
            headings(&help),
            ["Question", "Muscle", "Advanced", "Output"],
            "{help}"
        );
        assert!(
            help.contains(&format!("All flags, with details: mckibben {name} --help")),
            "{help}"
        );
        let before = help.split("\nMuscle:").next().unwrap();
        assert!(
            before.contains("-e, --contraction") || name == "contraction",
            "{help}"
        );
    }
}

#[test]
fn the_long_help_has_every_flag_in_the_same_groups() {
    for (name, groups) in [
        ("force", &["Question", "Muscle", "Advanced", "Output"][..]),
        ("curve", &["Question", "Muscle", "Advanced", "Output"]),
        (
            "design",
            &["Question", "Limits", "Muscle", "Advanced", "Output"],
        ),
        ("simulate", &["Question", "Muscle", "Advanced", "Output"]),
        ("compare", &["Question", "Muscle", "Advanced", "Output"]),
        ("identify", &["Question", "Muscle", "Advanced", "Output"]),
        ("rubber", &["Question", "Muscle", "Advanced", "Output"]),
        ("fit", &["Question", "Output"]),
        ("joint", &["Question", "Advanced", "Output"]),
        ("motion", &["Question", "Advanced", "Output"]),
    ] {
        let help = at_80(&format!("{name} --help"));
        assert_eq!(headings(&help), groups, "{name}: {help}");
        let short = at_80(&format!("{name} -h"));
        assert!(short.lines().count() < help.lines().count(), "{name}");
        for flag in short
            .split_whitespace()
            .filter(|word| word.starts_with("--"))
        {
            assert!(help.contains(flag.trim_end_matches(',')), "{name}: {flag}");
        }
    }
}

#[test]
fn help_and_a_command_print_the_help_of_the_command() {
    for name in ["force", "parts show", "rubber"] {
        assert_eq!(
            at_80(&format!("help {name}")),
            at_80(&format!("{name} --help")),
            "{name}"
        );
    }
    assert_eq!(at_80("help"), at_80("--help"));
}

#[test]
fn every_command_has_a_manual_page_that_is_not_written_over_an_older_one() {
    let dir = folder();
    let man = |dir: &Path| run_in(dir, "man -o man1");
    man(dir.path()).ok();
    let names = names(&dir.path().join("man1"));
    assert!(
        names.len() > 20 && names.contains(&"mckibben.1".into()),
        "{names:?}"
    );
    assert!(names.contains(&"mckibben-parts-show.1".into()), "{names:?}");
    let page = std::fs::read_to_string(dir.path().join("man1/mckibben-force.1")).unwrap();
    for part in [
        ".SH QUESTION",
        ".SH MUSCLE",
        ".SH ADVANCED",
        ".SH EXAMPLES",
        "mckibben force \\-D 50",
        "Any key of a muscle file",
        "Muscle file, same as",
    ] {
        assert!(page.contains(part), "{part}: {page}");
    }
    assert_eq!(mckibben("man force").ok().text(), page);
    assert_eq!(man(dir.path()).code, 2);
}

/// What the pages say in `--flag` is a flag of a command, if it is not one of another program.
#[test]
fn flags_of_the_pages_exist() {
    /// Lines of other programs and of scripts of this repository.
    const OTHERS: [&str; 5] = ["cargo ", "checks/", "web/", "mypy ", "rustc "];
    let dir = folder();
    run_in(dir.path(), "man -o man1").ok();
    let man: String = names(&dir.path().join("man1"))
        .iter()
        .map(|name| std::fs::read_to_string(dir.path().join("man1").join(name)).unwrap())
        .collect();
    let man = man.replace("\\-", "-").replace("\\fB", " ");
    let flags = |text: &str| -> std::collections::BTreeSet<String> {
        let words = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '-'));
        words
            .filter(|word| word.starts_with("--"))
            .map(str::to_owned)
            .collect()
    };
    let known = flags(&man);
    assert!(
        known.contains("--relaxation") && known.len() > 100,
        "{known:?}"
    );
    let mut unknown = vec![];
    for entry in std::fs::read_dir(root().join("docs")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|end| end != "md") {
            continue;
        }
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
