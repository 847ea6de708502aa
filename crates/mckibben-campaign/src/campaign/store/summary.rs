//! The content of a campaign in a few numbers.

use super::{Field, Folder, Opened, Provenance, Which};
use crate::PointRow;
use crate::campaign::{CampaignError, Result};
use crate::columns::Role;
use mckibben::status::Status;
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::Path;

/// Rows that failed in the same way.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
pub struct Failed {
    /// How many.
    pub points: u64,
    /// Number of the first muscle.
    pub first_muscle: u64,
    /// Its cause.
    pub first_cause: String,
}

/// Smallest and largest value of a column.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Extent {
    /// The column.
    pub name: String,
    /// Smallest value.
    pub smallest: f64,
    /// Largest value.
    pub largest: f64,
}

/// Contents of a campaign.
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
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
    /// Smallest and largest value of inputs and answers, in the order of the columns.
    pub ranges: Vec<Extent>,
    /// Bytes on the disk.
    pub bytes: u64,
    /// Parts that are missing, of a folder.
    pub missing_parts: u64,
    /// Damaged files, with their damage.
    pub damaged: Vec<String>,
    /// Where it comes from.
    #[serde(flatten)]
    pub provenance: Provenance,
}

impl Summary {
    fn new(provenance: Provenance) -> Self {
        Self {
            points_wanted: provenance.points(),
            provenance,
            ..Self::default()
        }
    }

    fn add(&mut self, mut row: PointRow, fields: &[Field]) {
        self.points += 1;
        if row.status.is_ok() {
            self.answered += 1;
        } else {
            let first = || Failed {
                points: 0,
                first_muscle: row.muscle,
                first_cause: row.cause.clone(),
            };
            self.failed.entry(row.status).or_insert_with(first).points += 1;
        }
        for (field, range) in fields.iter().zip(&mut self.ranges) {
            if let Some(value) = field.number(&mut row) {
                (range.smallest, range.largest) =
                    (range.smallest.min(value), range.largest.max(value));
            }
        }
    }

    fn add_file(&mut self, opened: Opened, path: &Path) -> Result<()> {
        let fields = opened.provenance.layout.fields();
        let fields: Vec<Field> = fields
            .iter()
            .filter(|f| f.column.role != Role::Note)
            .cloned()
            .collect();
        if self.ranges.is_empty() {
            let (smallest, largest) = (f64::INFINITY, f64::NEG_INFINITY);
            let range = |f: &Field| Extent {
                name: f.name.clone(),
                smallest,
                largest,
            };
            self.ranges = fields.iter().map(range).collect();
        }
        for row in opened.rows() {
            self.add(row?, &fields);
        }
        self.bytes += std::fs::metadata(path)
            .map_err(CampaignError::read(path))?
            .len();
        Ok(())
    }

    fn finished(mut self) -> Self {
        self.muscles = self.points / self.provenance.points_per_muscle.max(1);
        // Columns that no row has.
        self.ranges.retain(|r| r.smallest <= r.largest);
        self.complete = self.points == self.points_wanted;
        self
    }
}

/// Looks through a campaign: one file, or a folder of parts, which may be incomplete.
pub fn summary(path: impl AsRef<Path>) -> Result<Summary> {
    let path = path.as_ref();
    if !path.is_dir() {
        let opened = Opened::file(path)?;
        let mut out = Summary::new(opened.provenance.clone());
        out.add_file(opened, path)?;
        return Ok(out.finished());
    }
    let (mut out, mut damaged, mut whole): (Option<Summary>, _, u64) = (None, vec![], 0);
    for (number, part) in Folder::parts(path)? {
        let opened = Opened::file(&part)
            .and_then(Opened::checked)
            .and_then(|opened| {
                let first = out
                    .as_ref()
                    .map_or(&opened.provenance, |out| &out.provenance)
                    .clone();
                opened.expect(Which::Part(number), &first)
            });
        match opened {
            Ok(opened) => {
                let new = || Summary::new(opened.provenance.clone());
                out.get_or_insert_with(new).add_file(opened, &part)?;
                whole += 1;
            }
            Err(CampaignError::Damaged(_, why) | CampaignError::NoCampaign(_, why)) => {
                damaged.push(format!("{}: {why}", part.display()));
            }
            Err(error) => return Err(error),
        }
    }
    let Some(mut out) = out else {
        let why = if damaged.is_empty() {
            "there is no part in it".into()
        } else {
            damaged.join("; ")
        };
        return Err(CampaignError::NoCampaign(path.into(), why));
    };
    out.missing_parts = out.provenance.parts().saturating_sub(whole);
    out.damaged = damaged;
    Ok(out.finished())
}
