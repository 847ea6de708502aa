//! How a process ends: by a signal, without memory, disk, threads or reader.
#![cfg(unix)]

use crate::common::{Ran, command, ended, folder, mckibben, names, ran, root};
use std::{
    fs,
    os::unix::{ffi::OsStrExt, fs::PermissionsExt, process::CommandExt},
    path::Path,
    process::{Command, Stdio},
    time::Duration,
};

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error_and_no_panic() {
    let full = fs::OpenOptions::new().write(true).open("/dev/full");
    let full = full.unwrap();
    let full = || full.try_clone().unwrap();
    for line in [
        "--version",
        "parts list models",
        "force -p 0.2",
        "curve isobaric",
        "completions bash",
    ] {
        let result = ran(command(&root())
            .args(line.split(' '))
            .stdout(full())
            .output()
            .unwrap());
        assert!(
            result.code == 2 && result.err.contains("cannot write to standard output"),
            "{line}: {result:?}"
        );
    }
    let result = mckibben("parts list models -o /dev/full");
    assert!(
        result.code == 2 && result.err.contains("cannot write /dev/full"),
        "{}",
        result.err
    );
    // Warnings that nobody can read do not spoil the result.
    let args = "force -p 0.3 --model paper --extrapolate".split(' ');
    ran(command(&root()).args(args).stderr(full()).output().unwrap()).ok();
    // A file may not grow beyond some kilobytes.
    let dir = folder();
    let line = "curve isobaric --model ideal -p 0..0.25:0.001 -e 0..0.1:0.01";
    for out in ["-o long.csv", "--plot long.svg"] {
        let run = limited(dir.path(), "-f 8", &format!("{line} {out}"));
        assert!(
            run.code == 2 && run.err.contains("File too large"),
            "{out}: {run:?}"
        );
        assert!(names(dir.path()).is_empty(), "{out}");
    }
}

/// Runs a line under a limit of the shell.
fn limited(dir: &Path, limit: &str, line: &str) -> Ran {
    let script = format!(
        "ulimit {limit} && exec {} {line}",
        env!("CARGO_BIN_EXE_mckibben")
    );
    ran(Command::new("sh")
        .args(["-c", &script])
        .current_dir(dir)
        .output()
        .unwrap())
}

/// A hundred thousand points in 300 MB of addresses; and a mesh in 2 GB that is refused.
#[test]
fn a_curve_of_many_points_in_json_takes_little_memory() {
    let line =
        "curve isobaric --model ideal -p 0.001..0.25:0.001 -e 0..0.1596:0.0004 --format json";
    let answer = limited(&root(), "-v 300000", line).ok().json();
    assert_eq!(answer["points"].as_array().unwrap().len(), 250 * 400);
    let run = limited(
        &root(),
        "-v 2000000",
        "simulate --model fe3d --mesh 8x64x400",
    );
    assert!(
        run.code == 2 && run.err.contains(" bytes, and the limit is 4 000 000 000"),
        "{run:?}"
    );
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    for line in [
        "completions bash",
        "curve isobaric --model ideal -p 0..0.25:0.001 -e 0..0.2:0.001 --format json",
    ] {
        let mut command = command(&root());
        let command = command
            .args(line.split(' '))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        drop(child.stdout.take());
        let result = ran(child.wait_with_output().unwrap());
        assert_eq!((result.code, result.err.as_str()), (0, ""), "{line}");
    }
}

#[test]
fn bytes_that_are_no_text_are_refused() {
    let mut command = command(&root());
    let command = command
        .args(["force", "--format", "json", "-p"])
        .arg(std::ffi::OsStr::from_bytes(b"0.2\xff"));
    let run = ran(command.output().unwrap());
    assert_eq!((run.code, &run.error()["kind"]), (2, &"usage".into()));
}

