//! Files as they should not be: devices, pipes, holes of twenty gigabytes, changed formulas, other people's work at `-o`, names that
//! steer a terminal.
#![cfg(unix)]

use crate::common::{Ran, folder, ran, root, run_in};
use serde_json::Value;
use std::fs::{self, File};
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::Path;
use std::process::{Command, Stdio};
use tempfile::TempDir;

/// Runs a line in a folder with four gigabytes of addresses, and no more.
fn bounded(dir: &Path, line: &str) -> Ran {
    let program = env!("CARGO_BIN_EXE_mckibben");
    let script = format!("ulimit -v 4000000 && exec {program} {line}");
    let mut command = Command::new("sh");
    command.args(["-c", &script]).current_dir(dir).stdin(Stdio::null()).env_remove("RUST_BACKTRACE");
    ran(command.output().unwrap())
}

/// Commands that read a file of the name X.
const READERS: [&str; 10] = [
    "fit X.csv",
    "fit X.parquet",
    "fit X.parquet --method universal",
    "check X.json",
    "force -p 0.1 -e 0.1 --model X.json",
    "campaign show X.parquet",
    "campaign X.toml -o out.parquet",
    "compare --data X.csv",
    "identify --data X.csv",
    "rubber X.csv",
];

fn are_refused(dir: &Path, name: &str, says: &str) {
    for line in READERS {
        let result = bounded(dir, &format!("{} --format json", line.replace('X', name)));
        assert_eq!(result.code, 2, "{line}: {}", result.err);
        let error = result.error();
        let message = error["message"].as_str().unwrap();
        assert!(message.contains(says), "{line}: {message}");
        // The message does not advise to remove a file that the system refused to read.
        assert!(!error["hint"].as_str().unwrap().contains("remove"), "{line}: {error}");
    }
}

#[test]
fn what_is_no_regular_file_is_refused_at_once() {
    let dir = folder();
    for ending in ["csv", "parquet", "json", "toml"] {
        let at = |name: &str| dir.path().join(format!("{name}.{ending}"));
        symlink("/dev/zero", at("zero")).unwrap();
        assert!(Command::new("mkfifo").arg(at("pipe")).status().unwrap().success());
        symlink("nowhere", at("dangling")).unwrap();
    }
    are_refused(dir.path(), "zero", "is a device or a pipe; it must be a regular file");
    are_refused(dir.path(), "pipe", "is a device or a pipe; it must be a regular file");
    are_refused(dir.path(), "missing", "cannot be read: No such file");
    are_refused(dir.path(), "dangling", "cannot be read: No such file");
}

#[test]
fn a_hole_of_twenty_gigabytes_is_refused_at_once() {
    let dir = folder();
    for ending in ["csv", "json", "toml", "parquet"] {
        let hole = File::create(dir.path().join(format!("hole.{ending}"))).unwrap();
        hole.set_len(20 << 30).unwrap();
    }
    are_refused(dir.path(), "hole", "");
    let result = bounded(dir.path(), "campaign show hole.parquet");
    assert!(result.err.contains("does not begin as a Parquet file"), "{}", result.err);
    // The same with the ends of Parquet.
    use std::os::unix::fs::FileExt;
    let file = File::options().write(true).open(dir.path().join("hole.parquet")).unwrap();
    file.write_all_at(b"PAR1", 0).unwrap();
    file.write_all_at(b"\xff\xff\xff\x7fPAR1", (20 << 30) - 8).unwrap();
    let result = bounded(dir.path(), "campaign show hole.parquet");
    assert!(result.code == 2 && result.err.contains("is not a campaign"), "{}", result.err);
}

#[cfg(target_os = "linux")]
#[test]
fn what_the_system_fails_to_read_is_not_called_damaged() {
    let dir = folder();
    // The memory of the program begins with nothing: an error of input.
    for ending in ["csv", "json", "toml", "parquet"] {
        symlink("/proc/self/mem", dir.path().join(format!("mem.{ending}"))).unwrap();
    }
    are_refused(dir.path(), "mem", "cannot be read: Input/output error");
}

