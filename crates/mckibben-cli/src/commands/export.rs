//! `export`: a folder with a muscle for a controller or a simulator.

use crate::{Context, Result, examples::examples, output::ShownUnits, path_on_one_line};
use mckibben_app::{
    BuiltFile, ExportListRequest, ExportRequest, export, export_joint, export_list, print::Page,
};
use std::path::{Path, PathBuf};

/// A folder for a controller or a simulator.
#[derive(clap::Args)]
#[command(after_long_help = examples(&[
    "export --list",
    "export examples/prototype.toml --as c -o muscle_model",
    "export -D 20 -s 2 --as mjcf -p 4bar -o scene",
    "export examples/elbow.toml --as c -p 3bar -o elbow"
]))]
pub struct Export {
    #[command(flatten)]
    request: ExportRequest,
    /// List the targets: what each is, needs and loses
    #[arg(long, conflicts_with = "target")]
    list: bool,
    #[command(flatten)]
    units: ShownUnits,
    /// Folder for the files; without it only their names are printed
    #[arg(short, long, value_name = "DIR", help_heading = "Output")]
    output: Option<PathBuf>,
}

impl Export {
    pub fn run(self, context: &Context) -> Result<u8> {
        if self.list {
            context.print(&export_list(&ExportListRequest {})?, |_| (), None)?;
            return Ok(0);
        }
        let folder = self.output.as_deref();
        let save =
            |files: &[BuiltFile]| folder.map_or(Ok(()), |folder| context.save_all(files, folder));
        let written = |files: &[BuiltFile], page: &mut Page| {
            page.line(match folder {
                Some(folder) => {
                    let place = path_on_one_line(folder);
                    match files.len() {
                        1 => format!("One file is in {place}."),
                        count => format!("{count} files are in {place}."),
                    }
                }
                None => "-o DIR writes the files into a folder.".into(),
            });
        };
        let (request, file) = (&self.request, self.request.muscle.file());
        let is_joint = |text: &str| text.lines().any(|line| line.trim() == "[joint]");
        if let Some(file) = file.filter(|file| is_joint(&file.text)) {
            let answer = export_joint(&request.of_joint(Path::new(&file.name))?)?;
            save(&answer.files)?;
            context.print(&answer, |page| written(&answer.files, page), None)?;
        } else {
            let answer = export(request)?;
            save(&answer.files)?;
            context.print(&answer, |page| written(&answer.files, page), None)?;
        }
        Ok(0)
    }
}