/// What every command does with its caller's flag stands in the tests of the application layer. A
/// command that had not noticed the signal would end with 0; one that waits for its reader has
/// nothing to notice it with.
#[test]
fn a_signal_ends_a_command_that_works_and_one_that_waits_with_130() {
    let works = "curve isobaric --mesh 2x512 -p 0..2.5:0.1bar -e 0..0.15:0.001";
    // As long as the pipe is full.
    for (line, stdout) in [(works, Stdio::null()), ("schema", Stdio::piped())] {
        let mut command = command(&root());
        let command = command.args(line.split(' ')).stdout(stdout);
        let mut child = command.stderr(Stdio::null()).spawn().unwrap();
        std::thread::sleep(Duration::from_millis(500));
        // SAFETY: a signal to a child of this process.
        unsafe { libc::kill(child.id() as i32, libc::SIGINT) };
        let reader = child.stdout.take();
        assert_eq!(ended(child).status.code(), Some(130), "{line}");
        drop(reader);
    }
}

/// A user whom nobody else is, and who may have one process: a second thread is refused.
///
/// Limits of processes do not hold for root, who has to become somebody else for that.
fn alone(command: &mut Command, user: u32) {
    let limit = libc::rlimit {
        rlim_cur: 1,
        rlim_max: 1,
    };
    let become_alone = move || {
        // SAFETY: plain system calls, as may stand between fork and exec.
        let done = unsafe {
            libc::setrlimit(libc::RLIMIT_NPROC, &limit) == 0
                && (libc::geteuid() != 0 || libc::setuid(user) == 0)
        };
        if done {
            Ok(())
        } else {
            Err(std::io::Error::last_os_error())
        }
    };
    // SAFETY: what runs between fork and exec allocates nothing.
    unsafe { command.pre_exec(become_alone) };
}

/// Copies the program by a separate process: a file that this one has open for writing is inherited
/// by what another test starts at that instant, and cannot be executed for as long ("text file
/// busy").
fn place_program(dir: &Path) {
    fs::set_permissions(dir, fs::Permissions::from_mode(0o777)).unwrap();
    let copied = Command::new("cp")
        .arg(env!("CARGO_BIN_EXE_mckibben"))
        .arg(dir.join("mckibben"))
        .status();
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
    place_program(dir);
    for file in [
        "examples/bench.toml",
        "examples/bench.csv",
        "data/campaign/paper.csv",
    ] {
        let from = root().join(file);
        fs::copy(&from, dir.join(from.file_name().unwrap())).unwrap();
    }
    let plan = "[vary]\ntube.outer_diameter = \"30,40 mm\"\n[test]\ncontractions \
        = \"0,10%\"\npressures = \"0.1,0.2\"\n";
    fs::write(dir.join("plan.toml"), plan).unwrap();
    let nobody = Some(100_000 + std::process::id());
    for line in [
        "design --force 700N --contraction 15% --max-pressure 2.5bar --format json",
        "identify bench.toml --data bench.csv --format json",
        "fit paper.csv --method paper --format json",
    ] {
        let (many, single) = (runs(dir, line, None).ok(), runs(dir, line, nobody).ok());
        assert!(
            many.out == single.out,
            "{line}: {}\n{}",
            many.text(),
            single.text()
        );
        let warned = single.err.contains("warning: cannot start threads: ");
        assert!(warned || line.starts_with("fit"), "{line}: {}", single.err);
    }
    runs(dir, "campaign plan.toml -o many.parquet", None).ok();
    for threads in ["", "--threads 1"] {
        runs(
            dir,
            &format!("campaign plan.toml -o single.parquet {threads}"),
            nobody,
        )
        .ok();
        let table = |name: &str| fs::read(dir.join(name)).unwrap();
        assert!(table("single.parquet") == table("many.parquet"));
        fs::remove_file(dir.join("single.parquet")).unwrap();
    }
    let refused = runs(dir, "campaign plan.toml -o two.parquet --threads 2", nobody);
    assert!(
        refused.code == 2 && refused.err.contains("hint: take fewer threads"),
        "{refused:?}"
    );
}
