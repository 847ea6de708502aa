//! The report as PDF, printed by a browser.

use crate::failure::Failure;
use mckibben_app::ProblemKind;
use std::process::{Command, Stdio};

/// A browser that prints.
pub(super) fn browser() -> Result<&'static str, Failure> {
    let names = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "msedge"];
    let runs = |name: &&&str| {
        let quiet = Command::new(name).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
        quiet.is_ok_and(|status| status.success())
    };
    names.iter().find(runs).copied().ok_or_else(|| {
        let message = "a PDF needs Chromium or Chrome, which is not installed";
        Failure::input(
            ProblemKind::Output,
            message,
            "install chromium, or write FILE.html and print that from any browser",
        )
    })
}

/// The page as PDF.
pub(super) fn printed(browser: &str, html: &str) -> Result<Vec<u8>, Failure> {
    let wrong = |why: String| {
        Failure::input(
            ProblemKind::Output,
            format!("{browser} could not print the page: {why}"),
            "print the HTML page",
        )
    };
    // A folder of its own that nobody else can write to, also for the browser's profile.
    let folder = tempfile::tempdir().map_err(|e| wrong(e.to_string()))?;
    let (page, pdf) = (folder.path().join("report.html"), folder.path().join("report.pdf"));
    std::fs::write(&page, html).map_err(|e| wrong(e.to_string()))?;
    let mut flags = vec!["--headless".to_owned(), "--disable-gpu".into(), "--no-pdf-header-footer".into()];
    flags.push(format!("--user-data-dir={}", folder.path().join("profile").display()));
    flags.push(format!("--print-to-pdf={}", pdf.display()));
    if is_root() {
        // Its sandbox refuses to work for root; the page is our own and has no script.
        flags.push("--no-sandbox".into());
    }
    let ran = Command::new(browser).args(flags).arg(&page).output().map_err(|e| wrong(e.to_string()))?;
    if !ran.status.success() {
        return Err(wrong(String::from_utf8_lossy(&ran.stderr).lines().last().unwrap_or_default().into()));
    }
    std::fs::read(&pdf).map_err(|e| wrong(e.to_string()))
}

fn is_root() -> bool {
    std::env::var_os("USER").or_else(|| std::env::var_os("HOME")).is_some_and(|v| v == "root" || v == "/root")
}
