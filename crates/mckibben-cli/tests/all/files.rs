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

fn are_refused(dir: &Path, name: &str, says: &str) {
    for line in READERS {
        let result = bounded(dir, &format!("{} --format json", line.replace('X', name)));
        assert_eq!(result.code, 2, "{line}: {}", result.err);
        let error = result.error();
        let message = error["message"].as_str().unwrap();
        assert!(message.contains(says), "{line}: {message}");
        // The message does not advise to remove a file that the system refused to read.
        assert!(
            !error["hint"].as_str().unwrap().contains("remove"),
            "{line}: {error}"
        );
    }
}

#[test]
fn what_is_no_regular_file_is_refused_at_once() {
    let dir = folder();
    for ending in ["csv", "parquet", "json", "toml"] {
        let at = |name: &str| dir.path().join(format!("{name}.{ending}"));
        symlink("/dev/zero", at("zero")).unwrap();
        assert!(
            Command::new("mkfifo")
                .arg(at("pipe"))
                .status()
                .unwrap()
                .success()
        );
        symlink("nowhere", at("dangling")).unwrap();
    }
    are_refused(
        dir.path(),
        "zero",
        "is a device or a pipe; it must be a regular file",
    );
    are_refused(
        dir.path(),
        "pipe",
        "is a device or a pipe; it must be a regular file",
    );
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
}

#[test]
fn a_file_that_claims_72_gigabytes_is_refused() {
    let file = root().join("crates/mckibben-cli/tests/all/hostile/allocates_72_gb.parquet");
    let dir = folder();
    fs::copy(file, dir.path().join("c.parquet")).unwrap();
    for line in ["campaign show c.parquet", "fit c.parquet"] {
        let result = bounded(dir.path(), line);
        assert!(
            result.code == 2 && result.err.contains("is not a campaign"),
            "{}",
            result.err
        );
    }
}

const DESIGN: &str = "design -F 300 -e 10% --max-pressure 2.5bar -D 40 -s 2 --model paper -o ";

/// What every command writes, and where: the flag with its folder or file, and the file that is in
/// its way.
const WRITERS: [(&str, &str, &str); 33] = [
    (
        "design -F 300 -e 10% -p 2.5bar -D 40 -s 2 --model paper",
        "-o w.toml",
        "w.toml",
    ),
    ("force -p 0.1 --model ideal", "-o t.json", "t.json"),
    (
        "pressure -F 100N -e 5% --model ideal",
        "-o t.json",
        "t.json",
    ),
    (
        "contraction -F 100N -p 0.1 --model ideal",
        "-o t.json",
        "t.json",
    ),
    (
        "fill --liquid water --volume 20mL --model ideal",
        "-o t.txt",
        "t.txt",
    ),
    (
        "curve isobaric --model ideal -p 0.1 -e 0,0.1",
        "-o t.csv",
        "t.csv",
    ),
    (
        "curve isobaric --model ideal -p 0.1 -e 0,0.1",
        "-o t.txt",
        "t.txt",
    ),
    (
        "curve isobaric --model ideal -p 0.1 -e 0,0.1",
        "-o t.json",
        "t.json",
    ),
    (
        "curve isobaric --model ideal -p 0.1 -e 0,0.1",
        "--plot t.svg",
        "t.svg",
    ),
    (
        "joint examples/elbow.toml --model ideal -p 2bar,1bar",
        "-o t.json",
        "t.json",
    ),
    (
        "motion examples/drive.toml --model ideal",
        "-o t.csv",
        "t.csv",
    ),
    ("simulate -p 0.1 -e 0.1", "-o t.csv", "t.csv"),
    ("simulate -p 0.1 -e 0.1", "--vtu out", "out/muscle.pvd"),
    ("simulate -p 0.1 -e 0.1", "--vtu out", "out/tube_0000.vtu"),
    (
        "simulate --model fe3d --mesh 1x4 -p 0.1 -e 0.1",
        "--export-inp t.inp",
        "t.inp",
    ),
    (
        "check examples/prototype.toml --model ideal",
        "-o t.txt",
        "t.txt",
    ),
    ("check universal --latex", "-o t.tex", "t.tex"),
    ("build -D 30 -p 0.1", "--report report.html", "report.html"),
    ("build -D 30 -p 0.1", "-o out", "out/test.csv"),
    (
        "export --model ideal --as c",
        "-o out",
        "out/muscle_loop.ino",
    ),
    ("campaign show c0.parquet", "-o t.txt", "t.txt"),
    ("campaign merge parts", "-o t.parquet", "t.parquet"),
    ("compare --models ideal,paper", "-o t.csv", "t.csv"),
    (
        "identify examples/bench.toml --data examples/bench.csv --model thick-wall --free mu",
        "-o t.toml",
        "t.toml",
    ),
    (
        "identify examples/bench.toml --data examples/bench.csv --model thick-wall --free mu",
        "--save-measured out",
        "out/case.toml",
    ),
    ("fit paper.csv", "-o t.json", "t.json"),
    (
        "fit paper.csv --method paper",
        "--figures out",
        "out/figure_10_b_over_diameter.svg",
    ),
    ("parts list models", "-o t.txt", "t.txt"),
    ("parts show latex", "-o t.txt", "t.txt"),
    (
        "rubber tension.csv --law neo-hookean",
        "-o t.toml",
        "t.toml",
    ),
    ("schema force", "-o t.json", "t.json"),
    ("schema", "-o out", "out/force.json"),
    ("man", "-o out", "out/mckibben-force.1"),
];

