//! Where the system gives no threads: every command that works side by side answers by one, with the same bytes.
#![cfg(unix)]

use crate::common::{Ran, folder, ran, root};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::Command;

const PLAN: &str =
    "[vary]\ntube.outer_diameter = \"30,40 mm\"\n[test]\ncontractions = \"0,10%\"\npressures = \"0.1,0.2\"\n";

/// A user whom nobody else is, and who may have one process: a second thread is refused.
///
/// Limits of processes do not hold for root, who has to become somebody else for that.
fn alone(command: &mut Command, user: u32) {
    let limit = libc::rlimit { rlim_cur: 1, rlim_max: 1 };
    let become_alone = move || {
        // SAFETY: plain system calls, as may stand between fork and exec.
        let done = unsafe {
            libc::setrlimit(libc::RLIMIT_NPROC, &limit) == 0
                && (libc::geteuid() != 0 || libc::setuid(user) == 0)
        };
        if done { Ok(()) } else { Err(std::io::Error::last_os_error()) }
    };
    // SAFETY: what runs between fork and exec allocates nothing.
    unsafe { command.pre_exec(become_alone) };
}

/// Copies the program by a process of its own: a file that this one has open for writing is inherited by what another test starts at that
/// instant, and cannot be executed for as long ("text file busy").
fn place_program(dir: &Path) {
    let copied = Command::new("cp").arg(env!("CARGO_BIN_EXE_mckibben")).arg(dir.join("mckibben")).status();
    assert!(copied.unwrap().success());
}

/// Runs a line, with as many threads as the system gives or with the calling one alone.
fn runs(dir: &Path, line: &str, user: Option<u32>) -> Ran {
    let mut command = Command::new(dir.join("mckibben"));
    command.current_dir(dir).args(line.split_whitespace());
    if let Some(user) = user {
        alone(&mut command, user);
    }
    ran(command.output().unwrap())
}

#[test]
fn without_threads_the_answers_are_the_same_bytes() {
    let dir = folder();
    let dir = dir.path();
    // For that user as well, wherever the repository lies.
    fs::set_permissions(dir, fs::Permissions::from_mode(0o777)).unwrap();
    place_program(dir);
    for file in ["examples/bench.toml", "examples/bench.csv", "data/campaign/paper.csv"] {
        let from = root().join(file);
        fs::copy(&from, dir.join(from.file_name().unwrap())).unwrap();
    }
    fs::write(dir.join("plan.toml"), PLAN).unwrap();
    let nobody = Some(100_000 + std::process::id());
    for line in [
        "design --force 700N --contraction 15% --max-pressure 2.5bar --format json",
        "identify bench.toml --data bench.csv --format json",
        "validate --sweep 5 --format json",
        "fit paper.csv --method paper --format json",
    ] {
        let (many, single) = (runs(dir, line, None).ok(), runs(dir, line, nobody).ok());
        assert!(many.out == single.out, "{line}: {}\n{}", many.text(), single.text());
        let warned = single.err.contains("warning: cannot start threads: ");
        assert!(warned || line.starts_with("fit"), "{line}: {}", single.err);
    }
    runs(dir, "campaign plan.toml -o many.parquet", None).ok();
    for threads in ["", "--threads 1"] {
        runs(dir, &format!("campaign plan.toml -o single.parquet {threads}"), nobody).ok();
        let table = |name: &str| fs::read(dir.join(name)).unwrap();
        assert!(table("single.parquet") == table("many.parquet"));
        fs::remove_file(dir.join("single.parquet")).unwrap();
    }
    let refused = runs(dir, "campaign plan.toml -o two.parquet --threads 2", nobody);
    assert_eq!(refused.code, 2, "{refused:?}");
    assert!(refused.err.contains("error: cannot start threads: "), "{}", refused.err);
    assert!(refused.err.contains("hint: take fewer threads"), "{}", refused.err);
}

/// One thread more would be needed to answer: that is said, and no address is printed.
#[test]
fn without_threads_a_server_says_that_it_cannot_answer() {
    let dir = folder();
    fs::set_permissions(dir.path(), fs::Permissions::from_mode(0o777)).unwrap();
    place_program(dir.path());
    let run = runs(dir.path(), "serve --port 0", Some(300_000 + std::process::id()));
    assert!(run.code == 2 && run.out.is_empty(), "{run:?}");
    assert!(run.err.contains("the system gives it no thread"), "{}", run.err);
}
