//! A series of equilibria in a folder.

use super::error::VtuError;
use super::vtu::{Grid, collection};
use super::{Shape, helices};
use crate::axisymmetric::Section;
use mckibben::model::Response;
use std::path::{Path, PathBuf};

/// The problem of a step.
const PARTS: [&str; 3] = ["tube", "braid", "plug"];

/// Writes `tube_0000.vtu`, `braid_0000.vtu`, … (`plug_0000.vtu` where the terminals are bodies) and `muscle.pvd`, which lists them, into a folder.
///
/// Every file is complete when it gets its name, and `muscle.pvd` lists whole steps only, also where a series is broken
/// off. Files of an older series in the same folder are replaced one by one; the list names none of the older ones.
#[derive(Debug)]
pub struct VtuSeries {
    folder: PathBuf,
    about: String,
    /// Problem of every step.
    problem: Vec<usize>,
}

impl VtuSeries {
    /// A series in a folder, which is made where there is none. `about` says what the muscle is.
    ///
    /// # Errors
    /// [`VtuError::Folder`].
    pub fn new(dir: &Path, about: &str) -> Result<Self, VtuError> {
        std::fs::create_dir_all(dir).map_err(|source| VtuError::Folder { folder: dir.to_owned(), source })?;
        Ok(Self { folder: dir.to_owned(), about: about.to_owned(), problem: vec![] })
    }

    /// Adds a step: the section of an equilibrium and what the model says about it.
    ///
    /// # Errors
    /// [`VtuError::Write`], [`VtuError::NotFinite`].
    pub fn add(&mut self, section: &Section, response: &Response) -> Result<(), VtuError> {
        let drawn = f64::from(2 * helices::drawn(section));
        let note =
            if section.strand_count().is_some() { "" } else { "; the number of strands is for display" };
        self.add_shape(Shape::of_section(section), response, note, vec![("strands_drawn", drawn)])
    }

    /// Adds a step: bodies, what the model says about the equilibrium, a note, and more numbers of the braid.
    ///
    /// # Errors
    /// [`VtuError::Write`], [`VtuError::NotFinite`].
    pub fn add_shape(
        &mut self,
        shape: Shape,
        response: &Response,
        note: &str,
        more: Vec<(&'static str, f64)>,
    ) -> Result<(), VtuError> {
        let step = self.problem.len();
        let about = format!("{}; step {step}{note}", self.about);
        let mut grids = vec![(shape.tube, vec![]), (shape.braid, more)];
        grids.extend(shape.plug.map(|grid| (grid, vec![])));
        let count = grids.len();
        let mut ready = Vec::with_capacity(grids.len());
        for (name, (mut grid, more)) in PARTS.into_iter().zip(grids) {
            fill(&mut grid, response, more);
            let file = file(name, step);
            let xml = grid.to_xml(&about, &file)?;
            ready.push((file, xml));
        }
        for (file, xml) in ready {
            self.write(&file, &xml)?;
        }
        self.problem.push(count);
        self.list().map(|_| ())
    }

    /// Ends the series and gives the path of `muscle.pvd`.
    ///
    /// # Errors
    /// [`VtuError::Write`].
    pub fn finish(self) -> Result<PathBuf, VtuError> {
        if self.problem.is_empty() {
            return self.list();
        }
        Ok(self.folder.join(LIST))
    }

    fn list(&self) -> Result<PathBuf, VtuError> {
        let problem = self.problem.iter().enumerate().flat_map(|(step, &count)| {
            PARTS
                .into_iter()
                .take(count)
                .enumerate()
                .map(move |(part, name)| (step, part, name, file(name, step)))
        });
        self.write(LIST, &collection(&self.about, problem))
    }

    fn write(&self, file: &str, text: &str) -> Result<PathBuf, VtuError> {
        let path = self.folder.join(file);
        match mckibben_files::replace(&path, text.as_bytes()) {
            Ok(()) => Ok(path),
            Err(source) => Err(VtuError::Write { path, source }),
        }
    }
}

const LIST: &str = "muscle.pvd";

fn file(part: &str, step: usize) -> String {
    format!("{part}_{step:04}.vtu")
}

fn fill(grid: &mut Grid, r: &Response, more: Vec<(&'static str, f64)>) {
    let known = [
        ("pressure_mpa", Some(r.pressure_mpa)),
        ("contraction", Some(r.contraction)),
        ("force_n", Some(r.force_n)),
        ("volume_mm3", r.volume_mm3),
        ("bulged_diameter_mm", r.bulged_diameter_mm),
        ("braid_tension_n", r.braid_tension_n),
        ("strand_tension_n", r.strand_tension_n),
    ];
    grid.field = known.into_iter().filter_map(|(name, value)| value.map(|v| (name, v))).chain(more).collect();
}
