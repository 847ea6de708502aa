//! `report`: all that is known of a muscle, as one file.

use crate::failure::Failure;
use crate::flags::{MuscleFlags, UnitsFlag};
use crate::format::Format;
use crate::output::{check_ending, emit, ending, json, save, warn};
use crate::progress::Bar;
use crate::quantities::{contraction, quantity};
use crate::shown;
use clap::Args;
use mckibben::units::Dimension;
use mckibben::warning::is_of_burst;
use mckibben_app::{ProblemKind, ReportRequest, TitleBlock, report};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

pub const EXAMPLES: &str = "Examples:
  mckibben report examples/prototype.toml -o muscle.html
  mckibben report -D 38 -s 1 -p 2.5bar -e 15% -o muscle.html";

const TITLE_BLOCK: &str = "Title block";

/// `report`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct ReportArgs {
    /// Pressure of the state in the report [0.25]
    #[arg(short, long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    /// Contraction of that state [half of the free contraction]
    #[arg(short = 'e', long, value_name = "RATIO", allow_hyphen_values = true)]
    pub contraction: Option<String>,
    /// Name of the muscle in the title block
    #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true, help_heading = TITLE_BLOCK)]
    pub name: String,
    /// Project [a field to fill in]
    #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true, help_heading = TITLE_BLOCK)]
    pub project: String,
    /// Number of the document [a field to fill in]
    #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true, help_heading = TITLE_BLOCK)]
    pub number: String,
    /// Revision of the document [a field to fill in]
    #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true, help_heading = TITLE_BLOCK)]
    pub revision: String,
    /// Date of the document [a field to fill in]
    #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true, help_heading = TITLE_BLOCK)]
    pub date: String,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub units: UnitsFlag,
    /// Write the page to a file instead of standard output; FILE.pdf acts as --pdf
    #[arg(short, long, value_name = "FILE.html", help_heading = "Output")]
    pub output: Option<PathBuf>,
    /// Also write a PDF (needs an installed Chromium)
    #[arg(long, value_name = "FILE.pdf", help_heading = "Output")]
    pub pdf: Option<PathBuf>,
}

pub fn run(args: &ReportArgs, format: Format) -> Result<u8, Failure> {
    let printed_too = args.output.as_deref().filter(|path| ending(path).as_deref() == Some("pdf"));
    let page = args.output.as_deref().filter(|_| printed_too.is_none());
    let endings: &[&str] = match format {
        Format::Text => &["html", "htm"],
        Format::Json => &["json"],
        Format::Csv => {
            let message = "--format csv: a report is a page, and has no table";
            return Err(Failure::input(ProblemKind::Usage, message, "leave it out, or take json"));
        }
    };
    check_ending(page, endings)?;
    let pdfs: Vec<&Path> = args.pdf.as_deref().into_iter().chain(printed_too).collect();
    pdfs.iter().try_for_each(|path| check_ending(Some(path), &["pdf"]))?;
    let browser = pdfs.first().map(|_| browser()).transpose()?;
    let request = ReportRequest {
        muscle: args.muscle.fields()?,
        pressure_mpa: quantity("--pressure", args.pressure.as_deref(), Dimension::Pressure)?,
        contraction: contraction("--contraction", args.contraction.as_deref())?,
        units: shown::units(),
        title_block: TitleBlock {
            name: args.name.clone(),
            project: args.project.clone(),
            number: args.number.clone(),
            revision: args.revision.clone(),
            date: args.date.clone(),
        },
        html: false,
    };
    let answer = report(&request, &Bar::new("parts"))?;
    answer.warnings.iter().filter(|w| is_of_burst(w)).for_each(warn);
    if let Some(browser) = browser {
        let bytes = printed(browser, &answer.document.to_html("")?)?;
        pdfs.iter().try_for_each(|path| save(Some(path), &bytes))?;
    }
    if page.is_none() && !pdfs.is_empty() {
        return Ok(0);
    }
    let text = match format {
        Format::Json => format!("{:#}\n", json(&answer)?),
        _ => answer.document.to_html(&mckibben_web::viewer())?,
    };
    emit(text, page)?;
    Ok(0)
}

/// A browser that prints.
fn browser() -> Result<&'static str, Failure> {
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
fn printed(browser: &str, html: &str) -> Result<Vec<u8>, Failure> {
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
