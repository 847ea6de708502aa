//! What a campaign holds, in a few figures.

use super::store::{Folder, Opened, Provenance, Which};
use super::{CampaignError, solve};
use crate::Row;
use std::collections::BTreeMap;
use std::path::Path;

/// Rows that failed in the same way.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Failed {
    /// How many.
    pub points: u64,
    /// Number of the first muscle.
    pub first_muscle: u64,
    /// Its cause.
    pub first_cause: String,
}

/// What a campaign holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// Where it comes from.
    pub provenance: Provenance,
    /// Muscles that are there.
    pub muscles: u64,
    /// Rows that are there.
    pub points: u64,
    /// Rows with an answer.
    pub answered: u64,
    /// Rows without an answer by their status.
    pub failed: BTreeMap<String, Failed>,
    /// Smallest and largest value of each input and of the pull, in the order of the columns.
    pub ranges: Vec<(String, f64, f64)>,
    /// Parts that are missing, of a folder.
    pub missing_parts: u64,
    /// Files that are damaged, with what is wrong.
    pub damaged: Vec<String>,
    /// Bytes on the disk.
    pub bytes: u64,
    /// Newton iterations of all rows.
    pub iterations: u64,
}

impl Summary {
    fn new(provenance: Provenance) -> Self {
        Self {
            provenance,
            muscles: 0,
            points: 0,
            answered: 0,
            failed: BTreeMap::new(),
            ranges: vec![],
            missing_parts: 0,
            damaged: vec![],
            bytes: 0,
            iterations: 0,
        }
    }

    fn add(&mut self, row: &Row) {
        self.points += 1;
        self.iterations += u64::from(row.iterations);
        if row.status == solve::OK {
            self.answered += 1;
        } else {
            let first = || Failed { points: 0, first_muscle: row.muscle, first_cause: row.cause.clone() };
            self.failed.entry(row.status.clone()).or_insert_with(first).points += 1;
        }
        let measures = [
            ("outer_diameter_mm", Some(row.outer_diameter_mm)),
            ("wall_mm", Some(row.wall_mm)),
            ("length_mm", Some(row.length_mm)),
            ("angle_deg", Some(row.angle_deg)),
        ];
        let results = [
            ("braid_stiffness_n_per_mm", row.stiffness_of_braid_n_per_mm),
            ("pressure_mpa", Some(row.pressure_mpa)),
            ("contraction", Some(row.contraction)),
            ("force_n", row.force_n),
        ];
        let constants = row.constants.iter().map(|(k, v)| (k.as_str(), Some(*v)));
        for (at, (name, value)) in measures.into_iter().chain(constants).chain(results).enumerate() {
            if self.ranges.len() <= at {
                self.ranges.push((name.to_owned(), f64::INFINITY, f64::NEG_INFINITY));
            }
            if let (Some(value), Some(range)) = (value, self.ranges.get_mut(at)) {
                (range.1, range.2) = (range.1.min(value), range.2.max(value));
            }
        }
    }

    fn add_file(&mut self, opened: &Opened, path: &Path) -> Result<(), CampaignError> {
        for group in 0..opened.groups() {
            let table = opened.group(group)?;
            (0..table.rows).for_each(|i| self.add(&table.row(i)));
        }
        self.bytes += std::fs::metadata(path).map_err(CampaignError::read(path))?.len();
        Ok(())
    }

    fn finished(mut self) -> Self {
        self.muscles = self.points / self.provenance.points_per_muscle.max(1);
        // What no row has.
        self.ranges.retain(|r| r.1 <= r.2);
        self
    }
}

/// Looks through a campaign: one file, or a folder of parts, which may be incomplete.
///
/// # Errors
/// [`CampaignError`] where there is no campaign, or a file is damaged; damaged parts are listed instead.
pub fn summary(path: impl AsRef<Path>) -> Result<Summary, CampaignError> {
    let path = path.as_ref();
    if !path.is_dir() {
        let opened = Opened::file(path)?;
        let mut out = Summary::new(opened.provenance.clone());
        out.add_file(&opened, path)?;
        return Ok(out.finished());
    }
    let (mut out, mut damaged, mut there): (Option<Summary>, _, u64) = (None, vec![], 0);
    for (number, part) in Folder::parts(path)? {
        match Opened::file(&part) {
            Ok(opened) => {
                let out = out.get_or_insert_with(|| Summary::new(opened.provenance.clone()));
                super::resume::belongs(&opened.provenance, &out.provenance, &part)?;
                if opened.which == Which::Part(number) {
                    out.add_file(&opened, &part)?;
                    there += 1;
                } else {
                    damaged.push(format!("{}: it holds another part than its name says", part.display()));
                }
            }
            Err(CampaignError::Damaged { why, .. } | CampaignError::NoCampaign { why, .. }) => {
                damaged.push(format!("{}: {why}", part.display()));
            }
            Err(error) => return Err(error),
        }
    }
    let Some(mut out) = out else {
        let why = if damaged.is_empty() { "there is no part in it".into() } else { damaged.join("; ") };
        return Err(CampaignError::NoCampaign { path: path.into(), why });
    };
    out.missing_parts = out.provenance.parts() - there;
    out.damaged = damaged;
    Ok(out.finished())
}
