//! The deformed muscle of each point, as files that ParaView opens.

use crate::{BuiltFile, MuscleSummary, ProblemKind, Result, Units};
use mckibben_core::{model::Response, size};
use mckibben_fem::output::{Shape, VtuFile, VtuSeries};
use mckibben_io::files::File;

/// The files of the points so far.
pub struct ShapeFiles {
    series: VtuSeries,
    files: Vec<BuiltFile>,
    bytes: usize,
}

impl ShapeFiles {
    pub fn new(muscle: &MuscleSummary) -> Self {
        Self {
            series: VtuSeries::new(&muscle.line(&Units::default())),
            files: vec![],
            bytes: 0,
        }
    }

    pub fn add(&mut self, shape: Shape, response: &Response) -> Result<()> {
        let mut files = self
            .series
            .add(shape, response)
            .map_err(|e| ProblemKind::Output.problem(e))?;
        // The list comes once, when all points are known.
        files.pop();
        self.bytes += files.iter().map(|file| file.text.len()).sum::<usize>();
        size::bytes("vtu", self.bytes as f64)?;
        self.files.extend(files.into_iter().map(built));
        Ok(())
    }

    /// All of them, first the list of the others.
    pub fn into_files(self) -> Vec<BuiltFile> {
        std::iter::once(built(self.series.list()))
            .chain(self.files)
            .collect()
    }
}

fn built(VtuFile { name, text }: VtuFile) -> BuiltFile {
    let about = match name.as_str() {
        name if name.starts_with("tube") => "the rubber, with stretches and stresses",
        name if name.starts_with("braid") => "the strands, with their tension",
        name if name.starts_with("plug") => "the terminal",
        _ => "the list of the others, which ParaView opens",
    };
    File::text(name, about, text).into()
}
