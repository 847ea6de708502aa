//! `export`: a folder with a muscle for a controller or a simulator.

use crate::{Args, FLAT, Problem, Units, listed, pairs, place, save_all, tabled, value};
use mckibben_app::{ExportAnswer, ExportListRequest, export, export_list};
use std::path::Path;

pub fn run(args: &Args) -> Result<u8, Problem> {
    if args.is("list") {
        let answer = export_list(&ExportListRequest {})?;
        return args.print(&answer, "targets", |answer, u| tabled(&answer.targets, TARGETS, u));
    }
    let answer = export(&args.request()?)?;
    let folder = args.path("output");
    folder.as_deref().map_or(Ok(()), |folder| save_all(&answer.files, folder))?;
    args.print(&answer, FLAT, |answer, u| text(answer, folder.as_deref(), u))
}

const TARGETS: &str = "name=target about=what_it_is needs loses";
const KEYS: &str = "model supply_pressure_mpa contraction_low=contraction_from:% contraction_high=to:% blocked_force_n+uncertainty_n force_rms=error_of_the_pull,_rms:2% force_95_ratio=at_95_%_of_points:2% force_worst_ratio=largest:2% volume_rms=error_of_the_volume,_rms:2% volume_worst_ratio=largest:2% needs loses";

fn text(answer: &ExportAnswer, folder: Option<&Path>, u: &Units) -> String {
    let mut out = answer.muscle.line(u) + "\n" + &pairs(&listed(&value(answer), KEYS, u)) + "\n";
    out += &tabled(&answer.files, "name=file about=what_it_is", u);
    for warning in &answer.warnings {
        out += &format!("\nnote: {warning}");
    }
    out += &match folder {
        Some(folder) => format!("\n{} files are in {}.\n", answer.files.len(), place(folder)),
        None => "\n-o DIR writes the files into a folder.\n".into(),
    };
    out
}
