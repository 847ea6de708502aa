//! Files as they should not be: devices, pipes, holes of twenty gigabytes, other people's work at
//! `-o`, names that steer a terminal.
#![cfg(unix)]

use crate::common::{Ran, copy, folder, json, names, ran, root, run_in};
use std::{
    fs::{self, File},
    os::unix::fs::{PermissionsExt, symlink},
    path::Path,
    process::{Command, Stdio},
};

/// Runs a line in a folder with four gigabytes of addresses, and no more.
fn bounded(dir: &Path, line: &str) -> Ran {
    let program = env!("CARGO_BIN_EXE_mckibben");
    let script = format!("ulimit -v 4000000 && exec {program} {line}");
    let mut command = Command::new("sh");
    command
        .args(["-c", &script])
        .current_dir(dir)
        .stdin(Stdio::null())
        .env_remove("RUST_BACKTRACE");
    ran(command.output().unwrap())
}

/// Commands that read a file of the name X.
const READERS: [&str; 11] = [
    "fit X.csv",
    "fit X.parquet",
    "fit X.parquet --method universal",
    "check X.json",
    "force -p 0.1 -e 0.1 --model X.json",
    "force -p 0.1 --muscle X.toml",
    "campaign show X.parquet",
    "campaign X.toml -o out.parquet",
    "compare --data X.csv",
    "identify --data X.csv",
    "rubber X.csv",
];

/// Each of the readers says so, and does not advise to remove a file that the system refused to
/// read.
fn are_refused(dir: &Path, name: &str, says: &str) {
    for line in READERS {
        let result = bounded(dir, &format!("{} --format json", line.replace('X', name)));
        assert_eq!(result.code, 2, "{line}: {}", result.err);
        let error = result.error();
        let message = error["message"].as_str().unwrap();
        assert!(message.contains(says), "{line}: {error}");
        assert!(
            !error["hint"].as_str().unwrap().contains("remove"),
            "{line}: {error}"
        );
    }
}

/// Devices, pipes, links to nowhere, holes of twenty gigabytes, and a file that claims 72.
#[test]
fn what_is_no_file_to_read_is_refused_at_once() {
    let dir = folder();
    for ending in ["csv", "parquet", "json", "toml"] {
        let at = |name: &str| dir.path().join(format!("{name}.{ending}"));
        symlink("/dev/zero", at("zero")).unwrap();
        let made = Command::new("mkfifo").arg(at("pipe")).status();
        assert!(made.unwrap().success());
        symlink("nowhere", at("dangling")).unwrap();
        let hole = File::create(at("hole")).unwrap();
        hole.set_len(20 << 30).unwrap();
    }
    for (name, says) in [
        ("zero", "is a device or a pipe"),
        ("pipe", "is a device or a pipe"),
        ("missing", "No such file"),
        ("dangling", "No such file"),
        ("hole", ""),
    ] {
        are_refused(dir.path(), name, says);
    }
    let file = root().join("crates/mckibben-cli/tests/all/hostile/allocates_72_gb.parquet");
    fs::copy(file, dir.path().join("c.parquet")).unwrap();
    for line in ["campaign show c.parquet", "fit c.parquet"] {
        let result = bounded(dir.path(), &format!("{line} --format json"));
        assert_eq!((result.code, &result.error()["kind"]), (2, &"file".into()));
    }
}

/// A sheet into which somebody has written is kept when its folder is built again, and so is what is
/// no such sheet; a blank one is written anew.
#[test]
fn readings_in_the_sheet_of_the_first_test_are_kept() {
    let dir = copy();
    let sheet = dir.path().join("out/test.csv");
    let build = |line: &str| {
        let ran = run_in(
            dir.path(),
            &format!("build -D 30 -o out --overwrite {line}"),
        );
        let is_kept = ran.err.contains("test.csv has readings");
        ran.ok();
        (fs::read_to_string(&sheet).unwrap(), is_kept)
    };
    let (blank, _) = build("-p 0.1");
    let (other, is_kept) = build("-p 0.12");
    assert!(!is_kept && other != blank);
    for text in [
        &*other.replacen(",,,,force,", "0.1,0.05,3,,force,", 1),
        "notes of mine",
    ] {
        fs::write(&sheet, text).unwrap();
        let (kept, is_kept) = build("-p 0.1");
        assert!(is_kept && kept == text, "{kept}");
    }
}

