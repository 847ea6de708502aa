//! `export`: a folder with a muscle for a controller or a simulator.

use crate::{Args, FLAT, Problem, Units, listed, pairs, place, save_all, tabled, value};
use mckibben_app::{
    BuiltFile, ExportListRequest, JointFields, export, export_joint, export_list, find, understood,
};
use serde_json::{Value, json};
use std::path::Path;

pub fn run(args: &Args) -> Result<u8, Problem> {
    if args.is("list") {
        let answer = export_list(&ExportListRequest {})?;
        return args.print(&answer, "targets", |answer, u| {
            tabled(&answer.targets, TARGETS, u)
        });
    }
    let folder = args.path("output");
    let save = |files: &[BuiltFile]| {
        folder
            .as_deref()
            .map_or(Ok(()), |folder| save_all(files, folder))
    };
    let path = args.path("file").unwrap_or_default();
    let is_joint = |text: String| text.lines().any(|line| line.trim() == "[joint]");
    if std::fs::read_to_string(&path).is_ok_and(is_joint) {
        let mut fields = args.fields_without(&["muscle"])?;
        let joint = JointFields::at(&path)?;
        fields.extend([
            ("joint".into(), json!(joint.joint)),
            ("muscles".into(), json!(joint.muscles)),
        ]);
        // What only a muscle has is refused.
        find("export-joint")?.read(fields.clone().into())?;
        let answer = export_joint(&understood(&fields.into())?)?;
        save(&answer.files)?;
        return args.print(&answer, FLAT, |a, u| {
            let keys = "target torque_error_nm=error_of_the_torque,_at_most \
                stiffness_error_nm_per_rad=of_the_stiffness";
            text(value(a), String::new(), keys, folder.as_deref(), u)
        });
    }
    let answer = export(&args.request()?)?;
    save(&answer.files)?;
    args.print(&answer, FLAT, |a, u| {
        text(
            value(a),
            a.muscle.line(u) + "\n",
            KEYS,
            folder.as_deref(),
            u,
        )
    })
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
