//! The width of text: that of the terminal, or of `COLUMNS`; else 100 columns of tables.

use crate::common::{Ran, command, folder, ran, root};

fn with_columns(words: &str, columns: Option<&str>) -> Ran {
    let mut command = command(&root());
    command.args(words.split(' ')).env_remove("COLUMNS");
    if let Some(columns) = columns {
        command.env("COLUMNS", columns);
    }
    ran(command.output().unwrap())
}

fn widest(text: &str) -> usize {
    text.lines().map(|line| line.chars().count()).max().unwrap_or(0)
}

const WIDE: [&str; 9] = [
    "force -p 2.5bar -e 10% --model thick-wall",
    "contraction -p 2.5bar --load mass:20kg --model thick-wall",
    "check -p 2bar --model thick-wall",
    "design -F 700N -e 15% -p 2.5bar --model thick-wall --verify none",
    "design -F 700N -e 15% -p 100bar -D 20,30 -s 1,2 --model thick-wall --verify none",
    "curve isobaric -p 0.5..2.5:0.25bar -e 0..30%:10% --model thick-wall",
    "joint examples/elbow.toml -p 2bar,1bar -p 3bar,1bar --model thick-wall",
    "rubber crates/mckibben-cli/tests/tension/zwick.csv --gauge-length 25mm --area 8mm2",
    "parts show fe",
];

#[test]
fn text_fits_a_terminal_of_80_columns() {
    for words in WIDE {
        let ran = with_columns(words, Some("80"));
        assert!(widest(ran.text()) <= 80, "{words}: {} columns\n{}", widest(ran.text()), ran.text());
    }
}

#[test]
fn tables_in_files_and_pipes_have_at_most_100_columns_and_sentences_one_line() {
    for words in WIDE {
        let ran = with_columns(words, None);
        let wide = ran.text().lines().filter(|line| line.chars().count() > 100);
        // A sentence has no columns: no two blanks stand in it.
        let tables: Vec<&str> = wide.filter(|line| line.trim_start().contains("  ")).collect();
        assert!(tables.is_empty(), "{words}: {tables:#?}");
    }
}

#[test]
fn a_file_is_the_same_whatever_the_terminal() {
    let dir = folder();
    let text = |columns: &str| {
        let path = dir.path().join("out.txt");
        let words = format!("force -p 2.5bar -e 10% --model thick-wall --overwrite -o {}", path.display());
        with_columns(&words, Some(columns)).ok();
        std::fs::read_to_string(path).unwrap()
    };
    assert_eq!(text("60"), text("200"));
}

/// A page shows this command too; it takes long, and is not run again there.
pub const VALIDATE: &str = "validate";

/// No case disappears.
const HELD: [&str; 4] = [
    "verification: 300 of 300 cases hold",
    "measured pulls: 12 of 12 cases hold",
    "other measured quantities: 3 of 3 cases hold",
    "± of fe: 29 of 29 cases hold",
];

/// The one run of all cases of verification and validation.
#[test]
fn every_case_of_validate_holds_and_its_tables_fit_80_columns() {
    let ran = with_columns(VALIDATE, Some("80"));
    let (_, summary) = ran.text().split_once("\nSummary\n").unwrap_or_default();
    assert!(ran.code == 0 && !summary.contains("FAILS"), "{summary}{}", ran.err);
    for held in HELD {
        assert!(summary.contains(held), "{held}: {summary}");
    }
    assert!(widest(ran.text()) <= 80, "{} columns\n{}", widest(ran.text()), ran.text());
}

/// In a terminal: one of 80 columns, made by `script`, which every Linux has.
#[cfg(target_os = "linux")]
#[test]
fn in_a_terminal_no_progress_bar_appears_before_half_a_second() {
    let program = env!("CARGO_BIN_EXE_mckibben");
    let words = "design -F 700N -e 15% -p 2.5bar --model thick-wall --verify none";
    let line = format!("stty rows 24 cols 80; {program} {words}");
    let output = std::process::Command::new("script")
        .args(["-qec", &line, "/dev/null"])
        .current_dir(root())
        .env("TERM", "xterm")
        .env_remove("COLUMNS")
        .output();
    let Ok(output) = output else { return eprintln!("skipped: there is no `script`") };
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("F blocked") && !text.contains("left") && !text.contains("a second"), "{text}");
    let shown = text.lines().map(|line| line.trim_end_matches('\r').replace("\u{1b}[0m", ""));
    assert!(shown.filter(|l| !l.contains('\u{1b}')).all(|l| l.chars().count() <= 80), "{text}");
}
