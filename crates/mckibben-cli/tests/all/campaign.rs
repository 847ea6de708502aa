//! Campaigns as a user runs them: killed, interrupted, twice at once, on a full disk.
#![cfg(unix)]

use crate::common::{Ran, command, folder, ran, run_in};
use mckibben::random::Random;
use serde_json::Value;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// A campaign of some seconds.
const PLAN: &str = "[sampling]\nmethod = \"sobol\"\nsamples = 120\nseed = 5\n\
    [vary]\ntube.outer_diameter = \"20..50 mm\"\ntube.wall_ratio = \"4..12%\"\nbraid.angle = \"22..32\"\n\
    [test]\ncontractions = \"0,5,10%\"\npressures = \"0.05..0.3:0.05\"\nsensitivities = true\n";

fn with_plan() -> TempDir {
    let dir = folder();
    std::fs::write(dir.path().join("plan.toml"), PLAN).unwrap();
    dir
}

fn campaign(dir: &Path, words: &str) -> Ran {
    let line = format!("campaign {words}");
    run_in(dir, &line.split_whitespace().collect::<Vec<_>>())
}

fn started(dir: &Path, out: &str) -> Child {
    let mut command = command(dir);
    command.args(["campaign", "plan.toml", "-o", out, "--quiet"]);
    command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

fn reference(dir: &Path) -> Vec<u8> {
    campaign(dir, "plan.toml -o reference.parquet").ok();
    std::fs::read(dir.join("reference.parquet")).unwrap()
}

fn signal(child: &Child, name: &str) {
    Command::new("kill").args([&format!("-{name}"), &child.id().to_string()]).status().unwrap();
}

fn shown(dir: &Path, store: &str) -> Option<Value> {
    let result = campaign(dir, &format!("show {store} --format json"));
    (result.code == 0).then(|| result.json())
}

#[test]
fn killed_at_random_moments_and_resumed_it_is_the_same_bytes() {
    let dir = with_plan();
    let from = Instant::now();
    let expected = reference(dir.path());
    let whole = from.elapsed();
    let mut random = Random(7);
    for out in ["file.parquet", "parts"] {
        let store = if out == "parts" { "parts" } else { "file.parquet.parts" };
        let mut had = 0;
        for _ in 0..8 {
            let mut child = started(dir.path(), out);
            let longest = whole.as_millis() as u64 * 2 / 3;
            std::thread::sleep(Duration::from_millis(random.bits() % longest.max(1)));
            child.kill().unwrap();
            child.wait().unwrap();
            if dir.path().join(out).is_file() {
                // It was done; what is left of the store was about to be removed.
                break;
            }
            // Whatever is there is whole, and nothing that was there is lost.
            if let Some(shown) = shown(dir.path(), store) {
                assert_eq!(shown["damaged"].as_array().unwrap().len(), 0, "{shown}");
                let muscles = shown["muscles"].as_u64().unwrap();
                assert!(muscles >= had, "{muscles} of {had}");
                had = muscles;
            }
        }
        let last = campaign(dir.path(), &format!("plan.toml -o {out} --format json")).ok().json();
        assert_eq!((&last["muscles"], &last["complete"]), (&120.into(), &true.into()), "{last}");
        assert!(last["muscles_resumed"].as_u64().unwrap() >= had, "{last}");
    }
    campaign(dir.path(), "merge parts -o merged.parquet").ok();
    assert!(std::fs::read(dir.path().join("file.parquet")).unwrap() == expected);
    assert!(std::fs::read(dir.path().join("merged.parquet")).unwrap() == expected);
    assert!(!dir.path().join("file.parquet.parts").exists());
}

#[test]
fn ctrl_c_leaves_a_valid_store_and_the_same_command_goes_on() {
    let dir = with_plan();
    let expected = reference(dir.path());
    let mut interrupted = 0;
    for (name, wait) in [("INT", 100), ("TERM", 300), ("INT", 600)] {
        let mut child = started(dir.path(), "c.parquet");
        std::thread::sleep(Duration::from_millis(wait));
        signal(&child, name);
        let code = child.wait().unwrap().code();
        if code == Some(0) {
            break;
        }
        assert_eq!(code, Some(130));
        interrupted += 1;
        let shown = shown(dir.path(), "c.parquet.parts");
        assert!(shown.is_none_or(|s| s["damaged"].as_array().unwrap().is_empty()));
    }
    assert!(interrupted > 0, "it was too fast to be interrupted");
    campaign(dir.path(), "plan.toml -o c.parquet").ok();
    assert!(std::fs::read(dir.path().join("c.parquet")).unwrap() == expected);
}

#[test]
fn a_second_process_is_refused_while_the_first_writes() {
    let dir = with_plan();
    let expected = reference(dir.path());
    let mut first = started(dir.path(), "c.parquet");
    let lock = dir.path().join("c.parquet.parts/.lock");
    let from = Instant::now();
    while !lock.exists() && from.elapsed() < Duration::from_secs(20) {
        std::thread::sleep(Duration::from_millis(5));
    }
    std::thread::sleep(Duration::from_millis(50));
    let second = campaign(dir.path(), "plan.toml -o c.parquet --format json");
    assert_eq!(second.code, 2, "{second:?}");
    let error = second.error();
    assert_eq!(error["kind"], "locked");
    assert!(error["message"].as_str().unwrap().contains("another process is writing to c.parquet.parts"));
    assert!(first.wait().unwrap().success());
    assert!(std::fs::read(dir.path().join("c.parquet")).unwrap() == expected);
}

/// A limit on the size of files stands for the full disk: writing fails in the middle of a file.
#[test]
fn a_full_disk_ends_in_a_clear_error_with_a_valid_store() {
    let dir = with_plan();
    let expected = reference(dir.path());
    let limited = |blocks: usize, out: &str| {
        let program = env!("CARGO_BIN_EXE_mckibben");
        // Ignored, the signal of the limit becomes the error that a full disk gives.
        let script = format!("trap '' XFSZ; ulimit -f {blocks}; exec {program} campaign plan.toml -o {out}");
        ran(Command::new("sh").args(["-c", &script]).current_dir(dir.path()).output().unwrap())
    };
    // Not one part fits; parts fit and the file does not.
    for (blocks, out, what) in
        [(4, "parts/", "parts/part-"), (4, "c.parquet", "c.parquet"), (60, "c.parquet", "c.parquet")]
    {
        let full = limited(blocks, out);
        assert_eq!(full.code, 2, "{full:?}");
        assert!(full.err.contains(&format!("error: cannot write {what}")), "{}", full.err);
        assert!(full.err.contains("the same command continues"), "{}", full.err);
        assert!(!dir.path().join("c.parquet").exists(), "nothing half-written");
        for entry in std::fs::read_dir(dir.path()).unwrap() {
            let name = entry.unwrap().file_name().to_string_lossy().into_owned();
            assert!(!name.starts_with(".unfinished"), "{name} is left");
        }
    }
    campaign(dir.path(), "plan.toml -o c.parquet").ok();
    campaign(dir.path(), "plan.toml -o parts/").ok();
    campaign(dir.path(), "merge parts -o merged.parquet").ok();
    assert!(std::fs::read(dir.path().join("c.parquet")).unwrap() == expected);
    assert!(std::fs::read(dir.path().join("merged.parquet")).unwrap() == expected);
}

#[test]
fn damaged_parts_are_named_and_other_plans_refused() {
    let dir = with_plan();
    std::fs::write(dir.path().join("small.toml"), PLAN.replace("120", "3").replace("true", "false")).unwrap();
    campaign(dir.path(), "small.toml -o parts").ok();
    let part = dir.path().join("parts/part-000001.parquet");
    let whole = std::fs::read(&part).unwrap();
    std::fs::write(&part, &whole[..1000]).unwrap();
    let merged = campaign(dir.path(), "merge parts -o m.parquet --format json");
    assert_eq!((merged.code, &merged.error()["kind"]), (2, &"damaged".into()));
    assert!(merged.err.contains("part-000001.parquet is damaged: it is cut off"), "{}", merged.err);
    let again = campaign(dir.path(), "small.toml -o parts").ok();
    assert!(
        again.err.contains("warning: parts/part-000001.parquet was damaged and is recomputed"),
        "{}",
        again.err
    );
    assert_eq!(std::fs::read(&part).unwrap(), whole);

    let other = campaign(dir.path(), "plan.toml -o parts --format json");
    assert_eq!((other.code, &other.error()["kind"]), (2, &"other_plan".into()));
    let shard = campaign(dir.path(), "plan.toml -o x.parquet --shard 1/2");
    assert_eq!(shard.code, 2);
    assert!(shard.err.contains("hint: give a folder"), "{}", shard.err);
    for wrong in [
        "plan.toml",
        "-o x.parquet",
        "nothing.toml -o x.parquet",
        "plan.toml -o x --shard 3/2",
        "show nothing",
    ] {
        assert_eq!(campaign(dir.path(), wrong).code, 2, "{wrong}");
    }
}
