//! The content of a campaign in a few numbers, and how far it is.

use super::{
    file::Opened,
    folder::Folder,
    layout::Field,
    manifest::noted,
    provenance::Provenance,
    status::{ShardState, ShardStatus, parts_per_s, shards},
};
use crate::{
    campaign::{
        error::{CampaignError, Result},
        warnings::Warned,
    },
    columns::{PointRow, Role},
    fit::{Fits, Fittable},
};
use mckibben_core::{joined, status::Status};
use mckibben_io::files::ReadError;
use schemars::JsonSchema;
use serde::Serialize;
use std::{
    collections::{BTreeMap, BTreeSet},
    io::ErrorKind,
    path::{Path, PathBuf},
    time::SystemTime,
};

/// Rows that failed in the same way.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, JsonSchema)]
pub struct Failed {
    /// How many.
    pub points: u64,
    /// Number of the first muscle.
    pub first_muscle: u64,
    /// Its cause.
    pub first_cause: String,
}

/// Smallest and largest value of a column.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Extent {
    /// The column.
    pub name: String,
    /// Smallest value.
    pub smallest: f64,
    /// Largest value.
    pub largest: f64,
}

/// Contents of a campaign.
#[derive(Debug, Clone, Default, Serialize, JsonSchema)]
pub struct Summary {
    /// Muscles that are there.
    pub muscles: u64,
    /// Rows that are there.
    pub points: u64,
    /// Rows that there will be.
    pub points_wanted: u64,
    /// Whether all of them are there.
    pub complete: bool,
    /// Rows with an answer.
    pub answered: u64,
    /// Rows without an answer by their status.
    pub failed: BTreeMap<Status, Failed>,
    /// Warnings by their column.
    pub warnings: Vec<Warned>,
    /// Smallest and largest value of inputs and answers, in the order of the columns.
    pub ranges: Vec<Extent>,
    /// Size on the disk.
    pub bytes: u64,
    /// Parts that are missing, of a folder.
    pub missing_parts: u64,
    /// Shards of a folder.
    pub shards: Vec<ShardStatus>,
    /// Points a second, by the times of the newest parts, of all shards together.
    pub points_per_s: Option<f64>,
    /// What is left at this rate in s, where a process computes.
    pub left_s: Option<f64>,
    /// Parts that are damaged, or of another plan or version, with what shows it; they count as
    /// missing.
    pub damaged: Vec<String>,
    /// What can be fitted to it.
    #[serde(flatten)]
    pub fits: Fits,
    /// Where it comes from.
    #[serde(flatten)]
    pub provenance: Provenance,
    #[serde(skip)]
    fittable: Fittable,
}

impl Summary {
    fn new(provenance: Provenance) -> Self {
        let range = |field: &Field| Extent {
            name: field.name.clone(),
            smallest: f64::INFINITY,
            largest: f64::NEG_INFINITY,
        };
        Self {
            points_wanted: provenance.points(),
            warnings: Warned::none(),
            ranges: questions_and_answers(&provenance)
                .iter()
                .map(range)
                .collect(),
            provenance,
            ..Self::default()
        }
    }

    fn add_row(&mut self, mut row: PointRow, fields: &[Field]) {
        self.points += 1;
        if row.status.is_ok() {
            self.fittable.add(&row);
            self.answered += 1;
        } else {
            let first = || Failed {
                points: 0,
                first_muscle: row.muscle,
                first_cause: row.cause.clone(),
            };
            self.failed.entry(row.status).or_insert_with(first).points += 1;
        }
        Warned::count(&mut self.warnings, &mut row);
        for (field, range) in fields.iter().zip(&mut self.ranges) {
            if let Some(value) = field.number(&mut row) {
                range.smallest = range.smallest.min(value);
                range.largest = range.largest.max(value);
            }
        }
    }

    fn add_file(&mut self, opened: Opened, path: &Path) -> Result<()> {
        let fields = questions_and_answers(&opened.provenance);
        for row in opened.rows() {
            self.add_row(row?, &fields);
        }
        let metadata = std::fs::metadata(path);
        self.bytes += metadata.map_err(CampaignError::read(path))?.len();
        Ok(())
    }

    /// How far a folder is, with the numbers of its whole parts and the times of their files.
    fn progress(
        &mut self,
        folder: &Path,
        whole: &BTreeSet<u64>,
        written: Vec<SystemTime>,
    ) -> Result<()> {
        let parts_wanted = self.provenance.parts();
        let points_per_part = self.provenance.rows_of(Some(0)) as f64;
        self.shards = shards(folder, whole, parts_wanted)?;
        self.missing_parts = parts_wanted.saturating_sub(whole.len() as u64);
        self.points_per_s = parts_per_s(written).map(|rate| rate * points_per_part);
        let is_running = self.shards.iter().any(|s| s.state == ShardState::Running);
        let left = self.missing_parts as f64 * points_per_part;
        self.left_s = self
            .points_per_s
            .filter(|_| is_running)
            .map(|rate| left / rate);
        Ok(())
    }

    /// Whether parts are missing that no process computes.
    pub fn is_stopped(&self) -> bool {
        self.shards
            .iter()
            .any(|shard: &ShardStatus| shard.state == ShardState::Missing)
    }

    fn finished(mut self) -> Self {
        self.muscles = self.points / self.provenance.points_per_muscle.max(1);
        // Columns that no row has.
        self.ranges.retain(|r| r.smallest <= r.largest);
        self.complete = self.points == self.points_wanted;
        self.fits = self.fittable.fits();
        self
    }
}

/// The fields whose ranges are stated.
fn questions_and_answers(provenance: &Provenance) -> Vec<Field> {
    provenance
        .layout
        .fields()
        .iter()
        .filter(|f| matches!(f.column.role, Role::Question | Role::Answer))
        .cloned()
        .collect()
}

/// Looks through a campaign: one file, or a folder of parts, which may be incomplete.
pub fn summary(path: impl AsRef<Path>) -> Result<Summary> {
    let path = path.as_ref();
    if !path.is_dir() {
        let opened = Opened::file(path)?;
        let mut summary = Summary::new(opened.provenance.clone());
        summary.add_file(opened, path)?;
        return Ok(summary.finished());
    }
    let parts = Folder::parts(path)?;
    let whole = |part: &PathBuf| Opened::file(part).ok().map(|opened| opened.provenance);
    let of_folder = || parts.values().find_map(whole);
    let Some(provenance) = noted(path).or_else(of_folder) else {
        let damage = parts.values().filter_map(|part| Opened::file(part).err());
        let why = joined(damage.map(|error| error.to_string()), "; ");
        let none = "there is neither a part nor a note of a plan in it";
        let why = if why.is_empty() { none.into() } else { why };
        return Err(CampaignError::NoCampaign(path.into(), why));
    };
    let mut summary = Summary::new(provenance.clone());
    let (mut whole, mut written) = (BTreeSet::new(), vec![]);
    for (number, part) in parts {
        let opened = Opened::file(&part);
        match opened.and_then(|opened| opened.expect(Some(number), &provenance)) {
            Ok(opened) => {
                summary.add_file(opened, &part)?;
                whole.insert(number);
                written.extend(part.metadata().and_then(|m| m.modified()).ok());
            }
            // Another process has just replaced or removed it.
            Err(CampaignError::Read(_, ReadError::System(e)))
                if e.kind() == ErrorKind::NotFound => {}
            Err(error @ CampaignError::Read { .. }) => return Err(error),
            Err(error) => summary.damaged.push(error.to_string()),
        }
    }
    summary.progress(path, &whole, written)?;
    Ok(summary.finished())
}