#[test]
fn an_existing_file_is_overwritten_only_on_request() {
    let dir = copy();
    let at = |name: &str| dir.path().join(name);
    fs::copy(at("data/campaign/paper.csv"), at("paper.csv")).unwrap();
    fs::copy(at("data/treloar/tension.csv"), at("tension.csv")).unwrap();
    fs::write(at("plan.toml"), PLAN).unwrap();
    run_in(dir.path(), "campaign plan.toml -o c0.parquet").ok();
    run_in(dir.path(), "campaign plan.toml -o parts").ok();
    for (command, flag, file) in WRITERS {
        let line = format!("{command} {flag}");
        let is_refused = || {
            let result = run_in(dir.path(), &line);
            let said =
                result.err.contains("would be overwritten") && result.err.contains("--overwrite");
            assert!(result.code == 2 && said, "{line}: {}", result.err);
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
        let _ = fs::remove_file(at("new.svg"));
    }
}

/// Flags with a file or folder that is read.
const READ: [&str; 16] = [
    "log", "data", "columns", "muscle", "parts", "model", "models", "formula", "rubber", "rubbers",
    "load", "braid", "tube", "tubes", "samples", "terms",
];

#[test]
fn no_flag_that_names_an_output_is_missing_from_that_test() {
    let dir = folder();
    run_in(dir.path(), "man -o man").ok();
    for page in names(&dir.path().join("man")) {
        let name = page
            .trim_start_matches("mckibben")
            .trim_start_matches('-')
            .trim_end_matches(".1");
        let command = name.replace('-', " ");
        let help = run_in(dir.path(), &format!("{command} --help")).ok();
        let flags = help
            .text()
            .lines()
            .filter(|l| l.contains("FILE") || l.contains("DIR"));
        let flags = flags.filter_map(|l| l.split_once("--")?.1.split(" <").next());
        for flag in flags.filter(|flag| !flag.contains(' ') && !READ.contains(flag)) {
            let typed = if flag == "output" {
                "-o ".to_owned()
            } else {
                format!("--{flag} ")
            };
            // Figures are of all commands alike, and a campaign has a separate test.
            let once = flag.starts_with("plot") || command == "campaign";
            let has = |w: &(&str, &str, &str)| {
                (once || w.0.starts_with(&command)) && w.1.starts_with(&typed)
            };
            assert!(WRITERS.iter().any(has), "{command} --{flag}");
        }
    }
}

const PLAN: &str = "[test]\ncontractions = 0\npressures = 0.1\nmesh = \"3\"\n";
#[test]
fn a_campaign_of_another_plan_is_overwritten_only_on_request() {
    let dir = folder();
    fs::write(dir.path().join("plan.toml"), PLAN).unwrap();
    run_in(dir.path(), "campaign plan.toml -o c.parquet").ok();
    let before = fs::read(dir.path().join("c.parquet")).unwrap();
    // The same plan continues its file.
    run_in(dir.path(), "campaign plan.toml -o c.parquet").ok();
    fs::write(dir.path().join("plan.toml"), PLAN.replace("0.1", "0.2")).unwrap();
    let result = run_in(dir.path(), "campaign plan.toml -o c.parquet");
    assert!(
        result.code == 2 && result.err.contains("--overwrite"),
        "{}",
        result.err
    );
    assert_eq!(fs::read(dir.path().join("c.parquet")).unwrap(), before);
    run_in(dir.path(), "campaign plan.toml -o c.parquet --overwrite").ok();
    assert_ne!(fs::read(dir.path().join("c.parquet")).unwrap(), before);
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
    // Programs get the name as it is.
    let error = run_in(dir.path(), &format!("check '{toml}' --format json")).error();
    assert!(
        error["message"].as_str().unwrap().starts_with(STEERS),
        "{error}"
    );
}

#[test]
fn a_formula_of_a_name_that_steers_the_terminal_is_refused() {
    let dir = copy();
    let result = run_in(
        dir.path(),
        &format!("fit data/campaign/paper.csv --name '{STEERS}'"),
    );
    assert!(result.code == 2 && !steers(&result), "{result:?}");
    run_in(
        dir.path(),
        "fit data/campaign/paper.csv --method paper -o f.json",
    )
    .ok();
    let path = dir.path().join("f.json");
    let text =
        fs::read_to_string(&path)
            .unwrap()
            .replacen("\"paper-method\"", "\"a\\u001b[31mb\"", 1);
    fs::write(path, text).unwrap();
    let result = run_in(dir.path(), "check f.json");
    assert!(
        result.code == 2 && result.err.contains("control characters") && !steers(&result),
        "{result:?}"
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
