//! What would take too much is refused at once, with an estimate and the limit's name; what is to end ends.

use crate::common::{Ran, folder, ran, root};
use std::path::Path;
use std::process::Command;

/// Runs a line with two gigabytes of addresses, and no more.
fn bounded(dir: &Path, line: &str) -> Ran {
    let program = env!("CARGO_BIN_EXE_mckibben");
    let script = format!("ulimit -v 2000000 && exec {program} {line}");
    ran(Command::new("sh").args(["-c", &script]).current_dir(dir).output().unwrap())
}

const LARGE: &str = "[sampling]\nmethod = \"sobol\"\nsamples = 65536\n[vary]\ntube.outer_diameter = \"10..60 mm\"\n\
                     [test]\ncontractions = \"0..30:0.1%\"\npressures = \"0..3:0.01bar\"\n";

#[test]
fn what_does_not_fit_is_refused_with_an_estimate_and_the_name_of_the_limit() {
    let dir = folder();
    std::fs::write(dir.path().join("large.toml"), LARGE).unwrap();
    let alphas = ["2.0"; 2000].join(",");
    let law = format!(
        "[tube.material]\nlaw = \"ogden\"\nmu = [{}]\nalpha = [{alphas}]\n",
        alphas.replace("2.0", "0.001")
    );
    std::fs::write(dir.path().join("ogden.toml"), law).unwrap();
    for (line, says) in [
        ("simulate --model fe3d --mesh 16x256x2048", "8 388 608 elements, and the limit is 250 000"),
        ("simulate --model fe3d --mesh 8x64x400 --limit bytes=1e9", " bytes, and the limit is 1 000 000 000"),
        ("force -p 0.2 --model fe3d --limit seconds=0.001", " seconds, and the limit is 0"),
        ("force -p 0.2 --model fe3d --limit factorisations=2", "the limit of 2 factorisations is used up"),
        ("force --model fe --mesh 16x1024 -p 0.2", "the number of elements is 16384"),
        (
            "curve isobaric --model ideal -p 0..0.25:0.00025 -e 0..0.1996:0.0002 --format csv",
            "bytes, and the limit",
        ),
        ("force --muscle ogden.toml -p 0.2", "at most 20 terms"),
        ("campaign large.toml -o large.parquet", "points: about"),
        ("force -p 0.2 --limit apples=3", "points, elements, bytes, factorisations, seconds"),
    ] {
        let run = bounded(dir.path(), line);
        assert_eq!(run.code, 2, "{line}: {run:?}");
        assert!(run.err.contains(says), "{line}: {}", run.err);
    }
    let large = bounded(dir.path(), "campaign large.toml -o large.parquet");
    assert!(large.err.contains("GB") && large.err.contains("--yes"), "{}", large.err);
    assert!(!dir.path().join("large.parquet").exists());
}

/// A hundred thousand points in 300 MB of addresses, printed as they are computed.
#[test]
fn a_curve_in_json_is_printed_as_it_is_computed() {
    let program = env!("CARGO_BIN_EXE_mckibben");
    let line = "curve isobaric --model ideal -p 0.001..0.25:0.001 -e 0..0.1596:0.0004 --format json";
    let script = format!("ulimit -v 300000 && exec {program} {line}");
    let run = ran(Command::new("sh").args(["-c", &script]).output().unwrap());
    assert_eq!(run.code, 0, "{}", run.err);
    let answer: serde_json::Value = serde_json::from_slice(&run.out).unwrap();
    assert_eq!(answer["points"].as_array().unwrap().len(), 250 * 400);
    assert_eq!(answer["model"], "ideal");
}

#[cfg(unix)]
#[test]
fn a_signal_ends_long_work_within_a_second() {
    use std::time::{Duration, Instant};
    let mut child = Command::new(env!("CARGO_BIN_EXE_mckibben"))
        .args(["simulate", "--model", "fe3d", "--mesh", "2x24x78", "-p", "0..2.5:0.01bar"])
        .current_dir(root())
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_millis(1500));
    assert!(child.try_wait().unwrap().is_none(), "it was to be long");
    // SAFETY: a signal to a child of one's own.
    unsafe { libc::kill(child.id() as i32, libc::SIGTERM) };
    let since = Instant::now();
    let code = child.wait().unwrap().code();
    assert!(code.is_some_and(|code| code == 130 || code == 3), "{code:?}");
    // Twice the time, for machines that do something else as well.
    assert!(since.elapsed() < Duration::from_secs(2), "{:?}", since.elapsed());
}
