//! The report as PDF, printed by a browser.

use crate::{Problem, progress};
use mckibben_app::ProblemKind;
use std::{
    fs::File,
    io,
    process::{Command, Stdio},
    time::Duration,
};
use tempfile::TempDir;

/// What names of folders of the browser begin with.
const FOLDER: &str = "mckibben-print-";
/// In such a folder, held while it is used.
const LOCK: &str = "lock";
/// How often the browser is looked after.
const TICK: Duration = Duration::from_millis(20);
/// How often the folder of a browser that was stopped is removed.
const SWEEPS: usize = 20;

/// A browser that prints.
pub fn browser() -> Result<&'static str, Problem> {
    let names = [
        "chromium",
        "chromium-browser",
        "google-chrome",
        "google-chrome-stable",
        "chrome",
        "msedge",
    ];
    let runs = |name: &&&str| {
        Command::new(name)
            .arg("--version")
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .status()
            .is_ok_and(|status| status.success())
    };
    names.iter().find(runs).copied().ok_or_else(|| {
        let message = "a PDF needs Chromium or Chrome, which is not installed";
        let hint = "install chromium, or write FILE.html and print that from any browser";
        Problem::new(ProblemKind::Output, message, hint)
    })
}

/// The page as PDF.
pub fn printed(browser: &str, html: &str) -> Result<Vec<u8>, Problem> {
    let wrong = |why: io::Error| {
        let message = format!("{browser} could not print the page: {why}");
        Problem::new(ProblemKind::Output, message, "print the HTML page")
    };
    let (folder, _lock) = folder().map_err(&wrong)?;
    let page = folder.path().join("report.html");
    let pdf = folder.path().join("report.pdf");
    std::fs::write(&page, html).map_err(&wrong)?;
    let mut flags = vec![
        "--headless".to_owned(),
        "--disable-gpu".into(),
        "--no-pdf-header-footer".into(),
    ];
    flags.push(format!(
        "--user-data-dir={}",
        folder.path().join("profile").display()
    ));
    flags.push(format!("--print-to-pdf={}", pdf.display()));
    if is_root() {
        // Its sandbox refuses to work for root; the page is made here and has no script.
        flags.push("--no-sandbox".into());
    }
    let said = File::create(folder.path().join("said")).map_err(&wrong)?;
    let mut command = Command::new(browser);
    let quiet = command
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(said);
    let mut child = quiet
        .args(flags)
        .arg(&page)
        .env("TMPDIR", folder.path())
        .spawn()
        .map_err(&wrong)?;
    let status = loop {
        if let Some(status) = child.try_wait().map_err(&wrong)? {
            break status;
        }
        if let Err(ended) = progress::ended() {
            // It may have ended by itself since.
            let _ = child.kill().and_then(|()| child.wait());
            // The processes that it started end after it, and write until then.
            for _ in 0..SWEEPS {
                let _ = std::fs::remove_dir_all(folder.path());
                std::thread::sleep(TICK);
            }
            return Err(ended);
        }
        std::thread::sleep(TICK);
    };
    progress::ended()?;
    if !status.success() {
        let said = std::fs::read_to_string(folder.path().join("said")).unwrap_or_default();
        return Err(wrong(io::Error::other(
            said.lines().last().unwrap_or_default(),
        )));
    }
    std::fs::read(&pdf).map_err(&wrong)
}

/// A folder of this user alone, also for the browser's profile, with the lock that holds it. Those
/// that killed programs left are removed.
fn folder() -> io::Result<(TempDir, File)> {
    for entry in std::fs::read_dir(std::env::temp_dir())
        .into_iter()
        .flatten()
        .flatten()
    {
        let left = |lock: File| lock.try_lock().is_ok();
        if entry.file_name().to_string_lossy().starts_with(FOLDER)
            && File::open(entry.path().join(LOCK)).is_ok_and(left)
        {
            // Nothing depends on it.
            let _ = std::fs::remove_dir_all(entry.path());
        }
    }
    let folder = tempfile::Builder::new().prefix(FOLDER).tempdir()?;
    let lock = File::create(folder.path().join(LOCK))?;
    let _ = lock.try_lock();
    Ok((folder, lock))
}

fn is_root() -> bool {
    std::env::var_os("USER")
        .or_else(|| std::env::var_os("HOME"))
        .is_some_and(|v| v == "root" || v == "/root")
}
