//! The content of a campaign in a few numbers.

use super::{file::Opened, folder::Folder, layout::Field, provenance::Provenance};
use crate::{
    campaign::{
        error::{CampaignError, Result},
        warnings::Warned,
    },
    columns::{PointRow, Role},
};
use mckibben_core::status::Status;
use schemars::JsonSchema;
use serde::Serialize;
use std::{collections::BTreeMap, path::Path};

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
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema)]
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
    /// Damaged files, with their damage.
    pub damaged: Vec<String>,
    /// Where it comes from.
    #[serde(flatten)]
    pub provenance: Provenance,
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

    fn finished(mut self) -> Self {
        self.muscles = self.points / self.provenance.points_per_muscle.max(1);
        // Columns that no row has.
        self.ranges.retain(|r| r.smallest <= r.largest);
        self.complete = self.points == self.points_wanted;
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
    let (mut summary, mut damaged, mut whole): (Option<Summary>, _, u64) = (None, vec![], 0);
    for (number, part) in Folder::parts(path)? {
        let opened = Opened::file(&part).and_then(|opened| {
            let first = summary
                .as_ref()
                .map_or(&opened.provenance, |s| &s.provenance)
                .clone();
            opened.expect(Some(number), &first)
        });
        match opened {
            Ok(opened) => {
                let new = || Summary::new(opened.provenance.clone());
                summary.get_or_insert_with(new).add_file(opened, &part)?;
                whole += 1;
            }
            Err(CampaignError::Damaged(_, why) | CampaignError::NoCampaign(_, why)) => {
                damaged.push(format!("{}: {why}", part.display()));
            }
            Err(error) => return Err(error),
        }
    }
    if let Some(mut summary) = summary {
        summary.missing_parts = summary.provenance.parts().saturating_sub(whole);
        summary.damaged = damaged;
        return Ok(summary.finished());
    }
    let why = if damaged.is_empty() {
        "there is no part in it".into()
    } else {
        damaged.join("; ")
    };
    Err(CampaignError::NoCampaign(path.into(), why))
}
