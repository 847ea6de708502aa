//! Campaigns as a user runs them: killed, interrupted, twice at once, on a full disk.
#![cfg(unix)]

use crate::common::{Ran, command, folder, names, ran, run_in};
use mckibben_core::random::Random;
use serde_json::Value;
use std::{
    path::Path,
    process::{Child, Command, Stdio},
    time::{Duration, Instant},
};
use tempfile::TempDir;

/// A campaign of some seconds.
const PLAN: &str = "[sampling]\nmethod = \"sobol\"\nsamples = 120\nseed = 5\n\
    [vary]\ntube.outer_diameter = \"20..50 mm\"\ntube.wall_ratio = \"4..12%\"\nbraid.angle \
    = \"22..32\"\n\
    [test]\ncontractions = \"0,5,10%\"\npressures = \"0.05..0.3:0.05\"\nsensitivities = true\n";

fn with_plan() -> TempDir {
    let dir = folder();
    std::fs::write(dir.path().join("plan.toml"), PLAN).unwrap();
    dir
}

fn campaign(dir: &Path, words: &str) -> Ran {
    run_in(dir, &format!("campaign {words}"))
}

fn started(dir: &Path, out: &str) -> Child {
    let mut command = command(dir);
    command.args(["campaign", "plan.toml", "-o", out, "--quiet"]);
    command
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

fn reference(dir: &Path) -> Vec<u8> {
    campaign(dir, "plan.toml -o reference.parquet").ok();
    std::fs::read(dir.join("reference.parquet")).unwrap()
}

fn signal(child: &Child, name: &str) {
    Command::new("kill")
        .args([&format!("-{name}"), &child.id().to_string()])
        .status()
        .unwrap();
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
        let store = if out == "parts" {
            "parts"
        } else {
            "file.parquet.parts"
        };
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
        let last = campaign(dir.path(), &format!("plan.toml -o {out} --format json"))
            .ok()
            .json();
        assert_eq!(
            (&last["muscles"], &last["complete"]),
            (&120.into(), &true.into()),
            "{last}"
        );
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

/// A limit on the size of files stands for the full disk: writing fails in the middle of a file.
#[test]
fn a_full_disk_ends_in_a_clear_error_with_a_valid_store() {
    let dir = with_plan();
    let expected = reference(dir.path());
    let limited = |blocks: usize, out: &str| {
        let program = env!("CARGO_BIN_EXE_mckibben");
        // Ignored, the signal of the limit becomes the error that a full disk gives.
        let script =
            format!("trap '' XFSZ; ulimit -f {blocks}; exec {program} campaign plan.toml -o {out}");
        ran(Command::new("sh")
            .args(["-c", &script])
            .current_dir(dir.path())
            .output()
            .unwrap())
    };
    // Not one part fits; parts fit and the file does not.
    for (blocks, out, what) in [
        (4, "parts/", "parts/part-"),
        (4, "c.parquet", "c.parquet"),
        (60, "c.parquet", "c.parquet"),
    ] {
        let full = limited(blocks, out);
        assert_eq!(full.code, 2, "{full:?}");
        assert!(
            full.err.contains(&format!("error: cannot write {what}")),
            "{}",
            full.err
        );
        assert!(
            full.err.contains("the same command continues"),
            "{}",
            full.err
        );
        assert!(
            !dir.path().join("c.parquet").exists(),
            "nothing half-written"
        );
        assert!(
            !names(dir.path())
                .iter()
                .any(|name| name.starts_with(".unfinished"))
        );
    }
    campaign(dir.path(), "plan.toml -o c.parquet").ok();
    campaign(dir.path(), "plan.toml -o parts/").ok();
    campaign(dir.path(), "merge parts -o merged.parquet").ok();
    assert!(std::fs::read(dir.path().join("c.parquet")).unwrap() == expected);
    assert!(std::fs::read(dir.path().join("merged.parquet")).unwrap() == expected);
}

#[test]
fn damaged_parts_are_named() {
    let dir = with_plan();
    std::fs::write(
        dir.path().join("small.toml"),
        PLAN.replace("120", "3").replace("true", "false"),
    )
    .unwrap();
    campaign(dir.path(), "small.toml -o parts").ok();
    let part = dir.path().join("parts/part-000001.parquet");
    let whole = std::fs::read(&part).unwrap();
    std::fs::write(&part, &whole[..1000]).unwrap();
    let merged = campaign(dir.path(), "merge parts -o m.parquet --format json");
    assert_eq!(
        (merged.code, &merged.error()["kind"]),
        (2, &"damaged".into())
    );
    assert!(
        merged.err.contains("part-000001.parquet is damaged"),
        "{}",
        merged.err
    );
    let again = campaign(dir.path(), "small.toml -o parts").ok();
    assert!(
        again
            .err
            .contains("warning: parts/part-000001.parquet is recomputed"),
        "{}",
        again.err
    );
    assert_eq!(std::fs::read(&part).unwrap(), whole);
}

fn shard(dir: &Path, plan: &str, out: &str, share: &str) -> Child {
    let mut command = command(dir);
    command.args([
        "campaign",
        plan,
        "-o",
        out,
        "--shard",
        share,
        "--threads",
        "1",
        "--quiet",
    ]);
    command
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// Four shards, two at once; a random one is killed twenty times, and started again.
#[test]
fn shards_killed_twenty_times_give_the_same_bytes() {
    let dir = with_plan();
    let expected = reference(dir.path());
    let mut random = Random(11);
    let mut killed = 0;
    for round in 0..20 {
        let shares = [1 + round % 4, 1 + (round + 1) % 4];
        let [mut one, mut other] =
            shares.map(|i| shard(dir.path(), "plan.toml", "parts", &format!("{i}/4")));
        std::thread::sleep(Duration::from_millis(random.bits() % 150));
        one.kill().unwrap();
        killed += i32::from(!one.wait().unwrap().success());
        other.kill().unwrap();
        other.wait().unwrap();
    }
    assert!(killed > 5, "they were too fast to be killed");
    for i in 1..=4 {
        assert!(
            shard(dir.path(), "plan.toml", "parts", &format!("{i}/4"))
                .wait()
                .unwrap()
                .success()
        );
    }
    campaign(dir.path(), "merge parts -o merged.parquet").ok();
    assert!(std::fs::read(dir.path().join("merged.parquet")).unwrap() == expected);
    let left = names(&dir.path().join("parts"));
    let left: Vec<&String> = left
        .iter()
        .filter(|name| name.starts_with(".unfinished-part"))
        .collect();
    assert!(
        left.is_empty(),
        "what killed shards left is removed: {left:?}"
    );
}

fn state(status: &Value, share: usize) -> (&str, u64) {
    let shard = &status["shards"][share - 1];
    (
        shard["state"].as_str().unwrap(),
        shard["parts"].as_u64().unwrap(),
    )
}

#[test]
fn the_summary_names_a_shard_that_died_and_the_same_shard_fills_the_gap() {
    let dir = with_plan();
    let status = |code| {
        let ran = campaign(dir.path(), "show parts --format json");
        assert_eq!(ran.code, code, "{ran:?}");
        ran.json()
    };
    assert_eq!(
        campaign(dir.path(), "show parts").code,
        2,
        "there is nothing yet"
    );
    assert!(
        shard(dir.path(), "plan.toml", "parts", "1/3")
            .wait()
            .unwrap()
            .success()
    );
    let first = status(1);
    assert_eq!(
        (state(&first, 1).0, state(&first, 2), state(&first, 3).0),
        ("done", ("missing", 0), "missing")
    );
    assert_eq!(
        (&first["missing_parts"], &first["complete"]),
        (&80.into(), &false.into())
    );

    let mut child = shard(dir.path(), "plan.toml", "parts", "2/3");
    let from = Instant::now();
    while !dir.path().join("parts/part-000001.parquet").exists()
        && from.elapsed() < Duration::from_secs(30)
    {
        std::thread::sleep(Duration::from_millis(5));
    }
    // It holds its lock and goes no further while it is looked at.
    signal(&child, "STOP");
    let running = campaign(dir.path(), "show parts --format json").json();
    assert_eq!(state(&running, 2).0, "running", "{running}");
    // The same shard once more is refused, and the first is not disturbed.
    let second = campaign(dir.path(), "plan.toml -o parts --shard 2/3 --format json");
    assert_eq!(
        (second.code, &second.error()["kind"]),
        (2, &"locked".into())
    );
    child.kill().unwrap();
    child.wait().unwrap();
    let died = status(1);
    assert_eq!(
        [state(&died, 2).0, state(&died, 3).0],
        ["missing"; 2],
        "{died}"
    );

    // A part that was cut on its way is missing, and is named.
    let part = dir.path().join("parts/part-000000.parquet");
    let whole = std::fs::read(&part).unwrap();
    std::fs::write(&part, &whole[..whole.len() / 2]).unwrap();
    let cut = status(1);
    assert_eq!(
        (state(&cut, 1), cut["damaged"].as_array().unwrap().len()),
        (("missing", 39), 1)
    );
    for i in 1..=3 {
        assert!(
            shard(dir.path(), "plan.toml", "parts", &format!("{i}/3"))
                .wait()
                .unwrap()
                .success()
        );
    }
    let last = status(0);
    assert_eq!(
        (&last["complete"], &last["missing_parts"], &last["muscles"]),
        (&true.into(), &0.into(), &120.into())
    );
    assert_eq!(std::fs::read(&part).unwrap(), whole);
}

#[test]
fn a_worker_with_another_plan_or_version_is_refused_before_it_computes() {
    let dir = with_plan();
    std::fs::write(
        dir.path().join("other.toml"),
        PLAN.replace("seed = 5", "seed = 6"),
    )
    .unwrap();
    assert!(
        shard(dir.path(), "plan.toml", "parts", "1/60")
            .wait()
            .unwrap()
            .success()
    );
    let other = campaign(dir.path(), "other.toml -o parts --shard 2/60 --format json");
    assert_eq!(
        (other.code, &other.error()["kind"]),
        (2, &"other_plan".into())
    );
    let marker = dir.path().join("parts/.campaign.json");
    let text = std::fs::read_to_string(&marker).unwrap();
    let version = concat!("\"version\":\"", env!("CARGO_PKG_VERSION"));
    assert!(text.contains(version), "{text}");
    std::fs::write(&marker, text.replace(version, "\"version\":\"9.9.9")).unwrap();
    let older = campaign(dir.path(), "plan.toml -o parts --shard 2/60 --format json");
    assert!(
        older.err.contains("was written by mckibben 9.9.9"),
        "{}",
        older.err
    );
    let parts = names(&dir.path().join("parts"));
    assert_eq!(
        parts
            .iter()
            .filter(|name| name.starts_with("part-"))
            .count(),
        2
    );
}

#[test]
fn each_mistake_of_a_plan_stands_on_a_line_of_its_own() {
    let dir = folder();
    let plan = PLAN.replace("120", "0").replace("22..32", "32..22");
    std::fs::write(dir.path().join("plan.toml"), plan).unwrap();
    for words in ["plan.toml --dry-run", "plan.toml -o out.parquet"] {
        let errors = campaign(dir.path(), words).err;
        let starts = ["error: plan.toml:3:", "error: plan.toml:8:"];
        let lines: Vec<&str> = errors.lines().collect();
        assert_eq!(lines.len(), starts.len(), "{errors}");
        for (line, start) in lines.iter().zip(starts) {
            assert!(line.starts_with(start), "{errors}");
        }
    }
}
