//! The shapes of a test as files of its answer, for front ends that write no folder.

use super::{Shapes, SimulateAnswer, SimulateRequest, simulate};
use crate::{BuiltFile, MuscleSummary, Problem, ProblemKind, Result, Units};
use mckibben::{model::Response, progress::Progress, size};
use mckibben_fem::output::{Extent, Shape, VtuFile, VtuSeries};

/// The files of the points so far.
struct Kept {
    series: VtuSeries,
    files: Vec<BuiltFile>,
    bytes: usize,
}

impl Kept {
    fn file(VtuFile { name, text }: VtuFile) -> BuiltFile {
        let about = match name.as_str() {
            name if name.starts_with("tube") => "the rubber, with stretches and stresses",
            name if name.starts_with("braid") => "the strands, with their tension",
            name if name.starts_with("plug") => "the terminal",
            _ => "the list of the others, which ParaView opens",
        };
        BuiltFile::new(&name, about, Ok(text))
    }
}

impl Shapes for Kept {
    fn begin(&mut self, muscle: &MuscleSummary) -> Result<()> {
        self.series = VtuSeries::new(&muscle.line(&Units::default()));
        Ok(())
    }

    fn add(&mut self, shape: Shape, response: &Response) -> Result<()> {
        let mut files = self
            .series
            .add(shape, response)
            .map_err(|e| Problem::new(ProblemKind::Output, e.to_string(), ""))?;
        // The list comes once, when all points are known.
        files.pop();
        self.bytes += files.iter().map(|file| file.text.len()).sum::<usize>();
        size::bytes("vtu", self.bytes as f64)?;
        self.files.extend(files.into_iter().map(Self::file));
        Ok(())
    }

    fn extent(&self) -> Extent {
        Extent::Whole
    }
}

/// A test, with the files that its request asks for.
pub(crate) fn with_files(request: &SimulateRequest, progress: &dyn Progress) -> Result<SimulateAnswer> {
    if !request.vtu {
        return simulate(request, progress, None);
    }
    let series = VtuSeries::new("");
    let mut kept = Kept { series, files: vec![], bytes: 0 };
    let mut answer = simulate(request, progress, Some(&mut kept))?;
    answer.files = vec![Kept::file(kept.series.list())];
    answer.files.append(&mut kept.files);
    Ok(answer)
}
