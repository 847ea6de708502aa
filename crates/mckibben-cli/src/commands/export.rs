//! `export`: a folder with a muscle for a controller or a simulator.

use crate::output::ShownUnits;
use crate::{
    FLAT, Format, Problem, Units, listed, pairs, place, print_text, save_all, tabled, value,
};
use mckibben_app::{
    BuiltFile, ExportListRequest, ExportRequest, export, export_joint, export_list,
};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// A folder for a controller or a simulator.
#[derive(Debug, clap::Args)]
#[command(after_long_help = "Examples:
  mckibben export --list
  mckibben export examples/prototype.toml --as c -o muscle_model
  mckibben export -D 20 -s 2 --as mjcf -p 4bar -o scene
  mckibben export examples/elbow.toml --as c -p 3bar -o elbow")]
pub struct Export {
    #[command(flatten)]
    request: ExportRequest,
    /// List the targets: what each is, needs and loses
    #[arg(long, conflicts_with = "target", help_heading = "Question")]
    list: bool,
    #[command(flatten)]
    units: ShownUnits,
    /// Folder for the files; without it only their names are printed
    #[arg(short, long, value_name = "DIR", help_heading = "Output")]
    output: Option<PathBuf>,
}

impl Export {
    pub fn run(self, format: Format) -> Result<u8, Problem> {
        if self.list {
            let answer = export_list(&ExportListRequest {})?;
            return print_text(format, &answer, "targets", |answer, u| {
                tabled(&answer.targets, TARGETS, u)
            });
        }
        let folder = self.output.as_deref();
        let save = |files: &[BuiltFile]| folder.map_or(Ok(()), |folder| save_all(files, folder));
        let (request, file) = (&self.request, self.request.muscle.file());
        let is_joint = |text: &str| text.lines().any(|line| line.trim() == "[joint]");
        if let Some(file) = file.filter(|file| is_joint(&file.text)) {
            let answer = export_joint(&request.of_joint(Path::new(&file.name))?)?;
            save(&answer.files)?;
            return print_text(format, &answer, FLAT, |a, u| {
                let keys = "target torque_error_nm=error_of_the_torque,_at_most \
                    stiffness_error_nm_per_rad=of_the_stiffness";
                text(value(a), String::new(), keys, folder, u)
            });
        }
        let answer = export(request)?;
        save(&answer.files)?;
        print_text(format, &answer, FLAT, |a, u| {
            text(value(a), a.muscle.line(u) + "\n", KEYS, folder, u)
        })
    }
}

const TARGETS: &str = "name=target about=what_it_is needs loses";
const KEYS: &str = "model supply_pressure_mpa contraction_low=contraction_from:% \
    contraction_high=to:% blocked_force_n+uncertainty_n force_rms=error_of_the_pull,_rms:2% \
    force_95_ratio=at_95_%_of_points:2% force_worst_ratio=largest:2% \
    volume_rms=error_of_the_volume,_rms:2% volume_worst_ratio=largest:2% needs loses";

fn text(answer: Value, head: String, keys: &str, folder: Option<&Path>, u: &Units) -> String {
    let list = |key: &str| answer[key].as_array().cloned().unwrap_or_default();
    let files = list("files");
    let mut out = head
        + &pairs(&listed(&answer, keys, u))
        + "\n"
        + &tabled(&files, "name=file about=what_it_is", u);
    out.extend(
        list("warnings")
            .iter()
            .filter_map(Value::as_str)
            .map(|warning| format!("\nnote: {warning}")),
    );
    out += &match folder {
        Some(folder) => format!("\n{} files are in {}.\n", files.len(), place(folder)),
        None => "\n-o DIR writes the files into a folder.\n".into(),
    };
    out
}
