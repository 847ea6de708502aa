//! A series of equilibria as files that ParaView opens.

use super::{
    Shape,
    vtu::{Grid, VtuError, collection},
};
use mckibben_core::model::Response;

/// The parts of a step.
const PARTS: [&str; 3] = ["tube", "braid", "plug"];

/// A file of a series.
#[derive(Debug, Clone, PartialEq)]
pub struct VtuFile {
    /// Its name in the folder.
    pub name: String,
    /// What is in it.
    pub text: String,
}

/// Makes `tube_0000.vtu`, `braid_0000.vtu`, … (`plug_0000.vtu` where the terminals are bodies) and
/// `muscle.pvd`, which lists them.
///
/// The list comes last in what [`VtuSeries::add`] gives and names whole steps only: written in this
/// order, a series that is broken off can be opened. Who writes them decides where to.
#[derive(Debug)]
pub struct VtuSeries {
    about: String,
    steps: usize,
    /// Step, part, name and file.
    files: Vec<(usize, usize, &'static str, String)>,
}

impl VtuSeries {
    /// A series; `about` says what the muscle is.
    pub fn new(about: &str) -> Self {
        Self {
            about: about.to_owned(),
            steps: 0,
            files: vec![],
        }
    }

    /// The files of a step: bodies and what the model says about the equilibrium; then the list of
    /// all steps.
    pub fn add(&mut self, shape: Shape, response: &Response) -> Result<Vec<VtuFile>, VtuError> {
        let step = self.steps;
        let note = if shape.for_display {
            "; the number of strands is for display"
        } else {
            ""
        };
        let about = format!("{}; step {step}{note}", self.about);
        let drawn = shape.strands_drawn.map(|n| ("strands_drawn", f64::from(n)));
        let mut grids = vec![(shape.tube, None), (shape.braid, drawn)];
        grids.extend(shape.plug.map(|grid| (grid, None)));
        let mut files = Vec::with_capacity(grids.len() + 1);
        for (part, (mut grid, more)) in PARTS.into_iter().zip(grids) {
            fill(&mut grid, response, more);
            let name = format!("{part}_{step:04}.vtu");
            files.push(VtuFile {
                text: grid.to_xml(&about, &name)?,
                name,
            });
        }
        let parts = PARTS.into_iter().zip(&files).enumerate();
        self.files
            .extend(parts.map(|(number, (part, file))| (step, number, part, file.name.clone())));
        self.steps += 1;
        files.push(self.list());
        Ok(files)
    }

    /// The list of all steps, `muscle.pvd`.
    pub fn list(&self) -> VtuFile {
        VtuFile {
            name: "muscle.pvd".into(),
            text: collection(&self.about, &self.files),
        }
    }
}

fn fill(grid: &mut Grid, r: &Response, more: Option<(&'static str, f64)>) {
    let known = [
        ("pressure_mpa", Some(r.pressure_mpa)),
        ("contraction", Some(r.contraction)),
        ("force_n", Some(r.force_n)),
        ("volume_mm3", r.volume_mm3),
        ("bulged_diameter_mm", r.bulged_diameter_mm),
        ("braid_tension_n", r.braid_tension_n),
        ("strand_tension_n", r.strand_tension_n),
    ];
    grid.field = known
        .into_iter()
        .filter_map(|(name, value)| value.map(|v| (name, v)))
        .chain(more)
        .collect();
}
