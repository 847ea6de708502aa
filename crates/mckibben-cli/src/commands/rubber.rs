//! `rubber list|show`.

use crate::failure::Failure;
use crate::flags::OutputFlags;
use crate::format::Format;
use crate::names::RUBBERS;
use crate::output::text::{law_text, number, or_dash, pairs, percent, table};
use crate::output::{show as print, warn};
use clap::Args;
use mckibben::rubber::library::TABLE_OF_FITS;
use mckibben_app::{
    LibraryFit, RubberListAnswer, RubberListRequest, RubberShowAnswer, RubberShowRequest, rubber_list,
    rubber_show,
};

/// `rubber list`.
#[derive(Debug, Args)]
pub struct RubberListArgs {
    #[command(flatten)]
    pub output: OutputFlags,
}

/// `rubber show`.
#[derive(Debug, Args)]
pub struct RubberShowArgs {
    /// Name, or NAME:LAW
    #[arg(value_parser = RUBBERS, hide_possible_values = true)]
    pub name: String,
    #[command(flatten)]
    pub output: OutputFlags,
}

pub fn list(args: &RubberListArgs, format: Format) -> Result<u8, Failure> {
    let answer = rubber_list(&RubberListRequest {})?;
    print(&answer, format, "rubbers", || list_text(&answer), args.output.target())?;
    Ok(0)
}

fn list_text(answer: &RubberListAnswer) -> String {
    let width = answer.rubbers.iter().map(|r| r.name.chars().count()).max().unwrap_or(0);
    let mut out = format!("  {:<width$}   μ [MPa]   law              breaks at   title\n", "name");
    for rubber in &answer.rubbers {
        let breaks = or_dash(rubber.max_strain, |s| format!("{} %", (100.0 * s).round()));
        let law = format!("{}{}", rubber.law, if rubber.curve { " *" } else { "" });
        out.push_str(&format!(
            "  {:<width$}   {:>7}   {law:<15}   {breaks:>8}   {}\n",
            rubber.name,
            number(rubber.shear_modulus_mpa, 3),
            rubber.title
        ));
    }
    out.push_str(
        "\nμ: shear modulus at rest of the law that the name means in the prototype.\n\
         *: fitted to its curve, up to the stretches in the prototype: another muscle may use another law.\n\
         `mckibben rubber show NAME` shows the details; NAME:LAW selects another law.\n",
    );
    out
}

pub fn show(args: &RubberShowArgs, format: Format) -> Result<u8, Failure> {
    let answer = rubber_show(&RubberShowRequest { name: args.name.clone() })?;
    let text = || {
        answer.warnings.iter().for_each(warn);
        show_text(&answer)
    };
    print(&answer, format, "fits", text, args.output.target())?;
    Ok(0)
}

pub(super) fn show_text(answer: &RubberShowAnswer) -> String {
    let mut head = vec![("name", answer.name.clone()), ("title", answer.title.clone())];
    if let Some(strain) = answer.max_strain {
        let stress = or_dash(answer.max_stress_mpa, |s| format!(" at {} MPa", number(s, 3)));
        head.push(("breaks at", format!("{} strain{stress}", percent(strain))));
    }
    if let Some(data) = &answer.data {
        let from = if data == TABLE_OF_FITS { "as the published fits have it: " } else { "" };
        head.push(("curve", format!("{from}data/{data}")));
    }
    head.extend([("source", answer.source.clone()), ("terms", answer.terms.clone())]);
    if let Some(note) = &answer.note {
        head.push(("note", note.clone()));
    }
    let mut out = pairs(&head);
    let curve: Vec<&LibraryFit> = answer.fits.iter().filter(|f| f.fitted.is_some()).collect();
    if curve.is_empty() {
        return out + "\n" + &published_text(answer);
    }
    out.push_str(&format!("\n{}\n{}", by_reach_text(answer, &curve), others_text(answer, &curve)));
    let published: Vec<_> = answer.fits.iter().filter(|f| f.fitted.is_none()).map(published_row).collect();
    out.push_str(&format!("\nPublished, for comparison:\n{}", table(&PUBLISHED, published)));
    out
}