#[test]
fn a_resealed_file_that_claims_72_gigabytes_is_refused() {
    let file = root().join("crates/mckibben-cli/tests/all/hostile/resealed_allocates_72_gb.parquet");
    let dir = folder();
    fs::copy(file, dir.path().join("c.parquet")).unwrap();
    for line in ["campaign show c.parquet", "fit c.parquet"] {
        let result = bounded(dir.path(), line);
        assert!(result.code == 2 && result.err.contains("is damaged"), "{}", result.err);
    }
}

fn fitted(dir: &Path) -> String {
    let table = root().join("data/campaign/paper.csv");
    run_in(dir, &["fit", table.to_str().unwrap(), "--method", "paper", "-o", "f.json"]).ok();
    fs::read_to_string(dir.join("f.json")).unwrap()
}

/// Commands that answer by a formula, and where it is in for X.
const ANSWERS: [&str; 7] = [
    "force -D 40 -s 2 -p 0.2 -e 0.1 --model X",
    "pressure -D 40 -s 2 -F 300 -e 0.1 --model X",
    "contraction -D 40 -s 2 -F 500 -p 0.2 --model X",
    "curve isobaric -D 40 -s 2 -p 0.2 -e 0,0.1 --model X",
    "compare -D 40 -s 2 -p 0.2 -e 0,0.1 --models paper,X",
    "design -F 300 -e 10% --max-pressure 2.5bar -D 30..50:10 -s 1,2 --verify none --model X",
    "check X",
];

fn warnings(dir: &Path, line: &str, says: &str) -> usize {
    let words: Vec<&str> = line.split(' ').collect();
    let text = run_in(dir, &words).ok();
    let answer = run_in(dir, &[&words[..], &["--format", "json"]].concat()).ok().json();
    let list = answer["warnings"].as_array().cloned().unwrap_or_default();
    let found = list.iter().filter(|w| w.as_str().unwrap().contains(says)).count();
    assert_eq!(text.err.matches(says).count(), found, "{line}: {}", text.err);
    found
}

#[test]
fn a_formula_that_was_changed_says_so_in_every_answer() {
    let dir = folder();
    let text = fitted(dir.path());
    // The last digit of the first coefficient.
    let value = text.find("\"value\": ").unwrap() + 9;
    let last = value + text[value..].find('\n').unwrap() - 1;
    let other = if text.as_bytes()[last] == b'5' { '6' } else { '5' };
    fs::write(dir.path().join("edited.json"), format!("{}{other}{}", &text[..last], &text[last + 1..]))
        .unwrap();
    let mut bare: Value = serde_json::from_str(&text).unwrap();
    assert!(bare.as_object_mut().unwrap().remove("seal").is_some());
    fs::write(dir.path().join("bare.json"), bare.to_string()).unwrap();
    for line in ANSWERS {
        for (file, changed, absent) in [("f.json", 0, 0), ("edited.json", 1, 0), ("bare.json", 0, 1)] {
            let line = line.replace('X', file);
            assert_eq!(warnings(dir.path(), &line, "was changed after it was written"), changed, "{line}");
            assert_eq!(warnings(dir.path(), &line, "has no seal"), absent, "{line}");
        }
    }
    let answer = |file: &str| {
        let words = ["force", "-D", "40", "-s", "2", "-p", "0.2", "-e", "0.1", "--format", "json", "--model"];
        run_in(dir.path(), &[&words[..], &[file]].concat()).ok().json()
    };
    assert!(answer("f.json")["uncertainty_n"].is_number());
    assert!(answer("edited.json")["uncertainty_n"].is_null());
    // What is shown of a changed file is no sealed file.
    let shown = run_in(dir.path(), &["check", "edited.json", "--format", "json"]).ok();
    assert!(shown.json()["seal"].is_null());
}

#[test]
fn a_formula_whose_numbers_make_no_sense_is_refused() {
    let dir = folder();
    let text = fitted(dir.path());
    let value = text.find("\"value\": ").unwrap() + 9;
    let digits = value + text[value..].find(|c: char| c.is_ascii_digit()).unwrap();
    let wild = format!("{}9999999999999999{}", &text[..digits], &text[digits..]);
    fs::write(dir.path().join("wild.json"), wild).unwrap();
    for line in ANSWERS.iter().filter(|line| !line.starts_with("compare")) {
        let line = line.replace('X', "wild.json");
        let result = run_in(dir.path(), &line.split(' ').collect::<Vec<_>>());
        assert!(
            result.code == 2 && result.err.contains("its numbers are not plausible"),
            "{line}: {}",
            result.err
        );
    }
}

