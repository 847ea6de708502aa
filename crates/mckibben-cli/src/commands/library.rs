//! `library list|show|check`.

use super::validate::measured::folders;
use crate::failure::{Failure, NO_ANSWER};
use crate::flags::{OutputFlags, PlotFlag};
use crate::format::Format;
use crate::names::MUSCLES;
use crate::output::text::{number, or_dash, pairs, percent, percents, place, table};
use crate::output::{put, show as print};
use crate::progress::Bar;
use crate::{plot, shown};
use clap::Args;
use mckibben_app::{
    LibraryAgreement, LibraryCheck, LibraryCheckAnswer, LibraryCheckRequest, LibraryConstant,
    LibraryListAnswer, LibraryListRequest, LibraryShowAnswer, LibraryShowRequest, library_check,
    library_list, library_show,
};
use std::path::{Path, PathBuf};

pub const LIST: &str = "Examples:
  mckibben library list
  mckibben force lib:dmsp-20-300 -p 5bar -e 10%";

pub const SHOW: &str = "Example:
  mckibben library show dmsp-20-300";

pub const CHECK: &str = "Examples:
  mckibben library check --name dmsp-10-250
  mckibben library check examples/library/bench";

/// `library list`.
#[derive(Debug, Args)]
pub struct LibraryListArgs {
    #[command(flatten)]
    pub plot: PlotFlag,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// `library show`.
#[derive(Debug, Args)]
pub struct LibraryShowArgs {
    /// Name, with or without lib:
    #[arg(value_parser = MUSCLES, hide_possible_values = true)]
    pub name: String,
    #[command(flatten)]
    pub plot: PlotFlag,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// `library check`.
#[derive(Debug, Args)]
pub struct LibraryCheckArgs {
    /// Folder of a muscle, or folder of such folders [the built-in ones]
    #[arg(value_name = "DIR", conflicts_with = "name")]
    pub folder: Option<PathBuf>,
    /// Only this one of the built-in muscles
    #[arg(long, value_name = "NAME", value_parser = MUSCLES, hide_possible_values = true)]
    pub name: Option<String>,
    /// Write identified.toml of the refit into each folder whose own is missing or differs
    #[arg(long, requires = "folder")]
    pub write: bool,
    #[command(flatten)]
    pub output: OutputFlags,
}

pub fn list(args: &LibraryListArgs, format: Format) -> Result<u8, Failure> {
    plot::check(&args.plot)?;
    let figure = args.plot.plot.as_ref().map(|_| shown::units());
    let mut answer = library_list(&LibraryListRequest { figure })?;
    plot::save(answer.figure.take(), &args.plot)?;
    print(&answer, format, "muscles", || list_text(&answer), args.output.target())?;
    Ok(0)
}

fn list_text(answer: &LibraryListAnswer) -> String {
    let u = shown::units();
    let row = |m: &mckibben_app::LibraryMuscle| {
        vec![
            m.name.clone(),
            u.length.to(m.muscle.outer_diameter_mm, 4),
            u.length.to(m.muscle.length_mm, 4),
            u.pressure.to(m.pressure_mpa, 3),
            or_dash(m.blocked_force_n, |v| u.force.to(v, 4)),
            or_dash(m.uncertainty_n, |v| u.force.half_width(v)),
            percents([m.free_contraction], 3).concat(),
            m.points.to_string(),
            m.product.clone().unwrap_or_else(|| "hand-made".into()),
            m.source.clone(),
        ]
    };
    let headings = [u.length.heading("D0"), u.length.heading("L0"), u.pressure.heading("P")];
    let forces = [u.force.heading("F blocked"), u.force.heading("±")];
    let header: Vec<&str> = ["name"]
        .into_iter()
        .chain(headings.iter().chain(&forces).map(String::as_str))
        .chain(["ε free", "points", "", "source"])
        .collect();
    table(&header, answer.muscles.iter().map(row).collect())
        + "\nP: highest pressure of the bench. F blocked, its ± (95 %) and ε free: there, by fe.\n\
           A name stands wherever a muscle file may: mckibben force lib:dmsp-20-300 -p 5bar -e 10%\n\
           `mckibben library show NAME` shows source, terms and errors.\n"
}

pub fn show(args: &LibraryShowArgs, format: Format) -> Result<u8, Failure> {
    plot::check(&args.plot)?;
    let figure = args.plot.plot.as_ref().map(|_| shown::units());
    let mut answer = library_show(&LibraryShowRequest { name: args.name.clone(), figure })?;
    plot::save(answer.figure.take(), &args.plot)?;
    print(&answer, format, "", || show_text(&answer), args.output.target())?;
    Ok(0)
}

fn show_text(a: &LibraryShowAnswer) -> String {
    let (u, m) = (shown::units(), &a.muscle);
    let force = |v: f64| u.force.show(v);
    let blocked = or_dash(m.blocked_force_n, |v| {
        let half = or_dash(m.uncertainty_n, |half| u.force.half_width(half));
        format!("{} ± {half} {} at {}", force(v), u.force.name, u.pressure.show(m.pressure_mpa))
    });
    let rows = [
        ("name", m.name.clone()),
        ("what", m.title.clone()),
        ("product", m.product.clone().unwrap_or_else(|| "none: hand-made".into())),
        ("muscle", m.muscle.line(&u)),
        ("blocked force", blocked),
        ("free contraction", or_dash(m.free_contraction, percent)),
        ("source", m.source.clone()),
        ("terms", m.terms.clone()),
        ("known", a.known.clone()),
        ("unknown", a.unknown.clone()),
        ("identified", format!("{} (fit \"{}\")", a.identified.join(", "), a.fit)),
        ("agreement", agreement(&a.agreement)),
    ];
    format!("{}\n{}", pairs(&rows), a.muscle_file.text)
}

fn agreement(a: &LibraryAgreement) -> String {
    let u = shown::units();
    let force = |v: f64| format!("{} {}", u.force.to(v, 3), u.force.name);
    let held = or_dash(a.held, |share| {
        let percent = (100.0 * share).floor();
        format!("; {percent} % of the {} points of its length within its ±", a.bench_points)
    });
    format!(
        "rms {} ({} of the blocked force), largest {}, {} points{held}",
        force(a.rms_n),
        percents([Some(a.rms_of_blocked)], 2).concat(),
        force(a.largest_n),
        a.points
    )
}

/// Fits the points of folders again.
pub fn check(args: &LibraryCheckArgs, format: Format) -> Result<u8, Failure> {
    let cases = args.folder.as_deref().map(folders).transpose()?.unwrap_or_default();
    let request = LibraryCheckRequest { cases, name: args.name.clone() };
    let answer = library_check(&request, &Bar::new("muscles"))?;
    let mut written = vec![];
    if let Some(folder) = args.folder.as_deref().filter(|_| args.write) {
        for check in answer.checks.iter().filter(|c| c.is_outdated) {
            let path = place_of(folder, &check.name).join(&check.muscle_file.name);
            put(&path, check.muscle_file.text.as_bytes())?;
            written.push(path);
        }
    }
    let text = || check_text(&answer, &written);
    print(&answer, format, "checks", text, args.output.target())?;
    Ok(if answer.ok() || !written.is_empty() { 0 } else { NO_ANSWER })
}

/// The folder of a muscle: the one that was named, or one in it.
fn place_of(folder: &Path, name: &str) -> PathBuf {
    if folder.join("case.toml").is_file() { folder.to_owned() } else { folder.join(name) }
}

fn check_text(answer: &LibraryCheckAnswer, written: &[PathBuf]) -> String {
    let mut out = String::new();
    for check in &answer.checks {
        out.push_str(&block(check));
    }
    let held = answer.checks.iter().filter(|check| check.ok).count();
    out.push_str(&format!("{held} of {} folders hold\n", answer.checks.len()));
    written.iter().for_each(|path| out.push_str(&format!("written: {}\n", place(path))));
    out
}

fn block(check: &LibraryCheck) -> String {
    let row = |c: &LibraryConstant| {
        let half = c.refit.half_width;
        vec![
            c.refit.name.clone(),
            or_dash(c.kept_value, |v| number(v, 6)),
            number(c.refit.value, 6),
            if half.is_finite() { number(half, 2) } else { "–".into() },
            c.refit.unit.into(),
            if c.agrees { "agrees" } else { "DIFFERS" }.into(),
        ]
    };
    let header = ["", "folder", "refit", "± 95 %", "unit", ""];
    let faults: String = check.faults.iter().map(|fault| format!("  FAILS: {fault}\n")).collect();
    format!(
        "{}: {}, fit \"{}\"\n{}{}\n{faults}\n",
        check.name,
        check.title,
        check.fit,
        table(&header, check.constants.iter().map(row).collect()),
        agreement(&check.agreement)
    )
}