const DESIGN: &str = "design -F 300 -e 10% --max-pressure 2.5bar -D 40 -s 2 --model paper -o ";

/// What every command writes: command, flag with its file or folder, and the file that is in its
/// way. A test in `src/cli/tests.rs` says that none is missing.
const WRITERS: &str = include_str!("../rows/writers.tsv");

/// Of a campaign, which takes half a second.
const PLAN: &str = "[test]\ncontractions = 0\npressures = 0.1\nmesh = \"3\"\n";

#[test]
fn an_existing_file_is_overwritten_only_on_request() {
    let dir = copy();
    let at = |name: &str| dir.path().join(name);
    fs::copy(at("data/campaign/paper.csv"), at("paper.csv")).unwrap();
    fs::copy(at("data/treloar/tension.csv"), at("tension.csv")).unwrap();
    fs::write(at("plan.toml"), PLAN).unwrap();
    run_in(dir.path(), "campaign plan.toml -o c0.parquet").ok();
    run_in(dir.path(), "campaign plan.toml -o parts").ok();
    for row in WRITERS.lines() {
        let [command, flag, file] = row.split('\t').collect::<Vec<_>>()[..] else {
            panic!("{row}")
        };
        let line = format!("{command} {flag}");
        let is_refused = || {
            let result = run_in(dir.path(), &line);
            let is_hinted = result.err.contains("--overwrite");
            assert!(result.code == 2 && is_hinted, "{line}: {}", result.err);
        };
        fs::create_dir_all(at("out")).unwrap();
        fs::write(at(file), "notes of mine").unwrap();
        is_refused();
        assert_eq!(fs::read(at(file)).unwrap(), b"notes of mine", "{line}");
        run_in(dir.path(), &format!("{line} --overwrite")).ok();
        assert_ne!(fs::read(at(file)).unwrap(), b"notes of mine", "{line}");
        // A link in a folder is no way out of it.
        if file.starts_with("out/") {
            fs::remove_file(at(file)).unwrap();
            symlink("../elsewhere", at(file)).unwrap();
            is_refused();
            run_in(dir.path(), &format!("{line} --overwrite")).ok();
            assert!(
                !at(file).is_symlink() && !at("elsewhere").exists(),
                "{line}"
            );
        }
        fs::remove_dir_all(at("out")).unwrap();
    }
    // The same plan continues its file, another one is refused.
    let line = "campaign plan.toml -o c0.parquet";
    let before = fs::read(at("c0.parquet")).unwrap();
    run_in(dir.path(), line).ok();
    fs::write(at("plan.toml"), PLAN.replace("0.1", "0.2")).unwrap();
    let result = run_in(dir.path(), line);
    assert!(
        result.code == 2 && result.err.contains("--overwrite"),
        "{}",
        result.err
    );
    assert_eq!(fs::read(at("c0.parquet")).unwrap(), before);
    run_in(dir.path(), &format!("{line} --overwrite")).ok();
    assert_ne!(fs::read(at("c0.parquet")).unwrap(), before);
}