const DESIGN: &str = "design -F 300 -e 10% --max-pressure 2.5bar -D 40 -s 2 --model paper --verify none -o ";

fn line(dir: &Path, line: &str) -> Ran {
    run_in(dir, &line.split_whitespace().collect::<Vec<_>>())
}

#[test]
fn a_file_of_another_kind_is_replaced_only_where_that_is_asked_for() {
    let dir = folder();
    let at = |name: &str| dir.path().join(name);
    let paper = root().join("data/campaign/paper.csv");
    let tension = root().join("data/treloar/tension.csv");
    let table = format!("fit {} -o ", paper.display());
    let rubber = format!("rubber {} --law neo-hookean -o ", tension.display());
    let curve = "curve isobaric --model ideal -p 0.1 -e 0,0.1 -o ";
    for (command, file, flag) in [
        (DESIGN, "winner.toml", "--overwrite"),
        (table.as_str(), "f.json", "--force"),
        (rubber.as_str(), "r.toml", "--force"),
        (curve, "c.parquet", "--overwrite"),
    ] {
        let command = format!("{command}{file}");
        fs::write(at(file), "notes of mine").unwrap();
        let result = line(dir.path(), &command);
        assert!(result.code == 2 && result.err.contains("would be overwritten"), "{command}: {}", result.err);
        assert!(result.err.contains("--overwrite"), "{}", result.err);
        assert_eq!(fs::read(at(file)).unwrap(), b"notes of mine");
        line(dir.path(), &format!("{command} {flag}")).ok();
        let first = fs::read(at(file)).unwrap();
        assert_ne!(first, b"notes of mine");
        // The same again is no loss.
        line(dir.path(), &command).ok();
        assert_eq!(fs::read(at(file)).unwrap(), first);
    }
    // An answer is no formula, and a table no campaign.
    let result = line(dir.path(), "force -p 0.1 --model ideal -o f.json");
    assert!(result.code == 2 && result.err.contains("would be overwritten"), "{}", result.err);
}

