//! Files that users name, together with the files named in them, as requests hold them.

use crate::{
    ExportJointRequest, ExportRequest, JointFields, LoadFields, MotionRequest, MuscleFields, PAPER,
    Problem, ProblemKind, Result, TextFile,
};
use mckibben_core::{load::Load, muscle::file, units::typed::Length};
use mckibben_fit::library;
use mckibben_io::{
    files::{ReadError, read},
    table::{MAX_BYTES, read_text},
};
use mckibben_motion::Subject;
use std::{io::ErrorKind, path::Path};

impl TextFile {
    /// The file that a field of a request names.
    pub fn of_field(field: &str, path: &Path) -> Result<Self> {
        match field {
            "muscle" | "muscles" => Self::muscle(path),
            "data" | "table" | "tables" | "load_tables" | "log" => Self::table(path),
            _ => Self::read(path),
        }
    }

    /// A file written by hand: a joint, a plan.
    pub fn read(path: &Path) -> Result<Self> {
        named(path)?;
        Ok(Self {
            name: path.display().to_string(),
            text: file::read_text(path).map_err(|e| Problem::from(e.in_file(path)))?,
        })
    }

    /// The file of a formula.
    pub fn formula(path: &Path) -> Result<Self> {
        let text =
            mckibben_core::formula::read_text(path).map_err(|e| Problem::from(e.in_file(path)))?;
        Ok(Self {
            name: path.display().to_string(),
            text,
        })
    }

    /// A muscle file. `paper` is the paper's muscle, and `lib:NAME` one of the library, where no
    /// file has that name (a folder may); `check` also takes the formulas that are built in.
    pub fn muscle(path: &Path) -> Result<Self> {
        let named = [PAPER, "universal"].map(Path::new).contains(&path)
            || path.to_str().and_then(library::named).is_some();
        if named && !path.is_file() {
            return Ok(Self {
                name: path.display().to_string(),
                text: String::new(),
            });
        }
        Self::read(path)
    }

    /// A muscle file that another file names: relative to that file, or of the library.
    fn muscle_beside(folder: &Path, name: &str) -> Result<Self> {
        let place = if library::named(name).is_some() {
            name.into()
        } else {
            folder.join(name)
        };
        Ok(Self {
            name: name.into(),
            ..Self::muscle(&place)?
        })
    }

    /// A table, whatever program wrote it, or the sheet of a workbook: `bench.xlsx#Sheet 2`. Its
    /// name also says its encoding where that is not UTF-8.
    pub fn table(path: &Path) -> Result<Self> {
        named(path)?;
        let name = path.display().to_string();
        let (file, sheet) = match name.rsplit_once('#') {
            Some((file, sheet)) if !path.exists() => (file, Some(sheet)),
            _ => (&*name, None),
        };
        let unread = |error: ReadError| {
            let hint = match &error {
                ReadError::System(e) if e.kind() != ErrorKind::NotFound => {
                    "the operating system refused to read it; it is not necessarily damaged"
                }
                _ => "",
            };
            Problem::new(ProblemKind::File, format!("{file} {error}"), hint)
        };
        let bytes = read(Path::new(file), MAX_BYTES as u64).map_err(unread)?;
        let (text, from) =
            read_text(&bytes, sheet).map_err(|error| Problem::of_table(&name, &error))?;
        let from = from.map_or_else(String::new, |from| format!(" ({from})"));
        Ok(Self {
            name: format!("{file}{from}"),
            text,
        })
    }
}

/// Refuses what is no name of a file.
fn named(path: &Path) -> Result<()> {
    let text = path.to_string_lossy();
    if !text.trim().is_empty() && text.parse::<f64>().is_err() || path.exists() {
        return Ok(());
    }
    Err(Problem::new(
        ProblemKind::File,
        format!("\"{text}\" is no name of a file"),
        "name a file, or leave it out; a number stands behind the name of its quantity",
    ))
}

impl JointFields {
    /// A joint file with its muscle files, which lie relative to it.
    pub fn read(path: &Path) -> Result<Self> {
        let joint = TextFile::read(path)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut names = Self::files_of(&joint)?;
        names.dedup();
        let muscles = names
            .iter()
            .map(|name| TextFile::muscle_beside(folder, name))
            .collect::<Result<_>>()?;
        Ok(Self {
            joint: Some(joint),
            muscles,
        })
    }
}

impl MotionRequest {
    /// With a drive file and the files that it names, which lie relative to it.
    pub fn with_drive(self, path: &Path) -> Result<Self> {
        let drive = TextFile::read(path)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let names = Self::names_of(&drive)?;
        let table = |name: String| {
            TextFile::table(&folder.join(&name)).map(|file| TextFile { name, ..file })
        };
        let tables = names.tables.into_iter().map(table).collect::<Result<_>>()?;
        let (muscle, joint) = match names.subject {
            Subject::Muscle(name) => (Some(TextFile::muscle_beside(folder, &name)?), self.joint),
            Subject::Joint(name) => {
                let fields = JointFields::read(&folder.join(&name))?;
                (
                    None,
                    JointFields {
                        joint: fields.joint.map(|file| TextFile { name, ..file }),
                        ..fields
                    },
                )
            }
        };
        Ok(Self {
            drive: Some(drive),
            muscle,
            joint,
            tables,
            ..self
        })
    }
}

impl LoadFields {
    /// Reads the tables that the load names.
    pub fn read_tables(&mut self) -> Result<()> {
        self.load_tables = Load::tables(self.load.as_deref().unwrap_or_default())
            .map(|name: &str| -> Result<TextFile> {
                Ok(TextFile {
                    name: name.into(),
                    ..TextFile::table(Path::new(name))?
                })
            })
            .collect::<Result<_>>()?;
        Ok(())
    }
}

impl ExportRequest {
    /// The same of a joint, by its file; what only a muscle has is refused.
    pub fn of_joint(&self, path: &Path) -> Result<ExportJointRequest> {
        let muscle_alone = MuscleFields {
            file: None,
            also_file: None,
            ..self.muscle.clone()
        };
        Problem::refuse_unused(
            &[
                ("muscle", muscle_alone != MuscleFields::default()),
                ("contraction_low", self.contraction_low.is_some()),
                ("contraction_high", self.contraction_high.is_some()),
                ("cord_mm", self.cord_mm != Length::default()),
            ],
            "it belongs to a muscle, and the file is that of a joint",
        )?;
        Ok(ExportJointRequest {
            joint: JointFields::read(path)?,
            common: self.common.clone(),
        })
    }
}
