//! `export`: a folder with a muscle for a controller or a simulator.

use crate::{Args, Problem, place, save_all};
use mckibben_app::print::Page;
use mckibben_app::{
    BuiltFile, ExportListRequest, JointFields, export, export_joint, export_list, find, understood,
};
use serde_json::json;

pub fn run(args: &Args) -> Result<u8, Problem> {
    if args.is("list") {
        let answer = export_list(&ExportListRequest {})?;
        return args.output_beside(&answer, |_| ());
    }
    let folder = args.path("output");
    let save = |files: &[BuiltFile]| {
        folder
            .as_deref()
            .map_or(Ok(()), |folder| save_all(files, folder))
    };
    let written = |files: &[BuiltFile], page: &mut Page| {
        page.line(match &folder {
            Some(folder) => format!("{} files are in {}.", files.len(), place(folder)),
            None => "-o DIR writes the files into a folder.".into(),
        });
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
        return args.output_beside(&answer, |page| written(&answer.files, page));
    }
    let answer = export(&args.request()?)?;
    save(&answer.files)?;
    args.output_beside(&answer, |page| written(&answer.files, page))
}