/// What this program did not write is nowhere lost without a word: not for texts, tables, JSON and figures either. What it wrote is replaced.
#[test]
fn a_foreign_file_is_replaced_by_no_text_table_or_figure() {
    let dir = folder();
    let at = |name: &str| dir.path().join(name);
    let measured = "pressure_bar,contraction,force_n\n1,0,100\n";
    let curve = "curve isobaric --model ideal -p 0.1 -e 0,0.1 ";
    let show = "check universal --latex -o ";
    for (command, file, foreign) in [
        (format!("{curve}-o "), "t.txt", "notes of mine"),
        (format!("{curve}-o "), "t.csv", measured),
        (format!("{curve}-o "), "t.json", "{\"mine\": 1}"),
        (format!("{curve}-o "), "list.json", "[1, 2]"),
        (format!("{curve}--plot "), "t.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"></svg>"),
        (format!("{curve}--plot "), "t.png", "\u{89}PNG of mine"),
        (format!("{curve}--plot "), "t.html", "<!DOCTYPE html><p>mine</p>"),
        (show.into(), "t.tex", "\\section{Mine}"),
        ("report -D 30 -p 0.1 -o ".into(), "report.html", "<!DOCTYPE html><p>mine</p>"),
        ("schema force -o ".into(), "schema.json", "{\"mine\": 1}"),
        ("simulate --model fe3d --mesh 1x4 -p 0.01 -e 0.1 --export-inp ".into(), "t.inp", "*HEADING\nmine"),
    ] {
        let command = format!("{command}{file}");
        fs::write(at(file), foreign).unwrap();
        let result = line(dir.path(), &command);
        assert!(result.code == 2 && result.err.contains("would be overwritten"), "{command}: {}", result.err);
        assert!(result.err.contains("--overwrite"), "{command}: {}", result.err);
        assert_eq!(fs::read(at(file)).unwrap(), foreign.as_bytes(), "{command}");
        line(dir.path(), &format!("{command} --overwrite")).ok();
        assert_ne!(fs::read(at(file)).unwrap(), foreign.as_bytes(), "{command}");
        line(dir.path(), &command).ok();
    }
}

#[test]
fn a_campaign_is_not_replaced_by_a_table() {
    let dir = folder();
    let plan = "[test]\ncontractions = 0\npressures = 0.1\nmesh = \"3\"\n";
    fs::write(dir.path().join("plan.toml"), plan).unwrap();
    line(dir.path(), "campaign plan.toml -o c.parquet").ok();
    let before = fs::read(dir.path().join("c.parquet")).unwrap();
    let result = line(dir.path(), "curve isobaric --model ideal -p 0.1 -e 0,0.1 -o c.parquet");
    assert_eq!(result.code, 2, "{}", result.err);
    assert_eq!(fs::read(dir.path().join("c.parquet")).unwrap(), before);
    fs::write(dir.path().join("plan.toml"), plan.replace("0.1", "0.2")).unwrap();
    let result = line(dir.path(), "campaign plan.toml -o c.parquet");
    assert!(result.code == 2 && result.err.contains("--overwrite"), "{}", result.err);
    line(dir.path(), "campaign plan.toml -o c.parquet --force").ok();
    assert_ne!(fs::read(dir.path().join("c.parquet")).unwrap(), before);
}

#[test]
fn a_read_only_file_stays_and_a_link_is_followed() {
    let dir = folder();
    let at = |name: &str| dir.path().join(name);
    line(dir.path(), &format!("{DESIGN}w.toml")).ok();
    fs::set_permissions(at("w.toml"), fs::Permissions::from_mode(0o444)).unwrap();
    let before = fs::metadata(at("w.toml")).unwrap().modified().unwrap();
    for flag in ["", " --overwrite"] {
        let result = line(dir.path(), &format!("{DESIGN}w.toml{flag}"));
        assert!(result.code == 2 && result.err.contains("read-only"), "{}", result.err);
    }
    assert_eq!(fs::metadata(at("w.toml")).unwrap().modified().unwrap(), before);
    fs::create_dir(at("far")).unwrap();
    symlink("far/real.toml", at("link.toml")).unwrap();
    for _ in 0..2 {
        line(dir.path(), &format!("{DESIGN}link.toml")).ok();
        assert!(at("link.toml").is_symlink() && at("far/real.toml").is_file());
    }
}

/// A name that colours, turns, and breaks the line.
const STEERS: &str = "a\u{1b}[31m\u{202e}b\nc";

fn steers(ran: &Ran) -> bool {
    let all = format!("{}{}", ran.text(), ran.err);
    all.contains(['\u{1b}', '\u{202e}', '\u{9b}', '\r'])
}

#[test]
fn names_do_not_steer_the_terminal() {
    let dir = folder();
    let toml = format!("{STEERS}.toml");
    fs::write(dir.path().join(&toml), "[tube]\nlength = \"x\"\n").unwrap();
    let csv = format!("{STEERS}.csv");
    fs::write(
        dir.path().join(&csv),
        format!("pressure_mpa,contraction,force_n,\"{STEERS}\"\n0.1,0,200,1\n0.2,0,400,1\n"),
    )
    .unwrap();
    let out = format!("{STEERS}-winner.toml");
    let design = [&DESIGN.split_whitespace().collect::<Vec<_>>()[..], &[&out]].concat();
    for words in [
        vec!["check", &toml],
        vec!["check", STEERS],
        vec!["force", "-p", STEERS],
        vec!["force", "-p", "0.1", "--model", STEERS],
        vec!["force", "-p", "0.1", "--rubber", STEERS],
        vec![STEERS],
        vec!["campaign", "show", STEERS],
        vec!["compare", "--models", "ideal", "--data", &csv],
        vec!["rubber", &csv],
        vec!["parts", "list", "models", "-o", STEERS],
        design,
    ] {
        let result = run_in(dir.path(), &words);
        assert!(!steers(&result), "{words:?}: {result:?}");
    }
    let result = run_in(dir.path(), &["check", &toml]);
    assert!(
        result.err.starts_with("error: a\\u{1b}[31m\\u{202e}b\\nc.toml:2:10: tube.length"),
        "{}",
        result.err
    );
    // Programs get the name as it is.
    let error = run_in(dir.path(), &["check", &toml, "--format", "json"]).error();
    assert!(error["message"].as_str().unwrap().starts_with(STEERS), "{error}");
}

#[test]
fn a_formula_of_a_name_that_steers_the_terminal_is_refused() {
    let dir: TempDir = folder();
    let table = root().join("data/campaign/paper.csv");
    let result = run_in(dir.path(), &["fit", table.to_str().unwrap(), "--name", STEERS]);
    assert!(result.code == 2 && !steers(&result), "{result:?}");
    let text = fitted(dir.path()).replacen("\"paper-method\"", "\"a\\u001b[31mb\"", 1);
    fs::write(dir.path().join("f.json"), text).unwrap();
    let result = run_in(dir.path(), &["check", "f.json"]);
    assert!(result.code == 2 && result.err.contains("control characters") && !steers(&result), "{result:?}");
}

/// Whatever the command, and by whatever name.
#[test]
fn an_input_is_no_output() {
    let dir = folder();
    let at = |name: &str| dir.path().join(name);
    for name in ["bench.toml", "bench.csv"] {
        fs::copy(root().join("examples").join(name), at(name)).unwrap();
    }
    fs::copy(root().join("data/campaign/paper.csv"), at("paper.csv")).unwrap();
    fs::write(at("load.csv"), "shortening_mm,force_n\n0,100\n50,100\n100,100\n").unwrap();
    symlink("bench.csv", at("link.csv")).unwrap();
    fs::hard_link(at("bench.csv"), at("other.csv")).unwrap();
    let before = |name: &str| fs::read(at(name)).unwrap();
    let (bench, muscle, paper, load) =
        (before("bench.csv"), before("bench.toml"), before("paper.csv"), before("load.csv"));
    for line in [
        "compare bench.toml --data bench.csv -o bench.csv",
        "compare bench.toml --data bench.csv -o ./link.csv",
        "compare bench.toml --data other.csv -o bench.csv",
        "identify bench.toml --data bench.csv -o bench.toml",
        "rubber bench.csv --muscle bench.toml -o bench.toml",
        "fit paper.csv -o paper.csv",
        "simulate bench.toml -p 0.1 --export-inp bench.toml",
        "design -F 300 -e 10% -p 2.5bar --muscle bench.toml -o bench.toml",
        "curve isobaric bench.toml -p 0.1 --model ideal --load table:load.csv -o load.csv",
        "curve isobaric bench.toml -p 0.1 --model ideal --load table:load.csv -o ./load.csv",
    ] {
        let words: Vec<&str> = line.split(' ').collect();
        let run = run_in(dir.path(), &words);
        assert!(run.code == 2 && run.err.contains("is an input of this command"), "{line}: {run:?}");
    }
    assert!(before("bench.csv") == bench && before("bench.toml") == muscle);
    assert!(before("paper.csv") == paper && before("load.csv") == load);
    // Where that is wanted it can be said.
    let line = "compare bench.toml --data bench.csv --models ideal -o bench.csv --overwrite";
    run_in(dir.path(), &line.split(' ').collect::<Vec<_>>()).ok();
    assert!(before("bench.csv") != bench);
}

#[test]
fn folders_of_results_keep_what_others_put_there() {
    let dir = folder();
    fs::copy(root().join("data/campaign/paper.csv"), dir.path().join("paper.csv")).unwrap();
    for (line, name) in [
        ("fit paper.csv --tables out -o f.json", "tables.json"),
        ("simulate -p 0.1 --vtu out -e 0.1", "tube_0000.vtu"),
    ] {
        let words: Vec<&str> = line.split(' ').collect();
        // What the program wrote is replaced.
        run_in(dir.path(), &words).ok();
        run_in(dir.path(), &words).ok();
        let out = dir.path().join("out");
        let csv = fs::read_dir(&out)
            .unwrap()
            .map(|e| e.unwrap().path())
            .find(|p| p.extension().is_some_and(|e| e == "csv" || e == "vtu"));
        let csv = csv.unwrap();
        fs::write(&csv, "mine").unwrap();
        let refused = run_in(dir.path(), &words);
        assert!(refused.code == 2 && refused.err.contains("would be overwritten"), "{line}: {refused:?}");
        assert_eq!(fs::read(&csv).unwrap(), b"mine");
        run_in(dir.path(), &[&words[..], &["--overwrite"]].concat()).ok();
        assert!(fs::read(&csv).unwrap() != b"mine" && out.join(name).exists());
        fs::remove_dir_all(out).unwrap();
    }
}
