//! `validate --measured`: a block a muscle.

use super::ValidateArgs;
use crate::failure::Failure;
use crate::flags::Format;
use crate::output::show;
use crate::output::text::{or_dash, pairs, table};
use crate::progress::Bar;
use crate::{files, plot};
use mckibben_app::{
    MeasuredAnswer, MeasuredCase, MeasuredFit, MeasuredFolder, MeasuredRequest, MeasuredResult, ProblemKind,
    with_error_bar,
};
use mckibben_fem::validation::case::built_in;
use std::path::Path;

/// Runs the command.
pub fn run(args: &ValidateArgs, folder: Option<&Path>, format: Format) -> Result<u8, Failure> {
    plot::check(args.plot.plot.as_deref())?;
    let figure = args.plot.plot.as_ref().map(|_| args.output.units.or_typed([&None, &None]));
    let request = MeasuredRequest { cases: chosen(cases(folder)?, &args.only)?, figure };
    let mut answer = mckibben_app::measured(&request, &Bar::new("fits"))?;
    plot::save(answer.figure.take(), args.plot.plot.as_deref())?;
    show(&answer, format, "results", || as_text(&answer), args.output.target())?;
    Ok(0)
}

/// The cases of a folder, or those that are built in.
fn cases(folder: Option<&Path>) -> Result<Vec<MeasuredFolder>, Failure> {
    let Some(folder) = folder else {
        let built_in = built_in().into_iter();
        return Ok(built_in
            .map(|f| MeasuredFolder { name: f.name, case: f.case, muscle: f.muscle, points: f.points })
            .collect());
    };
    let unread = |e: &dyn std::fmt::Display| {
        Failure::input(ProblemKind::File, format!("{}: {e}", folder.display()), "")
    };
    let mut list = vec![];
    let entries = std::fs::read_dir(folder).map_err(|e| unread(&e))?;
    for entry in entries {
        let path = entry.map_err(|e| unread(&e))?.path();
        if path.join("case.toml").is_file() {
            let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
            list.push(MeasuredFolder {
                name,
                case: files::text(&path.join("case.toml"))?.text,
                muscle: files::text(&path.join("muscle.toml"))?.text,
                points: files::table(&path.join("points.csv"))?.text,
            });
        }
    }
    list.sort_by(|a, b| a.name.cmp(&b.name));
    if list.is_empty() {
        let message = format!("{}: no folder in it holds a case.toml", folder.display());
        let hint = "a measured muscle is a folder with case.toml, muscle.toml and points.csv";
        return Err(Failure::input(ProblemKind::MissingInput, message, hint));
    }
    Ok(list)
}

fn chosen(all: Vec<MeasuredFolder>, only: &[String]) -> Result<Vec<MeasuredFolder>, Failure> {
    if let Some(name) = only.iter().find(|name| !all.iter().any(|c| c.name == **name)) {
        let known: Vec<&str> = all.iter().map(|c| c.name.as_str()).collect();
        let message = format!("there is no measured muscle \"{name}\"; there are {}", known.join(", "));
        return Err(Failure::input(ProblemKind::Usage, message, ""));
    }
    Ok(all.into_iter().filter(|c| only.is_empty() || only.contains(&c.name)).collect())
}

fn as_text(answer: &MeasuredAnswer) -> String {
    let head = "Validation: fe against measured muscles. Bias is measured less computed; % is of the blocked force; held is the share of the points within the ±\n";
    let cases = answer.cases.iter().map(|case| block(case, &answer.results));
    std::iter::once(head.to_owned()).chain(cases).collect()
}

fn block(case: &MeasuredCase, results: &[MeasuredResult]) -> String {
    let facts = [
        ("folder", case.name.clone()),
        ("source", case.source.clone()),
        ("terms", case.terms.clone()),
        ("known", case.known.clone()),
        ("unknown", case.unknown.clone()),
    ];
    let fits: Vec<(String, String)> = case
        .fits
        .iter()
        .filter(|f| !f.parameters.is_empty())
        .map(|f| (format!("{} [{}]", f.fit, f.fitted_to), values(f)))
        .collect();
    let fits: Vec<(&str, String)> = fits.iter().map(|(name, text)| (name.as_str(), text.clone())).collect();
    let own = || results.iter().filter(|r| r.case == case.name);
    let header = [
        "rms [N]",
        "rms [%]",
        "bias [N]",
        "largest [N]",
        "points",
        "held",
        "blind",
        "of",
        "fitted to",
        "fit",
    ];
    let by_contraction: Vec<(String, String)> = own()
        .filter(|r| !r.blind)
        .map(|r| {
            let bins = r.by_contraction.iter().map(|b| format!("{:.2} {:+.1}", b.from, b.bias_n));
            (format!("{} [{}]", r.fit, r.of), bins.collect::<Vec<_>>().join(", "))
        })
        .collect();
    let bias: Vec<(&str, String)> = by_contraction.iter().map(|(n, t)| (n.as_str(), t.clone())).collect();
    format!(
        "\n{}, {} points that pull\n\n{}\nFound, ± 95 %\n{}\n{}\nBias in N from ε 0, 0.05, …, where fitted\n{}",
        case.title,
        case.points,
        pairs(&facts),
        pairs(&fits),
        table(&header, own().map(row).collect()),
        pairs(&bias)
    )
}

fn values(fit: &MeasuredFit) -> String {
    let one = |p: &mckibben::identify::Identified| {
        let (value, bar) = with_error_bar(p);
        let bar = if bar == "–" { String::new() } else { format!(" ± {bar}") };
        let unit = if p.unit.is_empty() { String::new() } else { format!(" {}", p.unit) };
        let doubt = if p.identifiable { "" } else { " (not identifiable)" };
        format!("{} {value}{bar}{unit}{doubt}", p.name)
    };
    fit.parameters.iter().map(one).collect::<Vec<_>>().join(", ")
}

fn row(r: &MeasuredResult) -> Vec<String> {
    let percent = |v: f64| format!("{:.0} %", 100.0 * v);
    vec![
        format!("{:.1}", r.rms_n),
        format!("{:.1}", 100.0 * r.rms_of_blocked),
        format!("{:+.1}", r.bias_n),
        format!("{:.0}", r.largest_n),
        r.points.to_string(),
        or_dash(r.held, percent),
        if r.blind { "blind" } else { "" }.into(),
        match r.unanswered {
            0 => r.of.clone(),
            n => format!("{} ({n} without an answer)", r.of),
        },
        r.fitted_to.clone(),
        r.fit.clone(),
    ]
}