#[test]
fn a_read_only_file_stays_and_a_link_is_followed() {
    let dir = folder();
    let at = |name: &str| dir.path().join(name);
    run_in(dir.path(), &format!("{DESIGN}w.toml")).ok();
    fs::set_permissions(at("w.toml"), fs::Permissions::from_mode(0o444)).unwrap();
    let before = fs::metadata(at("w.toml")).unwrap().modified().unwrap();
    for flag in ["", " --overwrite"] {
        let result = run_in(dir.path(), &format!("{DESIGN}w.toml{flag}"));
        assert!(
            result.code == 2 && result.err.contains("read-only"),
            "{}",
            result.err
        );
    }
    assert_eq!(
        fs::metadata(at("w.toml")).unwrap().modified().unwrap(),
        before
    );
    fs::create_dir(at("far")).unwrap();
    symlink("far/real.toml", at("link.toml")).unwrap();
    for flag in ["", " --overwrite"] {
        run_in(dir.path(), &format!("{DESIGN}link.toml{flag}")).ok();
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
    for words in [
        format!("check '{toml}'"),
        format!("force -p '{STEERS}'"),
        format!("force -p 0.1 --model '{STEERS}'"),
        format!("force -p 0.1 --rubber '{STEERS}'"),
        format!("'{STEERS}'"),
        format!("campaign show '{STEERS}'"),
        format!("compare --models ideal --data '{csv}'"),
        format!("rubber '{csv}'"),
        format!("parts list models -o '{STEERS}'"),
        format!("{DESIGN}'{STEERS}-winner.toml'"),
    ] {
        let result = run_in(dir.path(), &words);
        assert!(!steers(&result), "{words:?}: {result:?}");
    }
    let result = run_in(dir.path(), &format!("check '{toml}'"));
    assert!(
        result
            .err
            .starts_with("error: a\\u{1b}[31m\\u{202e}b\\nc.toml:2:10: tube.length"),
        "{}",
        result.err
    );
    // Nor does the name of a formula.
    let run = |line: &str| run_in(dir.path(), line);
    let table = root().join("data/campaign/paper.csv");
    let fit = format!("fit {}", table.display());
    let result = run(&format!("{fit} --name '{STEERS}'"));
    assert!(result.code == 2 && !steers(&result), "{result:?}");
    run(&format!("{fit} --method paper -o f.json")).ok();
    let path = dir.path().join("f.json");
    let text = fs::read_to_string(&path).unwrap();
    fs::write(
        path,
        text.replacen("\"paper-method\"", "\"a\\u001b[31mb\"", 1),
    )
    .unwrap();
    let result = run("check f.json");
    assert!(result.code == 2 && !steers(&result), "{result:?}");
    // Programs get the name as it is.
    let error = run_in(dir.path(), &format!("check '{toml}' --format json")).error();
    assert!(
        error["message"].as_str().unwrap().starts_with(STEERS),
        "{error}"
    );
}

/// A folder in a file cannot be made, and an existing file stays: for every target, nothing is
/// written.
#[test]
fn an_export_that_cannot_be_written_whole_is_not_begun() {
    let line = "export examples/prototype.toml --model thick-wall --as";
    let listed = json("export --list");
    let listed = listed["targets"].as_array().unwrap().iter();
    let mut targets: Vec<&str> = listed
        .map(|target| target["name"].as_str().unwrap())
        .collect();
    for target in &targets {
        let dir = copy();
        fs::write(dir.path().join("file"), "mine").unwrap();
        let refused = run_in(dir.path(), &format!("{line} {target} -o file/folder"));
        assert!(
            refused.code != 0 && refused.err.contains("cannot write"),
            "{target}: {}",
            refused.err
        );
        run_in(dir.path(), &format!("{line} {target} -o whole")).ok();
        let all = names(&dir.path().join("whole"));
        let last = all.last().unwrap();
        // A second muscle stands beside the first; the same name for another is refused.
        let before = fs::read(dir.path().join("whole").join(last)).unwrap();
        run_in(
            dir.path(),
            &format!("{line} {target} -o whole --name other"),
        )
        .ok();
        let refused = run_in(dir.path(), &format!("{line} {target} -o whole -p 2bar"));
        assert!(
            refused.code == 2 && refused.err.contains("muscle_prototype"),
            "{target}: {}",
            refused.err
        );
        assert_eq!(
            fs::read(dir.path().join("whole").join(last)).unwrap(),
            before,
            "{target}"
        );
        assert!(
            names(&dir.path().join("whole")).len() > all.len(),
            "{target}"
        );
        fs::create_dir(dir.path().join("inside")).unwrap();
        fs::write(dir.path().join("inside").join(last), "mine").unwrap();
        let refused = run_in(dir.path(), &format!("{line} {target} -o inside"));
        assert!(
            refused.code == 2 && refused.err.contains(last),
            "{target}: {}",
            refused.err
        );
        assert_eq!(names(&dir.path().join("inside")), [&**last], "{target}");
    }
    let text = fs::read_to_string(root().join("docs/exports.md")).unwrap();
    let rows = text
        .lines()
        .filter_map(|line| line.strip_prefix("| `")?.split('`').next());
    let mut rows: Vec<&str> = rows.filter(|word| !word.starts_with('-')).collect();
    rows.sort_unstable();
    targets.sort_unstable();
    assert_eq!(rows, targets);
}
