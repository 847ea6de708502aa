//! `rubber list|show`.

use crate::failure::Failure;
use crate::flags::{Format, OutputFlags};
use crate::output::text::{law_text, number, or_dash, pairs, percent, table};
use crate::output::{show as print, warn};
use clap::Args;
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
    pub name: String,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// All rubbers.
pub fn list(args: &RubberListArgs, format: Format) -> Result<u8, Failure> {
    let answer = rubber_list(&RubberListRequest {})?;
    print(&answer, format, "rubbers", || list_text(&answer), args.output.output.as_deref())?;
    Ok(0)
}

fn list_text(answer: &RubberListAnswer) -> String {
    let width = answer.rubbers.iter().map(|r| r.name.chars().count()).max().unwrap_or(0);
    let mut out = format!("  {:<width$}   μ [MPa]   breaks at   title\n", "name");
    for rubber in &answer.rubbers {
        let breaks = or_dash(rubber.max_strain, |s| format!("{} %", (100.0 * s).round()));
        out.push_str(&format!(
            "  {:<width$}   {:>7}   {breaks:>9}   {}\n",
            rubber.name,
            number(rubber.shear_modulus_mpa, 3),
            rubber.title
        ));
    }
    out.push_str("\nμ: shear modulus of the fit that is taken when no law is named. `mckibben rubber show NAME` tells more.\n");
    out
}

/// One rubber.
pub fn show(args: &RubberShowArgs, format: Format) -> Result<u8, Failure> {
    let answer = rubber_show(&RubberShowRequest { name: args.name.clone() })?;
    let text = || {
        answer.warnings.iter().for_each(warn);
        show_text(&answer)
    };
    print(&answer, format, "fits", text, args.output.output.as_deref())?;
    Ok(0)
}

fn show_text(answer: &RubberShowAnswer) -> String {
    let mut head = vec![("name", answer.name.clone()), ("title", answer.title.clone())];
    if let Some(strain) = answer.max_strain {
        let stress = or_dash(answer.max_stress_mpa, |s| format!(" at {} MPa", number(s, 3)));
        head.push(("breaks at", format!("{} strain{stress}", percent(strain))));
    }
    head.extend([("source", answer.source.clone()), ("terms", answer.terms.clone())]);
    if let Some(note) = &answer.note {
        head.push(("note", note.clone()));
    }
    let row = |fit: &LibraryFit| {
        vec![
            if fit.taken { "→".into() } else { String::new() },
            law_text(&fit.fit.law),
            number(fit.shear_modulus_mpa, 3),
            or_dash(fit.up_to_strain, percent),
            or_dash(fit.r_squared, |r| number(r, 5)),
        ]
    };
    let header = ["", "law and constants", "μ [MPa]", "fitted up to", "R²"];
    let rows = answer.fits.iter().map(row).collect();
    format!("{}\n{}\n→ is taken for --rubber {}\n", pairs(&head), table(&header, rows), answer.rubber)
}
