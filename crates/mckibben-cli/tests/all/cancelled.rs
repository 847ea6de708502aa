//! What does not fit into memory is refused at once, with an estimate and the limit; what is to end ends.

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
fn what_does_not_fit_is_refused_with_an_estimate_and_the_limit() {
    let dir = folder();
    let alphas = ["2.0"; 2000].join(",");
    let law = format!(
        "[tube.material]\nlaw = \"ogden\"\nmu = [{}]\nalpha = [{alphas}]\n",
        alphas.replace("2.0", "0.001")
    );
    std::fs::write(dir.path().join("ogden.toml"), law).unwrap();
    for (line, says) in [
        ("simulate --model fe3d --mesh 16x256x2048", "8 388 608 elements, and the limit is 250 000"),
        ("simulate --model fe3d --mesh 8x64x400", " bytes, and the limit is 4 000 000 000"),
        ("force --model fe --mesh 16x1024 -p 0.2", "the number of elements is 16384"),
        (
            "curve isobaric --model ideal -p 0..0.25:0.00025 -e 0..0.1996:0.0002 --format csv",
            "bytes, and the limit",
        ),
        ("force --muscle ogden.toml -p 0.2", "at most 20 terms"),
    ] {
        let run = bounded(dir.path(), line);
        assert_eq!(run.code, 2, "{line}: {run:?}");
        assert!(run.err.contains(says), "{line}: {}", run.err);
    }
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

/// Lines that take long, one of every command that may.
const LONG: [&str; 12] = [
    "simulate --model fe3d --mesh 2x24x78 -p 0..2.5:0.01bar",
    "curve isobaric --mesh 2x512 -p 0..2.5:0.1bar -e 0..0.15:0.001",
    "curve --study thickness --mesh 4x512",
    "validate --sweep 100000",
    "validate --all",
    "validate --measured",
    "fit --report",
    "joint examples/elbow.toml --map 60 --max-pressure 3bar",
    "motion --muscle examples/prototype.toml --load mass:1kg -p 2bar --valve festo-mh2 --until 500s --model fe",
    "compare --models fe,thick-wall -p 0..2.5:0.02bar -e 0..0.15:0.001",
    "identify --muscle examples/bench.toml --data examples/bench.csv --mesh 4x512",
    "design --joint 8Nm@45deg,3Nm@60deg --max-pressure 6bar --model fe",
];

#[cfg(unix)]
#[test]
fn a_signal_ends_every_command_within_a_second_with_130() {
    use std::time::{Duration, Instant};
    for line in LONG {
        let mut child = Command::new(env!("CARGO_BIN_EXE_mckibben"))
            .args(line.split_whitespace())
            .current_dir(root())
            .stdout(std::process::Stdio::null())
            .stderr(std::process::Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(400));
        assert!(child.try_wait().unwrap().is_none(), "{line}: it was to be long");
        // SAFETY: a signal to a child of one's own.
        unsafe { libc::kill(child.id() as i32, libc::SIGINT) };
        let since = Instant::now();
        let code = child.wait().unwrap().code();
        assert_eq!(code, Some(130), "{line}");
        // Twice the time, for machines that do something else as well.
        assert!(since.elapsed() < Duration::from_secs(2), "{line}: {:?}", since.elapsed());
    }
}

#[test]
fn meshes_of_a_campaign_that_do_not_fit_are_refused() {
    let dir = folder();
    let solid =
        LARGE.replace("[test]", "[test]\nmodel = \"fe3d\"\nmesh = \"16x256x2048\"").replace("65536", "4");
    std::fs::write(dir.path().join("solid.toml"), solid).unwrap();
    let run = bounded(dir.path(), "campaign solid.toml -o a.parquet");
    assert!(run.code == 2 && run.err.contains(" elements, and the limit is 250 000"), "{run:?}");
    assert!(!dir.path().join("a.parquet").exists());
}

/// A file may not grow beyond some kilobytes: that is said, and nothing is left of it.
#[cfg(unix)]
#[test]
fn a_limit_of_file_sizes_is_an_error_and_leaves_nothing() {
    let dir = folder();
    let program = env!("CARGO_BIN_EXE_mckibben");
    for line in [
        "curve isobaric --model ideal -p 0..0.25:0.001 -e 0..0.1:0.01 -o long.csv",
        "curve isobaric --model ideal -p 0..0.25:0.001 -e 0..0.1:0.01 --plot long.svg",
    ] {
        let script = format!("ulimit -f 8 && exec {program} {line}");
        let run = ran(Command::new("sh").args(["-c", &script]).current_dir(dir.path()).output().unwrap());
        assert!(run.code == 2 && run.err.contains("File too large"), "{line}: {run:?}");
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 0, "{line}");
    }
}

/// Five thousand threads would take seconds to start, and help nobody.
#[test]
fn an_absurd_number_of_threads_costs_no_time() {
    let from = std::time::Instant::now();
    let mut command = Command::new(env!("CARGO_BIN_EXE_mckibben"));
    let line = ["validate", "--sweep", "3"];
    ran(command.args(line).env("RAYON_NUM_THREADS", "5000").output().unwrap()).ok();
    assert!(from.elapsed().as_secs() < 3, "{:?}", from.elapsed());
}
