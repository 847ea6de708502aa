//! `export`: a folder with a muscle for a controller or a simulator.

use crate::asked::Asked;
use crate::failure::Failure;
use crate::output::text::{pairs, place, table};
use crate::output::{FLAT, save_all};
use crate::progress::Bar;
use crate::shown;
use mckibben_app::{ExportAnswer, ExportListAnswer, ExportListRequest, export, export_list, words};
use std::path::Path;

pub const TEXT: &str = "export: The muscle for a controller or simulator: C, Python, MuJoCo, FMI, OpenSim
Question:
target=as<TARGET>!^list | Target
list | List the targets: what each is, needs and loses
p/pressure_mpa contraction_low<CONTRACTION> contraction_high<CONTRACTION> name
@muscle Advanced: @engine
@units
o/output<DIR> | Folder for the files; without it only their names are printed
Examples:
  mckibben export --list
  mckibben export examples/prototype.toml --as c -o muscle_model
  mckibben export -D 20 -s 2 --as mjcf -p 4bar -o scene";

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    if asked.is("list") {
        let answer = export_list(&ExportListRequest {})?;
        return asked.print(&answer, "targets", || list_text(&answer));
    }
    let answer = export(&asked.request()?, &Bar::new("points"))?;
    let folder = asked.path("output");
    folder.as_deref().map_or(Ok(()), |folder| save_all(&answer.files, folder))?;
    asked.print(&answer, FLAT, || text(&answer, folder.as_deref()))
}

fn list_text(answer: &ExportListAnswer) -> String {
    let rows = answer.targets.iter().map(|t| [t.name, t.about, t.needs, t.loses].map(str::to_owned).into());
    table(&["target", "what it is", "needs", "loses"], rows.collect())
}

fn text(answer: &ExportAnswer, folder: Option<&Path>) -> String {
    let u = shown::units();
    let percent = |share: f64| format!("{:.2} %", 100.0 * share);
    let rows = [
        ("model", answer.model.clone()),
        (
            "box",
            format!(
                "0 to {}, contraction {} to {}",
                u.pressure.show(answer.bounds.supply_pressure_mpa),
                words::percent(answer.bounds.contraction_low),
                words::percent(answer.bounds.contraction_high)
            ),
        ),
        ("blocked force", format!("{} {}", u.force.to(answer.blocked_force_n, 4), u.force.name)),
        (
            "error of the pull",
            format!(
                "{} rms, {} at 95 % of points, {} worst, of the blocked force",
                percent(answer.errors.force_rms),
                percent(answer.errors.force_95_ratio),
                percent(answer.errors.force_worst_ratio)
            ),
        ),
        (
            "error of the volume",
            format!(
                "{} rms, {} worst, of the largest volume",
                percent(answer.errors.volume_rms),
                percent(answer.errors.volume_worst_ratio)
            ),
        ),
        (
            "± of the blocked force",
            answer
                .uncertainty_n
                .map_or_else(|| "not known".into(), |n| format!("{} {}", u.force.to(n, 2), u.force.name)),
        ),
        ("needs", answer.needs.clone()),
        ("loses", answer.loses.clone()),
    ];
    let mut out = answer.muscle.line(&u) + "\n" + &pairs(&rows) + "\n";
    let row = |file: &mckibben_app::BuiltFile| vec![file.name.clone(), file.about.clone()];
    out += &table(&["file", "what it is"], answer.files.iter().map(row).collect());
    for warning in &answer.warnings {
        out += &format!("\nnote: {warning}");
    }
    out += &match folder {
        Some(folder) => format!("\n{} files are in {}.\n", answer.files.len(), place(folder)),
        None => "\n-o DIR writes the files into a folder.\n".into(),
    };
    out
}