const PUBLISHED: [&str; 5] = ["", "law and constants", "μ [MPa]", "fitted up to", "R²"];

fn published_row(fit: &LibraryFit) -> Vec<String> {
    vec![
        if fit.by_reach { "→".into() } else { String::new() },
        law_text(&fit.fit),
        number(fit.shear_modulus_mpa, 3),
        or_dash(fit.up_to_strain, percent),
        or_dash(fit.r_squared, |r| number(r, 5)),
    ]
}

/// A rubber without a curve.
fn published_text(answer: &RubberShowAnswer) -> String {
    let rows: Vec<_> = answer.fits.iter().map(published_row).collect();
    let taken = answer.fits.iter().filter(|f| f.by_reach).count();
    let which = if taken > 1 { ", each for muscles whose stretches it covers" } else { "" };
    format!("{}\n→ is taken for --rubber {}{which}\n", table(&PUBLISHED, rows), answer.rubber)
}

/// What the name means, from the smallest range of stretches to the widest.
fn by_reach_text(answer: &RubberShowAnswer, curve: &[&LibraryFit]) -> String {
    let taken: Vec<&&LibraryFit> = curve.iter().filter(|f| f.by_reach).collect();
    let row = |(i, fit): (usize, &&&LibraryFit)| {
        let known = fit.fitted.as_ref()?;
        let of_range = |f: &&&LibraryFit| f.reach_up_to == fit.reach_up_to && f.name != fit.name;
        let equal =
            curve.iter().filter(of_range).filter(|f| standing(f) != "behind").map(|f| f.name.as_str());
        let equal = equal.collect::<Vec<_>>().join(", ");
        Some(vec![
            if i + 1 == taken.len() { "any".into() } else { or_dash(fit.reach_up_to, |r| number(r, 3)) },
            or_dash(fit.up_to_strain, |s| number(1.0 + s, 3)),
            known.points.to_string(),
            law_text(&fit.fit),
            number(fit.shear_modulus_mpa, 3),
            number(1000.0 * known.rms_mpa, 2),
            if equal.is_empty() { "–".into() } else { equal },
        ])
    };
    let header =
        ["reach", "data to", "points", "law and constants", "μ [MPa]", "rms [kPa]", "as good or better"];
    format!(
        "--rubber {} means, for muscles that stretch their rubber up to the reach (`mckibben muscle show`):\n{}",
        answer.rubber,
        table(&header, taken.iter().enumerate().filter_map(row).collect())
    )
}

fn standing(fit: &LibraryFit) -> &str {
    fit.fitted.as_ref().map_or("", |f| f.standing.as_str())
}

/// The laws that can be asked for, with the farthest that they come from the recommended one.
fn others_text(answer: &RubberShowAnswer, curve: &[&LibraryFit]) -> String {
    let ends: Vec<f64> =
        curve.iter().filter(|f| standing(f) == "recommended").filter_map(|f| f.up_to_strain).collect();
    let row = |name: &String| {
        let mut cells = vec![format!("{}:{name}", answer.name)];
        cells.extend(ends.iter().map(|end| {
            let of = |f: &&&LibraryFit| f.up_to_strain == Some(*end) && f.name == *name;
            let known = curve.iter().find(of).and_then(|f| f.fitted.as_ref());
            or_dash(known, |f| match f.standing.as_str() {
                "recommended" => "→".into(),
                standing => {
                    let mark = if standing == "equal" { " =" } else { "" };
                    format!("{} %{mark}", number(100.0 * f.planar_difference, 2))
                }
            })
        }));
        cells
    };
    let mut header = vec!["law".to_owned()];
    header.extend(ends.iter().map(|end| format!("to {}", number(1.0 + end, 3))));
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    format!(
        "Available laws, and their largest difference from the recommended one (→) in planar tension, up to the end of the data\n\
         (=: the data do not distinguish it from the recommended one):\n{}",
        table(&header, answer.laws.iter().map(row).collect())
    )
}
